/* A scripted player: renders an object, grabs a visible point of a part and moves the mouse along the projection of the
 * true motion. The library knows nothing of the truth. */
#ifndef CLI_DRAGBOT_H
#define CLI_DRAGBOT_H

#include <stdbool.h>
#include <stdio.h>

#include "dataset.h"
#include "output_file.h"
#include "random.h"

/* The player's screen, pixels; by hand. */
enum { BOT_WIDTH = 1280, BOT_HEIGHT = 960 };

/* ---- view ---- */

/* Part ids and depths at every BOT_STEP-th pixel, by a rasteriser independent of the library. */
enum { BOT_STEP = 4, BOT_COLUMNS = BOT_WIDTH / BOT_STEP, BOT_ROWS = BOT_HEIGHT / BOT_STEP };
#define BOT_CONTESTED UINT32_MAX /* a surface of two parts */

typedef struct bot_view {
    dm_camera camera;
    vec eye, right, up, forward;
    double zoom;    /* pixels a unit at distance 1 */
    float* depth;   /* 1 / distance along forward, 0: nothing; BOT_COLUMNS x BOT_ROWS */
    uint32_t* part; /* the part seen, 0: the body or nothing */
} bot_view;

bot_view bot_view_new(void);
void bot_view_free(bot_view* view);
/* Looks from the unit direction `from` at a ball. */
void bot_view_aim(bot_view* view, vec from, vec up, vec centre, double radius, double distance);
/* Looks from the eye along a unit direction. fov: of the screen's height, rad. */
void bot_view_look(bot_view* view, vec eye, vec forward, vec up, double fov);
/* Draws a mesh alone, one part id a face. */
void bot_view_draw(bot_view* view, const dm_mesh_desc* mesh, const uint8_t* face_parts);
/* The pixel of a point; 0 when it is behind the eye. */
bool bot_view_project(const bot_view* view, vec point, double* out_x, double* out_y);
bool bot_view_on_screen(double x, double y);
/* The point seen at column, row. */
vec bot_view_point(const bot_view* view, int column, int row);

/* ---- what moves while the player pulls ---- */

/* A motion in the world: a turn round the upward line through a point, and a rise along it. Zeros: none. */
typedef struct bot_carry {
    vec centre, up;
    double angle; /* rad */
    double rise;
} bot_carry;

vec bot_carry_point(const bot_carry* carry, vec point);
/* Returns a ray of the world as seen by an instance that was carried from where its frame is the world's. */
dm_ray bot_carry_ray_back(const bot_carry* carry, const dm_ray* ray);
/* Returns the view with its camera carried; it shares the buffers. */
bot_view bot_carry_view(const bot_carry* carry, const bot_view* view);

/* ---- one case ---- */

/* Frames at 60 a second, by hand: least and most of a pull, and still after it. */
enum { BOT_FRAMES = 120, BOT_MAX_FRAMES = 1200, BOT_HOLD = 20 };
enum { BOT_MAX_REGRABS = 20 };

/* A pixel to grab and the path of the mouse. */
typedef struct bot_pull {
    int x, y;     /* of the grab */
    vec point;    /* seen there */
    double asked; /* the true joint's value at the end */
    double path[BOT_MAX_FRAMES][2];
    int frames;
    double length; /* of the true path, pixels */
    vec way;       /* of a naive hand in space, from the grabbed point to the end */
} bot_pull;

/* Where the true joint at `value` takes a point. */
vec bot_true_move(const known_joint* truth, vec point, double value);
/* Returns the unit direction in which the true joint moves a point at first on its way to `value`. */
vec bot_true_direction(const known_joint* truth, vec point, double value);
/* Returns the value of the true joint that the bot pulls to. */
double bot_travel(const known_joint* truth, double size);
/* Minimum-jerk progress, 0 to 1, at a share of the time. */
double bot_minimum_jerk(double share);
/* Chooses a grab point and path. Returns 1; 0: the part is not visible; -1: visible, but no point of it has a path that
 * a mouse can draw. */
int bot_choose_pull(const bot_view* view, uint32_t part, const known_joint* truth, double size, random_state* random,
                    bot_pull* out_pull);

/* Grabs the point in the middle of the screen and pulls `pixels` straight to a side: 0 up, 1 down, 2 left, 3 right.
 * Returns false when the part is not what is seen there, or not near `point`. */
bool bot_pull_aside(const bot_view* view, uint32_t part, vec point, double tolerance, int side, double pixels,
                    bot_pull* out_pull);

/* How the player's hand deviates from the true path. All 0: not at all. */
typedef struct bot_hand {
    int straight;      /* from the grabbed pixel straight to the end of the path */
    int axis;          /* straight in the world, along the axis of the file nearest to the true way */
    double wander;     /* largest deviation: standard deviation in x and in y, share of the path's length */
    double tremor;     /* the same in every frame independently, pixels */
    double jostle;     /* goes the wrong way first, pixels */
    double offset;     /* the pointer is beside the grabbed point from the first frame on, and rests at first, pixels */
    int pause;         /* stops half-way and goes on */
    int regrab;        /* lets go and grabs again so often on the way */
    int hz;            /* updates a second; 0 = 60 */
    int hitch;         /* one update of a quarter of a second */
    int moving_camera; /* the camera turns round the part during the pull */
    int moving_instance; /* the object turns and rises in the world during the pull */
    int point;           /* a hand in space, where the true joint takes the grabbed point, in place of a pointer */
    int scalar;          /* a gamepad's axis in place of a pointer, steered by what the player sees of the part */
    int naive;           /* doesn't know the true path: dragbot_naive.h; then also: */
    double degrees;      /* its direction is off by so much at most */
    int snap;            /* along the screen's axis nearest to the first true direction */
    int up;              /* up the screen */
} bot_hand;

/* Bends the path as the hand draws it. Returns false when the path left is none that a mouse can draw. */
bool bot_hand_draw(const bot_hand* hand, const bot_view* view, const known_joint* truth, random_state* random,
                   bot_pull* pull);

/* ---- what the hand does, update by update ---- */

typedef struct bot_step {
    double dt;     /* s since the update before, or since the frame before the grab */
    double at;     /* place on the pull's path: an index with a fraction; -1: the grabbed pixel */
    double beside; /* of the pointer from the path: of the way that the jostle goes, 0 to 1 */
    double moved;  /* of the way of a moving camera or instance, 0 to 1 */
    bool on_way;   /* the pointer is on its way: the grabbed point must be near it */
    bool resting;  /* has not moved yet since the grab */
    bool regrabs;  /* lets go and grabs again just before */
} bot_step;

typedef struct bot_plan {
    bot_step* steps;
    int count;
    double offset[2], jostle[2]; /* px */
} bot_plan;

/* To be freed: steps. */
bot_plan bot_plan_make(const bot_hand* hand, const bot_pull* pull, random_state* random);
/* Returns the pixel of a step before it is rounded, with the camera and the instance where they were at the grab. */
void bot_plan_pointer(const bot_plan* plan, const bot_pull* pull, const bot_step* step, double out_pointer[2]);

/* ---- playing ---- */

typedef struct bot_times {
    float* ns;
    size_t count, room;
} bot_times;

/* Vertices that stand for all of a part's: the farthest both ways along 13 directions. */
enum { BOT_EXTREMES = 26 };

typedef struct bot_part {
    uint32_t id;
    vec centre; /* of its vertices */
    vec extremes[BOT_EXTREMES];
    vec swept_centre; /* of a ball round the part along its whole pull */
    double swept_radius;
    double object_size;
} bot_part;

typedef struct bot_result {
    bool picked;       /* the right part */
    double reached;    /* share of what was asked, on the true joint */
    double off;        /* farthest that the grabbed point was from the pointer, share of the screen's height */
    int jumps;         /* frames */
    double worst_jump; /* px */
    int changes;       /* of the joint, told by the pull */
    bool arrived;      /* 90 to 110 % of what was asked */
    bool near;         /* always within 2 % of the screen's height of the pointer */
    bool success;
    bool success_or_beyond;    /* the same, but going too far is no failure */
    bool stuck;                /* the grabbed point has gone less than a tenth of its way */
    bool still_moved;          /* the part moved, or its joint changed, while the pointer rested after the grab */
    int regrabs, regrab_jumps; /* the part moved by over 1 % of the object's size in the first frame after */
    double through;            /* how deep the part was in the body, share of the object's size */
    bool own_way;              /* the part is where its true joint can take it */
    double worst_regrab;       /* share of the object's size */
    dm_part_state end;
    dm_pose pose; /* as shown at the end */
} bot_result;

/* Where a pose takes a point. */
vec bot_moved(const dm_pose* pose, vec point);
/* Returns how far the part's vertices are apart under two poses, at most; share of the object's size. */
double bot_apart(const bot_part* part, const dm_pose* a, const dm_pose* b);
/* Returns the joint that the library is given where it is told the truth. */
dm_joint bot_true_joint(const known_joint* truth);

/* A case: where from, what and how. */
struct bot_body;
typedef struct bot_case {
    const char* id;
    bool given;                 /* with the true joint */
    uint32_t flags;             /* DM_DRAG_* */
    const dm_part_state* state; /* that the drag begins with; NULL: the object's joint, at rest */
    const bot_view* view;
    const bot_pull* pull;
    const bot_hand* hand;
    const bot_plan* plan;
    const bot_part* part;
    const known_joint* truth;
    vec up;
    struct bot_body* body; /* what the part must not go through; NULL: not looked at */
    output_file* poses;    /* NULL, or where every update is written */
} bot_case;

/* An update, kept until the drag has ended, so that nothing but the drag runs during it. */
typedef struct bot_frame {
    dm_pose pose;
    float value;
    dm_ray ray;     /* object frame */
    dm_joint joint; /* set when the poses are written */
} bot_frame;

/* Writes every update as a line of JSON. */
void bot_poses_write(const bot_case* played, const bot_frame* frames, int count);

/* Lets go of the part and grabs it again where it is, as docs/integration.md says. state: the last one. */
dm_result bot_regrab(session* session, uint32_t part, dm_drag* drag, dm_drag_state* state);

/* Picks and drags. With a straight pull the grabbed point need not stay near the pointer. */
dm_result bot_play(session* session, dm_scene scene, const bot_case* played, bot_times* times, bot_result* out_result);

#endif
