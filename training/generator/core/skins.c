/* Implements surfaces of revolution for nacelles, hulls and envelopes, whole or a patch of one. */
#include "core/skins.h"

enum { ROW_LIMIT = 12, STEP_LIMIT = 48 };

dmg_vec dmg_skin_point(float radius, float angle, float z) {
    return v3(radius * cosf(angle), radius * sinf(angle), z);
}

dmg_vec dmg_skin_tangent(float angle) {
    return v3(-sinf(angle), cosf(angle), 0);
}

static int skin_steps(const dmg_builder* b, float arc) {
    int steps = (int)ceilf((float)b->sides * arc / (2.0f * DMG_PI));
    return steps < 2 ? 2 : (steps > STEP_LIMIT ? STEP_LIMIT : steps);
}

/* Draws one layer's vertices, column by column; returns the first. */
static uint32_t add_layer(dmg_builder* b, const dmg_skin* s, int columns, int steps, float inset) {
    uint32_t first = b->vertex_count;
    for (int i = 0; i < columns; ++i) {
        float angle = s->from + (s->to - s->from) * (float)i / (float)steps;
        for (int k = 0; k < s->count; ++k) {
            dmg_vec p = dmg_skin_point(fmaxf(s->rows[k].x - inset, 0.0f), angle, s->rows[k].y);
            p.y *= s->high;
            dmg_vertex(b, p);
        }
    }
    return first;
}

void dmg_skin_draw(dmg_builder* b, const dmg_skin* s) {
    float arc = s->to - s->from;
    bool closed = arc > 2.0f * DMG_PI - 1e-4f;
    if (s->count > ROW_LIMIT) {
        b->failed = true;
        return;
    }
    int steps = skin_steps(b, arc), columns = closed ? steps : steps + 1;
    dmg_piece_begin(b);
    uint32_t outer = add_layer(b, s, columns, steps, 0), inner = s->t > 0 ? add_layer(b, s, columns, steps, s->t) : 0;
    uint32_t n = (uint32_t)s->count, last = n - 1;
    for (int i = 0; i < steps; ++i) {
        uint32_t here = (uint32_t)i * n, next = (uint32_t)((i + 1) % columns) * n;
        for (uint32_t k = 0; k < last; ++k) {
            dmg_quad(b, outer + here + k, outer + next + k, outer + next + k + 1, outer + here + k + 1);
            if (s->t > 0) dmg_quad(b, inner + here + k, inner + here + k + 1, inner + next + k + 1, inner + next + k);
        }
        if (s->t <= 0) continue;
        dmg_quad(b, outer + here, inner + here, inner + next, outer + next);
        dmg_quad(b, outer + here + last, outer + next + last, inner + next + last, inner + here + last);
    }
    uint32_t end = (uint32_t)(columns - 1) * n;
    for (uint32_t k = 0; k < last && s->t > 0 && !closed; ++k) {
        dmg_quad(b, outer + k, outer + k + 1, inner + k + 1, inner + k);
        dmg_quad(b, outer + end + k, inner + end + k, inner + end + k + 1, outer + end + k + 1);
    }
}

void dmg_skin_cone(dmg_builder* b, dmg_xy back, dmg_xy front, float from, float to, float t) {
    const dmg_xy rows[] = {back, front};
    dmg_skin skin = {.rows = rows, .count = 2, .from = from, .to = to, .t = t, .high = 1};
    dmg_skin_draw(b, &skin);
}

/* Draws a flat plate on the chord of the arc. */
static void draw_plate(dmg_builder* b, const dmg_band* d, float middle, float half) {
    float flat = cosf(half), width = 2 * sinf(half) * fminf(d->back.x, d->front.x), t = fmaxf(d->t, 0.01f * d->front.x);
    dmg_vec tangent = dmg_skin_tangent(middle), from = dmg_skin_point(d->front.x * flat, middle, d->front.y),
            to = dmg_skin_point(d->back.x * flat, middle, d->back.y);
    dmg_vec along = v3_normalize(v3_sub(to, from)), out = v3_scale(v3_cross(tangent, along), -0.5f * t);
    uint32_t v[8];
    dmg_piece_begin(b);
    for (int i = 0; i < 8; ++i) {
        dmg_vec p = v3_mad(i & 1 ? to : from, tangent, (i & 2 ? 0.5f : -0.5f) * width);
        v[i] = dmg_vertex(b, v3_add(p, v3_scale(out, i & 4 ? 1.0f : -1.0f)));
    }
    static const uint8_t faces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 2, 6, 4},
                                        {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}};
    for (int f = 0; f < 6; ++f) dmg_quad(b, v[faces[f][0]], v[faces[f][1]], v[faces[f][2]], v[faces[f][3]]);
}

void dmg_band_draw(dmg_builder* b, const dmg_band* d) {
    float each = d->arc / (float)d->count, half = 0.5f * each * d->fill;
    for (int i = 0; i < d->count; ++i) {
        float middle = d->start + each * ((float)i + 0.5f), rest = 0.5f * each - half;
        dmg_use(b, d->parent);
        if (d->strips && rest > 0.01f)
            dmg_skin_cone(b, d->back, d->front, middle + half + 0.05f * rest, middle + half + 1.95f * rest, d->t);
        /* Its line lies where the middle of the chord does, or on the skin. */
        float radius = d->front.x + (d->back.x - d->front.x) * d->at, z = d->front.y + (d->back.y - d->front.y) * d->at;
        if (d->at > 0.1f || d->plates) radius *= cosf(half);
        dmg_vec line = v3_scale(dmg_skin_tangent(middle), d->inwards ? 1.0f : -1.0f);
        uint32_t door = dmg_hinge(b, d->parent, d->name, dmg_skin_point(radius, middle, z), line, d->lower, d->upper);
        if (d->rest != 0) dmg_rest(b, door, d->rest);
        if (d->plates)
            draw_plate(b, d, middle, half);
        else
            dmg_skin_cone(b, d->back, d->front, middle - half, middle + half, d->t);
    }
    dmg_use(b, d->parent);
}
