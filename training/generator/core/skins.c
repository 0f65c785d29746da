/* Implements surfaces of revolution for nacelles, hulls and envelopes, whole or a patch of one. */
#include "core/skins.h"

enum { ROW_LIMIT = 12, STEP_LIMIT = 48 };

dmg_vec dmg_skin_point(float radius, float angle, float z) {
    return v3(radius * cosf(angle), radius * sinf(angle), z);
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
