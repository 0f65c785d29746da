/* Opens the door of a prepared object by a fifth of its range, without any mesh: example OBJECT.dmo */
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "dragmesh.hpp"

int main(int argc, char** argv) {
    std::ifstream file(argc > 1 ? argv[1] : "cabinet.dmo", std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    auto context = dragmesh::context::create();
    if (!context) return 1;
    auto object = context->load_object(bytes);
    if (!object) return std::printf("%s\n", object.what()), 1;
    const auto part = object->part(0);
    const auto joint = part ? object->joint(part->id) : dragmesh::result<dm_joint>::failed(part.error());
    if (!joint) return std::printf("%s\n", joint.what()), 1;
    dm_pose pose;
    dm_joint_pose(&*joint, joint->lower + 0.2f * (joint->upper - joint->lower), &pose);
    const dm_vec3 moved = dragmesh::apply(pose, part->centre);
    std::printf("part %u turns or slides from %.2f to %.2f; a fifth open, its centre is at (%.2f, %.2f, %.2f)\n",
                part->id, static_cast<double>(joint->lower), static_cast<double>(joint->upper),
                static_cast<double>(moved.x), static_cast<double>(moved.y), static_cast<double>(moved.z));
    return 0;
}
