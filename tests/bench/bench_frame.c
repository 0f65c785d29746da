/* The calls of a frame, each over and over, for callgrind to count (instructions.sh): bench_frame [rounds [models]]. */
#include <stdio.h>
#include <stdlib.h>

#include "world.h"

#define TRIANGLES 20000
#define POINTS 1000

typedef struct frame {
    bench_world world;
    dm_motion motion;
    dm_drag turn, slide;
    dm_scene scene;
    uint32_t instance, round;
    dm_camera camera;
    dm_pose pose;
    dm_ray ray;
    float points[3 * POINTS];
} frame;

/* Each counted function is one call of the library, and kept out of line for callgrind to find. */
#define COUNTED __attribute__((noinline))
#define CHECK(call) bench_check(call, #call)

COUNTED static void frame_motion_generate(frame* f) {
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = 1, .drag = bench_mesh_drag(1)};
    dm_motion motion;
    CHECK(dm_motion_generate(f->world.context, f->world.object, &desc, &motion));
    CHECK(dm_motion_destroy(f->world.context, motion));
}

COUNTED static void frame_motion_sample(frame* f) {
    CHECK(dm_motion_sample(f->world.context, f->motion, 0.01f * (float)(f->round % 100), &f->pose, NULL));
}

COUNTED static void frame_drag_update_turn(frame* f) {
    dm_drag_state state = {.struct_size = sizeof state};
    CHECK(dm_drag_update(f->world.context, f->turn, &f->ray, 1 / 60.0f, &state));
}

COUNTED static void frame_drag_update_slide(frame* f) {
    dm_drag_state state = {.struct_size = sizeof state};
    CHECK(dm_drag_update(f->world.context, f->slide, &f->ray, 1 / 60.0f, &state));
}

COUNTED static void frame_pose_apply_points(frame* f) {
    dm_pose_apply_points(&f->pose, f->points, 0, f->points, 0, POINTS);
}

COUNTED static void frame_camera_ray(frame* f) {
    CHECK(dm_camera_ray(f->world.context, &f->camera, (float)(480 + f->round % 40), 500, &f->ray));
}

COUNTED static void frame_scene_move(frame* f) {
    CHECK(dm_scene_move(f->world.context, f->scene, f->instance, 1, &f->pose));
}

COUNTED static void frame_scene_commit(frame* f) {
    CHECK(dm_scene_commit(f->world.context, f->scene));
}

COUNTED static void frame_scene_pick(frame* f) {
    dm_hit hit = {.struct_size = sizeof hit};
    CHECK(dm_scene_pick(f->world.context, f->scene, &f->ray, &hit));
}

static dm_drag begin_drag(frame* f, uint32_t part) {
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = part,
                               .object = f->world.object,
                               .grab_point = bench_mesh_drag(part).point};
    dm_drag drag;
    CHECK(dm_drag_begin(f->world.context, &desc, &drag));
    return drag;
}

static void set_up(frame* f, const char* models) {
    bench_world_open(&f->world, models, NULL);
    f->world.mesh = bench_mesh_new(TRIANGLES, 2);
    f->world.object = bench_world_prepare(&f->world, &f->world.mesh, 0);
    bench_world_hinge(&f->world, f->world.object, 1, DM_JOINT_REVOLUTE);
    bench_world_hinge(&f->world, f->world.object, 2, DM_JOINT_PRISMATIC);
    f->turn = begin_drag(f, 1);
    f->slide = begin_drag(f, 2);
    const dm_motion_desc motion = {.struct_size = sizeof motion, .part_id = 1, .drag = bench_mesh_drag(1)};
    const dm_scene_desc scene = {.struct_size = sizeof scene};
    CHECK(dm_motion_generate(f->world.context, f->world.object, &motion, &f->motion));
    CHECK(dm_scene_create(f->world.context, &scene, &f->scene));
    CHECK(dm_scene_add(f->world.context, f->scene, f->world.object, NULL, &f->instance));
    CHECK(dm_scene_commit(f->world.context, f->scene));
    f->camera = (dm_camera){.struct_size = sizeof f->camera,
                            .fov_y = 0.8f,
                            .eye = {0.4f, 1, 3},
                            .forward = {0, -0.2f, -1},
                            .up = {0, 1, 0},
                            .viewport_width = 1000,
                            .viewport_height = 1000};
}

int main(int argc, char** argv) {
    static frame f;
    const uint32_t rounds = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 100;
    set_up(&f, argc > 2 ? argv[2] : "sdk/models");
    for (f.round = 0; f.round < rounds; f.round++) {
        frame_motion_generate(&f);
        frame_motion_sample(&f);
        frame_camera_ray(&f);
        frame_drag_update_turn(&f);
        frame_drag_update_slide(&f);
        frame_pose_apply_points(&f);
        frame_scene_move(&f);
        frame_scene_commit(&f);
        frame_scene_pick(&f);
    }
    bench_world_close(&f.world);
    bench_mesh_free(&f.world.mesh);
    return 0;
}
