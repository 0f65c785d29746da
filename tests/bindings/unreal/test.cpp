/* The engine-free part of the Unreal plugin, in Unreal's frame: opens a part of a cabinet with a pointer, saves it,
 * restores it, and closes it by itself. OBJECT.dmo */
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "OpenableParts.h"

namespace {

constexpr float frame = 1.0f / 60, near = 0.01f; /* s; cm and rad */

void must(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "unreal: %s\n", what);
    std::exit(1);
}

/* FTransform's own arithmetic: q v q*, then the translation. */
dm_vec3 transform(const dragmesh_unreal::placement& p, dm_vec3 v) {
    const float *q = p.rotation, w = q[3];
    const dm_vec3 t = {2 * (q[1] * v.z - q[2] * v.y), 2 * (q[2] * v.x - q[0] * v.z), 2 * (q[0] * v.y - q[1] * v.x)};
    return {v.x + w * t.x + q[1] * t.z - q[2] * t.y + p.translation.x,
            v.y + w * t.y + q[2] * t.x - q[0] * t.z + p.translation.y,
            v.z + w * t.z + q[0] * t.y - q[1] * t.x + p.translation.z};
}

float distance(dm_vec3 a, dm_vec3 b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

} // namespace

int main(int argc, char** argv) {
    must(argc == 2, "OBJECT.dmo");
    std::ifstream file(argv[1], std::ios::binary);
    const std::vector<std::uint8_t> dmo{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    auto context = dragmesh_unreal::create_context();
    must(bool(context), "a context");
    must(!dragmesh_unreal::openable_parts::load(*context, {}), "no bytes are no object");
    auto loaded = dragmesh_unreal::openable_parts::load(*context, dmo);
    must(bool(loaded), loaded.what());
    dragmesh_unreal::openable_parts cabinet = std::move(*loaded);
    must(cabinet.count() == 4, "two doors and two drawers");

    const dm_part_info door = cabinet.info(0);
    const dm_joint hinge = cabinet.state(0).joint;
    must(hinge.type == DM_JOINT_REVOLUTE && std::fabs(std::fabs(hinge.axis.z) - 1) < near,
         "the hinge stands upright: z is up");
    must(door.box_max.z - door.box_min.z > 30, "lengths are centimetres");
    must(distance(transform(cabinet.at(0), door.centre), door.centre) < near, "it is closed");

    /* Unreal's y is glTF's z: the front. The pull goes to the hinge's side and forwards. */
    must(cabinet.grab(0, door.centre) && !cabinet.grab(0, door.centre), "one hand at a time");
    dm_ray ray = {{door.centre.x, door.centre.y + 200, door.centre.z}, {0, -200, 0}};
    for (int i = 0; i < 60; i++) {
        ray.direction.x = 0.3f * static_cast<float>(i) * (hinge.origin.x > door.centre.x ? 1.0f : -1.0f);
        cabinet.pull(0, ray, frame);
    }
    const float value = cabinet.state(0).value;
    must(value > 0.5f, "the door follows the pointer");
    const dm_vec3 now = transform(cabinet.at(0), door.centre);
    must(distance(now, dragmesh::apply(cabinet.state(0).pose, door.centre)) < near, "the placement is the pose");
    must(now.y > door.centre.y + 5, "the door comes to the front");

    const dm_part_state saved = cabinet.state(0);
    cabinet.release(0, DM_GO_OPEN);
    for (int i = 0; i < 600; i++) cabinet.advance(frame);
    must(std::fabs(cabinet.state(0).value - hinge.upper) < near, "it swings open by itself");
    must(cabinet.move(0, DM_GO_CLOSE), "it is moved without a hand");
    for (int i = 0; i < 600; i++) cabinet.advance(frame);
    must(std::fabs(cabinet.state(0).value) < near, "it closes by itself");
    cabinet.restore(0, saved);
    const dm_part_state restored = cabinet.state(0);
    must(saved.joint.evidence[0] != 0, "the pull has said something");
    must(std::memcmp(restored.joint.evidence, saved.joint.evidence, sizeof saved.joint.evidence) == 0,
         "what pulls have said is restored");
    must(distance(transform(cabinet.at(0), door.centre), now) < near, "it stands where it was saved");
    must(cabinet.grab(0, now), "it is grabbed where it stands");

    /* Indexes of parts that are not there, as a component has them whose parts are gone. */
    dragmesh_unreal::openable_parts none;
    for (const std::size_t index : {std::size_t(0), std::size_t(4), std::size_t(-1)}) {
        dragmesh_unreal::openable_parts& of = index == 0 ? none : cabinet;
        must(!of.grab(index, now) && !of.move(index, DM_GO_OPEN), "a part that is not there is not moved");
        of.pull(index, ray, frame);
        of.release(index);
        of.restore(index, saved);
        must(of.info(index).id == 0 && of.state(index).value == 0, "nothing is told of it");
        must(distance(of.at(index).translation, {0, 0, 0}) == 0, "it stays at rest");
    }
    *context = {}; /* before its parts */
    cabinet.pull(0, ray, frame);
    cabinet.release(0);
    cabinet.advance(frame);
    std::printf("Unreal: the engine-free part opens a door to %.2f\n", static_cast<double>(value));
    return 0;
}
