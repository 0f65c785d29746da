/* Parts of an object made of the nodes of its file. */
#include "nodes.h"

#include <math.h>

#include "cli.h"
#include "vec.h"

uint32_t node_of_face(const dm_gltf* gltf, uint64_t face) {
    uint32_t low = 0, high = dm_gltf_node_count(gltf) - 1;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        dm_gltf_node node;
        dm_gltf_get_node(gltf, middle, &node);
        if (face < node.first_face + node.face_count)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

void node_box_size(const session* session, uint32_t index, double out_size[3]) {
    dm_gltf_node node;
    dm_gltf_get_node(session->gltf, index, &node);
    vec low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    for (uint64_t v = node.first_vertex; v < node.first_vertex + node.vertex_count; v++) {
        const vec p = vec_at((const float*)session->mesh.positions + 3 * v);
        low = (vec){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (vec){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    const vec size = node.vertex_count > 0 ? sub(high, low) : (vec){0, 0, 0};
    out_size[0] = size.x, out_size[1] = size.y, out_size[2] = size.z;
}

uint32_t largest_node(const session* session) {
    uint32_t best = 0;
    double size = -1;
    for (uint32_t i = 0; i < dm_gltf_node_count(session->gltf); i++) {
        dm_gltf_node node;
        dm_gltf_get_node(session->gltf, i, &node);
        double sides[3];
        node_box_size(session, i, sides);
        const double diagonal = length((vec){sides[0], sides[1], sides[2]});
        if (node.face_count == 0 || diagonal <= size) continue;
        best = i;
        size = diagonal;
    }
    return best;
}

/* The entry that the node goes with, of the same bone in another mesh; itself when there is none. */
static uint32_t first_of_bone(const session* session, uint32_t index) {
    dm_gltf_node node, carrier;
    dm_gltf_get_node(session->gltf, index, &node);
    if (dm_gltf_get_node(session->gltf, node.carrier, &carrier) != DM_OK) return index;
    return carrier.node == node.node ? node.carrier : index;
}

uint16_t node_part_id(const session* session, uint32_t index, uint32_t body) {
    const uint32_t first = first_of_bone(session, index);
    return first == first_of_bone(session, body) ? 0 : (uint16_t)(first + 1);
}

uint16_t* node_part_ids(const session* session, uint32_t body) {
    uint16_t* ids = cli_alloc_zeroed(session->mesh.index_count / 3 * sizeof *ids);
    for (uint32_t i = 0; i < dm_gltf_node_count(session->gltf); i++) {
        dm_gltf_node node;
        dm_gltf_get_node(session->gltf, i, &node);
        const uint16_t id = node_part_id(session, i, body);
        for (uint64_t face = 0; face < node.face_count; face++) ids[node.first_face + face] = id;
    }
    return ids;
}
