/* Runs the library on one object with known joints and measures every joint. */
#include "evaluate.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "joint_type.h"
#include "mask_noise.h"
#include "part_at_point.h"
#include "play.h"

/* Parts with more vertices are thinned before they are measured. */
enum { MAX_VERTICES = 4000 }; /* by hand, for the time of a run */

#define MASK_FOUND 0.8 /* intersection over union of a part that counts as found; by hand, docs/accuracy.md */

/* The object as it is shown to the library. */
typedef struct trial {
    session* session;
    const eval_options* options;
    random_state* random;
    known_object object;
    float* positions; /* turned copy */
    double size;
    vec low, high;       /* of the object's box */
    double mask_overlap; /* of the last joint's part with the true one; NAN: it was not to be found */
    eval_rows* rows;
} trial;

/* ---- random poses and units ---- */

typedef struct similarity {
    vec axis;
    double angle, scale;
    vec shift;
} similarity;

static vec place_direction(const similarity* s, vec x) {
    return turn(x, s->axis, s->angle);
}

static vec place_point(const similarity* s, vec x) {
    return add(scale(place_direction(s, x), s->scale), s->shift);
}

/* Uniform over rotations (a unit quaternion of four normals), 0.01 to 100 in scale, shifted by a few sizes. */
static similarity random_similarity(random_state* random, double size) {
    const double w = random_normal(random);
    const vec v = {random_normal(random), random_normal(random), random_normal(random)};
    similarity s = {.axis = unit(v), .angle = 2 * atan2(length(v), w), .scale = pow(10, 4 * random_unit(random) - 2)};
    const vec away = {random_normal(random), random_normal(random), random_normal(random)};
    s.shift = scale(away, s.scale * size);
    return s;
}

static void place_truth(const similarity* s, known_joint* truth) {
    truth->axis = place_direction(s, truth->axis);
    truth->origin = place_point(s, truth->origin);
    if (truth->slides) {
        truth->lower *= s->scale;
        truth->upper *= s->scale;
    }
    truth->pivot = place_point(s, truth->pivot);
    for (int i = 0; i < 3; i++) truth->pivot_axes[i] = place_direction(s, truth->pivot_axes[i]);
    for (int i = 0; i < truth->drag_count; i++) {
        truth->drags[i].point = place_point(s, truth->drags[i].point);
        truth->drags[i].vector = scale(place_direction(s, truth->drags[i].vector), s->scale);
    }
}

static void widen_box(vec p, vec* low, vec* high) {
    *low = (vec){fmin(low->x, p.x), fmin(low->y, p.y), fmin(low->z, p.z)};
    *high = (vec){fmax(high->x, p.x), fmax(high->y, p.y), fmax(high->z, p.z)};
}

/* Finds the object's box and its largest side. */
static void measure_box(trial* t, uint64_t count) {
    vec low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    for (uint64_t v = 0; v < count; v++) widen_box(vec_at(t->positions + 3 * v), &low, &high);
    const vec side = sub(high, low);
    t->low = low;
    t->high = high;
    t->size = fmax(side.x, fmax(side.y, side.z));
}

static void place_object(trial* t) {
    const uint64_t count = t->session->mesh.vertex_count;
    t->positions = cli_alloc(count * 3 * sizeof(float));
    memcpy(t->positions, t->session->mesh.positions, count * 3 * sizeof(float));
    measure_box(t, count);
    if (!t->options->has_turn) return;
    const similarity s = random_similarity(t->random, t->size);
    for (uint64_t v = 0; v < count; v++) {
        const vec placed = place_point(&s, vec_at(t->positions + 3 * v));
        const float xyz[3] = {(float)placed.x, (float)placed.y, (float)placed.z};
        memcpy(t->positions + 3 * v, xyz, sizeof xyz);
    }
    const double size = t->size * s.scale;
    measure_box(t, count); /* of the turned box; the size stays that of the object at rest */
    t->size = size;
    t->object.up_direction = place_direction(&s, t->object.up_direction);
    for (int i = 0; i < t->object.joint_count; i++) place_truth(&s, &t->object.joints[i]);
}

/* ---- one joint ---- */

/* Vertices of the named nodes. */
static vec* moving_vertices(const trial* t, const name_list* moving, size_t* out_count) {
    vec* points = cli_alloc(t->session->mesh.vertex_count * sizeof *points);
    size_t count = 0;
    for (unsigned n = 0; n < moving->count; n++) {
        for (uint32_t i = 0; i < dm_gltf_node_count(t->session->gltf); i++) {
            dm_gltf_node node;
            dm_gltf_get_node(t->session->gltf, i, &node);
            if (strcmp(node.name, moving->names[n]) != 0) continue;
            for (uint64_t v = 0; v < node.vertex_count; v++)
                points[count++] = vec_at(t->positions + 3 * (node.first_vertex + v));
        }
    }
    *out_count = count;
    return points;
}

/* Keeps every n-th point, so that about MAX_VERTICES are left. Returns how many. */
static size_t thin(vec* points, size_t count) {
    const size_t step = count > MAX_VERTICES ? count / MAX_VERTICES : 1;
    size_t kept = 0;
    for (size_t i = 0; i < count; i += step) points[kept++] = points[i];
    return kept;
}

/* Rotates a drag direction by `degrees` x |N(0, 1)| about a random perpendicular axis. */
static vec noisy(vec vector, double degrees, random_state* random) {
    vec aside = {random_normal(random), random_normal(random), random_normal(random)};
    aside = unit(sub(aside, scale(vector, dot(aside, vector) / dot(vector, vector))));
    return turn(vector, aside, fabs(random_normal(random)) * degrees * PI / 180 /* degrees to rad */);
}

/* Intersection over union of two sets of faces, by area. */
static double overlap(const trial* t, const uint8_t* a, const uint8_t* b) {
    const uint32_t* corner = t->session->mesh.indices;
    double both = 0, either = 0;
    for (uint64_t f = 0; f < t->session->mesh.index_count / 3; f++, corner += 3) {
        if (!a[f] && !b[f]) continue;
        const vec p = vec_at(t->positions + 3 * (size_t)corner[0]), q = vec_at(t->positions + 3 * (size_t)corner[1]);
        const double area = length(cross(sub(q, p), sub(vec_at(t->positions + 3 * (size_t)corner[2]), p)));
        either += area;
        if (a[f] && b[f]) both += area;
    }
    return either > 0 ? both / either : 0;
}

/* Replaces the true part by the one that the library finds. */
static dm_result find_part(trial* t, const metric_case* known, uint64_t faces, uint8_t* ids) {
    uint8_t* found = cli_alloc_zeroed(faces);
    const dm_drag_hint drag = {vec_out(known->drag->point),
                               known->dragged ? vec_out(known->drag->vector) : (dm_vec3){0, 0, 0}};
    t->mask_overlap = 0;
    const dm_result result = part_at_point_mark(t->session, t->positions, &drag, t->options->merged, found);
    if (result == DM_OK) {
        t->mask_overlap = overlap(t, found, ids);
        memcpy(ids, found, faces);
    }
    free(found);
    return result;
}

/* Makes part ids of the named nodes: per face, or per vertex when mask noise is added. */
static dm_result part_ids(trial* t, const metric_case* known, dm_mesh_desc* mesh, uint8_t** out_ids) {
    const name_list* moving = &known->truth->moving;
    const uint64_t faces = mesh->index_count / 3;
    uint8_t* ids = cli_alloc_zeroed(faces + mesh->vertex_count);
    *out_ids = ids;
    mesh->part_ids = ids;
    mesh->part_id_bytes = faces;
    mesh->part_id_format = DM_UINT8;
    mesh->part_id_scope = DM_PER_FACE;
    dm_result result =
        dm_gltf_mark_faces(t->session->gltf, (const char* const*)moving->names, moving->count, JOB_PART, ids, faces);
    if (result == DM_OK && t->options->find_part) result = find_part(t, known, faces, ids);
    if (result != DM_OK || t->options->mask_noise <= 0) return result;
    uint8_t* vertices = ids + faces;
    mask_vertices_of_faces(mesh->indices, faces, ids, mesh->vertex_count, vertices);
    mask_noise_apply(t->positions, mesh->vertex_count, t->options->mask_noise, t->random, vertices);
    mesh->part_ids = vertices;
    mesh->part_id_bytes = mesh->vertex_count;
    mesh->part_id_scope = DM_PER_VERTEX;
    return DM_OK;
}

/* Leaves the part's faces alone in the mesh. Returns their corners, to be freed. */
static uint32_t* leave_part_alone(dm_mesh_desc* mesh, const uint8_t* ids, uint8_t* out_ids) {
    const uint32_t* corners = mesh->indices;
    uint32_t* kept = cli_alloc(mesh->index_count * sizeof *kept);
    uint64_t count = 0;
    for (uint64_t f = 0; f < mesh->index_count / 3; f++) {
        if (!ids[f]) continue;
        memcpy(kept + 3 * count, corners + 3 * f, 3 * sizeof *kept);
        out_ids[count++] = JOB_PART;
    }
    mesh->indices = kept;
    mesh->index_count = 3 * count;
    mesh->index_bytes = 0;
    mesh->part_ids = out_ids;
    mesh->part_id_bytes = count;
    return kept;
}

static dm_result answer_alone(trial* t, const dm_mesh_desc* mesh, const job* job, const uint8_t* ids,
                              joint_answer* out_answer) {
    dm_mesh_desc alone = *mesh;
    uint8_t* all = cli_alloc(mesh->index_count / 3);
    uint32_t* corners = leave_part_alone(&alone, ids, all);
    const dm_result result = job_answer_mesh(t->session, &alone, job, out_answer);
    free(corners);
    free(all);
    return result;
}

static dm_result infer(trial* t, const metric_case* known, joint_answer* out_answer) {
    dm_mesh_desc mesh = t->session->mesh;
    mesh.positions = t->positions;
    uint8_t* ids;
    dm_result result = part_ids(t, known, &mesh, &ids);
    job job = {.has_drag = known->dragged};
    eval_hints_set(t->options->hints, t->options->lies, &t->object, (int)(known->truth - t->object.joints), t->low,
                   t->high, t->random, &job);
    if (result == DM_OK) {
        vec vector = known->drag->vector;
        if (t->options->drag_noise > 0) vector = noisy(vector, t->options->drag_noise, t->random);
        job.drag = (dm_drag_hint){vec_out(known->drag->point), vec_out(vector)};
        if (t->options->given_type) job.type = known->truth->slides ? DM_JOINT_PRISMATIC : DM_JOINT_REVOLUTE;
        result = t->options->alone ? answer_alone(t, &mesh, &job, ids, out_answer)
                                   : job_answer_mesh(t->session, &mesh, &job, out_answer);
    }
    if (result != DM_OK) {
        free(ids);
        return result;
    }
    const size_t faces = (size_t)(mesh.index_count / 3);
    const bool per_face = mesh.part_id_scope == DM_PER_FACE;
    if (!per_face) memmove(ids, ids + faces, mesh.vertex_count);
    session_own_part_ids(t->session, ids, per_face ? faces : mesh.vertex_count, mesh.part_id_scope, job.type);
    return DM_OK;
}

/* Measures the network's motion along the true path of the dragged point. */
static void measure_motion(trial* t, const metric_case* known, const dm_joint* joint, metric_row* row) {
    dm_vec3 path[DM_MOTION_FRAMES];
    const double travel = metrics_travel(known);
    for (int i = 0; i < DM_MOTION_FRAMES; i++) {
        const double value = travel * (double)minimum_jerk((float)i / (DM_MOTION_FRAMES - 1));
        path[i] = vec_out(metrics_true_move(known, known->drag->point, value));
    }
    const dm_motion_desc desc = {.struct_size = sizeof desc,
                                 .part_id = JOB_PART,
                                 .drag = {vec_out(known->drag->point), vec_out(known->drag->vector)},
                                 .path = path,
                                 .path_count = DM_MOTION_FRAMES};
    dm_motion motion;
    dm_pose poses[DM_MOTION_FRAMES];
    if (dm_motion_generate(t->session->context, t->session->object, &desc, &motion) != DM_OK) return;
    dm_motion_get_frames(t->session->context, motion, poses, NULL);
    dm_motion_destroy(t->session->context, motion);
    metrics_of_motion(known, joint, poses, row);
}

/* Adds a picture of a wrong answer. The renderer shows the session's positions, so they are replaced meanwhile. */
static void report_error(trial* t, const metric_case* known, const joint_answer* answer, const metric_row* row) {
    if (t->options->error_report == NULL || (row->value[METRIC_POSE] < METRICS_RIGHT && row->value[METRIC_TYPE] > 0))
        return;
    session* session = t->session;
    const void* file_positions = session->mesh.positions;
    session->mesh.positions = t->positions;
    if (error_report_add(t->options->error_report, session, known, answer, row, t->object.up) != DM_OK)
        fprintf(stderr, "dragmesh eval: %s: no picture: %s\n", row->id, session->error);
    session->mesh.positions = file_positions;
}

static metric_row* new_row(eval_rows* rows) {
    rows->rows = cli_grow_list(rows->rows, rows->count, &rows->room, sizeof *rows->rows);
    metric_row* row = &rows->rows[rows->count++];
    memset(row, 0, sizeof *row);
    return row;
}

/* Returns the largest side of the points' box. */
static double size_of(const vec* points, size_t count) {
    vec low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    for (size_t i = 0; i < count; i++) widen_box(points[i], &low, &high);
    const vec side = sub(high, low);
    return fmax(side.x, fmax(side.y, side.z));
}

static void evaluate_joint(trial* t, int index) {
    const known_joint* truth = &t->object.joints[index];
    metric_case known = {.truth = truth, .size = t->size, .dragged = !t->options->no_drag};
    size_t count;
    vec* moving = moving_vertices(t, &truth->moving, &count);
    if (t->options->alone && count > 0) known.size = size_of(moving, count);
    const int drags = truth->drag_count < t->options->drags ? truth->drag_count : t->options->drags;
    known_drag pulled[DATASET_DRAGS];
    for (int d = 0; d < drags; d++)
        pulled[d] =
            count > 0 ? pull_make(t->options->pull, truth, &truth->drags[d], moving, count, t->size) : truth->drags[d];
    known.moving = moving;
    known.moving_count = thin(moving, count);
    for (int d = 0; d < drags; d++) {
        metric_row* row = new_row(t->rows);
        joint_answer answer;
        known.drag = &pulled[d];
        snprintf(row->id, sizeof row->id, "%s/%d/%d", t->object.name, index, d);
        snprintf(row->category, sizeof row->category, "%s", t->object.category);
        row->source = dataset_source(t->object.name);
        row->weight = truth->weight / drags;
        t->mask_overlap = NAN;
        if (known.moving_count > 0 && infer(t, &known, &answer) == DM_OK) {
            metrics_of_joint(&known, &answer, row);
            snprintf(row->found_type, sizeof row->found_type, "%s", joint_type_name(answer.joint.type));
            if (t->session->has_motion) measure_motion(t, &known, &answer.joint, row);
            report_error(t, &known, &answer, row);
        } else {
            fprintf(stderr, "dragmesh eval: %s: %s\n", row->id, t->session->error);
            metrics_of_failure(&known, row);
        }
        row->value[METRIC_MASK] = t->mask_overlap;
        if (!isnan(t->mask_overlap)) row->value[METRIC_MASK_FOUND] = t->mask_overlap >= MASK_FOUND;
    }
    free(moving);
}

int evaluate_object(session* session, const char* folder, const char* name, const eval_options* options,
                    random_state* random, eval_rows* rows) {
    trial t = {.session = session, .options = options, .random = random, .rows = rows};
    char error[512];
    if (dataset_read(folder, name, &t.object, error, sizeof error) != 0) {
        fprintf(stderr, "dragmesh eval: %s\n", error);
        return -1;
    }
    const dm_result result = session_use_file(session, t.object.glb);
    if (result == DM_OK) {
        dataset_enter_frame(&t.object, session->origin);
        place_object(&t);
        for (int i = 0; i < t.object.joint_count; i++) evaluate_joint(&t, i);
        free(t.positions);
    } else {
        fprintf(stderr, "dragmesh eval: %s\n", session->error);
    }
    dataset_free(&t.object);
    return result == DM_OK ? 0 : -1;
}
