/* Draws portable computers by the place of their hinge: raised on the base, dropped behind it, inside its edge, far
 * from it. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct notebook {
    float width, depth, base, lid; /* base, lid: thickness */
    float up, back;                /* the hinge line: y, z */
    float rear;                    /* z of the closed lid's hung end */
    float under;                   /* y of the closed lid's inner face */
    float radius;                  /* of a barrel */
    float far;                     /* the widest opening */
} notebook;

/* Draws a round barrel on the hinge line, drawn onto the lid, onto the base or half and half. */
static void draw_barrels(dmg_builder* b, const notebook* n, uint32_t lid) {
    int kind = dmg_int(b, 0, 4), owner = dmg_int(b, 0, 2); /* across, two, one, ends of both; lid, base, both */
    float span = n->width * (kind == 1 ? dmg_range(b, 0.05f, 0.25f) : dmg_range(b, 0.3f, 1.0f));
    if (kind == 0) span = n->width * dmg_range(b, 0.9f, 1.0f);
    float apart = dmg_range(b, 0.3f, 0.44f) * n->width;
    int count = kind == 1 || kind == 3 ? 2 : 1;
    if (kind == 3) span = fminf(span, 0.3f * n->width);
    for (int i = 0; i < count; ++i) {
        float x = count == 1 ? 0.0f : (i == 0 ? -apart : apart), half = 0.5f * span;
        dmg_use(b, owner == 1 ? 0 : lid);
        dmg_rod(b, v3(x - half, n->up, n->back), v3(x + half, n->up, n->back), n->radius);
        if (owner != 2) continue;
        dmg_use(b, 0);
        dmg_rod(b, v3(x - 1.4f * half, n->up, n->back), v3(x - 1.02f * half, n->up, n->back), n->radius);
    }
    dmg_use(b, lid);
}

/* Draws the base in profile: a box, a wedge, or with a slope behind the line. */
static void draw_base(dmg_builder* b, const notebook* n, int profile) {
    float z = 0.5f * n->depth, h = n->base;
    if (profile == 0) {
        dmg_box(b, v3(0, 0.5f * h, 0), v3(n->width, h, n->depth));
    } else if (profile == 1) {
        dmg_rounded_box(b, v3(0, 0.5f * h, 0), v3(n->width, h, n->depth), 0.4f * h);
    } else if (profile == 2) {
        dmg_save(b);
        dmg_move(b, 0, h, 0);
        dmg_face_up(b);
        dmg_rounded_plate(b, n->width, n->depth, h, dmg_range(b, 0.02f, 0.12f) * n->depth);
        dmg_restore(b);
    } else {
        float nose = h * dmg_range(b, 0.3f, 1.0f), slope = dmg_chance(b, 0.5f) ? h * dmg_range(b, 0.3f, 1.3f) : 0.0f;
        const dmg_xy outline[] = {{-z, h - nose}, {z + slope, 0}, {z, h}, {-z, h}};
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* the outline's x runs to the back */
        dmg_extrude(b, outline, 4, -0.5f * n->width, 0.5f * n->width);
        dmg_restore(b);
    }
    for (int s = -1; s <= 1 && profile == 1; s += 2)
        dmg_box(b, v3((float)s * 0.4f * n->width, -0.01f * n->width, 0), v3(0.03f, 0.02f * n->width, 0.8f * n->depth));
}

/* Keys one by one, in bars or as one field, and a pad to touch. */
static void draw_deck(dmg_builder* b, const notebook* n, float room) {
    int kind = dmg_int(b, 0, 3);
    float front = 0.5f * n->depth, middle = n->back + 0.35f * room, w = 0.88f * n->width, d = 0.5f * room;
    float rise = fmaxf(0.15f * (n->under - n->base), 0.0006f), taper = dmg_range(b, 0.0f, 0.3f);
    int columns = dmg_int(b, 8, 13), rows = dmg_int(b, 4, 6);
    if (kind == 1) dmg_box(b, v3(0, n->base, middle), v3(w, 2 * rise, d));
    for (int i = 0; i < rows && kind == 2; ++i)
        dmg_box(b, v3(0, n->base, middle + d * (((float)i + 0.5f) / (float)rows - 0.5f)),
                v3(w, 2 * rise, 0.8f * d / (float)rows));
    for (int i = 0; i < rows * columns && kind == 3; ++i) {
        float x = w * (((float)(i % columns) + 0.5f) / (float)columns - 0.5f),
              z = middle + d * (((float)(i / columns) + 0.5f) / (float)rows - 0.5f);
        dmg_box(b, v3(x, n->base, z), v3((0.95f - taper) * w / (float)columns, 2 * rise, 0.8f * d / (float)rows));
    }
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, n->base, front - 0.17f * room), v3(0.28f * n->width, rise, 0.2f * room));
}

/* Draws the lid lying closed, its hung end at z = rear. */
static void draw_lid(dmg_builder* b, const notebook* n, float length) {
    int style = dmg_int(b, 0, 3);
    float width = n->width * (dmg_chance(b, 0.6f) ? 1.0f : dmg_range(b, 0.86f, 1.03f)), t = n->lid;
    float border = dmg_range(b, 0.02f, 0.12f) * width;
    dmg_save(b);
    dmg_move(b, 0, n->under + t, n->rear + 0.5f * length);
    dmg_face_up(b);
    if (style == 0) dmg_rounded_plate(b, width, length, t, dmg_range(b, 0.02f, 0.1f) * length);
    if (style == 1) dmg_rounded_box(b, v3(0, 0, -0.5f * t), v3(width, length, t), 0.45f * t);
    if (style == 2) dmg_box(b, v3(0, 0, -0.5f * t), v3(width, length, t));
    if (style == 3) { /* a shell with its display let in */
        dmg_box_faces(b, v3(0, 0, -0.5f * t), v3(width, length, t), DMG_FACE_ALL & ~DMG_FACE_BACK);
        dmg_move(b, 0, 0, -0.7f * t);
        dmg_frame_draw(b, width, length, 0.3f * t, border);
        dmg_move(b, 0, 0, 0.7f * t);
    }
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0, -t), v3(width - 2 * border, length - 2 * border, 0.06f * t));
    if (dmg_chance(b, 0.2f)) dmg_box(b, v3(0, 0, 0), v3(0.2f * length, 0.2f * length, 0.06f * t));
    if (dmg_chance(b, 0.2f))
        dmg_box(b, v3(0, 0.5f * length - 0.5f * border, -t), v3(0.1f * border, 0.1f * border, 0.1f * t));
    dmg_restore(b);
}

/* Arms from the line in the base to a lid that hangs behind it. */
static void draw_arms(dmg_builder* b, const notebook* n) {
    float across = dmg_range(b, 0.05f, 0.5f) * n->width, apart = 0.3f * n->width, end = 0.7f * n->rear + 0.3f * n->back;
    int count = across > 0.25f * n->width ? 1 : 2;
    for (int i = 0; i < count; ++i) {
        float x = count == 1 ? 0.0f : (i == 0 ? -apart : apart);
        dmg_beam(b, v3(x, n->up, n->back), v3(x, n->under + 0.5f * n->lid, end), across, n->radius);
    }
}

/* Draws the line on a barrel that rises over the base: the lid grows out of it, in its middle or tangent to it. */
static void hang_raised(dmg_builder* b, notebook* n) {
    float z = 0.5f * n->depth;
    n->radius = n->lid * dmg_range(b, 0.4f, 1.4f);
    n->under = n->base + n->radius * dmg_range(b, 0.0f, 0.9f) + 0.0005f;
    n->up = n->under + (dmg_chance(b, 0.4f) ? 0.5f : dmg_range(b, 0.0f, 1.0f)) * n->lid;
    n->back = n->radius * dmg_range(b, -0.6f, 1.2f) - z;
    n->rear = n->back + n->radius * (dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, -0.8f, 0.9f));
    n->far = dmg_range(b, 2.0f, 2.9f);
}

/* Draws the line inside the base's rear edge: the lid overhangs behind and sinks below the deck when it opens. */
static void hang_dropped(dmg_builder* b, notebook* n) {
    float in = n->base * dmg_range(b, -0.1f, 0.5f), drop = n->base * dmg_range(b, 0.1f, 1.0f);
    n->back = in - 0.5f * n->depth;
    n->rear = -0.5f * n->depth - drop;
    n->far = dmg_range(b, 1.95f, 2.3f);
    /* Leaning by n->far, the lid's lower end must clear the rear face of the base. */
    float lean = -cosf(n->far), clear = (in + lean * (in + drop)) / sinf(n->far);
    n->under = n->base + dmg_range(b, 0.0003f, 0.003f);
    n->up = n->under - fmaxf(clear, 0.0f) * dmg_range(b, 0.9f, 1.3f);
    n->radius = n->base * dmg_range(b, 0.12f, 0.4f);
}

/* Draws the line at the lid's own lower edge, on the deck: at the base's edge or far in front of it. */
static void hang_on_edge(dmg_builder* b, notebook* n) {
    float in = dmg_chance(b, 0.5f) ? n->lid * dmg_range(b, -0.3f, 0.8f) : n->depth * dmg_range(b, 0.02f, 0.2f);
    static const float through[] = {0.0f, 0.0f, 0.5f, 1.0f};
    n->under = n->base + (dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, 0.0004f, 0.004f));
    n->up = n->under + through[dmg_int(b, 0, 3)] * n->lid;
    n->rear = in - 0.5f * n->depth;
    n->back = n->rear + (dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, -0.2f, 0.8f) * n->lid);
    n->radius = n->lid * dmg_range(b, 0.2f, 0.6f);
    n->far = dmg_range(b, 1.9f, 2.4f);
}

void dmg_build_notebook(dmg_builder* b) {
    notebook n = {.width = dmg_range(b, 0.22f, 0.42f)};
    n.depth = n.width * dmg_range(b, 0.55f, 0.85f);
    n.base = n.width * dmg_scale_range(b, 0.02f, 0.14f);
    n.lid = n.width * dmg_scale_range(b, 0.012f, 0.09f);
    int hung = dmg_int(b, 0, 2), profile = dmg_int(b, 0, 4);
    if (hung == 0) hang_raised(b, &n);
    if (hung == 1) hang_dropped(b, &n);
    if (hung == 2) hang_on_edge(b, &n);
    float room = 0.5f * n.depth - fmaxf(n.back, n.rear);
    draw_base(b, &n, hung == 1 ? profile % 3 : profile);
    draw_deck(b, &n, room);
    uint32_t lid = dmg_hinge(b, 0, "screen", v3(0, n.up, n.back), v3(-1, 0, 0), 0.0f, n.far);
    float length = (0.5f * n.depth - n.rear) * (dmg_chance(b, 0.6f) ? 1.0f : dmg_range(b, 0.8f, 1.03f));
    draw_lid(b, &n, length);
    if (hung == 1 && dmg_chance(b, 0.7f)) draw_arms(b, &n);
    if (dmg_chance(b, hung == 2 ? 0.35f : 0.85f)) draw_barrels(b, &n, lid);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.85f)) dmg_rest(b, lid, fminf(dmg_range(b, 1.4f, 2.3f), n.far));
}
