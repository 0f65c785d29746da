/* Declares hardware that categories share: handles, hinges, panels, carcasses, fronts, feet, wheels. */
#ifndef DMG_HARDWARE_H
#define DMG_HARDWARE_H

#include "core/build.h"

/* ---- handles (handles.c): on the surface z = 0 facing +Z, the long side along Y, centred at the origin ---- */

typedef enum dmg_handle_kind {
    DMG_HANDLE_NONE,
    DMG_HANDLE_BAR,  /* a rod on two posts */
    DMG_HANDLE_FLAT, /* a flat bar on two posts */
    DMG_HANDLE_ARCH, /* one bent rod */
    DMG_HANDLE_KNOB, /* turned */
    DMG_HANDLE_BALL,
    DMG_HANDLE_BLOCK,    /* a block glued on */
    DMG_HANDLE_CUP,      /* half a shell to reach into */
    DMG_HANDLE_RECESSED, /* a dish let into the front, with a rim */
    DMG_HANDLE_RING,     /* a ring hanging from a plate */
    DMG_HANDLE_LIP,      /* a profile along the whole length */
    DMG_HANDLE_KINDS
} dmg_handle_kind;

typedef struct dmg_handle {
    dmg_handle_kind kind;
    float length;    /* metres, of bars; cut to what there is room for */
    float thickness; /* of rods; knobs are a few times as wide */
    float standoff;  /* from the surface */
    float post;      /* where the posts sit: fraction of half the length */
} dmg_handle;

/* Picks a handle. hand: the length of a usual handle on such an object, metres (a cupboard: 0.15). */
dmg_handle dmg_handle_pick(dmg_builder* b, float hand);
/* Picks one of the kinds used on heavy doors: bars and similar. */
dmg_handle dmg_handle_pick_bar(dmg_builder* b, float hand);
/* Draws a handle. room: the largest length, metres. */
void dmg_handle_draw(dmg_builder* b, const dmg_handle* handle, float room);

/* A knob on z = 0, axis +Z: what turns on panels, taps and doors. Its pointer, if any, points to +Y. */
void dmg_knob_draw(dmg_builder* b, int kind, float radius, float height);
enum { DMG_KNOB_KINDS = 7 };
/* Of any kind, between `flattest` and `tallest` radii high. */
void dmg_any_knob_draw(dmg_builder* b, float radius, float flattest, float tallest);

/* ---- hinges (hinges.c): axis along Y through the origin, the leaf towards +X, its front towards +Z ---- */

typedef enum dmg_hinge_kind {
    DMG_HINGE_NONE,
    DMG_HINGE_BARREL, /* knuckles shared by leaf and frame */
    DMG_HINGE_PIANO,  /* one rod along the whole length */
    DMG_HINGE_LUGS,   /* ears on the frame, a pin through them */
    DMG_HINGE_STRAP,  /* long straps over the leaf */
    DMG_HINGE_PIVOT,  /* pins at both ends */
    DMG_HINGE_KINDS
} dmg_hinge_kind;

typedef struct dmg_hinge_style {
    dmg_hinge_kind kind;
    int count;
    float radius, length; /* of a knuckle */
    float inset;          /* of the outermost knuckle from the end, fraction of the line */
} dmg_hinge_style;

dmg_hinge_style dmg_hinge_pick(dmg_builder* b, float radius);
/* Draws onto `leaf` and onto `frame` (part ids); leaves `leaf` in use. width: of the leaf, for straps. */
void dmg_hinge_draw(dmg_builder* b, const dmg_hinge_style* style, float line, float width, uint32_t leaf,
                    uint32_t frame);

/* ---- panels (panels.c): centred in x and y, front at z = 0, back at z = -thickness ---- */

typedef enum dmg_panel_kind {
    DMG_PANEL_FLAT,
    DMG_PANEL_ROUNDED, /* rounded outline */
    DMG_PANEL_SOFT,    /* all edges rounded */
    DMG_PANEL_SHEET,   /* one face, no thickness */
    DMG_PANEL_FRAMED,  /* rails and stiles round an infill */
    DMG_PANEL_RAISED,  /* a smaller field on top */
    DMG_PANEL_WINDOW,  /* frame and a thin pane */
    DMG_PANEL_HOLLOW,  /* frame alone */
    DMG_PANEL_BARS,    /* frame and bars */
    DMG_PANEL_LOUVRES, /* frame and slats */
    DMG_PANEL_PLANKS,  /* boards side by side, with battens */
    DMG_PANEL_BOWED,   /* curved outwards */
    DMG_PANEL_KINDS
} dmg_panel_kind;

typedef struct dmg_panel {
    dmg_panel_kind kind;
    float border; /* fraction of the smaller side */
    float infill; /* thickness of the infill, fraction of the panel's */
    int bars_x, bars_y;
} dmg_panel;

dmg_panel dmg_panel_pick(dmg_builder* b);
/* Glazed kinds alone, with muntins sometimes. */
dmg_panel dmg_panel_pick_window(dmg_builder* b);
void dmg_panel_draw(dmg_builder* b, const dmg_panel* panel, float width, float height, float thickness);
/* A plate with a round hole in its middle: front at z = 0. */
void dmg_holed_plate_draw(dmg_builder* b, float width, float height, float thickness, float radius);
/* Four bars round a rectangle: front at z = 0. */
void dmg_frame_draw(dmg_builder* b, float width, float height, float thickness, float border);

/* An outer case, centred in x and y, open at the front z = 0, back at z = -depth. */
typedef enum dmg_case_kind {
    DMG_CASE_BOARDS, /* walls with thickness */
    DMG_CASE_SHEET,  /* five single faces */
    DMG_CASE_DOUBLE, /* outer and inner skin joined at the rim */
    DMG_CASE_SOLID,  /* a block: no inside */
    DMG_CASE_KINDS
} dmg_case_kind;

dmg_case_kind dmg_case_pick(dmg_builder* b);
void dmg_case_draw(dmg_builder* b, dmg_case_kind kind, float width, float height, float depth, float wall);
/* Turns the frame so that a case drawn with its opening at z = 0 opens upwards at y = 0. */
void dmg_face_up(dmg_builder* b);

/* Feet, plinth, casters or nothing below the rectangle width x depth at y = height; they reach down to y = 0. */
void dmg_feet_draw(dmg_builder* b, int kind, float width, float depth, float height);
enum { DMG_FEET_KINDS = 5 };

/* ---- leaves and drawers on a front (fronts.c): the opening is centred at the origin, front at z = 0 ---- */

typedef enum dmg_side { DMG_SIDE_LEFT, DMG_SIDE_RIGHT, DMG_SIDE_TOP, DMG_SIDE_BOTTOM } dmg_side;

typedef struct dmg_leaf {
    float width, height, thickness;
    dmg_side side;      /* where it is hung */
    float swing;        /* rad */
    float inset;        /* of the axis from the hung edge, fraction of the thickness; negative is outside */
    float depth;        /* of the axis behind the front, fraction of the thickness */
    float handle_at;    /* along the free edge, -0.5 … 0.5 */
    float handle_edge;  /* from the free edge, fraction of the leaf's width */
    bool handle_across; /* turned by 90 degrees */
    dmg_panel panel;
    dmg_handle handle;
    dmg_hinge_style hinge;
} dmg_leaf;

/* Returns a usual leaf with everything but size and side filled in. */
dmg_leaf dmg_leaf_pick(dmg_builder* b, float hand);
/* Draws the hinge line again, by one of several conventions of modellers. */
void dmg_leaf_pick_line(dmg_builder* b, dmg_leaf* leaf);
/* Adds the part, draws it, leaves it in use. */
uint32_t dmg_leaf_draw(dmg_builder* b, uint32_t parent, const char* name, const dmg_leaf* leaf);

typedef enum dmg_tray_kind {
    DMG_TRAY_NONE,
    DMG_TRAY_BOARDS,
    DMG_TRAY_SHEET,
    DMG_TRAY_SOLID,
    DMG_TRAY_WIRE
} dmg_tray_kind;

typedef struct dmg_drawer {
    float width, height, thickness;
    float depth;       /* of the tray behind the front */
    float travel;      /* metres */
    float tray_height; /* fraction of the height */
    float wall;
    dmg_tray_kind tray;
    dmg_panel panel;
    dmg_handle handle;
    int handles;     /* side by side */
    float handle_at; /* height, -0.5 … 0.5 */
} dmg_drawer;

dmg_drawer dmg_drawer_pick(dmg_builder* b, float hand);
uint32_t dmg_drawer_draw(dmg_builder* b, uint32_t parent, const char* name, const dmg_drawer* drawer);
/* An open tray, top at y = height, floor at y = 0, front at z = 0, back at z = -depth. */
void dmg_tray_draw(dmg_builder* b, dmg_tray_kind kind, float width, float height, float depth, float wall);

/* Push buttons on z = 0 facing +Z: `columns` x `rows` parts round the origin, pitch apart, each sinking by its travel.
 */
typedef struct dmg_buttons {
    const char* name;
    int columns, rows;
    float pitch_x, pitch_y, width, height, rise, travel;
    int kind; /* 0 box, 1 round, 2 rounded box, 3 domed */
} dmg_buttons;

/* Returns the travel of a button that stands out by `rise`: most of it, or a small share, as a switch under a key
 * allows. */
float dmg_button_way(dmg_builder* b, float rise);
void dmg_buttons_draw(dmg_builder* b, uint32_t parent, const dmg_buttons* buttons);

/* Leaves that slide past each other along X, on two tracks behind z = 0, filling a width centred at the origin. */
typedef struct dmg_sliding {
    const char* name;
    int leaves;
    float width, height, leaf, thickness; /* leaf: the width of one */
    dmg_panel panel;
    dmg_handle handle;
} dmg_sliding;

void dmg_sliding_draw(dmg_builder* b, const dmg_sliding* s);

/* ---- what appliances share (fittings.c) ---- */

/* A door thicker than furniture's, with a bar or nothing to pull it. */
dmg_leaf dmg_leaf_pick_appliance(dmg_builder* b, float width, float height, float thickness);
/* A row of knobs that turn, along (pitch_x, pitch_y), on z = 0 facing +Z. */
void dmg_knobs_draw(dmg_builder* b, uint32_t parent, int count, float pitch_x, float pitch_y, float radius);
/* Buttons, knobs or both on a panel of the given size, centred at the origin of z = 0. */
void dmg_controls_draw(dmg_builder* b, uint32_t parent, float width, float height);
/* Racks behind a closed door that slide out of a cavity whose opening is centred at z = 0. */
void dmg_racks_draw(dmg_builder* b, const char* name, int count, float width, float height, float depth, float rack);

/* ---- wheels (rounds.c): about the axis Z, centred at the origin ---- */

enum { DMG_WHEEL_KINDS = 7 };
void dmg_wheel_draw(dmg_builder* b, int kind, float radius, float width, int spokes);
enum { DMG_BLADE_KINDS = 4 };
void dmg_blades_draw(dmg_builder* b, int kind, float radius, float hub, float chord, int count, float twist);

#endif
