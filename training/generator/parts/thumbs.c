/* Implements controls for thumbs and fingers on hand-held things: sticks in a spherical skirt, touch pads, keys with
 * little travel, triggers that are shells. Controllers and headsets share them. */
#include "parts/thumbs.h"

void dmg_rows_draw(dmg_builder* b, const dmg_vec* at, int rows, int columns, unsigned flags) {
    uint32_t first = b->vertex_count, width = (uint32_t)columns;
    const bool round = (flags & DMG_ROWS_ROUND) != 0;
    dmg_piece_begin(b);
    for (int i = 0; i < rows * columns; ++i) dmg_vertex(b, at[i]);
    for (uint32_t r = 0; r + 1 < (uint32_t)rows; ++r) {
        uint32_t here = first + r * width, below = here + width;
        for (uint32_t c = 0; c + (round ? 0 : 1) < width; ++c) {
            uint32_t next = (c + 1) % width;
            dmg_quad(b, here + c, below + c, below + next, here + next);
        }
    }
    uint32_t last = first + (uint32_t)(rows - 1) * width;
    for (uint32_t c = 1; c + 1 < width; ++c) {
        if (flags & DMG_ROWS_CAP_FIRST) dmg_triangle(b, first, first + c, first + c + 1);
        if (flags & DMG_ROWS_CAP_LAST) dmg_triangle(b, last, last + c + 1, last + c);
    }
}

/* ---- sticks ---- */

/* Draws a cap on a stem, concave, flat, domed or ribbed; from z = low to z = high. */
static void draw_cap(dmg_builder* b, float radius, float low, float high) {
    float stem = radius * dmg_range(b, 0.3f, 0.65f), rim = (high - low) * dmg_range(b, 0.25f, 0.5f),
          dish = rim * dmg_range(b, -0.5f, 0.7f), waist = dmg_range(b, 0.7f, 1.0f);
    const dmg_xy profile[] = {{stem, low},
                              {waist * stem, 0.5f * (low + high - rim)},
                              {0.9f * radius, high - rim},
                              {radius, high - 0.6f * rim},
                              {0.96f * radius, high},
                              {0.7f * radius, high - 0.6f * dish},
                              {0, high - dish}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, 7);
}

/* The opening the stick comes out of: a crater, a ring, or nothing. */
static void draw_stick_rim(dmg_builder* b, float radius) {
    int kind = dmg_int(b, 0, 3);
    float thick = radius * dmg_range(b, 0.05f, 0.2f);
    const dmg_xy crater[] = {{1.35f * radius, -thick},
                             {1.25f * radius, thick},
                             {1.12f * radius, thick},
                             {1.02f * radius, -thick},
                             {0.98f * radius, -3 * thick}};
    if (kind == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), crater, 5);
    if (kind == 1) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.15f * radius, thick);
}

/* Real sticks are ball joints: the skirt is a piece of a sphere that hides the hole whichever way it leans, and the
 * pivot is that sphere's centre, below the face. Here it has one of its three motions; the drag tells which. */
void dmg_thumb_stick_draw(dmg_builder* b, uint32_t parent, float radius) {
    float ball = radius * dmg_range(b, 0.75f, 1.5f), top = radius * dmg_range(b, -0.1f, 0.45f), centre = top - ball,
          pivot = centre * (dmg_chance(b, 0.75f) ? dmg_range(b, 0.8f, 1.2f) : dmg_range(b, -0.1f, 1.8f)),
          swing = dmg_range(b, 0.15f, 0.42f), down = radius * dmg_range(b, 0.04f, 0.25f);
    draw_stick_rim(b, fmaxf(ball, radius));
    int motion = dmg_int(b, 0, 2);
    dmg_vec line = motion == 1 ? v3(1, 0, 0) : v3(0, 1, 0);
    if (motion == 0)
        dmg_slide(b, parent, "thumb_stick", v3(0, 0, -1), 0.0f, down);
    else
        dmg_hinge(b, parent, "thumb_stick", v3(0, 0, pivot), line, -swing, swing * dmg_range(b, 0.8f, 1.0f));
    float wide = dmg_range(b, 0.7f, 1.55f), high = top + radius * dmg_range(b, 0.45f, 1.1f);
    enum { ZONE = 5 };
    dmg_xy skirt[ZONE + 1];
    for (int i = 0; i < ZONE; ++i) { /* from the rim up */
        float angle = wide * (1.0f - (float)i / ZONE);
        skirt[i] = (dmg_xy){ball * sinf(angle), centre + ball * cosf(angle)};
    }
    skirt[ZONE] = (dmg_xy){0, top};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), skirt, ZONE + 1);
    if (dmg_chance(b, 0.2f)) /* the part inside that nobody sees */
        dmg_rod(b, v3(0, 0, centre), v3(0, 0, top), 0.3f * radius);
    draw_cap(b, radius, top - 0.05f * radius, high);
    dmg_use(b, parent);
}

/* ---- pads and keys ---- */

/* A pad is pressed, or tips a little about a line through its middle; the pivot is just below its face. */
void dmg_touch_pad_draw(dmg_builder* b, uint32_t parent, float radius) {
    float thick = radius * dmg_range(b, 0.05f, 0.3f), rise = radius * dmg_range(b, 0.02f, 0.15f),
          swing = dmg_range(b, 0.04f, 0.2f), dish = dmg_range(b, -0.1f, 0.1f) * radius;
    int motion = dmg_int(b, 0, 2), shape = dmg_int(b, 0, 2);
    if (motion == 0)
        dmg_slide(b, parent, "touch_pad", v3(0, 0, -1), 0.0f, rise * dmg_scale_range(b, 0.15f, 0.9f));
    else
        dmg_hinge(b, parent, "touch_pad", v3(0, 0, rise - thick * dmg_range(b, 0, 1.5f)),
                  motion == 1 ? v3(1, 0, 0) : v3(0, 1, 0), -swing, swing);
    if (shape < 2) { /* a face with an edge, or the face alone */
        const dmg_xy disc[] = {
            {radius, rise - thick}, {radius, rise}, {0.6f * radius, rise + 0.5f * dish}, {0, rise + dish}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), disc + shape, 4 - shape);
    } else {
        float x = radius * dmg_range(b, 1.2f, 2.0f), y = radius * dmg_range(b, 1.2f, 2.2f);
        dmg_move(b, 0, 0, rise);
        dmg_rounded_plate(b, x, y, thick, dmg_range(b, 0.1f, 0.5f) * x);
        dmg_move(b, 0, 0, -rise);
    }
    dmg_use(b, parent);
}

/* Most of a key is inside and it sinks by little: a switch's way is a millimetre or less, its plunger's length several.
 */
void dmg_thumb_key_draw(dmg_builder* b, uint32_t parent, const char* name, float radius) {
    float rise = radius * dmg_range(b, 0.08f, 0.8f), inside = radius * dmg_range(b, 0.0f, 1.2f),
          dome = rise * dmg_range(b, 0, 0.6f);
    float way = fminf((rise + inside) * dmg_scale_range(b, 0.04f, 0.5f), 0.5f * rise - 0.3f * dome);
    int shape = dmg_int(b, 0, 3);
    float thin = radius * dmg_range(b, 0.03f, 0.12f);
    if (dmg_chance(b, 0.25f)) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.08f * radius, thin);
    dmg_slide(b, parent, name, v3(0, 0, -1), 0.0f, way);
    const dmg_xy turned[] = {
        {0, -inside}, {radius, -inside}, {radius, rise - dome}, {0.8f * radius, rise - 0.3f * dome}, {0, rise}};
    if (shape == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), turned, 5);
    if (shape == 1) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), turned + 1, 4); /* open below */
    if (shape == 2) dmg_ellipsoid(b, v3(0, 0, 0), v3(radius, radius * dmg_range(b, 0.4f, 1.0f), rise));
    if (shape == 3) {
        dmg_move(b, 0, 0, rise);
        dmg_rounded_plate(b, 2 * radius, radius * dmg_range(b, 0.6f, 2.0f), rise + inside + thin, 0.4f * radius);
        dmg_move(b, 0, 0, -rise);
    }
    dmg_use(b, parent);
}

/* ---- triggers ---- */

enum { TRIGGER_ROWS = 7, TRIGGER_COLUMNS = 7 };

typedef struct trigger_shape {
    float width, length, depth; /* half width; from root to tip; of the wrap about the finger */
    float bulge, hook, taper, wrap;
} trigger_shape;

static dmg_vec trigger_point(const trigger_shape* t, float s, float u, float inward) {
    float angle = t->wrap * u, wide = t->width * (1.0f - t->taper * s);
    float z = t->length * (t->bulge * sinf(DMG_PI * s) + t->hook * s * s) - t->depth * (1.0f - cosf(angle));
    return v3(wide * sinf(angle) / sinf(t->wrap) * (1.0f - 0.3f * inward), -t->length * s, z - inward * t->depth);
}

/* Draws a shell that wraps the finger's side of the housing, open behind or closed by a flat back. */
static void draw_trigger_shell(dmg_builder* b, const trigger_shape* t, bool closed) {
    dmg_vec at[(TRIGGER_ROWS + 1) * (TRIGGER_COLUMNS + 2)];
    int count = 0;
    for (int r = 0; r <= TRIGGER_ROWS; ++r) {
        bool lip = r == TRIGGER_ROWS; /* the tip is folded in */
        float s = fminf(1.0f, (float)r / (TRIGGER_ROWS - 1)), inward = lip ? 0.5f : 0.0f;
        for (int c = 0; c < TRIGGER_COLUMNS; ++c)
            at[count++] = trigger_point(t, s, 2.0f * (float)c / (TRIGGER_COLUMNS - 1) - 1.0f, inward);
        if (!closed) continue;
        dmg_vec right = at[count - 1], left = at[count - TRIGGER_COLUMNS];
        at[count++] = v3(0.9f * right.x, right.y, right.z - 0.3f * t->depth);
        at[count++] = v3(0.9f * left.x, left.y, left.z - 0.3f * t->depth);
    }
    dmg_rows_draw(b, at, TRIGGER_ROWS + 1, TRIGGER_COLUMNS + (closed ? 2 : 0), closed ? DMG_ROWS_TUBE : 0);
}

/* Where the pin is: at the root as a rule, for the lever is to be long and the pin to have room in the housing; behind
 * the shell or half-way along it in others. */
static dmg_vec pick_pin(dmg_builder* b, const trigger_shape* t) {
    int where = dmg_int(b, 0, 9);
    float y = dmg_range(b, -0.12f, 0.12f), z = dmg_range(b, -0.15f, 0.1f);
    if (where >= 6) { /* deeper in, above or behind */
        y = dmg_range(b, -0.3f, 0.4f);
        z = dmg_range(b, -0.7f, 0.1f);
    }
    if (where == 9) y -= 0.3f;
    return v3(0, y * t->length, z * t->length);
}

void dmg_trigger_shell_draw(dmg_builder* b, uint32_t parent, const char* name, float width, float length) {
    trigger_shape t = {.width = 0.5f * width, .length = length};
    t.depth = length * dmg_range(b, 0.1f, 0.6f);
    t.bulge = dmg_range(b, -0.3f, 0.2f);
    t.hook = dmg_range(b, -0.1f, 0.5f);
    t.taper = dmg_range(b, -0.1f, 0.5f);
    t.wrap = dmg_range(b, 0.5f, 1.55f);
    dmg_vec pin = pick_pin(b, &t);
    float pull = dmg_range(b, 0.1f, 0.55f);
    dmg_hinge(b, parent, name, pin, v3(1, 0, 0), 0.0f, pull);
    draw_trigger_shell(b, &t, dmg_chance(b, 0.45f));
    if (dmg_chance(b, 0.2f)) /* the eye on the pin */
        dmg_rod(b, v3(-0.7f * t.width, pin.y, pin.z), v3(0.7f * t.width, pin.y, pin.z), 0.08f * length);
    dmg_use(b, parent);
}

/* ---- grips ---- */

enum { PAD_GRID = 7 };

/* A lever let into a handle of elliptical section along Z, middle of the lever at `angle` round it. It goes straight
 * in, towards the palm (along X) though it sits on the corner, or turns about one of its ends. */
void dmg_squeeze_draw(dmg_builder* b, const dmg_handle_section* h, float angle, float z, float length) {
    float arc = dmg_range(b, 0.25f, 0.6f), rise = h->half_width * dmg_range(b, 0.06f, 0.25f),
          way = rise * dmg_range(b, 0.3f, 0.8f), square = dmg_range(b, 0, 1), end = dmg_sign(b);
    dmg_vec out = v3_normalize(v3(cosf(angle) / h->half_width, sinf(angle) / h->half_height, 0));
    dmg_vec tangent = v3(-out.y, out.x, 0), press = v3_scale(out, -1);
    int motion = dmg_int(b, 0, 3);
    if (motion == 1 && fabsf(out.x) > 0.5f) press = v3(out.x > 0 ? -1 : 1, 0, 0);
    if (motion == 3) {
        dmg_vec pin = v3((h->half_width - rise) * cosf(angle), h->middle + (h->half_height - rise) * sinf(angle),
                         z + end * length * dmg_range(b, 0.45f, 0.6f));
        dmg_hinge(b, 0, "squeeze", pin, v3_scale(tangent, end), 0.0f, fminf(0.3f, 1.5f * way / length));
    } else {
        dmg_slide(b, 0, "squeeze", press, 0.0f, way);
    }
    dmg_vec at[PAD_GRID * PAD_GRID];
    for (int k = 0; k < PAD_GRID * PAD_GRID; ++k) {
        float i = 2.0f * (float)(k % PAD_GRID) / (PAD_GRID - 1) - 1.0f,
              j = 1.0f - 2.0f * (float)(k / PAD_GRID) / (PAD_GRID - 1), edge = fmaxf(fabsf(i), fabsf(j));
        /* Between a square and a disc. */
        float u = i * (square + (1 - square) * sqrtf(1.0f - 0.5f * j * j)),
              v = j * (square + (1 - square) * sqrtf(1.0f - 0.5f * i * i));
        float grow = rise * (1.0f - 1.4f * edge * edge * edge * edge), a = angle + arc * u;
        at[k] =
            v3((h->half_width + grow) * cosf(a), h->middle + (h->half_height + grow) * sinf(a), z + 0.5f * length * v);
    }
    dmg_rows_draw(b, at, PAD_GRID, PAD_GRID, 0);
    dmg_use(b, 0);
}
