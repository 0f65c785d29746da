/* Draws large-wheeled toys: tippers, cranes with a crank, cars whose doors and bonnets open; wind-up animals. */
#include "core/build.h"
#include "parts/hardware.h"

/* Ahead is +Z; z centred. */
typedef struct toy {
    float w, l, r; /* of the chassis; of a wheel */
    float floor;   /* the height of its top */
    int wheel;
} toy;

static void draw_toy_wheels(dmg_builder* b, const toy* t, int axles) {
    float wide = t->r * dmg_range(b, 0.5f, 0.9f), x = 0.5f * t->w + 0.55f * wide;
    bool joined = dmg_chance(b, 0.4f); /* the axle turns with both wheels */
    for (int i = 0; i < axles; ++i) {
        float z = 0.64f * t->l * ((float)i / (float)(axles - 1) - 0.5f);
        for (int s = -1; s <= 1; s += 2) {
            if (s < 0 || !joined) dmg_spin(b, 0, joined ? "axle" : "wheel", v3(0, t->r, z), v3(1, 0, 0));
            dmg_save(b);
            dmg_move(b, (float)s * x, t->r, z);
            dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
            dmg_wheel_draw(b, t->wheel, t->r, wide, 5);
            dmg_restore(b);
            dmg_rod(b, v3((float)s * x, t->r, z), v3(joined ? 0.0f : 0.4f * (float)s * t->w, t->r, z), 0.18f * t->r);
            if (!joined || s > 0) dmg_use(b, 0);
        }
    }
}

static void draw_toy_chassis(dmg_builder* b, const toy* t) {
    float y = 1.25f * t->r;
    dmg_rounded_box(b, v3(0, 0.5f * (y + t->floor), 0), v3(0.8f * t->w, t->floor - y, t->l), 0.1f * t->w);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(0.3f * (float)s * t->w - 0.08f * t->w, 0.7f * t->r, -0.4f * t->l),
                     v3(0.3f * (float)s * t->w + 0.08f * t->w, t->floor - 0.1f * t->r, 0.4f * t->l));
}

/* Draws a cab in front, its doors hung at their front edges. */
static void draw_toy_cab(dmg_builder* b, const toy* t, float z0, float z1) {
    float h = t->w * dmg_range(b, 0.7f, 1.0f), x = 0.46f * t->w, y = t->floor;
    bool doors = dmg_chance(b, 0.6f);
    dmg_rounded_box(b, v3(0, y + 0.5f * h, 0.5f * (z0 + z1)), v3(2 * x, h, z1 - z0), 0.08f * t->w);
    dmg_box_span(b, v3(-0.8f * x, y + 0.5f * h, z1), v3(0.8f * x, y + 0.85f * h, z1 + 0.02f * t->w));
    for (int s = -1; s <= 1 && doors; s += 2) {
        float side = (float)s, near = z1 - 0.12f * (z1 - z0), far = z0 + 0.12f * (z1 - z0);
        dmg_hinge(b, 0, "door", v3(side * x, 0, near), v3(0, -side, 0), 0.0f, 1.2f);
        dmg_box_span(b, v3(fminf(side * x * 1.01f, side * x * 1.09f), y + 0.1f * h, far),
                     v3(fmaxf(side * x * 1.01f, side * x * 1.09f), y + 0.85f * h, near));
        dmg_use(b, 0);
    }
}

/* The bed tips about its rear edge; its tailgate hangs from above or below. */
static void draw_toy_tipper(dmg_builder* b, const toy* t) {
    float z0 = -0.52f * t->l, z1 = 0.12f * t->l, y = t->floor + 0.01f * t->w, h = t->w * dmg_range(b, 0.3f, 0.6f),
          x = 0.5f * t->w, wall = 0.06f * t->w;
    bool above = dmg_chance(b, 0.6f);
    draw_toy_cab(b, t, 0.15f * t->l, 0.49f * t->l);
    uint32_t bed = dmg_hinge(b, 0, "bed", v3(0, y, 0.9f * z0), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.0f));
    dmg_box_span(b, v3(-x, y, z0), v3(x, y + wall, z1));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * (x - 0.5f * wall) - 0.5f * wall, y + wall, z0),
                     v3((float)s * (x - 0.5f * wall) + 0.5f * wall, y + h, z1));
    dmg_box_span(b, v3(wall - x, y + wall, z1 - wall), v3(x - wall, y + h, z1));
    dmg_hinge(b, bed, "tailgate", v3(0, above ? y + h : y + wall, z0), v3(above ? 1.0f : -1.0f, 0, 0), 0.0f, 1.3f);
    dmg_box_span(b, v3(-x, y + 1.05f * wall, z0 - wall), v3(x, y + h, z0 - 0.02f * wall));
    dmg_use(b, 0);
}

/* Draws a house that turns, its boom up and out; a crank at its side, a hook below its end. */
static void draw_toy_crane(dmg_builder* b, const toy* t) {
    float y = t->floor + 0.01f * t->w, h = 0.7f * t->w, z = -0.2f * t->l, x = 0.4f * t->w, r = 0.07f * t->w,
          length = t->l * dmg_range(b, 0.5f, 0.8f), lean = dmg_range(b, 0.5f, 0.9f);
    draw_toy_cab(b, t, 0.2f * t->l, 0.49f * t->l);
    uint32_t house = dmg_spin(b, 0, "house", v3(0, 0, z), v3(0, 1, 0));
    dmg_rod(b, v3(0, y, z), v3(0, y + 0.1f * h, z), 0.9f * x);
    dmg_rounded_box(b, v3(0, y + 0.6f * h, z), v3(2 * x, h, 1.8f * x), 0.08f * t->w);
    dmg_vec pin = v3(0, y + 1.15f * h, z + 0.5f * x),
            end = v3(0, pin.y + length * sinf(lean), pin.z + length * cosf(lean));
    dmg_spin(b, house, "crank", v3(0, y + 0.6f * h, z), v3(1, 0, 0));
    dmg_rod(b, v3(x + 0.002f, y + 0.6f * h, z), v3(x + 2 * r, y + 0.6f * h, z), r);
    dmg_box_span(b, v3(x + 2 * r, y + 0.6f * h - r, z - r), v3(x + 3 * r, y + 0.6f * h + r, z + 5 * r));
    dmg_rod(b, v3(x + 3 * r, y + 0.6f * h, z + 4 * r), v3(x + 6 * r, y + 0.6f * h, z + 4 * r), 0.8f * r);
    dmg_use(b, house);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3(2 * r * (float)s, y + 1.15f * h, pin.z), v3(1.2f * r, 0.3f * h, 3 * r));
    uint32_t boom = dmg_hinge(b, house, "boom", pin, v3(-1, 0, 0), -0.3f, 0.5f);
    dmg_beam(b, pin, end, 2.6f * r, 2.6f * r);
    dmg_slide(b, boom, "hook", v3(0, -1, 0), 0.0f, 0.3f * length);
    dmg_rod(b, v3(0, end.y - 5 * r, end.z), v3(0, end.y - 1.2f * r, end.z), 0.3f * r);
    dmg_torus(b, v3(0, end.y - 7 * r, end.z), v3(1, 0, 0), 2 * r, 0.6f * r);
    dmg_use(b, 0);
}

/* Draws a round back with a key in it: turned about the line it stands on. */
static void draw_toy_key(dmg_builder* b, dmg_vec at, float r) {
    dmg_spin(b, 0, "key", at, v3(0, 1, 0));
    dmg_rod(b, at, v3(at.x, at.y + 1.6f * r, at.z), 0.2f * r);
    for (int s = -1; s <= 1; s += 2)
        dmg_torus(b, v3(at.x + 0.7f * (float)s * r, at.y + 2.0f * r, at.z), v3(0, 0, 1), 0.6f * r, 0.18f * r);
    dmg_use(b, 0);
}

/* Draws a car: bonnet and boot on a low body, a key on some. */
static void draw_toy_car(dmg_builder* b, const toy* t) {
    float y = t->floor, h = 0.28f * t->w, x = 0.44f * t->w, thick = 0.05f * t->w;
    bool front = dmg_chance(b, 0.4f), key = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(-x, y - 0.1f * h, -0.48f * t->l), v3(x, y + 0.02f * h, 0.48f * t->l));
    draw_toy_cab(b, t, -0.22f * t->l, 0.14f * t->l);
    for (int i = 0; i < 2; ++i) {
        float z0 = i ? -0.48f * t->l : 0.16f * t->l, z1 = i ? -0.24f * t->l : 0.48f * t->l;
        bool ahead = i ? true : front; /* hung at its front edge */
        dmg_box_span(b, v3(-0.9f * x, y, z0 + 0.05f * t->l), v3(0.9f * x, y + h, z1 - 0.05f * t->l));
        dmg_hinge(b, 0, i ? "boot" : "bonnet", v3(0, y + h, ahead ? z1 : z0), v3(ahead ? 1.0f : -1.0f, 0, 0), 0.0f,
                  1.1f);
        dmg_box_span(b, v3(-x, y + 1.01f * h, z0), v3(x, y + h + thick, z1));
        dmg_use(b, 0);
    }
    if (key) draw_toy_key(b, v3(0, y + 0.6f * t->w, -0.04f * t->l), 0.14f * t->w);
}

/* Draws an animal on wheels: head and tail wag, the jaw drops. */
static void draw_toy_animal(dmg_builder* b, const toy* t) {
    float y = t->floor + 0.4f * t->w, rise = 0.5f * t->w, z = 0.52f * t->l;
    dmg_ellipsoid(b, v3(0, y, 0), v3(0.45f * t->w, rise, 0.52f * t->l));
    draw_toy_key(b, v3(0, y + 0.96f * rise, 0), 0.2f * t->w);
    uint32_t head = dmg_hinge(b, 0, "head", v3(0, y, 0.9f * z), v3(0, 1, 0), -0.5f, 0.5f);
    dmg_ellipsoid(b, v3(0, y + 0.3f * rise, z + 0.3f * t->w), v3(0.32f * t->w, 0.32f * t->w, 0.34f * t->w));
    for (int s = -1; s <= 1; s += 2) {
        dmg_hinge(b, head, "ear", v3(0.2f * (float)s * t->w, y + 0.3f * rise + 0.25f * t->w, z + 0.25f * t->w),
                  v3(1, 0, 0), -0.6f, 0.6f);
        dmg_ellipsoid(b, v3(0.2f * (float)s * t->w, y + 0.3f * rise + 0.42f * t->w, z + 0.25f * t->w),
                      v3(0.1f * t->w, 0.2f * t->w, 0.05f * t->w));
    }
    dmg_use(b, 0);
    dmg_hinge(b, 0, "tail", v3(0, y, -0.5f * t->l), v3(0, 1, 0), -0.7f, 0.7f);
    dmg_capsule(b, v3(0, y, -0.5f * t->l), v3(0, y + 0.3f * t->w, -0.72f * t->l), 0.06f * t->w);
    dmg_use(b, 0);
}

void dmg_build_toy_vehicle(dmg_builder* b) {
    toy t = {.l = dmg_scale_range(b, 0.08f, 0.5f)};
    t.w = t.l * dmg_range(b, 0.4f, 0.6f);
    t.r = t.w * dmg_range(b, 0.2f, 0.32f);
    t.floor = t.r * dmg_range(b, 2.1f, 2.5f);
    t.wheel = dmg_int(b, 0, DMG_WHEEL_KINDS - 1);
    int kind = dmg_weighted(b, (const float[]){3, 2, 3, 2}, 4), axles = dmg_chance(b, 0.25f) ? 3 : 2;
    draw_toy_chassis(b, &t);
    draw_toy_wheels(b, &t, kind < 2 ? axles : 2);
    if (kind == 0) draw_toy_tipper(b, &t);
    if (kind == 1) draw_toy_crane(b, &t);
    if (kind == 2) draw_toy_car(b, &t);
    if (kind == 3) draw_toy_animal(b, &t);
}
