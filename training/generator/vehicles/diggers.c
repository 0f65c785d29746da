/* Draws excavators and backhoes: a house that slews, a bent boom, a stick with its tail, a bucket, a thumb, a
 * breaker or a grab; rams that are still, jointed or left out. Ahead is +Z. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

/* ---- links: from the pin at the origin along +Z to the pin at z = length; above is +Y ---- */

typedef struct arm {
    int link; /* boxed and bent, boxed, two plates, a lattice, a plain bar */
    int pin;  /* on the carrier, on the mover, none */
    float thick, wide;
    dmg_ram_kind ram;
} arm;

static void draw_pin(dmg_builder* b, const arm* a, uint32_t carrier, uint32_t mover) {
    dmg_use(b, a->pin == 0 ? carrier : mover);
    float half = a->wide * (a->pin == 0 ? 0.85f : 0.6f), r = 0.45f * a->thick;
    if (a->pin < 2) dmg_rod(b, v3(-half, 0, 0), v3(half, 0, 0), r);
    dmg_use(b, carrier);
    for (int s = -1; s <= 1 && a->pin == 0; s += 2) /* ears */
        dmg_box(b, v3((float)s * 0.7f * a->wide, 0, -0.3f * a->thick),
                v3(0.2f * a->wide, 1.5f * a->thick, 2 * a->thick));
    dmg_use(b, mover);
}

/* tail: how far it goes on behind the pin; rise: of its bend. */
static void draw_link(dmg_builder* b, const arm* a, float length, float tail, float rise) {
    float t = a->thick, w = 0.5f * a->wide, knee = length * 0.42f;
    const dmg_xy side[] = {
        {-tail, 0.1f * t},       {0, -t}, {knee, rise - 1.2f * t}, {length, -0.6f * t}, {length, 0.6f * t},
        {knee, rise + 1.2f * t}, {0, t},  {-tail, 0.9f * t}};
    int first = tail > 0 ? 0 : 1, count = tail > 0 ? 8 : 6;
    if (a->link <= 1) dmg_side_prism(b, side + first, count, -w, w);
    for (int s = -1; s <= 1 && a->link == 2; s += 2)
        dmg_side_prism(b, side + first, count, (float)s * 0.55f * w, (float)s * w);
    if (a->link == 2)
        for (int i = 1; i < 4; ++i)
            dmg_rod(b, v3(-w, 0.5f * rise, 0.25f * length * (float)i), v3(w, 0.5f * rise, 0.25f * length * (float)i),
                    0.2f * t);
    if (a->link == 3)
        for (int i = 0; i < 4; ++i) {
            float x = (i & 1 ? 0.8f : -0.8f) * w, y = (i & 2 ? 0.8f : -0.8f) * t;
            dmg_beam(b, v3(x, y, -tail), v3(x, 0.6f * y, length), 0.25f * t, 0.25f * t);
            for (int k = 0; k < 4; ++k) {
                float z0 = 0.25f * length * (float)k, z1 = z0 + 0.25f * length;
                if (i < 2)
                    dmg_beam(b, v3(x, k % 2 ? 0.8f * t : -0.8f * t, z0), v3(x, k % 2 ? -0.6f * t : 0.6f * t, z1),
                             0.15f * t, 0.15f * t);
                if (i % 2 == 0)
                    dmg_beam(b, v3(k % 2 ? -x : x, y, z0), v3(k % 2 ? x : -x, 0.8f * y, z1), 0.15f * t, 0.15f * t);
            }
        }
    if (a->link == 4) dmg_beam(b, v3(0, 0, -tail), v3(0, 0, length), a->wide, 1.6f * t);
}

/* ---- what hangs on the stick: the pin at the origin, the stick came along +Z, the machine lies towards -Y ---- */

static void draw_bucket(dmg_builder* b, float r, float wide) {
    const dmg_xy bowl[] = {
        {0, 0.05f * r}, {1.5f * r, -0.3f * r}, {1.35f * r, 0.45f * r}, {0.85f * r, 0.8f * r}, {0.25f * r, 0.6f * r}};
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_side_prism(b, bowl, 5, -0.5f * wide, 0.5f * wide); /* solid */
    if (kind > 0) {
        const dmg_xy shell[] = {bowl[0], bowl[4], bowl[3], bowl[2], bowl[1]};
        dmg_side_sheet(b, shell, 5, 0.06f * r, wide);
        for (int s = -1; s <= 1; s += 2) dmg_side_prism(b, bowl, 5, (float)s * 0.46f * wide, (float)s * 0.5f * wide);
    }
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 0.2f * wide, 0.15f * r, 0.1f * r), v3(0.06f * wide, 0.5f * r, 0.5f * r));
    int teeth = kind < 2 ? dmg_int(b, 3, 6) : 0;
    for (int i = 0; i < teeth; ++i) {
        float x = wide * (((float)i + 0.5f) / (float)teeth - 0.5f);
        dmg_beam(b, v3(x, -0.25f * r, 1.49f * r), v3(x, -0.6f * r, 1.55f * r), 0.4f * wide / (float)teeth, 0.1f * r);
    }
}

/* Jaws that meet below a head that turns. */
static void draw_grab(dmg_builder* b, uint32_t stick, float r, float wide) {
    uint32_t head = dmg_hinge_across(b, stick, "grab", v3(0, 0, 0), -0.8f, 0.8f);
    dmg_box(b, v3(0, 0, 0.15f * r), v3(0.4f * wide, 0.3f * r, 0.5f * r));
    if (dmg_chance(b, 0.7f)) head = dmg_spin(b, head, "rotator", v3(0, 0, 0.4f * r), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, 0.4f * r), v3(0, 0, 0.7f * r), 0.25f * r);
    dmg_box(b, v3(0, 0, 0.75f * r), v3(0.5f * wide, 0.7f * r, 0.15f * r));
    int tines = dmg_int(b, 1, 3);
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_hinge(b, head, "jaw", v3(0, side * 0.3f * r, 0.8f * r), v3(-side, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.1f));
        const dmg_xy hook[] = {{0.75f * r, side * 0.3f * r},
                               {1.1f * r, side * 0.75f * r},
                               {1.6f * r, side * 0.7f * r},
                               {2.0f * r, side * 0.06f * r}};
        for (int i = 0; i < tines; ++i) {
            dmg_save(b);
            dmg_move(b, wide * (((float)i + 0.5f) / (float)tines - 0.5f), 0, 0);
            dmg_side_sheet(b, hook, 4, 0.1f * r, (tines == 1 ? 0.9f : 0.3f) * wide / (float)tines);
            dmg_restore(b);
        }
    }
}

static void draw_tool(dmg_builder* b, const arm* a, uint32_t stick, float r) {
    float wide = a->wide * dmg_range(b, 1.2f, 3.5f);
    int kind = dmg_weighted(b, (const float[]){6, 1.5f, 1.5f, 1}, 4);
    if (kind == 1) {
        draw_grab(b, stick, r, wide);
        return;
    }
    float bend = dmg_range(b, -0.3f, 1.5f); /* curled in by so much */
    dmg_save(b);
    if (kind == 0) dmg_turn(b, v3(1, 0, 0), bend);
    uint32_t tool = dmg_hinge_across(b, stick, kind == 0 ? "bucket" : "tool", v3(0, 0, 0),
                                     kind == 0 ? bend - 1.9f : -0.9f, kind == 0 ? bend + 0.5f : 0.9f);
    draw_pin(b, a, stick, tool);
    if (kind == 0) draw_bucket(b, r, wide);
    if (kind >= 2) {
        dmg_box(b, v3(0, 0, 0.5f * r), v3(0.8f * a->wide, 0.45f * r, 1.2f * r));
        if (kind == 2) dmg_slide(b, tool, "chisel", v3(0, 0, 1), -0.2f * r, 0.2f * r);
        if (kind == 3) dmg_spin(b, tool, "auger", v3(0, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0, 0, r), v3(0, 0, 2.2f * r), 0.1f * r);
        dmg_cone(b, v3(0, 0, 2.2f * r), v3(0, 0, 2.4f * r), 0.1f * r, 0.0f);
        for (int i = 0; i < 5 && kind == 3; ++i) { /* flights */
            dmg_save(b);
            dmg_move(b, 0, 0, (1.3f + 0.2f * (float)i) * r);
            dmg_turn(b, v3(1, 0, 0), 0.3f);
            dmg_rod(b, v3(0, 0, -0.02f * r), v3(0, 0, 0.02f * r), 0.3f * r);
            dmg_restore(b);
        }
    }
    dmg_restore(b);
    if (kind == 0 && dmg_chance(b, 0.3f)) { /* a thumb against it, hung before the pin on the machine's side */
        dmg_vec pin = {0, -0.9f * a->thick, -0.5f * r};
        dmg_hinge_across(b, stick, "thumb", pin, -0.2f, dmg_range(b, 0.5f, 1.2f));
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 0.3f * a->wide, pin.y, pin.z),
                     v3((float)s * 0.3f * a->wide, pin.y - 0.5f * r, pin.z + 1.1f * r), 0.15f * a->wide, 0.15f * r);
    }
}

/* ---- boom, stick and tool from the boom's pin at the origin on `carrier`; foot: where the boom's ram stands ---- */

static void draw_digger_arm(dmg_builder* b, uint32_t carrier, float size, dmg_vec foot) {
    float reach = size * dmg_range(b, 1.5f, 2.6f), dip = reach * dmg_range(b, 0.45f, 0.75f),
          up = dmg_range(b, 0.25f, 1.1f), fold = dmg_range(b, 1.0f, 2.5f);
    arm a = {.link = dmg_weighted(b, (const float[]){4, 2, 2, 1, 1}, 5)};
    a.pin = dmg_int(b, 0, 2);
    a.ram = dmg_ram_pick(b);
    a.thick = size * dmg_range(b, 0.07f, 0.15f);
    a.wide = size * dmg_range(b, 0.14f, 0.3f);
    float rise = a.link == 0 || a.link == 2 ? reach * dmg_range(b, 0.1f, 0.25f) : 0.0f,
          tail = dip * dmg_range(b, 0.0f, 0.3f), r = 0.25f * a.wide;
    dmg_save(b);
    uint32_t boom = dmg_hinge_across(b, carrier, "boom", v3(0, 0, 0), -0.4f - 0.5f * up, 1.3f - up);
    dmg_turn(b, v3(1, 0, 0), -up);
    draw_pin(b, &a, carrier, boom);
    draw_link(b, &a, reach, 0, rise);
    dmg_restore(b);
    dmg_vec lug = v3_turn(v3(0, rise - 1.2f * a.thick, 0.42f * reach), v3(1, 0, 0), -up);
    dmg_ram_draw(b, a.ram, carrier, boom, foot, lug, r);
    dmg_turn(b, v3(1, 0, 0), -up);
    dmg_vec tip = v3_add(v3(0, 0, reach), v3_turn(v3(0, 0.5f * a.thick, -tail), v3(1, 0, 0), fold));
    if (dmg_chance(b, 0.15f)) { /* a boom in two: its outer half turns on it */
        dmg_move(b, 0, 0, reach);
        boom = dmg_hinge_across(b, boom, "jib", v3(0, 0, 0), -0.8f, 0.5f);
        draw_link(b, &a, 0.5f * reach, 0, 0);
        dmg_move(b, 0, 0, -0.5f * reach);
        tip = v3_add(v3(0, 0, reach), v3_turn(v3(0, 0.5f * a.thick, -tail), v3(1, 0, 0), fold));
    }
    uint32_t stick;
    dmg_save(b);
    dmg_move(b, 0, 0, reach);
    stick = dmg_hinge_across(b, boom, "stick", v3(0, 0, 0), fold - 2.7f, fold - 0.5f);
    dmg_turn(b, v3(1, 0, 0), fold);
    draw_pin(b, &a, boom, stick);
    arm outer = a;
    outer.thick *= 0.8f;
    outer.wide *= 0.8f;
    if (outer.link == 0) outer.link = 1;
    bool reaches = dmg_chance(b, 0.12f); /* its end slides out */
    draw_link(b, &outer, dip, tail, 0);
    dmg_restore(b);
    if (tail > 0.1f * dip) dmg_ram_draw(b, a.ram, boom, stick, v3(0, rise + 2.0f * a.thick, 0.4f * reach), tip, r);
    dmg_move(b, 0, 0, reach);
    dmg_turn(b, v3(1, 0, 0), fold);
    if (reaches) {
        stick = dmg_slide(b, stick, "extension", v3(0, 0, 1), 0.0f, 0.5f * dip);
        dmg_box_span(b, v3(-0.35f * outer.wide, -0.4f * outer.thick, 0.5f * dip),
                     v3(0.35f * outer.wide, 0.4f * outer.thick, 1.05f * dip));
        dmg_move(b, 0, 0, 0.06f * dip);
    }
    dmg_move(b, 0, 0, dip);
    draw_tool(b, &outer, stick, size * dmg_range(b, 0.2f, 0.4f));
}

/* ---- what it stands on; the slewing ring lies at y = high ---- */

static void draw_track(dmg_builder* b, int kind, float x, float wide, float length, float high) {
    float h = 0.5f * length, r = 0.5f * high;
    const dmg_xy loop[] = {{-h + 0.3f * r, 0}, {h - 0.3f * r, 0},     {h, 0.4f * r},          {h + 0.2f * r, r},
                           {h, 1.7f * r},      {h - 0.4f * r, 2 * r}, {-h + 0.4f * r, 2 * r}, {-h, 1.7f * r},
                           {-h - 0.2f * r, r}, {-h, 0.4f * r}};
    if (kind == 2) dmg_rounded_box(b, v3(x, r, 0), v3(wide, high, length), 0.7f * r);
    if (kind != 2) dmg_side_prism(b, loop, 10, x - 0.5f * wide, x + 0.5f * wide);
    float out = x + (x > 0 ? 0.53f : -0.53f) * wide;
    for (int i = 0; i < 5 && kind == 1; ++i) { /* wheels seen from outside: the outer two drive */
        float z = 0.23f * length * ((float)i - 2), radius = i == 0 || i == 4 ? 0.75f * r : 0.4f * r,
              y = i == 0 || i == 4 ? r : 0.5f * r;
        if (i == 0 || i == 4) dmg_spin(b, 0, "sprocket", v3(out, y, z), v3(1, 0, 0));
        dmg_rod(b, v3(x, y, z), v3(out, y, z), radius);
        dmg_use(b, 0);
    }
}

static void draw_blade(dmg_builder* b, float size, float z, float high) {
    float reach = size * dmg_range(b, 0.3f, 0.5f), wide = size * dmg_range(b, 1.3f, 1.8f), tall = 0.8f * high;
    dmg_hinge_across(b, 0, "blade", v3(0, 0.6f * high, z), -0.15f, dmg_range(b, 0.2f, 0.5f));
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * 0.3f * size, 0.6f * high, z), v3((float)s * 0.35f * size, 0.4f * high, z + reach),
                 0.1f * size, 0.1f * size);
    const dmg_xy face[] = {{z + reach + 0.1f * size, 0.05f * high},
                           {z + reach, 0.05f * high + 0.35f * tall},
                           {z + reach, 0.05f * high + 0.7f * tall},
                           {z + reach + 0.1f * size, 0.05f * high + tall}};
    dmg_side_sheet(b, face, 4, 0.05f * size, wide);
    dmg_use(b, 0);
}

static float draw_undercarriage(dmg_builder* b, float size) {
    int kind = dmg_weighted(b, (const float[]){5, 2, 2}, 3);
    float high = size * dmg_range(b, 0.35f, 0.6f), length = size * dmg_range(b, 1.5f, 2.4f),
          gauge = size * dmg_range(b, 0.5f, 0.75f);
    if (kind == 2) { /* a plinth or a column */
        if (dmg_chance(b, 0.5f)) high *= dmg_range(b, 1.0f, 4.0f);
        dmg_cone(b, v3(0, 0, 0), v3(0, high, 0), 0.7f * size, 0.45f * size);
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.05f * size, 0), v3(2 * size, 0.1f * size, 2 * size));
        return high;
    }
    dmg_box_span(b, v3(-0.5f * size, 0.4f * high, -0.4f * size), v3(0.5f * size, 0.95f * high, 0.4f * size));
    dmg_rod(b, v3(0, 0.9f * high, 0), v3(0, high, 0), 0.4f * size);
    if (kind == 0) {
        int track = dmg_int(b, 0, 2);
        float wide = size * dmg_range(b, 0.22f, 0.4f);
        for (int s = -1; s <= 1; s += 2) {
            dmg_box_span(b, v3((float)s * 0.3f * size, 0.4f * high, -0.25f * size),
                         v3((float)s * gauge, 0.7f * high, 0.25f * size));
            draw_track(b, track, (float)s * gauge, wide, length, 0.85f * high);
        }
    } else {
        dmg_box_span(b, v3(-0.3f * size, 0.4f * high, -0.5f * length), v3(0.3f * size, 0.8f * high, 0.5f * length));
        dmg_tyre t = dmg_tyre_pick(b, 0.6f * high);
        for (int s = -1; s <= 1; s += 2) {
            t.steers = s > 0 && dmg_chance(b, 0.6f);
            if (t.steers && t.knuckle == 1) t.knuckle = 0;
            dmg_axle_draw(b, &t, 0, gauge + 0.3f * t.width, (float)s * 0.35f * length);
        }
    }
    if (dmg_chance(b, 0.35f)) draw_blade(b, size, 0.5f * length, high);
    return high;
}

/* ---- the house, on the slewing ring at the origin ---- */

static void draw_house(dmg_builder* b, float size, uint32_t house, float side) {
    float half = size * dmg_range(b, 0.5f, 0.75f), rear = size * dmg_range(b, 0.6f, 1.2f),
          deck = size * dmg_range(b, 0.1f, 0.25f), tall = size * dmg_range(b, 0.3f, 0.6f);
    int stern = dmg_int(b, 0, 2);
    dmg_box_span(b, v3(-half, 0, -0.6f * rear), v3(half, deck, 0.5f * size));
    dmg_box_span(b, v3(-half, deck, -0.7f * rear), v3(half, deck + tall, 0.0f));
    if (stern == 0) dmg_box_span(b, v3(-half, 0.02f * size, -rear), v3(half, deck + 0.9f * tall, -0.7f * rear));
    if (stern == 1) { /* round */
        const dmg_xy profile[] = {
            {0, 0.02f * size}, {half, 0.02f * size}, {half, deck + 0.85f * tall}, {0, deck + 0.85f * tall}};
        dmg_save(b);
        dmg_move(b, 0, 0, -0.7f * rear);
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 4);
        dmg_restore(b);
    }
    if (stern == 2)
        dmg_rounded_box(b, v3(0, 0.5f * (deck + tall), -0.85f * rear), v3(2 * half, deck + tall, 0.4f * rear),
                        0.12f * size);
    if (dmg_chance(b, 0.5f)) { /* the engine's cover */
        float t = 0.04f * size, y = deck + tall;
        bool at_rear = dmg_chance(b, 0.6f);
        float z0 = -0.68f * rear, z1 = -0.1f * rear;
        dmg_hinge_across(b, house, "hood", v3(0, y, at_rear ? z0 : z1), at_rear ? 0.0f : -1.2f, at_rear ? 1.2f : 0.0f);
        dmg_box_span(b, v3(-0.9f * half, y, z0), v3(0.9f * half, y + t, z1));
        dmg_use(b, house);
    }
    if (dmg_chance(b, 0.4f))
        dmg_rod(b, v3(0.7f * side * half, deck + tall, -0.5f * rear),
                v3(0.7f * side * half, deck + 1.6f * tall, -0.5f * rear), 0.04f * size);
    if (dmg_chance(b, 0.85f)) {
        float wide = half * dmg_range(b, 0.65f, 0.85f), x = side * half;
        dmg_cab cab = dmg_cab_pick(b, v3(fminf(x, x - side * wide), deck, 0.0f),
                                   v3(fmaxf(x, x - side * wide), deck + size * dmg_range(b, 0.7f, 1.0f), 0.65f * size));
        cab.left = cab.left && side < 0;
        cab.right = !cab.left && side > 0;
        dmg_cab_draw(b, &cab, house);
    }
}

static void build_slewing(dmg_builder* b, float size) {
    float high = draw_undercarriage(b, size), side = dmg_sign(b);
    dmg_move(b, 0, high, 0);
    uint32_t house = dmg_spin(b, 0, "house", v3(0, 0, 0), v3(0, 1, 0));
    dmg_turn(b, v3(0, 1, 0), dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, -3.0f, 3.0f));
    draw_house(b, size, house, side);
    float x = -side * size * dmg_range(b, 0.0f, 0.1f), y = 0.25f * size;
    dmg_vec foot = {0, -0.18f * size, 0.15f * size};
    if (dmg_chance(b, 0.3f)) { /* a post that swings the boom to the sides */
        dmg_use(b, house);
        dmg_box_span(b, v3(x - 0.14f * size, 0, 0.4f * size), v3(x + 0.14f * size, 0.08f * size, 0.85f * size));
        house = dmg_hinge(b, house, "swing_post", v3(x, 0, 0.78f * size), v3(0, dmg_sign(b), 0), -1.0f, 1.0f);
        dmg_box_span(b, v3(x - 0.13f * size, 0.08f * size, 0.66f * size),
                     v3(x + 0.13f * size, 0.35f * size, 0.95f * size));
        foot = v3(0, -0.12f * size, 0.12f * size);
        dmg_move(b, x, y + 0.05f * size, 0.9f * size);
    } else {
        dmg_move(b, x, y, 0.55f * size);
    }
    draw_digger_arm(b, house, size, foot);
}

/* ---- a tractor with a loader before it and a digging arm behind ---- */

static void draw_loader(dmg_builder* b, float size, float half) {
    float y = 0.95f * size, z = 0.5f * size, reach = size * dmg_range(b, 1.3f, 1.8f), t = 0.08f * size,
          drop = dmg_range(b, 0.1f, 0.45f), r = size * dmg_range(b, 0.35f, 0.5f),
          wide = size * dmg_range(b, 1.1f, 1.6f);
    dmg_vec pin = {0, y, z}, end = {0, y - reach * sinf(drop), z + reach * cosf(drop)};
    dmg_ram_kind ram = dmg_ram_pick(b);
    for (int s = -1; s <= 1; s += 2) /* towers */
        dmg_box_span(b, v3((float)s * half - 0.5f * t, 0.45f * size, z - t),
                     v3((float)s * half + 0.5f * t, y + 0.5f * t, z + t));
    uint32_t arms = dmg_hinge_across(b, 0, "loader", pin, -0.2f, dmg_range(b, 0.7f, 1.2f));
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec out = {(float)s * (half + t), 0, 0};
        dmg_beam(b, v3_add(pin, out), v3_add(end, out), t, 2 * t);
        dmg_ram_draw(b, ram, 0, arms, v3((float)s * half, 0.5f * size, z),
                     v3_add(v3_lerp(pin, end, 0.45f), v3_scale(out, half / (half + t))), 0.4f * t);
    }
    dmg_vec across = {half + t, 0, 0}, bar = v3_lerp(pin, end, 0.93f);
    dmg_rod(b, v3_sub(bar, across), v3_add(bar, across), 0.4f * t);
    dmg_hinge_across(b, arms, "bucket", end, -1.0f, 0.8f);
    const dmg_xy bowl[] = {{end.z + 1.1f * r, end.y - 0.5f * r},
                           {end.z + 0.2f * r, end.y - 0.5f * r},
                           {end.z, end.y},
                           {end.z + 0.15f * r, end.y + 0.5f * r},
                           {end.z + 0.5f * r, end.y + 0.7f * r}};
    const dmg_xy cheek[] = {bowl[4], bowl[3], bowl[2], bowl[1], bowl[0]};
    dmg_side_sheet(b, bowl, 5, 0.07f * r, wide);
    for (int s = -1; s <= 1; s += 2) dmg_side_prism(b, cheek, 5, (float)s * 0.47f * wide, (float)s * 0.5f * wide);
    dmg_use(b, 0);
}

static void draw_tractor(dmg_builder* b, float size) {
    float big = size * dmg_range(b, 0.5f, 0.7f), half = size * dmg_range(b, 0.7f, 0.85f), deck = 0.6f * size,
          t = 0.04f * size;
    dmg_tyre rear = dmg_tyre_pick(b, big), front;
    rear.width = fminf(rear.width, 0.45f * size);
    front = rear;
    front.radius = big * dmg_range(b, 0.6f, 0.85f);
    front.width = 0.7f * rear.width;
    front.steers = dmg_chance(b, 0.8f);
    front.knuckle = 2 * dmg_int(b, 0, 1);
    dmg_box_span(b, v3(-0.35f * size, 0.35f * size, -0.9f * size), v3(0.35f * size, deck, 1.25f * size));
    dmg_axle_draw(b, &rear, 0, half, -0.45f * size);
    dmg_axle_draw(b, &front, 0, half, 0.95f * size);
    bool opens = dmg_chance(b, 0.5f), at_nose = dmg_chance(b, 0.5f);
    dmg_box_span(b, v3(-0.28f * size, deck, 0.45f * size), v3(0.28f * size, 0.9f * size, 1.25f * size));
    if (opens)
        dmg_hinge_across(b, 0, "hood", v3(0, 0.9f * size, (at_nose ? 1.25f : 0.45f) * size), at_nose ? -1.0f : 0.0f,
                         at_nose ? 0.0f : 1.0f);
    dmg_box_span(b, v3(-0.28f * size, 0.9f * size, 0.45f * size), v3(0.28f * size, 0.9f * size + t, 1.25f * size));
    dmg_use(b, 0);
    dmg_cab cab = dmg_cab_pick(b, v3(-0.42f * size, deck, -0.7f * size),
                               v3(0.42f * size, size * dmg_range(b, 1.5f, 1.9f), 0.4f * size));
    dmg_cab_draw(b, &cab, 0);
}

static void build_backhoe(dmg_builder* b, float size) {
    draw_tractor(b, size);
    if (dmg_chance(b, 0.7f)) draw_loader(b, size, 0.36f * size);
    dmg_turn(b, v3(0, 1, 0), DMG_PI); /* now the rear is ahead */
    dmg_move(b, 0, 0, 0.9f * size);
    dmg_box_span(b, v3(-0.6f * size, 0.35f * size, 0), v3(0.6f * size, 0.55f * size, 0.12f * size));
    bool flips = dmg_chance(b, 0.6f);
    for (int s = -1; s <= 1; s += 2) { /* legs: folded up beside, or let down */
        float side = (float)s, x = side * 0.55f * size, y = 0.45f * size, z = 0.18f * size, leg = 0.6f * size;
        float lean = flips ? dmg_range(b, 0.0f, 0.4f) : 0.0f;
        dmg_vec foot = flips ? v3(x + side * leg * sinf(lean), y + leg * cosf(lean), z) : v3(x, 0.1f * size, z);
        if (flips)
            dmg_hinge(b, 0, "stabiliser", v3(x, y, z), v3(0, 0, -side), 0.0f, 2.4f - lean);
        else
            dmg_slide(b, 0, "stabiliser", v3(0, -1, 0), 0.0f, 0.1f * size);
        dmg_beam(b, v3(x, flips ? y : 0.8f * size, z), foot, 0.12f * size, 0.12f * size);
        dmg_box(b, foot, v3(0.25f * size, 0.06f * size, 0.25f * size));
        dmg_use(b, 0);
    }
    float x = dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, -0.3f, 0.3f) * size;
    dmg_box_span(b, v3(x - 0.12f * size, 0.4f * size, 0.1f * size), v3(x + 0.12f * size, 0.46f * size, 0.35f * size));
    uint32_t post = dmg_hinge(b, 0, "swing_post", v3(x, 0.5f * size, 0.26f * size), v3(0, dmg_sign(b), 0), -1.3f, 1.3f);
    dmg_box_span(b, v3(x - 0.12f * size, 0.46f * size, 0.15f * size), v3(x + 0.12f * size, 0.75f * size, 0.45f * size));
    dmg_move(b, x, 0.7f * size, 0.42f * size);
    draw_digger_arm(b, post, 0.8f * size, v3(0, -0.18f * size, 0.0f));
}

void dmg_build_excavator(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.08f, 3.0f);
    if (dmg_chance(b, 0.25f))
        build_backhoe(b, size);
    else
        build_slewing(b, size);
    dmg_use(b, 0);
}
