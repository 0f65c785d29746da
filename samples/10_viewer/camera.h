/* A camera on a sphere round a point: orbit, pan, zoom. */
#ifndef VIEWER_CAMERA_H
#define VIEWER_CAMERA_H

#include <stdbool.h>

#include "vec.h"

typedef struct camera {
    float yaw, pitch; /* rad; yaw 0 looks along -z of a y-up scene, along +y of a z-up one */
    float distance;
    dm_vec3 target;
    int z_up;
    float fov_y;
    int width, height; /* pixels */
} camera;

dm_vec3 camera_up(const camera* camera);      /* of the world */
dm_vec3 camera_forward(const camera* camera); /* unit, where it looks */
dm_vec3 camera_eye(const camera* camera);

/* Aims at a box so that all of it is visible, from the front and somewhat above and beside. */
void camera_frame(camera* camera, dm_vec3 box_min, dm_vec3 box_max);
void camera_orbit(camera* camera, float dx, float dy); /* pixels */
void camera_pan(camera* camera, float dx, float dy);
void camera_zoom(camera* camera, float steps);

/* The matrix that takes the world to clip space. */
void camera_matrix(const camera* camera, mat4 out);

/* Converts to the library's dm_camera. */
dm_camera camera_for_picking(const camera* camera);

/* Projects a world point to pixels; out[2]: depth in [0, 1]. Returns false when it is behind the camera. */
bool camera_project(const camera* camera, dm_vec3 p, float out[3]);

#endif
