/* Finds nodes whose meshes are one, shifted: exporters store those once. */
#include <stdlib.h>

#include "asset/asset_layer.h"

/* Where the faces of each node are listed, one after the other. */
typedef struct listing {
    uint32_t* first; /* node_count + 1 */
    uint32_t* faces;
} listing;

static int list_faces(const dmg_asset* asset, listing* out) {
    out->first = calloc(asset->node_count + 2, sizeof *out->first);
    out->faces = malloc((asset->object.face_count + 1) * sizeof *out->faces);
    if (!out->first || !out->faces) return 1;
    for (uint32_t f = 0; f < asset->object.face_count; ++f) ++out->first[asset->face_node[f] + 2];
    for (uint32_t i = 2; i < asset->node_count + 2; ++i) out->first[i] += out->first[i - 1];
    for (uint32_t f = 0; f < asset->object.face_count; ++f) out->faces[out->first[asset->face_node[f] + 1]++] = f;
    return 0;
}

static dmg_vec corner(const dmg_object* object, uint32_t face, uint32_t k) {
    return v3_from(object->positions + 3 * (size_t)object->indices[3 * face + k]);
}

/* Whether node `b` is node `a`, shifted by what their first corners are apart. */
static bool is_shifted(const dmg_asset* asset, const listing* list, uint32_t a, uint32_t b, float tolerance) {
    const uint32_t *one = list->faces + list->first[a], *other = list->faces + list->first[b];
    const uint32_t count = asset->nodes[a].face_count;
    if (count != asset->nodes[b].face_count) return false;
    const dmg_vec by = v3_sub(corner(&asset->object, other[0], 0), corner(&asset->object, one[0], 0));
    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t k = 0; k < 3; ++k) {
            const dmg_vec off = v3_sub(corner(&asset->object, other[i], k), corner(&asset->object, one[i], k));
            if (v3_length(v3_sub(off, by)) > tolerance) return false;
        }
    }
    return true;
}

/* Moves the node's pivot to where that of the mesh's first node is. */
static void align(dmg_asset* asset, const listing* list, uint32_t node) {
    const uint32_t first = asset->nodes[node].mesh;
    const dmg_vec by = v3_sub(corner(&asset->object, list->faces[list->first[node]], 0),
                              corner(&asset->object, list->faces[list->first[first]], 0));
    v3_to(v3_add(v3_from(asset->nodes[first].transform + 12), by), asset->nodes[node].transform + 12);
}

int dmg_share_meshes(dmg_asset* asset) {
    listing list = {0};
    const int failed = list_faces(asset, &list);
    const float tolerance = 2e-6f * dmg_object_size(&asset->object);
    for (uint32_t i = 1; !failed && i < asset->node_count; ++i) {
        uint32_t other = 0;
        if (asset->nodes[i].face_count == 0) continue;
        while (other < i && !(asset->nodes[other].mesh == other && is_shifted(asset, &list, other, i, tolerance)))
            ++other;
        if (other == i) continue;
        asset->nodes[i].mesh = other;
        align(asset, &list, i);
    }
    free(list.first);
    free(list.faces);
    return failed;
}
