/* Copies primitives: every attribute of the vertices that the copy has, as the file stores it. */
#include "gltf/gltf_copy.h"

#include <math.h>
#include <string.h>

#include "gltf/gltf_geometry.h"

enum { MOST_COMPONENTS = 16 };

/* One attribute being copied. */
typedef struct attribute {
    const char* name;
    double accessor; /* accessor in the file */
    dmi_gltf_elements from;
    uint64_t element, stride; /* bytes of an element of the copy; the same with its padding to 4 bytes */
    uint8_t* bytes;
    uint64_t size;
} attribute;

static int starts_with(const char* name, const char* start) {
    return strncmp(name, start, strlen(start)) == 0;
}

static dm_result find_attribute(dmi_edit* e, const dmi_copy* copy, const cJSON* item, attribute* out) {
    dm_gltf* gltf = (dm_gltf*)e->from; /* the file keeps what it decompresses */
    *out = (attribute){.name = item->string, .accessor = item->valuedouble};
    const dm_result result =
        dmi_gltf_draco_of(gltf, copy->from)
            ? dmi_gltf_find_in_draco(gltf, copy->from, out->name, "glTF: export", &e->problem, &out->from)
            : dmi_gltf_find_elements(gltf, out->accessor, "glTF: export", &e->problem, &out->from);
    if (result != DM_OK) return result;
    for (uint64_t v = 0; v < copy->vertex_count; v++) {
        if (copy->elements[v] >= out->from.count)
            return dmi_gltf_refuse(&e->problem, DM_ERROR_BAD_DATA, "glTF: export: %.40s has too few values", out->name);
    }
    out->element = (uint64_t)out->from.components * dmi_gltf_component_size(out->from.component_type);
    out->stride = (out->element + 3) & ~(uint64_t)3;
    out->size = copy->vertex_count * out->stride;
    out->bytes = dmi_alloc_zeroed(e->env, out->size, 16);
    if (out->bytes) return DM_OK;
    return dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: export: no memory for %.40s", out->name);
}

/* Copies the bytes as they are, with sparse changes. */
static void copy_values(const dmi_copy* copy, attribute* a) {
    const dmi_gltf_elements* from = &a->from;
    for (uint64_t v = 0; v < copy->vertex_count; v++) {
        const uint64_t element = copy->elements[v];
        const uint8_t* source = from->data ? from->data + element * from->stride : NULL;
        const uint64_t change = dmi_gltf_find_change(from, element);
        if (change < from->change_count) source = from->changes + change * from->change_stride;
        if (source) memcpy(a->bytes + v * a->stride, source, a->element);
    }
}

/* ---- vertices that bones have placed ---- */

/* Computes m * v, or for normals cofactor(m) * v, which stays perpendicular. */
static void turn_vector(const double m[16], int is_normal, const double v[3], double out[3]) {
    double c[9];
    for (int column = 0; column < 3; column++) {
        const double *p = m + 4 * (size_t)((column + 1) % 3), *q = m + 4 * (size_t)((column + 2) % 3);
        const double cross[3] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
        for (int row = 0; row < 3; row++) c[3 * column + row] = is_normal ? cross[row] : m[4 * column + row];
    }
    for (int row = 0; row < 3; row++) out[row] = c[row] * v[0] + c[3 + row] * v[1] + c[6 + row] * v[2];
    const double length = sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    for (int k = 0; k < 3; k++) out[k] = length > 0 ? out[k] / length : k == 2;
}

/* Replaces the values of positions, normals and tangents by floats in the frame of the merged mesh. */
static void place_values(dmi_edit* e, const dmi_copy* copy, attribute* a) {
    const int is_position = strcmp(a->name, "POSITION") == 0, width = strcmp(a->name, "TANGENT") == 0 ? 4 : 3;
    const int is_normal = strcmp(a->name, "NORMAL") == 0;
    const uint64_t size = copy->vertex_count * (uint64_t)width * sizeof(float);
    float* out = dmi_alloc(e->env, size, 16);
    if (!out) {
        dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: export: no memory for %s", a->name);
        return;
    }
    for (uint64_t v = 0; v < copy->vertex_count; v++) {
        float* to = out + v * (uint64_t)width;
        double from[4] = {0, 0, 0, 1}, turned[3];
        for (int k = 0; k < width && k < a->from.components; k++)
            from[k] = dmi_gltf_element(&a->from, copy->elements[v], k);
        turn_vector(copy->placed, is_normal, from, turned);
        for (int k = 0; k < 3; k++)
            to[k] = is_position ? e->from->positions[3 * (size_t)copy->vertices[v] + (size_t)k] : (float)turned[k];
        if (width == 4) to[3] = (float)from[3];
    }
    dmi_free(e->env, a->bytes, a->size);
    a->bytes = (uint8_t*)out;
    a->size = size;
    a->stride = a->element = (uint64_t)width * sizeof *out;
    a->from.component_type = DMI_GLTF_FLOAT;
    a->from.components = width;
    a->from.normalized = 0;
}

/* ---- accessors ---- */

/* Sets min and max from the bytes of the copy, which glTF demands of positions. */
static void set_limits(dmi_edit* e, const attribute* a, uint64_t count, cJSON* accessor) {
    const dmi_gltf_elements made = {.data = a->bytes,
                                    .stride = a->stride,
                                    .count = count,
                                    .component_type = a->from.component_type,
                                    .components = a->from.components};
    double low[MOST_COMPONENTS], high[MOST_COMPONENTS];
    for (int k = 0; k < made.components; k++) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
        for (uint64_t v = 0; v < count; v++) {
            low[k] = fmin(low[k], dmi_gltf_element(&made, v, k));
            high[k] = fmax(high[k], dmi_gltf_element(&made, v, k));
        }
    }
    dmi_edit_numbers(e, accessor, "min", low, made.components);
    dmi_edit_numbers(e, accessor, "max", high, made.components);
}

/* Returns whether bones move the attribute, so that a placed copy has its own values. */
static int is_placed(const char* name) {
    return strcmp(name, "POSITION") == 0 || strcmp(name, "NORMAL") == 0 || strcmp(name, "TANGENT") == 0;
}

/* Adds the accessor of an attribute of the copy. It is like the file's, but for what is different. */
static int32_t add_accessor(dmi_edit* e, const dmi_copy* copy, const attribute* a) {
    const cJSON* old = dmi_gltf_item(&e->from->document, DMI_GLTF_ACCESSORS, a->accessor);
    const char* placed_type = a->from.components == 4 ? "VEC4" : "VEC3";
    const char* type = copy->placed && is_placed(a->name) ? placed_type : dmi_json_text(old, "type");
    const int32_t view = dmi_edit_add_view(e, a->bytes, a->size, DMI_GLTF_VERTEX_TARGET);
    if (a->stride != a->element && e->problem.code == DM_OK)
        dmi_edit_number(e, dmi_json_get(e->document.root, "bufferViews")->child->prev, "byteStride", (double)a->stride);
    const dmi_edit_item made = dmi_edit_add(e, DMI_GLTF_ACCESSORS, dmi_edit_new(e, cJSON_Duplicate(old, 1)));
    static const char* const dropped[] = {"sparse", "byteOffset", "min", "max", "normalized"};
    for (size_t i = 0; made.json && i < sizeof dropped / sizeof *dropped; i++)
        cJSON_DeleteItemFromObjectCaseSensitive(made.json, dropped[i]);
    dmi_edit_number(e, made.json, "bufferView", view);
    dmi_edit_number(e, made.json, "componentType", a->from.component_type);
    dmi_edit_number(e, made.json, "count", (double)copy->vertex_count);
    dmi_edit_text(e, made.json, "type", type);
    if (a->from.normalized) dmi_edit_set(e, made.json, "normalized", cJSON_CreateTrue());
    if (strcmp(a->name, "POSITION") == 0) set_limits(e, a, copy->vertex_count, made.json);
    return made.index;
}

static void copy_attributes(dmi_edit* e, const dmi_copy* copy, const cJSON* from, cJSON* to) {
    const cJSON* item;
    cJSON_ArrayForEach(item, from) {
        attribute a;
        if (e->problem.code != DM_OK) return;
        if (copy->placed && (starts_with(item->string, "JOINTS_") || starts_with(item->string, "WEIGHTS_"))) continue;
        if (find_attribute(e, copy, item, &a) == DM_OK) {
            copy_values(copy, &a);
            if (copy->placed && is_placed(a.name)) place_values(e, copy, &a);
            dmi_edit_number(e, to, a.name, add_accessor(e, copy, &a));
        }
        dmi_free(e->env, a.bytes, a.size);
    }
}

/* ---- the primitive ---- */

/* Copies the morph targets. They move vertices in the mesh's frame, so a placed copy has none. */
static void copy_targets(dmi_edit* e, const dmi_copy* copy, cJSON* made) {
    const cJSON *targets = dmi_json_get(copy->from, "targets"), *target;
    if (!targets) return;
    if (copy->placed) {
        dmi_gltf_warn(&e->from->warnings, "dm_gltf_export: the morph targets of a moving part with bones are left out");
        cJSON_DeleteItemFromObjectCaseSensitive(made, "targets");
        return;
    }
    cJSON* list = dmi_edit_set(e, made, "targets", cJSON_CreateArray());
    cJSON_ArrayForEach(target, targets) {
        cJSON* copied = dmi_edit_new(e, cJSON_CreateObject());
        copy_attributes(e, copy, target, copied);
        dmi_edit_append(e, list, copied);
    }
}

cJSON* dmi_copy_primitive(dmi_edit* e, const dmi_copy* copy) {
    cJSON* made = dmi_edit_new(e, cJSON_Duplicate(copy->from, 1));
    if (!made) return NULL;
    cJSON* extensions = cJSON_GetObjectItemCaseSensitive(made, "extensions");
    if (extensions) cJSON_DeleteItemFromObjectCaseSensitive(extensions, DMI_DRACO_NAME);
    if (extensions && !extensions->child) cJSON_DeleteItemFromObjectCaseSensitive(made, "extensions");
    cJSON_DeleteItemFromObjectCaseSensitive(made, "mode"); /* the copy is a list of triangles */
    const uint64_t corners = 3 * copy->face_count;
    const int32_t view = dmi_edit_add_view(e, copy->corners, corners * sizeof *copy->corners, DMI_GLTF_INDEX_TARGET);
    dmi_edit_number(e, made, "indices", dmi_edit_add_accessor(e, view, DMI_GLTF_UINT, 1, corners, NULL, NULL));
    cJSON* attributes = dmi_edit_set(e, made, "attributes", cJSON_CreateObject());
    copy_attributes(e, copy, dmi_json_get(copy->from, "attributes"), attributes);
    copy_targets(e, copy, made);
    return made;
}
