/* Pictures of an asset from closed to open. */
#include <stdlib.h>

#include "render.h"
#include "rig.h"

enum { FRAMES = 3, PIXELS = 280, GAP = 6 }; /* pictures of a strip, their side and what is between them; by hand */
static const double axis_share = 0.7;       /* half the drawn axis, as a share of the part's size; by hand */
static const uint8_t blue[3] = {70, 150, 255}, orange[3] = {255, 150, 40};

/* Draws where the parts turn, blue, and the way they slide, orange. */
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
        render_segment(r, sub(middle, half), add(middle, half), slides ? orange : blue, strip, 0);
    }
}

static dm_result draw(renderer* r, const rig* rig, picture* strip) {
    const uint32_t count = rig->info.part_count + 1;
    dm_pose* poses = cli_alloc((size_t)FRAMES * count * sizeof *poses);
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < FRAMES && result == DM_OK; i++)
        result = rig_pose(rig, (float)i / (FRAMES - 1), poses + (size_t)i * count);
    if (result == DM_OK) render_aim(r, (vec){0, 0, 0}, poses, FRAMES, PIXELS, PIXELS);
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
