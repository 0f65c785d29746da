/* The prepared object: memory, queries, the check of drags, and the triangles that it keeps. */
#include "kinematics/object/object.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/sort.h"
#include "math/elementary.h"
#include "math/linear3.h"
#include "pick/backend.h"

#define MAX_DRAG_DISTANCE 0.5f /* object sizes from the part's box to a drag's point; by hand */
#define MIN_DRAG_LENGTH 1e-12  /* object sizes, of a drag's vector; by hand */
#define MAX_DRAG_LENGTH 1e12   /* object sizes, of a drag's vector; by hand */

enum { BOX_CORNERS = 8 };

dm_result dmi_object_create(dmi_env* env, uint32_t part_count, dmi_object** out_object) {
    dmi_object* object = dmi_alloc_zeroed(env, sizeof *object, _Alignof(dmi_object));
    if (object == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "object: no memory");
    object->part_count = part_count;
    object->parts = dmi_alloc_zeroed(env, part_count * sizeof *object->parts, _Alignof(dmi_object_part));
    if (object->parts == NULL) {
        dmi_object_destroy(env, object);
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "object: no memory for %u parts", part_count - 1);
    }
    *out_object = object;
    return DM_OK;
}

void dmi_object_destroy(dmi_env* env, dmi_object* object) {
    if (object == NULL) return;
    dmi_object_drop_triangles(env, object);
    dmi_free(env, object->parts, object->part_count * sizeof *object->parts);
    dmi_free(env, object, sizeof *object);
}

void dmi_object_drop_triangles(dmi_env* env, dmi_object* object) {
    dmi_bvh_destroy(object->bvh);
    dmi_packed_mesh_destroy(env, object->mesh);
    object->bvh = NULL;
    object->mesh = NULL;
}

int32_t dmi_object_find_part(const dmi_object* object, uint32_t id) {
    return dmi_find_id(&object->parts->shape.id, sizeof *object->parts, object->part_count, id);
}

bool dmi_object_moves_with(const dmi_object* object, uint32_t index, uint32_t ancestor) {
    while (index != ancestor && index != 0) index = object->parts[index].shape.parent;
    return index == ancestor;
}

void dmi_object_bound(dmi_object* object) {
    for (int k = 0; k < 3; k++) {
        object->box_min[k] = INFINITY;
        object->box_max[k] = -INFINITY;
        for (uint32_t i = 0; i < object->part_count; i++) {
            if (object->parts[i].shape.face_count == 0) continue; /* there is no body */
            object->box_min[k] = dmi_fminf(object->box_min[k], object->parts[i].shape.box_min[k]);
            object->box_max[k] = dmi_fmaxf(object->box_max[k], object->parts[i].shape.box_max[k]);
        }
    }
}

void dmi_object_box_out(const dmi_frame* frame, const float min[3], const float max[3], dm_vec3* out_min,
                        dm_vec3* out_max) {
    for (int corner = 0; corner < BOX_CORNERS; corner++) {
        float inner[3];
        for (int k = 0; k < 3; k++) inner[k] = corner >> k & 1 ? max[k] : min[k];
        float host[3];
        dmi_frame_point_out(frame, inner, host);
        const dm_vec3 p = {host[0], host[1], host[2]};
        if (corner == 0) *out_min = *out_max = p;
        *out_min = (dm_vec3){dmi_fminf(out_min->x, p.x), dmi_fminf(out_min->y, p.y), dmi_fminf(out_min->z, p.z)};
        *out_max = (dm_vec3){dmi_fmaxf(out_max->x, p.x), dmi_fmaxf(out_max->y, p.y), dmi_fmaxf(out_max->z, p.z)};
    }
}

dm_part_info dmi_object_part_out(const dmi_object* object, uint32_t index) {
    const dmi_part* shape = &object->parts[index].shape;
    const float length = dmi_frame_length_out(&object->frame);
    float centre[3];
    dmi_frame_point_out(&object->frame, shape->centre, centre);
    dm_part_info info = {.struct_size = sizeof info,
                         .id = shape->id,
                         .parent = object->parts[shape->parent].shape.id,
                         .triangle_count = shape->face_count,
                         .centre = dmi_vec3(centre),
                         .area = dmi_fminf(shape->area * length * length, FLT_MAX)};
    dmi_object_box_out(&object->frame, shape->box_min, shape->box_max, &info.box_min, &info.box_max);
    return info;
}

/* Returns 0 inside the box. */
static float distance_to_box(const dmi_part* shape, const float point[3]) {
    float square = 0.0f;
    for (int i = 0; i < 3; i++) {
        float outside = dmi_fmaxf(dmi_fmaxf(shape->box_min[i] - point[i], point[i] - shape->box_max[i]), 0.0f);
        square += outside * outside;
    }
    return sqrtf(square);
}

/* Returns the distance to the nearest box of the part and its descendants: a door is also pulled by its handle. */
static float distance_to_part(const dmi_object* object, uint32_t part, const float point[3]) {
    float nearest = INFINITY;
    for (uint32_t i = 1; i < object->part_count; i++) {
        if (dmi_object_moves_with(object, i, part)) {
            nearest = dmi_fminf(nearest, distance_to_box(&object->parts[i].shape, point));
        }
    }
    return nearest;
}

dm_result dmi_object_hint(dmi_env* env, const char* what, const dmi_object* object, uint32_t part,
                          const dm_drag_hint* drag, dmi_drag_hint* out_hint) {
    const double point[3] = {drag->point.x, drag->point.y, drag->point.z};
    const float vector[3] = {drag->vector.x, drag->vector.y, drag->vector.z};
    for (int i = 0; i < 3; i++) {
        if (!isfinite(point[i])) return dmi_fail(env, DM_ERROR_NOT_FINITE, "%s.point[%d] is %g", what, i, point[i]);
        if (!isfinite(vector[i])) {
            return dmi_fail(env, DM_ERROR_NOT_FINITE, "%s.vector[%d] is %g", what, i, (double)vector[i]);
        }
    }
    dmi_drag_hint hint;
    dmi_frame_point_in(&object->frame, point, hint.point);
    dmi_frame_vector_in(&object->frame, vector, hint.vector);
    double length = sqrt((double)hint.vector[0] * hint.vector[0] + (double)hint.vector[1] * hint.vector[1] +
                         (double)hint.vector[2] * hint.vector[2]);
    if (!(length > MIN_DRAG_LENGTH && length < MAX_DRAG_LENGTH)) {
        return dmi_fail(env, DM_ERROR_ZERO_DRAG, "%s.vector is %g object sizes long", what, length);
    }
    float distance = distance_to_part(object, part, hint.point);
    if (!(distance <= MAX_DRAG_DISTANCE)) {
        return dmi_fail(env, DM_ERROR_DRAG_OFF_PART, "%s.point (%g, %g, %g) is %g object sizes away from part %u", what,
                        point[0], point[1], point[2], (double)distance, object->parts[part].shape.id);
    }
    *out_hint = hint;
    return DM_OK;
}

/* ---- triangles and trees ---- */

static dmi_bvh_source source_of(const dmi_object* object, const dmi_tree_shape* shapes) {
    return (dmi_bvh_source){
        .mesh = object->mesh, .ids = {&object->parts->shape.id, sizeof *object->parts}, .shapes = shapes};
}

dm_result dmi_object_pack(dmi_env* env, const dmi_unpacked* from, bool wide, const dmi_progress* progress,
                          dmi_object* object) {
    return dmi_packed_mesh_create(env, from, wide, progress, &object->mesh);
}

dm_result dmi_object_make_trees(dmi_picker* picker, const dmi_tree_shape* shapes, const dmi_progress* progress,
                                dmi_object* object) {
    const dmi_bvh_source source = source_of(object, shapes);
    return dmi_bvh_create(picker, &source, progress, &object->bvh);
}

dm_result dmi_object_unpack(dmi_env* env, const dmi_object* object, const dmi_progress* progress, dmi_mesh** out_mesh) {
    const dmi_packed_mesh* packed = object->mesh;
    dmi_mesh* mesh = NULL;
    dm_result result =
        dmi_mesh_restore(env, &object->frame, packed->vertex_count, packed->face_count, packed->part_count, &mesh);
    if (result != DM_OK) return result;
    dmi_packed_mesh_unpack(packed, mesh);
    for (uint32_t i = 0; i < packed->part_count; i++) {
        mesh->parts[i].id = object->parts[i].shape.id;
        mesh->parts[i].parent = object->parts[i].shape.parent;
        mesh->parts[i].face_count = packed->parts[i].face_count;
    }
    result = dmi_mesh_measure(env, progress, mesh);
    if (result != DM_OK) {
        dmi_mesh_destroy(env, mesh);
        return result;
    }
    *out_mesh = mesh;
    return DM_OK;
}

dm_result dmi_object_stored_trees(dmi_env* env, const dmi_object* object, const dmi_bvh** out_trees,
                                  dmi_bvh** out_made) {
    dmi_tree_shape shape;
    *out_trees = *out_made = NULL;
    if (object->mesh == NULL) return DM_OK;
    if (dmi_bvh_shapes(object->bvh, 0, &shape)) {
        *out_trees = object->bvh;
        return DM_OK;
    }
    const dmi_bvh_source source = source_of(object, NULL);
    const dm_result result = dmi_bvh_create_to_store(env, &source, out_made);
    *out_trees = *out_made;
    return result;
}
