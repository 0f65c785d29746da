#include "engine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

gd_interface gd;
static bool double_precision;

bool gd_load(GDExtensionInterfaceGetProcAddress find) {
#define GD_FIND(type, name)                                                                                            \
    gd.name = (type)(void (*)(void))find(#name);                                                                       \
    if (!gd.name) return false;
    GD_FUNCTIONS(GD_FIND)
#undef GD_FIND
    return true;
}

void gd_find_precision(void) {
    gd_value os = gd_singleton("OS"), feature = gd_of_text("double");
    gd_value answer = gd_call(&os, "has_feature", 1, &feature);
    double_precision = gd_bool(&answer);
    gd_free(&answer);
    gd_free(&feature);
    gd_free(&os);
}

gd_name gd_name_of(const char* text) {
    gd_name name;
    gd.string_name_new_with_utf8_chars(&name, text);
    return name;
}

void gd_name_free(gd_name* name) {
    gd.variant_get_ptr_destructor(GDEXTENSION_VARIANT_TYPE_STRING_NAME)(name);
}

void* gd_string_of(const char* text) {
    void* string;
    gd.string_new_with_utf8_chars(&string, text);
    return string;
}

void gd_string_free(void** string) {
    gd.variant_get_ptr_destructor(GDEXTENSION_VARIANT_TYPE_STRING)(string);
}

static gd_value from_type(GDExtensionVariantType type, void* data) {
    gd_value value;
    gd.get_variant_from_type_constructor(type)(&value, data);
    return value;
}

static void to_type(GDExtensionVariantType type, const gd_value* value, void* out) {
    gd.get_variant_to_type_constructor(type)(out, (void*)value);
}

gd_value gd_nil(void) {
    gd_value value;
    gd.variant_new_nil(&value);
    return value;
}

gd_value gd_copy(const void* variant) {
    gd_value value;
    gd.variant_new_copy(&value, variant);
    return value;
}

gd_value gd_of_bool(bool value) {
    GDExtensionBool data = value;
    return from_type(GDEXTENSION_VARIANT_TYPE_BOOL, &data);
}

gd_value gd_of_int(int64_t value) {
    return from_type(GDEXTENSION_VARIANT_TYPE_INT, &value);
}

gd_value gd_of_float(double value) {
    return from_type(GDEXTENSION_VARIANT_TYPE_FLOAT, &value);
}

gd_value gd_of_text(const char* text) {
    void* string = gd_string_of(text);
    const gd_value value = from_type(GDEXTENSION_VARIANT_TYPE_STRING, &string);
    gd_string_free(&string);
    return value;
}

gd_value gd_of_object(GDExtensionObjectPtr object) {
    return object ? from_type(GDEXTENSION_VARIANT_TYPE_OBJECT, &object) : gd_nil();
}

/* Twelve numbers are enough for a Transform3D. */
typedef union reals {
    float narrow[12];
    double wide[12];
} reals;

static gd_value of_reals(GDExtensionVariantType type, const double* from, int count) {
    reals data;
    for (int i = 0; i < count; i++) {
        if (double_precision)
            data.wide[i] = from[i];
        else
            data.narrow[i] = (float)from[i];
    }
    return from_type(type, &data);
}

static void read_reals(const void* data, double* out, int count) {
    for (int i = 0; i < count; i++) out[i] = double_precision ? ((const double*)data)[i] : ((const float*)data)[i];
}

gd_value gd_of_vector3(const double v[3]) {
    return of_reals(GDEXTENSION_VARIANT_TYPE_VECTOR3, v, 3);
}

gd_value gd_of_transform(const double t[12]) {
    return of_reals(GDEXTENSION_VARIANT_TYPE_TRANSFORM3D, t, 12);
}

static void* internal(const gd_value* value) {
    return gd.variant_get_ptr_internal_getter(gd.variant_get_type(value))((void*)value);
}

static gd_value new_packed(GDExtensionVariantType type, size_t count) {
    gd_value array = gd_new(type), size = gd_of_int((int64_t)count);
    gd_do(&array, "resize", 1, &size);
    return array;
}

gd_value gd_of_bytes(const void* bytes, size_t size) {
    const gd_value array = new_packed(GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY, size);
    if (size) memcpy(gd.packed_byte_array_operator_index(internal(&array), 0), bytes, size);
    return array;
}

gd_value gd_of_floats(const float* values, size_t count) {
    const gd_value array = new_packed(GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY, count);
    if (count) memcpy(gd.packed_float32_array_operator_index(internal(&array), 0), values, count * sizeof *values);
    return array;
}

gd_value gd_new(GDExtensionVariantType type) {
    gd_value value;
    GDExtensionCallError error;
    gd.variant_construct(type, &value, NULL, 0, &error);
    return value;
}

gd_value gd_singleton(const char* name) {
    gd_name interned = gd_name_of(name);
    const gd_value value = gd_of_object(gd.global_get_singleton(&interned));
    gd_name_free(&interned);
    return value;
}

void gd_free(gd_value* value) {
    gd.variant_destroy(value);
}

bool gd_is(const gd_value* value, GDExtensionVariantType type) {
    return gd.variant_get_type(value) == type;
}

bool gd_equal(const gd_value* a, const gd_value* b) {
    return gd.variant_hash_compare(a, b);
}

bool gd_bool(const gd_value* value) {
    return gd.variant_booleanize(value);
}

int64_t gd_int(const gd_value* value) {
    int64_t out = 0;
    to_type(GDEXTENSION_VARIANT_TYPE_INT, value, &out);
    return out;
}

double gd_float(const gd_value* value) {
    double out = 0;
    to_type(GDEXTENSION_VARIANT_TYPE_FLOAT, value, &out);
    return out;
}

int32_t gd_enum(double number) {
    return number >= 0 && number <= INT32_MAX ? (int32_t)number : -1;
}

void gd_vector3(const gd_value* value, double out[3]) {
    reals data;
    to_type(GDEXTENSION_VARIANT_TYPE_VECTOR3, value, &data);
    read_reals(&data, out, 3);
}

void gd_transform(const gd_value* value, double out[12]) {
    reals data;
    to_type(GDEXTENSION_VARIANT_TYPE_TRANSFORM3D, value, &data);
    read_reals(&data, out, 12);
}

GDExtensionObjectPtr gd_object(const gd_value* value) {
    GDExtensionObjectPtr object = NULL;
    if (gd_is(value, GDEXTENSION_VARIANT_TYPE_OBJECT)) to_type(GDEXTENSION_VARIANT_TYPE_OBJECT, value, &object);
    return object;
}

char* gd_text(const gd_value* value) {
    void* string;
    gd.variant_stringify(value, &string);
    const GDExtensionInt length = gd.string_to_utf8_chars(&string, NULL, 0);
    char* text = malloc((size_t)length + 1);
    if (text) {
        gd.string_to_utf8_chars(&string, text, length);
        text[length] = 0;
    }
    gd_string_free(&string);
    return text;
}

int64_t gd_count(const gd_value* array) {
    if (gd.variant_get_type(array) < GDEXTENSION_VARIANT_TYPE_ARRAY) return 0;
    gd_value size = gd_call(array, "size", 0, NULL);
    const int64_t count = gd_int(&size);
    gd_free(&size);
    return count;
}

gd_value gd_at(const gd_value* array, int64_t index) {
    gd_value value;
    GDExtensionBool valid, outside;
    gd.variant_get_indexed(array, index, &value, &valid, &outside);
    return value;
}

static bool has_elements(const gd_value* array, GDExtensionVariantType type) {
    return gd_is(array, type) && gd_count(array) > 0;
}

const uint8_t* gd_bytes(const gd_value* array) {
    if (!has_elements(array, GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY)) return NULL;
    return gd.packed_byte_array_operator_index_const(internal(array), 0);
}

const int32_t* gd_ints(const gd_value* array) {
    if (!has_elements(array, GDEXTENSION_VARIANT_TYPE_PACKED_INT32_ARRAY)) return NULL;
    return gd.packed_int32_array_operator_index_const(internal(array), 0);
}

const float* gd_floats(const gd_value* array) {
    if (!has_elements(array, GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY)) return NULL;
    return gd.packed_float32_array_operator_index_const(internal(array), 0);
}

void gd_vector3_at(const gd_value* array, int64_t index, double out[3]) {
    read_reals(gd.packed_vector3_array_operator_index_const(internal(array), index), out, 3);
}

gd_value gd_get(const gd_value* self, const char* name) {
    gd_value value;
    GDExtensionBool valid;
    gd_name interned = gd_name_of(name);
    gd.variant_get_named(self, &interned, &value, &valid);
    gd_name_free(&interned);
    return value;
}

void gd_put(gd_value* self, const char* name, gd_value value) {
    gd_value key = gd_of_text(name);
    const gd_value pair[2] = {key, value};
    gd_do(self, "set", 2, pair);
    gd_free(&key);
    gd_free(&value);
}

void gd_append(gd_value* array, gd_value value) {
    gd_do(array, "append", 1, &value);
    gd_free(&value);
}

gd_value gd_call(const gd_value* self, const char* method, int count, const gd_value* arguments) {
    GDExtensionConstVariantPtr pointers[GD_MOST_ARGUMENTS];
    gd_value result;
    GDExtensionCallError error = {GDEXTENSION_CALL_OK, 0, 0};
    gd_name name = gd_name_of(method);
    for (int i = 0; i < count; i++) pointers[i] = &arguments[i];
    gd.variant_call((void*)self, &name, pointers, count, &result, &error);
    gd_name_free(&name);
    return result;
}

void gd_do(const gd_value* self, const char* method, int count, const gd_value* arguments) {
    gd_value result = gd_call(self, method, count, arguments);
    gd_free(&result);
}

/* ---- functions that scripts call ---- */

static int argument_count(const gd_argument* arguments) {
    int count = 0;
    while (count < GD_MOST_ARGUMENTS && arguments[count].name) count++;
    return count;
}

static void call_method(void* row_data, GDExtensionClassInstancePtr instance, const GDExtensionConstVariantPtr* given,
                        GDExtensionInt given_count, GDExtensionVariantPtr out, GDExtensionCallError* error) {
    const gd_method_row* row = row_data;
    const int count = argument_count(row->arguments);
    error->error = GDEXTENSION_CALL_OK;
    if (given_count != count) {
        error->error =
            given_count < count ? GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS : GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS;
        error->expected = count;
        return;
    }
    gd_value result = row->function(instance, (const gd_value* const*)given);
    gd.variant_destroy(out);
    gd.variant_new_copy(out, &result);
    gd_free(&result);
}

/* Godot calls so where the types are known beforehand: arguments and result are plain data of these types. */
static void call_typed(void* row_data, GDExtensionClassInstancePtr instance, const GDExtensionConstTypePtr* given,
                       GDExtensionTypePtr out) {
    const gd_method_row* row = row_data;
    const int count = argument_count(row->arguments);
    gd_value values[GD_MOST_ARGUMENTS];
    const gd_value* pointers[GD_MOST_ARGUMENTS];
    for (int i = 0; i < count; i++) {
        const GDExtensionVariantType type = row->arguments[i].type;
        values[i] =
            type == GDEXTENSION_VARIANT_TYPE_NIL ? gd_copy(given[i]) : from_type(type, (GDExtensionTypePtr)given[i]);
        pointers[i] = &values[i];
    }
    gd_value result = row->function(instance, pointers);
    if (row->any_result) {
        gd.variant_destroy(out);
        gd.variant_new_copy(out, &result);
    } else if (row->result != GDEXTENSION_VARIANT_TYPE_NIL) {
        const GDExtensionPtrDestructor destroy = gd.variant_get_ptr_destructor(row->result);
        if (destroy) destroy(out);
        to_type(row->result, &result, out);
    }
    gd_free(&result);
    for (int i = 0; i < count; i++) gd_free(&values[i]);
}

enum { USAGE_DEFAULT = 6, USAGE_NIL_IS_VARIANT = 131072 }; /* PropertyUsageFlags */

/* What Godot keeps copies of during one registration. */
typedef struct property_info {
    GDExtensionPropertyInfo info;
    gd_name name, class_name;
    void* hint;
} property_info;

static void fill_info(property_info* out, const char* name, GDExtensionVariantType type, const char* class_name,
                      uint32_t hint, const char* hint_text, uint32_t usage) {
    out->name = gd_name_of(name);
    out->class_name = gd_name_of(class_name ? class_name : "");
    out->hint = gd_string_of(hint_text ? hint_text : "");
    out->info = (GDExtensionPropertyInfo){type, &out->name, &out->class_name, hint, &out->hint, usage};
}

static void free_info(property_info* info) {
    gd_name_free(&info->name);
    gd_name_free(&info->class_name);
    gd_string_free(&info->hint);
}

/* Returns their number. */
static int fill_arguments(property_info* kept, GDExtensionPropertyInfo* infos, const gd_argument* arguments) {
    const int count = argument_count(arguments);
    for (int i = 0; i < count; i++) {
        const gd_argument* a = &arguments[i];
        const bool any = a->type == GDEXTENSION_VARIANT_TYPE_NIL;
        fill_info(&kept[i], a->name, a->type, a->class_name, 0, NULL, USAGE_DEFAULT | (any ? USAGE_NIL_IS_VARIANT : 0));
        infos[i] = kept[i].info;
    }
    return count;
}

void gd_register_method(GDExtensionClassLibraryPtr library, const char* class_name, const gd_method_row* row) {
    property_info kept[GD_MOST_ARGUMENTS], result;
    GDExtensionPropertyInfo infos[GD_MOST_ARGUMENTS];
    GDExtensionClassMethodArgumentMetadata metadata[GD_MOST_ARGUMENTS] = {0};
    gd_name class = gd_name_of(class_name), name = gd_name_of(row->name);
    const int count = fill_arguments(kept, infos, row->arguments);
    fill_info(&result, "", row->result, NULL, 0, NULL, USAGE_DEFAULT | (row->any_result ? USAGE_NIL_IS_VARIANT : 0));
    const GDExtensionClassMethodInfo info = {
        .name = &name,
        .method_userdata = (void*)row,
        .call_func = call_method,
        .ptrcall_func = call_typed,
        .method_flags = GDEXTENSION_METHOD_FLAGS_DEFAULT,
        .has_return_value = row->any_result || row->result != GDEXTENSION_VARIANT_TYPE_NIL,
        .return_value_info = &result.info,
        .argument_count = (uint32_t)count,
        .arguments_info = infos,
        .arguments_metadata = metadata,
    };
    gd.classdb_register_extension_class_method(library, &class, &info);
    for (int i = 0; i < count; i++) free_info(&kept[i]);
    free_info(&result);
    gd_name_free(&name);
    gd_name_free(&class);
}

void gd_register_signal(GDExtensionClassLibraryPtr library, const char* class_name, const char* name,
                        const gd_argument* arguments) {
    property_info kept[GD_MOST_ARGUMENTS];
    GDExtensionPropertyInfo infos[GD_MOST_ARGUMENTS];
    gd_name class = gd_name_of(class_name), signal = gd_name_of(name);
    const int count = fill_arguments(kept, infos, arguments);
    gd.classdb_register_extension_class_signal(library, &class, &signal, infos, count);
    for (int i = 0; i < count; i++) free_info(&kept[i]);
    gd_name_free(&signal);
    gd_name_free(&class);
}

/* A name that begins with `prefix`. */
static gd_name joined(const char* prefix, const char* name) {
    char text[64];
    snprintf(text, sizeof text, "%s%s", prefix, name);
    return gd_name_of(text);
}

void gd_register_property(GDExtensionClassLibraryPtr library, const char* class_name, const gd_property_row* row) {
    property_info info;
    gd_name class = gd_name_of(class_name), setter = joined("set_", row->name), getter = joined("get_", row->name);
    fill_info(&info, row->name, row->type, NULL, row->hint, row->hint_text, row->usage);
    gd.classdb_register_extension_class_property(library, &class, &info.info, &setter, &getter);
    free_info(&info);
    gd_name_free(&setter);
    gd_name_free(&getter);
    gd_name_free(&class);
}

GDObjectInstanceID gd_id(const gd_value* object) {
    const GDExtensionObjectPtr pointer = gd_object(object);
    return pointer ? gd.object_get_instance_id(pointer) : 0;
}

gd_value gd_node(GDObjectInstanceID id) {
    return gd_of_object(gd.object_get_instance_from_id(id));
}

gd_value gd_parent(const gd_value* node) {
    return gd_call(node, "get_parent", 0, NULL);
}
