/* Draws leaves as game artists ship them, without a frame: pairs of doors, gates and trapdoors that touch only each
 * other, hung outside; one leaf alone; and what looks like a pair but is not hung so: boards and books that fold at the
 * seam, panels that slide apart, flaps side by side. */
#include "core/build.h"
#include "parts/hardware.h"

enum { OUTLINE = 10 };

/* How the two leaves move. */
enum { HUNG_OUTSIDE, HUNG_ABOVE, FOLDS, SLIDES, ALONE, WAYS };

typedef struct pair {
    dmg_leaf leaf;
    dmg_hinge_style hardware;
    bool cut; /* an outline with a raised or lowered corner instead of a panel */
    float corner, curve;
    int trim;  /* 0 none, 1 bands, 2 bands and a rim, 3 a lock case */
    float gap; /* between the leaves */
} pair;

static pair pick_pair(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.3f, 3.0f);
    pair p = {.leaf = dmg_leaf_pick(b, 0.25f * width)};
    p.leaf.width = width;
    p.leaf.height = width * dmg_scale_range(b, 0.5f, 3.5f);
    p.leaf.thickness = width * dmg_scale_range(b, 0.02f, 0.3f);
    if (dmg_chance(b, 0.4f)) p.leaf.handle.kind = DMG_HANDLE_NONE;
    p.hardware = dmg_hinge_pick(b, 0.05f * width);
    p.leaf.hinge.kind = DMG_HINGE_NONE;
    p.cut = dmg_chance(b, 0.3f);
    p.corner = dmg_range(b, -0.35f, 0.5f);
    p.curve = dmg_range(b, 0.6f, 2.5f);
    p.trim = dmg_int(b, 0, 3);
    p.gap = dmg_chance(b, 0.4f) ? 0.0f : width * dmg_range(b, -0.01f, 0.05f);
    return p;
}

/* Draws a leaf whose free edge lies towards +X and whose top goes from the hung edge to the free one. */
static void draw_cut_leaf(dmg_builder* b, const pair* p) {
    float x = 0.5f * p->leaf.width, y = 0.5f * p->leaf.height, t = p->leaf.thickness, rise = p->corner * x;
    dmg_xy at[OUTLINE + 2] = {{-x, -y}, {x, -y}};
    for (int i = 0; i < OUTLINE; ++i) {
        float across = 1.0f - (float)i / (OUTLINE - 1);
        at[i + 2] = (dmg_xy){x * (2.0f * across - 1.0f), y + rise * (powf(across, p->curve) - 1.0f)};
    }
    dmg_extrude(b, at, OUTLINE + 2, -t, 0);
}

static void draw_trim(dmg_builder* b, const pair* p) {
    float w = p->leaf.width, h = p->leaf.height, t = p->leaf.thickness;
    for (int i = -1; i <= 1 && p->trim > 0 && p->trim < 3; i += 2)
        dmg_box(b, v3(0, 0.3f * h * (float)i, 0.05f * t), v3(0.96f * w, 0.06f * h, 0.3f * t));
    if (p->trim == 2) dmg_box(b, v3(0.44f * w, -0.1f * h, 0.05f * t), v3(0.06f * w, 0.7f * h, 0.3f * t));
    if (p->trim == 3) dmg_box(b, v3(0.4f * w, 0, 0.2f * t), v3(0.15f * w, 0.12f * h, 0.6f * t));
}

/* Draws a leaf about the origin, hung on its side; all hardware is the leaf's own. */
static void draw_leaf(dmg_builder* b, const pair* p, dmg_side side) {
    const dmg_leaf* leaf = &p->leaf;
    dmg_leaf hung = *leaf;
    hung.side = side;
    dmg_save(b);
    uint32_t part;
    if (p->cut && (side == DMG_SIDE_LEFT || side == DMG_SIDE_RIGHT)) {
        if (side == DMG_SIDE_RIGHT) dmg_mirror(b, v3(1, 0, 0));
        dmg_vec hinge = v3(-0.5f * leaf->width + leaf->inset * leaf->thickness, 0, -leaf->depth * leaf->thickness);
        part = dmg_hinge(b, 0, "leaf", hinge, v3(0, -1, 0), 0.0f, leaf->swing);
        draw_cut_leaf(b, p);
    } else {
        part = dmg_leaf_draw(b, 0, "leaf", &hung);
        if (side == DMG_SIDE_RIGHT) dmg_mirror(b, v3(1, 0, 0));
    }
    draw_trim(b, p);
    if (p->hardware.kind != DMG_HINGE_NONE && side != DMG_SIDE_TOP) {
        dmg_move(b, -0.5f * leaf->width + leaf->inset * leaf->thickness, 0, -leaf->depth * leaf->thickness);
        dmg_hinge_draw(b, &p->hardware, leaf->height, leaf->width, part, part);
    }
    dmg_restore(b);
}

/* Draws a leaf that is part of whatever is in use. */
static void draw_plain(dmg_builder* b, const pair* p) {
    if (p->cut)
        draw_cut_leaf(b, p);
    else
        dmg_panel_draw(b, &p->leaf.panel, p->leaf.width, p->leaf.height, p->leaf.thickness);
    draw_trim(b, p);
}

/* Draws a board whose one half lies still while the other turns at the seam. */
static void draw_folding(dmg_builder* b, const pair* p) {
    float half = 0.5f * p->leaf.width, seam = -half - 0.5f * p->gap, swing = dmg_range(b, 1.4f, 3.0f);
    int side = dmg_int(b, -1, 1); /* of the seam's line: the front edges, both ways about the middle, the back edges */
    float depth = 0.5f * (1.0f - (float)side) * p->leaf.thickness;
    dmg_save(b);
    dmg_move(b, 2.0f * seam, 0, 0);
    dmg_mirror(b, v3(1, 0, 0));
    draw_plain(b, p);
    dmg_restore(b);
    uint32_t leaf =
        dmg_hinge(b, 0, "half", v3(seam, 0, -depth), v3(0, -1, 0), side > 0 ? 0.0f : -swing, side < 0 ? 0.0f : swing);
    draw_plain(b, p);
    dmg_save(b);
    dmg_move(b, seam, 0, -depth);
    dmg_hinge_draw(b, &p->hardware, p->leaf.height, p->leaf.width, leaf, 0);
    dmg_restore(b);
}

static void draw_sliding(dmg_builder* b, const pair* p) {
    float apart = 0.5f * (p->leaf.width + p->gap), way = p->leaf.width * dmg_range(b, 0.5f, 1.0f);
    for (int side = -1; side <= 1; side += 2) {
        dmg_save(b);
        if (side < 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, apart, 0, 0);
        dmg_slide(b, 0, "leaf", v3(1, 0, 0), 0.0f, way);
        draw_plain(b, p);
        dmg_restore(b);
    }
}

static void draw_hung(dmg_builder* b, const pair* p, dmg_side left, dmg_side right) {
    float apart = 0.5f * (p->leaf.width + p->gap);
    dmg_save(b);
    dmg_move(b, -apart, 0, 0);
    draw_leaf(b, p, left);
    dmg_move(b, 2.0f * apart, 0, 0);
    draw_leaf(b, p, right);
    dmg_restore(b);
}

/* Draws one leaf. Its trim, a node of its own, is all the body there is. */
static void draw_alone(dmg_builder* b, const pair* p) {
    pair bare = *p;
    bare.trim = 0;
    draw_leaf(b, &bare, dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT);
    bare.trim = dmg_int(b, 1, 3);
    dmg_use(b, 0);
    draw_trim(b, &bare);
}

void dmg_build_bare_leaves(dmg_builder* b) {
    pair p = pick_pair(b);
    int way = dmg_weighted(b, (const float[WAYS]){6, 1, 1.5f, 1, 1.5f}, WAYS);
    dmg_move(b, 0, 0.5f * p.leaf.height, 0);
    if (dmg_chance(b, 0.4f)) { /* trapdoors, which open upwards or downwards */
        dmg_turn(b, v3(1, 0, 0), dmg_sign(b) * 0.5f * DMG_PI);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI * (float)dmg_int(b, 0, 3));
    }
    if (way == HUNG_OUTSIDE) draw_hung(b, &p, DMG_SIDE_LEFT, DMG_SIDE_RIGHT);
    if (way == HUNG_ABOVE) draw_hung(b, &p, DMG_SIDE_TOP, DMG_SIDE_TOP);
    if (way == FOLDS) draw_folding(b, &p);
    if (way == SLIDES) draw_sliding(b, &p);
    if (way == ALONE) draw_alone(b, &p);
    dmg_use(b, 0);
}
