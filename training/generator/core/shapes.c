/* Implements the builder's shapes: boxes, turned bodies, tubes along a path, extruded outlines. */
#include <string.h>

#include "core/build.h"

enum { OUTLINE_LIMIT = 128 };

/* ---- boxes ---- */

void dmg_box_faces(dmg_builder* b, dmg_vec centre, dmg_vec size, int faces) {
    static const int corners[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    uint32_t v[8];
    dmg_piece_begin(b);
    for (int i = 0; i < 8; ++i) {
        dmg_vec offset = v3(i & 1 ? 0.5f * size.x : -0.5f * size.x, i & 2 ? 0.5f * size.y : -0.5f * size.y,
                            i & 4 ? 0.5f * size.z : -0.5f * size.z);
        v[i] = dmg_vertex(b, v3_add(centre, offset));
    }
    for (int f = 0; f < 6; ++f) {
        const int* c = corners[f];
        if (faces & (1 << f)) dmg_quad(b, v[c[0]], v[c[1]], v[c[2]], v[c[3]]);
    }
}

void dmg_box(dmg_builder* b, dmg_vec centre, dmg_vec size) {
    dmg_box_faces(b, centre, size, DMG_FACE_ALL);
}

void dmg_box_span(dmg_builder* b, dmg_vec low, dmg_vec high) {
    dmg_box(b, v3_lerp(low, high, 0.5f), v3_sub(high, low));
}

/* Draws a band of quads between two rows of equally many vertices; `from` below, counter-clockwise seen from above. */
static void band(dmg_builder* b, uint32_t from, uint32_t to, int count, bool closed) {
    for (int i = 0; i + (closed ? 0 : 1) < count; ++i) {
        uint32_t next = (uint32_t)((i + 1) % count), here = (uint32_t)i;
        dmg_quad(b, from + here, from + next, to + next, to + here);
    }
}

/* A sphere whose eight octants are pulled apart to the corners of the box. */
void dmg_rounded_box(dmg_builder* b, dmg_vec centre, dmg_vec size, float radius) {
    enum { STEPS = 3, ROUND = 4 * STEPS, ROWS = 2 * STEPS };
    dmg_vec inner = v3_scale(v3_sub(size, v3(2 * radius, 2 * radius, 2 * radius)), 0.5f);
    inner = v3(fmaxf(inner.x, 0), fmaxf(inner.y, 0), fmaxf(inner.z, 0));
    uint32_t previous = 0;
    dmg_piece_begin(b);
    for (int row = 0; row < ROWS; ++row) {
        float side = row < STEPS ? -1.0f : 1.0f;
        float latitude = 0.5f * DMG_PI * ((float)(row % STEPS) / (STEPS - 1) + (row < STEPS ? -1.0f : 0.0f));
        uint32_t first = b->vertex_count;
        for (int i = 0; i < ROUND; ++i) {
            float quarter = (float)(i / STEPS), angle = 0.5f * DMG_PI * (quarter + (float)(i % STEPS) / (STEPS - 1));
            float diagonal = 0.5f * DMG_PI * (quarter + 0.5f), ring = radius * cosf(latitude);
            dmg_vec corner =
                v3(copysignf(inner.x, cosf(diagonal)), side * inner.y, copysignf(inner.z, -sinf(diagonal)));
            dmg_vec offset = v3(ring * cosf(angle), radius * sinf(latitude), -ring * sinf(angle));
            dmg_vertex(b, v3_add(centre, v3_add(corner, offset)));
        }
        if (row > 0) band(b, previous, first, ROUND, true);
        previous = first;
    }
    uint32_t bottom = previous - (uint32_t)((ROWS - 1) * ROUND);
    dmg_quad(b, bottom, bottom + 3 * STEPS, bottom + 2 * STEPS, bottom + STEPS);
    dmg_quad(b, previous, previous + STEPS, previous + 2 * STEPS, previous + 3 * STEPS);
}

void dmg_beam(dmg_builder* b, dmg_vec from, dmg_vec to, float width, float height) {
    dmg_vec along = v3_normalize(v3_sub(to, from)), across, up;
    across = v3_cross(v3(0, 1, 0), along);
    if (v3_length(across) < 1e-3f) across = v3(1, 0, 0);
    across = v3_normalize(across);
    up = v3_cross(along, across);
    across = v3_scale(across, 0.5f * width);
    up = v3_scale(up, 0.5f * height);
    dmg_vec ends[2] = {from, to};
    uint32_t v[8];
    dmg_piece_begin(b);
    for (int i = 0; i < 8; ++i) {
        dmg_vec corner = v3_mad(ends[i / 4], across, i % 4 == 0 || i % 4 == 3 ? -1.0f : 1.0f);
        v[i] = dmg_vertex(b, v3_mad(corner, up, i % 4 < 2 ? -1.0f : 1.0f));
    }
    for (int i = 0; i < 4; ++i) dmg_quad(b, v[i], v[(i + 1) % 4], v[4 + (i + 1) % 4], v[4 + i]);
    dmg_quad(b, v[3], v[2], v[1], v[0]);
    dmg_quad(b, v[4], v[5], v[6], v[7]);
}

/* ---- turned bodies ---- */

void dmg_lathe_arc(dmg_builder* b, dmg_vec origin, dmg_vec axis, const dmg_xy* profile, int count, float start,
                   float arc) {
    dmg_vec u, w;
    axis = v3_normalize(axis);
    v3_basis(axis, &u, &w);
    bool closed = arc >= 2.0f * DMG_PI - 1e-4f;
    int steps = (int)ceilf((float)b->sides * arc / (2.0f * DMG_PI));
    steps = steps < 2 ? 2 : steps;
    int columns = closed ? steps : steps + 1;
    uint32_t previous = 0;
    bool previous_point = false;
    dmg_piece_begin(b);
    for (int row = 0; row < count; ++row) {
        dmg_vec centre = v3_mad(origin, axis, profile[row].y);
        bool point = profile[row].x == 0.0f;
        uint32_t first = b->vertex_count;
        for (int i = 0; i < (point ? 1 : columns); ++i) {
            float angle = start + arc * (float)i / (float)steps;
            dmg_vec offset = v3_add(v3_scale(u, cosf(angle)), v3_scale(w, sinf(angle)));
            dmg_vertex(b, v3_mad(centre, offset, profile[row].x));
        }
        for (int i = 0; row > 0 && i + (closed ? 0 : 1) < columns; ++i) {
            uint32_t here = (uint32_t)i, next = (uint32_t)((i + 1) % columns);
            if (point && !previous_point) dmg_triangle(b, previous + here, previous + next, first);
            if (previous_point && !point) dmg_triangle(b, previous, first + next, first + here);
            if (!point && !previous_point) dmg_quad(b, previous + here, previous + next, first + next, first + here);
        }
        previous = first;
        previous_point = point;
    }
}

void dmg_lathe(dmg_builder* b, dmg_vec origin, dmg_vec axis, const dmg_xy* profile, int count) {
    dmg_lathe_arc(b, origin, axis, profile, count, 0.0f, 2.0f * DMG_PI);
}

void dmg_cone(dmg_builder* b, dmg_vec from, dmg_vec to, float radius_from, float radius_to) {
    float length = v3_length(v3_sub(to, from));
    const dmg_xy profile[4] = {{0, 0}, {radius_from, 0}, {radius_to, length}, {0, length}};
    int first = radius_from > 0.0f ? 0 : 1, last = radius_to > 0.0f ? 3 : 2;
    dmg_lathe(b, from, v3_sub(to, from), profile + first, last - first + 1);
}

void dmg_rod(dmg_builder* b, dmg_vec from, dmg_vec to, float radius) {
    dmg_cone(b, from, to, radius, radius);
}

void dmg_capsule(dmg_builder* b, dmg_vec from, dmg_vec to, float radius) {
    enum { CAP = 4 };
    float length = v3_length(v3_sub(to, from));
    dmg_xy profile[2 * CAP];
    for (int i = 0; i < CAP; ++i) {
        float angle = 0.5f * DMG_PI * (float)i / (CAP - 1), out = i == CAP - 1 ? radius : radius * sinf(angle);
        profile[i] = (dmg_xy){out, -radius * cosf(angle)};
        profile[2 * CAP - 1 - i] = (dmg_xy){out, length + radius * cosf(angle)};
    }
    dmg_lathe(b, from, v3_sub(to, from), profile, 2 * CAP);
}

/* Latitudes from `low` to `high` (rad). */
static void ellipsoid(dmg_builder* b, dmg_vec centre, dmg_vec radii, float low, float high) {
    enum { ROWS = 6 };
    dmg_xy profile[ROWS + 1];
    for (int i = 0; i <= ROWS; ++i) {
        float latitude = low + (high - low) * (float)i / ROWS;
        bool pole = fabsf(latitude) > 0.5f * DMG_PI - 1e-3f;
        profile[i].x = pole ? 0.0f : cosf(latitude);
        profile[i].y = sinf(latitude);
    }
    dmg_save(b);
    dmg_move(b, centre.x, centre.y, centre.z);
    dmg_frame* frame = &b->frames[b->frame_depth];
    frame->column[0] = v3_scale(frame->column[0], radii.x);
    frame->column[1] = v3_scale(frame->column[1], radii.y);
    frame->column[2] = v3_scale(frame->column[2], radii.z);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, ROWS + 1);
    dmg_restore(b);
}

void dmg_ellipsoid(dmg_builder* b, dmg_vec centre, dmg_vec radii) {
    ellipsoid(b, centre, radii, -0.5f * DMG_PI, 0.5f * DMG_PI);
}

void dmg_dome(dmg_builder* b, dmg_vec base, dmg_vec radii) {
    ellipsoid(b, base, radii, 0.0f, 0.5f * DMG_PI);
}

void dmg_torus(dmg_builder* b, dmg_vec centre, dmg_vec axis, float radius, float tube) {
    enum { AROUND = 8 };
    dmg_xy profile[AROUND + 1];
    for (int i = 0; i <= AROUND; ++i) {
        float angle = 2.0f * DMG_PI * (float)(i % AROUND) / AROUND;
        profile[i].x = radius + tube * cosf(angle);
        profile[i].y = tube * sinf(angle);
    }
    dmg_lathe(b, centre, axis, profile, AROUND + 1);
}

/* ---- tubes ---- */

/* Direction of the path at a point: along the two segments that meet there. */
static dmg_vec path_direction(const dmg_vec* path, int count, int i, bool closed) {
    int before = i > 0 ? i - 1 : (closed ? count - 1 : 0);
    int after = i + 1 < count ? i + 1 : (closed ? 0 : count - 1);
    dmg_vec in = v3_normalize(v3_sub(path[i], path[before])), out = v3_normalize(v3_sub(path[after], path[i]));
    dmg_vec sum = v3_add(in, out);
    return v3_normalize(v3_length(sum) > 1e-4f ? sum : out);
}

void dmg_sweep(dmg_builder* b, const dmg_vec* path, int count, float across, float along, bool closed) {
    int sides = b->sides < 12 ? 6 : 8;
    dmg_vec tangent = path_direction(path, count, 0, closed), u, w;
    v3_basis(tangent, &u, &w);
    /* Begin with u in the plane of the path, when the path has one. */
    for (int i = 2; i < count; ++i) {
        dmg_vec normal = v3_cross(v3_sub(path[1], path[0]), v3_sub(path[i], path[0]));
        if (v3_length(normal) < 1e-8f) continue;
        w = v3_normalize(v3_mad(normal, tangent, -v3_dot(normal, tangent)));
        u = v3_cross(w, tangent);
        break;
    }
    uint32_t first = b->vertex_count;
    dmg_piece_begin(b);
    for (int i = 0; i < count; ++i) {
        dmg_vec direction = path_direction(path, count, i, closed);
        u = v3_normalize(v3_mad(u, direction, -v3_dot(u, direction)));
        w = v3_cross(direction, u);
        for (int k = 0; k < sides; ++k) {
            float angle = 2.0f * DMG_PI * ((float)k + 0.5f) / (float)sides;
            dmg_vec offset = v3_add(v3_scale(u, across * cosf(angle)), v3_scale(w, along * sinf(angle)));
            dmg_vertex(b, v3_add(path[i], offset));
        }
    }
    uint32_t step = (uint32_t)sides, last = first + (uint32_t)(count - 1) * step;
    for (int i = 0; i + 1 < count; ++i)
        band(b, first + (uint32_t)i * step, first + (uint32_t)(i + 1) * step, sides, true);
    if (closed) band(b, last, first, sides, true);
    for (uint32_t k = 1; !closed && k + 1 < step; ++k) {
        dmg_triangle(b, first, first + k + 1, first + k);
        dmg_triangle(b, last, last + k, last + k + 1);
    }
}

/* ---- extruded outlines ---- */

static float cross2(dmg_xy a, dmg_xy c, dmg_xy d) {
    return (c.x - a.x) * (d.y - a.y) - (c.y - a.y) * (d.x - a.x);
}

static bool is_ear(const dmg_xy* polygon, const int* ring, int count, int at) {
    int i = ring[(at + count - 1) % count], j = ring[at], k = ring[(at + 1) % count];
    if (cross2(polygon[i], polygon[j], polygon[k]) <= 0.0f) return false;
    for (int n = 0; n < count; ++n) {
        int p = ring[n];
        if (p == i || p == j || p == k) continue;
        if (cross2(polygon[i], polygon[j], polygon[p]) >= 0.0f && cross2(polygon[j], polygon[k], polygon[p]) >= 0.0f &&
            cross2(polygon[k], polygon[i], polygon[p]) >= 0.0f) {
            return false;
        }
    }
    return true;
}

/* Ear clipping of both caps: vertices low.. and high.. in polygon order. */
static void cap(dmg_builder* b, const dmg_xy* polygon, int count, uint32_t low, uint32_t high) {
    int ring[OUTLINE_LIMIT], left = count, at = 0, misses = 0;
    for (int i = 0; i < count; ++i) ring[i] = i;
    while (left >= 3 && misses <= left) {
        at %= left;
        /* A degenerate outline has no ear left: cut anyway, so that the cap stays closed. */
        if (!is_ear(polygon, ring, left, at) && misses < left) {
            ++misses;
            ++at;
            continue;
        }
        uint32_t i = (uint32_t)ring[(at + left - 1) % left], j = (uint32_t)ring[at],
                 k = (uint32_t)ring[(at + 1) % left];
        dmg_triangle(b, high + i, high + j, high + k);
        dmg_triangle(b, low + k, low + j, low + i);
        memmove(ring + at, ring + at + 1, (size_t)(left - at - 1) * sizeof *ring);
        --left;
        misses = 0;
    }
}

/* Draws one row of vertices: an outline at height z. */
static uint32_t outline(dmg_builder* b, const dmg_xy* polygon, int count, float z) {
    uint32_t first = b->vertex_count;
    for (int i = 0; i < count; ++i) dmg_vertex(b, v3(polygon[i].x, polygon[i].y, z));
    return first;
}

void dmg_extrude(dmg_builder* b, const dmg_xy* polygon, int count, float low, float high) {
    if (count > OUTLINE_LIMIT) {
        b->failed = true;
        return;
    }
    dmg_piece_begin(b);
    uint32_t bottom = outline(b, polygon, count, low), over = outline(b, polygon, count, high);
    band(b, bottom, over, count, true);
    cap(b, polygon, count, bottom, over);
}

void dmg_ring_plate(dmg_builder* b, const dmg_xy* outer, const dmg_xy* inner, int count, float low, float high) {
    dmg_piece_begin(b);
    uint32_t ol = outline(b, outer, count, low), oh = outline(b, outer, count, high);
    uint32_t il = outline(b, inner, count, low), ih = outline(b, inner, count, high);
    band(b, ol, oh, count, true);
    band(b, ih, il, count, true);
    band(b, oh, ih, count, true);
    band(b, il, ol, count, true);
}

void dmg_loft(dmg_builder* b, const dmg_xy* outline, int count, const dmg_row* rows, int row_count) {
    uint32_t previous = 0;
    dmg_piece_begin(b);
    for (int r = 0; r < row_count; ++r) {
        const dmg_row* row = &rows[r];
        uint32_t first = b->vertex_count;
        for (int i = 0; i < count; ++i) {
            dmg_vertex(b, v3(outline[i].x * row->scale_x, outline[i].y * row->scale_y + row->shift_y, row->height));
        }
        if (r > 0) band(b, previous, first, count, true);
        previous = first;
    }
    uint32_t begin = previous - (uint32_t)((row_count - 1) * count);
    for (uint32_t i = 1; i + 1 < (uint32_t)count; ++i) {
        dmg_triangle(b, begin, begin + i + 1, begin + i);
        dmg_triangle(b, previous, previous + i, previous + i + 1);
    }
}

void dmg_rounded_plate(dmg_builder* b, float width, float height, float thickness, float radius) {
    enum { STEPS = 4 };
    dmg_xy polygon[4 * STEPS];
    radius = fminf(radius, 0.49f * fminf(width, height));
    for (int i = 0; i < 4 * STEPS; ++i) {
        float angle = 0.5f * DMG_PI * ((float)(i / STEPS) + (float)(i % STEPS) / (STEPS - 1));
        float diagonal = 0.5f * DMG_PI * ((float)(i / STEPS) + 0.5f);
        polygon[i].x = copysignf(0.5f * width - radius, cosf(diagonal)) + radius * cosf(angle);
        polygon[i].y = copysignf(0.5f * height - radius, sinf(diagonal)) + radius * sinf(angle);
    }
    dmg_extrude(b, polygon, 4 * STEPS, -thickness, 0.0f);
}

void dmg_bent_plate(dmg_builder* b, const dmg_xy* line, int count, float thickness, float depth) {
    dmg_xy polygon[OUTLINE_LIMIT];
    if (count < 2 || count > OUTLINE_LIMIT / 2) {
        b->failed = true;
        return;
    }
    for (int i = 0; i < count; ++i) {
        int before = i > 0 ? i - 1 : 0, after = i + 1 < count ? i + 1 : count - 1;
        dmg_vec along = v3_normalize(v3(line[after].x - line[before].x, line[after].y - line[before].y, 0));
        float nx = -along.y * 0.5f * thickness, ny = along.x * 0.5f * thickness;
        polygon[i].x = line[i].x - nx;
        polygon[i].y = line[i].y - ny;
        polygon[2 * count - 1 - i].x = line[i].x + nx;
        polygon[2 * count - 1 - i].y = line[i].y + ny;
    }
    dmg_extrude(b, polygon, 2 * count, -0.5f * depth, 0.5f * depth);
}
