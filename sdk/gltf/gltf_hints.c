/* What a file says of a node beside its mesh: the names on the way to it, where it is, its axes, and whether these are
 * the modeller's own. */
#include "gltf/gltf_hints.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/fp_environment.h"
#include "base/label_path.h"
#include "gltf/gltf_matrix.h"
#include "gltf/gltf_names.h"

enum { COLUMN = DMI_GLTF_COLUMN, ORIGIN = DMI_GLTF_ORIGIN };

const char* dmi_gltf_mesh_name(const dm_gltf* gltf, const dmi_gltf_tree_node* node) {
    const cJSON* mesh = dmi_gltf_item(&gltf->document, DMI_GLTF_MESHES, node->mesh);
    const char* name = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(mesh, "name"));
    return name ? name : "";
}

/* Writes the names of the nodes that carry a node, of its mesh and its own. Where not all fit, the innermost ones of
 * the nodes above stay. */
static void write_path(const dm_gltf* gltf, const dmi_gltf_tree_node* node, char* out, size_t size) {
    size_t used = dmi_put_name_before(out, size, 1, node->name);
    out[size - 1] = 0;
    used = dmi_put_name_before(out, size, used, dmi_gltf_mesh_name(gltf, node));
    for (int32_t index = node->named; index >= 0; index = gltf->tree[index].named) {
        const size_t before = used;
        used = dmi_put_name_before(out, size, used, gltf->tree[index].name);
        if (used == before) break;
    }
    memmove(out, out + size - used, used);
}

static bool fit_floats(const double* numbers, int count) {
    for (int i = 0; i < count; i++)
        if (!(fabs(numbers[i]) <= FLT_MAX)) return false;
    return true;
}

bool dmi_gltf_write_pivot(const dm_gltf* gltf, const double world[16], dm_pivot* out) {
    float origin[3];
    *out = (dm_pivot){{0, 0, 0}, {0}};
    if (!fit_floats(world, ORIGIN + 3)) return false;
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++) out->axes[3 * column + row] = (float)world[COLUMN * column + row];
    for (int row = 0; row < 3; row++) origin[row] = (float)(world[ORIGIN + row] - gltf->origin[row]);
    out->origin = (dm_vec3){origin[0], origin[1], origin[2]};
    return true;
}

/* ---- whether pivots follow a rule ---- */

static dmi_pivot_witness witness_of(const dm_gltf* gltf, const dm_gltf_node* node) {
    const double* world = gltf->tree[node->node].world;
    const uint32_t* corners = gltf->indices + 3 * node->first_face;
    dmi_pivot_gauge gauge;
    double origin[3];
    float axes[9];
    for (int row = 0; row < 3; row++) {
        origin[row] = world[ORIGIN + row] - gltf->origin[row];
        for (int column = 0; column < 3; column++) axes[3 * column + row] = (float)world[COLUMN * column + row];
    }
    dmi_pivot_gauge_begin(origin, axes, &gauge);
    for (uint64_t f = 0; f < node->face_count; f++) {
        double face[3][3];
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++) face[i][k] = (double)gltf->positions[3 * (size_t)corners[3 * f + i] + k];
        dmi_pivot_gauge_add_face(&gauge, (const double(*)[3])face);
    }
    return dmi_pivot_gauge_finish(&gauge);
}

/* Groups that stand at the scene's origin, or where all nodes with triangles do, are as unset as these. */
static void judge_groups(dm_gltf* gltf) {
    const double* shared = gltf->tree[gltf->nodes[0].node].world;
    for (uint32_t i = 0; i < gltf->order_count; i++) {
        dmi_gltf_tree_node* node = &gltf->tree[gltf->order[i]];
        bool at_origin = true, at_shared = true;
        for (int row = ORIGIN; row < ORIGIN + 3; row++) {
            at_origin &= node->world[row] == 0;
            at_shared &= node->world[row] == shared[row];
        }
        if (node->pivot_kind == DMI_PIVOT_UNJUDGED && (at_origin || at_shared)) node->pivot_kind = DMI_PIVOT_UNSET;
    }
}

static void keep_kinds(dm_gltf* gltf, const dmi_pivot_kind* kinds) {
    gltf->pivots_are_lost = gltf->node_count > 1;
    for (uint32_t i = gltf->node_count; i-- > 0;) { /* where several have one node, the first counts */
        gltf->tree[gltf->nodes[i].node].pivot_kind = (uint8_t)kinds[i];
        gltf->pivots_are_lost &= kinds[i] == DMI_PIVOT_UNSET;
    }
    if (gltf->pivots_are_lost) judge_groups(gltf);
}

dm_result dmi_gltf_judge_pivots(dm_gltf* gltf, dmi_gltf_problem* problem) {
    const uint32_t count = gltf->node_count;
    const size_t each = sizeof(dmi_pivot_witness) + sizeof(dmi_pivot_kind);
    const dm_result result = dmi_gltf_spend(gltf, count, each, "glTF: the pivots", problem);
    if (result != DM_OK || count == 0) return result;
    dmi_pivot_witness* nodes = dmi_alloc(&gltf->env, count * each, _Alignof(dmi_pivot_witness));
    if (!nodes)
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for the pivots of %u nodes", count);
    dmi_pivot_kind* kinds = (dmi_pivot_kind*)(nodes + count);
    for (uint32_t i = 0; i < count; i++) nodes[i] = witness_of(gltf, &gltf->nodes[i]);
    dmi_pivots_judge(nodes, count, kinds);
    keep_kinds(gltf, kinds);
    dmi_free(&gltf->env, nodes, count * each);
    return DM_OK;
}

/* Returns what is known of the pivot of a node of the file: DM_PIVOT_*. */
static int32_t pivot_kind(const dm_gltf* gltf, uint32_t file_node) {
    static const int32_t kinds[] = {
        [DMI_PIVOT_UNJUDGED] = DM_PIVOT_UNKNOWN, [DMI_PIVOT_UNSET] = DM_PIVOT_DEFAULT, [DMI_PIVOT_SET] = DM_PIVOT_SET};
    return kinds[gltf->tree[file_node].pivot_kind];
}

/* ---- what hosts ask ---- */

int32_t dm_gltf_pivots_are_lost(const dm_gltf* gltf) {
    return gltf && gltf->pivots_are_lost;
}

dm_result dm_gltf_get_pivot_kind(const dm_gltf* gltf, const char* name, int32_t* out_kind) {
    DMI_OWN_FP;
    if (!gltf || !name || !out_kind) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_gltf_namesakes found = dmi_gltf_find_nodes(gltf, name);
    if (found.count == 0 || !gltf->tree[found.first->node].placed) return DM_ERROR_NOT_FOUND;
    *out_kind = pivot_kind(gltf, found.first->node);
    return DM_OK;
}

dm_result dm_gltf_get_hints(const dm_gltf* gltf, const char* name, char* out_label, size_t label_size,
                            dm_pivot* out_pivot) {
    DMI_OWN_FP;
    if (!gltf || !name || (out_label && label_size == 0)) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_gltf_namesakes found = dmi_gltf_find_nodes(gltf, name);
    const dmi_gltf_tree_node* node = found.count > 0 ? &gltf->tree[found.first->node] : NULL;
    if (!node || !node->placed) return DM_ERROR_NOT_FOUND;
    if (out_label) write_path(gltf, node, out_label, label_size);
    if (out_pivot) dmi_gltf_write_pivot(gltf, node->world, out_pivot);
    return DM_OK;
}
