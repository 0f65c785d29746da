/* Implements what the walls of large machines carry: doors and hatches laid on them, round lids, sticks. */
#include "parts/walls.h"

void dmg_wall_enter(dmg_builder* b, dmg_vec at, float facing) {
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_turn(b, v3(0, 1, 0), facing);
}

void dmg_roof_enter(dmg_builder* b, dmg_vec at) {
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
}

uint32_t dmg_wall_leaf_draw(dmg_builder* b, uint32_t parent, const char* name, float width, float height,
                            dmg_side side) {
    float small = fminf(width, height);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.3f * small);
    leaf.width = width;
    leaf.height = height;
    leaf.thickness = small * dmg_range(b, 0.025f, 0.08f);
    leaf.side = side;
    leaf.swing = dmg_range(b, 1.2f, 2.4f);
    bool framed = dmg_chance(b, 0.4f);
    float rim = small * dmg_range(b, 0.03f, 0.08f);
    dmg_use(b, parent);
    dmg_save(b);
    if (framed) {
        dmg_move(b, 0, 0, 0.5f * leaf.thickness);
        dmg_frame_draw(b, width + 2.1f * rim, height + 2.1f * rim, 0.5f * leaf.thickness, rim);
        dmg_move(b, 0, 0, -0.5f * leaf.thickness);
    }
    dmg_move(b, 0, 0, 1.05f * leaf.thickness);
    uint32_t part = dmg_leaf_draw(b, parent, name, &leaf);
    dmg_restore(b);
    dmg_use(b, parent);
    return part;
}

void dmg_wall_lid_draw(dmg_builder* b, uint32_t parent, const char* name, float r) {
    float collar = r * dmg_range(b, 0.1f, 0.5f), t = r * dmg_range(b, 0.08f, 0.25f);
    int kind = dmg_weighted(b, (const float[]){3, 1, 1}, 3);
    bool domed = dmg_chance(b, 0.5f), grip = dmg_chance(b, 0.6f);
    float swing = kind == 0 ? dmg_range(b, 1.2f, 2.4f) : dmg_range(b, 1.5f, 3.0f);
    dmg_use(b, parent);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, collar), 0.93f * r);
    float z = 1.02f * collar;
    if (kind == 0) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.25f * r - 0.06f * r, 0.9f * r, 0),
                         v3((float)s * 0.25f * r + 0.06f * r, 1.2f * r, z + t));
        dmg_hinge(b, parent, name, v3(0, 1.1f * r, z + 0.5f * t), v3(-1, 0, 0), 0.0f, swing);
        dmg_box_span(b, v3(-0.15f * r, 0.8f * r, z), v3(0.15f * r, 1.18f * r, z + t));
    } else if (kind == 1) {
        dmg_rod(b, v3(1.1f * r, 0, 0), v3(1.1f * r, 0, z), 0.1f * r);
        dmg_hinge(b, parent, name, v3(1.1f * r, 0, z), v3(0, 0, dmg_sign(b)), -swing, swing);
        dmg_box_span(b, v3(0.6f * r, -0.12f * r, z), v3(1.2f * r, 0.12f * r, z + t));
    } else {
        dmg_screw(b, parent, name, v3(0, 0, z), v3(0, 0, 1), 0.05f * r, 0.0f, 9.0f);
        dmg_box(b, v3(0, 0, z + 1.2f * t), v3(1.2f * r, 0.2f * r, 1.2f * t));
    }
    if (domed) {
        const dmg_xy dish[] = {{0, z}, {r, z}, {r, z + 0.6f * t}, {0.6f * r, z + 1.2f * t}, {0, z + 1.4f * t}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), dish, 5);
    } else {
        dmg_rod(b, v3(0, 0, z), v3(0, 0, z + t), r);
    }
    if (grip && kind == 0) {
        dmg_move(b, 0, -0.55f * r, z + t);
        dmg_box(b, v3(0, 0, 0.15f * r), v3(0.5f * r, 0.12f * r, 0.3f * r));
        dmg_move(b, 0, 0.55f * r, -z - t);
    }
    dmg_use(b, parent);
}

void dmg_wall_stick_draw(dmg_builder* b, uint32_t parent, const char* name, float length) {
    float r = length * dmg_range(b, 0.015f, 0.04f), reach = dmg_range(b, 0.3f, 0.7f);
    bool slot = dmg_chance(b, 0.5f), ball = dmg_chance(b, 0.6f);
    dmg_use(b, parent);
    if (slot)
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 2.5f * r, 0, 0.03f * length), v3(2 * r, 0.35f * length, 0.06f * length));
    else
        dmg_rod(b, v3(-3 * r, 0, 0), v3(3 * r, 0, 0), 1.8f * r);
    dmg_hinge(b, parent, name, v3(0, 0, 0), v3(dmg_sign(b), 0, 0), -reach, reach);
    dmg_rod(b, v3(0, 0, -0.5f * r), v3(0, 0, length), r);
    if (ball)
        dmg_ellipsoid(b, v3(0, 0, length), v3(2.5f * r, 2.5f * r, 2.5f * r));
    else
        dmg_rod(b, v3(0, 0, 0.75f * length), v3(0, 0, 1.03f * length), 1.7f * r);
    dmg_use(b, parent);
}

void dmg_wall_wheel_draw(dmg_builder* b, uint32_t parent, const char* name, float r) {
    float out = r * dmg_range(b, 0.3f, 0.8f);
    int spokes = dmg_int(b, 3, 6);
    dmg_use(b, parent);
    dmg_rod(b, v3(0, 0, -0.05f * r), v3(0, 0, 0.8f * out), 0.1f * r);
    dmg_spin(b, parent, name, v3(0, 0, out), v3(0, 0, dmg_sign(b)));
    dmg_save(b);
    dmg_move(b, 0, 0, out);
    dmg_wheel_draw(b, 3, r, 0.25f * r, spokes);
    dmg_restore(b);
    dmg_use(b, parent);
}
