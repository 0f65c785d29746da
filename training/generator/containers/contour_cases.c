/* Draws cases in the shape of what they hold, and one-piece boxes hinged by the thin rim between their halves. */
#include "core/build.h"
#include "parts/hardware.h"

enum { ALONG = 9, OUTLINE = 2 * ALONG };

/* It lies flat: x along it, y to the rear, z up; the halves meet at z = 0. */
typedef struct contour {
    float length, width; /* halves of both */
    float front[ALONG];  /* share of the half width along x, from the left */
    float clip;          /* the rear edge is cut straight at this share */
    float low, high;     /* heights of the halves */
    float shrink, wall;  /* of the outer faces; of hollow halves, 0: solid */
    float rim;           /* what the flange stands out, as a share; 0: none */
} contour;

static float rear_share(const contour* c, int i) {
    return fminf(c->front[i], c->clip);
}

/* Counter-clockwise from the right, over the rear to the left, back along the front. */
static void contour_outline(const contour* c, float scale, dmg_xy* out) {
    for (int i = 0; i < ALONG; ++i) {
        float x = scale * c->length * (2.0f * (float)i / (ALONG - 1) - 1.0f);
        out[ALONG - 1 - i] = (dmg_xy){x, scale * c->width * rear_share(c, i)};
        out[ALONG + i] = (dmg_xy){x, -scale * c->width * c->front[i]};
    }
}

static void pick_contour(dmg_builder* b, contour* c) {
    static const float shapes[][ALONG] = {
        {0.9f, 1, 1, 1, 1, 1, 1, 1, 0.9f},                         /* a box, its corners cut */
        {0.55f, 0.93f, 1, 0.9f, 0.72f, 0.7f, 0.8f, 0.76f, 0.45f},  /* a body with a waist */
        {0.6f, 1, 0.98f, 0.7f, 0.78f, 0.6f, 0.3f, 0.28f, 0.34f},   /* with a neck */
        {0.95f, 1, 0.95f, 0.88f, 0.8f, 0.72f, 0.65f, 0.58f, 0.5f}, /* narrower to one end */
        {0.5f, 0.9f, 1, 0.92f, 0.7f, 0.5f, 0.4f, 0.35f, 0.25f},    /* a pear */
        {0.3f, 0.72f, 0.9f, 0.98f, 1, 0.98f, 0.9f, 0.72f, 0.3f}};  /* round or oval */
    int kind = dmg_int(b, 0, 5);
    for (int i = 0; i < ALONG; ++i) c->front[i] = shapes[kind][i];
    c->length = 0.5f * dmg_scale_range(b, 0.06f, 1.3f);
    c->width = c->length * dmg_range(b, 0.25f, 1.0f);
    c->clip = dmg_chance(b, 0.4f) ? dmg_range(b, 0.7f, 1.0f) : 1.0f;
    c->low = c->width * dmg_scale_range(b, 0.15f, 0.8f);
    c->high = dmg_chance(b, 0.3f) ? c->low : c->low * dmg_scale_range(b, 0.2f, 1.2f);
    c->shrink = dmg_chance(b, 0.4f) ? 1.0f : dmg_range(b, 0.75f, 1.0f);
    c->wall = dmg_chance(b, 0.6f) ? dmg_range(b, 0.03f, 0.1f) : 0.0f;
    c->rim = dmg_chance(b, 0.4f) ? dmg_range(b, 0.03f, 0.12f) : 0.0f;
}

/* Draws one half, open or closed at z = 0, reaching up to `high`. */
static void draw_contour_half(dmg_builder* b, const contour* c, float high) {
    dmg_xy outer[OUTLINE], inner[OUTLINE];
    contour_outline(c, 1.0f, outer);
    contour_outline(c, 1.0f - c->wall, inner);
    float soft = c->shrink, t = 0.12f * high;
    if (c->wall == 0.0f) {
        const dmg_row rows[] = {{1, 1, 0, 0},
                                {1, 1, 0, 0.5f * high},
                                {0.5f + 0.5f * soft, 0.5f + 0.5f * soft, 0, 0.85f * high},
                                {soft, soft, 0, high}};
        dmg_loft(b, outer, OUTLINE, rows, 4);
    } else {
        dmg_ring_plate(b, outer, inner, OUTLINE, 0, 0.9f * high);
        const dmg_row rows[] = {{1, 1, 0, 0.9f * high - t}, {1, 1, 0, 0.9f * high}, {soft, soft, 0, high}};
        dmg_loft(b, outer, OUTLINE, rows, 3);
    }
    if (c->rim > 0.0f) {
        dmg_xy edge[OUTLINE];
        contour_outline(c, 1.0f + c->rim, edge);
        dmg_ring_plate(b, edge, inner, OUTLINE, 0, 0.06f * fminf(c->low, c->high));
    }
}

/* Draws a clasp over the seam in front, hung on either half. */
static void draw_front_clasp(dmg_builder* b, const contour* c, uint32_t lid, float at, float size) {
    int i = (int)(at * (ALONG - 1));
    float x = c->length * (2.0f * at - 1.0f), share = at * (ALONG - 1) - (float)i,
          edge = c->front[i] + share * (c->front[i + 1 < ALONG ? i + 1 : i] - c->front[i]), t = 0.2f * size;
    float y = -edge * c->width * (1.0f + c->rim) - 0.5f * t, foot = dmg_chance(b, 0.5f) ? -0.6f : 0.6f;
    uint32_t carrier = dmg_chance(b, 0.6f) ? 0 : lid;
    float hung = carrier ? fabsf(foot) : foot; /* on the lid it hangs from above the seam */
    dmg_hinge(b, carrier, "clasp", v3(x, y + 0.5f * t, hung * size), v3(hung < 0.0f ? 1.0f : -1.0f, 0, 0), 0.0f,
              dmg_range(b, 0.8f, 2.6f));
    dmg_box(b, v3(x, y, 0), v3(0.7f * size, t, 1.3f * size));
    dmg_use(b, 0);
}

/* Draws a bail in front of the lower half, hanging or lifted. */
static void draw_front_bail(dmg_builder* b, const contour* c) {
    float span = c->length * dmg_range(b, 0.12f, 0.3f), wire = fminf(0.08f * span, 0.15f * c->low),
          reach = span * dmg_range(b, 0.4f, 0.8f), y = -c->width * c->front[ALONG / 2] * (1.0f + c->rim) - wire,
          z = -0.4f * c->low;
    if (dmg_chance(b, 0.7f)) dmg_hinge(b, 0, "handle", v3(0, y, z), v3(1, 0, 0), -1.2f, 1.2f);
    const dmg_vec bail[] = {{-span, y + wire, z}, {-span, y - reach, z}, {span, y - reach, z}, {span, y + wire, z}};
    dmg_sweep(b, bail, 4, wire, wire, false);
    dmg_use(b, 0);
}

/* Where the halves hang together: the rim's edge, a tape over the seam, barrels on the tangent or let in. */
static void draw_contour_hinges(dmg_builder* b, const contour* c, dmg_vec line, uint32_t lid, int kind) {
    float widest = 0.0f, r = 0.08f * fminf(c->low, c->high);
    for (int i = 0; i < ALONG; ++i) widest = fmaxf(widest, rear_share(c, i));
    for (int i = 0; i < ALONG && kind == 1; ++i) { /* a barrel wherever the outline reaches the line */
        if (rear_share(c, i) < 0.97f * widest || i == 0 || i + 1 == ALONG) continue;
        float x = c->length * (2.0f * (float)i / (ALONG - 1) - 1.0f), half = 0.07f * c->length;
        dmg_use(b, 0);
        dmg_rod(b, v3(x - half, line.y, line.z), v3(x, line.y, line.z), r);
        dmg_use(b, lid);
        dmg_rod(b, v3(x, line.y, line.z), v3(x + half, line.y, line.z), r);
    }
    if (kind == 2) { /* a thin strip that bends, where the outline is near the line: half of it to each */
        int first = 0, last = ALONG - 1;
        while (rear_share(c, first) < 0.9f * widest) ++first;
        while (rear_share(c, last) < 0.9f * widest) --last;
        float from = c->length * (2.0f * ((float)first - 0.3f) / (ALONG - 1) - 1.0f),
              to = c->length * (2.0f * ((float)last + 0.3f) / (ALONG - 1) - 1.0f), y = line.y;
        dmg_use(b, 0);
        dmg_box_span(b, v3(from, y - 3 * r, -0.3f * r), v3(to, y, 0));
        dmg_use(b, lid);
        dmg_box_span(b, v3(from, y - 3 * r, 0), v3(to, y, 0.3f * r));
    }
    dmg_use(b, 0);
}

/* Draws a little box with a lid of its own inside the lower half. */
static void draw_inner_box(dmg_builder* b, const contour* c) {
    float x = c->length * dmg_range(b, 0.1f, 0.3f), w = 0.3f * c->length, d = 0.5f * c->width, high = 0.6f * c->low,
          y = -0.1f * d;
    dmg_box_span(b, v3(x - 0.5f * w, y - 0.5f * d, -0.9f * c->low),
                 v3(x + 0.5f * w, y + 0.5f * d, -0.9f * c->low + high));
    uint32_t lid = dmg_hinge(b, 0, "inner_lid", v3(x, y + 0.5f * d, -0.9f * c->low + high), v3(-1, 0, 0), 0.0f, 1.4f);
    dmg_box_span(b, v3(x - 0.5f * w, y - 0.5f * d, -0.89f * c->low + high),
                 v3(x + 0.5f * w, y + 0.5f * d, -0.81f * c->low + high));
    dmg_keep_rest(b, lid);
    dmg_use(b, 0);
}

void dmg_build_contour_case(dmg_builder* b) {
    contour c;
    pick_contour(b, &c);
    dmg_move(b, 0, c.low, 0);
    dmg_face_up(b);
    if (dmg_chance(b, 0.2f)) { /* it stands on its long side or its end */
        dmg_move(b, 0, 0, c.width);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    }
    dmg_save(b);
    dmg_mirror(b, v3(0, 0, 1));
    draw_contour_half(b, &c, c.low);
    dmg_restore(b);
    float widest = 0.0f, small = fminf(c.low, c.high);
    for (int i = 0; i < ALONG; ++i) widest = fmaxf(widest, rear_share(&c, i));
    int kind = c.rim > 0.0f ? dmg_int(b, 0, 1) * 2 : dmg_int(b, 0, 2);
    float y = c.width * widest * (1.0f + c.rim), off = kind == 1 ? small * dmg_range(b, -0.06f, 0.1f) : 0.0f;
    dmg_vec line = {0, y + off, kind == 1 && dmg_chance(b, 0.3f) ? small * dmg_range(b, -0.1f, 0.15f) : 0.0f};
    if (kind == 2) line.y += 0.1f * small;
    float far = dmg_chance(b, 0.4f) ? 0.97f * DMG_PI : dmg_range(b, 1.2f, 2.4f);
    if (line.z > 0.0f || off < 0.0f) far = fminf(far, 1.9f);
    uint32_t lid = dmg_hinge(b, 0, "lid", line, v3(-1, 0, 0), 0.0f, far);
    dmg_save(b);
    dmg_move(b, 0, 0, 0.004f * small);
    draw_contour_half(b, &c, c.high);
    if (c.rim > 0.0f && dmg_chance(b, 0.5f)) /* a tab to lift */
        dmg_box_span(b, v3(-0.1f * c.length, -c.width * c.front[ALONG / 2] * (1.0f + 2.5f * c.rim), 0),
                     v3(0.1f * c.length, -c.width * c.front[ALONG / 2], 0.05f * small));
    dmg_restore(b);
    draw_contour_hinges(b, &c, line, lid, kind);
    if (c.wall > 0.0f && c.low > 0.3f * c.width && dmg_chance(b, 0.3f)) draw_inner_box(b, &c);
    int clasps = dmg_int(b, 0, 3);
    float size = fminf(0.5f * small, 0.15f * c.length);
    for (int i = 0; i < clasps; ++i) draw_front_clasp(b, &c, lid, ((float)i + 0.75f) / ((float)clasps + 0.5f), size);
    if (dmg_chance(b, 0.4f)) draw_front_bail(b, &c);
    if (clasps == 0 ? dmg_chance(b, 0.5f) : dmg_chance(b, 0.15f)) dmg_rest(b, lid, far * dmg_range(b, 0.2f, 1.0f));
}
