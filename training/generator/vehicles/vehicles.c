/* Draws cars, two-wheelers, delivery robots, trolleys. Nose to +Z, standing on y = 0. */
#include "core/build.h"
#include "parts/hardware.h"

/* A wheel about X at (x, radius, z), perhaps on a steered knuckle or a sprung one. */
typedef struct axle_wheel {
    int kind, spokes;
    float radius, width;
    int mount; /* 0 on the body, 1 steered about a kingpin, 2 goes up and down */
} axle_wheel;

static void draw_wheel_at(dmg_builder* b, const axle_wheel* w, float x, float z, float lean) {
    uint32_t carrier = 0;
    dmg_save(b);
    dmg_move(b, x, w->radius, z);
    float in = x > 0 ? -1.0f : 1.0f;
    bool bare = dmg_chance(b, 0.5f); /* the wheel itself steers or gives way: one part, one joint */
    if (w->mount == 1) {             /* the knuckle's own pin lies a little inside the wheel, or in its middle */
        float pin = in * w->width * dmg_range(b, 0.0f, 1.2f);
        carrier = dmg_hinge(b, 0, "steering", v3(pin, 0, 0), v3_normalize(v3(0, cosf(lean), -sinf(lean))), -0.7f, 0.7f);
        if (!bare) dmg_rod(b, v3(pin, 0, 0), v3(0, 0, 0), 0.2f * w->radius);
    }
    if (w->mount == 2) {
        carrier = dmg_slide(b, 0, "suspension", v3(0, 1, 0), -0.2f * w->radius, 0.3f * w->radius);
        if (!bare) dmg_rod(b, v3(in * 0.8f * w->width, 0, 0), v3(0, 0, 0), 0.15f * w->radius);
    }
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    if (w->mount == 0 || !bare) dmg_spin(b, carrier, "wheel", v3(0, 0, 0), v3(0, 0, 1));
    dmg_wheel_draw(b, w->kind, w->radius, w->width, w->spokes);
    dmg_restore(b);
    dmg_use(b, 0);
}

static axle_wheel pick_axle_wheel(dmg_builder* b, float radius) {
    axle_wheel w = {.kind = dmg_int(b, 0, 2), .spokes = dmg_int(b, 4, 9), .radius = radius};
    w.width = radius * dmg_range(b, 0.3f, 0.8f);
    return w;
}

/* ---- car ---- */

typedef struct car {
    float length, width, wheel, floor, belt, roof; /* heights: of the sills, the window line, the roof */
    float front, back;                             /* axles */
    float hood, trunk;                             /* where the cabin begins and ends */
    int cabin;                                     /* saloon, van, open, truck */
} car;

static car pick_car(dmg_builder* b) {
    float length = dmg_chance(b, 0.5f) ? dmg_range(b, 3, 6) : dmg_scale_range(b, 0.1f, 3);
    car c = {
        .length = length, .width = length * dmg_range(b, 0.35f, 0.5f), .wheel = length * dmg_range(b, 0.06f, 0.1f)};
    c.floor = c.wheel * dmg_range(b, 0.5f, 1.2f);
    c.belt = c.floor + length * dmg_range(b, 0.1f, 0.2f);
    c.roof = c.belt + length * dmg_range(b, 0.08f, 0.2f);
    c.front = length * dmg_range(b, 0.28f, 0.36f);
    c.back = -length * dmg_range(b, 0.26f, 0.36f);
    c.hood = length * dmg_range(b, 0.12f, 0.3f);
    c.trunk = -length * dmg_range(b, 0.2f, 0.42f);
    c.cabin = dmg_int(b, 0, 3);
    return c;
}

/* Draws a prism along X from an outline in z, y. */
static void draw_profile(dmg_builder* b, const dmg_xy* outline, int count, float width) {
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* the outline's x becomes z */
    dmg_extrude(b, outline, count, -0.5f * width, 0.5f * width);
    dmg_restore(b);
}

static void draw_car_body(dmg_builder* b, const car* c) {
    float nose = 0.5f * c->length, tail = -nose, slope = 0.4f * (c->roof - c->belt);
    const dmg_xy tub[] = {{tail, c->floor},
                          {nose, c->floor},
                          {nose, 0.4f * c->floor + 0.6f * c->belt},
                          {0.97f * nose, c->belt},
                          {tail, c->belt}};
    draw_profile(b, tub, 5, c->width);
    const dmg_xy cabin[] = {{c->trunk, c->belt},
                            {c->hood, c->belt},
                            {c->hood - slope, c->roof},
                            {c->trunk + (c->cabin == 1 ? 0.0f : slope), c->roof}};
    if (c->cabin < 2) draw_profile(b, cabin, 4, 0.92f * c->width);
    if (c->cabin == 2) { /* a screen and two seats */
        dmg_beam(b, v3(0, c->belt, c->hood), v3(0, c->roof, c->hood - 0.5f * slope), 0.85f * c->width,
                 0.02f * c->length);
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.22f * c->width, c->belt + 0.3f * slope, c->trunk),
                    v3(0.3f * c->width, 2 * slope, 0.05f * c->length));
    }
    if (c->cabin == 3) {
        float z = 0.5f * (c->hood + 0.06f * c->length);
        dmg_box(b, v3(0, 0.5f * (c->belt + c->roof), z + 0.05f * c->length),
                v3(0.95f * c->width, c->roof - c->belt, 0.3f * c->length));
    }
}

/* Draws what opens at the back: a tailgate, a bed that tips, a boot. low: the lower edge of the doors. */
static void draw_car_back(dmg_builder* b, const car* c, float low) {
    float t = 0.012f * c->length;
    if (c->cabin == 1) { /* a door at the back: upwards, or to the side */
        float tail = -0.5f * c->length;
        bool up = dmg_chance(b, 0.6f);
        if (c->trunk > tail + 0.02f * c->length) tail = c->trunk;
        float y0 = tail == c->trunk ? c->belt : low;
        if (up)
            dmg_hinge(b, 0, "tailgate", v3(0, c->roof, tail), v3(1, 0, 0), 0.0f, 1.4f);
        else
            dmg_hinge(b, 0, "tailgate", v3(0.45f * c->width, y0, tail - t), v3(0, -1, 0), 0.0f, 1.6f);
        dmg_box_span(b, v3(-0.45f * c->width, y0, tail - t), v3(0.45f * c->width, c->roof, tail));
        dmg_use(b, 0);
    } else if (c->cabin == 3) { /* a bed that tips */
        float tail = -0.5f * c->length, end = c->hood - 0.14f * c->length;
        if (dmg_chance(b, 0.6f)) dmg_hinge(b, 0, "bed", v3(0, c->belt, tail), v3(-1, 0, 0), 0.0f, 0.9f);
        dmg_save(b);
        dmg_move(b, 0, c->roof, 0.5f * (tail + end));
        dmg_face_up(b);
        dmg_case_draw(b, DMG_CASE_BOARDS, c->width, end - tail, c->roof - c->belt, t);
        dmg_restore(b);
        dmg_use(b, 0);
    } else if (dmg_chance(b, 0.6f)) {
        dmg_hinge(b, 0, "boot", v3(0, c->belt, c->trunk), v3(1, 0, 0), 0.0f, 1.2f);
        dmg_box_span(b, v3(-0.45f * c->width, c->belt, -0.5f * c->length), v3(0.45f * c->width, c->belt + t, c->trunk));
        dmg_use(b, 0);
    }
}

/* Panels lying on the body: side doors, bonnet, what is at the back. */
static void draw_car_panels(dmg_builder* b, const car* c) {
    float t = 0.012f * c->length, top = 0.97f * c->belt, low = c->floor + 0.1f * (c->belt - c->floor),
          doors = (float)dmg_int(b, 1, 2);
    float from = c->back + 1.3f * c->wheel, to = c->front - 1.3f * c->wheel, each = (to - from) / doors;
    bool slides = dmg_chance(b, 0.15f), gull = dmg_chance(b, 0.1f), with_window = dmg_chance(b, 0.5f) && c->cabin < 2,
         back_hung = dmg_chance(b, 0.1f);
    for (int i = 0; i < (int)doors; ++i) {
        for (int s = -1; s <= 1; s += 2) {
            float side = (float)s, x = side * (0.5f * c->width + 0.5f * t), front = to - each * (float)i,
                  hang = front - (back_hung ? 0.98f * each : 0.0f);
            if (slides && i == 1)
                dmg_slide(b, 0, "door", v3(0, 0, -1), 0.0f, 0.9f * each);
            else if (gull)
                dmg_hinge(b, 0, "door", v3(x - side * t, top, front), v3(0, 0, side), 0.0f, 1.3f);
            else
                dmg_hinge(b, 0, "door", v3(x, low, hang), v3(0, back_hung ? side : -side, 0), 0.0f,
                          dmg_range(b, 0.8f, 1.3f));
            dmg_box_span(b, v3(x - 0.5f * t, low, front - 0.98f * each), v3(x + 0.5f * t, top, front));
            if (dmg_chance(b, 0.7f))
                dmg_box(b, v3(x + side * t, top - 0.03f * c->length, front - 0.85f * each),
                        v3(t, 0.015f * c->length, 0.06f * c->length));
            if (with_window)
                dmg_box(b, v3(x - side * 0.04f * c->width, 0.5f * (top + c->roof), front - 0.5f * each),
                        v3(t, 0.8f * (c->roof - top), 0.7f * each));
            dmg_use(b, 0);
        }
    }
    if (dmg_chance(b, 0.7f)) {
        float nose = 0.48f * c->length;
        bool at_screen = dmg_chance(b, 0.8f);
        dmg_hinge(b, 0, "bonnet", v3(0, c->belt, at_screen ? c->hood : nose), v3(at_screen ? -1.0f : 1.0f, 0, 0), 0.0f,
                  dmg_range(b, 0.7f, 1.3f));
        dmg_box_span(b, v3(-0.45f * c->width, c->belt, c->hood), v3(0.45f * c->width, c->belt + t, nose));
        dmg_use(b, 0);
    }
    draw_car_back(b, c, low);
}

/* Draws what hands and feet move in an open car. */
static void draw_car_controls(dmg_builder* b, const car* c) {
    float radius = 0.1f * c->width, lean = dmg_range(b, 0.3f, 1.0f);
    dmg_save(b);
    dmg_move(b, 0.22f * c->width, c->belt + 0.12f * c->width, 0.75f * c->hood);
    dmg_turn(b, v3(1, 0, 0), -lean);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_rod(b, v3(0, 0, -2.5f * radius), v3(0, 0, 0), 0.15f * radius);
    dmg_hinge(b, 0, "steering_wheel", v3(0, 0, 0), v3(0, 0, 1), -3.1f, 3.1f);
    dmg_wheel_draw(b, 3, 1.2f * radius, 0.2f * radius, dmg_int(b, 2, 4));
    dmg_use(b, 0);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) {
        dmg_vec foot = {0, c->belt, 0.3f * c->hood};
        dmg_hinge(b, 0, "hand_brake", foot, v3(-1, 0, 0), 0.0f, 0.6f);
        dmg_beam(b, foot, v3_add(foot, v3(0, 0.05f * c->width, 0.2f * c->width)), 0.02f * c->width, 0.025f * c->width);
        dmg_use(b, 0);
    }
}

void dmg_build_car(dmg_builder* b) {
    car c = pick_car(b);
    draw_car_body(b, &c);
    axle_wheel front = pick_axle_wheel(b, c.wheel), back = front;
    static const float weights[] = {4, 4, 1};
    front.mount = dmg_weighted(b, weights, 3);
    back.mount = front.mount == 2 ? 2 : 0;
    float x = 0.5f * c.width + front.width * dmg_range(b, -0.4f, 0.55f),
          lean = dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, 0, 0.25f);
    for (int s = -1; s <= 1; s += 2) {
        draw_wheel_at(b, &front, (float)s * x, c.front, lean);
        draw_wheel_at(b, &back, (float)s * x, c.back, 0);
    }
    draw_car_panels(b, &c);
    if (c.cabin == 2) draw_car_controls(b, &c);
}

/* ---- bicycle, motorcycle, scooter ---- */

static void draw_cranks(dmg_builder* b, dmg_vec bottom, float wheel, float tube, float half) {
    uint32_t crank = dmg_spin(b, 0, "crank", bottom, v3(1, 0, 0));
    float arm = 0.45f * wheel;
    dmg_rod(b, v3_add(bottom, v3(-half, 0, 0)), v3_add(bottom, v3(half, 0, 0)), tube);
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec end = v3_add(bottom, v3((float)s * half, (float)s * 0.5f * arm, (float)s * 0.8f * arm));
        dmg_use(b, crank);
        dmg_beam(b, v3_add(bottom, v3((float)s * half, 0, 0)), end, 0.6f * tube, tube);
        dmg_spin(b, crank, "pedal", end, v3(1, 0, 0));
        dmg_box(b, v3_add(end, v3((float)s * 0.15f * wheel, 0, 0)), v3(0.3f * wheel, 0.08f * wheel, 0.25f * wheel));
    }
    dmg_use(b, 0);
}

static void draw_side_stand(dmg_builder* b, float wheel, float base, float tube, float half) {
    dmg_vec pin = {-0.5f * half, 0.7f * wheel, -0.2f * base};
    dmg_hinge(b, 0, "stand", pin, v3(-1, 0, 0), 0.0f, 1.5f);
    dmg_rod(b, pin, v3(-1.5f * half, 0.02f * wheel, -0.2f * base), 0.6f * tube);
    dmg_use(b, 0);
}

void dmg_build_two_wheeler(dmg_builder* b) {
    float wheel = dmg_scale_range(b, 0.08f, 0.4f), base = wheel * dmg_range(b, 2.8f, 4.5f),
          tube = wheel * dmg_range(b, 0.04f, 0.12f), lean = dmg_range(b, 0.1f, 0.6f),
          top = wheel * dmg_range(b, 2.2f, 3.6f);
    int kind = dmg_int(b, 0, 2); /* bicycle, motorcycle, scooter */
    axle_wheel w = pick_axle_wheel(b, wheel);
    w.width = wheel * (kind == 0 ? 0.12f : dmg_range(b, 0.25f, 0.5f));
    if (kind == 0) w.kind = 3;
    dmg_vec axle = {0, wheel, 0.5f * base}, rear = {0, wheel, -0.5f * base}, steer = {0, cosf(lean), -sinf(lean)};
    float up = (top - wheel) / cosf(lean), half = 0.6f * w.width + tube;
    dmg_vec head = v3_mad(axle, steer, up), crown = v3_mad(axle, steer, 0.45f * up + 0.4f * wheel),
            saddle = {0, 0.85f * top, -0.25f * base}, bottom = {0, 0.9f * wheel, -0.1f * base};
    dmg_rod(b, v3_mad(crown, steer, 0.05f * up), v3_mad(head, steer, -0.1f * up), 1.5f * tube);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * half, rear.y, rear.z), v3_add(bottom, v3((float)s * 0.3f * half, 0, 0)), 0.7f * tube);
    dmg_rod(b, bottom, crown, tube);
    if (kind == 2) dmg_box(b, v3(0, 0.6f * wheel, 0), v3(3 * w.width, 2 * tube, 0.9f * base - 2 * wheel));
    if (kind != 2) {
        dmg_rod(b, bottom, saddle, tube);
        dmg_rod(b, v3_lerp(crown, head, 0.3f), v3_lerp(bottom, saddle, 0.8f), tube);
        dmg_rounded_box(b, v3_add(saddle, v3(0, tube, 0)), v3(0.5f * wheel, 0.2f * wheel, 0.9f * wheel), 0.08f * wheel);
    }
    if (kind == 1) {
        dmg_rounded_box(b, v3_lerp(bottom, crown, 0.35f), v3(0.6f * wheel, 0.8f * wheel, wheel), 0.1f * wheel);
        dmg_ellipsoid(b, v3_lerp(saddle, head, 0.5f), v3(0.35f * wheel, 0.35f * wheel, 0.8f * wheel));
    }
    uint32_t fork = dmg_chance(b, 0.8f) ? dmg_hinge(b, 0, "fork", axle, steer, -0.8f, 0.8f) : 0;
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * half, axle.y, axle.z), v3_add(crown, v3((float)s * half, 0, 0)), 0.8f * tube);
    dmg_beam(b, v3_add(crown, v3(-half, 0, 0)), v3_add(crown, v3(half, 0, 0)), 2 * tube, 2 * tube);
    dmg_rod(b, crown, head, tube);
    float bar = wheel * dmg_range(b, 0.6f, 1.1f);
    dmg_rod(b, v3_add(head, v3(-bar, 0, 0)), v3_add(head, v3(bar, 0, 0)), 0.7f * tube);
    for (int s = 0; s < 2; ++s) {
        dmg_vec at = s ? axle : rear;
        dmg_save(b);
        dmg_move(b, 0, at.y, at.z);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_use(b, 0);
        dmg_spin(b, s ? fork : 0, s ? "front_wheel" : "rear_wheel", v3(0, 0, 0), v3(0, 0, 1));
        dmg_wheel_draw(b, w.kind, wheel, w.width, 8);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    if (kind == 0)
        draw_cranks(b, bottom, wheel, tube, half);
    else if (dmg_chance(b, 0.6f))
        draw_side_stand(b, wheel, base, tube, half);
}

/* ---- small robots and trolleys on wheels ---- */

/* Draws a wheel behind an upright pin. */
static void draw_caster(dmg_builder* b, float x, float z, float wheel, float top) {
    float turn = dmg_range(b, 0, 6.2f), trail = wheel * dmg_range(b, 0.0f, 0.7f), half = 0.45f * wheel;
    int cover = dmg_int(b, 0, 2);
    dmg_save(b);
    dmg_move(b, x, 0, z);
    dmg_turn(b, v3(0, 1, 0), turn);
    uint32_t fork = dmg_chance(b, 0.85f) ? dmg_spin(b, 0, "caster", v3(0, 0, 0), v3(0, 1, 0)) : 0;
    dmg_rod(b, v3(0, 2.1f * wheel, 0), v3(0, fmaxf(top, 2.3f * wheel), 0), 0.3f * wheel);
    if (cover == 0) dmg_box(b, v3(0, 2.1f * wheel, -0.5f * trail), v3(2.4f * half, 0.25f * wheel, 1.2f * wheel));
    for (int s = -1; s <= 1 && cover == 0; s += 2)
        dmg_beam(b, v3((float)s * half, 2.1f * wheel, -0.5f * trail), v3((float)s * half, wheel, -trail), 0.15f * wheel,
                 0.5f * wheel);
    if (cover == 1) dmg_dome(b, v3(0, 1.1f * wheel, -trail), v3(1.2f * half, 1.1f * wheel, 1.1f * wheel));
    if (cover == 2) dmg_beam(b, v3(0, 2.2f * wheel, 0), v3(0, wheel, -trail), 0.3f * wheel, 0.4f * wheel);
    dmg_move(b, 0, wheel, -trail);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_spin(b, fork, "wheel", v3(0, 0, 0), v3(0, 0, 1));
    if (cover == 2)
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3(0, 0, (float)s * 0.25f * wheel), v3(0, 0, (float)s * 0.75f * wheel), wheel);
    else
        dmg_wheel_draw(b, dmg_int(b, 0, 2), wheel, 1.5f * half, 4);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* True when its top is as wide as it is. */
static bool draw_robot_hull(dmg_builder* b, float width, float length, float floor, float high) {
    int kind = dmg_int(b, 0, 4);
    dmg_vec centre = {0, floor + 0.5f * high, 0};
    if (kind == 0) dmg_box(b, centre, v3(width, high, length));
    if (kind == 1) dmg_rounded_box(b, centre, v3(width, high, length), 0.25f * fminf(width, fminf(high, length)));
    if (kind == 2) dmg_rod(b, v3(0, floor, 0), v3(0, floor + high, 0), 0.5f * fminf(width, length));
    if (kind == 3) {
        const dmg_xy side[] = {{-0.5f * length, floor},
                               {0.5f * length, floor},
                               {0.5f * length, floor + 0.4f * high},
                               {0.25f * length, floor + 0.5f * high},
                               {0.05f * length, floor + high},
                               {-0.5f * length, floor + high}};
        draw_profile(b, side, 6, width);
    }
    if (kind == 4) { /* a shell on a base */
        dmg_box(b, v3(0, floor + 0.15f * high, 0), v3(width, 0.3f * high, length));
        dmg_cone(b, v3(0, floor + 0.3f * high, 0), v3(0, floor + high, 0), 0.45f * fminf(width, length),
                 0.3f * fminf(width, length));
    }
    return kind <= 1;
}

void dmg_build_mobile_robot(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.2f, 1.6f), width = size * dmg_range(b, 0.5f, 0.9f),
          wheel = size * dmg_range(b, 0.06f, 0.2f), floor = wheel * dmg_range(b, 0.3f, 1.3f),
          high = size * dmg_range(b, 0.2f, 1.3f);
    bool flat_top = draw_robot_hull(b, width, size, floor, high);
    axle_wheel w = pick_axle_wheel(b, wheel);
    static const float weights[] = {4, 1.5f, 3};
    w.mount = dmg_weighted(b, weights, 3);
    float x = 0.5f * width + w.width * dmg_range(b, -0.9f, 0.55f), small = wheel * dmg_range(b, 0.3f, 0.6f);
    int layout = dmg_int(b, 0, 2); /* two and casters, four, six */
    for (int s = -1; s <= 1; s += 2) {
        for (int i = 0; i <= layout; ++i)
            draw_wheel_at(b, &w, (float)s * x,
                          layout == 0 ? 0.0f : 0.38f * size * (2.0f * (float)i / (float)layout - 1.0f), 0);
        if (layout == 0) draw_caster(b, (float)s * 0.3f * width, -0.38f * size, small, floor);
    }
    if (layout == 0 && dmg_chance(b, 0.5f)) draw_caster(b, 0, 0.4f * size, small, floor);
    float top = floor + high;
    int extra = dmg_int(b, 0, 4);
    if (extra == 1 && flat_top) { /* a lid */
        dmg_hinge(b, 0, "lid", v3(0, top, -0.4f * size), v3(-1, 0, 0), 0.0f, 1.4f);
        dmg_box_span(b, v3(-0.45f * width, top, -0.4f * size), v3(0.45f * width, top + 0.04f * size, 0.1f * size));
    }
    if (extra == 2) { /* a head */
        dmg_spin(b, 0, "head", v3(0, 0, 0), v3(0, 1, 0));
        if (dmg_chance(b, 0.5f))
            dmg_dome(b, v3(0, top, 0), v3(0.35f * width, 0.3f * width, 0.35f * width));
        else
            dmg_box(b, v3(0, top + 0.15f * width, 0), v3(0.4f * width, 0.3f * width, 0.3f * width));
        dmg_rod(b, v3(0, top - 0.01f * size, 0), v3(0, top + 0.05f * width, 0), 0.15f * width);
    }
    if (extra == 3) { /* a lift */
        dmg_slide(b, 0, "lift", v3(0, 1, 0), 0.0f, 0.3f * size);
        dmg_box(b, v3(0, top + 0.03f * size, 0), v3(0.9f * width, 0.05f * size, 0.9f * size));
        dmg_rod(b, v3(0, top - 0.3f * high, 0), v3(0, top, 0), 0.1f * width);
    }
    if (extra == 4) { /* a screen that nods */
        dmg_rod(b, v3(0, top, 0), v3(0, top + 0.3f * size, 0), 0.03f * size);
        dmg_hinge(b, 0, "screen", v3(0, top + 0.3f * size, 0), v3(1, 0, 0), -0.7f, 0.5f);
        dmg_box(b, v3(0, top + 0.33f * size, 0.03f * size), v3(0.5f * width, 0.25f * size, 0.03f * size));
    }
    dmg_use(b, 0);
}

/* Shelves, beds and tables on casters. */
void dmg_build_trolley(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.25f, 1.2f), length = width * dmg_range(b, 0.5f, 1.6f),
          high = width * dmg_range(b, 0.5f, 2.0f), wheel = width * dmg_range(b, 0.03f, 0.1f),
          post = width * dmg_range(b, 0.015f, 0.05f);
    int shelves = dmg_int(b, 1, 4), rims = dmg_int(b, 0, 1);
    float floor = 2.3f * wheel;
    for (int i = 0; i < 4; ++i) {
        float x = (i % 2 ? 0.47f : -0.47f) * width, z = (i / 2 ? 0.47f : -0.47f) * length;
        dmg_use(b, 0);
        dmg_rod(b, v3(x, floor, z), v3(x, floor + high, z), post);
        draw_caster(b, x, z, wheel, floor);
    }
    for (int i = 0; i < shelves; ++i) {
        float y = floor + high * (shelves == 1 ? 0.98f : 0.05f + 0.93f * (float)i / (float)(shelves - 1));
        dmg_box(b, v3(0, y, 0), v3(width, 1.2f * post, length));
        if (rims) dmg_box(b, v3(0, y + 1.5f * post, 0.49f * length), v3(width, 3 * post, post));
    }
    if (dmg_chance(b, 0.5f)) { /* a handle */
        float z = 0.5f * length, y = floor + 0.95f * high;
        const dmg_vec path[] = {{-0.45f * width, y, z},
                                {-0.42f * width, y + 0.05f * high, z + 0.12f * length},
                                {0.42f * width, y + 0.05f * high, z + 0.12f * length},
                                {0.45f * width, y, z}};
        if (dmg_chance(b, 0.3f)) dmg_hinge(b, 0, "handle", v3(0, y, z), v3(1, 0, 0), -0.3f, 1.2f);
        dmg_sweep(b, path, 4, post, post, false);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.4f)) { /* a leaf that folds down, or a drawer */
        float y = floor + high, t = 1.2f * post;
        if (dmg_chance(b, 0.5f)) {
            dmg_hinge(b, 0, "leaf", v3(0.5f * width, y, 0), v3(0, 0, -1), 0.0f, 1.5f);
            dmg_box(b, v3(0.5f * width + 0.2f * width, y, 0), v3(0.4f * width, t, 0.95f * length));
        } else {
            dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, 0.8f * length);
            dmg_save(b);
            dmg_move(b, 0, y - 0.22f * high, 0.47f * length);
            dmg_tray_draw(b, DMG_TRAY_BOARDS, 0.85f * width, 0.15f * high, 0.9f * length, t);
            dmg_restore(b);
        }
        dmg_use(b, 0);
    }
}
