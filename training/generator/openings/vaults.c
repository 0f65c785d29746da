/* Draws stone and iron props of dungeons and yards: coffins whose lids slide, slew or hang on hinges, wells with a
 * windlass, gates that are drawn up in grooves, cell doors with their bolts. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- coffins ---- */

/* An outline in x, z about the origin, from foot (-z) to head (+z). */
typedef struct coffin {
    dmg_xy outline[8];
    int count;
    float length, width, high, wall, shoulder;
} coffin;

static coffin pick_coffin(dmg_builder* b) {
    coffin c = {.length = dmg_scale_range(b, 0.4f, 2.6f)};
    float foot = dmg_range(b, 0.55f, 1.0f);
    c.width = c.length * dmg_range(b, 0.28f, 0.48f);
    c.high = c.length * dmg_range(b, 0.18f, 0.45f);
    c.wall = c.width * dmg_range(b, 0.06f, 0.15f);
    float x = 0.5f * c.width, z = 0.5f * c.length;
    int shape = dmg_int(b, 0, 2);
    c.shoulder = shape == 1 ? z * dmg_range(b, 0.2f, 0.5f) : 0.0f;
    const dmg_xy box[] = {{-x, -z}, {x, -z}, {x, z}, {-x, z}};
    const dmg_xy six[] = {{-foot * x, -z}, {foot * x, -z}, {x, c.shoulder},
                          {0.7f * x, z},   {-0.7f * x, z}, {-x, c.shoulder}};
    const dmg_xy cut[] = {{-0.7f * x, -z}, {0.7f * x, -z}, {x, -0.8f * z}, {x, 0.8f * z},
                          {0.7f * x, z},   {-0.7f * x, z}, {-x, 0.8f * z}, {-x, -0.8f * z}};
    c.count = shape == 0 ? 4 : shape == 1 ? 6 : 8;
    for (int i = 0; i < c.count; ++i) c.outline[i] = shape == 0 ? box[i] : shape == 1 ? six[i] : cut[i];
    return c;
}

/* Draws the frame whose x, y are the object's x, z and whose +Z is down; so heights are written negative. */
static void lay_down(dmg_builder* b) {
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
}

static void draw_outline(dmg_builder* b, const coffin* c, float scale_x, float scale_z, float low, float high) {
    dmg_xy outline[8];
    for (int i = 0; i < c->count; ++i) outline[i] = (dmg_xy){scale_x * c->outline[i].x, scale_z * c->outline[i].y};
    dmg_save(b);
    lay_down(b);
    dmg_extrude(b, outline, c->count, -high, -low);
    dmg_restore(b);
}

/* Walls round a floor, a solid block with a dish, or a block; with a plinth and ledges or plain. */
static void draw_coffin(dmg_builder* b, const coffin* c) {
    int kind = dmg_int(b, 0, 2);
    float in_x = 1.0f - 2.0f * c->wall / c->width, in_z = 1.0f - 2.0f * c->wall / c->length;
    if (kind < 2) {
        dmg_xy inner[8];
        for (int i = 0; i < c->count; ++i) inner[i] = (dmg_xy){in_x * c->outline[i].x, in_z * c->outline[i].y};
        dmg_save(b);
        lay_down(b);
        dmg_ring_plate(b, c->outline, inner, c->count, -c->high, -0.5f * c->wall);
        dmg_restore(b);
        draw_outline(b, c, 1, 1, 0, c->wall);
        if (kind == 1 && dmg_chance(b, 0.5f)) /* what lies in it */
            dmg_ellipsoid(b, v3(0, 0.4f * c->high, 0), v3(0.3f * c->width, 0.25f * c->high, 0.42f * c->length));
    } else {
        draw_outline(b, c, 1, 1, 0, c->high);
    }
    if (dmg_chance(b, 0.4f)) draw_outline(b, c, 1.12f, 1.06f, 0, 0.15f * c->high);
    if (!dmg_chance(b, 0.3f)) return;
    for (int s = -1; s <= 1; s += 2) { /* bars to carry it by */
        float x = (float)s * (0.5f * c->width + 0.5f * c->wall), y = 0.6f * c->high;
        dmg_rod(b, v3(x, y, -0.3f * c->length), v3(x, y, 0.3f * c->length), 0.25f * c->wall);
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3((float)s * 0.3f * c->width, y, (float)k * 0.25f * c->length),
                    v3(x, y, (float)k * 0.25f * c->length), 0.3f * c->wall);
    }
}

/* Draws a slab, a stepped or roof-shaped lid, a figure lying on it. Its underside at y = high. */
static void draw_lid(dmg_builder* b, const coffin* c, float y, float scale, int kind) {
    float t = c->wall * dmg_range(b, 0.6f, 1.5f), over = dmg_range(b, 0.0f, 0.06f);
    draw_outline(b, c, scale + over, scale + 0.5f * over, y, y + t);
    if (kind == 1) draw_outline(b, c, 0.75f, 0.85f, y + t, y + 1.8f * t);
    if (kind == 2) { /* a ridge */
        const dmg_xy roof[] = {{-0.35f * c->width, y + t},
                               {0.35f * c->width, y + t},
                               {0.1f * c->width, y + 3.0f * t},
                               {-0.1f * c->width, y + 3.0f * t}};
        dmg_extrude(b, roof, 4, -0.42f * c->length, 0.42f * c->length);
    }
    if (kind == 3) {
        dmg_ellipsoid(b, v3(0, y + t, -0.05f * c->length), v3(0.22f * c->width, 1.5f * t, 0.35f * c->length));
        dmg_ellipsoid(b, v3(0, y + 1.2f * t, 0.36f * c->length), v3(0.13f * c->width, 1.5f * t, 0.08f * c->length));
    }
    if (kind == 4) { /* a cross */
        dmg_box(b, v3(0, y + 1.1f * t, 0), v3(0.1f * c->width, 0.4f * t, 0.7f * c->length));
        dmg_box(b, v3(0, y + 1.1f * t, 0.15f * c->length), v3(0.5f * c->width, 0.4f * t, 0.1f * c->width));
    }
}

/* Barrels along one long side; half on the lid, half on the coffin. */
static void draw_side_hinges(dmg_builder* b, uint32_t lid, uint32_t frame, float x, float y, float length, float r) {
    int count = dmg_int(b, 2, 3);
    for (int i = 0; i < count; ++i) {
        float z = length * ((float)i / (float)(count - 1) - 0.5f);
        dmg_use(b, frame);
        dmg_rod(b, v3(x, y, z - 3 * r), v3(x, y, z), r);
        dmg_use(b, lid);
        dmg_rod(b, v3(x, y, z), v3(x, y, z + 3 * r), r);
    }
}

void dmg_build_sarcophagus(dmg_builder* b) {
    coffin c = pick_coffin(b);
    draw_coffin(b, &c);
    int motion = dmg_weighted(b, (const float[]){1, 1, 0.7f, 1.2f, 0.7f}, 5), kind = dmg_int(b, 0, 4);
    float y = c.high, side = dmg_sign(b), x = side * 0.5f * c.width, r = c.wall * dmg_range(b, 0.1f, 0.3f),
          scale = dmg_range(b, 0.97f, 1.05f);
    if (motion == 0) dmg_slide(b, 0, "lid", v3(side, 0, 0), 0.0f, c.width * dmg_range(b, 0.3f, 0.7f));
    if (motion == 1) { /* along two rails, or only laid on */
        float way = c.length * dmg_range(b, 0.3f, 0.8f), run = 0.5f * c.length;
        for (int s = -1; s <= 1 && c.count == 4 && dmg_chance(b, 0.6f); s += 2)
            dmg_box_span(b, v3((float)s * 0.53f * c.width - 0.3f * c.wall, y - c.wall, -run),
                         v3((float)s * 0.53f * c.width + 0.3f * c.wall, y, run));
        dmg_slide(b, 0, "lid", v3(0, 0, -1), 0.0f, way);
    }
    if (motion == 2) { /* slewed about a corner: a pin of stone shows there or not */
        float z = dmg_sign(b) * 0.4f * c.length, at = 0.38f * side * c.width;
        dmg_hinge(b, 0, "lid", v3(at, y, z), v3(0, -side * copysignf(1.0f, z), 0), 0.0f, dmg_range(b, 0.6f, 1.6f));
        if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(at, y - c.wall, z), v3(at, y + 2.5f * c.wall, z), 0.4f * c.wall);
    }
    if (motion >= 3 && c.shoulder > 0.0f) x = side * 0.5f * c.width; /* touches at the shoulder alone */
    if (motion == 3) {
        uint32_t lid = dmg_hinge(b, 0, "lid", v3(x, y, 0), v3(0, 0, -side), 0.0f, dmg_range(b, 1.2f, 2.2f));
        if (c.count != 6) draw_side_hinges(b, lid, 0, x, y, 0.6f * c.length, r);
    }
    if (motion == 4) { /* in two leaves, the head's and the foot's, each on its own */
        for (int k = 0; k < 2; ++k) {
            coffin part = c;
            float cut = 0.1f * c.length;
            part.count = 4;
            const dmg_xy half[] = {{-0.5f * c.width, k ? cut : -0.5f * c.length},
                                   {0.5f * c.width, k ? cut : -0.5f * c.length},
                                   {0.5f * c.width, k ? 0.5f * c.length : 0.99f * cut},
                                   {-0.5f * c.width, k ? 0.5f * c.length : 0.99f * cut}};
            for (int i = 0; i < 4; ++i) part.outline[i] = half[i];
            dmg_hinge(b, 0, "lid", v3(x, y, 0), v3(0, 0, -side), 0.0f, dmg_range(b, 1.2f, 2.2f));
            draw_outline(b, &part, 1, 1, y, y + c.wall);
            float z = k ? 0.3f * c.length : -0.2f * c.length;
            dmg_rounded_box(b, v3(0, y + c.wall, z), v3(0.8f * c.width, 0.8f * c.wall, 0.3f * c.length), 0.2f * c.wall);
        }
    } else {
        draw_lid(b, &c, y, scale, kind);
    }
    dmg_use(b, 0);
}

/* ---- well ---- */

/* Draws a ring of masonry: turned, or stone by stone; or a frame of boards. Rim at y = high. */
static void draw_curb(dmg_builder* b, float radius, float high, float wall) {
    int kind = dmg_int(b, 0, 2);
    const dmg_xy ring[] = {{radius, 0}, {radius, high}, {radius - wall, high}, {radius - wall, 0}, {radius, 0}};
    if (kind == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), ring, 5);
    if (kind == 1) {
        int stones = dmg_int(b, 7, 12), rows = dmg_int(b, 2, 4);
        for (int i = 0; i < stones * rows; ++i) {
            float row = (float)(i / stones), h = high / (float)rows,
                  w = 2.0f * DMG_PI * (radius - 0.5f * wall) / (float)stones;
            dmg_save(b);
            dmg_turn(b, v3(0, 1, 0), 2.0f * DMG_PI * ((float)(i % stones) + 0.5f * row) / (float)stones);
            dmg_box(b, v3(radius - 0.5f * wall, h * (row + 0.5f), 0), v3(wall, 0.94f * h, 0.97f * w));
            dmg_restore(b);
        }
    }
    if (kind == 2) {
        dmg_save(b);
        dmg_move(b, 0, high, 0);
        dmg_face_up(b);
        dmg_frame_draw(b, 2 * radius, 2 * radius, high, wall);
        dmg_restore(b);
    }
}

/* Draws two posts with a roof or a lintel on them. */
static void draw_well_head(dmg_builder* b, float x, float high, float top, float t, float radius) {
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * x - t, 0.3f * high, -t), v3((float)s * x + t, top, t));
    dmg_box_span(b, v3(-x - t, top, -t), v3(x + t, top + 2 * t, t));
    if (dmg_chance(b, 0.3f)) return;
    float rise = radius * dmg_range(b, 0.3f, 0.8f), out = radius * dmg_range(b, 0.8f, 1.3f),
          wide = x + radius * dmg_range(b, 0.1f, 0.5f);
    if (dmg_chance(b, 0.5f)) {
        dmg_cone(b, v3(0, top + 2 * t, 0), v3(0, top + 2 * t + rise, 0), 1.3f * wide, 0);
        return;
    }
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, 0, top + 2 * t + rise, 0);
        dmg_turn(b, v3(1, 0, 0), (float)s * atanf(rise / out));
        dmg_box_span(b, v3(-wide, -0.5f * t, s > 0 ? 0 : -hypotf(rise, out)),
                     v3(wide, 0.5f * t, s > 0 ? hypotf(rise, out) : 0));
        dmg_restore(b);
    }
}

static void draw_bucket(dmg_builder* b, uint32_t parent, float y, float size, float rope_to) {
    dmg_slide(b, parent, "bucket", v3(0, -1, 0), -0.1f * size, dmg_range(b, 1.0f, 3.0f) * size);
    const dmg_xy pail[] = {
        {0, 0},          {0.35f * size, 0}, {0.48f * size, size}, {0.42f * size, size}, {0.31f * size, 0.1f * size},
        {0, 0.1f * size}};
    dmg_lathe(b, v3(0, y, 0), v3(0, 1, 0), pail, 6);
    const dmg_vec bail[] = {{-0.45f * size, y + 0.95f * size, 0},
                            {-0.3f * size, y + 1.4f * size, 0},
                            {0, y + 1.55f * size, 0},
                            {0.3f * size, y + 1.4f * size, 0},
                            {0.45f * size, y + 0.95f * size, 0}};
    dmg_sweep(b, bail, 5, 0.04f * size, 0.04f * size, false);
    dmg_rod(b, v3(0, y + 1.5f * size, 0), v3(0, rope_to, 0), 0.04f * size);
    dmg_use(b, parent);
}

void dmg_build_well(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.15f, 1.0f), high = radius * dmg_range(b, 0.6f, 1.4f),
          wall = radius * dmg_range(b, 0.12f, 0.3f), top = high + radius * dmg_range(b, 1.4f, 2.4f),
          t = radius * dmg_range(b, 0.05f, 0.1f), drum = radius * dmg_range(b, 0.08f, 0.18f);
    float x = radius - 0.5f * wall, axle = high + (top - high) * dmg_range(b, 0.5f, 0.8f);
    draw_curb(b, radius, high, wall);
    draw_well_head(b, x, high, top, t, radius);
    float side = dmg_sign(b), out = x + t + radius * 0.12f, reach = radius * dmg_range(b, 0.25f, 0.5f),
          thin = 0.3f * drum;
    dmg_spin(b, 0, "windlass", v3(0, axle, 0), v3(1, 0, 0));
    dmg_rod(b, v3(-x + t, axle, 0), v3(x - t, axle, 0), drum);
    dmg_rod(b, v3(-out, axle, 0), v3(out, axle, 0), 0.4f * drum);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(-0.4f * x, axle, 0), v3(0.4f * x, axle, 0), 1.3f * drum); /* rope */
    for (int s = -1; s <= 1; s += 2) {
        float at = (float)s * out;
        if ((float)s != side && !dmg_chance(b, 0.2f)) continue;
        if (dmg_chance(b, 0.75f)) {
            dmg_box_span(b, v3(at - thin, axle - thin, -thin), v3(at + thin, axle + reach, thin));
            dmg_rod(b, v3(at, axle + reach, 0), v3(at + (float)s * 0.5f * reach, axle + reach, 0), thin);
        } else {
            dmg_save(b);
            dmg_move(b, at, axle, 0);
            dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
            dmg_wheel_draw(b, dmg_int(b, 2, 3), reach, 2 * thin, 6);
            dmg_restore(b);
        }
    }
    dmg_use(b, 0);
    bool lids = dmg_chance(b, 0.35f);
    float pail = radius * dmg_range(b, 0.3f, 0.5f), y = lids ? high + 0.2f * radius : high - 0.2f * pail;
    if (y + 1.7f * pail < axle - 1.3f * drum) draw_bucket(b, 0, y, pail, axle - drum);
    for (int s = -1; s <= 1 && lids; s += 2) { /* two flaps over the mouth */
        float z = (float)s * (radius - wall), w = x - 1.5f * t;
        dmg_hinge(b, 0, "flap", v3(0, high + 0.3f * t, z), v3((float)s, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.0f));
        dmg_box_span(b, v3(-w, high, s > 0 ? 0.005f * radius : z),
                     v3(w, high + 0.6f * t, s > 0 ? z : -0.005f * radius));
        dmg_use(b, 0);
    }
}

/* ---- gates and cells ---- */

/* Bars up and across from y = low to high about x = 0; spikes below when asked for. */
static void draw_grille(dmg_builder* b, float width, float low, float high, float r, bool spikes) {
    int columns = dmg_int(b, 4, 8), rows = dmg_int(b, 1, 6);
    bool square = dmg_chance(b, 0.5f);
    for (int i = 0; i < columns; ++i) {
        float x = width * ((float)i / (float)(columns - 1) - 0.5f);
        if (square)
            dmg_box_span(b, v3(x - r, low, -r), v3(x + r, high, r));
        else
            dmg_rod(b, v3(x, low, 0), v3(x, high, 0), r);
        if (spikes) dmg_cone(b, v3(x, low, 0), v3(x, low - 4 * r, 0), 1.2f * r, 0);
    }
    for (int i = 0; i <= rows; ++i) {
        float y = low + (high - low) * ((float)i + 0.15f) / ((float)rows + 0.3f);
        dmg_box_span(b, v3(-0.5f * width - r, y - r, -0.8f * r), v3(0.5f * width + r, y + r, 0.8f * r));
    }
}

/* Draws two piers with grooves and a lintel over them, or towers. */
static void draw_gateway(dmg_builder* b, float width, float high, float top, float deep, float groove) {
    float pier = width * dmg_range(b, 0.15f, 0.5f), x = 0.5f * width;
    bool round = dmg_chance(b, 0.3f);
    for (int s = -1; s <= 1; s += 2) {
        float in = (float)s * x, out = (float)s * (x + pier);
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3(fminf(in, out), 0, k > 0 ? groove : -0.5f * deep),
                         v3(fmaxf(in, out), top, k > 0 ? 0.5f * deep : -groove));
        dmg_box_span(b, v3(fminf(in + (float)s * 0.4f * pier, out), 0, -groove),
                     v3(fmaxf(in + (float)s * 0.4f * pier, out), top, groove));
        if (round)
            dmg_rod(b, v3((float)s * (x + 1.3f * pier), 0, 0), v3((float)s * (x + 1.3f * pier), 1.15f * top, 0),
                    0.9f * pier);
    }
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3(-x, high, k > 0 ? groove : -0.5f * deep), v3(x, top, k > 0 ? 0.5f * deep : -groove));
}

static void draw_portcullis(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.3f, 4.0f), high = width * dmg_range(b, 0.8f, 1.6f),
          r = width * dmg_range(b, 0.012f, 0.03f), deep = width * dmg_range(b, 0.15f, 0.5f),
          top = high * dmg_range(b, 1.15f, 1.5f);
    float groove = 1.5f * r;
    draw_gateway(b, width, high, top, fmaxf(deep, 6 * groove), groove);
    dmg_slide(b, 0, "gate", v3(0, 1, 0), 0.0f, high * dmg_range(b, 0.6f, 0.95f));
    draw_grille(b, width + 2 * r, 4 * r, 1.03f * high, r, dmg_chance(b, 0.7f));
    dmg_use(b, 0);
    if (!dmg_chance(b, 0.6f)) return;
    /* The drum that draws it, over the arch or on the pier's side. */
    float drum = 0.06f * width, y = top + 2.5f * drum, half = 0.4f * width, z = 0.45f * deep;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * half - 0.5f * drum, top, z - drum),
                     v3((float)s * half + 0.5f * drum, y + 1.4f * drum, z + drum));
    dmg_spin(b, 0, "winch", v3(0, y, z), v3(1, 0, 0));
    dmg_rod(b, v3(-half, y, z), v3(half, y, z), drum);
    float at = half + 1.5f * drum;
    int spikes = dmg_int(b, 1, 6);
    dmg_rod(b, v3(half, y, z), v3(at, y, z), 0.5f * drum);
    for (int i = 0; i < spikes; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / (float)spikes;
        dmg_rod(b, v3(at, y, z), v3(at, y + 4 * drum * cosf(angle), z + 4 * drum * sinf(angle)), 0.25f * drum);
    }
    if (spikes == 1) dmg_rod(b, v3(at, y + 4 * drum, z), v3(at + 3 * drum, y + 4 * drum, z), 0.25f * drum);
    dmg_use(b, 0);
}

/* Draws what a cell's door has: a bolt that slides, a hatch for food, a shutter before a spyhole, a ring. */
static void draw_door_iron(dmg_builder* b, uint32_t door, float width, float high, float front, float t,
                           float hinge_side) {
    float free = -hinge_side * 0.5f * width, y = high * dmg_range(b, 0.45f, 0.6f);
    dmg_use(b, door);
    if (dmg_chance(b, 0.8f)) {
        float length = 0.35f * width, z = front + 0.6f * t, from = free + hinge_side * 0.02f * width;
        dmg_box(b, v3(from + hinge_side * 0.5f * length, y, front + 0.15f * t), v3(0.8f * length, 2 * t, 0.3f * t));
        for (int i = 0; i < 2; ++i)
            dmg_box(b, v3(from + hinge_side * length * (i ? 0.25f : 0.75f), y, z), v3(0.4f * t, 1.6f * t, 1.4f * t));
        dmg_slide(b, door, "bolt", v3(hinge_side, 0, 0), -0.1f * length, 0.2f * length);
        dmg_rod(b, v3(from, y, z), v3(from + hinge_side * length, y, z), 0.4f * t);
        dmg_rod(b, v3(from + hinge_side * 0.5f * length, y, z), v3(from + hinge_side * 0.5f * length, y - t, z + 2 * t),
                0.3f * t);
        dmg_use(b, door);
    }
    if (dmg_chance(b, 0.6f)) {
        float w = width * dmg_range(b, 0.25f, 0.45f), h = high * dmg_range(b, 0.06f, 0.12f),
              at = high * dmg_range(b, 0.7f, 0.8f);
        bool slides = dmg_chance(b, 0.5f);
        if (slides) { /* in two rails across the door */
            for (int k = -1; k <= 1; k += 2)
                dmg_box(b, v3(0, at + (float)k * 0.55f * h, front + 0.4f * t), v3(1.8f * w, 0.15f * h, 0.8f * t));
            dmg_slide(b, door, "shutter", v3(dmg_sign(b), 0, 0), 0.0f, 0.4f * w);
        } else {
            bool down = dmg_chance(b, 0.5f);
            dmg_hinge(b, door, "shutter", v3(0, at + (down ? -0.5f : 0.5f) * h, front + 0.2f * t),
                      v3(down ? 1 : -1, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.5f));
        }
        dmg_box(b, v3(0, at, front + 0.25f * t), v3(w, 0.95f * h, 0.3f * t));
        dmg_rod(b, v3(0.3f * w, at, front), v3(0.3f * w, at, front + 1.2f * t), 0.2f * t);
    }
    dmg_use(b, door);
    if (dmg_chance(b, 0.4f))
        dmg_torus(b, v3(free + hinge_side * 0.15f * width, y - 0.12f * high, front + 0.4f * t), v3(0, 0, 1),
                  0.06f * width, 0.4f * t);
}

static void draw_cell(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.3f, 1.2f), high = width * dmg_range(b, 1.6f, 2.4f),
          t = width * dmg_range(b, 0.03f, 0.06f), side = dmg_sign(b), wing = width * dmg_range(b, 0.3f, 1.6f);
    bool bars = dmg_chance(b, 0.5f), slides = bars && dmg_chance(b, 0.35f);
    for (int s = -1; s <= 1; s += 2) { /* the wall to both sides: bars or stone */
        float x = (float)s * (0.52f * width + 0.5f * wing);
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        if (bars)
            draw_grille(b, wing, 0, high, 0.3f * t, false);
        else
            dmg_box_span(b, v3(-0.5f * wing, 0, -2 * t), v3(0.5f * wing, 1.2f * high, t));
        dmg_restore(b);
    }
    float reach = 0.52f * width + wing;
    dmg_box_span(b, v3(-reach, 1.01f * high, -2 * t), v3(reach, 1.2f * high, t));
    float z = slides ? 1.2f * t : 0.0f;
    uint32_t door;
    if (slides) { /* hung on a rail before the bars */
        dmg_box_span(b, v3(-0.52f * width, 1.01f * high, t), v3(reach, 1.06f * high, 1.8f * t));
        if (side < 0) dmg_box_span(b, v3(-reach, 1.01f * high, t), v3(-0.52f * width, 1.06f * high, 1.8f * t));
        door = dmg_slide(b, 0, "door", v3(side, 0, 0), 0.0f, fminf(0.9f * width, wing));
    } else {
        float line = t * dmg_range(b, 0.0f, 0.8f), swing = dmg_range(b, 1.2f, 2.2f);
        door = dmg_hinge(b, 0, "door", v3(side * 0.51f * width, 0, line), v3(0, side, 0), 0.0f, swing);
    }
    dmg_save(b);
    dmg_move(b, 0, 0.01f * high, z);
    if (bars)
        draw_grille(b, 0.97f * width, 0, 0.99f * high, 0.35f * t, false);
    else
        dmg_box_span(b, v3(-0.5f * width, 0, -0.5f * t), v3(0.5f * width, 0.99f * high, 0.5f * t));
    for (int i = 0; i < 2 && !bars; ++i) /* straps that end in the hinge */
        dmg_box_span(b, v3(side > 0 ? -0.3f * width : -0.51f * width, high * (i ? 0.8f : 0.15f), 0.5f * t),
                     v3(side > 0 ? 0.51f * width : 0.3f * width, high * (i ? 0.84f : 0.19f), 0.75f * t));
    draw_door_iron(b, door, width, high, bars ? 0.35f * t : 0.5f * t, 0.5f * t + 0.01f * width, side);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_dungeon_gate(dmg_builder* b) {
    if (dmg_chance(b, 0.5f))
        draw_portcullis(b);
    else
        draw_cell(b);
    dmg_use(b, 0);
}
