/* Ray-traced pictures of an answered object by dm_camera_ray and dm_scene_pick: a soft sun, a sky, a floor. */
#ifndef CLI_RENDER_H
#define CLI_RENDER_H

#include "job.h"
#include "picture.h"
#include "random.h"
#include "smooth.h"

typedef struct renderer {
    session* session; /* its file and object are shown */
    dm_scene scene;
    uint32_t instance;
    smooth_normals normals;
    uint32_t* face_node; /* a face: its node's position in the file's list */
    vec* colours;        /* a node */
    uint32_t* face_part; /* a face: the id of the part that moves it; 0: it stays */
    uint32_t part_count; /* how many poses a picture has, by part id, the body's first; 0: that of JOB_PART alone */
    vec up, centre;
    double size, floor; /* largest side; height of the floor along up */
    dm_camera camera;
    vec sun;
    const dm_pose* poses; /* of the picture that is being drawn */
    random_state random;
    int grid, sky_rays; /* rays a pixel along a side; rays into the sky a hit */
} renderer;

/* up: 'x', 'y' or 'z'. For speed set `grid` and `sky_rays` to less afterwards. */
dm_result render_open(renderer* renderer, session* session, char up);
/* The same for an object of several parts, each with a pose of its own: wherever one pose is asked for below, there are
 * part_count of them. Takes face_part over. */
dm_result render_open_parts(renderer* renderer, session* session, char up, uint32_t* face_part, uint32_t part_count);
void render_close(renderer* renderer);
/* Returns the colour, 0 to 1, that a part (its id: 1 or more) is tinted with. Eight parts differ. */
vec render_accent(uint32_t part_id);
/* Returns the pose of a part among those of picture `index`. */
const dm_pose* render_pose(const renderer* renderer, const dm_pose* poses, uint32_t index, uint32_t part_id);
/* Returns where a pose takes a point. */
vec render_moved(const dm_pose* pose, vec point);
/* A camera for pictures of width x height that sees the whole object in all of the poses, from the side that `toward`
 * (the way the part moves; may be zero) points to. */
void render_aim(renderer* renderer, vec toward, const dm_pose* poses, uint32_t count, int width, int height);
/* Where a point of the scene is in the picture. */
void render_project(const renderer* renderer, vec point, double* out_x, double* out_y);
/* Draws the object with its part at `pose` into the columns from `left` on. */
dm_result render_draw(renderer* renderer, const dm_pose* poses, picture* picture, int left);
/* A segment of the scene over it; clipped to the panel that begins at the column `left`. */
void render_segment(const renderer* renderer, vec from, vec to, const uint8_t rgb[3], picture* picture, int left);
/* The joint's axis over it. */
void render_axis(const renderer* renderer, const dm_joint* joint, const uint8_t rgb[3], picture* picture, int left);
/* Draws a film strip: one panel a pose, the joint's axis over each (axis NULL: none). Returns the bytes of a .png, to
 * be freed; NULL and session->error on failure. */
void* render_film(renderer* renderer, const dm_pose* poses, uint32_t count, const dm_joint* axis, size_t* out_size);

#endif
