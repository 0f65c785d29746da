/* Reads the tree of nodes: who carries whom, where they are in the world, and which of them the scene has. It finds
 * nodes by name. */
#include "gltf/gltf_tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/utf8.h"

/* Composes translation, rotation and scale (glTF 2.0 §5.25). */
static void compose_matrix(const cJSON* node, double out[16]) {
    double q[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1}, t[3] = {0, 0, 0};
    dmi_json_numbers(node, "rotation", 4, q);
    dmi_json_numbers(node, "scale", 3, s);
    dmi_json_numbers(node, "translation", 3, t);
    dmi_gltf_normalize(q);
    dmi_gltf_compose(t, q, s, out);
}

void dmi_gltf_local_matrix(const cJSON* node, double out[16]) {
    if (!dmi_json_numbers(node, "matrix", 16, out)) compose_matrix(node, out);
}

/* Returns whether `node` has a rotation without a direction, which compose_matrix takes as none. */
static int is_turned_nowhere(const cJSON* node) {
    double q[4] = {0, 0, 0, 1};
    dmi_json_numbers(node, "rotation", 4, q);
    return q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0;
}

/* ---- the tree ---- */

static void read_nodes(dm_gltf* gltf) {
    const dmi_gltf_document* document = &gltf->document;
    for (uint32_t i = 0; i < document->counts[DMI_GLTF_NODES]; i++) {
        const cJSON* json = document->items[DMI_GLTF_NODES][i];
        const char* name = dmi_json_text(json, "name");
        const double mesh = dmi_json_number(json, "mesh", DMI_GLTF_NO_INDEX);
        dmi_gltf_tree_node* node = &gltf->tree[i];
        *node = (dmi_gltf_tree_node){.json = json, .name = name ? name : "", .parent = -1, .named = -1, .follows = -1};
        node->mesh = (int32_t)dmi_gltf_position(document, DMI_GLTF_MESHES, mesh);
        if (is_turned_nowhere(json))
            dmi_gltf_warn(&gltf->warnings, "glTF node %u '%.80s': its rotation is 0 0 0 0, taken as none", i,
                          node->name);
        if (mesh < 0 || node->mesh >= 0) continue;
        dmi_gltf_problem missing;
        dmi_gltf_refuse(&missing, DM_ERROR_BAD_DATA, "glTF node %u '%.80s': mesh %.17g does not exist", i, node->name,
                        mesh);
        dmi_gltf_leave_out(gltf, &missing);
    }
}

static dm_result read_parents(dm_gltf* gltf, dmi_gltf_problem* problem) {
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    for (uint32_t i = 0; i < count; i++) {
        const cJSON* child;
        cJSON_ArrayForEach(child, dmi_json_get(gltf->tree[i].json, "children")) {
            const int64_t index = dmi_gltf_position(&gltf->document, DMI_GLTF_NODES, child->valuedouble);
            if (index < 0)
                return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA,
                                       "glTF: node %u has child %.17g, the file has %u nodes", i, child->valuedouble,
                                       count);
            if (gltf->tree[index].parent >= 0 || index == i)
                return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "glTF: node %d is a child of node %u and of node %d",
                                       (int)index, i, gltf->tree[index].parent);
            gltf->tree[index].parent = (int32_t)i;
        }
    }
    return DM_OK;
}

/* Marks what the scene that a viewer shows lists; without a list, all roots. A listed node that another one carries
 * comes with that one. */
static dm_result list_roots(dm_gltf* gltf, dmi_gltf_problem* problem) {
    const dmi_gltf_document* document = &gltf->document;
    const cJSON* scene = dmi_gltf_item(document, DMI_GLTF_SCENES, dmi_json_number(document->root, "scene", 0));
    const cJSON *list = dmi_json_get(scene, "nodes"), *root;
    cJSON_ArrayForEach(root, list) {
        const int64_t index = dmi_gltf_position(document, DMI_GLTF_NODES, root->valuedouble);
        if (index < 0)
            return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA,
                                   "glTF: the scene lists node %.17g, the file has %u nodes", root->valuedouble,
                                   document->counts[DMI_GLTF_NODES]);
        gltf->tree[index].in_scene = 1;
    }
    for (uint32_t i = 0; !list || !list->child ? i < document->counts[DMI_GLTF_NODES] : 0; i++)
        gltf->tree[i].in_scene = 1;
    return DM_OK;
}

/* Places the nodes. It walks from the roots: every node has one parent at most, so the walk meets it once, and a cycle
 * has no root. */
static void place_nodes(dm_gltf* gltf) {
    for (uint32_t i = 0; i < gltf->document.counts[DMI_GLTF_NODES]; i++) {
        if (gltf->tree[i].parent < 0) gltf->order[gltf->order_count++] = i;
    }
    for (uint32_t at = 0; at < gltf->order_count; at++) {
        dmi_gltf_tree_node* node = &gltf->tree[gltf->order[at]];
        double local[16];
        const cJSON* child;
        dmi_gltf_local_matrix(node->json, local);
        if (node->parent < 0) {
            memcpy(node->world, local, sizeof local);
        } else {
            const dmi_gltf_tree_node* parent = &gltf->tree[node->parent];
            dmi_gltf_multiply(parent->world, local, node->world);
            node->in_scene = parent->in_scene;
            node->named = parent->name[0] ? node->parent : parent->named;
        }
        node->placed = 1;
        cJSON_ArrayForEach(child, dmi_json_get(node->json, "children")) gltf->order[gltf->order_count++] =
            (uint32_t)child->valuedouble;
    }
}

dm_result dmi_gltf_read_tree(dm_gltf* gltf, dmi_gltf_problem* problem) {
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    dm_result result =
        dmi_gltf_spend(gltf, count, sizeof *gltf->tree + sizeof *gltf->order, "glTF: the nodes", problem);
    if (result != DM_OK) return result;
    gltf->tree = dmi_alloc_zeroed(&gltf->env, count * sizeof *gltf->tree, 16);
    gltf->order = dmi_alloc(&gltf->env, count * sizeof *gltf->order, 16);
    if (!gltf->tree || !gltf->order)
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u nodes", count);
    read_nodes(gltf);
    result = read_parents(gltf, problem);
    if (result == DM_OK) result = list_roots(gltf, problem);
    if (result != DM_OK) return result;
    place_nodes(gltf);
    return DM_OK;
}

/* ---- names, sorted, so that one is found in the logarithm of their number ---- */

static int compare(const void* a, const void* b) {
    const dmi_gltf_name *x = a, *y = b;
    const int names = strcmp(x->name, y->name);
    return names != 0 ? names : (x->node > y->node) - (x->node < y->node);
}

dm_result dmi_gltf_sort_names(dm_gltf* gltf, dmi_gltf_problem* problem) {
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    if (count == 0) return DM_OK;
    const dm_result result = dmi_gltf_spend(gltf, count, sizeof *gltf->names, "glTF: the names", problem);
    if (result != DM_OK) return result;
    gltf->names = dmi_alloc(&gltf->env, count * sizeof *gltf->names, _Alignof(dmi_gltf_name));
    if (!gltf->names)
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "no memory for the names of %u nodes", count);
    for (uint32_t i = 0; i < count; i++) gltf->names[i] = (dmi_gltf_name){gltf->tree[i].name, i};
    qsort(gltf->names, count, sizeof *gltf->names, compare);
    return DM_OK;
}

/* Returns the first place from `low` on whose name is `name` or comes after it. after: only one that comes after it. */
static uint32_t lower_bound(const dm_gltf* gltf, const char* name, uint32_t low, bool after) {
    uint32_t high = gltf->document.counts[DMI_GLTF_NODES];
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        const int order = dmi_utf8_compare_mended(name, gltf->names[middle].name);
        if (order > 0 || (after && order == 0))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Finds the node that "#12" stands for. It finds none where the name is not of this form, or there is no such node. */
static dmi_gltf_namesakes numbered_node(const dm_gltf* gltf, const char* name) {
    const dmi_gltf_namesakes none = {NULL, 0};
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    if (name[0] != '#' || name[1] < '0' || name[1] > '9') return none;
    char* end;
    const unsigned long index = strtoul(name + 1, &end, 10);
    if (*end != 0 || index >= count) return none;
    const dmi_gltf_name wanted = {gltf->tree[index].name, (uint32_t)index};
    return (dmi_gltf_namesakes){bsearch(&wanted, gltf->names, count, sizeof wanted, compare), 1};
}

dmi_gltf_namesakes dmi_gltf_find_nodes(const dm_gltf* gltf, const char* name) {
    const uint32_t first = lower_bound(gltf, name, 0, false), end = lower_bound(gltf, name, first, true);
    return end > first ? (dmi_gltf_namesakes){gltf->names + first, end - first} : numbered_node(gltf, name);
}
