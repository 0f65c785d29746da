/* dragmesh for C++17: owners of handles, and results instead of output pointers. Header only; throws nothing itself.
 *
 * The plain structs are those of dragmesh.h. Every call that can fail returns a dragmesh::result: test it, or read its
 * error(). Owners are move-only and may end in any order: a context lives until the last of what it made has ended. A
 * call of an owner that is empty, moved from or ended answers DM_ERROR_INVALID_ARGUMENT or DM_ERROR_STALE_HANDLE.
 * Threading tags are those of dragmesh.h. */
#ifndef DRAGMESH_HPP
#define DRAGMESH_HPP

#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "dragmesh/dragmesh.h"

namespace dragmesh {

/* The name of a result, such as "DM_ERROR_EMPTY_MASK". */
inline const char* name(dm_result code) noexcept {
    return dm_result_string(code);
}

/* A value, or why there is none. */
template <class T> class result {
  public:
    result(T value) noexcept(std::is_nothrow_move_constructible<T>::value) : value_(std::move(value)) {
    }
    static result failed(dm_result code) {
        result out{T()};
        out.code_ = code;
        return out;
    }
    explicit operator bool() const noexcept {
        return code_ == DM_OK;
    }
    dm_result error() const noexcept {
        return code_;
    }
    const char* what() const noexcept {
        return name(code_);
    }
    /* The value; that of a failed call is empty. */
    T& operator*() & noexcept {
        return value_;
    }
    const T& operator*() const& noexcept {
        return value_;
    }
    T&& operator*() && noexcept {
        return std::move(value_);
    }
    T* operator->() noexcept {
        return &value_;
    }
    const T* operator->() const noexcept {
        return &value_;
    }
    T value_or(T other) && {
        return code_ == DM_OK ? std::move(value_) : std::move(other);
    }

  private:
    T value_;
    dm_result code_ = DM_OK;
};

/* A call that answers nothing but whether it worked. */
template <> class result<void> {
  public:
    result(dm_result code) noexcept : code_(code) {
    }
    explicit operator bool() const noexcept {
        return code_ == DM_OK;
    }
    dm_result error() const noexcept {
        return code_;
    }
    const char* what() const noexcept {
        return name(code_);
    }

  private:
    dm_result code_;
};

/* Numbers somewhere else; made from arrays, vectors and std::array by themselves. */
template <class T> class span {
  public:
    span() noexcept = default;
    span(T* data, std::size_t size) noexcept : data_(data), size_(size) {
    }
    template <std::size_t N> span(T (&array)[N]) noexcept : data_(array), size_(N) {
    }
    template <class C, class = decltype(static_cast<T*>(std::declval<C&>().data()))>
    span(C& container) noexcept : data_(container.data()), size_(container.size()) {
    }
    T* data() const noexcept {
        return data_;
    }
    std::size_t size() const noexcept {
        return size_;
    }
    std::size_t size_bytes() const noexcept {
        return size_ * sizeof(T);
    }

  private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

/* A handle that ends with its owner. */
template <class Handle, dm_result(DM_CALL* End)(dm_context*, Handle)> class owner {
  public:
    owner() noexcept = default;
    owner(std::shared_ptr<dm_context> context, Handle handle) noexcept : context_(std::move(context)), handle_(handle) {
    }
    /* Of a context that the caller ends, after this. */
    owner(dm_context* context, Handle handle) noexcept
        : context_(std::shared_ptr<dm_context>(), context), handle_(handle) {
    }
    owner(owner&& other) noexcept : context_(std::move(other.context_)), handle_(other.release()) {
    }
    owner& operator=(owner&& other) noexcept {
        if (this != &other) {
            reset();
            context_ = std::move(other.context_);
            handle_ = other.release();
        }
        return *this;
    }
    owner(const owner&) = delete;
    owner& operator=(const owner&) = delete;
    ~owner() {
        reset();
    }

    Handle get() const noexcept {
        return handle_;
    }
    explicit operator bool() const noexcept {
        return handle_ != 0;
    }
    /* Gives the handle away: the caller ends it. */
    Handle release() noexcept {
        return std::exchange(handle_, Handle(0));
    }
    void reset() noexcept {
        if (handle_ != 0) End(raw(), release());
    }

  protected:
    dm_context* raw() const noexcept {
        return context_.get();
    }
    std::shared_ptr<dm_context> context_;
    Handle handle_ = 0;
};

namespace detail {

inline dm_result DM_CALL end_drag(dm_context* context, dm_drag drag) {
    return dm_drag_end(context, drag, nullptr);
}

/* Runs a call that fills a value. */
template <class T, class Call> result<T> fill(T value, Call call) {
    const dm_result code = call(&value);
    return code == DM_OK ? result<T>(std::move(value)) : result<T>::failed(code);
}

/* Runs a call that makes a handle, and keeps its context meanwhile, whatever its callbacks do. */
template <class Owner, class Handle, class Call>
result<Owner> make(std::shared_ptr<dm_context> context, Handle handle, Call call) {
    const dm_result code = call(context.get(), &handle);
    return code == DM_OK ? result<Owner>(Owner(std::move(context), handle)) : result<Owner>::failed(code);
}

/* A number of elements; one that does not fit is beyond any that the library takes. */
inline std::uint32_t count_of(std::size_t size) noexcept {
    return size > UINT32_MAX ? UINT32_MAX : static_cast<std::uint32_t>(size);
}

} // namespace detail

/* ---- what a context makes ---- */

using model = owner<dm_model, dm_model_unload>;

class motion : public owner<dm_motion, dm_motion_destroy> {
  public:
    using owner::owner;
    /* The pose at t, 0 to 1. [frame] */
    result<dm_pose> sample(float t, float* out_value = nullptr) const {
        return detail::fill(dm_pose(),
                            [&](dm_pose* out) { return dm_motion_sample(raw(), handle_, t, out, out_value); });
    }
};

class drag : public owner<dm_drag, detail::end_drag> {
  public:
    using owner::owner;
    /* Follows the pointer. [frame] */
    result<dm_drag_state> update(const dm_ray& ray, float seconds) {
        return detail::fill(dm_drag_state_default(),
                            [&](dm_drag_state* out) { return dm_drag_update(raw(), handle_, &ray, seconds, out); });
    }
    /* Goes on after release(). [frame] */
    result<dm_drag_state> update(float seconds) {
        return detail::fill(dm_drag_state_default(),
                            [&](dm_drag_state* out) { return dm_drag_update(raw(), handle_, nullptr, seconds, out); });
    }
    /* Everything that can be told a drag at once. [frame] */
    result<dm_drag_state> update_input(const dm_drag_input& input, float seconds) {
        return detail::fill(dm_drag_state_default(), [&](dm_drag_state* out) {
            return dm_drag_update_input(raw(), handle_, &input, seconds, out);
        });
    }
    /* After an update_input with DM_INPUT_ASK: takes another value. [frame] */
    result<dm_drag_state> override_value(float value) {
        return detail::fill(dm_drag_state_default(),
                            [&](dm_drag_state* out) { return dm_drag_override(raw(), handle_, value, out); });
    }
    /* update_input and override_value, by their names in 0.2. [frame] */
    result<dm_drag_state> step(const dm_drag_input& input, float seconds) {
        return update_input(input, seconds);
    }
    result<dm_drag_state> take(float value) {
        return override_value(value);
    }
    result<dm_release_plan> let_go(const dm_release_desc& desc) {
        return detail::fill(dm_release_plan_default(),
                            [&](dm_release_plan* out) { return dm_drag_release(raw(), handle_, &desc, out); });
    }
    /* What the instance keeps: its joint, value and pose. */
    result<dm_part_state> part_state() const {
        return detail::fill(dm_part_state_default(),
                            [&](dm_part_state* out) { return dm_drag_get_part_state(raw(), handle_, out); });
    }
    /* Ends it, and hands over what the instance keeps. */
    result<dm_part_state> end() {
        return detail::fill(dm_part_state_default(),
                            [&](dm_part_state* out) { return dm_drag_end(raw(), release(), out); });
    }
    /* Bytes that save and restore take. */
    static std::size_t snapshot_size() noexcept {
        return dm_drag_snapshot_size();
    }
    result<void> save(span<std::uint8_t> buffer) const {
        return dm_drag_save(raw(), handle_, buffer.data(), buffer.size());
    }
    result<void> restore(span<const std::uint8_t> data) {
        return dm_drag_restore(raw(), handle_, data.data(), data.size());
    }
};

class object : public owner<dm_object, dm_object_destroy> {
  public:
    using owner::owner;
    result<dm_object_info> info() const {
        return detail::fill(dm_object_info_default(),
                            [&](dm_object_info* out) { return dm_object_get_info(raw(), handle_, out); });
    }
    result<dm_part_info> part(std::uint32_t index) const {
        return detail::fill(dm_part_info_default(),
                            [&](dm_part_info* out) { return dm_object_get_part(raw(), handle_, index, out); });
    }
    /* The joint in force. */
    result<dm_joint> joint(std::uint32_t part_id) const {
        return detail::fill(dm_joint_default(),
                            [&](dm_joint* out) { return dm_object_get_joint(raw(), handle_, part_id, out); });
    }
    /* All that were found, most probable first. hint: a drag that tells more, or nullptr. */
    result<std::vector<dm_joint>> hypotheses(std::uint32_t part_id, const dm_drag_hint* hint = nullptr) const {
        return detail::fill(
            std::vector<dm_joint>(DM_MAX_HYPOTHESES, dm_joint_default()), [&](std::vector<dm_joint>* out) {
                std::uint32_t count = 0;
                const dm_result code =
                    dm_object_get_hypotheses(raw(), handle_, part_id, hint, out->data(), DM_MAX_HYPOTHESES, &count);
                out->resize(code == DM_OK ? count : 0);
                return code;
            });
    }
    result<void> set_joint(std::uint32_t part_id, const dm_joint& joint) {
        return dm_object_set_joint(raw(), handle_, part_id, &joint);
    }
    result<void> reset_joint(std::uint32_t part_id) {
        return dm_object_reset_joint(raw(), handle_, part_id);
    }
    result<void> refine(std::uint32_t part_id, const dm_drag_hint& hint) {
        return dm_object_refine(raw(), handle_, part_id, &hint);
    }
    /* Links parts, in place of the links of before; none: unlinks them. */
    result<void> set_links(span<const dm_link> links) {
        return dm_object_set_links(raw(), handle_, links.data(), detail::count_of(links.size()));
    }
    /* Moves what is linked with a part. values: of one instance, one a part; held: as many, or none: 1 where a link
     * holds the part. [frame] */
    result<void> follow_links(std::uint32_t part_id, span<float> values, span<std::uint8_t> held = {}) const {
        if (held.size() != 0 && held.size() != values.size()) return DM_ERROR_INVALID_ARGUMENT;
        return dm_object_follow_links(raw(), handle_, part_id, values.data(), held.data(),
                                      detail::count_of(values.size()));
    }
    /* The bytes of a .dmo. */
    result<std::vector<std::uint8_t>> save() const {
        return detail::fill(std::vector<std::uint8_t>(), [&](std::vector<std::uint8_t>* out) {
            std::size_t size = 0;
            dm_result code = dm_object_save(raw(), handle_, nullptr, 0, &size);
            if (code != DM_OK) return code;
            out->resize(size);
            return dm_object_save(raw(), handle_, out->data(), out->size(), &size);
        });
    }
    /* Grabs a part: desc.object is filled in. */
    result<drag> grab(dm_drag_desc desc) const {
        desc.object = handle_;
        return detail::make<drag>(context_, dm_drag(0), [&](dm_context* context, dm_drag* out) {
            return dm_drag_begin(context, &desc, out);
        });
    }
    result<motion> generate_motion(const dm_motion_desc& desc) const {
        return detail::make<motion>(context_, dm_motion(0), [&](dm_context* context, dm_motion* out) {
            return dm_motion_generate(context, handle_, &desc, out);
        });
    }
};

class scene : public owner<dm_scene, dm_scene_destroy> {
  public:
    using owner::owner;
    /* Places an object and returns its instance. */
    result<std::uint32_t> add(const object& placed, const dm_pose* placement = nullptr) {
        return detail::fill(std::uint32_t(0), [&](std::uint32_t* out) {
            return dm_scene_add(raw(), handle_, placed.get(), placement, out);
        });
    }
    /* Moves a part, or with part 0 the instance. [frame] */
    result<void> move(std::uint32_t instance, std::uint32_t part_id, const dm_pose& pose) {
        return dm_scene_move(raw(), handle_, instance, part_id, &pose);
    }
    result<void> remove(std::uint32_t instance) {
        return dm_scene_remove(raw(), handle_, instance);
    }
    result<void> commit() {
        return dm_scene_commit(raw(), handle_);
    }
    /* The nearest hit; its object is 0 when nothing is hit. [frame] */
    result<dm_hit> pick(const dm_ray& ray) const {
        return detail::fill(dm_hit_default(), [&](dm_hit* out) { return dm_scene_pick(raw(), handle_, &ray, out); });
    }
};

/* ---- the context ---- */

/* The bytes of the weight files; empty ones are absent. */
struct weights {
    span<const std::uint8_t> kinematics, motion, ranker;
};

class context {
  public:
    static result<context> create(const dm_context_desc& desc = dm_context_desc_default()) {
        dm_context* made = nullptr;
        const dm_result code = dm_context_create(&desc, &made);
        return code == DM_OK ? result<context>(context(made)) : result<context>::failed(code);
    }
    context() noexcept = default;
    context(context&&) noexcept = default;
    context& operator=(context&&) noexcept = default;
    context(const context&) = delete;
    context& operator=(const context&) = delete;

    dm_context* get() const noexcept {
        return context_.get();
    }
    explicit operator bool() const noexcept {
        return context_ != nullptr;
    }

    result<model> load_model(const weights& from) {
        dm_model_desc desc = dm_model_desc_default();
        desc.kinematics = from.kinematics.data(), desc.kinematics_size = from.kinematics.size();
        desc.motion = from.motion.data(), desc.motion_size = from.motion.size();
        desc.ranker = from.ranker.data(), desc.ranker_size = from.ranker.size();
        return detail::make<model>(context_, dm_model(0), [&](dm_context* context, dm_model* out) {
            return dm_model_load(context, &desc, out);
        });
    }
    /* Finds out how each part moves. */
    result<object> prepare(const dm_object_desc& desc) {
        return detail::make<object>(context_, dm_object(0), [&](dm_context* context, dm_object* out) {
            return dm_object_prepare(context, &desc, out);
        });
    }
    /* Reads a .dmo. */
    result<object> load_object(span<const std::uint8_t> data, const model& from = model()) {
        return detail::make<object>(context_, dm_object(0), [&](dm_context* context, dm_object* out) {
            return dm_object_load(context, data.data(), data.size(), from.get(), out);
        });
    }
    result<scene> create_scene() {
        const dm_scene_desc desc = dm_scene_desc_default();
        return detail::make<scene>(context_, dm_scene(0), [&](dm_context* context, dm_scene* out) {
            return dm_scene_create(context, &desc, out);
        });
    }
    /* The ray through a pixel, (0, 0) the top left corner. [frame] */
    result<dm_ray> camera_ray(const dm_camera& camera, float x, float y) const {
        return detail::fill(dm_ray(), [&](dm_ray* out) { return dm_camera_ray(get(), &camera, x, y, out); });
    }
    result<dm_memory_info> memory() const {
        return detail::fill(dm_memory_info_default(),
                            [&](dm_memory_info* out) { return dm_context_get_memory(get(), out); });
    }

  private:
    explicit context(dm_context* made) : context_(made, dm_context_destroy) {
    }
    std::shared_ptr<dm_context> context_;
};

/* ---- meshes ---- */

/* Describes arrays of triangles: positions x, y, z; indices; and the part of each vertex, 0 the body. Borrowed. */
template <class Index, class Part>
dm_mesh_desc mesh(span<const float> positions, span<const Index> indices, span<const Part> vertex_parts) {
    static_assert(std::is_unsigned<Index>::value && sizeof(Index) <= 4, "indices are uint8_t, uint16_t or uint32_t");
    static_assert(std::is_unsigned<Part>::value && sizeof(Part) <= 4, "parts are uint8_t, uint16_t or uint32_t");
    dm_mesh_desc desc = dm_mesh_desc_default();
    desc.positions = positions.data();
    desc.vertex_count = positions.size() / 3;
    desc.position_bytes = positions.size_bytes();
    desc.indices = indices.data();
    desc.index_count = indices.size();
    desc.index_bytes = indices.size_bytes();
    desc.index_format = sizeof(Index) == 4 ? DM_UINT32 : sizeof(Index) == 2 ? DM_UINT16 : DM_UINT8;
    desc.part_ids = vertex_parts.data();
    desc.part_id_bytes = vertex_parts.size_bytes();
    desc.part_id_format = sizeof(Part) == 4 ? DM_UINT32 : sizeof(Part) == 2 ? DM_UINT16 : DM_UINT8;
    return desc;
}

/* ---- poses ---- */

/* a after b. [frame] */
inline dm_pose multiply(const dm_pose& a, const dm_pose& b) noexcept {
    dm_pose out;
    dm_pose_multiply(&a, &b, &out);
    return out;
}

/* [frame] */
inline dm_vec3 apply(const dm_pose& pose, dm_vec3 point) noexcept {
    dm_pose_apply_points(&pose, &point.x, 0, &point.x, 0, 1);
    return point;
}

} // namespace dragmesh

#endif
