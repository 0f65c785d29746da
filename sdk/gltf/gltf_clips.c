/* Reads animations, node by node. A clip is how the node's local transform moves it from where the file has it, in the
 * frame of the scene. The nodes above it stand still, so that the drawer of a moving cabinet only slides. */
#include "gltf/gltf_asset.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gltf/gltf_accessor.h"
#include "gltf/gltf_tree.h"

enum { TRANSLATION, ROTATION, SCALE, PATHS };
enum { COLUMN = DMI_GLTF_COLUMN, ORIGIN = DMI_GLTF_ORIGIN };
enum { SPLINE_STEPS = 8 }; /* samples between two keys of a spline; by hand */
#define NO_CHANNEL UINT32_MAX

/* How far the columns of a rigid motion may be off unit length and right angles: float keys are off by 1e-6. By hand.
 */
#define SHAPE_ERROR 1e-3
/* Share of a turn, and of the node's distance from the origin, below which a clip leaves the node where it is. By hand:
 * some steps of a float. */
#define STILL 1e-6

static const char* const path_names[PATHS] = {"translation", "rotation", "scale"};

typedef struct channel {
    dmi_gltf_sampler sampler;
    int path;
    uint32_t node, next; /* next: next channel of the same node; NO_CHANNEL: none */
} channel;

/* What is needed to read the animations one after the other. */
typedef struct reader {
    dm_gltf* gltf;
    dmi_gltf_asset* asset;
    dmi_arena scratch;
    uint32_t* firsts; /* per node of the file: its first channel */
    channel* channels;
    uint32_t channel_count;
} reader;

/* Translation, rotation and scale. */
typedef struct transform {
    double parts[PATHS][4];
} transform;

/* ---- the rest ---- */

/* Splits a node's transform at rest into its parts, also one that the file gives as a matrix. */
static void read_rest(const cJSON* node, transform* out) {
    double m[16];
    *out = (transform){{{0, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}}};
    if (!dmi_json_numbers(node, "matrix", 16, m)) {
        dmi_json_numbers(node, "translation", 3, out->parts[TRANSLATION]);
        dmi_json_numbers(node, "rotation", 4, out->parts[ROTATION]);
        dmi_json_numbers(node, "scale", 3, out->parts[SCALE]);
        dmi_gltf_normalize(out->parts[ROTATION]);
        return;
    }
    const double sign = dmi_gltf_determinant(m) < 0 ? -1 : 1;
    memcpy(out->parts[TRANSLATION], m + ORIGIN, 3 * sizeof *m);
    for (int k = 0; k < 3; k++) out->parts[SCALE][k] = sign * dmi_gltf_length(m + (size_t)COLUMN * (size_t)k);
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++)
            m[COLUMN * column + row] *= out->parts[SCALE][column] != 0 ? 1 / out->parts[SCALE][column] : 0;
    dmi_gltf_to_quaternion(m, out->parts[ROTATION]);
}

/* ---- times ---- */

static int compare_floats(const void* a, const void* b) {
    const float x = *(const float*)a, y = *(const float*)b;
    return (x > y) - (x < y);
}

static uint64_t count_times(const dmi_gltf_sampler* s) {
    return s->interpolation == DMI_GLTF_CUBIC ? (s->times.count - 1) * SPLINE_STEPS + 1 : s->times.count;
}

static float* add_times(const dmi_gltf_sampler* s, float* out) {
    const uint64_t steps = s->interpolation == DMI_GLTF_CUBIC ? SPLINE_STEPS : 1;
    for (uint64_t i = 0; i < s->times.count; i++) {
        const double at = dmi_gltf_sample_time(s, i);
        const double next = i + 1 < s->times.count ? dmi_gltf_sample_time(s, i + 1) : at;
        for (uint64_t k = 0; k < (i + 1 < s->times.count ? steps : 1); k++)
            *out++ = (float)(at + (next - at) * (double)k / (double)steps);
    }
    return out;
}

/* Writes the times of all keys of the node's channels, in order and each once. */
static dm_result list_times(reader* r, uint32_t first, float** out, uint32_t* out_count, dmi_gltf_problem* problem) {
    uint64_t most = 0, count = 0;
    for (uint32_t c = first; c != NO_CHANNEL; c = r->channels[c].next) most += count_times(&r->channels[c].sampler);
    if (most > DM_MAX_ELEMENTS)
        return dmi_gltf_refuse(problem, DM_ERROR_TOO_LARGE, "glTF: an animation has more than %d keys",
                               DM_MAX_ELEMENTS);
    float* times = dmi_gltf_push(r->gltf, &r->asset->arena, most, sizeof *times, problem);
    if (!times) return problem->code;
    float* end = times;
    for (uint32_t c = first; c != NO_CHANNEL; c = r->channels[c].next) end = add_times(&r->channels[c].sampler, end);
    qsort(times, (size_t)(end - times), sizeof *times, compare_floats);
    for (const float* at = times; at < end; at++)
        if (count == 0 || *at > times[count - 1]) times[count++] = *at;
    *out = times;
    *out_count = (uint32_t)count;
    return DM_OK;
}

/* ---- clips ---- */

/* What moves a node from its rest to a sample: scene frame = above x (local x inverse rest) x inverse above. */
typedef struct mover {
    transform rest;
    double above[16], below[16]; /* the product inverse rest x inverse above is `below` */
    double at[3];                /* where the node is at rest, in the merged mesh's frame */
} mover;

static bool open_mover(const dm_gltf* gltf, uint32_t node, mover* out) {
    static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const dmi_gltf_tree_node* tree = &gltf->tree[node];
    double local[16], whole[16];
    read_rest(tree->json, &out->rest);
    memcpy(out->above, tree->parent >= 0 ? gltf->tree[tree->parent].world : identity, sizeof identity);
    dmi_gltf_compose(out->rest.parts[TRANSLATION], out->rest.parts[ROTATION], out->rest.parts[SCALE], local);
    dmi_gltf_multiply(out->above, local, whole);
    for (int k = 0; k < 3; k++) out->at[k] = whole[ORIGIN + k] - gltf->origin[k];
    return dmi_gltf_invert(whole, out->below);
}

/* Writes the pose to which the channels have moved the node at a time. Returns whether it is a rigid motion. */
static bool find_pose(const reader* r, uint32_t first, const mover* mover, double time, dm_pose* out) {
    transform now = mover->rest;
    double local[16], half[16], m[16], q[4], t[3];
    for (uint32_t c = first; c != NO_CHANNEL; c = r->channels[c].next)
        dmi_gltf_sample(&r->channels[c].sampler, time, now.parts[r->channels[c].path]);
    dmi_gltf_compose(now.parts[TRANSLATION], now.parts[ROTATION], now.parts[SCALE], local);
    dmi_gltf_multiply(mover->above, local, half);
    dmi_gltf_multiply(half, mover->below, m);
    const double* origin = r->gltf->origin;
    for (int row = 0; row < 3; row++) /* the place that the node has come to */
        t[row] = half[ORIGIN + row] - origin[row];
    const bool rigid = dmi_gltf_straighten(m) <= SHAPE_ERROR;
    if (!rigid && !(fabs(dmi_gltf_determinant(m) - 1) < SHAPE_ERROR))
        memcpy(m, (double[16]){1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, sizeof m);
    for (int row = 0; row < 3; row++)
        t[row] -= m[row] * mover->at[0] + m[COLUMN + row] * mover->at[1] + m[2 * COLUMN + row] * mover->at[2];
    dmi_gltf_to_quaternion(m, q);
    for (int k = 0; k < 4; k++) out->real[k] = (float)q[k];
    out->dual[0] = (float)((t[0] * q[3] + t[1] * q[2] - t[2] * q[1]) / 2);
    out->dual[1] = (float)((t[1] * q[3] + t[2] * q[0] - t[0] * q[2]) / 2);
    out->dual[2] = (float)((t[2] * q[3] + t[0] * q[1] - t[1] * q[0]) / 2);
    out->dual[3] = (float)(-(t[0] * q[0] + t[1] * q[1] + t[2] * q[2]) / 2);
    return rigid;
}

static bool is_finite(const dm_pose* pose) {
    float sum = 0;
    for (int k = 0; k < 4; k++) sum += fabsf(pose->real[k]) + fabsf(pose->dual[k]);
    return isfinite(sum);
}

static bool is_still(const dm_pose* pose, const mover* mover) {
    const double distance = fabs(mover->at[0]) + fabs(mover->at[1]) + fabs(mover->at[2]);
    double turn = 0, way = 0;
    for (int k = 0; k < 3; k++) turn = fmax(turn, fabs((double)pose->real[k]));
    for (int k = 0; k < 4; k++) way = fmax(way, fabs((double)pose->dual[k]));
    return turn < STILL && way < STILL * (1 + distance);
}

/* Fills the poses of a clip. Returns whether the clip counts: it moves the node, and all of it is finite. */
static bool fill_poses(const reader* r, uint32_t first, const mover* mover, dm_asset_clip* clip, dm_pose* poses) {
    bool moves = false, finite = true;
    for (uint32_t k = 0; k < clip->key_count; k++) {
        if (!find_pose(r, first, mover, (double)clip->times[k], &poses[k])) clip->flags |= DM_CLIP_NOT_RIGID;
        moves |= !is_still(&poses[k], mover);
        finite &= is_finite(&poses[k]);
    }
    clip->poses = poses;
    return finite && (moves || clip->flags != 0);
}

/* Makes the clip of one node from the channels from `first` on. out_says: whether the clip counts. */
static dm_result make_clip(reader* r, uint32_t node, const char* name, dm_asset_clip* out, bool* out_says,
                           dmi_gltf_problem* problem) {
    mover mover;
    float* times = NULL;
    *out = (dm_asset_clip){.name = name};
    *out_says = false;
    if (!open_mover(r->gltf, node, &mover)) return DM_OK;
    const dm_result result = list_times(r, r->firsts[node], &times, &out->key_count, problem);
    if (result != DM_OK) return result;
    dm_pose* poses = dmi_gltf_push(r->gltf, &r->asset->arena, out->key_count, sizeof *poses, problem);
    if (!poses) return problem->code;
    out->times = times;
    *out_says = fill_poses(r, r->firsts[node], &mover, out, poses);
    return dmi_gltf_tell(r->gltf, 0, out->key_count, problem);
}

/* ---- animations ---- */

static int find_path(const char* name) {
    for (int path = 0; name && path < PATHS; path++)
        if (strcmp(name, path_names[path]) == 0) return path;
    return PATHS;
}

/* Returns whether a node of the file is in the list, so that its clips have a place. */
static bool is_listed(const reader* r, int64_t node) {
    if (node < 0 || r->asset->places[node] == DM_ASSET_NO_NODE) return false;
    return !(r->asset->nodes[r->asset->places[node]].flags & DM_ASSET_NODE_FOLLOWS);
}

/* Reads a channel that moves a node of the asset. */
static dm_result read_channel(reader* r, const cJSON* json, const cJSON** samplers, uint32_t sampler_count,
                              const char* place, dmi_gltf_problem* problem) {
    const cJSON* target = dmi_json_get(json, "target");
    const double index = dmi_json_number(json, "sampler", DMI_GLTF_NO_INDEX);
    const int path = find_path(dmi_json_text(target, "path"));
    const int64_t node =
        dmi_gltf_position(&r->gltf->document, DMI_GLTF_NODES, dmi_json_number(target, "node", DMI_GLTF_NO_INDEX));
    channel* c = &r->channels[r->channel_count];
    dmi_gltf_problem here = {.code = DM_OK};
    if (path == PATHS || !is_listed(r, node)) return DM_OK;
    const bool exists = index >= 0 && index < sampler_count && index == floor(index);
    dm_result result = DM_OK;
    if (exists)
        result = dmi_gltf_read_sampler(r->gltf, samplers[(uint32_t)index], path == ROTATION ? 4 : 3, place, &here,
                                       &c->sampler);
    else
        result = dmi_gltf_refuse(&here, DM_ERROR_BAD_DATA, "%s: sampler %.17g does not exist", place, index);
    if (result != DM_OK && !here.fatal) {
        dmi_gltf_warn(&r->gltf->warnings, "%s; a channel is left out", here.text);
        return DM_OK;
    }
    if (result != DM_OK) {
        *problem = here;
        return result;
    }
    c->path = path;
    c->node = (uint32_t)node;
    c->next = r->firsts[node];
    r->firsts[node] = r->channel_count++;
    return dmi_gltf_tell(r->gltf, 0, c->sampler.times.count, problem);
}

/* Lists the items of a list. */
static const cJSON** list_items(reader* r, const cJSON* list, uint32_t count, dmi_gltf_problem* problem) {
    const cJSON** items = dmi_gltf_push(r->gltf, &r->scratch, count, sizeof *items, problem);
    const cJSON* item = items && count > 0 ? list->child : NULL;
    for (uint32_t i = 0; item; item = item->next) items[i++] = item;
    return items;
}

static dm_result read_channels(reader* r, const cJSON* animation, const char* place, dmi_gltf_problem* problem) {
    const cJSON *samplers = dmi_json_get(animation, "samplers"), *json;
    const cJSON* channels = dmi_json_get(animation, "channels");
    const uint32_t sampler_count = (uint32_t)cJSON_GetArraySize(samplers);
    const uint32_t count = (uint32_t)cJSON_GetArraySize(channels);
    const cJSON** items = list_items(r, samplers, sampler_count, problem);
    r->channel_count = 0;
    r->channels = items ? dmi_gltf_push(r->gltf, &r->scratch, count, sizeof *r->channels, problem) : NULL;
    if (!r->channels) return problem->code;
    cJSON_ArrayForEach(json, channels) {
        const dm_result result = read_channel(r, json, items, sampler_count, place, problem);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

/* Appends a clip to those of a node, which lie side by side. */
static dm_result add_clip(reader* r, dm_asset_node* node, const dm_asset_clip* clip, dmi_gltf_problem* problem) {
    dm_asset_clip* clips = (dm_asset_clip*)(uintptr_t)node->clips;
    if ((node->clip_count & (node->clip_count - 1)) == 0) { /* the list is full with 1, 2, 4, ... clips */
        const uint32_t room = node->clip_count > 0 ? 2 * node->clip_count : 1;
        dm_asset_clip* larger = dmi_gltf_push(r->gltf, &r->asset->arena, room, sizeof *larger, problem);
        if (!larger) return problem->code;
        if (clips) memcpy(larger, clips, node->clip_count * sizeof *clips);
        clips = larger;
    }
    clips[node->clip_count++] = *clip;
    node->clips = clips;
    return DM_OK;
}

static dm_result read_animation(reader* r, const cJSON* animation, uint32_t index, dmi_gltf_problem* problem) {
    const char* name = dmi_json_text(animation, "name");
    char place[128];
    snprintf(place, sizeof place, "glTF animation %u '%.80s'", index, name ? name : "");
    dm_result result = read_channels(r, animation, place, problem);
    for (uint32_t c = 0; c < r->channel_count && result == DM_OK; c++) {
        const uint32_t node = r->channels[c].node;
        dm_asset_clip clip;
        bool says = false;
        if (r->firsts[node] == NO_CHANNEL) continue; /* it was read together with another channel */
        result = make_clip(r, node, name && name[0] ? name : NULL, &clip, &says, problem);
        r->firsts[node] = NO_CHANNEL;
        if (result == DM_OK && says) result = add_clip(r, &r->asset->nodes[r->asset->places[node]], &clip, problem);
    }
    return result;
}

dm_result dmi_gltf_read_clips(dm_gltf* gltf, dmi_gltf_asset* asset, dmi_gltf_problem* problem) {
    const uint32_t nodes = gltf->document.counts[DMI_GLTF_NODES];
    const cJSON* animation;
    uint32_t index = 0;
    reader r = {.gltf = gltf, .asset = asset};
    dmi_arena_init(&r.scratch, &gltf->env, asset->arena.block_size);
    r.firsts = dmi_gltf_push(gltf, &asset->arena, nodes, sizeof *r.firsts, problem);
    dm_result result = r.firsts ? DM_OK : problem->code;
    for (uint32_t i = 0; r.firsts && i < nodes; i++) r.firsts[i] = NO_CHANNEL;
    cJSON_ArrayForEach(animation, dmi_json_get(gltf->document.root, "animations")) {
        const dmi_arena_mark mark = dmi_arena_get_mark(&r.scratch);
        if (result == DM_OK) result = read_animation(&r, animation, index++, problem);
        dmi_arena_rewind(&r.scratch, mark);
    }
    dmi_arena_release(&r.scratch);
    return result;
}
