/* Pulls the first part of a prepared object open with a pointer, and lets it swing: first_door OBJECT.dmo */
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "dragmesh/dragmesh.hpp"

int main(int argc, char** argv) {
    std::ifstream file(argc > 1 ? argv[1] : "cabinet.dmo", std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    auto context = dragmesh::context::create();
    auto object = context->load_object(bytes);
    if (!object) return std::printf("%s\n", object.what()), 1;
    const auto part = object->part(0);
    dm_drag_desc desc = dm_drag_desc_default();
    desc.part_id = part->id, desc.grab_point = part->centre; /* of a hit: scene::pick */
    auto drag = object->grab(desc);
    if (!drag) return std::printf("%s\n", drag.what()), 1;
    dm_ray ray = {{part->centre.x, part->centre.y, part->centre.z + 2}, {0, 0, -2}};
    for (int frame = 0; frame < 60; frame++) { /* every frame: the pointer's ray in the object's frame */
        ray.direction.x = -0.003f * static_cast<float>(frame);
        drag->update(ray, 1.0f / 60);
    }
    dm_release_desc release = dm_release_desc_default();
    release.intent = DM_GO_OPEN;
    drag->let_go(release);
    while (drag->update(1.0f / 60)->phase != DM_DRAG_AT_REST) {
    }
    const auto kept = drag->end(); /* joint, value and pose: what the instance saves */
    std::printf("part %u stands open at %.2f\n", part->id, static_cast<double>(kept->value));
    return 0;
}
