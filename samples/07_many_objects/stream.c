/* The props around the camera. */
#include "stream.h"

#include <math.h>
#include <stdlib.h>

#include "kinds.h"

enum {
    MOST_OUT = 16,  /* props that go in a frame */
    DROP_FRAMES = 8 /* a kind that nobody needs goes when there is time, or after so many frames */
};
#define MARGIN 4.0f /* m beyond the reach until a prop goes: who stands at the edge does not make it come and go */

bool stream_open(stream* s, const char* const* files, uint32_t file_count) {
    s->kind_count = file_count + 1;
    for (uint32_t i = 0; i < s->kind_count; i++)
        s->kinds[i] = (kind){.owner = s, .path = i < file_count ? files[i] : NULL, .counted = true};
    s->placed = calloc(s->level->prop_count, sizeof *s->placed);
    s->prop_of = calloc(s->level->prop_count, sizeof *s->prop_of);
    return s->placed != NULL && s->prop_of != NULL;
}

void stream_close(stream* s) {
    for (uint32_t i = 0; i < s->kind_count; i++) free(s->kinds[i].bytes);
    free(s->placed);
    free(s->prop_of);
}

static float distance_to(const prop* p, float x, float z) {
    return hypotf(p->x - x, p->z - z);
}

/* ---- parts ---- */

/* Returns the part that carries one; 0: the body does. */
static uint32_t carrier_of(const kind* k, uint32_t part) {
    for (uint32_t i = 0; i < k->part_count; i++)
        if (k->parts[i].id == part) return k->parts[i].parent;
    return 0;
}

dm_result stream_move(stream* s, uint32_t prop, uint32_t part, const dm_pose* pose) {
    const struct prop* p = &s->level->props[prop];
    const kind* k = &s->kinds[p->kind];
    dm_result result = dm_scene_move(s->context, s->scene, p->instance, part, pose);
    for (uint32_t i = 0; i < k->part_count && result == DM_OK; i++) {
        uint32_t above = k->parts[i].parent;
        while (above != 0 && above != part) above = carrier_of(k, above);
        if (above == part) result = dm_scene_move(s->context, s->scene, p->instance, k->parts[i].id, pose);
    }
    return result;
}

/* ---- props ---- */

static void remove_prop(stream* s, uint32_t at) {
    const uint32_t index = s->placed[at];
    prop* p = &s->level->props[index];
    s->leaves(s->user, index);
    dm_scene_remove(s->context, s->scene, p->instance);
    p->placed = false;
    s->kinds[p->kind].placed--;
    s->placed[at] = s->placed[--s->placed_count];
    s->counts.removed++;
}

/* Places a prop as the player has left it. */
static void place_prop(stream* s, uint32_t index) {
    prop* p = &s->level->props[index];
    kind* k = &s->kinds[p->kind];
    p->place = level_place(p, k->info.box_min.y);
    if (dm_scene_add(s->context, s->scene, k->object, &p->place, &p->instance) != DM_OK) return;
    p->placed = true;
    k->placed++;
    s->placed[s->placed_count++] = index;
    s->prop_of[p->instance] = index;
    s->counts.placed++;
    for (uint32_t i = 0; i < k->part_count; i++) {
        const kept_part* kept = level_kept(s->level, index, k->parts[i].id);
        if (kept == NULL) continue;
        stream_move(s, index, kept->part, &kept->state.pose);
        s->counts.restored++;
    }
}

/* ---- a frame ---- */

/* Takes out what is far, some in each frame. */
static void take_out(stream* s, float x, float z) {
    uint32_t left = MOST_OUT;
    for (uint32_t at = s->placed_count; at-- > 0 && left > 0;) {
        if (distance_to(&s->level->props[s->placed[at]], x, z) <= s->reach + MARGIN) continue;
        remove_prop(s, at);
        left--;
    }
}

/* Brings in the props of a ring of the grid around the camera's place, `ring` steps away. Returns whether the time is
 * over; adds those that have to wait to *missing. */
static bool bring_ring(stream* s, float x, float z, int ring, double deadline, bool over, uint32_t* missing) {
    const int middle = (int)(-z / PITCH);
    for (int row = middle - ring; row <= middle + ring; row++) {
        for (int column = 0; column < COLUMNS && row >= 0; column++) {
            const int across = column / 2, along = abs(row - middle);
            if ((across > along ? across : along) != ring) continue;
            const uint32_t index = (uint32_t)row * COLUMNS + (uint32_t)column;
            if (index >= s->level->prop_count) continue;
            const prop* p = &s->level->props[index];
            const float distance = distance_to(p, x, z);
            if (distance > s->reach) continue;
            kind* k = &s->kinds[p->kind];
            k->wanted_when = s->frame;
            if (p->placed || (k->counted && atomic_load(&k->state) == KIND_FAILED)) continue;
            kind_request(k);
            if (!over && k->counted && atomic_load(&k->state) == KIND_HERE) {
                place_prop(s, index);
                over = wall_us() > deadline;
            }
            if (p->placed) continue;
            ++*missing;
            s->counts.late += distance < 0.5f * s->reach;
        }
    }
    return over;
}

uint32_t stream_step(stream* s, float x, float z, double deadline) {
    const int rings = (int)(s->reach / PITCH) + 1;
    uint32_t missing = 0;
    bool over = false;
    s->frame++;
    kinds_notice(s);
    take_out(s, x, z);
    for (int ring = 0; ring <= rings; ring++) over = bring_ring(s, x, z, ring, deadline, over, &missing);
    if (!over || s->frame % DROP_FRAMES == 0) kinds_drop_one(s);
    return missing;
}
