/* Draws seats of cars, buses and aircraft: on rails, blocks or a post; backs that recline, head rests on two rods,
 * arm rests that swing up, trays on the back of them, cushions that tip up. They look to -Z. */
#include "vehicles/vehicle_seats.h"

#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

dmg_seat dmg_seat_pick(dmg_builder* b) {
    dmg_seat s = {
        .shell = dmg_int(b, 0, 3), .base = dmg_int(b, 0, 3), .head = dmg_int(b, 0, 2), .arms = dmg_int(b, 0, 2)};
    s.wide = dmg_range(b, 0.38f, 0.54f);
    s.deep = dmg_range(b, 0.4f, 0.54f);
    s.seat = dmg_range(b, 0.26f, 0.46f);
    s.tall = dmg_range(b, 0.5f, 0.72f);
    s.thick = dmg_range(b, 0.05f, 0.12f);
    s.reclines = dmg_chance(b, 0.8f);
    s.tray = dmg_chance(b, 0.35f);
    s.tips = dmg_chance(b, 0.2f);
    s.lever = dmg_chance(b, 0.5f);
    return s;
}

/* Draws what carries it; returns the part that the cushion is on. */
static uint32_t draw_base(dmg_builder* b, const dmg_seat* s) {
    float x = 0.4f * s->wide, under = s->seat - s->thick, front = -s->deep, rail = 0.03f;
    uint32_t carrier = 0;
    if (s->base == 0) {
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3((float)k * x - 0.02f, 0, front - 0.12f), v3((float)k * x + 0.02f, rail, 0.12f));
        carrier = dmg_slide(b, 0, "seat", v3(0, 0, dmg_sign(b)), -0.1f, 0.1f);
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3((float)k * x - 0.014f, rail, front + 0.08f), v3((float)k * x + 0.014f, under, -0.04f));
        if (dmg_chance(b, 0.5f)) { /* the bow under its front edge that frees it */
            dmg_vec pin = {0, 0.3f * under + rail, front + 0.12f};
            dmg_hinge(b, carrier, "slide_bar", pin, v3(-1, 0, 0), -0.05f, 0.25f);
            const dmg_vec bow[] = {{-0.9f * x, pin.y, pin.z},
                                   {-0.9f * x, pin.y, front - 0.04f},
                                   {0.9f * x, pin.y, front - 0.04f},
                                   {0.9f * x, pin.y, pin.z}};
            dmg_sweep(b, bow, 4, 0.007f, 0.007f, false);
            dmg_use(b, carrier);
        }
    }
    if (s->base == 1) dmg_box_span(b, v3(-1.05f * x, 0, 0.9f * front), v3(1.05f * x, under, -0.05f));
    if (s->base == 2) {
        dmg_cone(b, v3(0, 0, 0.5f * front), v3(0, 0.04f, 0.5f * front), 0.16f, 0.06f);
        dmg_rod(b, v3(0, 0.03f, 0.5f * front), v3(0, 0.6f * under, 0.5f * front), 0.045f);
        if (dmg_chance(b, 0.6f))
            carrier = dmg_hinge(b, 0, "swivel", v3(0, 0, 0.5f * front), v3(0, dmg_sign(b), 0), -1.6f, 1.6f);
        dmg_rod(b, v3(0, 0.6f * under, 0.5f * front), v3(0, under, 0.5f * front), 0.03f);
        dmg_box(b, v3(0, under - 0.012f, 0.5f * front), v3(0.5f * s->wide, 0.024f, 0.5f * s->deep));
    }
    if (s->base == 3)
        for (int i = 0; i < 4; ++i) {
            float px = i & 1 ? x : -x;
            dmg_beam(b, v3(px, 0, i & 2 ? -0.02f : 0.9f * front), v3(px, under, i & 2 ? -0.1f : 0.8f * front), 0.03f,
                     0.03f);
        }
    return carrier;
}

static void draw_cushion(dmg_builder* b, const dmg_seat* s, uint32_t carrier) {
    float y = s->seat - 0.5f * s->thick, z = -0.5f * s->deep, soft = s->shell == 0 ? 0.3f : 0.1f;
    dmg_use(b, carrier);
    if (s->tips) { /* up against the back */
        for (int k = -1; k <= 1; k += 2)
            dmg_box(b, v3((float)k * 0.51f * s->wide, y, -0.04f), v3(0.012f, s->thick, 0.08f));
        dmg_hinge(b, carrier, "cushion", v3(0, y, -0.05f), v3(1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.3f));
        z -= 0.012f;
    }
    dmg_rounded_box(b, v3(0, y, z), v3(s->wide, s->thick, s->deep - (s->tips ? 0.06f : 0.0f)), soft * s->thick);
    if (s->shell == 2)
        for (int k = -1; k <= 1; k += 2)
            dmg_rounded_box(b, v3((float)k * 0.46f * s->wide, y + 0.4f * s->thick, z),
                            v3(0.12f * s->wide, s->thick, 0.8f * s->deep), 0.2f * s->thick);
    dmg_use(b, carrier);
}

/* Upright from the hinge at (0, seat, 0), on the part in use. */
static void draw_back(dmg_builder* b, const dmg_seat* s) {
    float y = s->seat + 0.02f, t = s->thick, mid = y + 0.5f * s->tall;
    if (s->shell == 0) dmg_rounded_box(b, v3(0, mid, 0.5f * t), v3(s->wide, s->tall, t), 0.3f * t);
    if (s->shell == 1) {
        const dmg_xy line[] = {
            {0.3f * t, y}, {0.6f * t, y + 0.25f * s->tall}, {0.4f * t, y + 0.7f * s->tall}, {0.9f * t, y + s->tall}};
        dmg_side_sheet(b, line, 4, 0.3f * t, s->wide);
        dmg_rounded_box(b, v3(0, mid, 0.25f * t), v3(0.85f * s->wide, 0.85f * s->tall, 0.4f * t), 0.1f * t);
    }
    if (s->shell == 2) {
        dmg_xy outline[] = {{-0.35f, 0}, {0.35f, 0},  {0.5f, 0.35f},  {0.46f, 0.7f},
                            {0.25f, 1},  {-0.25f, 1}, {-0.46f, 0.7f}, {-0.5f, 0.35f}};
        for (int i = 0; i < 8; ++i) outline[i] = (dmg_xy){outline[i].x * s->wide, y + outline[i].y * s->tall};
        dmg_extrude(b, outline, 8, 0, 0.7f * t);
        for (int k = -1; k <= 1; k += 2)
            dmg_rounded_box(b, v3((float)k * 0.43f * s->wide, y + 0.4f * s->tall, -0.1f * t),
                            v3(0.12f * s->wide, 0.5f * s->tall, 0.8f * t), 0.2f * t);
    }
    if (s->shell == 3) {
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3((float)k * 0.46f * s->wide, s->seat, 0.3f * t),
                    v3((float)k * 0.46f * s->wide, y + s->tall, 0.6f * t), 0.014f);
        for (int i = 0; i < 4; ++i)
            dmg_box(b, v3(0, y + s->tall * (0.2f + 0.25f * (float)i), 0.45f * t),
                    v3(s->wide, 0.14f * s->tall, 0.3f * t));
    }
}

static void draw_head_rest(dmg_builder* b, const dmg_seat* s, uint32_t back) {
    float y = s->seat + 0.02f + s->tall, z = 0.45f * s->thick, t = fmaxf(0.05f, 0.7f * s->thick),
          up = dmg_range(b, 0.02f, 0.06f);
    float wide = s->wide * dmg_range(b, 0.45f, 0.65f), high = dmg_range(b, 0.12f, 0.19f);
    dmg_use(b, back);
    uint32_t rest = back;
    if (s->head == 2) rest = dmg_slide(b, back, "head_rest", v3(0, 1, 0), 0.0f, dmg_range(b, 0.05f, 0.1f));
    for (int k = -1; k <= 1; k += 2)
        dmg_rod(b, v3((float)k * 0.25f * wide, y - 0.13f, z), v3((float)k * 0.25f * wide, y + up + 0.03f, z), 0.006f);
    if (dmg_chance(b, 0.3f)) dmg_hinge(b, rest, "head_pad", v3(0, y + up + 0.02f, z), v3(-1, 0, 0), -0.3f, 0.4f);
    dmg_rounded_box(b, v3(0, y + up + 0.5f * high, z), v3(wide, high, t), 0.3f * t);
    dmg_use(b, back);
}

/* Hung on the sides of the back: they swing up beside it; or on the base, still. */
static void draw_arm_rests(dmg_builder* b, const dmg_seat* s, uint32_t base, uint32_t back) {
    float y = s->seat + dmg_range(b, 0.16f, 0.24f), t = 0.05f, long_ = 0.75f * s->deep;
    for (int k = -1; k <= 1; k += 2) {
        float x = (float)k * (0.5f * s->wide + 0.035f);
        if (s->arms == 1) {
            dmg_use(b, base);
            dmg_box_span(b, v3(x - 0.02f, s->seat - s->thick, -0.3f * s->deep), v3(x + 0.02f, y, -0.1f * s->deep));
            dmg_box_span(b, v3(fminf(x, 0.8f * x), s->seat - 0.8f * s->thick, -0.3f * s->deep),
                         v3(fmaxf(x, 0.8f * x), s->seat - 0.4f * s->thick, -0.1f * s->deep));
        } else {
            dmg_use(b, back);
            dmg_rod(b, v3(0.8f * x, y, 0.5f * s->thick), v3(x - (float)k * 0.028f, y, 0.5f * s->thick), 0.018f);
            dmg_hinge(b, back, "arm_rest", v3(x, y, 0.5f * s->thick), v3(1, 0, 0), 0.0f, dmg_range(b, 1.2f, 1.65f));
        }
        dmg_rounded_box(b, v3(x, y, 0.5f * s->thick + 0.02f - 0.5f * long_), v3(t, 0.045f, long_), 0.012f);
    }
    dmg_use(b, back);
}

/* On the back's rear: a table on two arms, hinged below, or a plate hinged itself; a net's flap under it. */
static void draw_tray(dmg_builder* b, const dmg_seat* s, uint32_t back) {
    float z = s->thick + 0.004f, y = s->seat + 0.45f * s->tall, wide = 0.4f * s->wide,
          high = dmg_range(b, 0.18f, 0.26f);
    bool arms = dmg_chance(b, 0.6f);
    dmg_use(b, back);
    dmg_box_span(b, v3(-wide, y - 0.03f, 0.3f * s->thick), v3(wide, y - 0.012f, z));
    uint32_t tray = dmg_hinge(b, back, "tray", v3(0, y, z + 0.008f), v3(1, 0, 0), 0.0f, dmg_range(b, 1.4f, 1.6f));
    if (arms) {
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3((float)k * wide - 0.008f, y, z), v3((float)k * wide + 0.008f, y + high, z + 0.015f));
        dmg_slide(b, tray, "table", v3(0, 1, 0), 0.0f, dmg_range(b, 0.05f, 0.1f));
        dmg_box_span(b, v3(-wide + 0.012f, y + 0.05f, z), v3(wide - 0.012f, y + high + 0.02f, z + 0.016f));
    } else {
        dmg_box_span(b, v3(-wide, y, z), v3(wide, y + high, z + 0.016f));
    }
    dmg_use(b, back);
    if (dmg_chance(b, 0.6f)) {
        dmg_hinge(b, back, "tray_catch", v3(0, y + high + 0.035f, z), v3(0, 0, 1), -1.57f, 0.0f);
        dmg_box(b, v3(0, y + high + 0.025f, z + 0.024f), v3(0.014f, 0.05f, 0.006f));
        dmg_rod(b, v3(0, y + high + 0.035f, z - 0.012f), v3(0, y + high + 0.035f, z + 0.024f), 0.006f);
        dmg_use(b, back);
    }
}

/* At the side of the hinge: a lever, or a wheel that is turned. */
static void draw_recliner(dmg_builder* b, const dmg_seat* s, uint32_t base) {
    float x = 0.5f * s->wide + 0.005f;
    dmg_vec pin = {x, s->seat - 0.5f * s->thick, -0.04f};
    dmg_use(b, base);
    dmg_box(b, v3(0.98f * x, pin.y, pin.z), v3(0.03f, 0.08f, 0.08f));
    if (dmg_chance(b, 0.4f)) {
        dmg_spin(b, base, "recline_wheel", pin, v3(1, 0, 0));
        dmg_rod(b, v3_add(pin, v3(0.005f, 0, 0)), v3_add(pin, v3(0.03f, 0, 0)), 0.045f);
    } else {
        dmg_hinge(b, base, "recline_lever", pin, v3(1, 0, 0), 0.0f, dmg_range(b, 0.3f, 0.7f));
        dmg_rod(b, pin, v3_add(pin, v3(0.024f, 0, 0)), 0.018f);
        dmg_beam(b, v3_add(pin, v3(0.018f, 0, 0)), v3_add(pin, v3(0.018f, 0.01f, -0.15f)), 0.014f, 0.022f);
    }
    dmg_use(b, base);
}

void dmg_seat_draw(dmg_builder* b, const dmg_seat* s, float x, float z) {
    dmg_save(b);
    dmg_move(b, x, 0, z);
    uint32_t base = draw_base(b, s), back = base;
    draw_cushion(b, s, base);
    if (s->lever) draw_recliner(b, s, base);
    if (s->reclines) {
        dmg_use(b, base);
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3((float)k * 0.505f * s->wide - 0.005f, s->seat - s->thick, -0.03f),
                         v3((float)k * 0.505f * s->wide + 0.005f, s->seat + 0.05f, 0.05f));
        const float upper = dmg_range(b, 0.2f, 0.9f), lower = -dmg_range(b, 0.1f, 1.2f);
        back = dmg_hinge(b, base, "back", v3(0, s->seat, 0.5f * s->thick), v3(1, 0, 0), lower, upper);
    }
    draw_back(b, s);
    if (s->head) draw_head_rest(b, s, back);
    if (s->arms) draw_arm_rests(b, s, base, back);
    if (s->tray) draw_tray(b, s, back);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* One, or a row on one floor, or two rows, the rear one's back folding down in two. */
void dmg_build_car_seat(dmg_builder* b) {
    dmg_grow(b, dmg_chance(b, 0.8f) ? 1.0f : dmg_scale_range(b, 0.1f, 0.6f));
    dmg_seat s = dmg_seat_pick(b);
    int count = dmg_weighted(b, (const float[]){4, 3, 2}, 3) + 1, rows = dmg_chance(b, 0.2f) ? 2 : 1;
    float pitch = s.wide + (s.arms ? 0.13f : dmg_range(b, 0.02f, 0.2f)), apart = dmg_range(b, 0.75f, 1.0f);
    if (count > 1 && dmg_chance(b, 0.7f)) s.base = s.base == 2 ? 3 : s.base;
    bool floor = count * rows > 1 || dmg_chance(b, 0.4f);
    if (floor)
        dmg_box_span(b, v3(-0.5f * pitch * (float)count, -0.03f, -s.deep - 0.2f),
                     v3(0.5f * pitch * (float)count, 0, 0.3f + apart * (float)(rows - 1)));
    for (int r = 0; r < rows; ++r)
        for (int i = 0; i < count; ++i)
            dmg_seat_draw(b, &s, pitch * ((float)i - 0.5f * (float)(count - 1)), apart * (float)r);
}
