/* The parts of one openable thing in Unreal's frame (left-handed, z up, centimetres), without the engine: which part is
 * held, where each one stands, and what of it is saved. OpenableComponent.h moves components by it. */
#ifndef DRAGMESH_UNREAL_OPENABLE_PARTS_H
#define DRAGMESH_UNREAL_OPENABLE_PARTS_H

#include <cstdint>
#include <utility>
#include <vector>

#include "dragmesh/dragmesh.hpp"

namespace dragmesh_unreal {

/* The context of a game. */
inline dragmesh::result<dragmesh::context> create_context(dm_log log = {}) {
    constexpr float centimetre = 0.01f;
    dm_context_desc desc = dm_context_desc_default();
    desc.axes = DM_AXES_UNREAL, desc.unit_in_metres = centimetre, desc.log = log;
    return dragmesh::context::create(desc);
}

/* A rigid motion as FTransform takes it: FQuat(X, Y, Z, W) and FVector. */
struct placement {
    float rotation[4];
    dm_vec3 translation;
};

inline placement placement_of(const dm_pose& pose) {
    return {{pose.real[0], pose.real[1], pose.real[2], pose.real[3]}, dragmesh::apply(pose, {0, 0, 0})};
}

class openable_parts {
  public:
    /* Reads the bytes of a .dmo. */
    static dragmesh::result<openable_parts> load(dragmesh::context& context, dragmesh::span<const std::uint8_t> dmo) {
        auto object = context.load_object(dmo);
        openable_parts out;
        if (!object) return dragmesh::result<openable_parts>::failed(object.error());
        out.object_ = std::move(*object);
        const std::uint32_t count = out.object_.info()->part_count;
        for (std::uint32_t i = 0; i < count; i++) {
            part p;
            p.info = *out.object_.part(i);
            p.state = dm_part_state_default();
            p.state.joint = *out.object_.joint(p.info.id);
            dm_joint_pose(&p.state.joint, 0, &p.state.pose);
            out.parts_.push_back(std::move(p));
        }
        return out;
    }

    std::size_t count() const {
        return parts_.size();
    }
    /* Indexes go from 0 to count() - 1. Of others there is nothing to tell, and nothing to do. */
    dm_part_info info(std::size_t index) const {
        return index < parts_.size() ? parts_[index].info : dm_part_info_default();
    }
    /* The joint in force and where the part stands: to be saved and replicated as numbers. */
    dm_part_state state(std::size_t index) const {
        return index < parts_.size() ? parts_[index].state : dm_part_state_default();
    }

    /* Puts a part where it was saved, or where a server says it is; ends its drag. */
    void restore(std::size_t index, const dm_part_state& state) {
        if (index >= parts_.size()) return;
        part& p = parts_[index];
        p.drag.reset();
        p.held = false;
        p.state = state;
        p.state.struct_size = sizeof p.state;
        dm_joint_pose(&state.joint, state.value, &p.state.pose);
    }

    /* Grabs a part at a point of the object's frame, where the part is now; false: it can not be grabbed there. */
    bool grab(std::size_t index, dm_vec3 point) {
        if (index >= parts_.size()) return false;
        dm_pose back = carrier(index);
        dm_pose_inverse(&back, &back);
        return begin(index, dragmesh::apply(back, point), 0);
    }
    /* The grabbed point of a held part follows a ray of the object's frame; every frame, with its seconds. */
    void pull(std::size_t index, const dm_ray& ray, float seconds) {
        if (!is_held(index)) return;
        part& p = parts_[index];
        dm_pose back = carrier(index);
        dm_pose_inverse(&back, &back);
        const dm_vec3 from = dragmesh::apply(back, ray.origin);
        const dm_vec3 to = dragmesh::apply(
            back, {ray.origin.x + ray.direction.x, ray.origin.y + ray.direction.y, ray.origin.z + ray.direction.z});
        take(p, p.drag.update({from, {to.x - from.x, to.y - from.y, to.z - from.z}}, seconds));
    }
    /* Lets go. The part then moves on by itself, in advance(). */
    void release(std::size_t index, std::int32_t intent = DM_GO_AUTO) {
        if (!is_held(index)) return;
        part& p = parts_[index];
        dm_release_desc desc = dm_release_desc_default();
        desc.intent = intent, desc.flags = DM_RELEASE_BY_RULE; /* the same on every machine, without weights */
        p.held = false;
        p.drag.let_go(desc);
    }
    /* Opens or closes a part without a player. */
    bool move(std::size_t index, std::int32_t intent) {
        if (index >= parts_.size() || is_held(index) || !begin(index, {0, 0, 0}, DM_DRAG_WITHOUT_POINT)) return false;
        release(index, intent);
        return true;
    }
    /* Moves released parts on; once a frame. */
    void advance(float seconds) {
        for (part& p : parts_)
            if (p.drag && !p.held) take(p, p.drag.update(seconds));
    }

    /* The part from rest, with what carries it: the transform of its component relative to that at rest. */
    placement at(std::size_t index) const {
        if (index >= parts_.size()) return {{0, 0, 0, 1}, {0, 0, 0}};
        dm_pose pose = carrier(index);
        dm_pose_multiply(&pose, &parts_[index].state.pose, &pose);
        return placement_of(pose);
    }

  private:
    struct part {
        dm_part_info info;
        dm_part_state state;
        dragmesh::drag drag; /* empty at rest */
        bool held = false;
    };

    bool is_held(std::size_t index) const {
        return index < parts_.size() && parts_[index].held;
    }

    bool begin(std::size_t index, dm_vec3 point, std::uint32_t flags) {
        part& p = parts_[index];
        if (p.held) return false;
        p.drag.reset();
        dm_drag_desc desc = dm_drag_desc_default();
        desc.part_id = p.info.id, desc.grab_point = point, desc.state = &p.state, desc.flags = flags;
        auto drag = object_.grab(desc);
        if (!drag) return false;
        p.drag = std::move(*drag);
        p.held = true;
        return true;
    }

    /* Keeps what an update has answered; ends the drag of a part that has come to rest. */
    static void take(part& p, const dragmesh::result<dm_drag_state>& now) {
        const auto kept = p.drag.part_state();
        if (now && kept) p.state = *kept;
        if (!now || now->phase == DM_DRAG_AT_REST) p.drag.reset();
    }

    /* The pose of what carries a part. */
    dm_pose carrier(std::size_t index) const {
        for (std::size_t i = 0; i < parts_.size(); i++) {
            if (parts_[i].info.id != parts_[index].info.parent) continue;
            dm_pose pose = carrier(i);
            dm_pose_multiply(&pose, &parts_[i].state.pose, &pose);
            return pose;
        }
        return {{0, 0, 0, 1}, {0, 0, 0, 0}};
    }

    dragmesh::object object_;
    std::vector<part> parts_;
};

} // namespace dragmesh_unreal

#endif
