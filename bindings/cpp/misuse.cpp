/* What a host may do wrong with dragmesh.hpp: a result that says so, and the context goes on. OBJECT.dmo */
#include "dragmesh/dragmesh.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

namespace {

int checks = 0;

void must(bool holds, const char* what) {
    checks++;
    if (holds) return;
    std::fprintf(stderr, "misuse: %s\n", what);
    std::exit(1);
}

template <class T> void fails(const dragmesh::result<T>& got, dm_result code, const char* what) {
    must(!got && got.error() == code, (std::string(what) + ": " + got.what()).c_str());
}

dm_drag_desc without_point(std::uint32_t part) {
    dm_drag_desc desc = dm_drag_desc_default();
    desc.part_id = part, desc.flags = DM_DRAG_WITHOUT_POINT;
    return desc;
}

/* One that any owner's context must still do. */
void works(const dragmesh::object& object) {
    auto drag = object.grab(without_point(object.part(0)->id));
    must(drag && drag->update_input(dm_drag_input_default(), 0.01f), "the context after misuse");
}

void empty_owners() {
    dragmesh::context context;
    dragmesh::object object;
    dragmesh::drag drag;
    dragmesh::motion motion;
    dragmesh::scene scene;
    const std::array<std::uint8_t, 1> byte = {};
    fails(context.load_object(byte), DM_ERROR_INVALID_ARGUMENT, "an empty context");
    fails(context.memory(), DM_ERROR_INVALID_ARGUMENT, "the memory of an empty context");
    fails(object.info(), DM_ERROR_INVALID_ARGUMENT, "an empty object");
    fails(object.save(), DM_ERROR_INVALID_ARGUMENT, "saving an empty object");
    fails(object.hypotheses(1), DM_ERROR_INVALID_ARGUMENT, "hypotheses of an empty object");
    fails(object.grab(without_point(1)), DM_ERROR_INVALID_ARGUMENT, "grabbing an empty object");
    fails(drag.update(0.01f), DM_ERROR_INVALID_ARGUMENT, "an empty drag");
    fails(drag.end(), DM_ERROR_INVALID_ARGUMENT, "ending an empty drag");
    fails(motion.sample(0), DM_ERROR_INVALID_ARGUMENT, "an empty motion");
    fails(scene.add(object), DM_ERROR_INVALID_ARGUMENT, "an empty scene");
    must(!dragmesh::context::create({}), "a descriptor without a size");
}

/* A context that ends before what it made, and handles that are ended, moved and given away. */
void ends_in_any_order(dragmesh::span<const std::uint8_t> dmo) {
    dragmesh::drag drag;
    dragmesh::scene scene;
    dragmesh::object object;
    {
        auto context = dragmesh::context::create();
        object = std::move(*context->load_object(dmo));
        scene = std::move(*context->create_scene());
        drag = std::move(*object.grab(without_point(object.part(0)->id)));
        must(bool(scene.add(object)), "a placed object");
        *context = {};
        fails(context->memory(), DM_ERROR_INVALID_ARGUMENT, "a context that was given up");
    }
    must(drag.step(dm_drag_input_default(), 0.01f) && scene.commit(), "what outlives its context");
    works(object);
    dragmesh::object moved = std::move(object);
    object.reset();
    dragmesh::object& same = moved;
    moved = std::move(same);
    works(moved);
    auto context = dragmesh::context::create();
    fails(scene.add(*context->load_object(dmo)), DM_ERROR_STALE_HANDLE, "an object of another context");
    moved.reset();
    moved.reset();
    fails(moved.info(), DM_ERROR_STALE_HANDLE, "an ended object");
    fails(drag.step(dm_drag_input_default(), 0.01f), DM_ERROR_STALE_HANDLE, "a drag of an ended object");
    fails(drag.end(), DM_ERROR_STALE_HANDLE, "ending it");
    fails(drag.part_state(), DM_ERROR_STALE_HANDLE, "an ended drag");
    /* A context that the caller ends. */
    dm_context* own = nullptr;
    dm_object handle = 0;
    must(dm_context_create(nullptr, &own) == DM_OK && dm_object_load(own, dmo.data(), dmo.size(), 0, &handle) == DM_OK,
         "a context of C");
    works(dragmesh::object(own, handle));
    dm_context_destroy(own);
}

struct game {
    dragmesh::context context;
    dragmesh::object object;
};

/* Ends its context in the middle of a call. */
void DM_CALL give_up(void* user, std::int32_t level, dm_result code, const char* text) {
    (void)level, (void)code, (void)text;
    static_cast<game*>(user)->context = {};
}

void callbacks(dragmesh::span<const std::uint8_t> dmo) {
    game all;
    dm_context_desc desc = dm_context_desc_default();
    desc.log = {&all, give_up};
    all.context = std::move(*dragmesh::context::create(desc));
    fails(all.context.load_object({dmo.data(), 9}), DM_ERROR_BAD_DATA, "a log that gives its context up");
    must(!all.context, "it is given up");
}

void arguments(dragmesh::span<const std::uint8_t> dmo) {
    auto context = dragmesh::context::create();
    auto object = context->load_object(dmo);
    const std::uint32_t part = object->part(0)->id;
    auto drag = object->grab(without_point(part));
    std::vector<float> values(100);
    std::vector<std::uint8_t> held(99), saved(dragmesh::drag::snapshot_size());
    const std::vector<dm_link> links(1000);
    fails(context->load_object({}), DM_ERROR_INVALID_ARGUMENT, "no bytes");
    fails(context->load_model({}), DM_ERROR_INVALID_ARGUMENT, "no weights");
    fails(object->follow_links(part, values), DM_ERROR_INVALID_ARGUMENT, "too many values");
    fails(object->follow_links(part, values, held), DM_ERROR_INVALID_ARGUMENT, "too few held");
    fails(object->follow_links(part, {}), DM_ERROR_INVALID_ARGUMENT, "no values");
    fails(object->set_links(links), DM_ERROR_INVALID_ARGUMENT, "too many links");
    fails(object->set_links({nullptr, std::size_t(UINT32_MAX) + 2}), DM_ERROR_INVALID_ARGUMENT, "a count of 33 bits");
    fails(object->follow_links(part, {values.data(), std::size_t(UINT32_MAX) + 2}), DM_ERROR_INVALID_ARGUMENT,
          "values of 33 bits");
    fails(drag->save(held), DM_ERROR_BUFFER_TOO_SMALL, "a small buffer");
    must(!drag->restore(held) && !drag->restore({}), "a state that was not saved");
    must(drag->save(saved) && drag->restore(saved), "a state that was");
    const std::vector<float> positions(9);
    const std::vector<std::uint32_t> indices = {0, 1, 2}, parts = {0, 1};
    dm_object_desc desc = dm_object_desc_default();
    const dm_mesh_desc mesh = dragmesh::mesh<std::uint32_t, std::uint32_t>(positions, indices, parts);
    desc.mesh = &mesh;
    fails(context->prepare(desc), DM_ERROR_INVALID_ARGUMENT, "too few part ids");
    desc.mesh = nullptr;
    fails(context->prepare(desc), DM_ERROR_INVALID_ARGUMENT, "no mesh");
    for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        dm_joint joint = *object->joint(part);
        joint.axis = {wrong, 0, 0};
        fails(object->set_joint(part, joint), DM_ERROR_NOT_FINITE, "an axis");
        fails(drag->update({{wrong, 0, 0}, {0, 0, 1}}, 0.01f), DM_ERROR_NOT_FINITE, "a ray");
        fails(drag->update_input(dm_drag_input_default(), wrong), DM_ERROR_NOT_FINITE, "a time");
    }
    works(*object);
}

} // namespace

int main(int argc, char** argv) {
    must(argc == 2, "OBJECT.dmo");
    std::ifstream file(argv[1], std::ios::binary);
    const std::vector<std::uint8_t> dmo{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    empty_owners();
    ends_in_any_order(dmo);
    callbacks(dmo);
    arguments(dmo);
    std::printf("C++: %d misuses answered\n", checks);
    return 0;
}
