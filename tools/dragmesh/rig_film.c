/* Pictures of an asset from closed to open. */
#include <math.h>
#include <stdlib.h>

#include "play.h"
#include "render.h"
#include "rig_output.h"

enum { FRAMES = 3, PIXELS = 280, GAP = 6 }; /* pictures of a strip, their side and what is between them; by hand */
enum { DASHES = 5 };                        /* of the line along which a part slides; by hand */
static const double axis_share = 0.7;       /* half the drawn axis, as a share of the part's size; by hand */
static const double side_share =
    0.02;             /* of the size, mean way from which on it says where the camera stands; by hand */
#define FAR_SHARE 0.5 /* of the part's size, that one without limits slides; by hand */

/* Returns the value at which a part counts as open: at its limit; without one, a quarter turn or half its size on. */
static float open_value(const rig_part* part) {
    const bool limited = part->joint.type != DM_JOINT_CONTINUOUS && part->joint.lower < part->joint.upper;
    if (limited) return play_target(&part->joint);
    if (part->joint.type != DM_JOINT_PRISMATIC) return (float)(TWO_PI / 4);
    return (float)(FAR_SHARE * length(sub(vec_of(part->part.box_max), vec_of(part->part.box_min))));
}

/* Writes the poses of all parts, those that carry them included, at a share of the way from rest to open, 0 to 1.
 * out_poses: by part id, 1 and the count of parts. */
static dm_result pose_parts(const rig* rig, float share, dm_pose* out_poses) {
    const dm_pose rest = {.real = {0, 0, 0, 1}};
    const uint32_t count = rig->info.part_count;
    dm_pose* own = cli_alloc(count * sizeof *own);
    dm_result result = DM_OK;
    out_poses[0] = rest;
    for (uint32_t i = 0; i < count && result == DM_OK; i++) {
        const rig_part* part = &rig->parts[i];
        own[i] = rest;
        if (part->part.part_id != 0)
            result = dm_joint_pose(&part->joint, open_value(part) * minimum_jerk(share), &own[i]);
    }
    for (uint32_t i = 0; i < count && result == DM_OK; i++) {
        out_poses[i + 1] = own[i];
        for (uint32_t above = rig->parts[i].part.parent; above != DM_ASSET_NO_PART;
             above = rig->parts[above].part.parent)
            dm_pose_multiply(&own[above], &out_poses[i + 1], &out_poses[i + 1]);
    }
    free(own);
    return result;
}

/* Draws a line in a part's colour: dashed where the part slides along it, else whole. */
static void draw_axis(const renderer* r, uint32_t part_id, vec from, vec to, bool slides, picture* strip) {
    const vec accent = render_accent(part_id);
    const double channels[3] = {accent.x, accent.y, accent.z};
    uint8_t rgb[3];
    for (int i = 0; i < 3; i++) rgb[i] = (uint8_t)(255 * sqrt(channels[i])); /* near sRGB's curve */
    const vec step = scale(sub(to, from), 1.0 / (2 * DASHES - 1));
    for (int i = 0; i < DASHES && slides; i++) {
        const vec start = add(from, scale(step, 2.0 * i));
        render_segment(r, start, add(start, step), rgb, strip, 0);
    }
    if (!slides) render_segment(r, from, to, rgb, strip, 0);
}

/* Draws the lines about which the parts turn and along which they slide. */
static void draw_axes(const renderer* r, const rig* rig, picture* strip) {
    for (uint32_t i = 0; i < rig->info.part_count; i++) {
        const rig_part* part = &rig->parts[i];
        if (part->part.part_id == 0) continue;
        const bool slides = part->joint.type == DM_JOINT_PRISMATIC;
        const vec low = vec_of(part->part.box_min), high = vec_of(part->part.box_max), axis = vec_of(part->joint.axis);
        const vec half = scale(axis, axis_share * length(sub(high, low)));
        vec middle = scale(add(low, high), 0.5);
        if (!slides) { /* the point of the line beside the part's middle */
            const vec origin = vec_of(part->joint.origin);
            middle = add(origin, scale(axis, dot(sub(middle, origin), axis)));
        }
        draw_axis(r, part->part.part_id, sub(middle, half), add(middle, half), slides, strip);
    }
}

/* Returns the way that the surface of the moving parts goes in the mean from rest to `poses`; zero where it is short.
 */
static vec mean_way(const renderer* r, const dm_pose* poses) {
    const dm_mesh_desc* mesh = &r->session->mesh;
    vec sum = {0, 0, 0};
    double area = 0;
    for (uint64_t face = 0; face < mesh->index_count / 3; face++) {
        if (r->face_part[face] == 0) continue;
        vec corner[3];
        for (int i = 0; i < 3; i++)
            corner[i] = vec_at((const float*)mesh->positions +
                               3 * (size_t)((const uint32_t*)mesh->indices)[3 * face + (uint64_t)i]);
        const vec middle = scale(add(add(corner[0], corner[1]), corner[2]), 1.0 / 3);
        const double share = length(cross(sub(corner[1], corner[0]), sub(corner[2], corner[0])));
        const vec moved = render_moved(render_pose(r, poses, 0, r->face_part[face]), middle);
        sum = add(sum, scale(sub(moved, middle), share));
        area += share;
    }
    return length(sum) > side_share * r->size * area ? scale(sum, 1 / area) : (vec){0, 0, 0};
}

static dm_result draw(renderer* r, const rig* rig, picture* strip) {
    const uint32_t count = rig->info.part_count + 1;
    dm_pose* poses = cli_alloc((size_t)FRAMES * count * sizeof *poses);
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < FRAMES && result == DM_OK; i++)
        result = pose_parts(rig, (float)i / (FRAMES - 1), poses + (size_t)i * count);
    const vec way = result == DM_OK ? mean_way(r, poses + (size_t)(FRAMES - 1) * count) : (vec){0, 0, 0};
    if (result == DM_OK) render_aim(r, way, poses, FRAMES, PIXELS, PIXELS);
    for (uint32_t i = 0; i < FRAMES && result == DM_OK; i++)
        result = render_draw(r, poses + (size_t)i * count, strip, (int)i * (PIXELS + GAP));
    if (result == DM_OK) draw_axes(r, rig, strip);
    free(poses);
    return result;
}

static dm_result write_strip(file_set* set, renderer* r, const rig* rig, const char* path) {
    picture strip = picture_new(FRAMES * (PIXELS + GAP) - GAP, PIXELS);
    size_t size;
    dm_result result = draw(r, rig, &strip);
    void* png = result == DM_OK ? picture_encode(&strip, &size) : NULL;
    if (result == DM_OK && png == NULL)
        result = session_fail(set->session, DM_ERROR_OUT_OF_MEMORY, "no memory for the picture");
    if (result == DM_OK) result = file_set_add(set, path, png, size);
    free(png);
    picture_free(&strip);
    return result;
}

dm_result rig_write_film(file_set* set, const rig* rig, char up, const char* path) {
    session* session = set->session;
    session_release_object(session);
    dm_result result = dm_asset_make_object(session->context, rig->asset, &session->object);
    if (result != DM_OK) return result;
    renderer renderer;
    result = render_open_parts(&renderer, session, up, rig_face_parts(session, rig), rig->info.part_count + 1);
    renderer.grid = 1; /* quick: a fourth of the rays */
    renderer.sky_rays = 3;
    if (result == DM_OK) result = write_strip(set, &renderer, rig, path);
    render_close(&renderer);
    return result;
}
