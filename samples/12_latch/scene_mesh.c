/* From a scene's shapes to triangles, and to a prepared object. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "scene.h"

enum { ROUND_SIDES = 24, POINTS_A_TOOTH = 4 };
static const float tooth_depth = 0.16f; /* of the radius */
static const float two_pi = 6.2831853f;

static uint32_t add_vertex(scene_mesh* mesh, uint32_t part, float x, float y, float z) {
    const uint32_t v = mesh->vertex_count++;
    mesh->positions[v][0] = x, mesh->positions[v][1] = y, mesh->positions[v][2] = z;
    mesh->parts[v] = (uint8_t)part;
    return v;
}

static void add_triangle(scene_mesh* mesh, uint32_t a, uint32_t b, uint32_t c) {
    uint32_t* to = &mesh->indices[mesh->index_count];
    to[0] = a, to[1] = b, to[2] = c;
    mesh->index_count += 3;
}

static void add_box(scene_mesh* mesh, const scene_shape* shape) {
    static const uint8_t corners[36] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                        2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
    const dm_vec3 l = shape->low, h = shape->high;
    const uint32_t first = mesh->vertex_count;
    for (int v = 0; v < 8; v++) add_vertex(mesh, shape->part, v & 1 ? h.x : l.x, v & 2 ? h.y : l.y, v & 4 ? h.z : l.z);
    for (int i = 0; i < 36; i += 3)
        add_triangle(mesh, first + corners[i], first + corners[i + 1], first + corners[i + 2]);
}

/* Radius of a wheel's point, a share: teeth are two points out and two in. */
static float share_at(const scene_shape* shape, int point) {
    return shape->teeth != ROUND && point % POINTS_A_TOOTH >= POINTS_A_TOOTH / 2 ? 1 - tooth_depth : 1;
}

/* Two rims of points, and a point in the middle of each. */
static void add_wheel(scene_mesh* mesh, const scene_shape* shape) {
    const dm_vec3 l = shape->low, h = shape->high;
    const float x = (l.x + h.x) / 2, y = (l.y + h.y) / 2, radius = (h.x - l.x) / 2;
    const int points = shape->teeth != ROUND ? POINTS_A_TOOTH * shape->teeth : ROUND_SIDES;
    const uint32_t back = add_vertex(mesh, shape->part, x, y, l.z), front = add_vertex(mesh, shape->part, x, y, h.z);
    for (int i = 0; i < points; i++) {
        const float angle = two_pi * (float)i / (float)points, r = radius * share_at(shape, i);
        add_vertex(mesh, shape->part, x + r * cosf(angle), y + r * sinf(angle), l.z);
        add_vertex(mesh, shape->part, x + r * cosf(angle), y + r * sinf(angle), h.z);
    }
    for (int i = 0; i < points; i++) {
        const uint32_t a = front + 1 + 2 * (uint32_t)i, b = front + 1 + 2 * (uint32_t)((i + 1) % points);
        add_triangle(mesh, back, b, a);
        add_triangle(mesh, front, a + 1, b + 1);
        add_triangle(mesh, a, b, b + 1);
        add_triangle(mesh, a, b + 1, a + 1);
    }
}

void scene_mesh_make(const scene* scene, scene_mesh* out) {
    memset(out, 0, sizeof *out);
    for (uint32_t part = 0; part <= scene->part_count; part++) {
        out->first_vertex[part] = out->vertex_count, out->first_index[part] = out->index_count;
        for (uint32_t i = 0; i < scene->shape_count; i++) {
            const scene_shape* shape = &scene->shapes[i];
            if (shape->part != part) continue;
            if (shape->teeth != NO_WHEEL)
                add_wheel(out, shape);
            else
                add_box(out, shape);
        }
    }
    out->first_vertex[scene->part_count + 1] = out->vertex_count;
    out->first_index[scene->part_count + 1] = out->index_count;
}

dm_mesh_desc scene_mesh_desc(const scene_mesh* mesh) {
    dm_mesh_desc desc = dm_mesh_desc_default();
    desc.positions = mesh->positions, desc.vertex_count = mesh->vertex_count;
    desc.indices = mesh->indices, desc.index_count = mesh->index_count;
    desc.part_ids = mesh->parts, desc.part_id_bytes = mesh->vertex_count, desc.part_id_format = DM_UINT8;
    return desc;
}

dm_result scene_equip(const scene* scene, dm_context* context, dm_object object) {
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < scene->part_count && result == DM_OK; i++) {
        dm_joint joint = scene->parts[i].joint;
        joint.struct_size = sizeof joint;
        result = dm_object_set_joint(context, object, i + 1, &joint);
    }
    return result == DM_OK ? dm_object_set_links(context, object, scene->links, scene->link_count) : result;
}

dm_result scene_prepare(const scene* scene, dm_context* context, const dm_mesh_desc* mesh, dm_object* out_object) {
    dm_part_desc parts[SCENE_PARTS];
    for (uint32_t i = 0; i < scene->part_count; i++) {
        parts[i] = dm_part_desc_default();
        parts[i].id = i + 1, parts[i].parent = scene->parts[i].parent;
    }
    dm_object_desc desc = dm_object_desc_default();
    desc.mesh = mesh, desc.parts = parts, desc.part_count = scene->part_count;
    const dm_result result = dm_object_prepare(context, &desc, out_object);
    return result == DM_OK ? scene_equip(scene, context, *out_object) : result;
}

const scene* scene_at(uint32_t index) {
    static const scene* const all[SCENE_COUNT] = {&scene_house_door,   &scene_double_door, &scene_safe,
                                                  &scene_drawers,      &scene_hatch,       &scene_gears,
                                                  &scene_blocked_door, &scene_two_hands};
    return index < SCENE_COUNT ? all[index] : NULL;
}

const scene* scene_find(const char* name) {
    for (uint32_t i = 0; i < SCENE_COUNT; i++)
        if (strcmp(scene_at(i)->name, name) == 0) return scene_at(i);
    return NULL;
}
