/* The common scenario through dragmesh.hpp: prints what bindings/scenario/scenario.c prints. */
#include "dragmesh/dragmesh.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

namespace {

constexpr int frames = 60, shown_every = 10, saved_at = 30, released_frames = 120, handle_turns_at = 25;
constexpr float frame_time = 1.0f / 60;
constexpr float handle_turn = 1, widest = 0.45f;     /* rad */
constexpr std::array<float, 2> snaps = {0.2f, 0.4f}; /* rad */
constexpr std::uint32_t door = 1, drawer = 2;
const dm_ray first_ray = {{0.9f, 0.9f, 2.0f}, {-0.35f, -0.45f, -1.55f}};

/* From x, y, z to x, y, z, and the part: samples/common/cabinet.h. */
constexpr int boxes = 13;
const float cabinet[boxes][7] = {
    {0.00f, 0.00f, 0.000f, 0.60f, 0.02f, 0.40f, 0},       {0.00f, 0.98f, 0.000f, 0.60f, 1.00f, 0.42f, 0},
    {0.00f, 0.02f, 0.000f, 0.02f, 0.98f, 0.40f, 0},       {0.58f, 0.02f, 0.000f, 0.60f, 0.98f, 0.40f, 0},
    {0.02f, 0.02f, 0.000f, 0.58f, 0.98f, 0.02f, 0},       {0.00f, 0.00f, 0.402f, 0.60f, 0.79f, 0.42f, door},
    {0.54f, 0.35f, 0.420f, 0.56f, 0.55f, 0.45f, door},    {0.00f, 0.80f, 0.402f, 0.60f, 0.97f, 0.42f, drawer},
    {0.25f, 0.87f, 0.420f, 0.35f, 0.89f, 0.45f, drawer},  {0.04f, 0.82f, 0.030f, 0.56f, 0.83f, 0.402f, drawer},
    {0.04f, 0.83f, 0.030f, 0.05f, 0.95f, 0.402f, drawer}, {0.55f, 0.83f, 0.030f, 0.56f, 0.95f, 0.402f, drawer},
    {0.05f, 0.83f, 0.030f, 0.55f, 0.95f, 0.040f, drawer},
};
const std::uint16_t corners[36] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                   2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};

struct arrays {
    std::vector<float> positions;
    std::vector<std::uint16_t> indices;
    std::vector<std::uint8_t> parts;
};

arrays make_cabinet() {
    arrays out;
    for (int v = 0; v < boxes * 8; v++) {
        for (int k = 0; k < 3; k++) out.positions.push_back(cabinet[v / 8][(v >> k) & 1 ? k + 3 : k]);
        out.parts.push_back(static_cast<std::uint8_t>(cabinet[v / 8][6]));
    }
    for (int i = 0; i < boxes * 36; i++)
        out.indices.push_back(static_cast<std::uint16_t>(i / 36 * 8 + corners[i % 36]));
    return out;
}

/* Ends the program where a call has failed, and else gives its value. */
template <class T> T must(dragmesh::result<T> got, const char* what) {
    if (!got) {
        std::printf("%s: %s\n", what, got.what());
        std::exit(1);
    }
    return std::move(*got);
}

void must(dragmesh::result<void> got, const char* what) {
    if (got) return;
    std::printf("%s: %s\n", what, got.what());
    std::exit(1);
}

void print_floats(const char* label, const float* values, int count) {
    std::printf("%s", label);
    for (int i = 0; i < count; i++) {
        std::uint32_t bits;
        std::memcpy(&bits, &values[i], sizeof bits);
        std::printf(" %08x", bits);
    }
    std::printf("\n");
}

void print_joint(const dm_joint& j) {
    const float numbers[] = {j.axis.x,   j.axis.y, j.axis.z, j.origin.x,        j.origin.y,
                             j.origin.z, j.lower,  j.upper,  j.type_confidence, j.joint_confidence};
    std::printf("joint %d source %d\n", j.type, j.source);
    print_floats(" ", numbers, 10);
}

void print_state(const char* label, const dm_drag_state& s) {
    const float numbers[] = {s.value, s.joint_confidence};
    std::printf("%s phase %d events %u changes %u basis %d\n", label, s.phase, s.events, s.changes, s.joint_basis);
    print_floats(" ", numbers, 2);
    print_floats(" ", s.pose.real, 4);
    print_floats(" ", s.pose.dual, 4);
}

dm_ray ray_at(int frame) {
    dm_ray ray = first_ray;
    ray.direction.x -= 0.01f * static_cast<float>(frame);
    ray.direction.z += 0.005f * static_cast<float>(frame);
    return ray;
}

std::vector<std::uint8_t> read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

dragmesh::model load_weights(dragmesh::context& context, const std::string& folder) {
    const auto kpp = read_file(folder + "/kpp_net.safetensors"), vae = read_file(folder + "/dq_vae.safetensors"),
               ranker = read_file(folder + "/ranker.safetensors");
    return must(context.load_model({kpp, vae, ranker}), "weights");
}

void print_hypotheses(const dragmesh::object& object, std::uint32_t part) {
    const auto joint = must(object.joint(part), "joint");
    const auto all = must(object.hypotheses(part), "hypotheses");
    std::printf("part %u hypotheses %zu\n", part, all.size());
    print_joint(joint);
    for (const dm_joint& j : all) print_joint(j);
}

dm_hit pick(dragmesh::context& context, const dragmesh::object& object) {
    auto scene = must(context.create_scene(), "scene");
    must(scene.add(object), "add");
    must(scene.commit(), "commit");
    const auto hit = must(scene.pick(first_ray), "pick");
    std::printf("picked part %u triangle %u\n", hit.part_id, hit.triangle);
    print_floats(" ", &hit.object_point.x, 3);
    return hit;
}

void drag_and_release(const dragmesh::object& object, const dm_hit& hit) {
    const dm_drag_rules rules = dm_drag_rules_default();
    dm_drag_desc desc = dm_drag_desc_default();
    desc.part_id = hit.part_id, desc.grab_point = hit.object_point, desc.rules = &rules;
    auto drag = must(object.grab(desc), "begin");
    std::vector<std::uint8_t> saved(dragmesh::drag::snapshot_size());
    std::uint32_t events = 0;
    for (int frame = 0; frame < frames; frame++) {
        const auto state = must(drag.update(ray_at(frame), frame_time), "update");
        events |= state.events;
        if (frame % shown_every == 0) print_state("frame", state);
        if (frame == saved_at) must(drag.save(saved), "save");
    }
    must(drag.restore(saved), "restore");
    auto state = must(drag.update(ray_at(frames), frame_time), "update");
    print_state("restored", state);
    dm_release_desc release = dm_release_desc_default();
    release.intent = DM_GO_OPEN, release.flags = DM_RELEASE_BY_RULE;
    const auto plan = must(drag.let_go(release), "release");
    print_floats("plan", &plan.end_value, 1);
    for (int frame = 0; frame < released_frames; frame++) {
        state = must(drag.update(frame_time), "released");
        events |= state.events;
    }
    state.events = events;
    print_state("released", state);
    auto end = must(drag.end(), "end");
    desc.grab_point = state.grab_point, desc.state = &end;
    auto again = must(object.grab(desc), "begin again");
    const auto last = must(again.end(), "end again");
    print_floats("again", &last.value, 1);
    print_floats(" ", last.pose.real, 4);
    print_floats(" ", last.pose.dual, 4);
    const std::uint32_t* words = last.joint.evidence;
    std::printf("evidence %u %u %u %u\n", words[0], words[1], words[2], words[3]);
}

void drag_behind_latch(const dragmesh::object& object, const dm_hit& hit) {
    dm_drag_rules rules = dm_drag_rules_default();
    dm_drag_desc desc = dm_drag_desc_default();
    dm_drag_input input = dm_drag_input_default();
    dm_drag_state state = dm_drag_state_default();
    rules.flags = DM_RULE_LATCH, rules.snaps = snaps.data(), rules.snap_count = 2;
    desc.part_id = hit.part_id, desc.grab_point = hit.object_point, desc.rules = &rules;
    auto drag = must(object.grab(desc), "begin");
    input.flags = DM_INPUT_ASK, input.hand.kind = DM_HAND_RAY;
    std::uint32_t events = 0, detents = 0;
    for (int frame = 0; frame < frames; frame++) {
        input.hand.ray = ray_at(frame);
        input.handles[0] = frame < handle_turns_at ? 0 : handle_turn;
        state = must(drag.update_input(input, frame_time), "update");
        if (state.value > widest) state = must(drag.override_value(widest), "override");
        events |= state.events, detents += state.detents;
        if (frame % shown_every == 0) print_state("latch", state);
    }
    state.events = events;
    print_state("latched", state);
    std::printf("detents %u\n", detents);
}

dm_link link(std::uint32_t driver, std::uint32_t driven, std::int32_t kind, float from) {
    dm_link out = {};
    out.driver = driver, out.driven = driven, out.kind = kind, out.from = from;
    return out;
}

void follow_links(dragmesh::object& object) {
    std::array<dm_link, 2> links = {link(door, drawer, DM_LINK_MOVES, 0.1f), link(drawer, door, DM_LINK_HOLDS, 0.05f)};
    links[0].ratio = 0.25f;
    std::array<float, 2> values = {-0.9f, 0};
    std::array<std::uint8_t, 2> held = {};
    must(object.set_links(links), "links");
    for (int i = 0; i < 2; i++) {
        must(object.follow_links(door, values, held), "follow");
        print_floats("linked", values.data(), 2);
        std::printf("held %u %u\n", held[0], held[1]);
        values[0] = 0.9f;
    }
}

void save_and_load(dragmesh::context& context, const dragmesh::object& object) {
    const auto data = must(object.save(), "save");
    std::uint32_t hash = 2166136261u; /* FNV-1a */
    for (const std::uint8_t byte : data) hash = (hash ^ byte) * 16777619u;
    std::printf("saved %zu bytes %08x\n", data.size(), hash);
    const auto again = must(context.load_object(data), "load");
    print_joint(must(again.joint(door), "joint"));
}

} // namespace

int main(int argc, char** argv) {
    auto context = must(dragmesh::context::create(), "context");
    const auto model = load_weights(context, argc > 1 ? argv[1] : "sdk/models");
    const arrays cabinet_arrays = make_cabinet();
    dm_mesh_desc mesh = dragmesh::mesh<std::uint16_t, std::uint8_t>(cabinet_arrays.positions, cabinet_arrays.indices,
                                                                    cabinet_arrays.parts);
    std::array<dm_part_desc, 2> parts = {dm_part_desc_default(), dm_part_desc_default()};
    parts[0].id = door, parts[0].label = "kitchen/cabinet/door";
    parts[1].id = drawer, parts[1].label = "kitchen/cabinet/drawer";
    dm_object_desc desc = dm_object_desc_default();
    desc.mesh = &mesh, desc.parts = parts.data(), desc.part_count = 2, desc.model = model.get();
    {
        auto object = must(context.prepare(desc), "prepare");
        print_hypotheses(object, door);
        print_hypotheses(object, drawer);
        const dm_hit hit = pick(context, object);
        drag_and_release(object, hit);
        drag_behind_latch(object, hit);
        follow_links(object);
        save_and_load(context, object);
    }
    mesh.index_count = 3 * 12; /* one box, without any part */
    dm_object_desc broken = dm_object_desc_default();
    broken.mesh = &mesh;
    std::printf("error %s\n", context.prepare(broken).what());
    return 0;
}
