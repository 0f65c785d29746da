/* Draws thrust that is aimed or folded away: rotors and fans that tilt, arms of drones that fold, thrusters that
 * turn. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct thruster {
    int shell;                 /* bare motor, nacelle, duct, guarded */
    int blade;                 /* kind of the blades */
    int blades;                /* how many */
    float radius, pod, length; /* of the blades, of the motor, of the nacelle behind it */
} thruster;

static thruster pick_thruster(dmg_builder* b, float radius) {
    thruster t = {.shell = dmg_int(b, 0, 3), .radius = radius};
    t.blade = dmg_int(b, 0, DMG_BLADE_KINDS - 1);
    t.blades = dmg_int(b, 2, 5);
    t.pod = radius * dmg_range(b, 0.12f, 0.3f);
    t.length = radius * dmg_range(b, 0.3f, 1.6f);
    return t;
}

/* Its axis is +Z, the blades' plane z = 0; what tilts is round the origin. The blades are a part on `carrier`. */
static void draw_thruster(dmg_builder* b, const thruster* t, uint32_t carrier) {
    float r = t->radius, pod = t->pod, back = -0.15f * r - t->length;
    if (t->shell == 0) dmg_rod(b, v3(0, 0, -0.8f * pod), v3(0, 0, -0.1f * pod), pod);
    if (t->shell == 1) {
        const dmg_xy profile[] = {
            {0, back}, {0.6f * pod, 0.8f * back}, {pod, 0.4f * back}, {pod, -0.1f * pod}, {0, -0.1f * pod}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, 5);
    }
    if (t->shell == 2) { /* a duct, held by vanes */
        float high = 0.25f * r;
        const dmg_xy ring[] = {{1.06f * r, -high},
                               {1.16f * r, -0.5f * high},
                               {1.16f * r, 0.5f * high},
                               {1.06f * r, high},
                               {1.06f * r, -high}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 5);
        for (int i = 0; i < 3; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 0, 1), i, 3);
            dmg_box(b, v3(0, 0.55f * r, -0.8f * high), v3(0.05f * r, 1.08f * r, 0.3f * high));
            dmg_restore(b);
        }
        dmg_rod(b, v3(0, 0, -high), v3(0, 0, -0.1f * pod), 0.8f * pod);
    }
    if (t->shell == 3) { /* a ring before it on spokes */
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.08f * r, 0.04f * r);
        dmg_box(b, v3(0, 0, -0.2f * r), v3(2.1f * r, 0.06f * r, 0.06f * r));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 1.06f * r, 0, -0.1f * r), v3(0.06f * r, 0.06f * r, 0.2f * r));
        dmg_rod(b, v3(0, 0, -0.25f * r), v3(0, 0, -0.1f * pod), 0.8f * pod);
    }
    dmg_spin(b, carrier, "rotor", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    float chord = r * dmg_range(b, 0.1f, 0.3f), twist = dmg_range(b, 0.1f, 0.6f);
    dmg_rod(b, v3(0, 0, -0.08f * pod), v3(0, 0, 0.5f * pod), 0.7f * pod);
    if (dmg_chance(b, 0.4f)) dmg_cone(b, v3(0, 0, 0.5f * pod), v3(0, 0, 1.4f * pod), 0.7f * pod, 0.1f * pod);
    dmg_blades_draw(b, t->blade, r, 0.6f * pod, chord, t->blades, twist);
    dmg_use(b, carrier);
}

/* ---- aircraft whose rotors or wings tilt: the nose to +Z ---- */

static void draw_fuselage(dmg_builder* b, float length, float wide) {
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.5f * wide, 0.5f * wide, 0.55f * length));
    if (kind == 1) {
        dmg_cone(b, v3(0, 0, -0.5f * length), v3(0, 0, 0.1f * length), 0.15f * wide, 0.5f * wide);
        dmg_cone(b, v3(0, 0, 0.1f * length), v3(0, 0, 0.5f * length), 0.5f * wide, 0.2f * wide);
    }
    if (kind == 2) dmg_rounded_box(b, v3(0, 0, 0), v3(wide, 0.8f * wide, length), 0.2f * wide);
    if (kind == 3) {
        dmg_box(b, v3(0, 0, 0.2f * length), v3(wide, 0.8f * wide, 0.6f * length));
        dmg_rod(b, v3(0, 0, -0.6f * length), v3(0, 0, -0.1f * length), 0.15f * wide);
    }
    if (dmg_chance(b, 0.7f))
        dmg_box(b, v3(0, 0.1f * wide, -0.45f * length), v3(1.4f * wide, 0.05f * wide, 0.12f * length));
    if (dmg_chance(b, 0.7f))
        dmg_box(b, v3(0, 0.4f * wide, -0.45f * length), v3(0.05f * wide, 0.8f * wide, 0.12f * length));
}

/* Draws one station on a wing: what turns about X at (x, 0, 0) of the frame: the nacelle alone, or the wing's outer
 * end. */
static void draw_tilting(dmg_builder* b, const thruster* t, float x, float chord, float tip) {
    float up = dmg_range(b, 1.2f, 1.7f), t_wing = 0.12f * chord;
    dmg_vec axle = {x, 0, dmg_range(b, -0.3f, 0.2f) * chord};
    bool drawn_up = dmg_chance(b, 0.4f);
    dmg_save(b);
    uint32_t part = dmg_hinge(b, 0, tip > 0 ? "wing" : "nacelle", axle, v3(drawn_up ? 1.0f : -1.0f, 0, 0), 0.0f, up);
    dmg_move(b, axle.x, axle.y, axle.z);
    if (drawn_up) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    if (tip > 0) dmg_box(b, v3(0, 0, 0), v3(tip, t_wing, 0.9f * chord));
    if (tip <= 0 && dmg_chance(b, 0.5f)) dmg_rod(b, v3(-1.5f * t->pod, 0, 0), v3(1.5f * t->pod, 0, 0), 0.5f * t->pod);
    float ahead = t->shell == 2 && tip <= 0 ? 0.0f : fmaxf(0.25f * t->length, 0.5f * chord * (tip > 0)) + t->pod;
    if (ahead > 0) dmg_rod(b, v3(0, 0, -0.3f * ahead), v3(0, 0, ahead), 0.6f * t->pod);
    dmg_move(b, 0, 0, ahead);
    draw_thruster(b, t, part);
    dmg_use(b, 0);
    dmg_restore(b);
}

static void draw_vtol(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.2f, 6.0f), wide = length * dmg_range(b, 0.1f, 0.22f),
          span = length * dmg_range(b, 0.7f, 1.5f), chord = length * dmg_range(b, 0.12f, 0.25f),
          z = length * dmg_range(b, -0.05f, 0.2f), y = wide * dmg_range(b, -0.2f, 0.4f);
    bool whole = dmg_chance(b, 0.3f);
    thruster t = pick_thruster(b, fminf(0.22f * span, 0.3f * length) * dmg_range(b, 0.5f, 1.0f));
    int rows = dmg_int(b, 1, 2), sides = dmg_chance(b, 0.85f) ? 2 : 1;
    dmg_move(b, 0, 0.5f * length, 0);
    draw_fuselage(b, length, wide);
    for (int row = 0; row < rows; ++row) {
        float at = row ? z - 0.42f * length : z, reach = 0.5f * span * (row ? 0.8f : 1.0f), root = 0.5f * wide;
        float inner = whole ? root + 0.15f * (reach - root) : reach;
        dmg_box(b, v3(0, y, at), v3(2 * inner, 0.12f * chord, chord));
        for (int s = 0; s < sides; ++s) {
            dmg_save(b);
            if (s) dmg_mirror(b, v3(1, 0, 0));
            dmg_move(b, 0, y, at);
            float tip = whole ? reach - inner : 0.0f;
            draw_tilting(b, &t, whole ? inner + 0.51f * tip : inner + (t.shell == 2 ? 1.2f * t.radius : 1.2f * t.pod),
                         chord, tip);
            dmg_restore(b);
        }
    }
}

/* ---- drones that fold ---- */

/* Draws a camera held by one, two or three turning brackets under the nose. */
static void draw_gimbal(dmg_builder* b, float s) {
    uint32_t carrier = 0;
    float t = 0.12f * s;
    int axes = dmg_int(b, 1, 3);
    dmg_rod(b, v3(0, -0.4f * s, 0), v3(0, 0.1f * s, 0), 0.3f * s);
    if (axes > 1) {
        carrier = dmg_hinge(b, 0, "gimbal_yaw", v3(0, 0, 0), v3(0, 1, 0), -1.0f, 1.0f);
        dmg_rod(b, v3(0, -0.55f * s, 0), v3(0, -0.4f * s, 0), 0.35f * s);
        dmg_box(b, v3(0, -0.6f * s, -0.4f * s), v3(2 * t, t, 0.9f * s));
        dmg_box(b, v3(0, -0.9f * s, -0.8f * s), v3(2 * t, 0.7f * s, t));
    }
    dmg_move(b, 0, -1.1f * s, 0);
    if (axes > 2) {
        carrier = dmg_hinge(b, carrier, "gimbal_roll", v3(0, 0, 0), v3(0, 0, 1), -0.6f, 0.6f);
        dmg_rod(b, v3(0, 0, -0.78f * s), v3(0, 0, -0.6f * s), 0.25f * s);
        dmg_box(b, v3(0.35f * s, 0, -0.6f * s), v3(0.8f * s, 1.5f * t, t));
        dmg_box(b, v3(0.7f * s, 0, -0.3f * s), v3(t, 1.5f * t, 0.8f * s));
    }
    dmg_hinge(b, carrier, "camera", v3(0, 0, 0), v3(1, 0, 0), -0.5f, 1.5f);
    if (dmg_chance(b, 0.5f))
        dmg_ellipsoid(b, v3(0, 0, 0), v3(0.45f * s, 0.45f * s, 0.45f * s));
    else
        dmg_box(b, v3(0, 0, 0), v3(0.9f * s, 0.6f * s, 0.6f * s));
    dmg_rod(b, v3(0, 0, 0.2f * s), v3(0, 0, 0.55f * s), 0.22f * s);
    if (axes != 2) dmg_rod(b, v3(0, 0, 0), v3(0.65f * s, 0, 0), 0.12f * s);
    dmg_use(b, 0);
}

/* Draws an arm from the corner along +X; it folds back about the upright, or down, or not at all. Blades fold when few.
 */
static void draw_folding_arm(dmg_builder* b, float reach, float thick, const thruster* t, int fold, int bar) {
    uint32_t arm = 0;
    float swing = dmg_range(b, 1.2f, 2.4f);
    if (fold == 1) arm = dmg_hinge(b, 0, "arm", v3(0, 0, 0), v3(0, 1, 0), 0.0f, swing);
    if (fold == 2) arm = dmg_hinge(b, 0, "arm", v3(0, 0, 0), v3(0, 0, -1), 0.0f, fminf(swing, 1.6f));
    if (fold == 1 && dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, -0.8f * thick, 0), v3(0, 0.8f * thick, 0), 0.8f * thick);
    if (fold == 2 && dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, 0, -thick), v3(0, 0, thick), 0.6f * thick);
    if (bar == 0) dmg_rod(b, v3(0, 0, 0), v3(reach, 0, 0), 0.4f * thick);
    if (bar == 1) dmg_box(b, v3(0.5f * reach, 0, 0), v3(reach, 0.7f * thick, thick));
    if (bar == 2) dmg_cone(b, v3(0, 0, 0), v3(reach, 0, 0), 0.6f * thick, 0.35f * thick);
    dmg_move(b, reach, thick + 0.5f * t->pod, 0);
    dmg_rod(b, v3(0, -thick - 0.7f * t->pod, 0), v3(0, 0, 0), 0.7f * t->pod);
    if (dmg_chance(b, 0.3f)) { /* a leg under the motor */
        float leg = reach * dmg_range(b, 0.3f, 0.7f);
        dmg_cone(b, v3(0, -thick - leg, 0), v3(0, -thick, 0), 0.2f * thick, 0.4f * thick);
    }
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    draw_thruster(b, t, arm);
    dmg_use(b, 0);
}

static void draw_folding_drone(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.06f, 1.0f), wide = size * dmg_range(b, 0.3f, 0.7f),
          high = size * dmg_range(b, 0.15f, 0.4f), reach = size * dmg_range(b, 0.6f, 1.1f),
          thick = size * dmg_range(b, 0.06f, 0.12f), out = dmg_range(b, 0.3f, 1.0f);
    thruster t = pick_thruster(b, 0.55f * reach * dmg_range(b, 0.7f, 1.0f));
    int hull = dmg_int(b, 0, 2), fold = dmg_int(b, 0, 2), bar = dmg_int(b, 0, 2), pairs = dmg_chance(b, 0.8f) ? 2 : 3;
    t.shell = dmg_chance(b, 0.5f) ? 0 : 3;
    if (dmg_chance(b, 0.6f)) t.blades = 2;
    dmg_move(b, 0, size, 0);
    if (hull == 0) dmg_box(b, v3(0, 0, 0), v3(wide, high, size));
    if (hull == 1) dmg_rounded_box(b, v3(0, 0, 0), v3(wide, high, 1.1f * size), 0.35f * high);
    if (hull == 2)
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(0, (float)s * 0.45f * high, 0), v3(wide, 0.1f * high, size));
    if (hull == 2) dmg_box(b, v3(0, 0, 0), v3(0.7f * wide, 0.8f * high, 0.7f * size));
    for (int i = 0; i < 2 * pairs; ++i) {
        float end = 1.0f - 2.0f * (float)(i / 2) / (float)(pairs - 1);
        dmg_save(b);
        if (i % 2) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, 0.5f * wide + (fold == 1 ? 0.5f * thick : 0), hull == 2 ? 0 : 0.2f * high, 0.42f * size * end);
        if (end < 0) dmg_mirror(b, v3(0, 0, 1)); /* the rear arms fold forwards */
        if (end != 0.0f) dmg_turn(b, v3(0, 1, 0), -out);
        draw_folding_arm(b, reach, thick, &t, fold, bar);
        dmg_restore(b);
    }
    float leg = size * dmg_range(b, 0.4f, 0.7f);
    bool gear = dmg_chance(b, 0.4f);
    for (int s = -1; s <= 1 && gear; s += 2) { /* skids that swing up */
        float x = (float)s * 0.4f * wide;
        dmg_hinge(b, 0, "skid", v3(x, -0.5f * high, 0), v3(0, 0, (float)s), 0.0f, 1.4f);
        for (int e = -1; e <= 1; e += 2)
            dmg_rod(b, v3(x, -0.5f * high, (float)e * 0.25f * size), v3(1.5f * x, -leg, (float)e * 0.25f * size),
                    0.3f * thick);
        dmg_rod(b, v3(1.5f * x, -leg, -0.5f * size), v3(1.5f * x, -leg, 0.5f * size), 0.35f * thick);
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.6f)) return;
    dmg_move(b, 0, -0.5f * high, 0.3f * size);
    draw_gimbal(b, size * dmg_range(b, 0.15f, 0.3f));
}

/* ---- thrusters under water ---- */

/* Draws a pod on an upright shaft that turns all round, or on a bracket at a transom that also tips up. */
static void draw_azimuth(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.03f, 0.6f), shaft = r * dmg_range(b, 1.5f, 5.0f),
          thin = r * dmg_range(b, 0.1f, 0.25f);
    thruster t = pick_thruster(b, r);
    if (t.shell == 0) t.shell = 2;
    bool outboard = dmg_chance(b, 0.45f);
    if (outboard) dmg_turn(b, v3(0, 1, 0), dmg_range(b, 2.0f, 4.0f));
    dmg_move(b, 0, shaft + 1.5f * r, 0);
    uint32_t carrier = 0;
    if (outboard) {
        dmg_box(b, v3(0, -0.8f * r, 0.8f * r), v3(4 * r, 3 * r, 0.4f * r)); /* the transom */
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.5f * r, 0.6f * r, 0.5f * r), v3(0.15f * r, 1.2f * r, 0.8f * r));
        carrier = dmg_hinge(b, 0, "tilt", v3(0, 0.9f * r, 0.5f * r), v3(1, 0, 0), -0.1f, dmg_range(b, 0.8f, 1.4f));
        dmg_rod(b, v3(-0.7f * r, 0.9f * r, 0.5f * r), v3(0.7f * r, 0.9f * r, 0.5f * r), 0.12f * r);
        dmg_box(b, v3(0, 0.5f * r, 0.1f * r), v3(0.8f * r, 1.0f * r, 0.7f * r));
    } else
        dmg_box(b, v3(0, 0.1f * r, 0), v3(3 * r, 0.3f * r, 3 * r));
    uint32_t pod = !outboard && dmg_chance(b, 0.6f)
                       ? dmg_spin(b, carrier, "azimuth", v3(0, 0, 0), v3(0, 1, 0))
                       : dmg_hinge(b, carrier, "azimuth", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -0.8f, 0.8f);
    float z = outboard ? -0.4f * r : 0.0f;
    if (outboard) {
        dmg_rounded_box(b, v3(0, 1.5f * r, z), v3(1.2f * r, 1.0f * r, 1.6f * r), 0.2f * r);
        if (dmg_chance(b, 0.6f))
            dmg_rod(b, v3(0, 1.4f * r, 0.3f * r), v3(0, 1.6f * r, 2.5f * r), 0.1f * r); /* tiller */
    } else if (dmg_chance(b, 0.6f))
        dmg_rod(b, v3(0, 0.2f * r, 0), v3(0, 0.9f * r, 0), 0.6f * r);
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, -shaft, z), v3(0, outboard ? 1.2f * r : 0, z), thin);
    else
        dmg_box(b, v3(0, -0.5f * shaft + (outboard ? 0.5f * r : 0), z),
                v3(1.2f * thin, shaft + (outboard ? r : 0), 3 * thin));
    dmg_move(b, 0, -shaft, z + 0.2f * r);
    if (t.shell == 2) dmg_rod(b, v3(0, 0, -0.2f * r), v3(0, 0.0f, -0.2f * r - t.length), t.pod);
    draw_thruster(b, &t, pod);
    dmg_use(b, 0);
}

void dmg_build_tilt_rotor(dmg_builder* b) {
    int kind = dmg_int(b, 0, 4);
    if (kind < 2) draw_vtol(b);
    if (kind == 2 || kind == 3) draw_folding_drone(b);
    if (kind == 4) draw_azimuth(b);
}
