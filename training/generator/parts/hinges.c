/* Implements hinge hardware, drawn onto the leaf and onto what carries it. */
#include "parts/hardware.h"

dmg_hinge_style dmg_hinge_pick(dmg_builder* b, float radius) {
    static const float weights[DMG_HINGE_KINDS] = {6, 2, 0.8f, 1, 0.8f, 1};
    dmg_hinge_style style = {.kind = (dmg_hinge_kind)dmg_weighted(b, weights, DMG_HINGE_KINDS)};
    style.count = dmg_int(b, 2, 3);
    style.radius = radius * dmg_scale_range(b, 0.5f, 1.6f);
    style.length = style.radius * dmg_range(b, 4, 12);
    style.inset = dmg_range(b, 0.05f, 0.22f);
    return style;
}

/* The middle third of a knuckle belongs to the leaf. */
static void draw_knuckle(dmg_builder* b, float y, float radius, float length, uint32_t leaf, uint32_t frame) {
    for (int i = -1; i <= 1; ++i) {
        float centre = y + (float)i * length / 3.0f, half = 0.48f * length / 3.0f;
        dmg_use(b, i == 0 ? leaf : frame);
        dmg_rod(b, v3(0, centre - half, 0), v3(0, centre + half, 0), radius);
    }
}

static void draw_lugs(dmg_builder* b, float y, const dmg_hinge_style* style, uint32_t leaf, uint32_t frame) {
    float r = style->radius;
    dmg_use(b, frame);
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3(-0.8f * r, y + (float)s * 0.4f * style->length, -0.3f * r),
                v3(3.6f * r, 0.15f * style->length, 2.4f * r));
    }
    dmg_use(b, leaf);
    dmg_rod(b, v3(0, y - 0.5f * style->length, 0), v3(0, y + 0.5f * style->length, 0), 0.5f * r);
}

void dmg_hinge_draw(dmg_builder* b, const dmg_hinge_style* style, float line, float width, uint32_t leaf,
                    uint32_t frame) {
    float r = style->radius, length = fminf(style->length, 0.8f * line / (float)style->count);
    for (int i = 0; i < style->count; ++i) {
        float y = line * (0.5f - style->inset) * (2.0f * (float)i / (float)(style->count - 1) - 1.0f);
        if (style->kind == DMG_HINGE_BARREL) draw_knuckle(b, y, r, length, leaf, frame);
        if (style->kind == DMG_HINGE_LUGS) draw_lugs(b, y, style, leaf, frame);
        if (style->kind == DMG_HINGE_STRAP) {
            draw_knuckle(b, y, r, length, leaf, frame);
            dmg_use(b, leaf);
            dmg_box(b, v3(0.3f * width, y, 0.3f * r), v3(0.6f * width, 0.7f * length, 0.7f * r));
        }
    }
    for (int s = -1; s <= 1 && style->kind == DMG_HINGE_PIVOT; s += 2) {
        dmg_use(b, s < 0 ? leaf : frame);
        dmg_rod(b, v3(0, (float)s * 0.46f * line, 0), v3(0, (float)s * 0.53f * line, 0), r);
    }
    if (style->kind == DMG_HINGE_PIANO) {
        dmg_use(b, frame);
        dmg_rod(b, v3(0, -0.48f * line, 0), v3(0, 0.48f * line, 0), 0.6f * r);
    }
    dmg_use(b, leaf);
}
