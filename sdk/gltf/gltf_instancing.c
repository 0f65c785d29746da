/* Makes nodes of instances. Each may be a part, such as one of four drawers, and the rest of the library need not know
 * of instances. */
#include "gltf/gltf_tree.h"

#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "gltf/gltf_accessor.h"

/* Bytes of the node that an instance becomes, counted: some 16 values of cJSON, and its places in the tree and among
 * the names. */
#define BYTES_AN_INSTANCE 2048
#define NAME_SIZE 256

enum { TRANSLATION, ROTATION, SCALE, ATTRIBUTES };

static const struct {
    const char *attribute, *member;
    int components;
} kinds[ATTRIBUTES] = {{"TRANSLATION", "translation", 3}, {"ROTATION", "rotation", 4}, {"SCALE", "scale", 3}};

typedef struct instances {
    cJSON* node;
    const char* place;
    uint64_t count;
    bool has[ATTRIBUTES];
    dmi_gltf_elements elements[ATTRIBUTES];
} instances;

static dm_result read_attribute(dm_gltf* gltf, const cJSON* attributes, int kind, instances* out,
                                dmi_gltf_problem* problem) {
    const cJSON* accessor = dmi_json_get(attributes, kinds[kind].attribute);
    dmi_gltf_elements* elements = &out->elements[kind];
    if (!cJSON_IsNumber(accessor)) return DM_OK;
    const dm_result result = dmi_gltf_find_elements(gltf, accessor->valuedouble, out->place, problem, elements);
    if (result != DM_OK) return result;
    if (elements->components != kinds[kind].components)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: %s of its instances has %d components", out->place,
                               kinds[kind].attribute, elements->components);
    if (out->count > 0 && elements->count != out->count)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: %" PRIu64 " instances have a %s, not %" PRIu64,
                               out->place, elements->count, kinds[kind].attribute, out->count);
    out->count = elements->count;
    out->has[kind] = true;
    return DM_OK;
}

static dm_result read_attributes(dm_gltf* gltf, const cJSON* extension, instances* out, dmi_gltf_problem* problem) {
    const cJSON* attributes = dmi_json_get(extension, "attributes");
    if (dmi_json_get(out->node, "skin"))
        return dmi_gltf_refuse(problem, DM_ERROR_UNSUPPORTED, "%s: its instances have bones", out->place);
    for (int kind = 0; kind < ATTRIBUTES; kind++) {
        const dm_result result = read_attribute(gltf, attributes, kind, out, problem);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

/* Returns whether all that moves, turns or scales an instance is finite. */
static bool is_finite(const instances* from, uint64_t instance) {
    for (int kind = 0; kind < ATTRIBUTES; kind++)
        for (int k = 0; from->has[kind] && k < kinds[kind].components; k++)
            if (!isfinite(dmi_gltf_value(&from->elements[kind], instance, k))) return false;
    return true;
}

/* Sets a member. Returns whether there was memory for it, and for `item`. */
static bool set_member(cJSON* node, const char* name, cJSON* item) {
    if (item && cJSON_AddItemToObject(node, name, item)) return true;
    cJSON_Delete(item);
    return false;
}

static bool add_transform(const instances* from, uint64_t instance, cJSON* node) {
    for (int kind = 0; kind < ATTRIBUTES; kind++) {
        double values[4];
        if (!from->has[kind]) continue;
        for (int k = 0; k < kinds[kind].components; k++) values[k] = dmi_gltf_value(&from->elements[kind], instance, k);
        if (!set_member(node, kinds[kind].member, cJSON_CreateDoubleArray(values, kinds[kind].components)))
            return false;
    }
    return true;
}

/* Returns the node of an instance, or NULL when there is no memory. */
static cJSON* make_node(const instances* from, uint64_t instance) {
    cJSON* node = cJSON_CreateObject();
    const char* name = dmi_json_text(from->node, "name");
    const cJSON* weights = dmi_json_get(from->node, "weights");
    char text[NAME_SIZE] = "";
    if (name) snprintf(text, sizeof text, "%.*s.%" PRIu64, NAME_SIZE / 2, name, instance);
    if (node && set_member(node, "mesh", cJSON_Duplicate(dmi_json_get(from->node, "mesh"), 1)) &&
        (!name || set_member(node, "name", cJSON_CreateString(text))) &&
        (!weights || set_member(node, "weights", cJSON_Duplicate(weights, 1))) && add_transform(from, instance, node))
        return node;
    cJSON_Delete(node);
    return NULL;
}

/* Returns the list of children of the node, a new one where it has none, or NULL when there is no memory. */
static cJSON* children_of(cJSON* node) {
    cJSON* children = cJSON_GetObjectItemCaseSensitive(node, "children");
    return children ? children : cJSON_AddArrayToObject(node, "children");
}

/* Removes mesh and extension from the node, because its instances have them now. */
static void empty_node(cJSON* node) {
    cJSON* extensions = cJSON_GetObjectItemCaseSensitive(node, "extensions");
    cJSON_DeleteItemFromObjectCaseSensitive(node, "mesh");
    cJSON_DeleteItemFromObjectCaseSensitive(node, "weights");
    cJSON_DeleteItemFromObjectCaseSensitive(extensions, DMI_INSTANCING_NAME);
    if (!extensions->child) cJSON_DeleteItemFromObjectCaseSensitive(node, "extensions");
}

/* Appends the node of an instance, and its index to the children of the one that had it. */
static dm_result add_node(const instances* from, uint64_t instance, cJSON* nodes, uint32_t* inout_count,
                          dmi_gltf_problem* problem) {
    cJSON* children = children_of(from->node);
    cJSON *node = make_node(from, instance), *index = cJSON_CreateNumber(*inout_count);
    if (!children || !node || !index) {
        cJSON_Delete(node);
        cJSON_Delete(index);
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "%s: no memory for its instances", from->place);
    }
    cJSON_AddItemToArray(nodes, node);
    cJSON_AddItemToArray(children, index);
    ++*inout_count;
    return DM_OK;
}

static dm_result add_nodes(dm_gltf* gltf, const instances* from, cJSON* nodes, uint32_t* inout_count,
                           dmi_gltf_problem* problem) {
    uint64_t lost = 0;
    for (uint64_t i = 0; i < from->count; i++) {
        dm_result result = dmi_gltf_tell(gltf, 0, 1, problem);
        if (!is_finite(from, i))
            lost++;
        else if (result == DM_OK)
            result = add_node(from, i, nodes, inout_count, problem);
        if (result != DM_OK) return result;
    }
    empty_node(from->node);
    if (lost == 0) return DM_OK;
    dmi_gltf_problem here;
    dmi_gltf_refuse(&here, DM_ERROR_NOT_FINITE, "%s: %" PRIu64 " of its %" PRIu64 " instances are nowhere", from->place,
                    lost, from->count);
    dmi_gltf_leave_out(gltf, &here);
    return DM_OK;
}

/* Unrolls the instances of one node. */
static dm_result unroll_node(dm_gltf* gltf, uint32_t index, cJSON* nodes, uint32_t* inout_count,
                             dmi_gltf_problem* problem) {
    cJSON* node = gltf->document.items[DMI_GLTF_NODES][index];
    const cJSON* extension = dmi_json_get(dmi_json_get(node, "extensions"), DMI_INSTANCING_NAME);
    char place[NAME_SIZE];
    instances from = {.node = node, .place = place};
    dmi_gltf_problem here = {.code = DM_OK};
    if (!extension || !dmi_json_get(node, "mesh")) return DM_OK;
    const char* name = dmi_json_text(node, "name");
    snprintf(place, sizeof place, "glTF node %u '%.80s'", index, name ? name : "");
    const dm_result result = read_attributes(gltf, extension, &from, &here);
    if (result != DM_OK && !here.fatal) {
        dmi_gltf_warn(&gltf->warnings, "%s; only one of its instances is read", here.text);
        gltf->has_one_of_instances = 1;
        return DM_OK;
    }
    if (result != DM_OK) {
        *problem = here;
        return result;
    }
    if (from.count == 0) return DM_OK;
    const dm_result spent = dmi_gltf_spend(gltf, from.count, BYTES_AN_INSTANCE, place, problem);
    return spent == DM_OK ? add_nodes(gltf, &from, nodes, inout_count, problem) : spent;
}

dm_result dmi_gltf_unroll_instances(dm_gltf* gltf, dmi_gltf_problem* problem) {
    const uint32_t before = gltf->document.counts[DMI_GLTF_NODES];
    cJSON* nodes = cJSON_GetObjectItemCaseSensitive(gltf->document.root, "nodes");
    uint32_t count = before;
    for (uint32_t i = 0; i < before; i++) {
        const dm_result result = unroll_node(gltf, i, nodes, &count, problem);
        if (result != DM_OK) return result;
    }
    return count > before ? dmi_gltf_list_again(&gltf->env, &gltf->document, DMI_GLTF_NODES, problem) : DM_OK;
}
