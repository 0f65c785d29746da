/* Draws sewing machines: bed, pillar, arm and head, the wheel at the right, and the small parts that move on it. */
#include "core/build.h"
#include "parts/hardware.h"

/* Lengths in metres; the needle is at the left, the handwheel at the right. */
typedef struct sewer {
    float length, deep, high; /* over all, of the bed, of the arm's top */
    float bed;                /* height of its top */
    float arm, head, pillar;  /* height of the arm, widths of the head and of the pillar */
    float thick;              /* depth of the arm */
    float needle;             /* x */
    float chin;               /* height of the head's underside */
    int frame;                /* boxes, rounded boxes, one slab cut out, a curved casting */
    bool free_arm;
    uint32_t body; /* the base, or the whole machine where it tilts on one */
} sewer;

static sewer pick_sewer(dmg_builder* b) {
    sewer m = {.length = dmg_scale_range(b, 0.2f, 0.55f)};
    m.deep = m.length * dmg_range(b, 0.35f, 0.5f);
    m.high = m.length * dmg_range(b, 0.6f, 0.8f);
    m.bed = m.length * dmg_range(b, 0.08f, 0.22f);
    m.arm = m.length * dmg_range(b, 0.14f, 0.28f);
    m.head = m.length * dmg_range(b, 0.16f, 0.26f);
    m.pillar = m.length * dmg_range(b, 0.18f, 0.38f);
    m.thick = m.deep * dmg_range(b, 0.45f, 0.9f);
    m.needle = -0.5f * m.length + 0.5f * m.head;
    m.frame = dmg_int(b, 0, 3);
    m.free_arm = m.frame != 3 && dmg_chance(b, 0.4f);
    if (m.frame == 3) m.thick = m.deep * dmg_range(b, 0.3f, 0.45f);
    float gap = m.high - m.arm - m.bed;
    m.chin = m.bed + fmaxf(0.35f * gap, m.length * 0.1f);
    return m;
}

/* ---- what stands still ---- */

static void draw_bed(dmg_builder* b, const sewer* m) {
    float x0 = -0.5f * m->length, x1 = 0.5f * m->length, inner = x1 - m->pillar;
    float r = m->frame == 1 ? 0.25f * m->bed : 0.05f * m->bed;
    if (!m->free_arm) {
        dmg_rounded_box(b, v3(0, 0.5f * m->bed, 0), v3(m->length, m->bed, m->deep), r);
        return;
    }
    dmg_rounded_box(b, v3(0.5f * (inner + x1), 0.5f * m->bed, 0), v3(m->pillar, m->bed, m->deep), r);
    dmg_box_span(b, v3(x0, 0.3f * m->bed, -0.2f * m->deep), v3(inner, m->bed, 0.12f * m->deep));
    dmg_box_span(b, v3(x0 + 0.3f * m->length, 0, -0.5f * m->deep), v3(inner, 0.3f * m->bed, -0.2f * m->deep));
}

static void draw_casting(dmg_builder* b, const sewer* m) {
    enum { POINTS = 9 };
    float x = 0.5f * (m->length - m->pillar), y = m->high - 0.5f * m->arm, bend = 0.6f * m->pillar;
    dmg_vec path[POINTS] = {{x, 0.8f * m->bed, 0}, {x, 0.5f * (m->bed + y), 0}};
    for (int i = 0; i < 5; ++i) {
        float angle = 0.5f * DMG_PI * (float)i / 4.0f;
        path[2 + i] = v3(x - bend * (1.0f - cosf(angle)), y - bend * (1.0f - sinf(angle)), 0);
    }
    path[7] = v3(0.3f * m->needle, y, 0);
    path[8] = v3(m->needle, y, 0);
    dmg_sweep(b, path, POINTS, 0.5f * m->arm, 0.5f * m->thick, false);
    dmg_rounded_box(b, v3(m->needle, 0.5f * (m->chin + m->high), 0), v3(0.8f * m->head, m->high - m->chin, m->thick),
                    0.1f * m->head);
    dmg_rod(b, v3(x, y, 0), v3(0.5f * m->length, y, 0), 0.4f * m->arm); /* the wheel's bearing */
}

static void draw_upper(dmg_builder* b, const sewer* m) {
    float x0 = -0.5f * m->length, x1 = 0.5f * m->length, inner = x1 - m->pillar, over = m->high - m->arm;
    if (m->frame == 3) {
        draw_casting(b, m);
        return;
    }
    if (m->frame == 2) {
        float cut = 0.3f * (over - m->bed);
        const dmg_xy slab[] = {
            {inner, 0.5f * m->bed},  {x1, 0.5f * m->bed},        {x1, m->high},       {x0, m->high},      {x0, m->chin},
            {x0 + m->head, m->chin}, {x0 + m->head + cut, over}, {inner - cut, over}, {inner, over - cut}};
        dmg_extrude(b, slab, 9, -0.5f * m->thick, 0.5f * m->thick);
        return;
    }
    float r = m->frame == 1 ? 0.2f * m->arm : 0.04f * m->arm;
    dmg_rounded_box(b, v3(x1 - 0.5f * m->pillar, 0.5f * (0.5f * m->bed + m->high), 0),
                    v3(m->pillar, m->high - 0.5f * m->bed, m->thick), r);
    dmg_rounded_box(b, v3(0, m->high - 0.5f * m->arm, 0), v3(m->length, m->arm, 0.98f * m->thick), r);
    dmg_rounded_box(b, v3(m->needle, 0.5f * (m->chin + m->high), 0), v3(m->head, m->high - m->chin, 0.96f * m->thick),
                    r);
}

/* ---- at the needle ---- */

static void draw_needle(dmg_builder* b, const sewer* m) {
    float r = 0.012f * m->length, x = m->needle, z = 0.1f * m->thick, drop = m->chin - m->bed;
    float way = drop * dmg_range(b, 0.2f, 0.4f), low = m->chin - 0.35f * drop;
    dmg_slide(b, m->body, "needle_bar", v3(0, -1, 0), 0.0f, way);
    dmg_rod(b, v3(x, low, z), v3(x, m->chin + 0.1f * m->arm, z), r);
    dmg_box(b, v3(x, low, z), v3(3.0f * r, 3.0f * r, 3.0f * r));
    dmg_cone(b, v3(x, low - 0.4f * drop, z), v3(x, low, z), 0.0f, 0.4f * r);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(x, low, z), v3(x + 6.0f * r, low, z), 0.8f * r);
    float lift = 0.15f * drop, back = z - 5.0f * r, sole = m->bed + 0.02f * drop;
    if (dmg_chance(b, 0.85f)) { /* the foot that holds the cloth, and the lever that lifts it */
        dmg_slide(b, m->body, "presser_foot", v3(0, 1, 0), 0.0f, lift);
        dmg_rod(b, v3(x, sole + 0.1f * drop, back), v3(x, m->chin + 0.1f * m->arm, back), r);
        dmg_box_span(b, v3(x - 3.0f * r, sole, back - 2.0f * r), v3(x + 3.0f * r, sole + 0.12f * drop, back + r));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(x + (float)s * 2.0f * r, sole + 0.4f * r, back + 5.0f * r), v3(2.0f * r, 0.8f * r, 9.0f * r));
        float y = m->chin + 0.05f * (m->high - m->chin), rear = -0.5f * m->thick - 0.5f * r;
        dmg_hinge(b, m->body, "foot_lever", v3(x, y, rear), v3(0, 0, 1), 0.0f, dmg_range(b, 0.8f, 1.6f));
        dmg_rod(b, v3(x, y, rear - r), v3(x, y, rear + 2.0f * r), 1.5f * r);
        dmg_beam(b, v3(x, y, rear), v3(x + 9.0f * r, y - 5.0f * r, rear - 2.0f * r), 1.5f * r, 2.0f * r);
    }
    dmg_use(b, m->body);
}

/* In a slot of the head's front: slides in it, or swings about a line inside. */
static void draw_take_up(dmg_builder* b, const sewer* m) {
    float x = m->needle - 0.15f * m->head, face = 0.48f * m->thick, tall = 0.5f * (m->high - m->chin);
    float y = m->high - 0.3f * (m->high - m->chin), r = 0.01f * m->length, way = 0.4f * tall;
    dmg_use(b, m->body);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3(x + (float)s * 2.5f * r, y - 0.5f * way, face), v3(r, 1.4f * way, 2.5f * r));
    if (dmg_chance(b, 0.5f)) {
        dmg_slide(b, m->body, "take_up", v3(0, -1, 0), 0.0f, way);
    } else {
        float arm = fminf(0.8f * m->thick, 1.5f * tall);
        dmg_hinge(b, m->body, "take_up", v3(x, y - 0.5f * way, face - arm), v3(1, 0, 0), 0.0f, way / arm);
    }
    dmg_box_span(b, v3(x - r, y - r, face - 3.0f * r), v3(x + r, y + r, face + 5.0f * r));
    dmg_torus(b, v3(x, y, face + 6.0f * r), v3(1, 0, 0), 1.5f * r, 0.6f * r);
    dmg_use(b, m->body);
}

/* Draws the plate at the left end: a door about its front or rear edge, about its top, or one that is screwed on. */
static void draw_face_plate(dmg_builder* b, const sewer* m) {
    float x = m->needle - (m->frame == 3 ? 0.4f : 0.5f) * m->head, t = 0.012f * m->length, z = 0.45f * m->thick;
    float low = m->chin + 0.03f * m->high, top = m->high - 0.05f * m->high;
    int way = dmg_int(b, 0, 2);
    if (way == 0)
        dmg_hinge(b, m->body, "face_plate", v3(x - 0.5f * t, 0, -z), v3(0, -1, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
    if (way == 1)
        dmg_hinge(b, m->body, "face_plate", v3(x - 0.5f * t, 0, z), v3(0, 1, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
    if (way == 2) dmg_hinge(b, m->body, "face_plate", v3(x, top, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 0.8f, 1.8f));
    dmg_box_span(b, v3(x - t, low, -z), v3(x, top, z));
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(x - 1.5f * t, low + 0.2f * (top - low), way == 0 ? 0.8f * z : -0.8f * z),
                v3(2 * t, 3 * t, 2 * t));
    dmg_use(b, m->body);
}

/* ---- at the pillar ---- */

static void draw_hand_wheel(dmg_builder* b, const sewer* m) {
    float r = m->arm * dmg_range(b, 0.35f, 0.75f), wide = m->length * dmg_range(b, 0.04f, 0.08f);
    int kind = dmg_int(b, 0, DMG_WHEEL_KINDS - 1), spokes = dmg_int(b, 3, 8);
    float x = 0.5f * m->length + 0.55f * wide, y = m->high - 0.5f * m->arm;
    if (m->frame == 3) r *= 1.3f;
    dmg_spin(b, m->body, "hand_wheel", v3(x, y, 0), v3(dmg_chance(b, 0.5f) ? 1.0f : -1.0f, 0, 0));
    dmg_save(b);
    dmg_move(b, x, y, 0);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    if (dmg_chance(b, 0.4f)) {
        dmg_rod(b, v3(0, 0, -0.55f * wide), v3(0, 0, 0.5f * wide), r);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.8f * wide), 0.5f * r);
    } else {
        dmg_wheel_draw(b, kind, r, wide, spokes);
    }
    if (dmg_chance(b, 0.25f)) { /* a crank's grip */
        dmg_box_span(b, v3(-0.15f * r, 0, 0.4f * wide), v3(0.15f * r, 0.9f * r, 0.7f * wide));
        dmg_rod(b, v3(0, 0.85f * r, 0.4f * wide), v3(0, 0.85f * r, 2.5f * wide), 0.13f * r);
    }
    dmg_restore(b);
    dmg_use(b, m->body);
}

/* Dials and a lever or a key for sewing backwards, on the pillar's front. */
static void draw_pillar_controls(dmg_builder* b, const sewer* m) {
    int dials = dmg_int(b, 1, 3), kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    float x = 0.5f * (m->length - m->pillar), face = 0.5f * m->thick, room = m->high - m->bed;
    float pitch = 0.6f * room / (float)dials, r = fminf(0.35f * m->pillar, 0.4f * pitch) * dmg_range(b, 0.5f, 1.0f);
    bool casting = m->frame == 3;
    if (casting) r = fminf(r, 0.2f * m->pillar);
    for (int i = 0; i < dials; ++i) {
        dmg_save(b);
        dmg_move(b, x, m->bed + 0.35f * room + pitch * ((float)i + 0.3f), casting ? 0.85f * face : 0.98f * face);
        dmg_hinge(b, m->body, "dial", v3(0, 0, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 1.5f, 5.0f));
        dmg_knob_draw(b, kind, r, r * dmg_range(b, 0.5f, 1.2f));
        dmg_restore(b);
    }
    float y = m->bed + 0.18f * room, w = 0.15f * m->pillar, rise = 0.035f * m->length;
    if (dmg_chance(b, 0.5f)) {
        dmg_hinge(b, m->body, "reverse_lever", v3(x, y, 0.9f * face), v3(1, 0, 0), -0.2f, dmg_range(b, 0.3f, 0.6f));
        dmg_beam(b, v3(x, y, 0.8f * face), v3(x, y + 0.3f * rise, face + 2.0f * rise), w, 0.4f * rise);
        dmg_box(b, v3(x, y + 0.3f * rise, face + 2.0f * rise), v3(1.8f * w, 0.7f * rise, 0.5f * rise));
    } else {
        dmg_slide(b, m->body, "reverse_key", v3(0, 0, -1), 0.0f, 0.4f * rise);
        dmg_rounded_box(b, v3(x, y, (casting ? 0.85f : 1.0f) * face), v3(2.5f * w, 1.5f * w, rise), 0.2f * w);
    }
    dmg_use(b, m->body);
}

/* ---- on top ---- */

static void draw_spool(dmg_builder* b, uint32_t pin, dmg_vec from, dmg_vec way, float r) {
    dmg_spin(b, pin, "spool", from, way);
    const dmg_xy profile[] = {{0, 0},        {1.6f * r, 0},        {1.6f * r, 0.5f * r}, {r, 0.8f * r},
                              {r, 3.2f * r}, {1.6f * r, 3.5f * r}, {1.6f * r, 4 * r},    {0, 4 * r}};
    dmg_lathe(b, from, way, profile, 8);
}

/* Pins for thread, upright or folded down on the arm; a bobbin's winder that is pushed over to wind. */
static void draw_spools(dmg_builder* b, const sewer* m) {
    int pins = dmg_int(b, 1, 2);
    float r = 0.025f * m->length, tall = 6.0f * r, y = m->high, z = -0.2f * m->thick;
    for (int i = 0; i < pins; ++i) {
        float x = 0.5f * m->length - 0.6f * m->pillar - (float)i * 5.0f * r;
        bool folds = dmg_chance(b, 0.4f);
        uint32_t pin = m->body;
        dmg_use(b, m->body);
        dmg_box(b, v3(x, y, z), v3(2.0f * r, r, 2.0f * r));
        if (folds) {
            pin = dmg_hinge(b, m->body, "spool_pin", v3(x, y + 0.5f * r, z), v3(0, 0, 1), 0.0f, 1.5f);
            dmg_rest(b, pin, dmg_chance(b, 0.7f) ? 0.0f : 1.5f);
        }
        dmg_rod(b, v3(x, y, z), v3(x, y + tall, z), 0.25f * r);
        if (dmg_chance(b, 0.7f)) draw_spool(b, pin, v3(x, y + r, z), v3(0, 1, 0), r);
    }
    if (dmg_chance(b, 0.5f)) {
        float x = 0.5f * m->length - 0.2f * m->pillar;
        bool slides = dmg_chance(b, 0.5f);
        uint32_t arm = slides ? dmg_slide(b, m->body, "winder", v3(1, 0, 0), 0.0f, 0.1f * m->pillar)
                              : dmg_hinge(b, m->body, "winder", v3(x, y, z - r), v3(0, -1, 0), 0.0f, 0.5f);
        dmg_box(b, v3(x, y + 0.3f * r, z + r), v3(1.2f * r, 0.6f * r, 5.0f * r));
        dmg_rod(b, v3(x, y, z + 2.5f * r), v3(x, y + 2.0f * r, z + 2.5f * r), 0.3f * r);
        dmg_spin(b, arm, "bobbin", v3(x, y, z + 2.5f * r), v3(0, 1, 0));
        dmg_rod(b, v3(x, y + 0.8f * r, z + 2.5f * r), v3(x, y + 1.8f * r, z + 2.5f * r), 0.9f * r);
    }
    dmg_use(b, m->body);
}

/* Draws a handle to carry it by, or a lid over the spools. */
static void draw_top(dmg_builder* b, const sewer* m) {
    float t = 0.02f * m->length, half = 0.3f * m->length, y = m->high;
    if (dmg_chance(b, 0.5f)) {
        float tall = m->thick * dmg_range(b, 0.3f, 0.6f), z = 0.25f * m->thick;
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * half, y, z), v3(t, 2.5f * t, 2 * t));
        dmg_hinge(b, m->body, "handle", v3(0, y + 0.8f * t, z), v3(1, 0, 0), 0.0f, dmg_range(b, 1.2f, 1.6f));
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * half - (s > 0 ? 1.5f : -0.5f) * t, y + 0.3f * t, z - tall),
                         v3((float)s * half - (s > 0 ? 0.5f : -1.5f) * t, y + 1.3f * t, z));
        dmg_box(b, v3(0, y + 0.8f * t, z - tall), v3(2 * half - t, 1.2f * t, 2 * t));
    } else {
        float thick = t * dmg_range(b, 0.5f, 2.0f), z = 0.48f * m->thick;
        float line = y + thick * dmg_unit(b);
        dmg_hinge(b, m->body, "lid", v3(0, line, -z), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 2.0f));
        dmg_box_span(b, v3(-0.48f * m->length, y, -z), v3(0.48f * m->length, y + thick, z));
    }
    dmg_use(b, m->body);
}

/* ---- at the bed ---- */

/* Draws the box round a free arm: it is drawn off to the left; things are kept under its flap. */
static void draw_extension(dmg_builder* b, const sewer* m) {
    float x0 = -0.5f * m->length, x1 = 0.5f * m->length - m->pillar - 0.005f * m->length, z = 0.14f * m->deep,
          front = 0.5f * m->deep;
    uint32_t table = dmg_slide(b, m->body, "extension", v3(-1, 0, 0), 0.0f, (x1 - x0) * dmg_range(b, 0.3f, 0.9f));
    float t = 0.08f * m->bed, end = x0 - 0.1f * m->length;
    dmg_box_span(b, v3(end, 0, z), v3(x1, m->bed - t, front - t));
    dmg_box_span(b, v3(end, 0, -0.2f * m->deep), v3(x0 - 0.005f * m->length, m->bed, z));
    if (dmg_chance(b, 0.5f)) {
        dmg_box_span(b, v3(end, m->bed - t, z), v3(x1, m->bed, front));
        dmg_hinge(b, table, "flap", v3(0, 0.5f * t, front - 0.5f * t), v3(1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.6f));
        dmg_box_span(b, v3(end + t, 0, front - t), v3(x1 - t, m->bed - t, front));
    } else {
        dmg_hinge(b, table, "flap", v3(0, m->bed - 0.5f * t, z), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 2.2f));
        dmg_box_span(b, v3(end, m->bed - t, z), v3(x1, m->bed, front - t));
    }
    dmg_use(b, m->body);
}

/* Over the bobbin: a plate that slides in the bed, one that tips up, or a door in front. */
static void draw_bobbin_cover(dmg_builder* b, const sewer* m) {
    float x = m->needle, w = 0.4f * m->head, t = 0.015f * m->length, y = m->bed, far = 0.48f * m->deep,
          near = 0.22f * m->deep;
    int way = m->frame == 1 ? dmg_int(b, 0, 1) : dmg_int(b, 0, 2);
    if (way == 0) {
        bool sideways = dmg_chance(b, 0.5f);
        dmg_slide(b, m->body, "bobbin_cover", sideways ? v3(-1, 0, 0) : v3(0, 0, 1), 0.0f,
                  sideways ? 1.6f * w : 0.8f * (far - near));
        dmg_box_span(b, v3(x - w, y - 0.3f * t, near), v3(x + w, y + 0.7f * t, far));
        dmg_box(b, v3(x, y + 0.8f * t, near + 0.3f * (far - near)), v3(0.6f * w, 0.6f * t, 0.5f * t));
    } else if (way == 1) {
        dmg_hinge(b, m->body, "bobbin_cover", v3(x - w, y + 0.2f * t, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 0.8f, 1.7f));
        dmg_box_span(b, v3(x - w, y - 0.3f * t, near), v3(x + w, y + 0.7f * t, far));
    } else {
        float z = 0.5f * m->deep;
        dmg_hinge(b, m->body, "bobbin_door", v3(x, 0.15f * y, z + 0.5f * t), v3(1, 0, 0), 0.0f,
                  dmg_range(b, 0.8f, 1.6f));
        dmg_box_span(b, v3(x - 1.2f * w, 0.15f * y, z), v3(x + 1.2f * w, 0.85f * y, z + t));
    }
    dmg_use(b, m->body);
}

/* Draws a wooden base, or a table with a treadle; the machine tilts back on it about the bed's rear edge. */
static void draw_base(dmg_builder* b, sewer* m) {
    float wide = 1.15f * m->length, deep = 1.2f * m->deep, tall = m->length * dmg_range(b, 0.1f, 0.2f);
    bool table = dmg_chance(b, 0.4f), tilts = dmg_chance(b, 0.7f);
    float up = table ? m->length * dmg_range(b, 1.2f, 1.8f) : tall, t = 0.06f * m->length;
    if (table) {
        wide *= 1.5f;
        deep *= 1.3f;
        dmg_box_span(b, v3(-0.5f * wide, up - t, -0.5f * deep), v3(0.5f * wide, up, 0.5f * deep));
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * 0.42f * wide;
            for (int k = -1; k <= 1; k += 2)
                dmg_beam(b, v3(x, 0, 0.45f * (float)k * deep), v3(x, up - t, 0.25f * (float)k * deep), t, t);
            dmg_box(b, v3(x, 0.12f * up, 0), v3(t, t, 0.8f * deep));
        }
        dmg_rod(b, v3(-0.42f * wide, 0.12f * up, 0), v3(0.42f * wide, 0.12f * up, 0), 0.3f * t);
        dmg_hinge(b, 0, "treadle", v3(0, 0.12f * up, 0), v3(1, 0, 0), -0.25f, 0.25f);
        dmg_box(b, v3(0, 0.12f * up, 0), v3(0.5f * wide, 0.4f * t, 0.6f * deep));
        if (dmg_chance(b, 0.6f)) {
            float r = 0.3f * up, x = 0.42f * wide - 1.5f * t;
            dmg_spin(b, 0, "fly_wheel", v3(x, 0.5f * up, 0), v3(1, 0, 0));
            dmg_save(b);
            dmg_move(b, x, 0.5f * up, 0);
            dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
            dmg_wheel_draw(b, dmg_int(b, 0, DMG_WHEEL_KINDS - 1), r, 0.7f * t, 5);
            dmg_restore(b);
        }
    } else {
        dmg_box_span(b, v3(-0.5f * wide, 0, -0.5f * deep), v3(0.5f * wide, up, 0.5f * deep));
    }
    dmg_use(b, 0);
    dmg_move(b, 0, up, 0);
    float line = 0.3f * m->bed * dmg_unit(b), back = dmg_range(b, 0.5f, 1.4f);
    if (tilts) m->body = dmg_hinge(b, 0, "machine", v3(0, line, -0.5f * m->deep), v3(-1, 0, 0), 0.0f, back);
}

void dmg_build_sewing_machine(dmg_builder* b) {
    sewer m = pick_sewer(b);
    if (dmg_chance(b, 0.2f)) dmg_mirror(b, v3(1, 0, 0));
    if (!m.free_arm && dmg_chance(b, 0.35f)) draw_base(b, &m);
    draw_bed(b, &m);
    draw_upper(b, &m);
    draw_hand_wheel(b, &m);
    draw_needle(b, &m);
    if (dmg_chance(b, 0.7f)) draw_take_up(b, &m);
    if (dmg_chance(b, 0.85f)) draw_pillar_controls(b, &m);
    if (dmg_chance(b, 0.5f)) draw_face_plate(b, &m);
    if (dmg_chance(b, 0.5f))
        draw_spools(b, &m);
    else if (m.frame != 3)
        draw_top(b, &m);
    if (m.free_arm)
        draw_extension(b, &m);
    else if (dmg_chance(b, 0.7f))
        draw_bobbin_cover(b, &m);
}
