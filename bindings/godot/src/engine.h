/* Godot's interface as the extension uses it: values of any type (Variants), made, read and called by name.
 *
 * Everything goes through Variants. So one binary serves Godot built with 32-bit and with 64-bit real numbers (real_t):
 * a Vector3 or Transform3D is read and written here alone. */
#ifndef DRAGMESH_GODOT_ENGINE_H
#define DRAGMESH_GODOT_ENGINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "godot/gdextension_interface.h"

/* A Variant: 24 bytes where real_t is a float, 40 where it is a double. Whoever gets one by value frees it. */
typedef struct gd_value {
    uint64_t words[5];
} gd_value;

/* An interned name, as StringName is laid out. */
typedef struct gd_name {
    void* data;
} gd_name;

#define GD_FUNCTIONS(X)                                                                                                \
    X(GDExtensionInterfaceVariantNewCopy, variant_new_copy)                                                            \
    X(GDExtensionInterfaceVariantNewNil, variant_new_nil)                                                              \
    X(GDExtensionInterfaceVariantDestroy, variant_destroy)                                                             \
    X(GDExtensionInterfaceVariantCall, variant_call)                                                                   \
    X(GDExtensionInterfaceVariantGetNamed, variant_get_named)                                                          \
    X(GDExtensionInterfaceVariantSetNamed, variant_set_named)                                                          \
    X(GDExtensionInterfaceVariantGetIndexed, variant_get_indexed)                                                      \
    X(GDExtensionInterfaceVariantGetType, variant_get_type)                                                            \
    X(GDExtensionInterfaceVariantBooleanize, variant_booleanize)                                                       \
    X(GDExtensionInterfaceVariantHashCompare, variant_hash_compare)                                                    \
    X(GDExtensionInterfaceVariantStringify, variant_stringify)                                                         \
    X(GDExtensionInterfaceVariantConstruct, variant_construct)                                                         \
    X(GDExtensionInterfaceGetVariantFromTypeConstructor, get_variant_from_type_constructor)                            \
    X(GDExtensionInterfaceGetVariantToTypeConstructor, get_variant_to_type_constructor)                                \
    X(GDExtensionInterfaceGetVariantGetInternalPtrFunc, variant_get_ptr_internal_getter)                               \
    X(GDExtensionInterfaceVariantGetPtrDestructor, variant_get_ptr_destructor)                                         \
    X(GDExtensionInterfaceStringNewWithUtf8Chars, string_new_with_utf8_chars)                                          \
    X(GDExtensionInterfaceStringToUtf8Chars, string_to_utf8_chars)                                                     \
    X(GDExtensionInterfaceStringNameNewWithUtf8Chars, string_name_new_with_utf8_chars)                                 \
    X(GDExtensionInterfacePackedByteArrayOperatorIndex, packed_byte_array_operator_index)                              \
    X(GDExtensionInterfacePackedFloat32ArrayOperatorIndex, packed_float32_array_operator_index)                        \
    X(GDExtensionInterfacePackedByteArrayOperatorIndexConst, packed_byte_array_operator_index_const)                   \
    X(GDExtensionInterfacePackedFloat32ArrayOperatorIndexConst, packed_float32_array_operator_index_const)             \
    X(GDExtensionInterfacePackedInt32ArrayOperatorIndexConst, packed_int32_array_operator_index_const)                 \
    X(GDExtensionInterfacePackedVector3ArrayOperatorIndexConst, packed_vector3_array_operator_index_const)             \
    X(GDExtensionInterfaceGlobalGetSingleton, global_get_singleton)                                                    \
    X(GDExtensionInterfaceObjectSetInstance, object_set_instance)                                                      \
    X(GDExtensionInterfaceObjectGetInstanceFromId, object_get_instance_from_id)                                        \
    X(GDExtensionInterfaceObjectGetInstanceId, object_get_instance_id)                                                 \
    X(GDExtensionInterfaceRefGetObject, ref_get_object)                                                                \
    X(GDExtensionInterfaceClassdbConstructObject2, classdb_construct_object2)                                          \
    X(GDExtensionInterfaceClassdbRegisterExtensionClass4, classdb_register_extension_class4)                           \
    X(GDExtensionInterfaceClassdbRegisterExtensionClassMethod, classdb_register_extension_class_method)                \
    X(GDExtensionInterfaceClassdbRegisterExtensionClassProperty, classdb_register_extension_class_property)            \
    X(GDExtensionInterfaceClassdbRegisterExtensionClassSignal, classdb_register_extension_class_signal)                \
    X(GDExtensionInterfaceClassdbUnregisterExtensionClass, classdb_unregister_extension_class)                         \
    X(GDExtensionInterfaceWorkerThreadPoolAddNativeTask, worker_thread_pool_add_native_task)                           \
    X(GDExtensionInterfacePrintErrorWithMessage, print_error_with_message)                                             \
    X(GDExtensionInterfacePrintWarningWithMessage, print_warning_with_message)

#define GD_FIELD(type, name) type name;
typedef struct gd_interface {
    GD_FUNCTIONS(GD_FIELD)
} gd_interface;
#undef GD_FIELD
extern gd_interface gd;

/* Looks all functions up; false: this Godot lacks one. */
bool gd_load(GDExtensionInterfaceGetProcAddress find);
/* Asks Godot how wide real_t is. Singletons must be there. */
void gd_find_precision(void);

gd_name gd_name_of(const char* text);
void gd_name_free(gd_name* name);
/* A String, 8 bytes; gd_string_free. */
void* gd_string_of(const char* text);
void gd_string_free(void** string);

gd_value gd_nil(void);
gd_value gd_copy(const void* variant);
gd_value gd_of_bool(bool value);
gd_value gd_of_int(int64_t value);
gd_value gd_of_float(double value);
gd_value gd_of_text(const char* text);
gd_value gd_of_object(GDExtensionObjectPtr object);
gd_value gd_of_vector3(const double v[3]);
/* Row-major 3x3 matrix, then the origin: Transform3D's own order. */
gd_value gd_of_transform(const double t[12]);
gd_value gd_of_bytes(const void* bytes, size_t size);
gd_value gd_of_floats(const float* values, size_t count);
/* An empty one: an Array, a Dictionary. */
gd_value gd_new(GDExtensionVariantType type);
gd_value gd_singleton(const char* name);
void gd_free(gd_value* value);

bool gd_is(const gd_value* value, GDExtensionVariantType type);
bool gd_equal(const gd_value* a, const gd_value* b);
bool gd_bool(const gd_value* value);
int64_t gd_int(const gd_value* value);
double gd_float(const gd_value* value);
/* A number of a script as C's enums have it; -1, which none is, for one that does not fit. */
int32_t gd_enum(double number);
void gd_vector3(const gd_value* value, double out[3]);
void gd_transform(const gd_value* value, double out[12]);
GDExtensionObjectPtr gd_object(const gd_value* value);
/* Its text in UTF-8, of malloc; NULL without memory. */
char* gd_text(const gd_value* value);

/* Number of elements of an array, of any kind. */
int64_t gd_count(const gd_value* array);
gd_value gd_at(const gd_value* array, int64_t index);
/* The elements of a packed array, NULL when it is empty or of another type; valid as long as the value. */
const uint8_t* gd_bytes(const gd_value* array);
const int32_t* gd_ints(const gd_value* array);
const float* gd_floats(const gd_value* array);
/* Three numbers an element. */
void gd_vector3_at(const gd_value* array, int64_t index, double out[3]);

/* A property or key; nil where there is none. */
gd_value gd_get(const gd_value* self, const char* name);
/* Sets a property or key and frees the value. */
void gd_put(gd_value* self, const char* name, gd_value value);
void gd_append(gd_value* array, gd_value value);
/* Calls a method by name; nil where that fails. */
gd_value gd_call(const gd_value* self, const char* method, int count, const gd_value* arguments);
/* The id of an object; 0: none. */
GDObjectInstanceID gd_id(const gd_value* object);
/* The node of an id; nil: it is gone. */
gd_value gd_node(GDObjectInstanceID id);
gd_value gd_parent(const gd_value* node);
/* The same where the answer is not asked for. */
void gd_do(const gd_value* self, const char* method, int count, const gd_value* arguments);

/* ---- functions that scripts call ---- */

typedef gd_value (*gd_method)(void* instance, const gd_value* const* arguments);

enum { GD_MOST_ARGUMENTS = 4 };
typedef struct gd_argument {
    const char* name;
    GDExtensionVariantType type;
    const char* class_name; /* of an object; NULL = any */
} gd_argument;

typedef struct gd_method_row {
    const char* name;
    gd_method function;
    GDExtensionVariantType result; /* nil: none */
    bool any_result;               /* a Variant of any type */
    gd_argument arguments[GD_MOST_ARGUMENTS];
} gd_method_row;

void gd_register_method(GDExtensionClassLibraryPtr library, const char* class_name, const gd_method_row* row);
void gd_register_signal(GDExtensionClassLibraryPtr library, const char* class_name, const char* name,
                        const gd_argument* arguments);

typedef struct gd_property_row {
    const char* name;
    GDExtensionVariantType type;
    uint32_t hint; /* PropertyHint */
    const char* hint_text;
    uint32_t usage; /* PropertyUsageFlags */
} gd_property_row;

/* Its functions set_NAME and get_NAME must be registered. */
void gd_register_property(GDExtensionClassLibraryPtr library, const char* class_name, const gd_property_row* row);

#endif
