/* Measures each node about its pivot, and compares them. */
#include "mesh/gltf/gltf_pivots.h"

#include "mesh/gltf/gltf_matrix.h"

enum { COLUMN = DMI_GLTF_COLUMN, ORIGIN = DMI_GLTF_ORIGIN };

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

/* Judges groups. Those at the scene's origin, or where all nodes with triangles have their pivot, are as unset as
 * these. */
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
    for (uint32_t i = gltf->node_count;
         i-- > 0;) { /* the first of several dm_gltf_nodes of one node counts, so it is written last */
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

int32_t dmi_gltf_pivot_kind(const dm_gltf* gltf, uint32_t file_node) {
    static const int32_t kinds[] = {
        [DMI_PIVOT_UNJUDGED] = DM_PIVOT_UNKNOWN, [DMI_PIVOT_UNSET] = DM_PIVOT_DEFAULT, [DMI_PIVOT_SET] = DM_PIVOT_SET};
    return kinds[gltf->tree[file_node].pivot_kind];
}
