/* Answers a job: selects the part by names or mask, prepares it (or refines the last job's object), reads joint and
 * hypotheses, generates a motion. */
#include "job.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "mask_noise.h"
#include "part_at_point.h"

/* Part ids of a job, one byte a face or a vertex. */
typedef struct selection {
    uint8_t* ids;
    size_t count;
    int32_t scope;
} selection;

static uint64_t larger(uint64_t a, uint64_t b) {
    return a > b ? a : b;
}

static dm_result select_by_mask(session* session, const job* job, selection* out, joint_answer* answer) {
    size_t size;
    char* bytes = file_read(job->mask, &size);
    if (bytes == NULL)
        return session_fail(session, DM_ERROR_NOT_FOUND, "can't read the mask '%.200s': %s", job->mask, file_problem());
    int32_t ambiguous = 0;
    const dm_result result = dm_gltf_read_mask(
        session->gltf, bytes, size, job->has_mask_value ? &job->mask_value : NULL, out->ids, &out->scope, &ambiguous);
    free(bytes);
    answer->ambiguous_mask = ambiguous != 0;
    out->count = out->scope == DM_PER_VERTEX ? session->mesh.vertex_count : session->mesh.index_count / 3;
    return result;
}

static void add_mask_noise(const session* session, double fraction, selection* selected) {
    const dm_mesh_desc* mesh = &session->mesh;
    if (selected->scope == DM_PER_FACE) {
        uint8_t* ids = cli_alloc(larger(mesh->vertex_count, mesh->index_count / 3));
        mask_vertices_of_faces(mesh->indices, mesh->index_count / 3, selected->ids, mesh->vertex_count, ids);
        free(selected->ids);
        *selected = (selection){ids, mesh->vertex_count, DM_PER_VERTEX};
    }
    random_state random = {1};
    mask_noise_apply(mesh->positions, mesh->vertex_count, fraction, &random, selected->ids);
}

static dm_result select_part(session* session, const job* job, selection* out, joint_answer* answer) {
    const uint64_t faces = session->mesh.index_count / 3;
    out->ids = cli_alloc_zeroed(larger(faces, session->mesh.vertex_count));
    out->scope = DM_PER_FACE;
    out->count = faces;
    dm_result result;
    if (job->mask != NULL)
        result = select_by_mask(session, job, out, answer);
    else if (job->find_part)
        result = part_at_point_mark(session, NULL, &job->drag, false, out->ids);
    else
        result = dm_gltf_mark_faces(session->gltf, (const char* const*)job->moving.names, job->moving.count, JOB_PART,
                                    out->ids, faces);
    if (result == DM_OK && job->mask_noise > 0) add_mask_noise(session, job->mask_noise, out);
    return result;
}

/* The library reports 10 % progress when mesh and picking structure are built; the rest is kinematics. */
static const float MESH_DONE = 0.099f; /* 10 % but for rounding */

typedef struct stopwatch {
    double mesh_ready;
} stopwatch;

static int32_t DM_CALL on_progress(void* user, float done) {
    stopwatch* watch = user;
    if (watch->mesh_ready == 0 && done > MESH_DONE) watch->mesh_ready = cli_now_ms();
    return 0;
}

/* Collects what the job says of the part and, where it says nothing, what the file does. from_file: the part is the
 * file's nodes that the job names. */
static void find_hints(const session* session, const job* job, bool from_file, part_hints* out) {
    *out = (part_hints){.has_pivot = false};
    if (job->no_hints) return;
    if (from_file && job->moving.count > 0 && job->mask == NULL && !job->find_part)
        part_hints_of_node(session->gltf, session->path, job->moving.names[0], out);
    if (job->label != NULL) part_hints_set_label(out, job->label);
    if (job->has_pivot) out->pivot = job->pivot, out->pivot_kind = DM_PIVOT_UNKNOWN;
    out->has_pivot = (out->has_pivot || job->has_pivot) && !job->no_pivot;
}

static dm_result prepare(session* session, const dm_mesh_desc* mesh, const job* job, const part_hints* hints,
                         joint_answer* answer) {
    stopwatch watch = {0};
    chooser chooser = {&job->choice, &answer->choice};
    dm_part_desc part = {
        .struct_size = sizeof part, .id = JOB_PART, .joint_type = job->type, .drag = job->has_drag ? &job->drag : NULL};
    session->hints = *hints;
    part_hints_enter(&session->hints, &part);
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .flags = session_prepare_flags(session),
                                 .mesh = mesh,
                                 .parts = &part,
                                 .part_count = 1,
                                 .model = session->model,
                                 .up = job->up,
                                 .choose = job->choice.kind != CHOICE_NONE ? choose_hypothesis : NULL,
                                 .choose_user = &chooser,
                                 .progress = on_progress,
                                 .progress_user = &watch};
    session_release_object(session);
    const double start = cli_now_ms();
    const dm_result result = dm_object_prepare(session->context, &desc, &session->object);
    const double end = cli_now_ms();
    if (result != DM_OK) session->object = 0;
    answer->prepare_ms = end - start;
    answer->kinematics_ms = watch.mesh_ready > 0 ? end - watch.mesh_ready : 0;
    return result;
}

/* Whether the last job's object has the same part, so that only the drag differs. */
static bool can_refine(const session* session, const job* job, const part_hints* hints, const selection* selected) {
    return session->object && session->part_ids != NULL && session->model && job->has_drag &&
           job->choice.kind == CHOICE_NONE && part_hints_equal(&session->hints, hints) &&
           session->joint_type == job->type && session->part_id_scope == selected->scope &&
           session->part_id_count == selected->count && memcmp(session->part_ids, selected->ids, selected->count) == 0;
}

static dm_result refine(session* session, const job* job, joint_answer* answer) {
    const double start = cli_now_ms();
    const dm_result result = dm_object_refine(session->context, session->object, JOB_PART, &job->drag);
    answer->prepare_ms = answer->kinematics_ms = cli_now_ms() - start;
    return result;
}

static dm_result read_joints(session* session, const job* job, joint_answer* answer) {
    answer->joint = answer->hypotheses[0] = dm_joint_default();
    dm_result result = dm_object_get_joint(session->context, session->object, JOB_PART, &answer->joint);
    if (result == DM_OK)
        result = dm_object_get_hypotheses(session->context, session->object, JOB_PART, NULL, answer->hypotheses,
                                          DM_MAX_HYPOTHESES, &answer->hypothesis_count);
    if (result != DM_OK || !session->has_motion || !job->has_drag) return result;
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = JOB_PART, .drag = job->drag};
    dm_motion motion;
    const double start = cli_now_ms();
    result = dm_motion_generate(session->context, session->object, &desc, &motion);
    answer->motion_ms = cli_now_ms() - start;
    return result == DM_OK ? dm_motion_destroy(session->context, motion) : result;
}

dm_result job_answer_mesh(session* session, const dm_mesh_desc* mesh, const job* job, joint_answer* out_answer) {
    part_hints hints;
    memset(out_answer, 0, sizeof *out_answer);
    find_hints(session, job, false, &hints);
    const dm_result result = prepare(session, mesh, job, &hints, out_answer);
    return result == DM_OK ? read_joints(session, job, out_answer) : result;
}

dm_result job_answer(session* session, job* job, joint_answer* out_answer) {
    memset(out_answer, 0, sizeof *out_answer);
    dm_result result = session_use_file(session, job->file);
    if (result != DM_OK) return result;
    job->drag.point = session_point(session, job->drag_point);
    if (job->has_pivot) job->pivot.origin = session_point(session, job->pivot_origin);
    memcpy(out_answer->frame, session->origin, sizeof out_answer->frame);
    selection selected;
    part_hints hints;
    find_hints(session, job, true, &hints);
    result = select_part(session, job, &selected, out_answer);
    if (result == DM_OK && can_refine(session, job, &hints, &selected)) {
        result = refine(session, job, out_answer);
    } else if (result == DM_OK) {
        dm_mesh_desc mesh = session->mesh;
        mesh.part_ids = selected.ids;
        mesh.part_id_bytes = selected.count;
        mesh.part_id_format = DM_UINT8;
        mesh.part_id_scope = selected.scope;
        result = prepare(session, &mesh, job, &hints, out_answer);
    }
    if (result == DM_OK) {
        session_own_part_ids(session, selected.ids, selected.count, selected.scope, job->type);
        return read_joints(session, job, out_answer);
    }
    free(selected.ids);
    return result;
}
