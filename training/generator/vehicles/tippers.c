/* Draws lorries and tippers: beds with tailgates and boards, rock dumpers, trailers, front skips. Ahead is +Z; a
 * lorry's rear end is z = 0. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/trucks.h"

/* ---- what every lorry has ---- */

dmg_truck dmg_truck_pick(dmg_builder* b, float size) {
    dmg_truck t = {.half = size * dmg_range(b, 0.42f, 0.55f)};
    t.length = size * dmg_range(b, 1.4f, 3.2f);
    t.wheel = size * dmg_range(b, 0.18f, 0.28f);
    t.deck = 2.0f * t.wheel * dmg_range(b, 1.0f, 1.3f);
    t.cab = size * dmg_range(b, 0.55f, 0.95f);
    t.roof = t.deck + size * dmg_range(b, 0.7f, 1.1f);
    t.nose = dmg_chance(b, 0.35f) ? size * dmg_range(b, 0.4f, 0.8f) : 0.0f;
    return t;
}

static void draw_bonnet(dmg_builder* b, const dmg_truck* t, uint32_t carrier, float z) {
    float low = 1.1f * t->wheel, belt = t->deck + 0.35f * (t->roof - t->deck), x = 0.8f * t->half;
    dmg_use(b, carrier);
    bool whole = dmg_chance(b, 0.5f), opens = dmg_chance(b, 0.6f);
    if (!whole) dmg_box_span(b, v3(-x, low, z), v3(x, 0.85f * belt, z + t->nose));
    if (opens && whole) /* bonnet and wings as one tip forward */
        dmg_hinge_across(b, carrier, "bonnet", v3(0, low, z + t->nose), -1.1f, 0.0f);
    if (opens && !whole) dmg_hinge_across(b, carrier, "bonnet", v3(0, belt, z), 0.0f, 1.0f);
    dmg_box_span(b, v3(-x, whole ? low : 0.85f * belt, z + 0.01f * t->nose), v3(x, belt, z + t->nose));
    dmg_use(b, 0);
}

static void draw_truck_cab(dmg_builder* b, const dmg_truck* t) {
    float z0 = t->length + 0.06f * t->cab, z1 = z0 + t->cab, floor = t->nose > 0 ? 0.85f * t->deck : 1.0f * t->wheel;
    dmg_box_span(b, v3(-0.45f * t->half, 0.7f * t->deck, z0), v3(0.45f * t->half, 0.9f * t->deck, z1 + t->nose));
    uint32_t cab_part = 0;
    if (t->nose == 0 && dmg_chance(b, 0.35f))
        cab_part = dmg_hinge_across(b, 0, "cab", v3(0, floor + 0.05f * t->cab, z1 - 0.05f * t->cab),
                                    -dmg_range(b, 0.6f, 1.0f), 0.0f);
    dmg_cab cab = dmg_cab_pick(b, v3(-0.95f * t->half, floor, z0), v3(0.95f * t->half, t->roof, z1));
    dmg_cab_draw(b, &cab, cab_part);
    if (dmg_chance(b, 0.5f))
        for (int s = -1; s <= 1; s += 2) {
            dmg_vec root = {(float)s * 0.96f * t->half, t->roof - 0.3f * (t->roof - t->deck), z1 - 0.05f * t->cab},
                    glass = v3_add(root, v3((float)s * 0.2f * t->half, 0, 0));
            if (dmg_chance(b, 0.4f)) dmg_hinge(b, cab_part, "mirror", root, v3(0, dmg_sign(b), 0), -1.0f, 1.0f);
            dmg_rod(b, root, glass, 0.02f * t->half);
            dmg_box(b, glass, v3(0.14f * t->half, 0.35f * t->half, 0.04f * t->half));
            dmg_use(b, cab_part);
        }
    if (t->nose > 0) draw_bonnet(b, t, 0, z1);
    dmg_use(b, 0);
}

void dmg_truck_draw(dmg_builder* b, const dmg_truck* t) {
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.35f * t->half - 0.06f * t->half, 0.8f * t->deck, 0),
                     v3((float)s * 0.35f * t->half + 0.06f * t->half, 0.95f * t->deck, t->length + 0.5f * t->cab));
    for (int i = 0; i < 3; ++i) {
        float z = t->length * (0.1f + 0.4f * (float)i);
        dmg_box_span(b, v3(-0.35f * t->half, 0.82f * t->deck, z),
                     v3(0.35f * t->half, 0.92f * t->deck, z + 0.1f * t->half));
    }
    dmg_tyre front = dmg_tyre_pick(b, t->wheel), rear = front;
    front.width = fminf(front.width, 0.5f * t->half);
    rear.width = front.width * (dmg_chance(b, 0.5f) ? 1.5f : 1.0f);
    front.steers = dmg_chance(b, 0.6f);
    front.knuckle = 2 * dmg_int(b, 0, 1);
    int rears = dmg_int(b, 1, 3);
    float at = t->nose > 0 ? t->length + t->cab + 0.55f * t->nose : t->length + 0.5f * t->cab;
    dmg_axle_draw(b, &front, 0, t->half - 0.4f * front.width, at);
    for (int i = 0; i < rears; ++i)
        dmg_axle_draw(b, &rear, 0, t->half - 0.5f * rear.width, (1.3f + 2.2f * (float)i) * t->wheel);
    draw_truck_cab(b, t);
    if (dmg_chance(b, 0.5f)) { /* a tank and a box between the axles */
        float z = t->length - 0.3f * t->cab;
        dmg_rod(b, v3(0.7f * t->half, 0.6f * t->deck, z - 0.5f * t->cab), v3(0.7f * t->half, 0.6f * t->deck, z),
                0.22f * t->deck);
        dmg_box_span(b, v3(-0.9f * t->half, 0.4f * t->deck, z - 0.4f * t->cab), v3(-0.5f * t->half, 0.8f * t->deck, z));
    }
}

/* ---- beds: the rear pivot at the origin, the floor at y = 0, ahead is +Z ---- */

typedef struct bed {
    float half, length, high, t;
    float over; /* how far it hangs out behind its pivot */
    int kind;   /* boards, ribbed boards, a rock body, half round, with sides that drop */
} bed;

static void draw_board_ribs(dmg_builder* b, const bed* d) {
    int ribs = dmg_int(b, 3, 7);
    for (int s = -1; s <= 1; s += 2)
        for (int i = 0; i < ribs; ++i) {
            float z = -d->over + (d->length + d->over) * ((float)i + 0.5f) / (float)ribs,
                  x = (float)s * (d->half + 0.5f * d->t);
            dmg_box_span(b, v3(x - 0.5f * d->t, 0, z - d->t), v3(x + 0.5f * d->t, d->high, z + d->t));
        }
}

static void draw_bed_shell(dmg_builder* b, const bed* d) {
    float back = -d->over, h = d->half, t = d->t;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.4f * h - t, -1.5f * t, back), v3((float)s * 0.4f * h + t, -t, d->length));
    if (d->kind == 2) { /* the floor goes up behind, a roof over the cab */
        const dmg_xy floor[] = {{back - 0.2f * d->length, 0.55f * d->high},
                                {back + 0.15f * d->length, 0.1f * d->high},
                                {0.8f * d->length, -0.5f * t},
                                {d->length, d->high},
                                {d->length + 0.35f * d->length, 1.02f * d->high}};
        const dmg_xy wall[] = {{back - 0.2f * d->length, 0.55f * d->high},
                               {back + 0.15f * d->length, 0.1f * d->high},
                               {0.8f * d->length, -0.5f * t},
                               {d->length, d->high},
                               {back - 0.05f * d->length, d->high}};
        dmg_side_sheet(b, floor, 5, 1.5f * t, 2 * h);
        for (int s = -1; s <= 1; s += 2) dmg_side_prism(b, wall, 5, (float)s * h, (float)s * (h - 1.5f * t));
        return;
    }
    dmg_box_span(b, v3(-h, d->high * (d->kind == 3 ? 0.0f : -0.02f), d->length - t), v3(h, d->high, d->length));
    if (d->kind == 3) {
        dmg_xy round[9];
        for (int i = 0; i < 9; ++i) {
            float angle = DMG_PI * (1.0f + (float)i / 8.0f);
            round[i] = (dmg_xy){h * cosf(angle), d->high * (1.0f + sinf(angle))};
        }
        dmg_save(b);
        dmg_move(b, 0, 0, 0.5f * (d->length + back));
        dmg_bent_plate(b, round, 9, t, d->length - back);
        dmg_restore(b);
        return;
    }
    dmg_box_span(b, v3(-h, -t, back), v3(h, 0, d->length));
    for (int s = -1; s <= 1 && d->kind < 2; s += 2)
        dmg_box_span(b, v3((float)s * h - (s > 0 ? t : 0), 0, back),
                     v3((float)s * h + (s > 0 ? 0 : t), d->high, d->length));
    if (d->kind == 1) draw_board_ribs(b, d);
}

/* Draws what closes it behind: hung at its top, at its bottom, two leaves, or one that is lifted out. */
static void draw_tailgate(dmg_builder* b, const bed* d, uint32_t carrier) {
    float z = -d->over, h = d->half, t = d->t;
    int kind = dmg_weighted(b, (const float[]){4, 3, 1.5f, 1.5f}, 4);
    if (kind == 2) {
        for (int s = -1; s <= 1; s += 2) {
            float side = (float)s;
            uint32_t leaf = dmg_hinge(b, carrier, "tail_door", v3(side * h, 0.5f * d->high, z), v3(0, -side, 0), 0.0f,
                                      dmg_range(b, 1.6f, 3.0f));
            dmg_box_span(b, v3(fminf(side * h, 0.01f * side * h), 0, z - t),
                         v3(fmaxf(side * h, 0.01f * side * h), d->high, z));
            if (dmg_chance(b, 0.6f)) { /* a rod with its handle */
                float x = side * 0.15f * h;
                dmg_hinge(b, leaf, "bolt", v3(x, 0, z - 1.5f * t), v3(0, dmg_sign(b), 0), -1.2f, 1.2f);
                dmg_rod(b, v3(x, 0.02f * d->high, z - 1.5f * t), v3(x, 0.98f * d->high, z - 1.5f * t), 0.5f * t);
                dmg_box_span(b, v3(fminf(x, x + side * 0.2f * h), 0.4f * d->high, z - 2.3f * t),
                             v3(fmaxf(x, x + side * 0.2f * h), 0.45f * d->high, z - 1.5f * t));
            }
            dmg_use(b, carrier);
        }
        return;
    }
    float out = dmg_chance(b, 0.5f) ? 0.0f : 1.5f * t, lean = dmg_range(b, 0.6f, 1.4f);
    if (kind == 0) dmg_hinge_across(b, carrier, "tailgate", v3(0, d->high + out, z), -lean, 0.0f);
    if (kind == 1)
        dmg_hinge_across(b, carrier, "tailgate", v3(0, -0.5f * out, z - out), 0.0f, dmg_range(b, 1.5f, 2.9f));
    if (kind == 3) dmg_slide(b, carrier, "tailgate", v3(0, 1, 0), 0.0f, 0.9f * d->high);
    float x = kind == 3 ? 0.97f * h : h;
    dmg_box_span(b, v3(-x, 0, z - t), v3(x, d->high, z));
    if (kind == 0 && out > 0)
        for (int s = -1; s <= 1; s += 2) {
            dmg_box_span(b, v3((float)s * 0.9f * h - t, d->high - t, z - t),
                         v3((float)s * 0.9f * h + t, d->high + 2 * out, z + t));
            dmg_use(b, carrier);
            dmg_box_span(b, v3((float)s * 0.97f * h - 0.5f * t, d->high, z),
                         v3((float)s * 0.97f * h + 0.5f * t, d->high + 2 * out, z + 4 * t));
            dmg_use(b, b->part_count);
        }
    if (kind < 2 && dmg_chance(b, 0.4f)) { /* a hatch let into it, for grain */
        dmg_slide(b, b->part_count, "hatch", v3(0, 1, 0), 0.0f, 0.35f * d->high);
        dmg_box_span(b, v3(-0.2f * h, 0.08f * d->high, z - 1.6f * t), v3(0.2f * h, 0.45f * d->high, z - t));
    }
    dmg_use(b, carrier);
    if (kind == 3)
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * h - t, -t, z - 2 * t), v3((float)s * h + t, d->high, z - t));
}

static void draw_drop_sides(dmg_builder* b, const bed* d, uint32_t carrier) {
    int each = dmg_int(b, 1, 3);
    float back = -d->over, span = (d->length - d->t - back) / (float)each, swing = dmg_range(b, 1.5f, 3.0f),
          drop = dmg_chance(b, 0.5f) ? 0.0f : d->t;
    for (int s = -1; s <= 1; s += 2)
        for (int i = 0; i < each; ++i) {
            float side = (float)s, x = side * d->half, z0 = back + span * (float)i, z1 = z0 + 0.97f * span;
            dmg_hinge(b, carrier, "side_board", v3(x, -drop, 0.5f * (z0 + z1)), v3(0, 0, -side), 0.0f, swing);
            dmg_box_span(b, v3(fminf(x, x + side * d->t), -drop, z0), v3(fmaxf(x, x + side * d->t), d->high, z1));
            if (dmg_chance(b, 0.3f))
                dmg_box(b, v3(x + side * 1.3f * d->t, 0.7f * d->high, z0 + 0.1f * span),
                        v3(d->t, 0.2f * d->high, 0.04f * span));
            dmg_use(b, carrier);
            if (i)
                dmg_box_span(b, v3(x - side * d->t - d->t, 0, z0 - 0.03f * span),
                             v3(x - side * d->t + d->t, d->high, z0 - 0.005f * span));
        }
}

static void draw_bed_cover(dmg_builder* b, const bed* d, uint32_t carrier) {
    int kind = dmg_int(b, 0, 2);
    float y = d->high, back = -d->over;
    if (kind == 0) { /* pushed to the front or the rear */
        dmg_slide(b, carrier, "cover", v3(0, 0, 1), 0.0f, 0.8f * d->length);
        dmg_box_span(b, v3(-d->half, y, back), v3(d->half, y + 0.6f * d->t, d->length));
    } else { /* two halves that turn out over the sides */
        for (int s = -1; s <= 1; s += 2) {
            float side = (float)s;
            dmg_hinge(b, carrier, "cover", v3(side * d->half, y, 0.5f * (back + d->length)), v3(0, 0, -side), 0.0f,
                      kind == 1 ? 2.6f : 1.5f);
            dmg_box_span(b, v3(fminf(side * d->half, side * d->t), y, back),
                         v3(fmaxf(side * d->half, side * d->t), y + 0.6f * d->t, d->length));
            dmg_use(b, carrier);
        }
    }
    dmg_use(b, carrier);
}

/* Tips to the rear, or to a side, from the frame at y = 0. */
static void draw_bed(dmg_builder* b, const bed* d) {
    bool aside = d->kind == 4 && dmg_chance(b, 0.4f);
    float most = dmg_range(b, 0.6f, 1.0f), raised = dmg_chance(b, 0.7f) ? 0.0f : dmg_range(b, 0.1f, 0.9f) * most,
          side = dmg_sign(b), t = d->t;
    dmg_ram_kind ram = dmg_ram_pick(b);
    uint32_t part;
    dmg_vec foot = {0, -0.5f * d->high, d->length + 2 * t}, top = {0, 0.85f * d->high, d->length + 2 * t};
    if (d->kind == 2) {
        foot = v3(0.2f * d->half, -0.5f * d->high, 0.35f * d->length);
        top = v3(0.2f * d->half, -0.5f * t, 0.7f * d->length);
    }
    for (int s = -1; s <= 1 && !aside; s += 2)
        dmg_box_span(b, v3((float)s * 0.3f * d->half - t, -3 * t, -2 * t),
                     v3((float)s * 0.3f * d->half + t, 0.5f * t, 2 * t));
    if (aside)
        part = dmg_hinge(b, 0, "bed", v3(side * 0.8f * d->half, -t, 0.5f * d->length), v3(0, 0, -side), -0.5f * raised,
                         0.8f - 0.5f * raised);
    else
        part = dmg_hinge_across(b, 0, "bed", v3(0, -t, 0), -raised, most - raised);
    dmg_save(b);
    if (!aside) {
        dmg_move(b, 0, -t, 0);
        dmg_turn(b, v3(1, 0, 0), -raised);
        dmg_move(b, 0, t, 0);
        top = v3_turn(top, v3(1, 0, 0), -raised);
    } else {
        dmg_rest(b, part, 0);
    }
    draw_bed_shell(b, d);
    if (d->kind != 2 && (d->kind != 3 || dmg_chance(b, 0.5f))) draw_tailgate(b, d, part);
    if (d->kind == 4) draw_drop_sides(b, d, part);
    if (d->kind < 2 && dmg_chance(b, 0.25f)) draw_bed_cover(b, d, part);
    dmg_restore(b);
    if (!aside) dmg_ram_draw(b, ram, 0, part, foot, top, 1.6f * t);
    dmg_use(b, 0);
}

static bed pick_bed(dmg_builder* b, float half, float length) {
    bed d = {.half = half, .length = length, .kind = dmg_weighted(b, (const float[]){3, 2, 2, 1, 2}, 5)};
    d.high = half * (d.kind == 4 ? dmg_range(b, 0.3f, 0.7f) : dmg_range(b, 0.5f, 1.3f));
    d.t = half * dmg_range(b, 0.03f, 0.07f);
    d.over = length * dmg_range(b, 0.0f, 0.15f);
    return d;
}

/* ---- without a cab: drawn by a bar that folds or slides, on a wheel or a leg ---- */

static void build_trailer(dmg_builder* b, float size) {
    float half = size * dmg_range(b, 0.4f, 0.6f), length = size * dmg_range(b, 1.0f, 2.0f),
          wheel = size * dmg_range(b, 0.2f, 0.3f), deck = 1.9f * wheel, bar = size * dmg_range(b, 0.6f, 1.0f);
    dmg_tyre t = dmg_tyre_pick(b, wheel);
    bool beside = dmg_chance(b, 0.6f);
    int axles = dmg_int(b, 1, 2);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.4f * half - 0.05f * half, 0.8f * deck, 0),
                     v3((float)s * 0.4f * half + 0.05f * half, 0.95f * deck, length));
    for (int i = 0; i < axles; ++i)
        dmg_axle_draw(b, &t, 0, beside ? half + 0.7f * t.width : half - 0.5f * t.width,
                      0.45f * length + 2.2f * wheel * ((float)i - 0.5f * (float)(axles - 1)));
    float y = 0.87f * deck, r = 0.05f * half;
    uint32_t drawbar = dmg_chance(b, 0.4f) ? dmg_hinge_across(b, 0, "drawbar", v3(0, y, length), -0.2f, 1.4f) : 0;
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * 0.4f * half, y, length), v3(0, y, length + 0.7f * bar), 1.5f * r, 2 * r);
    dmg_beam(b, v3(0, y, length + 0.5f * bar), v3(0, y, length + bar), 2 * r, 2 * r);
    dmg_torus(b, v3(0, y, length + bar + 1.5f * r), v3(0, 1, 0), 2 * r, 0.7f * r);
    int leg = dmg_int(b, 0, 2); /* none, a wheel on a leg that slides, a leg that folds up */
    dmg_vec hold = {2.6f * r, y, length + 0.6f * bar};
    if (leg == 1) {
        dmg_box(b, hold, v3(3 * r, 3 * r, 3 * r));
        uint32_t post = dmg_slide(b, drawbar, "jockey", v3(0, 1, 0), -0.1f * deck, 0.6f * deck);
        dmg_rod(b, v3(hold.x, 0.35f * deck, hold.z), v3(hold.x, 1.5f * deck, hold.z), 0.9f * r);
        dmg_spin(b, post, "jockey_wheel", v3(hold.x, 0.18f * deck, hold.z), v3(1, 0, 0));
        dmg_rod(b, v3(hold.x - r, 0.18f * deck, hold.z), v3(hold.x + r, 0.18f * deck, hold.z), 0.18f * deck);
        dmg_use(b, post);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3(hold.x + (float)s * 1.4f * r, 0.14f * deck, hold.z),
                     v3(hold.x + (float)s * 1.4f * r, 0.4f * deck, hold.z), 0.5f * r, r);
        dmg_box(b, v3(hold.x, 0.4f * deck, hold.z), v3(3.4f * r, r, 1.4f * r));
        dmg_spin(b, post, "crank", v3(hold.x, 1.5f * deck, hold.z), v3(0, 1, 0));
        dmg_rod(b, v3(hold.x, 1.5f * deck + 0.4f * r, hold.z), v3(hold.x, 1.5f * deck + 0.4f * r, hold.z - 4 * r),
                0.4f * r);
        dmg_rod(b, v3(hold.x, 1.5f * deck, hold.z - 4 * r), v3(hold.x, 1.5f * deck + 2.5f * r, hold.z - 4 * r),
                0.4f * r);
    }
    if (leg == 2) {
        dmg_hinge_across(b, drawbar, "leg", hold, -1.5f, 0.0f);
        dmg_box_span(b, v3(hold.x - 0.8f * r, 0.05f * deck, hold.z - r), v3(hold.x + 0.8f * r, y, hold.z + r));
        dmg_box(b, v3(hold.x, 0.04f * deck, hold.z), v3(4 * r, 0.08f * deck, 4 * r));
    }
    dmg_use(b, 0);
    bed d = pick_bed(b, beside ? half : half * 1.05f, 0.95f * length);
    if (d.kind == 2) d.kind = 1;
    dmg_move(b, 0, deck + 2 * d.t, 0);
    draw_bed(b, &d);
}

/* ---- a skip before the driver, that tips forward, on a turntable or not; the two halves of the machine bend ---- */

static void build_site_dumper(dmg_builder* b, float size) {
    float half = size * dmg_range(b, 0.4f, 0.55f), wheel = size * dmg_range(b, 0.22f, 0.32f), deck = 2 * wheel,
          t = 0.05f * half;
    dmg_tyre tyre = dmg_tyre_pick(b, wheel);
    dmg_box_span(b, v3(-0.7f * half, 0.7f * wheel, -1.0f * size), v3(0.7f * half, deck + 0.3f * size, -0.35f * size));
    dmg_box_span(b, v3(-0.5f * half, 0.7f * wheel, -0.35f * size), v3(0.5f * half, 1.4f * wheel, 0.0f));
    dmg_rounded_box(b, v3(0, deck + 0.1f * size, -0.2f * size), v3(half, 0.3f * size, 0.25f * size), 0.04f * size);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * 0.6f * half, deck, -0.5f * size),
                 v3((float)s * 0.6f * half, deck + 1.1f * size, -0.45f * size), 0.06f * half, 0.06f * half);
    dmg_beam(b, v3(-0.6f * half, deck + 1.1f * size, -0.45f * size), v3(0.6f * half, deck + 1.1f * size, -0.45f * size),
             0.06f * half, 0.06f * half);
    if (dmg_chance(b, 0.5f)) {
        dmg_hinge_across(b, 0, "hood", v3(0, deck + 0.3f * size, -0.35f * size), -1.0f, 0.0f);
        dmg_box_span(b, v3(-0.72f * half, deck + 0.3f * size, -1.0f * size),
                     v3(0.72f * half, deck + 0.35f * size, -0.35f * size));
        dmg_use(b, 0);
    }
    dmg_axle_draw(b, &tyre, 0, half, -0.7f * size);
    uint32_t front = dmg_chance(b, 0.6f) ? dmg_hinge(b, 0, "articulation", v3(0, wheel, 0.06f * size),
                                                     v3(0, dmg_sign(b), 0), -0.45f, 0.45f)
                                         : 0;
    dmg_rod(b, v3(0, 0.6f * wheel, 0.06f * size), v3(0, 1.5f * wheel, 0.06f * size), 0.3f * wheel);
    dmg_box_span(b, v3(-0.45f * half, 0.7f * wheel, 0.0f), v3(0.45f * half, 1.5f * wheel, 0.9f * size));
    dmg_axle_draw(b, &tyre, front, half, 0.55f * size);
    dmg_move(b, 0, 1.5f * wheel, 0.55f * size);
    if (dmg_chance(b, 0.5f)) {
        front = dmg_spin(b, front, "turntable", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.08f * size, 0), 0.4f * half);
        dmg_move(b, 0, 0.08f * size, 0);
    }
    dmg_box_span(b, v3(-0.3f * half, 0, 0.2f * size), v3(0.3f * half, 0.12f * size, 0.35f * size));
    dmg_vec pin = {0, 0.14f * size, 0.3f * size};
    uint32_t skip = dmg_hinge_across(b, front, "skip", pin, -1.2f, 0.0f);
    float y = pin.y + 0.02f * size, high = size * dmg_range(b, 0.35f, 0.55f), wide = half * dmg_range(b, 0.9f, 1.2f);
    const dmg_xy wall[] = {{-0.35f * size, y},
                           {0.35f * size, y},
                           {0.75f * size, y + 0.9f * high},
                           {0.7f * size, y + high},
                           {-0.45f * size, y + high}};
    const dmg_xy sheet[] = {wall[4], wall[0], wall[1], wall[2]};
    dmg_side_sheet(b, sheet, 4, t, 2 * wide);
    for (int s = -1; s <= 1; s += 2) dmg_side_prism(b, wall, 5, (float)s * wide, (float)s * (wide - t));
    dmg_ram_draw(b, dmg_ram_pick(b), front, skip, v3(0, 0.03f * size, -0.1f * size), v3(0, y, 0.1f * size),
                 0.06f * half);
}

void dmg_build_tipper(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.06f, 2.5f);
    int kind = dmg_weighted(b, (const float[]){5, 2, 2}, 3);
    if (kind == 0) {
        dmg_truck t = dmg_truck_pick(b, size);
        dmg_truck_draw(b, &t);
        bed d = pick_bed(b, t.half * dmg_range(b, 0.95f, 1.1f), t.length);
        d.over = fminf(d.over, 0.08f * t.length);
        dmg_move(b, 0, t.deck + 2 * d.t, 0);
        if (d.kind == 2) d.high = fmaxf(d.high, t.roof - t.deck);
        draw_bed(b, &d);
    }
    if (kind == 1) build_trailer(b, size);
    if (kind == 2) build_site_dumper(b, size);
    dmg_use(b, 0);
}
