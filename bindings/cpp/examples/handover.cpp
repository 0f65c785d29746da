/* What a host does with a joint beside dragging: a constraint for physics, a saved game, a client. handover OBJECT.dmo
 */
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "dragmesh/dragmesh.hpp"

/* Numbers, not the struct as it lies in memory: structs grow. */
static std::string save(const dm_part_state& door) {
    const dm_joint& j = door.joint;
    std::ostringstream out;
    out.precision(9); /* enough for every bit of a float */
    out << j.type << ' ' << j.source << ' ' << door.value << ' ' << j.type_confidence << ' ' << j.joint_confidence
        << ' ' << j.pitch << ' ' << j.axis.x << ' ' << j.axis.y << ' ' << j.axis.z << ' ' << j.origin.x << ' '
        << j.origin.y << ' ' << j.origin.z << ' ' << j.lower << ' ' << j.upper;
    for (const std::uint32_t word : j.evidence) out << ' ' << word; /* what pulls have said */
    return out.str();
}

static dm_part_state load(const std::string& text) {
    dm_part_state door = dm_part_state_default();
    door.joint = dm_joint_default();
    dm_joint& j = door.joint;
    std::istringstream in(text);
    in >> j.type >> j.source >> door.value >> j.type_confidence >> j.joint_confidence >> j.pitch >> j.axis.x >>
        j.axis.y >> j.axis.z >> j.origin.x >> j.origin.y >> j.origin.z >> j.lower >> j.upper;
    for (std::uint32_t& word : j.evidence) in >> word;
    return door; /* its pose is zeros: that of joint and value */
}

int main(int argc, char** argv) {
    std::ifstream file(argc > 1 ? argv[1] : "cabinet.dmo", std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    auto context = dragmesh::context::create();
    auto object = context->load_object(bytes);
    if (!object) return std::printf("%s\n", object.what()), 1;
    const auto part = object->part(0);
    dm_part_state door = dm_part_state_default();
    door.joint = *object->joint(part->id);

    /* Physics: origin, rotation (x is the axis) and limits are those of the engine's hinge or slider. */
    dm_joint_frame frame = dm_joint_frame_default();
    dm_joint_get_frame(&door.joint, &frame);
    std::printf("a constraint that opens to %.2f\n", static_cast<double>(frame.upper));

    /* … and back: body is the transform that the engine has given the part, from rest. */
    dm_pose body;
    dm_joint_pose(&door.joint, 1.2f, &body);
    float angle_off, distance_off;
    dm_joint_value(&door.joint, &body, &door.value, &angle_off, &distance_off);
    door.pose = body;
    std::printf("physics leaves it at %.2f\n", static_cast<double>(door.value));

    const dm_part_state loaded = load(save(door));
    std::printf("saved and loaded at %.2f\n", static_cast<double>(loaded.value));

    /* A client has neither object nor context: the joint once, the value every frame. */
    dm_pose shown;
    dm_joint_pose(&loaded.joint, loaded.value, &shown);

    /* The next grab begins where the part stands. */
    dm_drag_desc desc = dm_drag_desc_default();
    desc.part_id = part->id, desc.grab_point = dragmesh::apply(shown, part->centre), desc.state = &loaded;
    auto drag = object->grab(desc);
    if (!drag) return std::printf("%s\n", drag.what()), 1;
    const auto again = drag->end();
    std::printf("grabbed again at %.2f\n", static_cast<double>(again->value));
    return std::fabs(again->value - door.value) > 1e-4f;
}
