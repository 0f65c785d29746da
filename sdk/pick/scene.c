/* Instances of objects: one Embree instance for each part over the part's own hierarchy, moved by its matrix.
 *
 * A move only stores the pose. Commit computes the matrices and rebuilds the small top level, so picks between a move
 * and the commit see the scene as it was. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "pick/bvh.h"

#include "math/vec3.h"

#define FIRST_CAPACITY 16 /* instances; doubles when full */
/* Bounds of the next three, host units: Embree takes coordinates up to 1.8e18, also in the frame of an instance, where
 * they are divided by its object's size; Debian's build aborts on larger ones. */
#define MAX_COORDINATE 1e10  /* of ray origins and translations */
#define MIN_OBJECT_SIZE 1e-6 /* largest side */
#define MAX_OBJECT_SIZE 1e12

typedef struct placed_object placed_object;

typedef struct placed_part {
    const placed_object* owner;
    RTCGeometry geometry;
    uint32_t geometry_id; /* in the top level, when attached */
    dm_pose pose;         /* from rest, object frame */
    bool moved;           /* since the last commit */
    uint32_t part;
    double to_object[12], to_world[12]; /* from the object-normalised frame, as committed; 3x4, column-major */
} placed_part;

struct placed_object {
    placed_object* next_dirty;
    const dmi_bvh* bvh;
    dmi_frame frame;
    dm_object object;
    dm_pose placement;
    uint32_t id;
    bool dirty;          /* in the scene's list */
    bool moved;          /* placement, since the last commit */
    bool attached;       /* to the top level */
    placed_part parts[]; /* of bvh */
};

struct dmi_scene {
    dmi_picker* picker;
    RTCScene top;
    placed_object** objects; /* by instance id; NULL where removed */
    uint32_t capacity;
    placed_object* dirty;
};

/* ---- matrices: 3x4, column-major, doubles so that objects far from the origin keep their shape ---- */

static void pose_matrix(const dm_pose* pose, double out[12]) {
    double x = (double)pose->real[0], y = (double)pose->real[1], z = (double)pose->real[2], w = (double)pose->real[3];
    double a = (double)pose->dual[0], b = (double)pose->dual[1], c = (double)pose->dual[2], d = (double)pose->dual[3];
    const double columns[12] = {
        1 - 2 * (y * y + z * z),
        2 * (x * y + w * z),
        2 * (x * z - w * y),
        2 * (x * y - w * z),
        1 - 2 * (x * x + z * z),
        2 * (y * z + w * x),
        2 * (x * z + w * y),
        2 * (y * z - w * x),
        1 - 2 * (x * x + y * y),
        2 * (w * a - d * x + y * c - z * b),
        2 * (w * b - d * y + z * a - x * c),
        2 * (w * c - d * z + x * b - y * a),
    };
    memcpy(out, columns, sizeof columns);
}

static void apply(const double m[12], const double p[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = m[i] * p[0] + m[3 + i] * p[1] + m[6 + i] * p[2] + m[9 + i];
}

/* Applies the matrix without its translation. */
static void apply_linear(const double m[12], const double direction[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = m[i] * direction[0] + m[3 + i] * direction[1] + m[6 + i] * direction[2];
}

static void multiply(const double a[12], const double b[12], double out[12]) {
    for (int column = 0; column < 3; column++) apply_linear(a, b + 3 * column, out + 3 * column);
    apply(a, b + 9, out + 9);
}

/* ---- placed objects ---- */

static size_t placed_size(const dmi_bvh* bvh) {
    return sizeof(placed_object) + bvh->part_count * sizeof(placed_part);
}

static void mark_dirty(dmi_scene* scene, placed_object* placed) {
    if (placed->dirty) return;
    placed->dirty = true;
    placed->next_dirty = scene->dirty;
    scene->dirty = placed;
}

static void unmark_dirty(dmi_scene* scene, const placed_object* placed) {
    placed_object** link = &scene->dirty;
    while (*link != NULL && *link != placed) link = &(*link)->next_dirty;
    if (*link != NULL) *link = placed->next_dirty;
}

static void release_placed(dmi_env* env, placed_object* placed) {
    for (uint32_t p = 0; p < placed->bvh->part_count; p++) {
        if (placed->parts[p].geometry != NULL) rtcReleaseGeometry(placed->parts[p].geometry);
    }
    dmi_free(env, placed, placed_size(placed->bvh));
}

static dm_result grow(dmi_scene* scene) {
    dmi_env* env = scene->picker->env;
    uint32_t capacity = scene->capacity > 0 ? 2 * scene->capacity : FIRST_CAPACITY;
    placed_object** objects = dmi_alloc_zeroed(env, capacity * sizeof(placed_object*), DMI_ALIGNMENT);
    if (objects == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u instances", capacity);
    if (scene->capacity > 0) memcpy(objects, scene->objects, scene->capacity * sizeof(placed_object*));
    dmi_free(env, scene->objects, scene->capacity * sizeof(placed_object*));
    scene->objects = objects;
    scene->capacity = capacity;
    return DM_OK;
}

static dm_result make_parts(dmi_picker* picker, placed_object* placed) {
    for (uint32_t p = 0; p < placed->bvh->part_count; p++) {
        placed_part* part = &placed->parts[p];
        part->owner = placed;
        part->part = p;
        part->pose = dmi_pose_identity();
        part->geometry = rtcNewGeometry(picker->device, RTC_GEOMETRY_TYPE_INSTANCE);
        if (part->geometry == NULL) break;
        rtcSetGeometryInstancedScene(part->geometry, placed->bvh->parts[p].scene);
        rtcSetGeometryUserData(part->geometry, part);
    }
    return dmi_picker_status(picker);
}

/* Normalises a pose and checks that its translation is within the bounds. */
static dm_result check_pose(dmi_env* env, const dm_pose* pose, dm_pose* out) {
    float t[3];
    *out = dmi_pose_normalize(pose);
    dmi_pose_translation(out, t);
    if (fabs((double)t[0]) <= MAX_COORDINATE && fabs((double)t[1]) <= MAX_COORDINATE &&
        fabs((double)t[2]) <= MAX_COORDINATE)
        return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "scene: a pose by (%g, %g, %g), must be within %g units",
                    (double)t[0], (double)t[1], (double)t[2], MAX_COORDINATE);
}

static dm_result check_size(dmi_env* env, const dmi_frame* frame) {
    double size = (double)dmi_frame_length_out(frame);
    if (size >= MIN_OBJECT_SIZE && size <= MAX_OBJECT_SIZE) return DM_OK;
    return dmi_fail(env, DM_ERROR_UNSUPPORTED, "scene: an object %g units large, can pick those of %g to %g", size,
                    MIN_OBJECT_SIZE, MAX_OBJECT_SIZE);
}

static dm_result make_placed(dmi_scene* scene, const dmi_bvh* bvh, const dmi_frame* frame, dm_object object,
                             const dm_pose* placement, placed_object** out_placed) {
    dmi_env* env = scene->picker->env;
    placed_object* placed = dmi_alloc_zeroed(env, placed_size(bvh), DMI_ALIGNMENT);
    if (placed == NULL) {
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for an instance of %u parts", bvh->part_count);
    }
    placed->bvh = bvh;
    placed->frame = *frame;
    placed->object = object;
    placed->placement = *placement;
    placed->moved = true;
    dm_result result = make_parts(scene->picker, placed);
    if (result != DM_OK) {
        release_placed(env, placed);
        return result;
    }
    *out_placed = placed;
    return DM_OK;
}

dm_result dmi_scene_add(dmi_scene* scene, const dmi_bvh* bvh, const dmi_frame* frame, dm_object object,
                        const dm_pose* host_placement, uint32_t* out_instance) {
    dmi_env* env = scene->picker->env;
    placed_object* placed = NULL;
    dm_pose placement;
    uint32_t id = 0;
    dm_result result = check_size(env, frame);
    if (result == DM_OK) result = check_pose(env, host_placement, &placement);
    if (result != DM_OK) return result;
    while (id < scene->capacity && scene->objects[id] != NULL) id++;
    if (id == scene->capacity) result = grow(scene);
    if (result == DM_OK) result = make_placed(scene, bvh, frame, object, &placement, &placed);
    if (result != DM_OK) return result;
    placed->id = id;
    scene->objects[id] = placed;
    mark_dirty(scene, placed);
    *out_instance = id;
    return DM_OK;
}

static placed_object* find_placed(const dmi_scene* scene, uint32_t instance) {
    return instance < scene->capacity ? scene->objects[instance] : NULL;
}

dm_result dmi_scene_move(dmi_scene* scene, uint32_t instance, uint32_t part_id, const dm_pose* host_pose) {
    dmi_env* env = scene->picker->env;
    placed_object* placed = find_placed(scene, instance);
    if (placed == NULL) return dmi_fail(env, DM_ERROR_NOT_FOUND, "scene: no instance %u", instance);
    int32_t part = dmi_bvh_find_part(placed->bvh, part_id);
    if (part < 0) return dmi_fail(env, DM_ERROR_NOT_FOUND, "scene: instance %u has no part %u", instance, part_id);
    dm_pose pose;
    dm_result result = check_pose(env, host_pose, &pose);
    if (result != DM_OK) return result;
    if (part == 0) {
        placed->placement = pose;
        placed->moved = true;
    } else {
        placed->parts[part].pose = pose;
        placed->parts[part].moved = true;
    }
    mark_dirty(scene, placed);
    return DM_OK;
}

dm_result dmi_scene_remove(dmi_scene* scene, uint32_t instance) {
    placed_object* placed = find_placed(scene, instance);
    if (placed == NULL) return dmi_fail(scene->picker->env, DM_ERROR_NOT_FOUND, "scene: no instance %u", instance);
    scene->objects[instance] = NULL;
    if (placed->dirty) unmark_dirty(scene, placed);
    if (placed->attached) {
        for (uint32_t p = 0; p < placed->bvh->part_count; p++)
            rtcDetachGeometry(scene->top, placed->parts[p].geometry_id);
        dmi_picker_commit(scene->picker, scene->top);
    }
    release_placed(scene->picker->env, placed);
    return DM_OK;
}

/* ---- commit ---- */

static void place_part(placed_part* part, const double placement[12], const double from_inner[12]) {
    double pose[12];
    float transform[12];
    pose_matrix(&part->pose, pose);
    multiply(pose, from_inner, part->to_object);
    multiply(placement, part->to_object, part->to_world);
    for (int i = 0; i < 12; i++) transform[i] = (float)part->to_world[i];
    rtcSetGeometryTransform(part->geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, transform);
    rtcCommitGeometry(part->geometry);
    part->moved = false;
}

static void update_placed(dmi_scene* scene, placed_object* placed) {
    double placement[12], from_inner[12];
    pose_matrix(&placed->placement, placement);
    dmi_frame_matrix_out(&placed->frame, from_inner);
    for (uint32_t p = 0; p < placed->bvh->part_count; p++) {
        placed_part* part = &placed->parts[p];
        if (placed->moved || part->moved) place_part(part, placement, from_inner);
        if (!placed->attached) part->geometry_id = rtcAttachGeometry(scene->top, part->geometry);
    }
    placed->attached = true;
    placed->moved = false;
    placed->dirty = false;
}

void dmi_scene_commit(dmi_scene* scene) {
    if (scene->dirty == NULL) return;
    while (scene->dirty != NULL) {
        placed_object* placed = scene->dirty;
        scene->dirty = placed->next_dirty;
        update_placed(scene, placed);
    }
    dmi_picker_commit(scene->picker, scene->top);
}

/* ---- pick ---- */

/* Returns a x b, unit; the direction against the ray where the triangle has no area. */
static dm_vec3 edge_normal(const double a[3], const double b[3], const double direction[3]) {
    double n[3];
    for (int k = 0; k < 3; k++) n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; k++) n[k] = length > 0 ? n[k] / length : -direction[k];
    return dmi_vec3_f64(n);
}

/* Computes the hit from the triangle's corners, not along the ray: exact on the surface at any distance. */
static void describe_hit(const placed_part* part, const struct RTCHit* hit, const double origin[3],
                         const double direction[3], dm_hit* out) {
    const dmi_bvh* bvh = part->owner->bvh;
    const float* corners[3];
    dmi_bvh_corners(bvh, part->part, hit->primID, corners);
    double edges[2][3], inner[3], object[3], world[3], world_edges[2][3], distance = 0;
    for (int k = 0; k < 3; k++) {
        const double corner = (double)corners[0][k];
        for (int i = 0; i < 2; i++) edges[i][k] = (double)corners[i + 1][k] - corner;
        inner[k] = corner + (double)hit->u * edges[0][k] + (double)hit->v * edges[1][k];
    }
    apply(part->to_object, inner, object);
    apply(part->to_world, inner, world);
    for (int i = 0; i < 2; i++) apply_linear(part->to_world, edges[i], world_edges[i]);
    for (int k = 0; k < 3; k++) distance += (world[k] - origin[k]) * direction[k];
    *out = (dm_hit){.object = part->owner->object,
                    .instance = part->owner->id,
                    .part_id = bvh->parts[part->part].id,
                    .triangle = bvh->faces[bvh->parts[part->part].first_face + hit->primID],
                    .distance = (float)distance,
                    .u = hit->u,
                    .v = hit->v,
                    .point = dmi_vec3_f64(world),
                    .normal = edge_normal(world_edges[0], world_edges[1], direction),
                    .object_point = dmi_vec3_f64(object)};
}

void dmi_scene_pick(const dmi_scene* scene, const dm_ray* host_ray, dm_hit* out_hit) {
    const dmi_double3 origin = dmi_xyz_f64(host_ray->origin);
    dmi_double3 direction = dmi_xyz_f64(host_ray->direction);
    const double* d = direction.v;
    const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    *out_hit = (dm_hit){0};
    if (!(length > 0) || isinf(length)) return; /* NaN too, here and below */
    for (int k = 0; k < 3; k++) {
        direction.v[k] /= length;
        if (!(fabs(origin.v[k]) <= MAX_COORDINATE)) return;
    }
    const dmi_float3 along = dmi_xyz(dmi_vec3_f64(direction.v));
    struct RTCRayHit ray = dmi_embree_ray(dmi_xyz(host_ray->origin).v, along.v, INFINITY);
    dmi_embree_intersect(scene->top, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    const placed_part* part = rtcGetGeometryUserData(rtcGetGeometry(scene->top, ray.hit.instID[0]));
    describe_hit(part, &ray.hit, origin.v, direction.v, out_hit);
}

/* ---- scenes ---- */

dm_result dmi_scene_create(dmi_picker* picker, dmi_scene** out_scene) {
    dmi_scene* scene = dmi_alloc_zeroed(picker->env, sizeof *scene, DMI_ALIGNMENT);
    if (scene == NULL) return dmi_fail(picker->env, DM_ERROR_OUT_OF_MEMORY, "no memory for a scene");
    scene->picker = picker;
    scene->top = rtcNewScene(picker->device);
    if (scene->top != NULL) {
        rtcSetSceneFlags(scene->top, RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST);
        dmi_picker_commit(picker, scene->top); /* a pick before any other commit then finds nothing */
    }
    dm_result result = dmi_picker_status(picker);
    if (result != DM_OK) {
        dmi_scene_destroy(scene);
        return result;
    }
    *out_scene = scene;
    return DM_OK;
}

void dmi_scene_destroy(dmi_scene* scene) {
    if (scene == NULL) return;
    dmi_env* env = scene->picker->env;
    if (scene->top != NULL) rtcReleaseScene(scene->top);
    for (uint32_t i = 0; i < scene->capacity; i++) {
        if (scene->objects[i] != NULL) release_placed(env, scene->objects[i]);
    }
    dmi_free(env, scene->objects, scene->capacity * sizeof(placed_object*));
    dmi_free(env, scene, sizeof *scene);
}
