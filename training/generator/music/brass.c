/* Draws wind instruments: brass with valves that are pressed or turned by levers, slides that draw out and water
 * keys; woodwind with cups on long hinge rods and levers across them. Brass is blown towards +Z, woodwind stands. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- brass: the bell's tube and the mouth pipe run along Z, one above the other ---- */

typedef struct brass {
    float bore, reach; /* of the tubes: radius, half the wrap's length */
    float high;        /* half the distance of the upper and the lower run */
    float bell, flare; /* radius and length */
    int valves;
    bool rotary;
} brass;

enum { BOW = 7 };

/* Half a turn in the plane of Y and Z about `middle`, the lower end first, bulging to `way` along Z. */
static void draw_bow(dmg_builder* b, dmg_vec middle, float radius, float way, float tube) {
    dmg_vec path[BOW];
    for (int i = 0; i < BOW; ++i) {
        float angle = DMG_PI * ((float)i / (BOW - 1) - 0.5f);
        path[i] = v3_add(middle, v3(0, radius * sinf(angle), way * radius * cosf(angle)));
    }
    dmg_sweep(b, path, BOW, tube, tube, false);
}

static void draw_bell(dmg_builder* b, dmg_vec at, const brass* w) {
    float r = w->bore, rim = w->bell, l = w->flare, t = 0.25f * r, curve = dmg_range(b, 0.25f, 0.5f);
    const dmg_xy flare[] = {{0, 0},
                            {r, 0},
                            {r + 0.2f * curve * rim, 0.45f * l},
                            {curve * rim + 0.3f * r, 0.8f * l},
                            {rim, l},
                            {rim - t, l},
                            {curve * rim, 0.82f * l},
                            {0.7f * r, 0.5f * l},
                            {0, 0.5f * l}};
    dmg_lathe(b, at, v3(0, 0, 1), flare, 9);
}

/* Draws a key on a bow: a lever about a pin across, its cork below, held shut by a spring. */
static void draw_water_key(dmg_builder* b, uint32_t carrier, dmg_vec at, float r, float way) {
    dmg_use(b, carrier);
    dmg_box(b, v3_add(at, v3(0, -0.3f * r, 0)), v3(0.9f * r, 0.9f * r, 0.5f * r));
    dmg_vec pin = v3_add(at, v3(0, -0.9f * r, 0));
    dmg_hinge(b, carrier, "water_key", pin, v3(way, 0, 0), 0.0f, dmg_range(b, 0.15f, 0.6f));
    dmg_rod(b, v3_add(pin, v3(-0.7f * r, 0, 0)), v3_add(pin, v3(0.7f * r, 0, 0)), 0.2f * r);
    dmg_beam(b, v3_add(pin, v3(0, 0.1f * r, way * 1.6f * r)), v3_add(pin, v3(0, -0.3f * r, -way * 2.2f * r)), 0.5f * r,
             0.2f * r);
    dmg_use(b, carrier);
}

/* Draws a bow with two legs that draws out of its sleeves along Z: `way` is 1 to the front. The sleeves end at `at`. */
static uint32_t draw_slide(dmg_builder* b, const char* name, dmg_vec at, float radius, float way, float travel,
                           const brass* w) {
    float r = w->bore, leg = travel * 1.2f;
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(at.x, at.y + (float)s * radius, at.z - way * leg), v3(at.x, at.y + (float)s * radius, at.z),
                1.2f * r);
    uint32_t slide = dmg_slide(b, 0, name, v3(0, 0, way), 0.0f, travel);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(at.x, at.y + (float)s * radius, at.z - way * leg),
                v3(at.x, at.y + (float)s * radius, at.z + way * r), r);
    draw_bow(b, v3(at.x, at.y, at.z + way * r), radius, way, r);
    if (dmg_chance(b, 0.35f))
        dmg_torus(b, v3(at.x, at.y, at.z + way * (radius + 2.5f * r)), v3(0, 1, 0), 1.6f * r, 0.4f * r);
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(at.x, at.y - radius, at.z), v3(at.x, at.y + radius, at.z), 0.5f * r);
    dmg_rest(b, slide, travel * (dmg_chance(b, 0.6f) ? dmg_range(b, 0.0f, 0.2f) : dmg_range(b, 0.0f, 1.0f)));
    return slide;
}

/* Pistons side by side along Z, pressed down; their bottom caps screw off. */
static void draw_pistons(dmg_builder* b, const brass* w, float tall) {
    float r = w->bore * dmg_range(b, 1.4f, 1.9f), pitch = r * dmg_range(b, 2.05f, 2.6f),
          stem = tall * dmg_range(b, 0.25f, 0.45f), press = 0.75f * stem, cap = 0.15f * tall;
    bool screwed = dmg_chance(b, 0.4f), drawn = dmg_chance(b, 0.2f);
    for (int i = 0; i < w->valves; ++i) {
        float z = pitch * (0.5f * (float)(w->valves - 1) - (float)i);
        dmg_rod(b, v3(0, -tall, z), v3(0, tall - 0.6f * cap, z), r);
        dmg_rod(b, v3(0, tall - cap, z), v3(0, tall, z), 1.08f * r);
        uint32_t piston = dmg_slide(b, 0, "valve", v3(0, -1, 0), 0.0f, press);
        dmg_rod(b, v3(0, tall - cap, z), v3(0, tall + stem, z), 0.3f * r);
        dmg_rod(b, v3(0, tall + stem, z), v3(0, tall + stem + 0.25f * r, z), 0.8f * r);
        if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, tall, z), v3(0, tall + 0.2f * stem, z), 0.6f * r);
        if (drawn) dmg_rest(b, piston, press * dmg_unit(b));
        dmg_use(b, 0);
        if (screwed) dmg_screw(b, 0, "bottom_cap", v3(0, -tall, z), v3(0, -1, 0), 0.03f * r, 0.0f, 12.0f);
        const dmg_xy nut[] = {{0, -0.7f * cap},
                              {0.4f * r, -0.6f * cap},
                              {1.08f * r, -0.4f * cap},
                              {1.08f * r, 0.5f * cap},
                              {0, 0.5f * cap}};
        dmg_lathe(b, v3(0, -tall, z), v3(0, 1, 0), nut, 5);
        dmg_use(b, 0);
    }
    for (int i = 0; i + 1 < w->valves; ++i) /* knuckles between them */
        for (int s = -1; s <= 1; s += 2) {
            float z = pitch * (0.5f * (float)(w->valves - 2) - (float)i);
            dmg_rod(b, v3(0, (float)s * 0.4f * tall, z - 0.5f * pitch), v3(0, (float)s * 0.4f * tall, z + 0.5f * pitch),
                    0.8f * w->bore);
        }
}

/* Rotors lie across; each has a lever on one axle along Z, a paddle under a finger. */
static void draw_rotors(dmg_builder* b, const brass* w, float tall) {
    float r = w->bore * dmg_range(b, 1.6f, 2.2f), pitch = r * dmg_range(b, 2.1f, 2.8f),
          arm = w->high * dmg_range(b, 1.2f, 2.0f), swing = dmg_range(b, 0.2f, 0.45f), t = 0.25f * r, side = 1.4f * r,
          axle = tall * dmg_range(b, 0.6f, 1.0f);
    float long_ = pitch * (float)w->valves;
    bool caps = dmg_chance(b, 0.4f);
    for (int i = 0; i <= w->valves; i += w->valves)
        dmg_box_span(b, v3(side - t, 0, 0.5f * long_ - pitch * (float)i - t),
                     v3(side + t, axle, 0.5f * long_ - pitch * (float)i + t));
    dmg_rod(b, v3(side, axle, -0.5f * long_), v3(side, axle, 0.5f * long_), 0.5f * t);
    for (int i = 0; i < w->valves; ++i) {
        float z = 0.5f * long_ - pitch * ((float)i + 0.5f);
        dmg_rod(b, v3(-r, 0, z), v3(1.05f * r, 0, z), r);
        if (caps) dmg_screw(b, 0, "rotor_cap", v3(-r, 0, z), v3(-1, 0, 0), 0.03f * r, 0.0f, 10.0f);
        dmg_rod(b, v3(-1.3f * r, 0, z), v3(-r, 0, z), 1.05f * r);
        dmg_use(b, 0);
        dmg_hinge(b, 0, "valve_lever", v3(side, axle, z), v3(0, 0, -1), 0.0f, swing);
        dmg_rod(b, v3(side, axle, z - 0.4f * pitch), v3(side, axle, z + 0.4f * pitch), t);
        dmg_beam(b, v3(side, axle, z), v3(side + arm, axle + 0.2f * arm, z), 0.8f * t, 1.2f * t);
        dmg_rounded_box(b, v3(side + arm, axle + 0.2f * arm, z), v3(0.4f * arm, 0.8f * t, 0.75f * pitch), 0.3f * t);
        dmg_use(b, 0);
    }
    dmg_rod(b, v3(0, 0, -0.6f * long_), v3(0, 0, 0.6f * long_), w->bore);
}

static void draw_mouthpiece(dmg_builder* b, dmg_vec at, float r) {
    const dmg_xy cup[] = {{0, 0},         {0.7f * r, 0},     {0.8f * r, 3 * r}, {1.9f * r, 4.5f * r},
                          {2 * r, 6 * r}, {1.5f * r, 6 * r}, {0, 4.5f * r}};
    if (dmg_chance(b, 0.6f)) dmg_slide(b, 0, "mouthpiece", v3(0, 0, -1), 0.0f, 3 * r);
    dmg_lathe(b, at, v3(0, 0, -1), cup, 7);
    dmg_use(b, 0);
}

/* Draws a trumpet's wrap: the mouth pipe above ends in the tuning slide in front, the bell's tube turns behind. */
static void draw_wrapped(dmg_builder* b, const brass* w) {
    float r = w->bore, h = w->high, l = w->reach, x = 2.4f * r, tall = h * dmg_range(b, 1.0f, 1.6f),
          pull = l * dmg_range(b, 0.1f, 0.4f);
    dmg_rod(b, v3(-x, h, -1.5f * l), v3(-x, h, 0.6f * l), r);
    dmg_rod(b, v3(-x, -h, 0), v3(-x, -h, 0.6f * l), r);
    draw_mouthpiece(b, v3(-x, h, -1.45f * l), r);
    uint32_t slide = draw_slide(b, "tuning_slide", v3(-x, 0, 0.6f * l), h, 1, pull, w);
    if (dmg_chance(b, 0.7f)) draw_water_key(b, slide, v3(-x, -h, 0.6f * l + 0.5f * h), r, 1);
    dmg_use(b, 0);
    dmg_rod(b, v3(x, -h, -l), v3(x, -h, 0), 1.05f * r);
    draw_bow(b, v3(x, 0, -l), h, -1, 1.05f * r);
    dmg_rod(b, v3(x, h, -l), v3(x, h, 0.9f * l), 1.1f * r);
    draw_bell(b, v3(x, h, 0.85f * l), w);
    for (int s = -1; s <= 1; s += 2) /* stays, and the valves' pipes */
        dmg_rod(b, v3(-x, (float)s * h, 0.3f * l), v3(x, (float)s * h, 0.3f * l), 0.5f * r);
    dmg_rod(b, v3(-x, -h, 0), v3(x, -h, 0), r);
    if (w->rotary)
        draw_rotors(b, w, tall);
    else
        draw_pistons(b, w, tall);
    float side = 3.6f * r;
    if (dmg_chance(b, 0.7f)) {
        uint32_t third =
            draw_slide(b, "third_slide", v3(-side - r, -0.2f * h, 0.35f * l), 0.45f * h, 1, 0.6f * pull, w);
        if (dmg_chance(b, 0.4f)) draw_water_key(b, third, v3(-side - r, -0.65f * h, 0.35f * l), 0.8f * r, 1);
        dmg_use(b, 0);
        dmg_rod(b, v3(-side - r, 0.25f * h, 0.3f * l), v3(0, 0.25f * h, 0.1f * l), 0.9f * r);
    }
    if (dmg_chance(b, 0.6f)) {
        draw_slide(b, "first_slide", v3(side + r, -0.2f * h, -0.3f * l), 0.35f * h, -1, 0.5f * pull, w);
        dmg_use(b, 0);
        dmg_rod(b, v3(side + r, 0.15f * h, -0.2f * l), v3(0, 0.15f * h, -0.1f * l), 0.9f * r);
    }
}

/* Draws a trombone: the long slide in front of the player, the bell beside it, its tuning slide behind. */
static void draw_trombone(dmg_builder* b, const brass* w) {
    float r = w->bore, h = w->high, l = 2.5f * w->reach, way = l * dmg_range(b, 0.6f, 0.85f), x = 5 * r,
          back = 0.7f * l;
    for (int s = -1; s <= 1; s += 2) dmg_rod(b, v3(0, (float)s * h, 0), v3(0, (float)s * h, l), 0.8f * r);
    dmg_rod(b, v3(0, -h, 0), v3(0, h, 0), 0.6f * r);
    draw_mouthpiece(b, v3(0, h, 0), r);
    uint32_t hand = dmg_slide(b, 0, "hand_slide", v3(0, 0, 1), 0.0f, way);
    for (int s = -1; s <= 1; s += 2) dmg_rod(b, v3(0, (float)s * h, 0.04f * l), v3(0, (float)s * h, l), 1.05f * r);
    dmg_rod(b, v3(0, -h, 0.07f * l), v3(0, h, 0.07f * l), 0.7f * r);
    draw_bow(b, v3(0, 0, l), h, 1, 1.05f * r);
    if (dmg_chance(b, 0.7f)) draw_water_key(b, hand, v3(0, -h, l), r, 1);
    dmg_rest(b, hand, way * dmg_range(b, 0.0f, 0.9f));
    dmg_use(b, 0);
    dmg_vec elbow[] = {v3(0, -h, 0), v3(0.3f * x, -h, -0.06f * l), v3(0.8f * x, -h, -0.08f * l), v3(x, -h, -0.15f * l)};
    dmg_sweep(b, elbow, 4, r, r, false);
    dmg_rod(b, v3(x, -h, -back), v3(x, -h, -0.14f * l), 1.05f * r);
    dmg_rod(b, v3(x, h, -back), v3(x, h, -0.1f * l), 1.1f * r);
    draw_slide(b, "tuning_slide", v3(x, 0, -back), h, -1, 0.12f * l, w);
    dmg_use(b, 0);
    draw_bell(b, v3(x, h, -0.12f * l), w);
    dmg_rod(b, v3(x, -h, -0.5f * back), v3(x, h, -0.5f * back), 0.5f * r);
    if (!dmg_chance(b, 0.5f)) return;
    float z = -0.35f * back, arm = h * dmg_range(b, 0.8f, 1.6f); /* a rotor with its thumb lever */
    dmg_rod(b, v3(x - 1.6f * r, -h, z), v3(x + 2.2f * r, -h, z), 2.2f * r);
    dmg_box(b, v3(x - 2.2f * r, -h, z + 3 * r), v3(r, r, 2 * r));
    dmg_hinge(b, 0, "trigger", v3(x - 2.6f * r, -h, z + 3.5f * r), v3(1, 0, 0), -0.35f, 0.0f);
    dmg_rod(b, v3(x - 3.1f * r, -h, z + 3.5f * r), v3(x - 2.1f * r, -h, z + 3.5f * r), 0.6f * r);
    dmg_beam(b, v3(x - 2.8f * r, -h, z + 3.5f * r), v3(x - 2.8f * r, -h + 0.3f * arm, z + 3.5f * r + arm), 0.6f * r,
             0.5f * r);
    dmg_use(b, 0);
}

static void build_brass(dmg_builder* b) {
    brass w = {.bore = dmg_range(b, 0.005f, 0.009f)};
    w.reach = w.bore * dmg_range(b, 12.0f, 20.0f);
    w.high = w.bore * dmg_range(b, 4.0f, 7.0f);
    w.bell = w.bore * dmg_range(b, 7.0f, 14.0f);
    w.flare = w.bore * dmg_range(b, 18.0f, 35.0f);
    w.valves = dmg_int(b, 3, 4);
    w.rotary = dmg_chance(b, 0.35f);
    int kind = dmg_weighted(b, (const float[]){3, 1.5f, 1.5f}, 3);
    dmg_move(b, 0, 2.0f * w.bell, 0);
    if (kind == 1) { /* a tuba: short and wide, its bell up */
        w.bell *= 1.6f;
        w.reach *= 0.8f;
        dmg_grow(b, dmg_range(b, 1.0f, 3.0f));
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    }
    if (kind == 2)
        draw_trombone(b, &w);
    else
        draw_wrapped(b, &w);
}

/* ---- woodwind: a pipe up along Y, the keys round +Z ---- */

typedef struct pipe {
    float low, high, r0, r1; /* radius at either end */
    float cup;               /* over the pipe's radius */
} pipe;

static float pipe_radius(const pipe* p, float y) {
    return p->r0 + (p->r1 - p->r0) * (y - p->low) / (p->high - p->low);
}

/* Draws a cup over its hole on +Z at height y, an arm to a rod along Y beside the pipe; the rod may run on to a touch.
 */
static void draw_cup_key(dmg_builder* b, const pipe* p, float y, float reach) {
    float r = pipe_radius(p, y), cup = r * p->cup, t = 0.15f * r, px = -0.95f * r, pz = 0.85f * r,
          lift = dmg_range(b, 0.12f, 0.4f);
    float far = y + reach, over = fmaxf(r, pipe_radius(p, far));
    dmg_rod(b, v3(0, y, 0.7f * r), v3(0, y, 1.08f * r), 0.9f * cup);
    for (int i = 0; i < 2; ++i) { /* posts */
        float at = i ? fmaxf(y, far) + cup : fminf(y, far) - cup;
        dmg_rod(b, v3(0.6f * px, at, 0.5f * pz), v3(px, at, pz), 0.6f * t);
        dmg_ellipsoid(b, v3(px, at, pz), v3(t, t, t));
    }
    uint32_t key = dmg_hinge(b, 0, "key", v3(px, y, pz), v3(0, -1, 0), 0.0f, lift);
    dmg_rod(b, v3(px, fminf(y, far) - 0.9f * cup, pz), v3(px, fmaxf(y, far) + 0.9f * cup, pz), 0.5f * t);
    dmg_beam(b, v3(px, y, pz), v3(0, y, 1.25f * r), 0.8f * t, 0.5f * t);
    dmg_rod(b, v3(0, y, 1.1f * r), v3(0, y, 1.1f * r + t), cup);
    if (reach != 0) /* the touch, on the rod's other side or over the pipe */
        dmg_beam(b, v3(px, far, pz), v3(dmg_chance(b, 0.5f) ? 2.2f * px : 0.2f * r, far, 1.2f * over), 1.5f * t,
                 0.5f * t);
    dmg_rest(b, key, dmg_chance(b, 0.6f) ? 0.0f : lift);
    dmg_use(b, 0);
}

/* Draws a lever along the pipe on a saddle: a pad at one end, a touch at the other; it rocks about a pin across. */
static void draw_lever_key(dmg_builder* b, const pipe* p, float y, float length) {
    float r = pipe_radius(p, y), t = 0.15f * r, z = 1.45f * r, tilt = dmg_range(b, 0.08f, 0.2f),
          cup = 0.7f * r * p->cup;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 1.5f * t - 0.5f * t, y - t, 0.8f * r),
                     v3((float)s * 1.5f * t + 0.5f * t, y + t, z + t));
    dmg_hinge(b, 0, "lever", v3(0, y, z), v3(1, 0, 0), 0.0f, tilt);
    dmg_rod(b, v3(-1.8f * t, y, z), v3(1.8f * t, y, z), 0.5f * t);
    dmg_beam(b, v3(0, y - 0.5f * length, z), v3(0, y + 0.5f * length, z), 1.4f * t, 0.6f * t);
    dmg_rod(b, v3(0, y - 0.5f * length, 1.15f * r), v3(0, y - 0.5f * length, z), cup);
    dmg_rounded_box(b, v3(0, y + 0.5f * length, z + 0.3f * t), v3(3 * t, 6 * t, 0.8f * t), 0.3f * t);
    dmg_use(b, 0);
}

static void draw_keys(dmg_builder* b, const pipe* p) {
    int count = dmg_int(b, 5, 14), levers = dmg_int(b, 0, 3);
    float step = 0.86f * (p->high - p->low) / (float)count, fan = dmg_range(b, 0.0f, 0.5f);
    bool touches = dmg_chance(b, 0.7f);
    for (int i = 0; i < count; ++i) {
        float y = p->low + 0.07f * (p->high - p->low) + step * ((float)i + 0.5f), reach = 0;
        if (touches && i + 3 < count && dmg_chance(b, 0.3f)) reach = step * dmg_range(b, 1.0f, 2.5f);
        if (step < 2.0f * pipe_radius(p, y) * p->cup && (i & 1)) continue;
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), dmg_range(b, -fan, fan) + (reach > 0 ? 1.6f : 0.0f));
        draw_cup_key(b, p, y, reach);
        dmg_restore(b);
    }
    for (int i = 0; i < levers; ++i) {
        float y = p->low + (p->high - p->low) * dmg_range(b, 0.2f, 0.8f);
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), DMG_PI + 0.7f * ((float)i - 1.0f));
        draw_lever_key(b, p, y, step * dmg_range(b, 1.5f, 3.0f));
        dmg_restore(b);
    }
}

/* On the pipe's upper end: a joint that draws out to tune, a beak or a reed, a screwed ring about it. */
static void draw_head_joint(dmg_builder* b, const pipe* p) {
    float r = p->r1, l = r * dmg_range(b, 3.0f, 7.0f), y = p->high;
    uint32_t joint = 0;
    if (dmg_chance(b, 0.6f)) joint = dmg_slide(b, 0, "head_joint", v3(0, 1, 0), 0.0f, dmg_range(b, 0.3f, 0.8f) * l);
    dmg_rod(b, v3(0, y - 0.8f * l, 0), v3(0, y + 0.1f * l, 0), 0.8f * r);
    const dmg_xy barrel[] = {{0, 0}, {1.15f * r, 0}, {1.25f * r, 0.5f * l}, {1.1f * r, l}, {0, l}};
    dmg_lathe(b, v3(0, y, 0), v3(0, 1, 0), barrel, 5);
    if (dmg_chance(b, 0.5f)) { /* the beak, turned in its cork */
        if (dmg_chance(b, 0.6f)) dmg_spin(b, joint, "mouthpiece", v3(0, y + l, 0), v3(0, 1, 0));
        const dmg_xy beak[] = {{-0.9f * r, 0},     {0.9f * r, 0},     {0.9f * r, l},
                               {0.75f * r, 2 * l}, {0.5f * r, 2 * l}, {-0.9f * r, l}};
        dmg_save(b);
        dmg_move(b, 0, y + l, 0);
        dmg_extrude(b, beak, 6, -0.7f * r, 0.7f * r);
        dmg_restore(b);
        dmg_torus(b, v3(0, y + 1.5f * l, 0), v3(0, 1, 0), 1.0f * r, 0.15f * r);
    } else {
        dmg_cone(b, v3(0, y + l, 0), v3(0, y + 1.6f * l, 0), 0.7f * r, 0.3f * r);
        dmg_box(b, v3(0, y + 2 * l, 0), v3(0.7f * r, l, 0.15f * r));
    }
    dmg_use(b, 0);
}

static void build_woodwind(dmg_builder* b) {
    float long_ = dmg_range(b, 0.3f, 0.75f), r = long_ * dmg_scale_range(b, 0.018f, 0.05f);
    int kind = dmg_int(b, 0, 2); /* straight, conical with a bell turned up, held across */
    pipe p = {.high = long_, .r0 = r, .r1 = r, .cup = dmg_range(b, 0.6f, 1.25f)};
    if (kind == 1) p.r0 = r * dmg_range(b, 1.8f, 2.8f);
    if (kind == 2) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    if (kind == 1) dmg_move(b, 0, 0.25f * long_, 0);
    dmg_cone(b, v3(0, 0, 0), v3(0, long_, 0), p.r0, p.r1);
    draw_keys(b, &p);
    if (kind == 0) {
        const dmg_xy bell[] = {{0, -6 * r}, {3 * r, -6 * r}, {1.6f * r, -3 * r}, {1.1f * r, 0}, {0, 0}};
        if (dmg_chance(b, 0.5f)) dmg_spin(b, 0, "bell", v3(0, 0, 0), v3(0, 1, 0));
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), bell, 5);
        dmg_use(b, 0);
        draw_head_joint(b, &p);
    } else if (kind == 1) { /* down round the bow, up to the bell in front; a neck that turns */
        float apart = 2.2f * p.r0, up = long_ * dmg_range(b, 0.3f, 0.6f);
        dmg_vec path[BOW];
        for (int i = 0; i < BOW; ++i) {
            float angle = DMG_PI * (float)i / (BOW - 1);
            path[i] = v3(0, -apart * sinf(angle), apart * (1.0f - cosf(angle)));
        }
        dmg_sweep(b, path, BOW, p.r0, p.r0, false);
        dmg_cone(b, v3(0, 0, 2 * apart), v3(0, up, 2.1f * apart), p.r0, 1.4f * p.r0);
        dmg_cone(b, v3(0, up, 2.1f * apart), v3(0, up + 0.15f * long_, 2.3f * apart), 1.4f * p.r0, 2.6f * p.r0);
        dmg_spin(b, 0, "neck", v3(0, long_, 0), v3(0, 1, 0));
        const dmg_vec neck[] = {v3(0, long_ - r, 0), v3(0, long_ + 2 * r, 0), v3(0, long_ + 4 * r, -2 * r),
                                v3(0, long_ + 4 * r, -8 * r)};
        dmg_sweep(b, neck, 4, 0.8f * r, 0.8f * r, false);
        dmg_box(b, v3(0, long_ + 4 * r, -10 * r), v3(1.6f * r, 1.2f * r, 5 * r));
        dmg_use(b, 0);
    } else { /* stopped at one end, the foot turned */
        dmg_slide(b, 0, "head_joint", v3(0, 1, 0), 0.0f, 4 * r);
        dmg_rod(b, v3(0, long_ - 4 * r, 0), v3(0, long_ + 12 * r, 0), 0.9f * r);
        dmg_rod(b, v3(0, long_ + 0.2f * r, 0), v3(0, long_ + 12 * r, 0), 1.05f * r);
        dmg_box(b, v3(0, long_ + 8 * r, 0.8f * r), v3(1.4f * r, 2.2f * r, 0.8f * r));
        dmg_spin(b, 0, "foot_joint", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, -7 * r, 0), v3(0, -0.1f * r, 0), 1.05f * r);
        dmg_rod(b, v3(0, -4 * r, 0.9f * r), v3(0, -4 * r, 1.4f * r), 0.8f * r);
        dmg_use(b, 0);
    }
}

void dmg_build_wind_instrument(dmg_builder* b) {
    if (dmg_chance(b, 0.6f))
        build_brass(b);
    else
        build_woodwind(b);
}
