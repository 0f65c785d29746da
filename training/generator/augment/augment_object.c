/* Finishes an object after its category has drawn it: poses the parts at rest, and augments messy objects with the
 * defects of meshes that people make: surroundings, decoration, shells missing, doubled or shifted, uneven triangles,
 * any up axis, rotation and size. Whatever moves a part moves its joint with it. */
#include <string.h>

#include "core/build.h"

enum { MESSY_FACE_LIMIT = 20000 };

/* ---- boxes ---- */

bool dmg_boxes_meet(const dmg_bounds* a, const dmg_bounds* b) {
    return a->low.x < b->high.x && b->low.x < a->high.x && a->low.y < b->high.y && b->low.y < a->high.y &&
           a->low.z < b->high.z && b->low.z < a->high.z;
}

dmg_bounds dmg_whole_bounds(const dmg_builder* b) {
    dmg_bounds around = dmg_bounds_none();
    for (uint32_t i = 0; i < b->vertex_count; ++i) dmg_bounds_grow(&around, b->vertices[i]);
    return around;
}

float dmg_largest_side(const dmg_bounds* around) {
    dmg_vec size = v3_sub(around->high, around->low);
    return fmaxf(size.x, fmaxf(size.y, size.z));
}

/* ---- rest ---- */

/* Moves parts and joints to their rest values. Goes by id, so that a parent comes before what it carries. */
static void pose_parts(dmg_builder* b) {
    dmg_frame pose[DMG_PART_LIMIT + 1];
    pose[0] = dmg_frame_identity();
    for (uint32_t i = 0; i < b->part_count; ++i) {
        dmg_part* part = &b->parts[i];
        const dmg_frame* carrier = &pose[part->joint.parent];
        dmg_frame moved = dmg_joint_frame(&part->joint, part->rest);
        pose[i + 1] = dmg_frame_multiply(carrier, &moved);
        v3_to(dmg_frame_point(carrier, v3_from(part->joint.origin)), part->joint.origin);
        v3_to(v3_normalize(dmg_frame_vector(carrier, v3_from(part->joint.axis))), part->joint.axis);
    }
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        uint32_t part = b->pieces[p].part, end = dmg_piece_end(b, p);
        if (part == 0) continue;
        for (uint32_t v = b->pieces[p].first_vertex; v < end; ++v)
            b->vertices[v] = dmg_frame_point(&pose[part], b->vertices[v]);
    }
}

/* Returns the direction in which the part opens: away from the limit it rests at (within a tenth of the range), either
 * way at random from between. */
static int32_t opening_direction(dmg_builder* b, const dmg_joint* joint) {
    float range = joint->upper - joint->lower;
    if (joint->type == DM_JOINT_CONTINUOUS || range <= 0.0f) return (int32_t)dmg_sign(b);
    float at = -joint->lower / range;
    if (at > 0.9f) return -1;
    return at < 0.1f || dmg_chance(b, 0.5f) ? 1 : -1;
}

/* Makes limits relative to rest and sets the opening direction. */
static void settle_limits(dmg_builder* b) {
    for (uint32_t i = 0; i < b->part_count; ++i) {
        dmg_part* part = &b->parts[i];
        part->joint.lower -= part->rest;
        part->joint.upper -= part->rest;
        part->joint.closed = -part->rest;
        part->joint.opens = opening_direction(b, &part->joint);
    }
}

/* Draws rest values: some parts are open, continuous joints are at any angle. */
static void scatter_rest(dmg_builder* b) {
    bool open = dmg_chance(b, 0.35f);
    float share = dmg_range(b, 0.2f, 1.0f);
    for (uint32_t i = 0; i < b->part_count; ++i) {
        dmg_part* part = &b->parts[i];
        if (part->keep_rest) continue;
        if (part->joint.type == DM_JOINT_CONTINUOUS)
            part->rest = dmg_range(b, -DMG_PI, DMG_PI);
        else if (open && dmg_chance(b, share))
            part->rest = dmg_range(b, part->joint.lower, part->joint.upper);
    }
}

/* ---- augmentation of single pieces ---- */

/* Begins a piece that holds faces of `piece`. */
static void begin_copy(dmg_builder* b, uint32_t piece) {
    dmg_piece_begin(b);
    if (!b->failed) b->pieces[b->piece_count - 1].drawn_as = b->pieces[piece].drawn_as;
}

/* Splits every face of the piece into four at the midpoints of its edges. */
static void subdivide(dmg_builder* b, uint32_t piece) {
    uint32_t first = b->pieces[piece].first_face, end = dmg_piece_face_end(b, piece), part = b->pieces[piece].part;
    uint32_t in_use = b->part;
    b->part = part;
    begin_copy(b, piece);
    for (uint32_t f = first; f < end && !b->failed; ++f) {
        uint32_t c[3], v[6];
        memcpy(c, b->indices + (size_t)f * 3, sizeof c);
        for (int k = 0; k < 3; ++k) v[k] = dmg_vertex(b, b->vertices[c[k]]);
        for (int k = 0; k < 3; ++k)
            v[3 + k] = dmg_vertex(b, v3_lerp(b->vertices[c[k]], b->vertices[c[(k + 1) % 3]], 0.5f));
        if (b->failed) break;
        /* The face itself becomes the middle one. */
        memcpy(b->indices + (size_t)f * 3, v + 3, sizeof c);
        dmg_triangle(b, v[0], v[3], v[5]);
        dmg_triangle(b, v[3], v[1], v[4]);
        dmg_triangle(b, v[5], v[4], v[2]);
    }
    b->part = in_use;
}

static void subdivide_some(dmg_builder* b) {
    static const float shares[] = {0.0f, 0.25f, 1.0f}, weights[] = {5, 3, 1.5f};
    float share = shares[dmg_weighted(b, weights, 3)];
    int rounds = dmg_chance(b, 0.3f) ? 2 : 1;
    for (int round = 0; round < rounds; ++round) {
        uint32_t pieces = b->piece_count;
        for (uint32_t p = 0; p < pieces; ++p) {
            if (dmg_chance(b, share) && b->face_count < MESSY_FACE_LIMIT) subdivide(b, p);
        }
    }
}

static void flip_face(dmg_builder* b, uint32_t f) {
    uint32_t* face = b->indices + (size_t)f * 3;
    uint32_t second = face[1];
    face[1] = face[2];
    face[2] = second;
}

static void flip_some(dmg_builder* b) {
    static const float shares[] = {0.0f, 0.2f, 1.0f}, weights[] = {7, 2, 0.7f};
    float share = shares[dmg_weighted(b, weights, 3)];
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (!dmg_chance(b, share)) continue;
        for (uint32_t f = b->pieces[p].first_face; f < dmg_piece_face_end(b, p); ++f) flip_face(b, f);
    }
}

/* Adds copies of some pieces' faces with the opposite orientation. */
static void double_faces(dmg_builder* b) {
    if (!dmg_chance(b, 0.1f) || b->face_count > MESSY_FACE_LIMIT) return;
    float share = dmg_chance(b, 0.5f) ? 1.0f : 0.4f;
    uint32_t pieces = b->piece_count, in_use = b->part;
    for (uint32_t p = 0; p < pieces; ++p) {
        if (!dmg_chance(b, share)) continue;
        b->part = b->pieces[p].part;
        uint32_t end = dmg_piece_face_end(b, p), vertex_end = dmg_piece_end(b, p);
        uint32_t from = b->pieces[p].first_vertex, to = b->vertex_count;
        begin_copy(b, p);
        for (uint32_t v = from; v < vertex_end; ++v) dmg_vertex(b, b->vertices[v]);
        for (uint32_t f = b->pieces[p].first_face; f < end && !b->failed; ++f) {
            uint32_t c[3];
            memcpy(c, b->indices + (size_t)f * 3, sizeof c);
            dmg_triangle(b, c[0] - from + to, c[2] - from + to, c[1] - from + to);
        }
    }
    b->part = in_use;
}

/* Shifts pieces by .0005 to .005 of the object's size (standard deviation), which leaves gaps and interpenetrations. */
static void shift_some(dmg_builder* b, float size) {
    if (!dmg_chance(b, 0.25f)) return;
    float by = size * dmg_scale_range(b, 0.0005f, 0.005f);
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (!dmg_chance(b, 0.5f)) continue;
        float x = by * dmg_normal(b), y = by * dmg_normal(b), z = by * dmg_normal(b);
        for (uint32_t v = b->pieces[p].first_vertex; v < dmg_piece_end(b, p); ++v) {
            b->vertices[v] = v3_add(b->vertices[v], v3(x, y, z));
        }
    }
}

/* Removes the faces of random pieces; keeps the first piece of every part. */
static void drop_some(dmg_builder* b) {
    if (!dmg_chance(b, 0.15f)) return;
    float share = dmg_range(b, 0.03f, 0.2f);
    bool seen[DMG_PART_LIMIT + 1] = {false};
    uint32_t faces = 0, end = 0;
    for (uint32_t p = 0, first = 0; p < b->piece_count; ++p, first = end) {
        end = dmg_piece_face_end(b, p);
        uint32_t part = b->pieces[p].part;
        bool keep = !seen[part] || !dmg_chance(b, share);
        seen[part] = seen[part] || end > first;
        b->pieces[p].first_face = faces;
        if (!keep) continue;
        memmove(b->indices + (size_t)faces * 3, b->indices + (size_t)first * 3,
                (size_t)(end - first) * 3 * sizeof *b->indices);
        memmove(b->face_part + faces, b->face_part + first, (end - first) * sizeof *b->face_part);
        faces += end - first;
    }
    b->face_count = faces;
}

/* ---- surroundings ---- */

uint32_t dmg_swept_boxes(const dmg_builder* b, dmg_bounds out[DMG_SWEPT_LIMIT]) {
    enum { STOPS = DMG_SWEPT_STOPS };
    for (uint32_t i = 0; i < b->part_count * STOPS; ++i) out[i] = dmg_bounds_none();
    dmg_frame pose[DMG_PART_LIMIT][STOPS];
    for (uint32_t i = 0; i < b->part_count; ++i) {
        const dmg_joint* joint = &b->parts[i].joint;
        for (int s = 0; s < STOPS; ++s) {
            dmg_frame own = dmg_joint_frame(joint, dmg_joint_stop(joint, s, STOPS));
            pose[i][s] = joint->parent ? dmg_frame_multiply(&pose[joint->parent - 1][s], &own) : own;
        }
    }
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        uint32_t part = b->pieces[p].part;
        if (part == 0) continue;
        for (uint32_t v = b->pieces[p].first_vertex; v < dmg_piece_end(b, p); ++v) {
            for (int s = 0; s < STOPS; ++s)
                dmg_bounds_grow(&out[(part - 1) * STOPS + (uint32_t)s],
                                dmg_frame_point(&pose[part - 1][s], b->vertices[v]));
        }
    }
    return b->part_count * STOPS;
}

static void draw_thing(dmg_builder* b, const dmg_bounds* room) {
    dmg_vec centre = v3_lerp(room->low, room->high, 0.5f), size = v3_sub(room->high, room->low);
    float radius = 0.5f * fminf(size.x, size.z);
    dmg_vec bottom = v3(centre.x, room->low.y, centre.z), up = v3(centre.x, room->high.y, centre.z);
    switch (dmg_int(b, 0, 6)) {
    case 0:
        dmg_rod(b, bottom, up, radius);
        break;
    case 1:
        dmg_cone(b, bottom, up, radius, radius * dmg_unit(b));
        break;
    case 2:
        dmg_ellipsoid(b, centre, v3_scale(size, 0.5f));
        break;
    case 3:
        dmg_rounded_box(b, centre, size, 0.2f * fminf(radius, 0.5f * size.y));
        break;
    case 4:
        dmg_beam(b, room->low, room->high, 0.3f * radius, 0.3f * radius);
        break;
    default:
        dmg_box(b, centre, size);
        break;
    }
}

/* Adds one random solid round the object that no swept box meets. */
static void add_thing(dmg_builder* b, const dmg_bounds* object, const dmg_bounds* swept, uint32_t swept_count) {
    dmg_vec size = v3_sub(object->high, object->low);
    float scale = dmg_largest_side(object);
    for (int attempt = 0; attempt < 4; ++attempt) {
        float sx = scale * dmg_scale_range(b, 0.02f, 0.5f), sy = scale * dmg_scale_range(b, 0.02f, 0.5f);
        float sz = scale * dmg_scale_range(b, 0.02f, 0.5f), x = dmg_range(b, -0.3f, 1.3f),
              y = dmg_range(b, -0.1f, 1.2f);
        dmg_vec centre = v3_add(object->low, v3(x * size.x, y * size.y, dmg_range(b, -0.3f, 1.3f) * size.z));
        dmg_bounds room = {v3_sub(centre, v3(0.5f * sx, 0.5f * sy, 0.5f * sz)),
                           v3_add(centre, v3(0.5f * sx, 0.5f * sy, 0.5f * sz))};
        bool free = true;
        for (uint32_t i = 0; i < swept_count && free; ++i) free = !dmg_boxes_meet(&room, &swept[i]);
        if (!free) continue;
        draw_thing(b, &room);
        return;
    }
}

/* Adds a floor, a wall, two walls or a large block beside the object. */
static void add_setting(dmg_builder* b, const dmg_bounds* object) {
    dmg_vec size = v3_sub(object->high, object->low), centre = v3_lerp(object->low, object->high, 0.5f);
    float scale = dmg_largest_side(object), wide = scale * dmg_scale_range(b, 1.2f, 5.0f),
          thick = scale * dmg_scale_range(b, 0.01f, 0.1f);
    int kind = dmg_int(b, 0, 4);
    if (kind <= 2) dmg_box(b, v3(centre.x, object->low.y - 0.5f * thick, centre.z), v3(wide, thick, wide)); /* floor */
    if (kind == 1 || kind == 2 || kind == 3) { /* wall behind */
        dmg_box(b, v3(centre.x, centre.y + 0.2f * wide, object->low.z - 0.5f * thick), v3(wide, 0.8f * wide, thick));
    }
    if (kind == 2)
        dmg_box(b, v3(centre.x - 0.5f * wide, centre.y + 0.2f * wide, centre.z), v3(thick, 0.8f * wide, wide));
    if (kind == 4) { /* a block beside, behind or below */
        float w = size.x * dmg_scale_range(b, 0.5f, 3.0f), h = size.y * dmg_scale_range(b, 0.5f, 3.0f);
        float d = size.z * dmg_scale_range(b, 0.5f, 3.0f), side = dmg_sign(b);
        dmg_vec offsets[] = {
            {side * 0.5f * (size.x + w), 0, 0}, {0, 0, -0.5f * (size.z + d)}, {0, -0.5f * (size.y + h), 0}};
        dmg_box(b, v3_add(centre, offsets[dmg_int(b, 0, 2)]), v3(w, h, d));
    }
}

/* Adds a copy of the whole object beside it, as part of the body. */
static void add_twin(dmg_builder* b, const dmg_bounds* object) {
    if (b->face_count > MESSY_FACE_LIMIT / 4) return;
    uint32_t vertices = b->vertex_count, faces = b->face_count;
    float away = (object->high.x - object->low.x) * dmg_sign(b);
    away *= dmg_range(b, 1.0f, 1.3f);
    dmg_piece_begin(b);
    for (uint32_t v = 0; v < vertices; ++v) dmg_vertex(b, v3_add(b->vertices[v], v3(away, 0, 0)));
    for (uint32_t f = 0; f < faces && !b->failed; ++f) {
        uint32_t c[3];
        memcpy(c, b->indices + (size_t)f * 3, sizeof c);
        dmg_triangle(b, c[0] + vertices, c[1] + vertices, c[2] + vertices);
    }
}

/* Adds small boxes (screws, stickers, vents) on random faces of the body and of the parts. */
static void add_decoration(dmg_builder* b, float size) {
    int count = dmg_int(b, 1, 10);
    uint32_t faces = b->face_count;
    for (int i = 0; i < count && faces > 0; ++i) {
        uint32_t f = (uint32_t)dmg_int(b, 0, (int)faces - 1);
        dmg_vec corner[3];
        for (int k = 0; k < 3; ++k) corner[k] = b->vertices[b->indices[(size_t)f * 3 + (size_t)k]];
        float u = dmg_unit(b), w = dmg_unit(b) * (1.0f - u);
        dmg_vec at = v3_mad(v3_mad(corner[0], v3_sub(corner[1], corner[0]), u), v3_sub(corner[2], corner[0]), w);
        float sx = size * dmg_scale_range(b, 0.003f, 0.04f), sy = size * dmg_scale_range(b, 0.003f, 0.04f);
        float sz = size * dmg_scale_range(b, 0.003f, 0.02f);
        dmg_use(b, b->face_part[f]);
        dmg_box(b, at, v3(sx, sy, sz));
    }
    dmg_use(b, 0);
}

static void add_surroundings(dmg_builder* b) {
    dmg_bounds object = dmg_whole_bounds(b), swept[DMG_SWEPT_LIMIT];
    dmg_use(b, 0);
    if (dmg_chance(b, 0.25f)) add_decoration(b, dmg_largest_side(&object));
    if (dmg_chance(b, 0.08f) && !b->lone) add_twin(b, &object);
    if (dmg_chance(b, 0.35f)) {
        uint32_t swept_count = dmg_swept_boxes(b, swept);
        for (int left = dmg_int(b, 1, 6); left > 0; --left) add_thing(b, &object, swept, swept_count);
    }
    if (dmg_chance(b, 0.2f)) add_setting(b, &object);
}

/* ---- the frame of the result ---- */

/* Draws a frame with any up axis, rotation, small tilt, mirroring, position and unit. */
static dmg_frame random_frame(dmg_builder* b, float size) {
    static const float ups[] = {6, 3, 1};
    dmg_frame frame = dmg_frame_identity(), next;
    if (dmg_chance(b, 0.5f)) frame.column[0] = v3(-1, 0, 0);
    int up = dmg_weighted(b, ups, 3);
    float yaw = dmg_chance(b, 0.7f) ? 0.5f * DMG_PI * (float)dmg_int(b, 0, 3) : dmg_range(b, 0, 2.0f * DMG_PI);
    next = dmg_frame_screw(v3(0, 0, 0), v3(0, 1, 0), yaw, 0.0f);
    frame = dmg_frame_multiply(&next, &frame);
    if (up == 1) next = dmg_frame_screw(v3(0, 0, 0), v3(1, 0, 0), 0.5f * DMG_PI, 0.0f);  /* Y to Z */
    if (up == 2) next = dmg_frame_screw(v3(0, 0, 0), v3(0, 0, 1), -0.5f * DMG_PI, 0.0f); /* Y to X */
    if (up != 0) frame = dmg_frame_multiply(&next, &frame);
    if (dmg_chance(b, 0.12f)) {
        float x = dmg_normal(b), y = dmg_normal(b), z = dmg_normal(b);
        next = dmg_frame_screw(v3(0, 0, 0), v3_normalize(v3(x, y, z)), dmg_range(b, 0, 0.35f), 0.0f);
        frame = dmg_frame_multiply(&next, &frame);
    }
    float scale = dmg_chance(b, 0.5f) ? 1.0f : dmg_scale_range(b, 0.01f, 100.0f);
    for (int i = 0; i < 3; ++i) frame.column[i] = v3_scale(frame.column[i], scale);
    if (dmg_chance(b, 0.5f)) {
        float x = dmg_normal(b), y = dmg_normal(b), z = dmg_normal(b);
        frame.origin = v3_scale(v3(x, y, z), scale * size);
    }
    return frame;
}

static void move_joint(dmg_joint* joint, const dmg_frame* frame, float scale, bool mirrored) {
    dmg_vec axis = v3_scale(dmg_frame_vector(frame, v3_from(joint->axis)), 1.0f / scale);
    float sign = mirrored && joint->type != DM_JOINT_PRISMATIC ? -1.0f : 1.0f; /* turning axes are pseudovectors */
    v3_to(v3_normalize(v3_scale(axis, sign)), joint->axis);
    v3_to(dmg_frame_point(frame, v3_from(joint->origin)), joint->origin);
    joint->pitch *= sign * scale;
    if (joint->type != DM_JOINT_PRISMATIC) return;
    joint->lower *= scale;
    joint->upper *= scale;
    joint->closed *= scale;
}

static void move_everything(dmg_builder* b, const dmg_frame* frame) {
    bool mirrored = dmg_frame_determinant(frame) < 0.0f;
    float scale = v3_length(frame->column[0]);
    for (uint32_t v = 0; v < b->vertex_count; ++v) b->vertices[v] = dmg_frame_point(frame, b->vertices[v]);
    for (uint32_t i = 0; i < b->part_count; ++i) move_joint(&b->parts[i].joint, frame, scale, mirrored);
    for (uint32_t f = 0; f < b->face_count && mirrored; ++f) flip_face(b, f);
}

/* Reverses the axes of half of the joints, with their limits and opening direction: the sign of an axis carries no
 * information. */
static void turn_signs(dmg_builder* b) {
    for (uint32_t i = 0; i < b->part_count; ++i) {
        dmg_joint* joint = &b->parts[i].joint;
        if (!dmg_chance(b, 0.5f)) continue;
        float lower = joint->lower;
        v3_to(v3_scale(v3_from(joint->axis), -1.0f), joint->axis);
        joint->lower = -joint->upper;
        joint->upper = -lower;
        joint->closed = -joint->closed;
        joint->opens = -joint->opens;
    }
}

/* Moves origins along their axes at random, so that nothing can be learnt from where on the line an origin lies. */
static void slide_origins(dmg_builder* b, float size) {
    for (uint32_t i = 0; i < b->part_count; ++i) {
        dmg_joint* joint = &b->parts[i].joint;
        v3_to(v3_mad(v3_from(joint->origin), v3_from(joint->axis), 0.2f * size * dmg_normal(b)), joint->origin);
    }
}

void dmg_finish(dmg_builder* b) {
    b->frame_depth = 0;
    b->frames[0] = dmg_frame_identity(); /* a category's last frame must not move the augmentation */
    if (b->failed) return;
    if (b->messy) scatter_rest(b);
    pose_parts(b);
    settle_limits(b);
    if (!b->messy) return;
    dmg_bounds object = dmg_whole_bounds(b);
    float size = dmg_largest_side(&object);
    drop_some(b);
    shift_some(b, size);
    dmg_augment_buttons(b, size);
    dmg_augment_fit(b);
    add_surroundings(b);
    double_faces(b);
    subdivide_some(b);
    flip_some(b);
    dmg_augment_joints(b, size);
    slide_origins(b, size);
    dmg_frame frame = random_frame(b, size);
    move_everything(b, &frame);
    turn_signs(b);
}
