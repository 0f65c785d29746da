/* Implements the generator's public interface: makes objects of a category, and drags on them. */
#include "generator.h"

#include <stdlib.h>
#include <string.h>

#include "categories.h"
#include "core/make.h"

typedef struct category {
    const char* name;
    uint32_t id;
    int32_t set; /* DMG_SET_* */
    void (*build)(dmg_builder* b);
} category;

#define DMG_ROW(name, id, set) {#name, id, DMG_SET_##set, dmg_build_##name},
static const category categories[] = {DMG_CATEGORIES(DMG_ROW)};
#undef DMG_ROW

enum { CATEGORY_COUNT = sizeof categories / sizeof *categories };

uint32_t dmg_category_count(void) {
    return CATEGORY_COUNT;
}

const char* dmg_category_name(uint32_t row) {
    return row < CATEGORY_COUNT ? categories[row].name : NULL;
}

uint32_t dmg_category_id(uint32_t row) {
    return row < CATEGORY_COUNT ? categories[row].id : UINT32_MAX;
}

int32_t dmg_category_set(uint32_t row) {
    return row < CATEGORY_COUNT ? categories[row].set : -1;
}

int32_t dmg_category_find(const char* name) {
    for (int32_t i = 0; i < CATEGORY_COUNT; ++i) {
        if (strcmp(categories[i].name, name) == 0) return i;
    }
    return -1;
}

int32_t dmg_category_with_id(uint32_t id) {
    for (int32_t i = 0; i < CATEGORY_COUNT; ++i) {
        if (categories[i].id == id) return i;
    }
    return -1;
}

uint32_t dmg_category_id_limit(void) {
    uint32_t limit = 0;
    for (int32_t i = 0; i < CATEGORY_COUNT; ++i) {
        if (categories[i].id >= limit) limit = categories[i].id + 1;
    }
    return limit;
}

int32_t dmg_split(uint32_t category, uint64_t seed) {
    /* SplitMix64's finaliser over the seed and the id. */
    uint64_t x = seed * 0x9e3779b97f4a7c15u + dmg_category_id(category) + 0x2545f4914f6cdd1du;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    const uint64_t slot = (x ^ (x >> 31)) % 20;
    return slot == 0 ? DMG_SPLIT_VALIDATION : slot == 1 ? DMG_SPLIT_TEST : DMG_SPLIT_TRAIN;
}

/* ---- making an object ---- */

/* Sets the origin of slides, which have no line of their own, to the centre of the part's box. */
static void centre_slides(const dmg_builder* b, dmg_object* object) {
    for (uint32_t j = 0; j < object->joint_count; ++j) {
        if (object->joints[j].type != DM_JOINT_PRISMATIC) continue;
        float low[3] = {1e30f, 1e30f, 1e30f}, high[3] = {-1e30f, -1e30f, -1e30f};
        for (uint32_t i = 0; i < 3 * b->face_count; ++i) {
            if (b->face_part[i / 3] != j + 1) continue;
            const float* p = &b->vertices[b->indices[i]].x;
            for (int k = 0; k < 3; ++k) {
                low[k] = fminf(low[k], p[k]);
                high[k] = fmaxf(high[k], p[k]);
            }
        }
        for (int k = 0; k < 3; ++k) object->joints[j].origin[k] = 0.5f * (low[k] + high[k]);
    }
}

/* Copies the mesh without unused vertices. soup: every corner gets a vertex of its own. */
static int copy_mesh(const dmg_builder* b, dmg_object* object, bool soup) {
    uint32_t corners = 3 * b->face_count, capacity = soup ? corners : b->vertex_count;
    uint32_t* remap = malloc((b->vertex_count + 1) * sizeof *remap);
    object->positions = malloc(((size_t)capacity * 3 + 1) * sizeof *object->positions);
    object->indices = malloc((corners + 1) * sizeof *object->indices);
    object->face_part = malloc((b->face_count + 1) * sizeof *object->face_part);
    object->joints = calloc(b->part_count + 1, sizeof *object->joints);
    if (!remap || !object->positions || !object->indices || !object->face_part || !object->joints) {
        free(remap);
        return 1;
    }
    memset(remap, 0xff, b->vertex_count * sizeof *remap);
    for (uint32_t i = 0; i < corners; ++i) {
        uint32_t v = b->indices[i];
        if (soup || remap[v] == UINT32_MAX) {
            memcpy(object->positions + (size_t)object->vertex_count * 3, &b->vertices[v], 3 * sizeof(float));
            remap[v] = object->vertex_count++;
        }
        object->indices[i] = remap[v];
    }
    memcpy(object->face_part, b->face_part, b->face_count * sizeof *object->face_part);
    for (uint32_t i = 0; i < b->part_count; ++i) object->joints[i] = b->parts[i].joint;
    object->face_count = b->face_count;
    object->joint_count = b->part_count;
    free(remap);
    return 0;
}

void dmg_draw_category(dmg_builder* b, uint32_t category, uint64_t seed, uint32_t flags) {
    dmg_builder_init(b, seed * 0x2545f4914f6cdd1dull + categories[category].id * 0x9e3779b9ull + flags,
                     (flags & DMG_MESSY) != 0);
    categories[category].build(b);
}

int dmg_take_object(dmg_builder* b, uint32_t category, bool soup, dmg_object* out_object) {
    dmg_object object = {.category = categories[category].name};
    if (b->failed || copy_mesh(b, &object, soup)) {
        dmg_object_release(&object);
        return 1;
    }
    centre_slides(b, &object);
    *out_object = object;
    return 0;
}

int dmg_make(uint32_t category, uint64_t seed, uint32_t flags, dmg_object* out_object) {
    if (category >= CATEGORY_COUNT) return 1;
    dmg_builder* b = malloc(sizeof *b);
    if (!b) return 1;
    dmg_draw_category(b, category, seed, flags);
    dmg_finish(b);
    const bool soup = b->messy && dmg_chance(b, 0.15f);
    const int failed = dmg_take_object(b, category, soup, out_object);
    dmg_builder_free(b);
    free(b);
    return failed;
}

void dmg_object_release(dmg_object* object) {
    free(object->positions);
    free(object->indices);
    free(object->face_part);
    free(object->joints);
    memset(object, 0, sizeof *object);
}

/* ---- drags ---- */

static dmg_vec corner(const dmg_object* object, uint32_t face, int k) {
    const float* p = object->positions + (size_t)object->indices[(size_t)face * 3 + (size_t)k] * 3;
    return v3_from(p);
}

static float face_area(const dmg_object* object, uint32_t face) {
    dmg_vec a = corner(object, face, 0);
    return 0.5f * v3_length(v3_cross(v3_sub(corner(object, face, 1), a), v3_sub(corner(object, face, 2), a)));
}

/* Returns whether `carrier` is the part or carries it: grabbing what a part carries moves the part too. */
static bool moves_with(const dmg_object* object, uint32_t part, uint32_t carrier) {
    while (part != 0 && part != carrier) part = object->joints[part - 1].parent;
    return part == carrier;
}

float dmg_object_size(const dmg_object* object) {
    float size = 0.0f;
    for (int k = 0; k < 3; ++k) {
        float low = 1e30f, high = -1e30f;
        for (uint32_t v = 0; v < object->vertex_count; ++v) {
            low = fminf(low, object->positions[(size_t)v * 3 + (size_t)k]);
            high = fmaxf(high, object->positions[(size_t)v * 3 + (size_t)k]);
        }
        size = fmaxf(size, high - low);
    }
    return size;
}

static float distance_to_axis(const dmg_joint* joint, dmg_vec p) {
    dmg_vec axis = v3_from(joint->axis);
    dmg_vec from = v3_sub(p, v3_from(joint->origin));
    return v3_length(v3_cross(axis, from));
}

/* Returns a random point of the face in which the running sum of areas passes `target`. */
static dmg_vec point_at_area(const dmg_object* object, const bool* moves, float target, dmg_builder* b) {
    uint32_t hit = 0;
    for (uint32_t f = 0; f < object->face_count && target >= 0.0f; ++f) {
        if (!moves[object->face_part[f]]) continue;
        hit = f;
        target -= face_area(object, f);
    }
    float u = dmg_unit(b), w = dmg_unit(b);
    if (u + w > 1.0f) {
        u = 1.0f - u;
        w = 1.0f - w;
    }
    dmg_vec a = corner(object, hit, 0);
    return v3_mad(v3_mad(a, v3_sub(corner(object, hit, 1), a), u), v3_sub(corner(object, hit, 2), a), w);
}

static dmg_vec grab_point(const dmg_object* object, uint32_t part, dmg_builder* b) {
    enum { ATTEMPTS = 32 };
    const dmg_joint* joint = &object->joints[part - 1];
    bool moves[DMG_PART_LIMIT + 1];
    for (uint32_t i = 0; i <= object->joint_count; ++i) moves[i] = moves_with(object, i, part);
    float area = 0.0f, farthest = 0.0f, best_distance = -1.0f;
    for (uint32_t f = 0; f < object->face_count; ++f) {
        if (!moves[object->face_part[f]]) continue;
        area += face_area(object, f);
        for (int k = 0; k < 3; ++k) farthest = fmaxf(farthest, distance_to_axis(joint, corner(object, f, k)));
    }
    dmg_vec best = {0, 0, 0};
    for (int i = 0; i < ATTEMPTS; ++i) {
        dmg_vec p = point_at_area(object, moves, area * dmg_unit(b), b);
        float distance = distance_to_axis(joint, p);
        if (joint->type == DM_JOINT_PRISMATIC || distance >= 0.3f * farthest) return p;
        if (distance > best_distance) best = p;
        best_distance = fmaxf(best_distance, distance);
    }
    return best;
}

void dmg_drag(const dmg_object* object, uint32_t part, float noise_degrees, uint64_t seed, float out_point[3],
              float out_vector[3]) {
    dmg_builder b = {.random_state = seed * 0x9e3779b97f4a7c15ull + part};
    dmg_random(&b);
    dmg_random(&b);
    const dmg_joint* joint = &object->joints[part - 1];
    dmg_vec axis = v3_from(joint->axis);
    dmg_vec origin = v3_from(joint->origin);
    dmg_vec p = grab_point(object, part, &b), direction = axis;
    if (joint->type != DM_JOINT_PRISMATIC) {
        direction = v3_cross(axis, v3_sub(p, origin));
        if (joint->type == DM_JOINT_SCREW) direction = v3_mad(direction, axis, joint->pitch);
    }
    direction = v3_scale(v3_normalize(direction), (float)joint->opens);
    dmg_vec u, w;
    v3_basis(direction, &u, &w);
    float off = fabsf(dmg_normal(&b)) * noise_degrees * DMG_PI / 180.0f, round = dmg_range(&b, 0, 2.0f * DMG_PI);
    dmg_vec sideways = v3_add(v3_scale(u, cosf(round)), v3_scale(w, sinf(round)));
    direction = v3_add(v3_scale(direction, cosf(off)), v3_scale(sideways, sinf(off)));
    float length = dmg_object_size(object) * dmg_scale_range(&b, 0.02f, 0.5f);
    memcpy(out_point, &p, sizeof p);
    direction = v3_scale(direction, length);
    memcpy(out_vector, &direction, sizeof direction);
}
