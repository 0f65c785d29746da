/* Finds the part at the grabbed point, for hosts without a mask. */
#include "api_check.h"
#include "api_handles.h"
#include "api_mesh.h"
#include "base/fp_environment.h"
#include "math/linear3.h"
#include "segmentation/part_finder.h"

static dm_result check_buffer(dmi_env* env, const dmi_mesh* mesh, uint64_t face_count) {
    if (face_count >= mesh->face_count) return DM_OK;
    return dmi_fail(env, DM_ERROR_BUFFER_TOO_SMALL, "dm_mesh_find_part: face_count is %llu, the mesh has %u triangles",
                    (unsigned long long)face_count, mesh->face_count);
}

/* Converts the host's drag to the frame of the mesh. The point may be off the box by half the object's size. */
static dm_result read_drag(dmi_env* env, const dmi_mesh* mesh, const dm_drag_hint* drag, dmi_part_query* out) {
    const dmi_double3 point = dmi_xyz_f64(drag->point);
    const dmi_float3 vector = dmi_xyz(drag->vector);
    const float numbers[6] = {drag->point.x, drag->point.y, drag->point.z, vector.v[0], vector.v[1], vector.v[2]};
    dm_result result = dmi_check_finite(env, "dm_mesh_find_part: drag", numbers, 6);
    if (result != DM_OK) return result;
    dmi_frame_point_in(&mesh->frame, point.v, out->point);
    dmi_frame_direction_in(&mesh->frame, vector.v, out->drag);
    if (!(dmi_normalize3(out->drag) > 0)) out->drag[0] = out->drag[1] = out->drag[2] = 0;
    for (int k = 0; k < 3; k++) {
        if (fabsf(out->point[k]) <= 1) continue; /* the box runs from -0.5 to 0.5 at most */
        return dmi_fail(env, DM_ERROR_DRAG_OFF_PART, "dm_mesh_find_part: drag.point (%g, %g, %g) is far from the mesh",
                        point.v[0], point.v[1], point.v[2]);
    }
    return DM_OK;
}

static dm_result find(dmi_env* env, const dmi_mesh* mesh, const dm_drag_hint* drag, const dmi_progress* progress,
                      uint8_t* out_face_ids) {
    dmi_part_query query = {.mesh = mesh, .progress = progress};
    dm_result result = read_drag(env, mesh, drag, &query);
    if (result == DM_OK) result = dmi_part_find(env, &query, out_face_ids);
    return result;
}

dm_result DM_CALL dm_mesh_find_part(dm_context* context, const dm_mesh_desc* mesh, const dm_drag_hint* drag,
                                    uint8_t* out_face_ids, uint64_t face_count) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dm_mesh_desc known;
    if (drag == NULL || out_face_ids == NULL)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_find_part: %s is NULL",
                        drag != NULL ? "out_face_ids" : "drag");
    dm_result result = dmi_mesh_desc_read(env, "dm_mesh_find_part: mesh", mesh, &known);
    float told;
    const dmi_progress progress = dmi_progress_of(env, "dm_mesh_find_part", &told),
                       reading = dmi_progress_piece(&progress, 0, DMI_STAGE_FIND_MESH_READ),
                       finding = dmi_progress_piece(&progress, DMI_STAGE_FIND_MESH_READ, 1);
    dmi_mesh* inner = NULL;
    if (result == DM_OK) result = dmi_mesh_create_pieces(env, &context->axes, &known, &reading, &inner);
    if (result != DM_OK) return result;
    result = dmi_progress_tell(&finding, 0);
    if (result == DM_OK) result = check_buffer(env, inner, face_count);
    if (result == DM_OK) result = find(env, inner, drag, &finding, out_face_ids);
    dmi_mesh_destroy(env, inner);
    return result;
}
