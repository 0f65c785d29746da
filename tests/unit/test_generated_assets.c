/* Generator: an asset has each face in one node and each node in one body; what it welds, drops and adds is labelled;
 * the same seed gives the same bits. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "asset/asset_layer.h"
#include "asset/asset_words.h"
#include "test_object_hash.h"

enum { SEEDS = 2 };

static dmg_asset make(uint32_t category, uint64_t seed, uint32_t flags) {
    dmg_asset asset;
    assert_int_equal(dmg_make_asset(category, seed, flags, &asset), 0);
    return asset;
}

static uint64_t hash_asset(const dmg_asset* asset) {
    uint64_t hash = test_hash_object(TEST_HASH_START, &asset->object);
    hash = test_hash_bytes(hash, asset->face_node, asset->object.face_count * sizeof *asset->face_node);
    return test_hash_bytes(hash, asset->nodes, asset->node_count * sizeof *asset->nodes);
}

static void same_seed_same_bits(void** state) {
    (void)state;
    for (uint32_t c = 0; c < dmg_category_count(); c += 3) {
        for (uint32_t flags = 0; flags <= DMG_MESSY; ++flags) {
            dmg_asset a = make(c, 5, flags), again = make(c, 5, flags), other = make(c, 6, flags);
            assert_int_equal(hash_asset(&a), hash_asset(&again));
            assert_int_not_equal(hash_asset(&a), hash_asset(&other));
            dmg_asset_release(&a);
            dmg_asset_release(&again);
            dmg_asset_release(&other);
        }
    }
    dmg_asset asset;
    assert_int_not_equal(dmg_make_asset(dmg_category_count(), 0, 0, &asset), 0);
}

/* Every face is in a node of its part, no vertex in two nodes, and no part without a node. */
static void check_faces(const dmg_asset* a) {
    uint32_t* faces = calloc(a->node_count + 1, sizeof *faces);
    uint32_t* owner = malloc(a->object.vertex_count * sizeof *owner);
    memset(owner, 0xff, a->object.vertex_count * sizeof *owner);
    for (uint32_t f = 0; f < a->object.face_count; ++f) {
        const uint32_t node = a->face_node[f];
        assert_true(node < a->node_count);
        assert_int_equal(a->nodes[node].part, a->object.face_part[f]);
        ++faces[node];
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t v = a->object.indices[3 * f + k];
            assert_true(owner[v] == UINT32_MAX || owner[v] == node);
            owner[v] = node;
        }
    }
    for (uint32_t i = 0; i < a->node_count; ++i) assert_int_equal(faces[i], a->nodes[i].face_count);
    for (uint32_t part = 1; part <= a->object.joint_count; ++part) {
        uint32_t i = 0;
        while (i < a->node_count && (a->nodes[i].part != part || faces[i] == 0)) ++i;
        assert_true(i < a->node_count);
    }
    free(owner);
    free(faces);
}

/* Names are there once, no node is above itself, and transforms are a rotation with one scale. */
static void check_nodes(const dmg_asset* a) {
    for (uint32_t i = 0; i < a->node_count; ++i) {
        const dmg_asset_node* node = &a->nodes[i];
        assert_true(node->name[0] != '\0' && memchr(node->name, 0, sizeof node->name));
        for (uint32_t k = 0; k < i; ++k) assert_string_not_equal(node->name, a->nodes[k].name);
        uint32_t above = node->parent, steps = 0;
        for (; above != DMG_NO_NODE && steps <= a->node_count; ++steps) above = a->nodes[above].parent;
        assert_int_equal(above, DMG_NO_NODE);
        const float* m = node->transform;
        for (int k = 0; k < 16; ++k) assert_true(isfinite(m[k]));
        const float scale = m[0] * m[0] + m[1] * m[1] + m[2] * m[2];
        for (int p = 0; p < 3; ++p)
            for (int q = 0; q < 3; ++q) {
                float dot = 0;
                for (int k = 0; k < 3; ++k) dot += m[4 * p + k] * m[4 * q + k];
                assert_true(fabsf(dot - (p == q ? scale : 0)) < 1e-3f * scale);
            }
    }
}

static float size_of(const dmg_object* o) {
    dmg_bounds box = dmg_bounds_none();
    for (uint32_t v = 0; v < o->vertex_count; ++v) dmg_bounds_grow(&box, v3_from(o->positions + 3 * (size_t)v));
    return dmg_largest_side(&box);
}

/* The corners of a node, face by face, relative to its pivot. */
static dmg_vec* corners_of(const dmg_asset* a, uint32_t node) {
    dmg_vec* out = malloc(3 * ((size_t)a->nodes[node].face_count + 1) * sizeof *out);
    uint32_t count = 0;
    for (uint32_t i = 0; i < 3 * a->object.face_count; ++i)
        if (a->face_node[i / 3] == node)
            out[count++] = v3_sub(v3_from(a->object.positions + 3 * (size_t)a->object.indices[i]),
                                  v3_from(a->nodes[node].transform + 12));
    return out;
}

/* Instances have one shape round their pivots. Returns how many there are. */
static uint32_t check_instances(const dmg_asset* a) {
    const float tolerance = 1e-5f * size_of(&a->object);
    uint32_t instances = 0;
    for (uint32_t i = 0; i < a->node_count; ++i) {
        const uint32_t first = a->nodes[i].mesh;
        if (a->nodes[i].face_count == 0 || first == i) continue;
        assert_int_equal(a->nodes[i].face_count, a->nodes[first].face_count);
        dmg_vec *own = corners_of(a, i), *its = corners_of(a, first);
        for (uint32_t k = 0; k < 3 * a->nodes[i].face_count; ++k)
            assert_true(v3_length(v3_sub(own[k], its[k])) < tolerance + 1e-5f * v3_length(own[k]));
        free(own);
        free(its);
        ++instances;
    }
    return instances;
}

static void check_joints(const dmg_asset* a) {
    for (uint32_t i = 0; i < a->object.joint_count; ++i) {
        const dmg_joint* j = &a->object.joints[i];
        assert_true(j->parent <= i); /* carriers come first */
        for (uint32_t k = 0; k < i; ++k) assert_string_not_equal(j->name, a->object.joints[k].name);
        if (j->type == DM_JOINT_CONTINUOUS) continue;
        const float slack = 1e-4f * (j->upper - j->lower);
        assert_true(j->lower < j->upper);
        assert_true(j->lower <= slack && j->upper >= -slack);
        assert_true(isfinite(j->closed));
    }
}

/* What a set of assets has. */
typedef struct tally {
    uint32_t assets, still, loose, instances, split_bodies, split_parts, carried, parts, open, empties, lone_nodes;
} tally;

static void count(const dmg_asset* a, tally* out) {
    uint32_t meshes = 0, own[DMG_PART_LIMIT + 1] = {0};
    ++out->assets;
    out->still += a->object.joint_count == 0;
    out->parts += a->object.joint_count;
    for (uint32_t i = 0; i < a->node_count; ++i) {
        out->loose += a->nodes[i].face_count > 0 && a->nodes[i].loose;
        out->empties += a->nodes[i].face_count == 0;
        if (a->nodes[i].face_count > 0) ++own[a->nodes[i].part], ++meshes;
    }
    out->lone_nodes += meshes == 1;
    out->split_bodies += own[0] > 1;
    for (uint32_t i = 0; i < a->object.joint_count; ++i) {
        out->split_parts += own[i + 1] > 1;
        out->carried += a->object.joints[i].parent != 0;
        out->open += fabsf(a->object.joints[i].closed) > 1e-3f;
    }
}

static void every_asset_is_sound(void** state) {
    (void)state;
    tally all = {0};
    for (uint32_t c = 0; c < dmg_category_count(); ++c) {
        for (uint64_t seed = 0; seed < SEEDS; ++seed) {
            dmg_asset asset = make(c, seed, seed % 2 ? DMG_MESSY : 0);
            assert_true(asset.object.face_count > 0 && asset.node_count > 0);
            check_faces(&asset);
            check_nodes(&asset);
            check_joints(&asset);
            all.instances += check_instances(&asset);
            count(&asset, &all);
            dmg_asset_release(&asset);
        }
    }
    /* All sorts are there, in shares from which something can be learnt. */
    assert_in_range(all.still, all.assets / 15, all.assets / 5);
    assert_in_range(all.split_bodies, all.assets / 3, all.assets * 4 / 5);
    assert_in_range(all.split_parts, all.parts / 5, all.parts * 3 / 4);
    assert_in_range(all.carried, all.parts / 10, all.parts / 2);
    assert_in_range(all.open, all.parts / 50, all.parts / 3);
    assert_true(all.loose > all.assets / 10 && all.instances > all.assets / 10 && all.empties > all.assets / 10);
    assert_true(all.lone_nodes > 0);
}

/* ---- single steps ---- */

/* A body, a door that carries a knob, and a drawer. */
static dmg_builder* draw_furniture(void) {
    dmg_builder* b = malloc(sizeof *b);
    dmg_builder_init(b, 1, false);
    dmg_box(b, v3(0, 0, 0), v3(1, 1, 1));
    const uint32_t door = dmg_hinge(b, 0, "door", v3(-0.5f, 0, 0.5f), v3(0, 1, 0), 0, 1.5f);
    dmg_box(b, v3(-0.25f, 0, 0.52f), v3(0.5f, 1, 0.04f));
    dmg_spin(b, door, "knob", v3(-0.1f, 0, 0.55f), v3(0, 0, 1));
    dmg_box(b, v3(-0.1f, 0, 0.56f), v3(0.05f, 0.05f, 0.04f));
    dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0, 0.4f);
    dmg_box(b, v3(0.25f, 0, 0.25f), v3(0.5f, 0.2f, 0.5f));
    dmg_use(b, 0);
    return b;
}

static void discard(dmg_builder* b) {
    dmg_builder_free(b);
    free(b);
}

static void welded_parts_become_their_carrier(void** state) {
    (void)state;
    dmg_builder* b = draw_furniture();
    dmg_fate fates[DMG_PART_LIMIT] = {DMG_KEPT, DMG_WELDED, DMG_KEPT};
    dmg_part_fates(b, fates);
    assert_false(b->failed);
    assert_int_equal(b->part_count, 2);
    assert_string_equal(b->parts[1].joint.name, "drawer");
    assert_int_equal(b->piece_count, 4);
    assert_int_equal(b->pieces[2].part, 1); /* the knob is the door's now */
    assert_int_equal(b->face_part[2 * 12], 1);
    assert_int_equal(b->pieces[3].part, 2);
    discard(b);
}

static void dropped_parts_take_along_what_they_carry(void** state) {
    (void)state;
    dmg_builder* b = draw_furniture();
    dmg_fate fates[DMG_PART_LIMIT] = {DMG_DROPPED, DMG_KEPT, DMG_KEPT};
    dmg_part_fates(b, fates);
    assert_false(b->failed);
    assert_int_equal(b->part_count, 1);
    assert_string_equal(b->parts[0].joint.name, "drawer");
    assert_int_equal(b->piece_count, 2);
    assert_int_equal(b->vertex_count, 16);
    assert_int_equal(b->face_count, 24);
    for (uint32_t i = 0; i < 3 * b->face_count; ++i) assert_true(b->indices[i] < b->vertex_count);
    assert_int_equal(b->face_part[12], 1);
    discard(b);
}

/* A ray finds the nearest face; a place on the top looks up, is the body's, and has the way free. */
static void places_are_on_surfaces(void** state) {
    (void)state;
    dmg_builder* b = draw_furniture();
    uint32_t face = 0;
    assert_true(fabsf(dmg_cast(b, v3(0.1f, 2, 0.1f), v3(0, -1, 0), &face) - 1.5f) < 1e-5f);
    assert_int_equal(b->face_part[face], 0);
    dmg_place place;
    for (int i = 0; i < 10; ++i) {
        if (!dmg_find_place(b, true, 0.98f, 1.1f, 0.05f, &place)) continue;
        assert_int_equal(place.part, 0);
        assert_true(fabsf(place.frame.origin.y - 0.5f) < 1e-5f && place.frame.column[2].y > 0.99f);
        assert_true(place.clearance > 1e29f);
    }
    const dmg_bounds before_drawer = {v3(0.2f, -0.05f, 0.6f), v3(0.3f, 0.05f, 0.7f)};
    const dmg_bounds on_top = {v3(-0.1f, 0.51f, -0.1f), v3(0.1f, 0.6f, 0.1f)};
    assert_true(dmg_is_swept(b, 0, &before_drawer));
    assert_false(dmg_is_swept(b, 3, &before_drawer)); /* the drawer takes it along */
    assert_false(dmg_is_swept(b, 0, &on_top));
    discard(b);
}

static void words_are_those_of_the_lexicon(void** state) {
    (void)state;
    const int32_t door = dmg_word_row("door_left_2"), handle = dmg_word_row("door_handle");
    assert_true(door >= 0 && handle >= 0 && door != handle);
    assert_int_equal(dmg_word_row("zzz_3"), -1);
    assert_int_equal(dmg_word_row(""), -1);
    char word[64];
    dmg_copy_word(door, 0, word, sizeof word);
    assert_string_equal(word, "door");
    for (uint32_t i = 0; i < 100; ++i) {
        dmg_copy_word(dmg_part_row(i), i, word, sizeof word);
        assert_true(word[0] != '\0' && strchr(word, ' ') == NULL);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_seed_same_bits),
        cmocka_unit_test(every_asset_is_sound),
        cmocka_unit_test(welded_parts_become_their_carrier),
        cmocka_unit_test(dropped_parts_take_along_what_they_carry),
        cmocka_unit_test(places_are_on_surfaces),
        cmocka_unit_test(words_are_those_of_the_lexicon),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
