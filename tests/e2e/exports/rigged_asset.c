/* Rigged assets as their rig.json states them. */
#include "rigged_asset.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dragmesh/ext/gltf.h"

static double number_of(const cJSON* object, const char* name, double otherwise) {
    const cJSON* item = cJSON_GetObjectItemCaseSensitive(object, name);
    return cJSON_IsNumber(item) ? item->valuedouble : otherwise;
}

static void turn_up(const double y_up[3], double out[3]) {
    const double y = y_up[1], z = y_up[2];
    out[0] = y_up[0];
    out[1] = -z;
    out[2] = y;
}

static char* read_file(const char* folder, const char* name, size_t* out_size) {
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE* file = fopen(path, "rb");
    if (file == NULL) return NULL;
    fseek(file, 0, SEEK_END);
    *out_size = (size_t)ftell(file);
    rewind(file);
    char* text = calloc(1, *out_size + 1);
    *out_size = fread(text, 1, *out_size, file);
    fclose(file);
    return text;
}

static void read_part(const cJSON* json, const double origin[3], rigged_part* out) {
    const cJSON* exact = cJSON_GetObjectItemCaseSensitive(json, "dragmesh_joint"); /* of screws and endless turns */
    const cJSON* joint = exact != NULL ? exact : json;
    const char* type = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(joint, "type"));
    const char* state = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "state"));
    const cJSON *axis = cJSON_GetObjectItemCaseSensitive(joint, "axis"),
                *at = cJSON_GetObjectItemCaseSensitive(joint, "origin");
    double given[2][3] = {{1, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < 3; k++) {
        if (cJSON_GetArrayItem(axis, k)) given[0][k] = cJSON_GetArrayItem(axis, k)->valuedouble;
        if (cJSON_GetArrayItem(at, k)) given[1][k] = cJSON_GetArrayItem(at, k)->valuedouble - origin[k];
    }
    *out = (rigged_part){.parent = (int)number_of(json, "parent", -1),
                         .lower = number_of(joint, "lower", 0),
                         .upper = number_of(joint, "upper", 0),
                         .pitch = number_of(joint, "pitch", 0)};
    snprintf(out->type, sizeof out->type, "%s", type != NULL ? type : "");
    out->moves = state != NULL && strcmp(state, "moves") == 0 && strcmp(out->type, "fixed") != 0;
    turn_up(given[0], out->axis);
    turn_up(given[1], out->origin);
}

/* The part with which a part goes. */
static int mover(const rigged_asset* asset, int part) {
    while (part >= 0 && part < asset->count && !asset->parts[part].moves) part = asset->parts[part].parent;
    return part < 0 ? asset->count : part;
}

static void add_node(const dm_mesh_desc* mesh, rigged_part* out) {
    const float* points = mesh->positions;
    const uint32_t* indices = mesh->indices;
    out->node_corners = realloc(out->node_corners, (size_t)(out->node_count + 1) * sizeof *out->node_corners);
    out->node_corners[out->node_count++] = mesh->index_count;
    out->corners = realloc(out->corners, (out->corner_count + mesh->index_count) * sizeof *out->corners);
    for (uint64_t i = 0; i < mesh->index_count; i++) {
        const float* p = points + 3 * (size_t)indices[i];
        turn_up((double[3]){(double)p[0], (double)p[1], (double)p[2]}, out->corners[out->corner_count++]);
    }
}

/* The part of a node of the file; -1: none lists it. */
static int part_of(const cJSON* parts, uint32_t node) {
    int index = 0;
    const cJSON *part, *item;
    cJSON_ArrayForEach(part, parts) {
        cJSON_ArrayForEach(item, cJSON_GetObjectItemCaseSensitive(part, "node_indices")) {
            if (item->valuedouble == (double)node) return index;
        }
        index++;
    }
    return -1;
}

static void measure(rigged_asset* asset) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int p = 0; p <= asset->count; p++)
        for (size_t i = 0; i < asset->parts[p].corner_count; i++)
            for (int k = 0; k < 3; k++) {
                low[k] = fmin(low[k], asset->parts[p].corners[i][k]);
                high[k] = fmax(high[k], asset->parts[p].corners[i][k]);
            }
    for (int k = 0; k < 3; k++) asset->size = fmax(asset->size, high[k] - low[k]);
}

bool rigged_open(const char* file, const char* folder, rigged_asset* out) {
    size_t size = 0;
    uint32_t count = 0;
    double origin[3];
    const dm_asset_node* nodes;
    dm_gltf* gltf = NULL;
    const dm_gltf_desc desc = {.struct_size = sizeof desc};
    *out = (rigged_asset){.count = 0};
    char* text = read_file(folder, "rig.json", &size);
    cJSON* json = text != NULL ? cJSON_ParseWithLength(text, size) : NULL;
    free(text);
    const cJSON *parts = cJSON_GetObjectItemCaseSensitive(json, "parts"), *part;
    if (json == NULL || dm_gltf_open_file(file, &desc, &gltf) != DM_OK) return false;
    if (dm_gltf_get_asset(gltf, 0, &nodes, &count) != DM_OK) return false;
    dm_gltf_get_origin(gltf, origin);
    out->parts = calloc((size_t)cJSON_GetArraySize(parts) + 1, sizeof *out->parts);
    cJSON_ArrayForEach(part, parts) read_part(part, origin, &out->parts[out->count++]);
    out->parts[out->count].parent = -1;
    for (uint32_t n = 0; n < count; n++) {
        uint32_t number = 0;
        if (nodes[n].mesh == NULL || (nodes[n].flags & DM_ASSET_NODE_FOLLOWS)) continue;
        dm_gltf_get_asset_node(gltf, n, &number);
        add_node(nodes[n].mesh, &out->parts[mover(out, part_of(parts, number))]);
    }
    measure(out);
    cJSON_Delete(json);
    dm_gltf_close(gltf);
    return true;
}

void rigged_close(rigged_asset* asset) {
    for (int p = 0; asset->parts != NULL && p <= asset->count; p++) {
        free(asset->parts[p].corners);
        free(asset->parts[p].node_corners);
    }
    free(asset->parts);
}

double rigged_value(const rigged_asset* asset, int part, double share) {
    const rigged_part* p = &asset->parts[part];
    if (strcmp(p->type, "continuous") != 0 && p->lower < p->upper) return p->lower + share * (p->upper - p->lower);
    return share * (strcmp(p->type, "prismatic") == 0 ? asset->size / 4 : atan(1) * 2);
}

/* Moves a point by a part's own joint. */
static void move(const rigged_part* part, double value, double p[3]) {
    const bool turns = strcmp(part->type, "prismatic") != 0;
    const double angle = turns ? value : 0, way = turns ? part->pitch * value : value, *a = part->axis;
    const double c = cos(angle), s = sin(angle);
    double d[3], along = 0;
    for (int k = 0; k < 3; k++) d[k] = p[k] - part->origin[k];
    for (int k = 0; k < 3; k++) along += d[k] * a[k];
    const double crossed[3] = {a[1] * d[2] - a[2] * d[1], a[2] * d[0] - a[0] * d[2], a[0] * d[1] - a[1] * d[0]};
    for (int k = 0; k < 3; k++)
        p[k] = part->origin[k] + c * d[k] + s * crossed[k] + (1 - c) * along * a[k] + way * a[k];
}

void rigged_corner(const rigged_asset* asset, int part, size_t corner, const double* values, double out[3]) {
    memcpy(out, asset->parts[part].corners[corner], 3 * sizeof *out);
    for (int p = part == asset->count ? -1 : part; p >= 0; p = asset->parts[p].parent)
        if (asset->parts[p].moves) move(&asset->parts[p], values[p], out);
}

int rigged_part_called(const rigged_asset* asset, const char* name) {
    if (strcmp(name, "body") == 0) return asset->count;
    if (strncmp(name, "part_", 5) != 0) return -1;
    const long number = strtol(name + 5, NULL, 10);
    return number >= 1 && number <= asset->count ? (int)number - 1 : -1;
}

size_t rigged_node_corners(const rigged_part* part, int node, size_t corners) {
    if (node >= part->node_count) return 0;
    const size_t own = part->node_corners[node];
    return corners == own || corners == own + 3 ? own : 0;
}
