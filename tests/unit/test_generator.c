/* Generator: the same seed gives the same bits; every object is sound; labels say how its parts really move. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "core/build.h"
#include "core/check.h"
#include "generator.h"
#include "test_object_hash.h"

enum { SEEDS = 20, FEW_SEEDS = 4 };

static dmg_object make(uint32_t category, uint64_t seed, uint32_t flags) {
    dmg_object object;
    assert_int_equal(dmg_make(category, seed, flags, &object), 0);
    return object;
}

/* ---- vectors and motion, written again: the generator's own are under test ---- */

static void cross(const float* a, const float* b, float* out) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static float dot(const float* a, const float* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static float length(const float* a) {
    return sqrtf(dot(a, a));
}

static float angle_between(const float* a, const float* b) {
    float n[3];
    cross(a, b, n);
    return atan2f(length(n), dot(a, b));
}

static void move_point(const dmg_joint* joint, double value, const float* in, float* out) {
    double a[3], r[3], along = 0.0, turn = joint->type == DM_JOINT_PRISMATIC ? 0.0 : value;
    for (int k = 0; k < 3; ++k) {
        a[k] = joint->axis[k];
        r[k] = (double)in[k] - (double)joint->origin[k];
        along += a[k] * r[k];
    }
    double advance = joint->type == DM_JOINT_PRISMATIC
                         ? value
                         : (joint->type == DM_JOINT_SCREW ? value * (double)joint->pitch : 0.0);
    double c = cos(turn), s = sin(turn);
    for (int k = 0; k < 3; ++k) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        double turned = r[k] * c + (a[i] * r[j] - a[j] * r[i]) * s + a[k] * along * (1.0 - c);
        out[k] = (float)((double)joint->origin[k] + turned + advance * a[k]);
    }
}

static float size_of(const dmg_object* o) {
    float size = 0.0f;
    for (uint32_t k = 0; k < 3; ++k) {
        float low = INFINITY, high = -INFINITY;
        for (uint32_t v = 0; v < o->vertex_count; ++v) {
            low = fminf(low, o->positions[3 * v + k]);
            high = fmaxf(high, o->positions[3 * v + k]);
        }
        size = fmaxf(size, high - low);
    }
    return size;
}

/* ---- tests ---- */

static void categories_have_names(void** state) {
    (void)state;
    assert_true(dmg_category_count() >= 43);
    for (uint32_t i = 0; i < dmg_category_count(); ++i) assert_int_equal(dmg_category_find(dmg_category_name(i)), i);
    assert_null(dmg_category_name(dmg_category_count()));
    assert_int_equal(dmg_category_find("no such thing"), -1);
    dmg_object object;
    assert_int_not_equal(dmg_make(dmg_category_count(), 0, 0, &object), 0);
}

/* Ids are unique, lead back to their rows, and end at the limit. */
static void category_ids_are_unique(void** state) {
    (void)state;
    const uint32_t count = dmg_category_count(), limit = dmg_category_id_limit();
    uint8_t* seen = calloc(limit, 1);
    for (uint32_t row = 0; row < count; ++row) {
        const uint32_t id = dmg_category_id(row);
        assert_true(id < limit);
        assert_int_equal(seen[id]++, 0);
        assert_int_equal(dmg_category_with_id(id), row);
    }
    assert_int_equal(seen[limit - 1], 1);
    assert_int_equal(dmg_category_with_id(limit), -1);
    assert_int_equal(dmg_category_id(count), UINT32_MAX);
    free(seen);
}

/* The categories of today stay in their sets. */
static void category_sets_stay(void** state) {
    (void)state;
    enum { IDS = 390 };
    uint32_t sizes[2] = {0};
    for (uint32_t id = 0; id < IDS; ++id) {
        const int32_t row = dmg_category_with_id(id);
        if (row < 0) continue; /* retired */
        const int32_t set = dmg_category_set((uint32_t)row);
        assert_in_range(set, DMG_SET_TRAINED, DMG_SET_TEST_ONLY);
        ++sizes[set];
    }
    assert_int_equal(sizes[DMG_SET_TRAINED], 195);
    assert_int_equal(sizes[DMG_SET_TEST_ONLY], 30);
    assert_int_equal(dmg_category_set(dmg_category_count()), -1);
}

/* Of 20 seeds one is for validation and one for test. */
static void splits_have_their_shares(void** state) {
    (void)state;
    enum { COUNT = 2000 };
    for (uint32_t row = 0; row < dmg_category_count(); ++row) {
        uint32_t sizes[3] = {0};
        for (uint64_t seed = 0; seed < COUNT; ++seed) ++sizes[dmg_split(row, seed)];
        assert_in_range(sizes[DMG_SPLIT_VALIDATION], COUNT / 30, COUNT / 12);
        assert_in_range(sizes[DMG_SPLIT_TEST], COUNT / 30, COUNT / 12);
    }
}

static void same_seed_same_bits(void** state) {
    (void)state;
    for (uint32_t c = 0; c < dmg_category_count(); ++c) {
        for (uint32_t flags = 0; flags <= DMG_MESSY; ++flags) {
            dmg_object a = make(c, 7, flags), again = make(c, 7, flags), other = make(c, 8, flags);
            assert_int_equal(test_hash_object(TEST_HASH_START, &a), test_hash_object(TEST_HASH_START, &again));
            assert_int_not_equal(test_hash_object(TEST_HASH_START, &a), test_hash_object(TEST_HASH_START, &other));
            dmg_object_release(&a);
            dmg_object_release(&again);
            dmg_object_release(&other);
        }
    }
}

static void check_mesh(const dmg_object* o) {
    assert_true(o->face_count > 0 && o->vertex_count > 0);
    for (uint32_t i = 0; i < o->vertex_count * 3; ++i) assert_true(isfinite(o->positions[i]));
    uint32_t* faces = calloc(o->joint_count + 1, sizeof *faces);
    uint32_t* owner = malloc(o->vertex_count * sizeof *owner);
    memset(owner, 0xff, o->vertex_count * sizeof *owner);
    for (uint32_t f = 0; f < o->face_count; ++f) {
        assert_in_range(o->face_part[f], 0, o->joint_count);
        ++faces[o->face_part[f]];
        for (int k = 0; k < 3; ++k) {
            uint32_t v = o->indices[3 * f + (uint32_t)k];
            assert_true(v < o->vertex_count);
            assert_true(owner[v] == UINT32_MAX || owner[v] == o->face_part[f]); /* no vertex of two parts */
            owner[v] = o->face_part[f];
        }
    }
    for (uint32_t v = 0; v < o->vertex_count; ++v) assert_int_not_equal(owner[v], UINT32_MAX);
    for (uint32_t i = 0; i <= o->joint_count; ++i)
        assert_true(faces[i] > 0 || i == 0); /* leaves without a frame have no body */
    free(owner);
    free(faces);
}

static void check_joints(const dmg_object* o) {
    assert_true(o->joint_count > 0);
    float size = size_of(o);
    for (uint32_t i = 0; i < o->joint_count; ++i) {
        const dmg_joint* j = &o->joints[i];
        assert_true(j->name[0] != '\0' && memchr(j->name, 0, sizeof j->name));
        for (uint32_t k = 0; k < i; ++k) assert_string_not_equal(j->name, o->joints[k].name);
        assert_true(j->parent <= i); /* carriers come first */
        assert_in_range(j->type, DM_JOINT_REVOLUTE, DM_JOINT_CONTINUOUS);
        assert_true(fabsf(length(j->axis) - 1.0f) < 1e-4f);
        for (int k = 0; k < 3; ++k) assert_true(isfinite(j->origin[k]));
        assert_true(j->opens == 1 || j->opens == -1);
        if (j->type == DM_JOINT_CONTINUOUS) continue;
        assert_true(j->lower < j->upper);
        float range = j->upper - j->lower, at_limit = 1e-4f * range;
        assert_true(j->lower <= at_limit && j->upper >= -at_limit);         /* rest is within the limits */
        assert_true((j->opens > 0 ? j->upper : -j->lower) > 0.09f * range); /* and leaves room to open */
        if (j->type == DM_JOINT_PRISMATIC)
            assert_true(range < 2.0f * size);
        else
            assert_true(range < 40.0f);
        if (j->type == DM_JOINT_SCREW) assert_true(j->pitch != 0.0f && fabsf(j->pitch) * range < 2.0f * size);
    }
}

static void every_object_is_sound(void** state) {
    (void)state;
    for (uint32_t c = 0; c < dmg_category_count(); ++c) {
        for (uint64_t seed = 0; seed < SEEDS; ++seed) {
            for (uint32_t flags = 0; flags <= DMG_MESSY; ++flags) {
                dmg_object object = make(c, seed, flags);
                check_mesh(&object);
                check_joints(&object);
                dmg_object_release(&object);
            }
        }
    }
}

/* The drag is the velocity of its point in the opening direction, and the point moves at all. */
static void check_drag(const dmg_object* o, uint32_t part, uint64_t seed, float size) {
    const dmg_joint* j = &o->joints[part - 1];
    float point[3], vector[3], there[3], back[3], step = j->type == DM_JOINT_PRISMATIC ? 0.01f * size : 0.01f;
    dmg_drag(o, part, 0.0f, seed, point, vector);
    move_point(j, (double)step * 0.5 * j->opens, point, there);
    move_point(j, (double)step * -0.5 * j->opens, point, back);
    for (int k = 0; k < 3; ++k) there[k] -= back[k];
    /* Close to the axis of a huge object the difference drowns in rounding. */
    if (length(there) > 1e-4f * size) assert_true(angle_between(there, vector) < 0.02f);
    assert_true(length(vector) > 0.019f * size && length(vector) < 0.51f * size);
}

static void drags_follow_the_motion(void** state) {
    (void)state;
    for (uint32_t c = 0; c < dmg_category_count(); ++c) {
        for (uint64_t seed = 0; seed < FEW_SEEDS; ++seed) {
            dmg_object object = make(c, seed, seed % 2 ? DMG_MESSY : 0);
            float size = size_of(&object);
            for (uint32_t part = 1; part <= object.joint_count; ++part) check_drag(&object, part, seed, size);
            dmg_object_release(&object);
        }
    }
}

static void noisy_drags_are_off_as_asked(void** state) {
    (void)state;
    enum { COUNT = 400 };
    dmg_object object = make((uint32_t)dmg_category_find("kitchen_cabinet"), 1, 0);
    double sum = 0.0;
    for (uint64_t seed = 0; seed < COUNT; ++seed) {
        float point[3], exact[3], noisy[3];
        dmg_drag(&object, 1, 0.0f, seed, point, exact);
        dmg_drag(&object, 1, 8.0f, seed, point, noisy);
        sum += (double)angle_between(exact, noisy) * 180.0 / 3.14159265358979;
    }
    double expected = 8.0 * sqrt(2.0 / 3.14159265358979); /* mean of 8 |N(0, 1)| */
    assert_true(fabs(sum / COUNT - expected) < 0.6);
    dmg_object_release(&object);
}

/* What a network could guess without looking: axes of messy doors point in every direction, both ways, and the line of
 * a hinge does not run through the middle of its part. */
static void axes_are_not_given_away(void** state) {
    (void)state;
    uint32_t category = (uint32_t)dmg_category_find("door");
    int seen[3][2] = {{0}}, opens[2] = {0};
    for (uint64_t seed = 0; seed < 300; ++seed) {
        dmg_object object = make(category, seed, DMG_MESSY);
        const dmg_joint* j = &object.joints[0];
        for (int k = 0; k < 3; ++k) {
            if (fabsf(j->axis[k]) > 0.9f) ++seen[k][j->axis[k] > 0.0f];
        }
        ++opens[j->opens > 0];
        float low[3], high[3], r[3], away[3];
        for (int k = 0; k < 3; ++k) low[k] = INFINITY, high[k] = -INFINITY;
        for (uint32_t i = 0; i < object.face_count * 3; ++i) {
            for (uint32_t k = 0; k < 3 && object.face_part[i / 3] == 1; ++k) {
                low[k] = fminf(low[k], object.positions[3 * object.indices[i] + k]);
                high[k] = fmaxf(high[k], object.positions[3 * object.indices[i] + k]);
            }
        }
        float side = 0.0f;
        for (int k = 0; k < 3; ++k) {
            r[k] = 0.5f * (low[k] + high[k]) - j->origin[k];
            side = fmaxf(side, high[k] - low[k]);
        }
        cross(j->axis, r, away);
        assert_true(length(away) > 0.05f * side);
        dmg_object_release(&object);
    }
    for (int k = 0; k < 3; ++k) assert_true(seen[k][0] > 5 && seen[k][1] > 5);
    assert_true(opens[0] > 50 && opens[1] > 50);
}

/* Winding number of the body about a point (van Oosterom and Strackee 1983): 1 inside a closed shell, 0 outside. */
static double winding(const dmg_object* o, const float* p) {
    double sum = 0.0;
    for (uint32_t f = 0; f < o->face_count; ++f) {
        if (o->face_part[f] != 0) continue;
        float c[3][3], l[3], n[3];
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k)
                c[i][k] = o->positions[3 * o->indices[3 * f + (uint32_t)i] + (uint32_t)k] - p[k];
            l[i] = length(c[i]);
        }
        cross(c[1], c[2], n);
        float below = l[0] * l[1] * l[2] + dot(c[0], c[1]) * l[2] + dot(c[1], c[2]) * l[0] + dot(c[2], c[0]) * l[1];
        sum += 2.0 * atan2((double)dot(c[0], n), (double)below);
    }
    return sum / (4.0 * 3.14159265358979);
}

static int is_carried(const dmg_object* o, uint32_t part, uint32_t carrier) {
    while (part != 0 && part != carrier) part = o->joints[part - 1].parent;
    return part == carrier;
}

/* A part that has opened must show, with what it carries: it is not swallowed by the body. */
static void check_visible(const dmg_object* o, uint32_t part) {
    enum { POINTS = 24 };
    const dmg_joint* j = &o->joints[part - 1];
    uint32_t own = 0, taken = 0, inside = 0;
    for (uint32_t f = 0; f < o->face_count; ++f) own += is_carried(o, o->face_part[f], part);
    for (uint32_t f = 0, i = 0; f < o->face_count; ++f) {
        if (!is_carried(o, o->face_part[f], part) || i++ % (own / POINTS + 1) != 0) continue;
        float p[3] = {0, 0, 0}, moved[3];
        for (int c = 0; c < 3; ++c) {
            for (int k = 0; k < 3; ++k) p[k] += o->positions[3 * o->indices[3 * f + (uint32_t)c] + (uint32_t)k] / 3.0f;
        }
        move_point(j, j->opens > 0 ? (double)j->upper : (double)j->lower, p, moved);
        inside += winding(o, moved) > 0.5;
        ++taken;
    }
    if (inside * 10 >= taken * 9)
        fail_msg("%s: %s is hidden in the body when open (%u of %u)", o->category, j->name, inside, taken);
}

static void open_parts_show(void** state) {
    (void)state;
    for (uint32_t c = 0; c < dmg_category_count(); ++c) {
        for (uint64_t seed = 0; seed < FEW_SEEDS; ++seed) {
            dmg_object object = make(c, seed, 0);
            for (uint32_t part = 1; part <= object.joint_count && part <= 6; ++part) check_visible(&object, part);
            dmg_object_release(&object);
        }
    }
}

/* ---- the true motion runs into nothing and nothing comes off ---- */

/* Two boxes, corner to corner, the second a part. */
static void fill_box(float* positions, uint32_t* indices, uint32_t first, const float low[3], const float high[3]) {
    static const uint32_t faces[12][3] = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                                          {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    for (uint32_t v = 0; v < 8; ++v) {
        for (uint32_t k = 0; k < 3; ++k) positions[3 * v + k] = v >> k & 1 ? high[k] : low[k];
    }
    for (uint32_t i = 0; i < 36; ++i) indices[i] = first + faces[i / 3][i % 3];
}

/* The check itself must see what is wrong: a door that opens into its block, and one hung on a line far away. */
static void wrong_joints_are_found(void** state) {
    (void)state;
    float positions[48];
    uint32_t indices[72], face_part[24] = {0};
    for (int f = 12; f < 24; ++f) face_part[f] = 1;
    fill_box(positions, indices, 0, (const float[3]){0, 0, 0}, (const float[3]){1, 1, 1});
    fill_box(positions + 24, indices + 36, 8, (const float[3]){0, 0, 1}, (const float[3]){1, 1, 1.05f});
    dmg_joint door = {.name = "door", .type = DM_JOINT_REVOLUTE, .axis = {0, -1, 0}, .origin = {0, 0, 1.05f}};
    door.upper = 1.5f;
    dmg_object object = {"block", positions, indices, face_part, 16, 24, &door, 1};
    dmg_finding finding;
    assert_int_equal(dmg_check(&object, 1, &finding), 0);
    assert_true(finding.depth < 0.06f &&
                finding.gap < 0.06f); /* it turns about its outer edge: the inner one digs in */
    door.axis[1] = 1.0f;
    assert_int_equal(dmg_check(&object, 1, &finding), 0);
    assert_true(finding.depth > 0.2f);
    door.axis[1] = -1.0f;
    door.origin[0] = -2.0f;
    assert_int_equal(dmg_check(&object, 1, &finding), 0);
    assert_true(finding.gap > 0.2f);
    assert_int_not_equal(dmg_check(&object, 0, &finding), 0);
    assert_int_not_equal(dmg_check(&object, 2, &finding), 0);
}

/* A few first parts in a hundred graze their surroundings at the very end of their way, as in real models; no more do,
 * and none goes through and through. dragmesh_generate --check looks at all of them. */
static void motions_are_free(void** state) {
    (void)state;
    uint32_t parts = 0, deep = 0, loose = 0;
    for (uint32_t c = 0; c < dmg_category_count(); ++c) {
        dmg_object object = make(c, 21, 0);
        for (uint32_t part = 1; object.face_count < 1000 && part <= object.joint_count && part <= 1; ++part) {
            const dmg_joint* joint = &object.joints[part - 1];
            dmg_finding finding;
            assert_int_equal(dmg_check(&object, part, &finding), 0);
            const int slides = joint->type == DM_JOINT_PRISMATIC;
            const int sinks = slides && joint->upper - joint->lower < 0.15f * finding.size;
            deep += finding.depth > 0.02f && !sinks;
            loose += finding.gap > 0.08f && !slides && joint->type != DM_JOINT_SCREW;
            ++parts;
        }
        dmg_object_release(&object);
    }
    assert_true(parts > 60);
    if (deep * 12 > parts || loose * 40 > parts)
        fail_msg("of %u parts %u run into something, %u come off", parts, deep, loose);
}

/* Augmentation moves joints with their parts: the hinge lines of messy doors still run along their doors. */
static void labels_survive_augmentation(void** state) {
    (void)state;
    static const char* const names[] = {"door", "chest", "microwave", "book", "gate"};
    uint32_t parts = 0, loose = 0;
    for (uint64_t seed = 0; seed < 12; ++seed) {
        dmg_object object = make((uint32_t)dmg_category_find(names[seed % 5]), seed, DMG_MESSY);
        dmg_finding finding;
        if (object.face_count < 1500 && object.joints[0].type == DM_JOINT_REVOLUTE) {
            assert_int_equal(dmg_check(&object, 1, &finding), 0);
            loose += finding.gap > 0.08f;
            ++parts;
        }
        dmg_object_release(&object);
    }
    assert_true(parts >= 4);
    assert_true(loose == 0);
}

/* dmg_augment_fit may enlarge and shift a door and add body round it: the hinge moves with the door, the door keeps its
 * faces, and what is added belongs to the body. */
static void fitted_parts_keep_their_hinges(void** state) {
    (void)state;
    uint32_t moved = 0, more = 0;
    for (uint64_t seed = 0; seed < 60; ++seed) {
        dmg_builder b;
        dmg_builder_init(&b, seed, true);
        dmg_box(&b, v3(0, 0.5f, -0.3f), v3(1, 1, 0.58f));
        uint32_t door = dmg_hinge(&b, 0, "door", v3(-0.5f, 0.5f, 0), v3(0, 1, 0), 0, 1.5f), body = b.face_count;
        dmg_box(&b, v3(0, 0.5f, 0), v3(1, 1, 0.02f));
        dmg_augment_fit(&b);
        assert_false(b.failed);
        assert_int_equal(door, 1);
        dmg_bounds of_door = dmg_bounds_none();
        uint32_t faces = 0;
        for (uint32_t p = 0; p < b.piece_count; ++p)
            for (uint32_t v = b.pieces[p].first_vertex; b.pieces[p].part == door && v < dmg_piece_end(&b, p); ++v)
                dmg_bounds_grow(&of_door, b.vertices[v]);
        for (uint32_t f = 0; f < b.face_count; ++f) faces += b.face_part[f] == door;
        const float* origin = b.parts[0].joint.origin;
        const dmg_vec middle = v3_lerp(of_door.low, of_door.high, 0.5f);
        assert_true(fabsf(middle.x - origin[0] - 0.5f) < 1e-5f && fabsf(middle.z - origin[2]) < 1e-5f);
        assert_true(of_door.high.x - of_door.low.x < 1.1f);
        assert_int_equal(faces, 12);
        moved += fabsf(origin[2]) > 1e-4f;
        more += b.face_count > body + faces;
        dmg_builder_free(&b);
    }
    assert_true(moved > 5 && more > 10);
}

/* The farthest that a part's corners end from where another joint takes them, at the end of the way. */
static float ends_apart(const dmg_builder* b, uint32_t part, const dmg_joint* was) {
    const dmg_joint* is = &b->parts[part - 1].joint;
    const dmg_frame there = dmg_joint_frame(was, was->upper), here = dmg_joint_frame(is, is->upper);
    float most = 0;
    for (uint32_t p = 0; p < b->piece_count; ++p)
        for (uint32_t v = b->pieces[p].first_vertex; b->pieces[p].part == part && v < dmg_piece_end(b, p); ++v) {
            const dmg_vec off = v3_sub(dmg_frame_point(&here, b->vertices[v]), dmg_frame_point(&there, b->vertices[v]));
            most = fmaxf(most, v3_length(off));
        }
    return most;
}

static float leaning(const dmg_joint* a, const dmg_joint* b) {
    const dmg_vec u = v3_from(a->axis), w = v3_from(b->axis);
    return v3_length(v3_cross(u, w));
}

/* dmg_augment_joints may tilt a button by degrees but not a door, and both end nearly where they should. */
static void joints_are_as_exact_as_people_see(void** state) {
    (void)state;
    uint32_t inexact = 0, leaning_buttons = 0;
    for (uint64_t seed = 0; seed < 60; ++seed) {
        dmg_builder b;
        dmg_builder_init(&b, seed, true);
        dmg_box(&b, v3(0, 0.5f, -0.3f), v3(1, 1, 0.58f));
        dmg_hinge(&b, 0, "door", v3(-0.5f, 0.5f, 0), v3(0, 1, 0), 0, 1.5f);
        dmg_box(&b, v3(0, 0.5f, 0), v3(1, 1, 0.02f));
        dmg_slide(&b, 0, "button", v3(0, 0, -1), 0, 0.01f);
        dmg_box(&b, v3(0, 1.1f, 0), v3(0.05f, 0.05f, 0.02f));
        const dmg_joint door = b.parts[0].joint, button = b.parts[1].joint;
        dmg_augment_joints(&b, 1);
        const float door_leans = leaning(&door, &b.parts[0].joint), leans = leaning(&button, &b.parts[1].joint);
        assert_true(door_leans < 0.02f && leans < 0.5f);
        assert_true(ends_apart(&b, 1, &door) < 0.03f && ends_apart(&b, 2, &button) < 0.005f);
        inexact += leans > 0;
        leaning_buttons += leans > 0.03f;
        dmg_builder_free(&b);
    }
    assert_true(inexact > 10 && inexact < 40 && leaning_buttons > 5);
}

/* dmg_augment_buttons lengthens stems downwards and changes travels, keeps tops, and changes nothing but buttons. */
static void buttons_go_deep(void** state) {
    (void)state;
    uint32_t deeper = 0, other_ways = 0;
    for (uint64_t seed = 0; seed < 60; ++seed) {
        dmg_builder b;
        dmg_builder_init(&b, seed, true);
        dmg_box(&b, v3(0, 0.5f, -0.3f), v3(1, 1, 0.6f));
        dmg_slide(&b, 0, "button", v3(0, 0, -1), 0, 0.01f);
        dmg_box(&b, v3(0, 0.2f, 0), v3(0.05f, 0.05f, 0.02f));
        const dmg_bounds drawn = {v3(-0.025f, 0.175f, -0.01f), v3(0.025f, 0.225f, 0.01f)};
        dmg_slide(&b, 0, "drawer", v3(0, 0, 1), 0, 0.4f);
        dmg_box(&b, v3(0, 0.7f, -0.2f), v3(0.2f, 0.2f, 0.4f));
        const dmg_joint drawer = b.parts[1].joint;
        dmg_augment_buttons(&b, 1);
        dmg_bounds box = dmg_bounds_none();
        for (uint32_t v = b.pieces[1].first_vertex; v < dmg_piece_end(&b, 1); ++v) dmg_bounds_grow(&box, b.vertices[v]);
        assert_float_equal(box.high.z, drawn.high.z, 1e-6f);
        assert_float_equal(box.high.x, drawn.high.x, 1e-6f);
        assert_true(box.low.z < drawn.low.z + 1e-6f && box.low.z > -0.6f);
        const dmg_joint* button = &b.parts[0].joint;
        assert_true(button->lower == 0 && button->upper > 0.001f && button->upper <= 0.031f);
        assert_memory_equal(&drawer, &b.parts[1].joint, sizeof drawer);
        deeper += box.low.z < drawn.low.z - 1e-3f;
        other_ways += fabsf(button->upper - 0.01f) > 1e-4f;
        dmg_builder_free(&b);
    }
    assert_true(deeper > 12 && deeper < 40 && other_ways > 12 && other_ways < 40);
}

/* The demo leans on these names. */
static void kitchen_cabinet_is_stable(void** state) {
    (void)state;
    static const char* const names[] = {"door_left", "door_right", "drawer_left", "drawer_right"};
    uint32_t category = (uint32_t)dmg_category_find("kitchen_cabinet");
    for (uint64_t seed = 0; seed < SEEDS; ++seed) {
        dmg_object object = make(category, seed, 0);
        assert_int_equal(object.joint_count, 4);
        for (uint32_t i = 0; i < 4; ++i) {
            assert_string_equal(object.joints[i].name, names[i]);
            assert_int_equal(object.joints[i].opens, 1);
            assert_true(object.joints[i].lower == 0.0f);
        }
        dmg_object_release(&object);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(categories_have_names),
        cmocka_unit_test(category_ids_are_unique),
        cmocka_unit_test(category_sets_stay),
        cmocka_unit_test(splits_have_their_shares),
        cmocka_unit_test(same_seed_same_bits),
        cmocka_unit_test(every_object_is_sound),
        cmocka_unit_test(drags_follow_the_motion),
        cmocka_unit_test(noisy_drags_are_off_as_asked),
        cmocka_unit_test(axes_are_not_given_away),
        cmocka_unit_test(open_parts_show),
        cmocka_unit_test(wrong_joints_are_found),
        cmocka_unit_test(motions_are_free),
        cmocka_unit_test(labels_survive_augmentation),
        cmocka_unit_test(fitted_parts_keep_their_hinges),
        cmocka_unit_test(joints_are_as_exact_as_people_see),
        cmocka_unit_test(buttons_go_deep),
        cmocka_unit_test(kitchen_cabinet_is_stable),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
