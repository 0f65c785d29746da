/* Draws lifting and loading vehicles: forklifts and stackers with their masts, belt loaders, aircraft stairs. Ahead
 * is +Z. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

/* ---- mast: stages one in another, a carriage, forks; its foot at the origin, rails up along Y, forks to +Z ---- */

typedef struct mast {
    float half, high, rail, fork; /* half width, height of a stage, a rail's side, length of the forks */
    int stages, grid;             /* moving stages; back rest: none, bars, a plate */
} mast;

static void draw_rails(dmg_builder* b, const mast* m, float half, float z) {
    float t = m->rail;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * half - 0.5f * t, 0, z - 0.8f * t),
                     v3((float)s * half + 0.5f * t, m->high, z + 0.8f * t));
    for (int i = 0; i < 2; ++i)
        dmg_box(b, v3(0, m->high * (i ? 0.96f : 0.1f), z - 0.9f * t), v3(2 * half, 1.2f * t, 0.6f * t));
}

static void draw_forks(dmg_builder* b, const mast* m, uint32_t carriage, float y, float z) {
    float wide = m->half * dmg_range(b, 0.12f, 0.3f), t = m->rail * dmg_range(b, 0.3f, 0.7f),
          tall = m->half * dmg_range(b, 0.5f, 0.9f);
    float at = m->half * dmg_range(b, 0.35f, 0.75f), room = fminf(at - 0.6f * wide, m->half - at);
    int moves = dmg_weighted(b, (const float[]){4, 3, 1.5f}, 3); /* fixed, to the sides, folding up */
    const dmg_xy line[] = {{z, y + tall}, {z, y}, {z + 0.6f * m->fork, y}, {z + m->fork, y + 0.3f * t}};
    const dmg_xy blunt[] = {{z, y + tall}, {z, y}, {z + m->fork, y}};
    bool tapered = dmg_chance(b, 0.5f);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * at;
        dmg_use(b, carriage);
        if (moves == 1) dmg_slide(b, carriage, "fork", v3((float)s, 0, 0), -0.9f * room, 0.9f * room);
        if (moves == 2) dmg_hinge_across(b, carriage, "fork", v3(x, y + tall, z), 0.0f, 1.4f);
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        if (tapered)
            dmg_side_sheet(b, line, 4, t, wide);
        else
            dmg_side_sheet(b, blunt, 3, t, wide);
        if (moves == 2) dmg_rod(b, v3(-0.7f * wide, y + tall, z), v3(0.7f * wide, y + tall, z), 0.8f * t);
        dmg_restore(b);
    }
    dmg_use(b, carriage);
}

/* Drawn with the carriage at `up`, a share of a stage. */
static void draw_mast(dmg_builder* b, const mast* m, uint32_t carrier) {
    float t = m->rail, half = m->half, z = 0, step = 1.3f * t, low = 0.08f * m->high;
    uint32_t stage = carrier;
    dmg_use(b, carrier);
    draw_rails(b, m, half, z);
    int rams = dmg_int(b, 0, 2);
    for (int i = 0; i < m->stages; ++i) {
        dmg_use(b, stage);
        for (int k = 0; k < rams && i == 0; ++k)
            dmg_rod(b, v3((rams == 1 ? 0.0f : (k ? 0.7f : -0.7f)) * half, 0.03f * m->high, -t),
                    v3((rams == 1 ? 0.0f : (k ? 0.7f : -0.7f)) * half, 0.9f * m->high, -t), 0.4f * t);
        half -= step;
        z += 0.3f * t;
        stage = dmg_slide(b, stage, "mast_stage", v3(0, 1, 0), 0.0f, m->high * dmg_range(b, 0.6f, 0.85f));
        draw_rails(b, m, half, z);
    }
    float tall = m->half * dmg_range(b, 0.7f, 1.1f), face = z + 1.6f * t,
          up = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.0f, 0.4f) * m->high, most = m->high - tall - low - up;
    uint32_t carriage = dmg_slide(b, stage, "carriage", v3(0, 1, 0), -up, fmaxf(most, 0.2f * m->high));
    float y = low + up;
    for (int s = -1; s <= 1; s += 2) /* rollers' plates in the rails */
        dmg_box_span(b, v3((float)s * (half - 0.9f * t) - 0.3f * t, y, z - 0.5f * t),
                     v3((float)s * (half - 0.9f * t) + 0.3f * t, y + tall, face));
    for (int i = 0; i < 2; ++i)
        dmg_box(b, v3(0, y + tall * (i ? 0.85f : 0.2f), face), v3(2.1f * m->half, 0.2f * tall, 0.5f * t));
    if (dmg_chance(b, 0.3f)) { /* the whole front of it shifts to the sides */
        float shift = 0.2f * m->half;
        carriage = dmg_slide(b, carriage, "side_shift", v3(dmg_sign(b), 0, 0), -shift, shift);
        face += 0.6f * t;
        for (int i = 0; i < 2; ++i)
            dmg_box(b, v3(0, y + tall * (i ? 0.85f : 0.2f), face), v3(1.9f * m->half, 0.16f * tall, 0.5f * t));
        dmg_box(b, v3(0, y + 0.5f * tall, face), v3(0.5f * m->half, tall, 0.4f * t));
    }
    if (m->grid == 2) dmg_box(b, v3(0, y + 1.5f * tall, face), v3(2 * m->half, 1.1f * tall, 0.3f * t));
    for (int i = 0; i < 5 && m->grid == 1; ++i)
        dmg_box(b, v3(m->half * 0.45f * ((float)i - 2), y + 1.4f * tall, face), v3(0.3f * t, 1.3f * tall, 0.3f * t));
    if (m->grid == 1) dmg_box(b, v3(0, y + 2.05f * tall, face), v3(2 * m->half, 0.3f * t, 0.4f * t));
    draw_forks(b, m, carriage, y, face + 0.5f * t);
}

static mast pick_mast(dmg_builder* b, float size) {
    mast m = {.half = size * dmg_range(b, 0.28f, 0.42f)};
    m.high = size * dmg_range(b, 1.3f, 2.2f);
    m.stages = dmg_int(b, 0, 2);
    m.grid = dmg_int(b, 0, 2);
    m.rail = size * dmg_range(b, 0.04f, 0.07f);
    m.fork = size * dmg_range(b, 0.6f, 1.2f);
    return m;
}

/* ---- a truck with a seat and a roof over it ---- */

static void draw_guard(dmg_builder* b, float half, float z0, float z1, float low, float high) {
    float t = 0.05f * (high - low), lean = dmg_range(b, 0.0f, 0.3f) * (z1 - z0);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half;
        dmg_beam(b, v3(x, low, z1), v3(x, high, z1 - lean), t, t);
        dmg_beam(b, v3(x, low, z0), v3(x, high, z0 + 0.3f * lean), t, t);
        dmg_box_span(b, v3(x - 0.5f * t, high, z0), v3(x + 0.5f * t, high + t, z1 - 0.8f * lean));
    }
    int bars = dmg_int(b, 0, 6);
    if (bars < 2)
        dmg_box_span(b, v3(-half, high, z0), v3(half, high + t, z1 - 0.8f * lean));
    else
        for (int i = 0; i < bars; ++i) {
            float z = z0 + (z1 - 0.8f * lean - z0) * ((float)i + 0.5f) / (float)bars;
            dmg_box(b, v3(0, high + 0.5f * t, z), v3(2 * half, 0.8f * t, t));
        }
}

static void draw_seat_and_wheel(dmg_builder* b, float size, float deck, bool opens) {
    float z = -0.15f * size, w = 0.2f * size;
    if (opens) dmg_hinge_across(b, 0, "hood", v3(0, deck, -0.45f * size), 0.0f, dmg_range(b, 0.7f, 1.3f));
    dmg_box_span(b, v3(-0.3f * size, deck, -0.45f * size), v3(0.3f * size, deck + 0.05f * size, 0.1f * size));
    dmg_rounded_box(b, v3(0, deck + 0.1f * size, z), v3(2 * w, 0.1f * size, 2 * w), 0.03f * size);
    dmg_rounded_box(b, v3(0, deck + 0.32f * size, z - w), v3(1.8f * w, 0.4f * size, 0.08f * size), 0.03f * size);
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, 0, deck + 0.25f * size, 0.25f * size);
    dmg_turn(b, v3(1, 0, 0), -DMG_PI + dmg_range(b, 0.7f, 1.3f)); /* its face looks back and up */
    dmg_rod(b, v3(0, 0, -0.35f * size), v3(0, 0, 0), 0.025f * size);
    dmg_hinge(b, 0, "steering_wheel", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -3.1f, 3.1f);
    dmg_wheel_draw(b, 3, 0.14f * size, 0.04f * size, dmg_int(b, 2, 4));
    dmg_use(b, 0);
    dmg_restore(b);
    int levers = dmg_int(b, 0, 3);
    dmg_box_span(b, v3(-0.3f * size, 0.6f * deck, 0.36f * size), v3(0.3f * size, deck + 0.1f * size, 0.48f * size));
    for (int i = 0; i < levers; ++i) {
        dmg_vec foot = {0.14f * size + 0.05f * size * (float)i, deck + 0.08f * size, 0.4f * size};
        dmg_hinge_across(b, 0, "lever", foot, -0.35f, 0.35f);
        dmg_rod(b, foot, v3_add(foot, v3(0, 0.15f * size, -0.03f * size)), 0.009f * size);
        dmg_ellipsoid(b, v3_add(foot, v3(0, 0.16f * size, -0.03f * size)),
                      v3(0.02f * size, 0.02f * size, 0.02f * size));
        dmg_use(b, 0);
    }
}

static void build_counterbalance(dmg_builder* b, float size) {
    float half = size * dmg_range(b, 0.36f, 0.48f), floor = 0.12f * size, deck = size * dmg_range(b, 0.5f, 0.7f),
          rear = size * dmg_range(b, 0.8f, 1.1f), nose = 0.5f * size, roof = size * dmg_range(b, 1.5f, 1.9f);
    dmg_box_span(b, v3(-half, floor, -0.5f * size), v3(half, 0.3f * size, nose));
    dmg_box_span(b, v3(-0.9f * half, 0.3f * size, -0.5f * size), v3(0.9f * half, deck, 0.1f * size));
    const dmg_xy weight[] = {{-0.45f * size, floor},
                             {-0.45f * size, deck + 0.1f * size},
                             {-0.8f * rear, deck + 0.1f * size},
                             {-rear, 0.7f * deck},
                             {-0.9f * rear, floor}};
    dmg_side_prism(b, weight, 5, -half, half);
    dmg_tyre front = dmg_tyre_pick(b, size * dmg_range(b, 0.2f, 0.28f)), back = front;
    back.radius *= dmg_range(b, 0.7f, 1.0f);
    back.steers = dmg_chance(b, 0.7f);
    back.knuckle = 2 * dmg_int(b, 0, 1);
    dmg_axle_draw(b, &front, 0, half + 0.45f * front.width, 0.3f * size);
    dmg_axle_draw(b, &back, 0, half + 0.3f * back.width, -0.7f * rear);
    draw_seat_and_wheel(b, size, deck, dmg_chance(b, 0.5f));
    if (dmg_chance(b, 0.25f)) {
        dmg_cab cab =
            dmg_cab_pick(b, v3(-0.98f * half, deck + 0.1f * size, -0.5f * size), v3(0.98f * half, roof, nose));
        cab.shell = 2;
        dmg_cab_draw(b, &cab, 0);
    } else {
        draw_guard(b, 0.95f * half, -0.5f * size, 0.95f * nose, 0.3f * size, roof);
    }
    mast m = pick_mast(b, size);
    float z = nose + 1.2f * m.rail, tilt = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, -0.1f, 0.06f);
    dmg_vec foot = {0, 0.18f * size, z};
    dmg_ram_kind ram = dmg_ram_pick(b);
    uint32_t carrier = 0;
    if (dmg_chance(b, 0.85f)) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.6f * m.half - m.rail, foot.y - m.rail, nose),
                         v3((float)s * 0.6f * m.half + m.rail, foot.y + m.rail, z));
        carrier = dmg_hinge_across(b, 0, "mast", foot, -0.1f - tilt, dmg_range(b, 0.1f, 0.2f) + tilt);
        for (int s = -1; s <= 1; s += 2)
            dmg_ram_draw(b, ram, 0, carrier, v3((float)s * 0.8f * half, 0.28f * size, nose - 0.15f * size),
                         v3((float)s * m.half, 0.6f * size, z - 0.8f * m.rail), 0.03f * size);
    }
    dmg_move(b, 0, 0.05f * size, z);
    dmg_turn(b, v3(1, 0, 0), tilt);
    draw_mast(b, &m, carrier);
}

/* ---- a stacker or pallet truck: a tiller to pull it by, legs under the load ---- */

static void draw_tiller(dmg_builder* b, float size, float y, float z) {
    float tall = size * dmg_range(b, 0.7f, 1.0f), lean = dmg_range(b, 0.0f, 0.6f), t = 0.03f * size;
    bool steers = dmg_chance(b, 0.8f);
    uint32_t head = 0;
    if (steers) {
        head = dmg_hinge(b, 0, "steering", v3(0, y, z), v3(0, dmg_sign(b), 0), -1.4f, 1.4f);
        dmg_rod(b, v3(0, 0.1f * size, z), v3(0, y, z), 2 * t);
        dmg_box(b, v3(0, y, z), v3(5 * t, 3 * t, 4 * t));
        if (dmg_chance(b, 0.6f)) {
            for (int s = -1; s <= 1; s += 2) {
                dmg_spin(b, head, "wheel", v3(0, 0.09f * size, z), v3(1, 0, 0));
                dmg_rod(b, v3((float)s * 2.3f * t, 0.09f * size, z), v3((float)s * 4 * t, 0.09f * size, z),
                        0.09f * size);
            }
            dmg_use(b, head);
            dmg_rod(b, v3(-3 * t, 0.09f * size, z), v3(3 * t, 0.09f * size, z), 0.5f * t);
        }
    }
    dmg_vec pin = {0, y + 0.5f * t, z - 2 * t}, way = {0, cosf(lean), -sinf(lean)}, end = v3_mad(pin, way, tall);
    dmg_hinge_across(b, head, "tiller", pin, -lean, 1.4f - lean);
    dmg_rod(b, v3_add(pin, v3(-3 * t, 0, 0)), v3_add(pin, v3(3 * t, 0, 0)), t);
    dmg_rod(b, pin, v3_mad(pin, way, 0.75f * tall), t);
    int grip = dmg_int(b, 0, 2);
    const dmg_vec loop[] = {v3_mad(pin, way, 0.7f * tall), v3_add(v3_mad(pin, way, 0.8f * tall), v3(5 * t, 0, 0)),
                            v3_add(end, v3(4 * t, 0, 0)), v3_add(end, v3(-4 * t, 0, 0)),
                            v3_add(v3_mad(pin, way, 0.8f * tall), v3(-5 * t, 0, 0))};
    if (grip == 0) dmg_sweep(b, loop, 5, 0.7f * t, 0.7f * t, true);
    if (grip == 1)
        dmg_rounded_box(b, v3_lerp(v3_mad(pin, way, 0.75f * tall), end, 0.5f), v3(8 * t, 0.2f * tall, 3 * t), t);
    if (grip == 2) {
        dmg_rod(b, v3_mad(pin, way, 0.7f * tall), end, t);
        dmg_rod(b, v3_add(end, v3(-5 * t, 0, 0)), v3_add(end, v3(5 * t, 0, 0)), 0.8f * t);
    }
    dmg_use(b, 0);
}

static void build_stacker(dmg_builder* b, float size) {
    mast m = pick_mast(b, size);
    float half = m.half * dmg_range(b, 1.0f, 1.3f), body = size * dmg_range(b, 0.3f, 0.6f),
          tall = size * dmg_range(b, 0.5f, 0.8f);
    dmg_rounded_box(b, v3(0, 0.06f * size + 0.5f * tall, -0.5f * body - 2.5f * m.rail), v3(2 * half, tall, body),
                    0.06f * size);
    dmg_box_span(b, v3(-half, 0.04f * size, -3 * m.rail), v3(half, 0.14f * size, 0));
    float out = half + 1.5f * m.rail;
    for (int s = -1; s <= 1; s += 2) { /* legs beside the load */
        float x = (float)s * out;
        dmg_use(b, 0);
        dmg_box_span(b, v3(x - m.rail, 0.05f * size, -3 * m.rail), v3(x + m.rail, 0.12f * size, m.fork));
        dmg_box_span(b, v3(fminf(x, x * 0.7f), 0.05f * size, -3 * m.rail),
                     v3(fmaxf(x, x * 0.7f), 0.14f * size, -1.2f * m.rail));
        if (dmg_chance(b, 0.8f)) dmg_spin(b, 0, "roller", v3(x, 0.045f * size, 0.9f * m.fork), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.7f * m.rail, 0.045f * size, 0.9f * m.fork),
                v3(x + 0.7f * m.rail, 0.045f * size, 0.9f * m.fork), 0.045f * size);
    }
    dmg_use(b, 0);
    draw_tiller(b, size, tall * dmg_range(b, 0.3f, 0.6f), -body - 2.5f * m.rail - 0.1f * size);
    dmg_box_span(b, v3(-0.1f * size, 0.12f * size, -body - 2.5f * m.rail - 0.14f * size),
                 v3(0.1f * size, 0.2f * size, -body));
    if (dmg_chance(b, 0.35f)) { /* a board to stand on folds up behind */
        float z = -body - 2.5f * m.rail;
        for (int s = -1; s <= 1; s += 2) {
            dmg_hinge_across(b, 0, "step", v3((float)s * 0.7f * half, 0.07f * size, z), -1.45f, 0.0f);
            dmg_box_span(b, v3((float)s * 0.7f * half - 0.25f * half, 0.05f * size, z - 0.35f * size),
                         v3((float)s * 0.7f * half + 0.25f * half, 0.08f * size, z));
            dmg_use(b, 0);
        }
    }
    float reach = dmg_chance(b, 0.35f) ? 0.5f * m.fork : 0.0f; /* the mast goes out on the legs */
    dmg_move(b, 0, 0.05f * size, 0);
    uint32_t carrier = reach > 0 ? dmg_slide(b, 0, "reach", v3(0, 0, 1), 0.0f, reach) : 0;
    draw_mast(b, &m, carrier);
}

/* Draws a pump on forks: the forks and what the tiller stands on are one frame that rises, or the forks alone do. */
static void build_pallet_truck(dmg_builder* b, float size) {
    float at = size * dmg_range(b, 0.15f, 0.22f), wide = size * dmg_range(b, 0.1f, 0.16f),
          fork = size * dmg_range(b, 0.9f, 1.4f), y = 0.16f * size, t = 0.05f * size;
    dmg_rod(b, v3(0, 0.1f * size, -0.12f * size), v3(0, 0.55f * size, -0.12f * size), 0.05f * size);
    dmg_box(b, v3(0, 0.3f * size, -0.12f * size), v3(0.2f * size, 0.08f * size, 0.14f * size));
    uint32_t lift = dmg_slide(b, 0, "forks", v3(0, 1, 0), 0.0f, 0.12f * size);
    dmg_box_span(b, v3(-at - 0.5f * wide, y - t, -0.05f * size), v3(at + 0.5f * wide, y + 0.35f * size, 0.04f * size));
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * at;
        dmg_use(b, lift);
        dmg_box_span(b, v3(x - 0.5f * wide, y - t, 0), v3(x + 0.5f * wide, y, 0.92f * fork));
        dmg_beam(b, v3(x, y - 0.5f * t, 0.92f * fork), v3(x, y - 0.7f * t, fork), 0.7f * wide, 0.6f * t);
        uint32_t bogie = lift;
        if (dmg_chance(b, 0.4f)) {
            bogie = dmg_hinge_across(b, lift, "bogie", v3(x, y - 0.5f * t, 0.6f * fork), -0.7f, 0.1f);
            dmg_beam(b, v3(x, y - 0.6f * t, 0.6f * fork), v3(x, 0.05f * size, 0.8f * fork), 0.3f * wide, 0.6f * t);
        }
        dmg_spin(b, bogie, "roller", v3(x, 0.05f * size, 0.8f * fork), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.35f * wide, 0.05f * size, 0.8f * fork), v3(x + 0.35f * wide, 0.05f * size, 0.8f * fork),
                0.05f * size);
    }
    dmg_use(b, 0);
    draw_tiller(b, size, 0.3f * size, -0.25f * size);
    dmg_box_span(b, v3(-0.06f * size, 0.2f * size, -0.27f * size), v3(0.06f * size, 0.26f * size, -0.1f * size));
}

void dmg_build_forklift(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.08f, 2.0f);
    int kind = dmg_weighted(b, (const float[]){5, 3, 2}, 3);
    if (kind == 0) build_counterbalance(b, size);
    if (kind == 1) build_stacker(b, size);
    if (kind == 2) build_pallet_truck(b, size);
    dmg_use(b, 0);
}
