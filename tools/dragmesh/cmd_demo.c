/* dragmesh demo: a scripted player picks a pixel and drags the pointer across the screen; the part follows. Writes a
 * film strip and an animated file, and prints the inferred joint beside the true one. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "answer.h"
#include "dataset.h"
#include "files.h"
#include "metrics.h"
#include "output_file.h"
#include "play.h"
#include "render.h"
#include "runs.h"
#include "session_open.h"
#include "shown.h"

enum { PANELS = 6, UPDATES = 90, PANEL_PIXELS = 420, LEAST_PIXELS = 16, MOST_PIXELS = 1024 }; /* by hand */
static const float seconds = 1.5f;                                                            /* of the drag */
static const double first_stretch = 0.25; /* share of the drag that the joint is refined by; by hand */
static const double demo_travel = 0.95;   /* share of the full travel that is dragged; by hand */

typedef struct pixel {
    double x, y;
} pixel;

typedef struct player {
    session* session;
    renderer* view;
    pixel from, to; /* the pointer's path across the screen */
    dm_hit grab;
    int pixels; /* a side of a picture */
} player;

static dm_result ray_through(const player* p, double share, dm_ray* out_ray) {
    const double x = p->from.x + share * (p->to.x - p->from.x), y = p->from.y + share * (p->to.y - p->from.y);
    return dm_camera_ray(p->session->context, &p->view->camera, (float)x, (float)y, out_ray);
}

/* Picks what is under the pointer; it must be the part. */
static dm_result grab_part(player* p) {
    dm_ray ray;
    dm_result result = ray_through(p, 0, &ray);
    p->grab = dm_hit_default();
    if (result == DM_OK) result = dm_scene_commit(p->session->context, p->view->scene);
    if (result == DM_OK) result = dm_scene_pick(p->session->context, p->view->scene, &ray, &p->grab);
    if (result != DM_OK) return result;
    if (p->grab.object == 0 || p->grab.part_id != JOB_PART)
        return session_fail(p->session, DM_ERROR_NOT_FOUND, "the pixel (%.0f, %.0f) does not show the part", p->from.x,
                            p->from.y);
    printf("picked pixel (%.0f, %.0f): the part, at (%.3f, %.3f, %.3f)\n", p->from.x, p->from.y,
           shown((double)p->grab.object_point.x, 3), shown((double)p->grab.object_point.y, 3),
           shown((double)p->grab.object_point.z, 3));
    return DM_OK;
}

/* What a drag on the screen means in space: the pointer's ray cut with the plane through the grabbed point that holds
 * the surface's normal and faces the camera best, so that pulling, pushing and sliding can all be said. */
static dm_result drag_in_space(const player* p, dm_drag_hint* out_hint) {
    dm_ray ray;
    const dm_result result = ray_through(p, first_stretch, &ray);
    if (result != DM_OK) return result;
    const vec point = vec_of(p->grab.object_point), normal = vec_of(p->grab.normal);
    const vec origin = vec_of(ray.origin), direction = unit(vec_of(ray.direction));
    const vec across = sub(direction, scale(normal, dot(direction, normal)));
    const vec plane = length(across) > 1e-3 ? unit(across) : direction;
    const double along = dot(sub(point, origin), plane) / dot(direction, plane);
    *out_hint = (dm_drag_hint){vec_out(point), vec_out(sub(add(origin, scale(direction, along)), point))};
    return DM_OK;
}

/* Moves the pointer along its path; the part follows. */
static dm_result follow(const player* p, dm_pose poses[UPDATES], float* out_value) {
    dm_context* context = p->session->context;
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = JOB_PART,
                               .object = p->session->object,
                               .grab_point = p->grab.object_point};
    dm_drag drag;
    dm_result result = dm_drag_begin(context, &desc, &drag);
    if (result != DM_OK) return result;
    dm_drag_state state = {.struct_size = sizeof state};
    for (int i = 0; i < UPDATES && result == DM_OK; i++) {
        dm_ray ray;
        result = ray_through(p, (double)minimum_jerk((float)i / (UPDATES - 1)), &ray);
        if (result == DM_OK) result = dm_drag_update(context, drag, &ray, seconds / UPDATES, &state);
        poses[i] = state.pose;
    }
    *out_value = state.value;
    return result == DM_OK ? dm_drag_end(context, drag, NULL) : result;
}

/* Sets the pointer's path: from the drag point to where the true joint takes it. */
static void aim_pointer(player* p, const metric_case* known) {
    const vec start = known->drag->point;
    render_project(p->view, start, &p->from.x, &p->from.y);
    render_project(p->view, metrics_true_move(known, start, demo_travel * metrics_travel(known)), &p->to.x, &p->to.y);
}

static void print_joint_beside_truth(const known_joint* truth, const dm_joint* found, const metric_row* row) {
    printf("found  ");
    joint_print(found, (double[3]){0, 0, 0});
    printf("true   %-10s        axis (%.4f, %.4f, %.4f)  origin (%.4f, %.4f, %.4f)  from %.4f to %.4f %s\n",
           truth->slides ? "prismatic" : "revolute", shown(truth->axis.x, 4), shown(truth->axis.y, 4),
           shown(truth->axis.z, 4), shown(truth->origin.x, 4), shown(truth->origin.y, 4), shown(truth->origin.z, 4),
           shown(truth->lower, 4), shown(truth->upper, 4), truth->slides ? "units" : "rad");
    printf("       axis %.1f mrad off", row->value[METRIC_AXIS]);
    if (!truth->slides) printf(", %.1f thousandths of the object beside the true line", row->value[METRIC_ORIGIN]);
    printf("; fully open, the part is %.1f thousandths out of place\n", row->value[METRIC_POSE] * 1e3);
    confidence_print();
}

/* Poses along the true joint, so that the camera sees all of the motion. */
static void true_poses(const metric_case* known, dm_pose poses[PANELS]) {
    const known_joint* truth = known->truth;
    const dm_joint joint = {.struct_size = sizeof joint,
                            .type = truth->slides ? DM_JOINT_PRISMATIC : DM_JOINT_REVOLUTE,
                            .axis = vec_out(truth->axis),
                            .origin = vec_out(truth->origin)};
    for (int i = 0; i < PANELS; i++)
        dm_joint_pose(&joint, (float)(metrics_travel(known) * i / (PANELS - 1)), &poses[i]);
}

static dm_result open_view(player* p, metric_case* known, job* job, joint_answer* answer) {
    dm_pose poses[PANELS];
    dm_result result = job_answer(p->session, job, answer); /* without a drag, as a game prepares while it loads */
    if (result == DM_OK) result = render_open(p->view, p->session, 'y');
    if (result != DM_OK) return result;
    known->size = p->view->size;
    true_poses(known, poses);
    render_aim(p->view, known->drag->vector, poses, PANELS, p->pixels, p->pixels);
    aim_pointer(p, known);
    return DM_OK;
}

static dm_result play(player* p, const metric_case* known, joint_answer* answer, dm_pose poses[UPDATES]) {
    dm_drag_hint hint;
    float value = 0;
    answer->joint = dm_joint_default();
    dm_result result = grab_part(p);
    if (result == DM_OK) result = drag_in_space(p, &hint);
    if (result == DM_OK && p->session->model)
        result = dm_object_refine(p->session->context, p->session->object, JOB_PART, &hint);
    if (result == DM_OK)
        result = dm_object_get_joint(p->session->context, p->session->object, JOB_PART, &answer->joint);
    if (result == DM_OK) result = follow(p, poses, &value);
    if (result != DM_OK) return result;
    metric_row row;
    answer->hypothesis_count = 0;
    metrics_of_joint(known, answer, &row);
    printf("dragged to pixel (%.0f, %.0f): the joint went to %.3f\n", p->to.x, p->to.y, shown((double)value, 3));
    print_joint_beside_truth(known->truth, &answer->joint, &row);
    return DM_OK;
}

static char* path_with_ending(const char* prefix, const char* ending) {
    const size_t room = strlen(prefix) + strlen(ending) + 1;
    char* path = cli_alloc(room);
    snprintf(path, room, "%s%s", prefix, ending);
    return path;
}

/* Writes the picture and the animation, both or none. */
static dm_result write_both(session* session, const output_bytes files[2]) {
    int failed;
    if (output_write_all(files, 2, &failed) != 0) return session_fail_to_write(session, files[failed].path);
    for (int i = 0; i < 2; i++) printf("wrote %s\n", files[i].path);
    return DM_OK;
}

static dm_result show(player* p, const joint_answer* answer, const dm_pose poses[UPDATES], const char* prefix) {
    dm_pose panels[PANELS];
    char *png_path = path_with_ending(prefix, ".png"), *glb_path = path_with_ending(prefix, ".glb");
    void* glb = NULL;
    size_t png_size = 0, glb_size = 0;
    for (int i = 0; i < PANELS; i++) panels[i] = poses[i * (UPDATES - 1) / (PANELS - 1)];
    void* png = render_film(p->view, panels, PANELS, &answer->joint, &png_size);
    dm_result result = png != NULL ? DM_OK : DM_ERROR_INTERNAL;
    if (result == DM_OK) result = play_export(p->session, poses, UPDATES, seconds, &glb, &glb_size);
    if (result == DM_OK)
        result = write_both(p->session, (output_bytes[2]){{png_path, png, png_size}, {glb_path, glb, glb_size}});
    dm_gltf_release_bytes(p->session->gltf, glb, glb_size);
    free(png);
    free(png_path);
    free(glb_path);
    return result;
}

/* Vertices of the part, for the comparison with the truth. */
static vec* vertices_of(const session* session, size_t* out_count) {
    uint8_t* moving = session_moving_faces(session);
    vec* points = cli_alloc(session->mesh.index_count * sizeof *points);
    size_t count = 0;
    for (uint64_t corner = 0; corner < session->mesh.index_count; corner++) {
        const size_t vertex = ((const uint32_t*)session->mesh.indices)[corner];
        if (moving[corner / 3]) points[count++] = vec_at((const float*)session->mesh.positions + 3 * vertex);
    }
    free(moving);
    *out_count = count;
    return points;
}

static dm_result demonstrate(session* session, const known_object* object, int pixels, const char* prefix) {
    const known_joint* truth = &object->joints[0];
    job job = {.file = object->glb, .moving = truth->moving};
    metric_case known = {.truth = truth, .drag = &truth->drags[0], .dragged = 1};
    renderer view;
    player p = {.session = session, .view = &view, .pixels = pixels};
    joint_answer answer;
    memset(&view, 0, sizeof view);
    view.session = session;
    printf("the part '%s' may move\n", truth->moving.count ? truth->moving.names[0] : "");
    dm_result result = open_view(&p, &known, &job, &answer);
    if (result == DM_OK) {
        dm_pose* poses = cli_alloc(UPDATES * sizeof *poses);
        vec* moving = vertices_of(session, &known.moving_count);
        known.moving = moving;
        result = play(&p, &known, &answer, poses);
        if (result == DM_OK) result = show(&p, &answer, poses, prefix);
        free(moving);
        free(poses);
    }
    render_close(&view);
    return result;
}

static int demonstrate_folder(const known_object* object, int pixels, const char* prefix, const char* models) {
    session session;
    const int status = session_open(&session, models, NULL);
    if (status != CLI_OK) return status;
    const dm_result result = demonstrate(&session, object, pixels, prefix);
    if (result != DM_OK) fprintf(stderr, "dragmesh: %s\n", session.error);
    session_close(&session);
    return result == DM_OK ? CLI_OK : CLI_FAILED;
}

int demo_run(const cli_command* command, int argc, char** argv) {
    const char *folder = NULL, *prefix = NULL, *models = NULL;
    int pixels = PANEL_PIXELS;
    const option_spec table[] = {{.name = "-o", .kind = OPTION_TEXT, .value = &prefix},
                                 {.name = "--size", .kind = OPTION_INTEGER, .value = &pixels},
                                 {.name = "--models", .kind = OPTION_TEXT, .value = &models}};
    known_object object;
    char error[512];
    int status = options_read(command, argc, argv, table, sizeof table / sizeof *table, &folder);
    if (status == CLI_OK && (folder == NULL || prefix == NULL))
        status = options_refuse(command, "a folder and -o are needed");
    if (status == CLI_OK && (pixels < LEAST_PIXELS || pixels > MOST_PIXELS))
        status = options_refuse(command, "--size: %d to %d", LEAST_PIXELS, MOST_PIXELS);
    if (status != CLI_OK) return status;
    if (dataset_read(folder, ".", &object, error, sizeof error) != 0) return options_refuse(command, "%s", error);
    if (object.joints[0].drag_count > 0)
        status = demonstrate_folder(&object, pixels, prefix, models);
    else
        status = options_refuse(command, "the first joint of '%s' has no drag", folder);
    dataset_free(&object);
    return status;
}
