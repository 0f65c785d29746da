/* Implements what working machines share: prisms across the machine, road wheels, cabs with doors, hydraulic rams. */
#include "parts/works.h"

#include "parts/hardware.h"

/* ---- shapes in side view ---- */

void dmg_side_prism(dmg_builder* b, const dmg_xy* outline, int count, float x0, float x1) {
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* the outline's x becomes z, its depth -x */
    dmg_extrude(b, outline, count, -fmaxf(x0, x1), -fminf(x0, x1));
    dmg_restore(b);
}

void dmg_side_sheet(dmg_builder* b, const dmg_xy* line, int count, float thickness, float width) {
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_bent_plate(b, line, count, thickness, width);
    dmg_restore(b);
}

uint32_t dmg_hinge_across(dmg_builder* b, uint32_t parent, const char* name, dmg_vec origin, float lower, float upper) {
    if (dmg_chance(b, 0.5f)) return dmg_hinge(b, parent, name, origin, v3(-1, 0, 0), lower, upper);
    return dmg_hinge(b, parent, name, origin, v3(1, 0, 0), -upper, -lower);
}

/* ---- road wheels ---- */

dmg_tyre dmg_tyre_pick(dmg_builder* b, float radius) {
    dmg_tyre t = {.radius = radius, .spokes = dmg_int(b, 4, 8)};
    t.knuckle = dmg_int(b, 0, 2);
    t.kind = dmg_weighted(b, (const float[]){2, 4, 2, 0, 0, 1, 3}, DMG_WHEEL_KINDS);
    t.width = radius * dmg_range(b, 0.3f, 0.95f);
    t.turns = dmg_chance(b, 0.85f);
    return t;
}

void dmg_tyre_draw(dmg_builder* b, const dmg_tyre* t, uint32_t parent, float x, float z, float inner) {
    float r = t->radius, in = x > 0 ? -1.0f : 1.0f;
    uint32_t carrier = parent;
    dmg_save(b);
    dmg_move(b, x, r, z);
    dmg_use(b, parent);
    if (t->steers && t->knuckle < 2) {
        float pin = t->knuckle == 0 ? in * (0.5f * t->width + 0.12f * r) : 0.0f;
        dmg_rod(b, v3(pin, 0, 0), v3(inner - x, 0, 0), 0.1f * r);
        if (t->knuckle) dmg_box(b, v3(0, 1.35f * r, 0), v3(0.4f * r, 0.3f * r, 0.4f * r));
        carrier = dmg_hinge(b, parent, "steering", v3(pin, 0, 0), v3(0, dmg_sign(b), 0), -0.6f, 0.6f);
        if (t->knuckle) {
            dmg_rod(b, v3(0, 1.05f * r, 0), v3(0, 1.25f * r, 0), 0.12f * r);
            for (int s = -1; s <= 1; s += 2)
                dmg_beam(b, v3((float)s * (0.5f * t->width + 0.06f * r), 1.1f * r, 0),
                         v3((float)s * (0.5f * t->width + 0.06f * r), -0.1f * r, 0), 0.1f * r, 0.3f * r);
            dmg_box(b, v3(0, 1.1f * r, 0), v3(t->width + 0.22f * r, 0.1f * r, 0.3f * r));
        } else {
            dmg_box(b, v3(pin, 0, 0), v3(0.18f * r, 0.6f * r, 0.25f * r));
        }
    } else {
        dmg_rod(b, v3(0, 0, 0), v3(inner - x, 0, 0), 0.1f * r);
    }
    if (t->steers && t->knuckle == 2)
        dmg_hinge(b, parent, "steering", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -0.5f, 0.5f);
    else if (t->turns)
        dmg_spin(b, carrier, "wheel", v3(0, 0, 0), v3(dmg_sign(b), 0, 0));
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_wheel_draw(b, t->kind, r, t->width, t->spokes);
    dmg_restore(b);
    dmg_use(b, parent);
}

void dmg_axle_draw(dmg_builder* b, const dmg_tyre* t, uint32_t parent, float half, float z) {
    for (int s = -1; s <= 1; s += 2) dmg_tyre_draw(b, t, parent, (float)s * half, z, 0);
}

/* ---- cab ---- */

dmg_cab dmg_cab_pick(dmg_builder* b, dmg_vec low, dmg_vec high) {
    dmg_cab c = {.low = low, .high = high, .shell = dmg_int(b, 0, 3)};
    c.slope = dmg_range(b, 0.0f, 0.3f);
    c.left = dmg_chance(b, 0.85f);
    c.right = c.left && dmg_chance(b, 0.7f);
    c.back_hung = dmg_chance(b, 0.2f);
    c.panes = dmg_chance(b, 0.5f);
    c.swing = dmg_range(b, 1.0f, 1.9f);
    return c;
}

static void draw_cab_shell(dmg_builder* b, const dmg_cab* c) {
    float wide = c->high.x - c->low.x, high = c->high.y - c->low.y, deep = c->high.z - c->low.z, t = 0.04f * deep;
    float belt = c->low.y + 0.45f * high, x = 0.5f * (c->low.x + c->high.x), nose = c->high.z - c->slope * deep;
    const dmg_xy side[] = {
        {c->low.z, c->low.y}, {c->high.z, c->low.y}, {c->high.z, belt}, {nose, c->high.y}, {c->low.z, c->high.y}};
    if (c->shell == 0) dmg_box_span(b, c->low, c->high);
    if (c->shell == 1) {
        dmg_side_prism(b, side, 5, c->low.x, c->high.x);
        dmg_beam(b, v3(x, belt + 0.05f * high, c->high.z), v3(x, c->high.y - 0.05f * high, nose), 0.85f * wide, t);
    }
    if (c->shell == 2) { /* posts, a roof, a low tub */
        for (int i = 0; i < 4; ++i) {
            float px = i & 1 ? c->high.x - t : c->low.x + t;
            dmg_vec foot = {px, c->low.y, i & 2 ? c->high.z - t : c->low.z + t},
                    top = {px, c->high.y, i & 2 ? nose - t : c->low.z + t};
            dmg_beam(b, foot, top, t, t);
        }
        dmg_box_span(b, v3(c->low.x, c->high.y - t, c->low.z), v3(c->high.x, c->high.y, nose));
        dmg_box_span(b, c->low, v3(c->high.x, c->low.y + t, c->high.z));
        dmg_box_span(b, v3(c->low.x + t, c->low.y, c->low.z + 0.1f * deep),
                     v3(c->high.x - t, belt, c->low.z + 0.4f * deep));
    }
    if (c->shell == 3) { /* walls round a hollow, open at the sides */
        dmg_box_span(b, c->low, v3(c->high.x, c->low.y + t, c->high.z));
        dmg_box_span(b, v3(c->low.x, c->low.y, c->low.z), v3(c->high.x, c->high.y, c->low.z + t));
        dmg_box_span(b, v3(c->low.x, c->low.y, c->high.z - t), v3(c->high.x, belt, c->high.z));
        dmg_box_span(b, v3(c->low.x, c->high.y - t, c->low.z), v3(c->high.x, c->high.y, nose));
        for (int s = 0; s < 2; ++s) {
            float px = s ? c->high.x - 0.5f * t : c->low.x + 0.5f * t;
            dmg_beam(b, v3(px, belt, c->high.z - 0.5f * t), v3(px, c->high.y, nose), t, t);
        }
    }
}

/* Draws a slab over the side, from behind the screen to the rear; hung at its front edge or rear edge. */
static void draw_cab_door(dmg_builder* b, const dmg_cab* c, uint32_t parent, float side) {
    float high = c->high.y - c->low.y, deep = c->high.z - c->low.z, t = 0.03f * deep;
    float x = side > 0 ? c->high.x : c->low.x, z1 = c->high.z - fmaxf(c->slope, 0.08f) * deep,
          z0 = c->low.z + 0.12f * deep, y0 = c->low.y + 0.05f * high, y1 = c->high.y - 0.06f * high;
    float belt = c->low.y + 0.5f * high, hang = c->back_hung ? z0 : z1, free = c->back_hung ? z1 : z0;
    uint32_t door = dmg_hinge(b, parent, "cab_door", v3(x + side * t, belt, hang),
                              v3(0, c->back_hung ? side : -side, 0), 0.0f, c->swing);
    if (c->panes) {
        float rim = 0.12f * (z1 - z0);
        dmg_box_span(b, v3(x, y0, z0), v3(x + side * t, belt, z1));
        dmg_box_span(b, v3(x, belt, z0), v3(x + side * t, y1, z0 + rim));
        dmg_box_span(b, v3(x, belt, z1 - rim), v3(x + side * t, y1, z1));
        dmg_box_span(b, v3(x, y1 - rim, z0 + rim), v3(x + side * t, y1, z1 - rim));
        if (dmg_chance(b, 0.6f))
            dmg_box_span(b, v3(x + 0.3f * side * t, belt, z0 + rim), v3(x + 0.6f * side * t, y1 - rim, z1 - rim));
    } else {
        dmg_box_span(b, v3(x, y0, z0), v3(x + side * t, y1, z1));
    }
    dmg_vec grip = {x + side * 1.6f * t, belt - 0.06f * high, free + (hang - free) * 0.16f};
    if (dmg_chance(b, 0.2f)) /* a lever that turns */
        dmg_hinge(b, door, "door_handle", v3_add(grip, v3(0, 0, (free - hang) * 0.05f)), v3(dmg_sign(b), 0, 0), -0.5f,
                  0.5f);
    if (dmg_chance(b, 0.7f))
        dmg_box(b, grip, v3(1.2f * t, 0.035f * high, 0.16f * (z1 - z0)));
    else
        dmg_box(b, v3_add(grip, v3(0, 0.1f * high, 0)), v3(1.2f * t, 0.2f * high, 0.04f * (z1 - z0)));
    dmg_use(b, parent);
}

void dmg_cab_draw(dmg_builder* b, const dmg_cab* c, uint32_t parent) {
    dmg_use(b, parent);
    draw_cab_shell(b, c);
    if (c->left) draw_cab_door(b, c, parent, -1);
    if (c->right) draw_cab_door(b, c, parent, 1);
}

/* ---- rams ---- */

dmg_ram_kind dmg_ram_pick(dmg_builder* b) {
    return (dmg_ram_kind)dmg_weighted(b, (const float[]){0.3f, 0.35f, 0.35f}, 3);
}

void dmg_ram_draw(dmg_builder* b, dmg_ram_kind kind, uint32_t carrier, uint32_t mover, dmg_vec from, dmg_vec to,
                  float radius) {
    dmg_vec along = v3_normalize(v3_sub(to, from)), neck = v3_lerp(from, to, dmg_range(b, 0.5f, 0.7f));
    float length = v3_length(v3_sub(to, from)), share = dmg_range(b, 0.15f, 0.35f);
    uint32_t barrel = carrier, rod = mover;
    if (kind == DMG_RAM_JOINTED) {
        barrel = dmg_hinge(b, carrier, "ram", from, v3(dmg_sign(b), 0, 0), -0.4f, 0.4f);
        rod = dmg_slide(b, barrel, "ram_rod", along, -share * length, 0.3f * length);
    }
    if (kind != DMG_RAM_NONE) {
        dmg_use(b, barrel);
        dmg_rod(b, from, neck, radius);
        dmg_rod(b, v3_add(from, v3(-1.3f * radius, 0, 0)), v3_add(from, v3(1.3f * radius, 0, 0)), 1.1f * radius);
        dmg_use(b, rod);
        dmg_rod(b, v3_mad(neck, along, -0.1f * length), to, 0.55f * radius);
        dmg_rod(b, v3_add(to, v3(-1.2f * radius, 0, 0)), v3_add(to, v3(1.2f * radius, 0, 0)), 0.9f * radius);
    }
    dmg_use(b, mover);
}
