/* Draws sofas that become beds: each seat, back and arm moves on its own. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- sofa ---- */

typedef struct sofa {
    int seats;
    float width;         /* of one seat */
    float deep, seat;    /* to the seat's top */
    float cushion, base; /* thickness; height of what is below it, above the floor */
    float back, tall;    /* thickness, height above the seat */
    float arm, arm_up;
    float soft;  /* radius of the cushions' edges, share of their thickness */
    float open;  /* chance of anything to be unfolded */
    bool slats;  /* a frame of laths in place of a box */
    bool common; /* the back in one piece */
} sofa;

static void rest_somewhere(dmg_builder* b, uint32_t part, float far, float chance) {
    if (dmg_chance(b, chance)) dmg_rest(b, part, far * (dmg_chance(b, 0.5f) ? 1.0f : dmg_range(b, 0.1f, 1.0f)));
}

static void draw_cushion(dmg_builder* b, const sofa* s, dmg_vec low, dmg_vec high) {
    dmg_vec size = v3_sub(high, low);
    float thin = fminf(size.x, fminf(size.y, size.z));
    if (s->soft > 0.05f)
        dmg_rounded_box(b, v3_lerp(low, high, 0.5f), size, s->soft * thin);
    else
        dmg_box_span(b, low, high);
}

/* Laths across a frame, w x h about the origin of z = 0, t thick. */
static void draw_laths(dmg_builder* b, float w, float h, float t) {
    int count = dmg_int(b, 4, 9);
    dmg_frame_draw(b, w, h, t, 0.06f * h);
    for (int i = 0; i < count; ++i) {
        float x = w * (((float)i + 0.5f) / (float)count - 0.5f);
        dmg_box(b, v3(x, 0, -0.5f * t), v3(0.5f * w / (float)count, 0.88f * h, 0.5f * t));
    }
}

/* Draws what carries the seats: a box or rails, on legs. It ends at the seat's rear, so that backs can lie down behind.
 */
static void draw_sofa_base(dmg_builder* b, const sofa* s, bool hollow) {
    float w = s->width * (float)s->seats, low = s->seat - s->cushion - s->base, z = 0.5f * s->deep, t = 0.025f;
    float high = s->seat - s->cushion;
    if (s->slats) {
        for (int i = -1; i <= 1; i += 2) {
            float at = (float)i * (z - t);
            dmg_box_span(b, v3(-0.5f * w, high - 3 * t, at - t), v3(0.5f * w, high, at + t));
        }
    } else if (hollow) { /* open in front and above */
        dmg_box_span(b, v3(-0.5f * w, low, -z), v3(t - 0.5f * w, high, z));
        dmg_box_span(b, v3(0.5f * w - t, low, -z), v3(0.5f * w, high, z));
        dmg_box_span(b, v3(t - 0.5f * w, low, -z), v3(0.5f * w - t, high, t - z));
    } else {
        dmg_box_span(b, v3(-0.5f * w, low, -z), v3(0.5f * w, high, z - 0.02f));
    }
    float leg = dmg_range(b, 0.015f, 0.035f);
    if (low < 0.01f && !s->slats) return;
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.5f : -0.5f) * (w - 4 * leg), y = s->slats ? high - 3 * t : low;
        dmg_rod(b, v3(x, 0, (i & 2 ? 1.0f : -1.0f) * (z - 2 * leg)), v3(x, y, (i & 2 ? 1.0f : -1.0f) * (z - 2 * leg)),
                leg);
    }
}

/* ---- seats: from x0 to x1 ---- */

/* Over a chest: the cushion is its lid. */
static void draw_chest_seat(dmg_builder* b, const sofa* s, float x0, float x1, float front) {
    float high = s->seat - s->cushion, low = fmaxf(high - s->base, 0.02f), z = -0.5f * s->deep,
          far = dmg_range(b, 0.7f, 1.4f);
    dmg_save(b);
    dmg_move(b, 0.5f * (x0 + x1), high, 0.5f * (z + front));
    dmg_face_up(b);
    dmg_case_draw(b, DMG_CASE_BOARDS, x1 - x0 - 0.004f, front - z, high - low, 0.02f);
    dmg_restore(b);
    /* By its rear edge, near its upper side: what is below that swings forward, away from the back. */
    float up = high + dmg_range(b, 0.55f, 1.0f) * s->cushion;
    uint32_t lid = dmg_hinge(b, 0, "seat_lid", v3(0.5f * (x0 + x1), up, z), v3(-1, 0, 0), 0.0f, far);
    if (dmg_chance(b, 0.5f)) dmg_box_span(b, v3(x0 + 0.01f, high, z), v3(x1 - 0.01f, high + 0.15f * s->cushion, front));
    draw_cushion(b, s, v3(x0, high + 0.1f * s->cushion, z), v3(x1, s->seat, front));
    rest_somewhere(b, lid, far, s->open);
    dmg_use(b, 0);
}

/* Draws two layers: the upper one turns over the front edge and lies before the lower one, on a leg that folds out. */
static void draw_turn_over_seat(dmg_builder* b, const sofa* s, float x0, float x1) {
    float z = 0.5f * s->deep, middle = s->seat - 0.5f * s->cushion, half = 0.5f * s->cushion,
          far = dmg_range(b, 2.9f, 3.14f);
    draw_cushion(b, s, v3(x0, middle - half, -z), v3(x1, middle, z));
    uint32_t flap = dmg_hinge(b, 0, "seat_flap", v3(0, middle, z), v3(1, 0, 0), 0.0f, far);
    draw_cushion(b, s, v3(x0, middle, -z), v3(x1, s->seat, z));
    if (dmg_chance(b, 0.4f)) {
        float x = 0.5f * (x0 + x1), w = 0.4f * (x1 - x0), r = 0.012f, length = fminf(0.9f * middle, 0.7f * s->deep);
        uint32_t leg = dmg_hinge(b, flap, "leg", v3(x, s->seat + r, 0.2f * s->deep - z), v3(-1, 0, 0), 0.0f, 1.57f);
        const dmg_vec loop[] = {{x - w, s->seat + r, 0.2f * s->deep - z},
                                {x - w, s->seat + r, 0.2f * s->deep - z + length},
                                {x + w, s->seat + r, 0.2f * s->deep - z + length},
                                {x + w, s->seat + r, 0.2f * s->deep - z}};
        dmg_sweep(b, loop, 4, r, r, false);
        rest_somewhere(b, leg, 1.57f, s->open);
    }
    rest_somewhere(b, flap, far, s->open);
    dmg_use(b, 0);
}

static uint32_t draw_sliding_seat(dmg_builder* b, const sofa* s, float x0, float x1) {
    float z = 0.5f * s->deep, far = dmg_range(b, 0.15f, 0.8f) * s->deep;
    uint32_t part = dmg_slide(b, 0, "seat", v3(0, 0, 1), 0.0f, far);
    draw_cushion(b, s, v3(x0, s->seat - s->cushion, -z), v3(x1, s->seat, z));
    if (s->slats) {
        dmg_save(b);
        dmg_move(b, 0.5f * (x0 + x1), s->seat - s->cushion + 0.001f, 0);
        dmg_face_up(b);
        draw_laths(b, x1 - x0, s->deep, 0.02f);
        dmg_restore(b);
    }
    rest_somewhere(b, part, far, s->open);
    return part;
}

/* ---- backs ---- */

/* It lies down behind the seat about its lower edge. */
static void draw_falling_back(dmg_builder* b, const sofa* s, uint32_t carrier, float x0, float x1) {
    float z = -0.5f * s->deep, up = s->seat - s->cushion * dmg_range(b, 0.0f, 0.9f),
          off = s->back * dmg_range(b, 0.0f, 1.0f), far = dmg_range(b, 0.6f, 1.5f), low = fminf(up + 0.01f, s->seat),
          top = s->seat + s->tall;
    if (dmg_chance(b, 0.4f)) off = 0.0f;
    uint32_t part = dmg_hinge(b, carrier, "back", v3(0.5f * (x0 + x1), up, z - off), v3(-1, 0, 0), 0.0f, far);
    if (s->slats) {
        dmg_save(b);
        dmg_move(b, 0.5f * (x0 + x1), 0.5f * (low + top), z - 0.7f * s->back);
        draw_laths(b, x1 - x0, top - low, 0.3f * s->back);
        dmg_restore(b);
    }
    draw_cushion(b, s, v3(x0, low, s->slats ? z - 0.7f * s->back : z - s->back), v3(x1, top, z));
    if (dmg_chance(b, 0.3f)) /* its pins */
        dmg_rod(b, v3(x0 - 0.01f, up, z - off), v3(x1 + 0.01f, up, z - off), 0.012f);
    rest_somewhere(b, part, far, s->open);
    if (!dmg_chance(b, 0.3f)) {
        dmg_use(b, 0);
        return;
    }
    float w = (x1 - x0) * dmg_range(b, 0.4f, 0.95f), high = dmg_range(b, 0.12f, 0.2f), x = 0.5f * (x0 + x1),
          thin = 0.6f * s->back;
    bool tilts = dmg_chance(b, 0.6f);
    if (tilts)
        dmg_hinge(b, part, "head_rest", v3(x, top, z - 0.2f * s->back - 0.5f * thin), v3(1, 0, 0), -0.2f,
                  dmg_range(b, 0.4f, 1.0f));
    else
        dmg_slide(b, part, "head_rest", v3(0, 1, 0), 0.0f, dmg_range(b, 0.05f, 0.15f));
    for (int i = -1; i <= 1 && !tilts; i += 2)
        dmg_rod(b, v3(x + 0.3f * (float)i * w, top - 0.15f, z - 0.5f * s->back),
                v3(x + 0.3f * (float)i * w, top + 0.05f, z - 0.5f * s->back), 0.008f);
    draw_cushion(b, s, v3(x - 0.5f * w, top + 0.01f, z - 0.2f * s->back - thin),
                 v3(x + 0.5f * w, top + high, z - 0.2f * s->back));
    dmg_use(b, 0);
}

/* Its middle comes forward onto the seat and is a table, with cups let in. */
static void draw_table_back(dmg_builder* b, const sofa* s, float x0, float x1) {
    float z = -0.5f * s->deep, t = 0.35f * s->back, high = fminf(s->tall, 0.9f * s->deep), x = 0.5f * (x0 + x1),
          far = dmg_range(b, 1.35f, 1.56f);
    dmg_box_span(b, v3(x0, s->seat - s->cushion, z - s->back), v3(x1, s->seat + s->tall, z - t - 0.005f));
    uint32_t part = dmg_hinge(b, 0, "table", v3(x, s->seat + 0.01f, z), v3(1, 0, 0), 0.0f, far);
    dmg_box_span(b, v3(x0 + 0.005f, s->seat + 0.01f, z - t), v3(x1 - 0.005f, s->seat + high, z));
    for (int i = -1; i <= 1; i += 2) {
        dmg_vec at = v3(x + 0.25f * (float)i * (x1 - x0), s->seat + 0.7f * high, z - t);
        dmg_torus(b, at, v3(0, 0, 1), 0.035f, 0.004f);
    }
    rest_somewhere(b, part, far, s->open);
    dmg_use(b, 0);
}

/* ---- arms: `side` is -1 or 1, the seat ends at x ---- */

static void draw_arm(dmg_builder* b, const sofa* s, float side, int kind) {
    float x = 0.5f * s->width * (float)s->seats, z = 0.5f * s->deep, top = s->seat + s->arm_up,
          far = dmg_range(b, 0.8f, 1.57f);
    dmg_save(b);
    if (side < 0) dmg_mirror(b, v3(1, 0, 0));
    dmg_move(b, x, 0, 0);
    uint32_t part = 0;
    if (kind == 1) { /* falls outwards, level with the seat */
        part =
            dmg_hinge(b, 0, "arm", v3(0, s->seat - dmg_range(b, 0.0f, 0.4f) * s->cushion, 0), v3(0, 0, -1), 0.0f, far);
        draw_cushion(b, s, v3(0.002f, s->seat, -z), v3(s->arm, top, z));
    } else if (kind == 2) { /* a chest with a lid hung on its outer edge, or behind */
        bool behind = dmg_chance(b, 0.4f);
        float lid = dmg_range(b, 0.02f, 0.05f);
        dmg_save(b);
        dmg_move(b, 0.5f * s->arm, top, 0);
        dmg_face_up(b);
        dmg_case_draw(b, DMG_CASE_BOARDS, s->arm, 2 * z, top, 0.015f);
        dmg_restore(b);
        if (behind)
            part = dmg_hinge(b, 0, "arm_lid", v3(0.5f * s->arm, top, -z), v3(-1, 0, 0), 0.0f, far);
        else
            part = dmg_hinge(b, 0, "arm_lid", v3(s->arm, top, 0), v3(0, 0, -1), 0.0f, far);
        dmg_box_span(b, v3(0, top + 0.001f, -z), v3(s->arm, top + lid, z));
    } else { /* stands there; a tray may slide or turn on it */
        draw_cushion(b, s, v3(0.002f, 0.02f, -z - s->back), v3(s->arm, top, z));
        float t = 0.015f, at = dmg_range(b, 0.0f, 0.5f) * z;
        if (kind == 3) {
            part = dmg_slide(b, 0, "tray", v3(0, 0, -1), 0.0f, far = at + 0.5f * z);
            const dmg_xy hook[] = {
                {-0.01f, top - 0.08f}, {-0.01f, top + t}, {s->arm + 0.012f, top + t}, {s->arm + 0.012f, top - 0.12f}};
            dmg_move(b, 0, 0, at);
            dmg_bent_plate(b, hook, 4, t, 0.5f * z);
        }
        if (kind == 4) {
            part = dmg_hinge(b, 0, "tray", v3(0.5f * s->arm, top, 0.8f * z), v3(0, 1, 0), 0.0f, far);
            dmg_rod(b, v3(0.5f * s->arm, top - 0.02f, 0.8f * z), v3(0.5f * s->arm, top + 0.03f, 0.8f * z), 0.02f);
            dmg_box_span(b, v3(0.02f, top + 0.03f, -0.1f * z), v3(s->arm + 0.05f, top + 0.03f + t, 0.9f * z));
        }
    }
    dmg_restore(b);
    if (part) rest_somewhere(b, part, far, s->open);
    dmg_use(b, 0);
}

/* ---- what comes out below the seat: its front is the base's ---- */

static void draw_trundle(dmg_builder* b, const sofa* s, float x0, float x1) {
    float high = s->seat - s->cushion - 0.02f, low = 0.03f, z = 0.5f * s->deep, t = 0.025f,
          far = dmg_range(b, 0.6f, 0.95f) * s->deep, r = 0.025f;
    bool bed = dmg_chance(b, 0.6f);
    uint32_t part = dmg_slide(b, 0, bed ? "bed" : "drawer", v3(0, 0, 1), 0.0f, far);
    dmg_box_span(b, v3(x0, low, z + 0.001f), v3(x1, high, z + t));
    dmg_save(b);
    dmg_move(b, 0.5f * (x0 + x1), 0.06f, z);
    dmg_tray_draw(b, DMG_TRAY_BOARDS, x1 - x0 - 0.07f, (high - low) * dmg_range(b, 0.25f, 0.6f), s->deep - 0.06f,
                  0.015f);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) {
        dmg_handle grip = dmg_handle_pick(b, 0.12f);
        dmg_save(b);
        dmg_move(b, 0.5f * (x0 + x1), 0.6f * high, z + t);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_handle_draw(b, &grip, 0.5f * (x1 - x0));
        dmg_restore(b);
    }
    bool wheels = dmg_chance(b, 0.4f);
    rest_somewhere(b, part, far, fmaxf(s->open, 0.3f));
    for (int i = -1; i <= 1 && wheels; i += 2) {
        float x = 0.5f * (x0 + x1) + 0.4f * (float)i * (x1 - x0);
        dmg_use(b, part);
        dmg_box(b, v3(x, 0.055f, 0.7f * z), v3(0.01f, 0.03f, 0.03f));
        dmg_spin(b, part, "wheel", v3(x, r, 0.7f * z), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.01f, r, 0.7f * z), v3(x + 0.01f, r, 0.7f * z), r);
    }
    if (bed) { /* a mattress that lifts to the seat's level, or is just there */
        if (dmg_chance(b, 0.3f))
            dmg_slide(b, part, "mattress", v3(0, 1, 0), 0.0f, 0.5f * high);
        else
            dmg_use(b, part);
        draw_cushion(b, s, v3(x0 + 0.06f, 0.085f, 0.06f - z), v3(x1 - 0.06f, 0.85f * high, z - 0.02f));
    }
    dmg_use(b, 0);
}

static sofa pick_sofa(dmg_builder* b) {
    sofa s = {.seats = dmg_int(b, 1, 4)};
    s.width = dmg_range(b, 0.55f, 0.85f);
    s.deep = dmg_range(b, 0.5f, 0.8f);
    s.seat = dmg_range(b, 0.36f, 0.48f);
    s.cushion = dmg_range(b, 0.1f, 0.2f);
    s.base = s.seat - s.cushion - (dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.04f, 0.14f));
    s.back = dmg_range(b, 0.06f, 0.2f);
    s.tall = dmg_range(b, 0.3f, 0.6f);
    s.arm = dmg_range(b, 0.08f, 0.25f);
    s.arm_up = dmg_range(b, 0.1f, 0.25f);
    s.soft = dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, 0.1f, 0.35f);
    s.open = dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, 0.15f, 0.7f);
    s.slats = dmg_chance(b, 0.25f);
    s.common = dmg_chance(b, 0.4f);
    return s;
}

/* Draws the seats, which all have one way of moving, or each its own, and what is behind them. */
static void draw_seats_and_backs(dmg_builder* b, const sofa* s, bool trundle) {
    bool alike = dmg_chance(b, 0.5f);
    int seat = dmg_int(b, 0, 4), back = dmg_int(b, 0, 3);
    float w = s->width, x = -0.5f * w * (float)s->seats, z = 0.5f * s->deep;
    for (int i = 0; i < s->seats; ++i) {
        bool all = s->common && alike; /* in one piece from end to end */
        float x0 = x + (float)i * w + 0.003f, x1 = all ? -x - 0.003f : x0 + w - 0.006f;
        if (!alike) seat = dmg_int(b, 0, 4);
        if (!alike || back == 3) back = dmg_int(b, 0, 3);
        if (trundle && seat == 1) seat = 0;
        if (i + 1 == s->seats && b->part_count == 0 && seat % 4 == 0) back = 0;
        uint32_t carrier = 0;
        if (seat == 0 || seat == 4) draw_cushion(b, s, v3(x0, s->seat - s->cushion, -z), v3(x1, s->seat, z));
        if (seat == 1) draw_chest_seat(b, s, x0, x1, z * (i + 1 == s->seats && dmg_chance(b, 0.5f) ? 2.2f : 1.0f));
        if (seat == 2) draw_turn_over_seat(b, s, x0, x1);
        if (seat == 3) carrier = draw_sliding_seat(b, s, x0, x1);
        if (!dmg_chance(b, 0.6f)) carrier = 0;
        dmg_use(b, 0);
        if (back < 2 || all)
            draw_falling_back(b, s, carrier, x0, x1);
        else if (back == 2 && s->seats > 1)
            draw_table_back(b, s, x0, x1);
        else
            draw_cushion(b, s, v3(x0, s->seat - s->cushion, -z - s->back), v3(x1, s->seat + s->tall, -z));
        if (all) break;
    }
}

void dmg_build_sofa_bed(dmg_builder* b) {
    sofa s = pick_sofa(b);
    float w = 0.5f * s.width * (float)s.seats;
    bool trundle = !s.slats && dmg_chance(b, 0.35f), twins = dmg_chance(b, 0.3f) && s.seats > 1;
    int arms = dmg_int(b, 0, 4), other = dmg_chance(b, 0.7f) ? arms : dmg_int(b, 0, 4);
    if (trundle) s.base = s.seat - s.cushion;
    draw_sofa_base(b, &s, trundle || dmg_chance(b, 0.5f));
    draw_seats_and_backs(b, &s, trundle);
    if (trundle && twins) {
        draw_trundle(b, &s, -w + 0.03f, -0.004f);
        draw_trundle(b, &s, 0.004f, w - 0.03f);
    } else if (trundle) {
        draw_trundle(b, &s, -w + 0.03f, w - 0.03f);
    }
    if (dmg_chance(b, 0.85f)) draw_arm(b, &s, -1.0f, arms);
    if (dmg_chance(b, 0.85f)) draw_arm(b, &s, 1.0f, other);
}
