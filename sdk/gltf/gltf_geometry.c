/* Finds the geometry of primitives, in accessors or in a Draco stream. */
#include "gltf/gltf_geometry.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "gltf/gltf_buffers.h"

/* Bytes a point that Draco takes while it decodes, for its corner table, its maps and its attributes; by hand. */
#define DRACO_BYTES_A_POINT 64
#define DRACO_BYTES_A_FACE 64

/* ---- Draco ---- */

/* Decoded elements of a Draco stream, in the list of its view. */
struct dmi_gltf_block {
    dmi_gltf_block* next;
    uint64_t size; /* size of the whole block */
    uint32_t id;   /* id of the attribute; FACES: the block holds the corners */
    int32_t type;
    uint32_t values[];
};
#define FACES UINT32_MAX

/* Returns whether the positions of a primitive are there without Draco too, as in a file whose Draco is optional. */
static int has_plain_data(const dm_gltf* gltf, const cJSON* primitive) {
    const double positions = dmi_json_number(dmi_json_get(primitive, "attributes"), "POSITION", DMI_GLTF_NO_INDEX);
    return dmi_json_get(dmi_gltf_item(&gltf->document, DMI_GLTF_ACCESSORS, positions), "bufferView") != NULL;
}

const cJSON* dmi_gltf_draco_of(const dm_gltf* gltf, const cJSON* primitive) {
    const cJSON* found = dmi_json_get(dmi_json_get(primitive, "extensions"), DMI_DRACO_NAME);
    if (!found) return NULL;
    const int64_t view =
        dmi_gltf_position(&gltf->document, DMI_GLTF_VIEWS, dmi_json_number(found, "bufferView", DMI_GLTF_NO_INDEX));
    const int refused = view >= 0 && gltf->decoded[view].refused;
    return (refused || !dmi_draco_available()) && has_plain_data(gltf, primitive) ? NULL : found;
}

static dm_result accessor_count(dm_gltf* gltf, double accessor, const char* place, dmi_gltf_problem* problem,
                                uint64_t* out) {
    const cJSON* json = dmi_gltf_item(&gltf->document, DMI_GLTF_ACCESSORS, accessor);
    if (!json) return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: accessor %.17g does not exist", place, accessor);
    return dmi_json_whole(json, "count", 0, 3.0 * DM_MAX_ELEMENTS, place, problem, out);
}

/* Decodes the stream of the primitive, once. */
static dm_result open_draco(dm_gltf* gltf, const cJSON* primitive, const char* place, dmi_gltf_problem* problem,
                            dmi_gltf_decoded** out) {
    const double index = dmi_json_number(dmi_gltf_draco_of(gltf, primitive), "bufferView", DMI_GLTF_NO_INDEX);
    const cJSON* view = dmi_gltf_item(&gltf->document, DMI_GLTF_VIEWS, index);
    const cJSON* attributes = dmi_json_get(primitive, "attributes");
    dmi_gltf_view stream = {0};
    uint64_t points = 0, corners = 0;
    if (!view) return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: buffer view %.17g does not exist", place, index);
    *out = &gltf->decoded[dmi_gltf_position(&gltf->document, DMI_GLTF_VIEWS, index)];
    if ((*out)->draco) return DM_OK;
    dm_result result = dmi_gltf_find_stored(gltf, view, place, problem, &stream);
    if (result == DM_OK)
        result =
            accessor_count(gltf, dmi_json_number(attributes, "POSITION", DMI_GLTF_NO_INDEX), place, problem, &points);
    if (result == DM_OK)
        result =
            accessor_count(gltf, dmi_json_number(primitive, "indices", DMI_GLTF_NO_INDEX), place, problem, &corners);
    const uint64_t granted = result == DM_OK ? dmi_gltf_grant_draco(gltf, stream.size) : 0;
    if (result == DM_OK) result = dmi_gltf_spend(gltf, points, DRACO_BYTES_A_POINT, place, problem);
    if (result == DM_OK) result = dmi_gltf_spend(gltf, corners / 3, DRACO_BYTES_A_FACE, place, problem);
    if (result != DM_OK) return result;
    char reason[160] = "";
    result = dmi_draco_open(stream.data, (size_t)stream.size, (uint32_t)points, (uint32_t)(corners / 3), reason,
                            sizeof reason, &(*out)->draco);
    if (result == DM_OK) return DM_OK;
    dmi_gltf_take_back(gltf, granted);
    return dmi_gltf_refuse(problem, result, "%s: %s: %s", place, DMI_DRACO_NAME, reason);
}

/* Returns the elements of the block, which is filled when it is new. */
static dm_result read_block(dm_gltf* gltf, dmi_gltf_decoded* decoded, uint32_t id, int32_t type, const char* place,
                            dmi_gltf_problem* problem, dmi_gltf_elements* out) {
    dmi_gltf_block* block = decoded->blocks;
    while (block && (block->id != id || block->type != type)) block = block->next;
    const uint64_t element = (uint64_t)out->components * dmi_gltf_component_size(type);
    out->stride = element;
    if (!block) {
        const uint64_t size = sizeof *block + out->count * element;
        const dm_result result = dmi_gltf_spend(gltf, out->count, element, place, problem);
        if (result != DM_OK) return result;
        block = dmi_alloc(&gltf->env, size, 16);
        if (!block) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "%s: no memory for %" PRIu64, place, size);
        *block = (dmi_gltf_block){.next = decoded->blocks, .size = size, .id = id, .type = type};
        if (id == FACES) {
            dmi_draco_read_faces(decoded->draco, block->values);
        } else if (!dmi_draco_read(decoded->draco, id, type, block->values)) {
            dmi_free(&gltf->env, block, size);
            return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: values that can't be converted", place);
        }
        decoded->blocks = block;
    }
    out->data = (const uint8_t*)block->values;
    return DM_OK;
}

dm_result dmi_gltf_find_in_draco(dm_gltf* gltf, const cJSON* primitive, const char* attribute, const char* place,
                                 dmi_gltf_problem* problem, dmi_gltf_elements* out) {
    const cJSON* ids = dmi_json_get(dmi_gltf_draco_of(gltf, primitive), "attributes");
    dmi_gltf_decoded* decoded = NULL;
    uint64_t id;
    dm_result result = open_draco(gltf, primitive, place, problem, &decoded);
    if (result != DM_OK || !decoded) return result;
    if (!attribute) {
        *out = (dmi_gltf_elements){
            .count = 3 * (uint64_t)dmi_draco_faces(decoded->draco), .component_type = DMI_GLTF_UINT, .components = 1};
        return read_block(gltf, decoded, FACES, DMI_GLTF_UINT, place, problem, out);
    }
    const double index = dmi_json_number(dmi_json_get(primitive, "attributes"), attribute, DMI_GLTF_NO_INDEX);
    const cJSON* accessor = dmi_gltf_item(&gltf->document, DMI_GLTF_ACCESSORS, index);
    if (!dmi_json_get(ids, attribute)) return dmi_gltf_find_elements(gltf, index, place, problem, out);
    result = dmi_json_whole(ids, attribute, 0, INT32_MAX, place, problem, &id);
    if (result != DM_OK) return result;
    int32_t type;
    result = dmi_gltf_read_type(accessor, place, problem, &type);
    if (result != DM_OK) return result;
    *out = (dmi_gltf_elements){.count = dmi_draco_points(decoded->draco),
                               .component_type = type,
                               .components = dmi_gltf_components(dmi_json_text(accessor, "type")),
                               .normalized = cJSON_IsTrue(dmi_json_get(accessor, "normalized"))};
    if (out->components == 0 || dmi_draco_components(decoded->draco, (uint32_t)id) != (uint32_t)out->components ||
        dmi_gltf_component_size(out->component_type) == 0)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: %s is not what accessor %.17g says", place, attribute,
                               index);
    return read_block(gltf, decoded, (uint32_t)id, out->component_type, place, problem, out);
}

static void release_view(dmi_env* env, const dmi_gltf_decoded* decoded) {
    dmi_free(env, decoded->data, decoded->size);
    dmi_draco_close(decoded->draco);
    for (dmi_gltf_block *block = decoded->blocks, *next; block; block = next) {
        next = block->next;
        dmi_free(env, block, block->size);
    }
}

void dmi_gltf_release_decoded(dm_gltf* gltf) {
    const uint32_t views = gltf->document.counts[DMI_GLTF_VIEWS];
    for (uint32_t i = 0; gltf->decoded && i < views; i++) release_view(&gltf->env, &gltf->decoded[i]);
    dmi_free(&gltf->env, gltf->decoded, views * sizeof *gltf->decoded);
}

/* ---- primitives ---- */

static dm_result find_attribute(dm_gltf* gltf, const cJSON* primitive, const char* name, const char* place,
                                dmi_gltf_problem* problem, dmi_gltf_elements* out) {
    if (dmi_gltf_draco_of(gltf, primitive)) return dmi_gltf_find_in_draco(gltf, primitive, name, place, problem, out);
    const double index = dmi_json_number(dmi_json_get(primitive, "attributes"), name, DMI_GLTF_NO_INDEX);
    return dmi_gltf_find_elements(gltf, index, place, problem, out);
}

static int is_index_type(const dmi_gltf_elements* elements) {
    return elements->components == 1 &&
           (elements->component_type == DMI_GLTF_UBYTE || elements->component_type == DMI_GLTF_USHORT ||
            elements->component_type == DMI_GLTF_UINT);
}

static dm_result find_indices(dm_gltf* gltf, const cJSON* primitive, const char* place, dmi_gltf_problem* problem,
                              dmi_gltf_geometry* out) {
    const int draco = dmi_gltf_draco_of(gltf, primitive) != NULL;
    const double index = dmi_json_number(primitive, "indices", DMI_GLTF_NO_INDEX);
    out->indexed = draco || dmi_json_get(primitive, "indices") != NULL;
    if (!out->indexed) return DM_OK;
    const dm_result result = draco ? dmi_gltf_find_in_draco(gltf, primitive, NULL, place, problem, &out->indices)
                                   : dmi_gltf_find_elements(gltf, index, place, problem, &out->indices);
    if (result != DM_OK) return result;
    if (!is_index_type(&out->indices))
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: indices of component type %d, %d components", place,
                               out->indices.component_type, out->indices.components);
    out->indices.normalized = 0;
    return DM_OK;
}

/* Finds joints and weights of every vertex. A set that does not fit the vertices ends the list. */
static dm_result find_joints(dm_gltf* gltf, const cJSON* primitive, const char* place, dmi_gltf_problem* problem,
                             dmi_gltf_geometry* out) {
    const cJSON* attributes = dmi_json_get(primitive, "attributes");
    dmi_gltf_problem here;
    out->joint_key = dmi_json_number(attributes, "JOINTS_0", DMI_GLTF_NO_INDEX);
    for (uint32_t set = 0; set < DMI_GLTF_JOINT_SETS; set++) {
        char joints[16], weights[16];
        snprintf(joints, sizeof joints, "JOINTS_%u", set);
        snprintf(weights, sizeof weights, "WEIGHTS_%u", set);
        if (!dmi_json_get(attributes, joints) || !dmi_json_get(attributes, weights)) return DM_OK;
        dm_result result = find_attribute(gltf, primitive, joints, place, &here, &out->joints[set]);
        if (result == DM_OK) result = find_attribute(gltf, primitive, weights, place, &here, &out->weights[set]);
        if (result != DM_OK && here.fatal) {
            *problem = here;
            return result;
        }
        if (result != DM_OK || out->joints[set].components != 4 || out->weights[set].components != 4 ||
            out->joints[set].count < out->positions.count || out->weights[set].count < out->positions.count)
            return DM_OK;
        out->joint_sets++;
    }
    return DM_OK;
}

uint32_t dmi_gltf_key_count(const dm_gltf* gltf) {
    return gltf->document.counts[DMI_GLTF_ACCESSORS] + gltf->document.counts[DMI_GLTF_VIEWS];
}

uint32_t dmi_gltf_key(const dm_gltf* gltf, const cJSON* primitive) {
    const cJSON* draco = dmi_gltf_draco_of(gltf, primitive);
    const double index = draco ? dmi_json_number(draco, "bufferView", DMI_GLTF_NO_INDEX)
                               : dmi_json_number(dmi_json_get(primitive, "attributes"), "POSITION", DMI_GLTF_NO_INDEX);
    const int64_t position = dmi_gltf_position(&gltf->document, draco ? DMI_GLTF_VIEWS : DMI_GLTF_ACCESSORS, index);
    if (position < 0) return dmi_gltf_key_count(gltf);
    return (uint32_t)position + (draco ? gltf->document.counts[DMI_GLTF_ACCESSORS] : 0);
}

static dm_result find_geometry(dm_gltf* gltf, const cJSON* primitive, const char* place, dmi_gltf_problem* problem,
                               dmi_gltf_geometry* out) {
    uint64_t mode;
    dm_result result = dmi_json_whole(primitive, "mode", DMI_GLTF_TRIANGLES, INT32_MAX, place, problem, &mode);
    if (result != DM_OK) return result;
    *out = (dmi_gltf_geometry){.mode = (int32_t)mode, .key = dmi_gltf_key(gltf, primitive)};
    if (out->mode < DMI_GLTF_TRIANGLES || out->mode > DMI_GLTF_FAN)
        return dmi_gltf_refuse(problem, DM_ERROR_DEGENERATE_MESH, "%s: points or lines", place);
    if (!dmi_json_get(dmi_json_get(primitive, "attributes"), "POSITION"))
        return dmi_gltf_refuse(problem, DM_ERROR_DEGENERATE_MESH, "%s: it has no POSITION", place);
    result = find_attribute(gltf, primitive, "POSITION", place, problem, &out->positions);
    if (result == DM_OK && out->positions.components != 3)
        result =
            dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: %d components a vertex", place, out->positions.components);
    if (result == DM_OK) result = find_indices(gltf, primitive, place, problem, out);
    return result == DM_OK ? find_joints(gltf, primitive, place, problem, out) : result;
}

/* Takes the plain data when a Draco stream does not decode and the file does not need it. Returns whether it does. */
static int refuse_draco(dm_gltf* gltf, const cJSON* primitive, const dmi_gltf_problem* problem) {
    const cJSON* draco = dmi_gltf_draco_of(gltf, primitive);
    if (!draco || problem->fatal || !has_plain_data(gltf, primitive)) return 0;
    if (dmi_gltf_requires(&gltf->document, DMI_DRACO_NAME)) return 0;
    const int64_t view =
        dmi_gltf_position(&gltf->document, DMI_GLTF_VIEWS, dmi_json_number(draco, "bufferView", DMI_GLTF_NO_INDEX));
    if (view < 0) return 0;
    gltf->decoded[view].refused = 1;
    dmi_gltf_warn(&gltf->warnings, "%s; its plain data is read", problem->text);
    return 1;
}

dm_result dmi_gltf_find_geometry(dm_gltf* gltf, const cJSON* primitive, const char* place, dmi_gltf_problem* problem,
                                 dmi_gltf_geometry* out) {
    const dm_result result = find_geometry(gltf, primitive, place, problem, out);
    if (result == DM_OK || !refuse_draco(gltf, primitive, problem)) return result;
    *problem = (dmi_gltf_problem){.code = DM_OK};
    return find_geometry(gltf, primitive, place, problem, out);
}
