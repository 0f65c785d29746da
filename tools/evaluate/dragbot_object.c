/* Parts of an object for the scripted player: which faces are whose, and what it takes to drag them. */
#include <stdlib.h>
#include <string.h>

#include "dragbot_object.h"
#include "eval_hints.h"

/* ---- parts ---- */

static bool has_name(const name_list* list, const char* name) {
    for (unsigned i = 0; i < list->count; i++)
        if (strcmp(list->names[i], name) == 0) return true;
    return false;
}

static bool includes(const name_list* outer, const name_list* inner) {
    for (unsigned i = 0; i < inner->count; i++)
        if (!has_name(outer, inner->names[i])) return false;
    return true;
}

/* Joints of the same nodes share a part; ids from 1 on. */
static void number_parts(bot_object* s) {
    const known_joint* joints = s->known.joints;
    for (int i = 0; i < s->known.joint_count; i++) {
        for (int k = 0; k < i && !s->part_of_joint[i]; k++) {
            const int same =
                includes(&joints[i].moving, &joints[k].moving) && includes(&joints[k].moving, &joints[i].moving);
            if (same) s->part_of_joint[i] = s->part_of_joint[k];
        }
        if (!s->part_of_joint[i] && s->part_count < BOT_MAX_PARTS) s->part_of_joint[i] = ++s->part_count;
    }
}

/* Returns the joint whose part carries a joint's part: the smallest that holds all its nodes; -1: the body. */
static int carrier_of(const bot_object* s, int joint) {
    const known_joint* joints = s->known.joints;
    int best = -1;
    for (int i = 0; i < s->known.joint_count; i++) {
        if (s->part_of_joint[i] == s->part_of_joint[joint]) continue;
        if (!includes(&joints[i].moving, &joints[joint].moving)) continue;
        if (best < 0 || joints[i].moving.count < joints[best].moving.count) best = i;
    }
    return best;
}

/* Larger parts first, so that what they carry is marked over them. */
static dm_result mark_faces(bot_object* s) {
    const uint64_t faces = s->session->mesh.index_count / 3;
    unsigned most = 0;
    for (int i = 0; i < s->known.joint_count; i++)
        most = s->known.joints[i].moving.count > most ? s->known.joints[i].moving.count : most;
    for (unsigned count = most; count > 0; count--) {
        for (int i = 0; i < s->known.joint_count; i++) {
            const name_list* moving = &s->known.joints[i].moving;
            if (moving->count != count || !s->part_of_joint[i]) continue;
            const dm_result result = dm_gltf_mark_faces(s->session->gltf, (const char* const*)moving->names, count,
                                                        (uint8_t)s->part_of_joint[i], s->face_parts, faces);
            if (result != DM_OK) return result;
        }
    }
    return DM_OK;
}

static void drop_faceless_parts(bot_object* s) {
    const uint64_t faces = s->session->mesh.index_count / 3;
    uint64_t own[BOT_MAX_PARTS + 1] = {0};
    for (uint64_t i = 0; i < faces; i++) own[s->face_parts[i]]++;
    for (int i = 0; i < s->known.joint_count; i++)
        if (!own[s->part_of_joint[i]]) s->part_of_joint[i] = 0;
}

/* Enters what the dataset has of a joint. pivot: room for it. */
static void enter_hints(const bot_object* s, const known_joint* joint, dm_pivot* pivot, dm_part_desc* part) {
    if (s->hints & HINTS_NAMES && joint->label[0] != 0) part->label = joint->label;
    if (!(s->hints & HINTS_PIVOTS) || !joint->has_pivot) return;
    *pivot = eval_hints_pivot(joint->pivot, joint->pivot_axes);
    part->pivot = pivot;
}

static dm_result prepare(bot_object* s) {
    dm_part_desc parts[BOT_MAX_PARTS];
    dm_pivot pivots[BOT_MAX_PARTS];
    uint8_t known[BOT_MAX_PARTS + 1] = {0};
    uint32_t count = 0;
    for (int i = 0; i < s->known.joint_count; i++) {
        const uint32_t id = s->part_of_joint[i];
        if (!id || known[id]) continue;
        const int carrier = carrier_of(s, i);
        known[id] = 1;
        parts[count] = (dm_part_desc){
            .struct_size = sizeof parts[0], .id = id, .parent = carrier < 0 ? 0 : s->part_of_joint[carrier]};
        enter_hints(s, &s->known.joints[i], &pivots[count], &parts[count]);
        count++;
    }
    dm_mesh_desc mesh = s->session->mesh;
    mesh.part_ids = s->face_parts;
    mesh.part_id_bytes = mesh.index_count / 3;
    mesh.part_id_format = DM_UINT8;
    mesh.part_id_scope = DM_PER_FACE;
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .mesh = &mesh,
                                 .parts = parts,
                                 .part_count = count,
                                 .model = s->session->model,
                                 .up = vec_out(s->told_up)};
    session_release_object(s->session);
    return dm_object_prepare(s->session->context, &desc, &s->session->object);
}

/* ---- setup ---- */

static void make_room(bot_object* s) {
    s->face_parts = cli_alloc_zeroed(s->session->mesh.index_count / 3);
    s->part_of_joint = cli_alloc_zeroed((size_t)s->known.joint_count * sizeof *s->part_of_joint);
}

/* Prepares the parts that have numbers and places the object. */
static dm_result set_up(bot_object* s) {
    const dm_scene_desc scene = {.struct_size = sizeof scene};
    uint32_t instance;
    dm_result result = mark_faces(s);
    if (result != DM_OK) return result;
    drop_faceless_parts(s);
    result = prepare(s);
    if (result == DM_OK) result = dm_scene_create(s->session->context, &scene, &s->scene);
    if (result == DM_OK) result = dm_scene_add(s->session->context, s->scene, s->session->object, NULL, &instance);
    if (result == DM_OK) result = dm_scene_commit(s->session->context, s->scene);
    dm_object_info info = {.struct_size = sizeof info};
    if (result == DM_OK) result = dm_object_get_info(s->session->context, s->session->object, &info);
    if (result != DM_OK) return result;
    s->centre = scale(add(vec_of(info.box_min), vec_of(info.box_max)), 0.5);
    s->radius = 0.5 * length(sub(vec_of(info.box_max), vec_of(info.box_min)));
    s->size = (double)info.size;
    return DM_OK;
}

dm_result bot_object_set_up(bot_object* s) {
    make_room(s);
    number_parts(s);
    return set_up(s);
}

dm_result bot_object_set_up_alone(bot_object* s, int joint) {
    make_room(s);
    s->part_of_joint[joint] = s->part_count = 1;
    return set_up(s);
}

void bot_object_take_down(bot_object* s) {
    if (s->scene) dm_scene_destroy(s->session->context, s->scene);
    session_release_object(s->session);
    free(s->face_parts);
    free(s->part_of_joint);
}

/* ---- one part ---- */

enum { QUARTERS = 4 }; /* at which a part is looked at along its pull; by hand */

bool bot_object_owns(const bot_object* s, int joint, uint64_t face) {
    return s->face_parts[face] == s->part_of_joint[joint];
}

void bot_object_moving(const bot_object* s, int joint, bool out_moves[BOT_MAX_PARTS + 1]) {
    const known_joint* joints = s->known.joints;
    memset(out_moves, 0, (BOT_MAX_PARTS + 1) * sizeof *out_moves);
    for (int i = 0; i < s->known.joint_count; i++)
        if (s->part_of_joint[i] && includes(&joints[joint].moving, &joints[i].moving))
            out_moves[s->part_of_joint[i]] = true;
}

/* Moves the two extremes along a direction to `point` where it lies farther. */
static void widen(bot_part* part, int direction, vec along, vec point, bool first) {
    vec *low = &part->extremes[2 * (size_t)direction], *high = low + 1;
    if (first || dot(point, along) < dot(*low, along)) *low = point;
    if (first || dot(point, along) > dot(*high, along)) *high = point;
}

/* A box that grows. */
typedef struct bounds {
    vec low, high;
} bounds;

/* Takes in where a point is along its joint's whole pull: at quarters of it. */
static void sweep(bounds* b, const known_joint* truth, vec point, double asked) {
    for (int k = 0; k <= QUARTERS; k++) {
        const vec p = bot_true_move(truth, point, k * asked / QUARTERS);
        b->low = (vec){fmin(b->low.x, p.x), fmin(b->low.y, p.y), fmin(b->low.z, p.z)};
        b->high = (vec){fmax(b->high.x, p.x), fmax(b->high.y, p.y), fmax(b->high.z, p.z)};
    }
}

bot_part bot_object_part(const bot_object* s, int joint) {
    static const vec along[BOT_EXTREMES / 2] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},  {1, 1, 0},  {1, -1, 0},
                                                {1, 0, 1},  {1, 0, -1}, {0, 1, 1},  {0, 1, -1}, {1, 1, 1},
                                                {1, 1, -1}, {1, -1, 1}, {1, -1, -1}};
    const uint32_t* indices = s->session->mesh.indices;
    const known_joint* truth = &s->known.joints[joint];
    const double asked = bot_travel(truth, s->size);
    bounds swept = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    bot_part part = {.id = s->part_of_joint[joint], .object_size = s->size};
    vec sum = {0, 0, 0};
    double count = 0;
    for (uint64_t i = 0; i < s->session->mesh.index_count; i++) {
        if (!bot_object_owns(s, joint, i / 3)) continue;
        const vec point = vec_at((const float*)s->session->mesh.positions + 3 * (size_t)indices[i]);
        for (int k = 0; k < BOT_EXTREMES / 2; k++) widen(&part, k, along[k], point, count == 0);
        sweep(&swept, truth, point, asked);
        sum = add(sum, point), count++;
    }
    part.centre = scale(sum, 1 / count);
    part.swept_centre = scale(add(swept.low, swept.high), 0.5);
    part.swept_radius = 0.5 * length(sub(swept.high, swept.low));
    return part;
}

static vec corner_of(const bot_object* s, uint64_t index) {
    const uint32_t* indices = s->session->mesh.indices;
    return vec_at((const float*)s->session->mesh.positions + 3 * (size_t)indices[index]);
}

static double area_of(const bot_object* s, uint64_t face) {
    const vec a = corner_of(s, 3 * face);
    return 0.5 * length(cross(sub(corner_of(s, 3 * face + 1), a), sub(corner_of(s, 3 * face + 2), a)));
}

static vec point_on(const bot_object* s, uint64_t face, random_state* random) {
    const vec a = corner_of(s, 3 * face), b = corner_of(s, 3 * face + 1), c = corner_of(s, 3 * face + 2);
    const double root = sqrt(random_unit(random)), share = random_unit(random);
    return add(a, scale(add(scale(sub(b, a), 1 - share), scale(sub(c, a), share)), root));
}

void bot_object_sample(const bot_object* s, const bool parts[BOT_MAX_PARTS + 1], random_state* random, vec* out_points,
                       int count) {
    const uint64_t faces = s->session->mesh.index_count / 3;
    double area = 0, passed = 0;
    uint64_t last = 0;
    int done = 0;
    for (uint64_t i = 0; i < faces; i++)
        if (parts[s->face_parts[i]]) area += area_of(s, i), last = i;
    for (uint64_t i = 0; i < faces && done < count; i++) {
        if (!parts[s->face_parts[i]]) continue;
        passed += area_of(s, i);
        while (done < count && passed >= (done + 0.5) * area / count) out_points[done++] = point_on(s, i, random);
    }
    while (done < count) out_points[done++] = point_on(s, last, random); /* rounding */
    for (int i = count - 1; i > 0; i--) {
        const int k = (int)(random_u64(random) % (uint64_t)(i + 1));
        const vec swapped = out_points[i];
        out_points[i] = out_points[k], out_points[k] = swapped;
    }
}
