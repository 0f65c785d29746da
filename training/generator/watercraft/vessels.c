/* Draws vessels: remotely operated vehicles whose small screws sit deep in their ducts, torpedoes with fins that
 * turn whole, boats with outboard motors. Bow to +Z. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/wings.h"

/* ---- thrusters, blowing along +Z ---- */

typedef struct thruster {
    float radius, screw; /* of the duct, of the screw: often far smaller */
    int blades, kind;    /* of the screw: blades on a hub, a block, a hub alone, a disc */
    bool ducted, guarded;
} thruster;

static thruster pick_thruster(dmg_builder* b, float radius) {
    thruster t = {.radius = radius, .blades = dmg_int(b, 2, 5), .kind = dmg_int(b, 0, 4)};
    t.screw = radius * (dmg_chance(b, 0.5f) ? dmg_range(b, 0.8f, 0.95f) : dmg_range(b, 0.35f, 0.8f));
    t.ducted = dmg_chance(b, 0.8f);
    t.guarded = dmg_chance(b, 0.3f);
    return t;
}

static void draw_thruster(dmg_builder* b, const thruster* t, uint32_t carrier) {
    float r = t->radius, half = 0.5f * r, hub = 0.25f * t->screw;
    const dmg_xy duct[] = {{r, -half}, {1.15f * r, -half}, {1.08f * r, half}, {r, half}, {r, -half}};
    dmg_use(b, carrier);
    if (t->ducted) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), duct, 5);
    dmg_rod(b, v3(0, 0, -1.3f * half), v3(0, 0, -0.3f * half), 0.22f * r);
    for (int i = 0; i < 3; ++i) {
        float angle = 2.1f * (float)i + 0.4f;
        dmg_beam(b, v3(0, 0, -0.8f * half), v3(1.05f * r * cosf(angle), 1.05f * r * sinf(angle), -0.8f * half),
                 0.08f * r, 0.08f * r);
        if (t->guarded)
            dmg_beam(b, v3(0, 0, half), v3(1.05f * r * cosf(angle), 1.05f * r * sinf(angle), half), 0.05f * r,
                     0.05f * r);
    }
    dmg_spin(b, carrier, "screw", v3(0, 0, 0), v3(0, 0, 1));
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0, 6.2f));
    if (t->kind <= 1) {
        dmg_cone(b, v3(0, 0, -0.3f * half), v3(0, 0, 0.6f * half), hub, 0.5f * hub);
        const float twist = dmg_range(b, 0.3f, 0.8f);
        const int kind = dmg_int(b, 0, 2);
        dmg_blades_draw(b, kind, t->screw, hub, 0.45f * t->screw, t->blades, twist);
    }
    if (t->kind == 2) dmg_box(b, v3(0, 0, 0), v3(1.2f * t->screw, 0.8f * t->screw, 0.7f * half));
    if (t->kind == 3) dmg_cone(b, v3(0, 0, -0.4f * half), v3(0, 0, half), 0.6f * t->screw, 0.25f * t->screw);
    if (t->kind == 4) dmg_rod(b, v3(0, 0, -0.1f * half), v3(0, 0, 0.1f * half), t->screw);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- remotely operated vehicle ---- */

static void draw_rov_frame(dmg_builder* b, float width, float high, float length) {
    int kind = dmg_int(b, 0, 2);
    float t = 0.03f * length;
    if (kind == 0) /* two cheeks and floats */
        for (int s = -1; s <= 1; s += 2) {
            dmg_box(b, v3((float)s * 0.5f * width, 0, 0), v3(t, high, length));
            dmg_rounded_box(b, v3((float)s * 0.25f * width, 0.4f * high, 0),
                            v3(0.4f * width, 0.3f * high, 0.8f * length), 0.08f * high);
        }
    if (kind == 1) { /* tubes round a box, a block of foam on top */
        for (int i = 0; i < 4; ++i) {
            float x = (i & 1 ? 0.5f : -0.5f) * width, z = (i & 2 ? 0.5f : -0.5f) * length;
            dmg_rod(b, v3(x, -0.5f * high, z), v3(x, 0.5f * high, z), 0.5f * t);
        }
        for (int k = -1; k <= 1; k += 2)
            for (int s = -1; s <= 1; s += 2) {
                dmg_rod(b, v3((float)s * 0.5f * width, (float)k * 0.5f * high, -0.5f * length),
                        v3((float)s * 0.5f * width, (float)k * 0.5f * high, 0.5f * length), 0.5f * t);
                dmg_rod(b, v3(-0.5f * width, (float)k * 0.5f * high, (float)s * 0.5f * length),
                        v3(0.5f * width, (float)k * 0.5f * high, (float)s * 0.5f * length), 0.5f * t);
            }
        dmg_box(b, v3(0, 0.45f * high, 0), v3(0.9f * width, 0.25f * high, 0.9f * length));
    }
    if (kind == 2) { /* one hull on legs */
        dmg_rounded_box(b, v3(0, 0.15f * high, 0), v3(0.9f * width, 0.45f * high, length), 0.15f * high);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 0.4f * width, -0.55f * high, 0), v3((float)s * 0.4f * width, 0, 0), t, t);
    }
    if (kind < 2) dmg_rod(b, v3(0, 0, -0.4f * length), v3(0, 0, 0.4f * length), 0.16f * fminf(width, high));
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.4f * width, -0.55f * high, -0.5f * length),
                v3((float)s * 0.4f * width, -0.55f * high, 0.5f * length), 0.6f * t);
}

void dmg_build_rov(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.2f, 3.0f), width = length * dmg_range(b, 0.5f, 0.9f),
          high = length * dmg_range(b, 0.35f, 0.7f);
    thruster t = pick_thruster(b, length * dmg_range(b, 0.05f, 0.1f));
    int level = 2 * dmg_int(b, 1, 2), upright = dmg_int(b, 0, 4);
    float toe = level == 4 ? dmg_range(b, 0.5f, 1.0f) : 0.0f;
    dmg_move(b, 0, 0.6f * high, 0);
    draw_rov_frame(b, width, high, length);
    for (int i = 0; i < level + upright; ++i) {
        bool up = i >= level;
        float x = i & 1 ? 1.0f : -1.0f, z = i & 2 ? 1.0f : -1.0f;
        dmg_save(b);
        if (up) {
            bool alone = upright == 1; /* behind, where it is clear of the hull */
            float aft = alone ? -0.5f * length - 1.3f * t.radius : (upright > 2 ? z * 0.3f * length : 0.0f);
            dmg_move(b, alone ? 0.0f : x * (0.5f * width + 1.3f * t.radius), 0.1f * high, aft);
            dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        } else {
            dmg_move(b, x * 0.38f * width, -0.32f * high, z * 0.38f * length);
            dmg_turn(b, v3(0, 1, 0), -x * z * toe);
        }
        draw_thruster(b, &t, 0);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.4f)) { /* a camera that nods behind its dome */
        float r = 0.1f * length;
        dmg_hinge_either_way(b, 0, "camera", v3(0, 0, 0.5f * length), v3(1, 0, 0), 0.3f, 0.9f);
        dmg_box(b, v3(0, 0, 0.5f * length), v3(r, 0.8f * r, r));
        dmg_rod(b, v3(0, 0, 0.5f * length), v3(0, 0, 0.5f * length + 0.8f * r), 0.3f * r);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.3f)) /* jaws in front */
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * 0.02f * length, z = 0.65f * length;
            dmg_hinge(b, 0, "jaw", v3(x, -0.4f * high, z), v3(0, (float)s, 0), 0.0f, dmg_range(b, 0.4f, 0.9f));
            dmg_beam(b, v3(x, -0.4f * high, z), v3(x, -0.4f * high, z + 0.15f * length), 0.03f * length,
                     0.03f * length);
            dmg_use(b, 0);
            dmg_rod(b, v3(0, -0.4f * high, 0.4f * length), v3(0, -0.4f * high, z), 0.02f * length);
        }
}

/* ---- torpedo ---- */

static void draw_stern_fins(dmg_builder* b, float radius, float z, int count, float first) {
    const float root = radius * dmg_range(b, 0.5f, 1.2f), span = radius * dmg_range(b, 0.8f, 2.0f);
    dmg_wing fin = dmg_wing_pick(b, span, root);
    int kind = dmg_int(b, 0, 2); /* whole fins, trailing edges, fins on a stock clear of the hull */
    float pivot = dmg_range(b, 0.2f, 0.6f), swing = dmg_range(b, 0.2f, 0.6f), clear = kind == 2 ? 0.25f * radius : 0.0f;
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), first + 2.0f * DMG_PI * (float)i / (float)count);
        dmg_move(b, 0.5f * radius + clear, 0, z);
        dmg_use(b, 0);
        if (kind == 1) {
            dmg_surface flap = {
                .name = "rudder", .s0 = 0.1f, .s1 = 0.97f, .c = dmg_range(b, 0.4f, 0.75f), .swing = swing};
            dmg_wing_draw(b, &fin, 0, &flap, 1);
        } else {
            dmg_hinge(b, 0, "fin", dmg_wing_point(&fin, 0, pivot, 0), v3(1, 0, 0), -swing, swing);
            dmg_wing_piece_draw(b, &fin, 0.03f, 1, 0, 1);
            if (clear > 0)
                dmg_rod(b, v3_add(dmg_wing_point(&fin, 0.03f, pivot, 0), v3(-2 * clear, 0, 0)),
                        dmg_wing_point(&fin, 0.1f, pivot, 0), 0.05f * radius);
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_torpedo(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.05f, 3.0f), length = radius * dmg_range(b, 6.0f, 16.0f),
          end = radius * dmg_range(b, 0.1f, 0.35f);
    dmg_move(b, 0, 2.5f * radius, 0);
    const dmg_xy profile[] = {{0, -0.5f * length},
                              {end, -0.5f * length},
                              {radius, -0.5f * length + 2.5f * radius},
                              {radius, 0.5f * length - 1.2f * radius},
                              {0.7f * radius, 0.5f * length - 0.4f * radius},
                              {0, 0.5f * length}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, 6);
    const float first = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0, 1.5f);
    const int count = dmg_int(b, 3, 4);
    draw_stern_fins(b, radius, -0.5f * length + 1.5f * radius, count, first);
    dmg_save(b);
    dmg_move(b, 0, 0, -0.5f * length - 0.15f * radius);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    thruster t = pick_thruster(b, radius * dmg_range(b, 0.5f, 1.0f));
    draw_thruster(b, &t, 0);
    dmg_restore(b);
    if (dmg_chance(b, 0.6f)) { /* a sail with planes, a hatch and a mast that rises */
        float high = radius * dmg_range(b, 0.6f, 1.5f), z = 0.15f * length, deep = radius * dmg_range(b, 1.0f, 2.0f);
        dmg_box(b, v3(0, radius + 0.3f * high, z), v3(0.5f * radius, 1.4f * high, deep));
        for (int s = 0; s < 2 && dmg_chance(b, 0.6f); ++s) {
            dmg_wing plane = dmg_wing_pick(b, 0.9f * radius, 0.6f * radius);
            dmg_save(b);
            if (s) dmg_mirror(b, v3(1, 0, 0));
            dmg_move(b, 0.25f * radius, radius + 0.5f * high, z);
            dmg_hinge(b, 0, "plane", dmg_wing_point(&plane, 0, 0.4f, 0), v3(1, 0, 0), -0.4f, 0.4f);
            dmg_wing_piece_draw(b, &plane, 0.02f, 1, 0, 1);
            dmg_use(b, 0);
            dmg_restore(b);
        }
        if (dmg_chance(b, 0.5f)) {
            dmg_slide(b, 0, "mast", v3(0, 1, 0), 0.0f, high * dmg_range(b, 0.5f, 1.2f));
            dmg_rod(b, v3(0, radius, z), v3(0, radius + 1.3f * high, z), 0.06f * radius);
            dmg_use(b, 0);
        }
    }
}

/* ---- boat ---- */

/* Clamped to the transom: steers about its leg, tips up about the clamp, its screw turns. */
static void draw_outboard(dmg_builder* b, float size) {
    bool steers = dmg_chance(b, 0.7f), tips = dmg_chance(b, 0.7f) || !steers;
    dmg_box(b, v3(0, 0, 0.1f * size), v3(0.25f * size, 0.4f * size, 0.15f * size));
    uint32_t motor = 0;
    if (tips)
        motor = dmg_hinge(b, 0, "tilt", v3(0, 0.1f * size, 0.05f * size), v3(1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.3f));
    if (tips && steers) dmg_box(b, v3(0, 0, -0.02f * size), v3(0.14f * size, 0.3f * size, 0.1f * size));
    if (steers) motor = dmg_hinge_either_way(b, motor, "motor", v3(0, 0, -0.15f * size), v3(0, 1, 0), 0.3f, 0.8f);
    dmg_rounded_box(b, v3(0, 0.45f * size, -0.2f * size), v3(0.35f * size, 0.45f * size, 0.5f * size), 0.08f * size);
    dmg_box(b, v3(0, -0.3f * size, -0.18f * size), v3(0.1f * size, 1.1f * size, 0.2f * size));
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, 0.3f * size, -0.1f * size), v3(0, 0.35f * size, 0.6f * size), 0.03f * size);
    dmg_save(b);
    dmg_move(b, 0, -0.75f * size, -0.3f * size);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.25f * size), 0.08f * size);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    thruster t = pick_thruster(b, 0.2f * size);
    t.ducted = t.guarded = false;
    draw_thruster(b, &t, motor);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_boat(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.3f, 8.0f), width = length * dmg_range(b, 0.25f, 0.45f),
          high = length * dmg_range(b, 0.08f, 0.18f);
    const dmg_xy keel[] = {{0.5f * width, -0.5f * length},  {0.5f * width, 0.1f * length},
                           {0.3f * width, 0.35f * length},  {0, 0.5f * length},
                           {-0.3f * width, 0.35f * length}, {-0.5f * width, 0.1f * length},
                           {-0.5f * width, -0.5f * length}};
    dmg_xy inner[7];
    for (int i = 0; i < 7; ++i) inner[i] = (dmg_xy){0.9f * keel[i].x, 0.95f * keel[i].y};
    dmg_move(b, 0, high, 0);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* the outline's y becomes z, its depth goes down */
    dmg_ring_plate(b, keel, inner, 7, 0, high);
    dmg_extrude(b, inner, 7, 0.7f * high, high);
    dmg_restore(b);
    for (int i = 0; i < 2; ++i)
        dmg_box(b, v3(0, -0.2f * high, length * (0.15f - 0.4f * (float)i)),
                v3(0.85f * width, 0.1f * high, 0.1f * length));
    int kind = dmg_int(b, 0, 2);
    if (kind <= 1) {
        dmg_save(b);
        dmg_move(b, 0, 0, -0.5f * length - 0.02f * length);
        draw_outboard(b, length * dmg_range(b, 0.12f, 0.2f));
        dmg_restore(b);
    } else {
        dmg_hinge_either_way(b, 0, "rudder", v3(0, 0, -0.51f * length), v3(0, 1, 0), 0.3f,
                             0.8f); /* a rudder with its tiller */
        dmg_box(b, v3(0, -0.7f * high, -0.56f * length), v3(0.015f * length, 2.0f * high, 0.1f * length));
        if (dmg_chance(b, 0.7f))
            dmg_rod(b, v3(0, 0.2f * high, -0.55f * length), v3(0, 0.4f * high, -0.3f * length), 0.008f * length);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.5f)) /* oars in their locks */
        for (int s = -1; s <= 1; s += 2) {
            dmg_vec lock = {(float)s * 0.48f * width, 0.1f * high, -0.05f * length};
            dmg_rod(b, v3_add(lock, v3(0, -0.2f * high, 0)), lock, 0.006f * length);
            dmg_hinge_either_way(b, 0, "oar", lock, v3(0, (float)s, 0), 0.3f, 0.9f);
            dmg_rod(b, v3_add(lock, v3((float)-s * 0.4f * width, 0.1f * high, 0)),
                    v3_add(lock, v3((float)s * 0.9f * width, -0.4f * high, 0)), 0.008f * length);
            dmg_use(b, 0);
        }
    if (kind != 2 && dmg_chance(b, 0.4f)) { /* a locker in the bow, hinged at its after edge */
        dmg_hinge(b, 0, "hatch", v3(0, 0.03f * high, 0.1f * length), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.7f));
        dmg_box(b, v3(0, 0.06f * high, 0.2f * length), v3(0.6f * width, 0.06f * high, 0.2f * length));
        dmg_use(b, 0);
    }
}
