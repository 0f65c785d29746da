/* Places shapes in the scene. */
#include "gltf/gltf_merge.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gltf/gltf_matrix.h"

/* ---- lists ---- */

/* Makes room for one more item of a list. Returns NULL on a failure, and `problem` says why. */
static void* grow_list(dm_gltf* gltf, void* items, uint32_t count, uint32_t* capacity, size_t size,
                       dmi_gltf_problem* problem) {
    if (count < *capacity) return items;
    const uint32_t larger = *capacity ? 2 * *capacity : 16;
    if (dmi_gltf_spend(gltf, larger, size, "glTF: the nodes", problem) != DM_OK) return NULL;
    void* copy = dmi_alloc(&gltf->env, larger * size, 16);
    if (!copy) {
        dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u nodes or primitives", count + 1);
        return NULL;
    }
    if (items) memcpy(copy, items, count * size);
    dmi_free(&gltf->env, items, *capacity * size);
    *capacity = larger;
    return copy;
}

static dm_gltf_node* add_node(dm_gltf* gltf, uint32_t node, dmi_gltf_problem* problem) {
    dm_gltf_node* nodes = grow_list(gltf, gltf->nodes, gltf->node_count, &gltf->node_capacity, sizeof *nodes, problem);
    if (!nodes) return NULL;
    gltf->nodes = nodes;
    nodes += gltf->node_count++;
    *nodes = (dm_gltf_node){.name = gltf->tree[node].name,
                            .node = node,
                            .carrier = DM_GLTF_NO_CARRIER,
                            .first_vertex = gltf->vertex_count,
                            .first_face = gltf->face_count};
    return nodes;
}

static dmi_gltf_piece* add_piece(dm_gltf* gltf, dmi_gltf_problem* problem) {
    dmi_gltf_piece* pieces =
        grow_list(gltf, gltf->pieces, gltf->piece_count, &gltf->piece_capacity, sizeof *pieces, problem);
    if (!pieces) return NULL;
    gltf->pieces = pieces;
    return pieces + gltf->piece_count++;
}

/* ---- common ---- */

static void transform_point(const double m[16], const float local[3], double out[3]) {
    for (int row = 0; row < 3; row++)
        out[row] =
            m[row] * (double)local[0] + m[4 + row] * (double)local[1] + m[8 + row] * (double)local[2] + m[12 + row];
}

static void store_position(dm_gltf* gltf, uint64_t vertex, const double position[3]) {
    for (int k = 0; k < 3; k++) gltf->positions[3 * vertex + k] = (float)(position[k] - gltf->origin[k]);
}

/* Notes that vertices and faces keep the order of the file from here on. */
static void keep_order(dm_gltf* gltf, const dmi_gltf_shape* shape) {
    for (uint64_t v = gltf->vertex_count; gltf->vertex_places && v < gltf->vertex_count + shape->vertex_count; v++)
        gltf->vertex_places[v] = (uint32_t)v;
    for (uint64_t f = gltf->face_count; gltf->face_places && f < gltf->face_count + shape->face_count; f++)
        gltf->face_places[f] = (uint32_t)f;
}

/* ---- placed by the node ---- */

dm_result dmi_gltf_add_rigid(dm_gltf* gltf, const dmi_gltf_shape* shape, uint32_t node, dmi_gltf_problem* problem) {
    const double* world = gltf->tree[node].world;
    const uint32_t mirrored = dmi_gltf_determinant(world) < 0;
    dm_gltf_node* entry = add_node(gltf, node, problem);
    if (!entry) return problem->code;
    entry->vertex_count = shape->vertex_count;
    entry->face_count = shape->face_count;
    memcpy(entry->colour, shape->runs[0].colour, sizeof entry->colour);
    for (uint32_t r = 0; r < shape->run_count; r++) {
        dmi_gltf_piece* piece = add_piece(gltf, problem);
        if (!piece) return problem->code;
        *piece = (dmi_gltf_piece){.node = gltf->node_count - 1,
                                  .mesh_node = node,
                                  .primitive = shape->runs[r].primitive,
                                  .json = shape->runs[r].json,
                                  .mirrored = mirrored,
                                  .joint = -1,
                                  .first_face = gltf->face_count + shape->runs[r].first_face,
                                  .face_count = shape->runs[r].face_count};
    }
    for (uint64_t v = 0; v < shape->vertex_count; v++) {
        double position[3];
        transform_point(world, shape->local + 3 * v, position);
        store_position(gltf, gltf->vertex_count + v, position);
    }
    const dm_result result = dmi_gltf_tell(gltf, 0, shape->vertex_count, problem);
    if (result != DM_OK) return result;
    memcpy(gltf->sources + gltf->vertex_count, shape->elements, shape->vertex_count * sizeof *gltf->sources);
    uint32_t* out = gltf->indices + 3 * gltf->face_count;
    for (uint64_t i = 0; i < 3 * shape->face_count; i += 3) {
        for (uint32_t corner = 0; corner < 3; corner++)
            out[i + (mirrored ? 2 - corner : corner)] = (uint32_t)gltf->vertex_count + shape->corners[i + corner];
    }
    keep_order(gltf, shape);
    gltf->vertex_count += shape->vertex_count;
    gltf->face_count += shape->face_count;
    return dmi_gltf_tell(gltf, 0, shape->face_count, problem);
}

/* ---- placed by bones ---- */

#define SKINNER_BYTES 40 /* bytes of a vertex, and about as much of its faces, while a skin is applied */

typedef struct skinner {
    dm_gltf* gltf;
    const dmi_gltf_shape* shape;
    uint32_t node;
    dmi_gltf_skin skin;
    uint32_t* joints;       /* one a vertex */
    double (*positions)[3]; /* one a vertex */
    uint32_t* vertices;     /* per vertex: where it comes to lie, from the first on */
    uint32_t* face_joints;  /* one a face */
    uint32_t* faces;        /* per place in the new order: the face of the shape */
    uint32_t* starts;       /* one a joint, and one more */
    uint32_t* vertex_starts;
} skinner;

static dm_result open_skinner(skinner* s, const char* place, dmi_gltf_problem* problem) {
    dmi_env* env = &s->gltf->env;
    const uint64_t vertices = s->shape->vertex_count, faces = s->shape->face_count;
    const double skin = dmi_json_number(s->gltf->tree[s->node].json, "skin", DMI_GLTF_NO_INDEX);
    dm_result result = dmi_gltf_open_skin(s->gltf, skin, place, problem, &s->skin);
    if (result != DM_OK) return result;
    s->joints = dmi_alloc(env, vertices * sizeof *s->joints, 16);
    s->positions = dmi_alloc(env, vertices * sizeof *s->positions, 16);
    s->vertices = dmi_alloc(env, vertices * sizeof *s->vertices, 16);
    s->face_joints = dmi_alloc(env, faces * sizeof *s->face_joints, 16);
    s->faces = dmi_alloc(env, faces * sizeof *s->faces, 16);
    s->starts = dmi_alloc(env, (s->skin.joint_count + 1) * sizeof *s->starts, 16);
    s->vertex_starts = dmi_alloc(env, (s->skin.joint_count + 1) * sizeof *s->starts, 16);
    if (s->joints && s->positions && s->vertices && s->face_joints && s->faces && s->starts && s->vertex_starts)
        return DM_OK;
    return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "%s: no memory for %" PRIu64 " vertices", place, vertices);
}

static void close_skinner(skinner* s) {
    dmi_env* env = &s->gltf->env;
    const uint64_t vertices = s->shape->vertex_count, faces = s->shape->face_count;
    dmi_free(env, s->joints, vertices * sizeof *s->joints);
    dmi_free(env, s->positions, vertices * sizeof *s->positions);
    dmi_free(env, s->vertices, vertices * sizeof *s->vertices);
    dmi_free(env, s->face_joints, faces * sizeof *s->face_joints);
    dmi_free(env, s->faces, faces * sizeof *s->faces);
    dmi_free(env, s->starts, (s->skin.joint_count + 1) * sizeof *s->starts);
    dmi_free(env, s->vertex_starts, (s->skin.joint_count + 1) * sizeof *s->starts);
    dmi_gltf_close_skin(env, &s->skin);
}

/* Finds joint and place of every vertex, and checks that floats hold the places. */
static dm_result find_places(skinner* s, const char* place, dmi_gltf_problem* problem) {
    const int64_t mixed = dmi_gltf_skin_vertices(&s->skin, s->shape, s->joints, s->positions);
    if (mixed < 0) return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: vertices without a bone", place);
    for (uint64_t v = 0; v < s->shape->vertex_count; v++) {
        for (int k = 0; k < 3; k++) {
            if (!(fabs(s->positions[v][k]) <= FLT_MAX))
                return dmi_gltf_refuse(problem, DM_ERROR_NOT_FINITE, "%s: its bones place vertex %" PRIu64 " nowhere",
                                       place, v);
        }
    }
    if (mixed > 0)
        dmi_gltf_warn(&s->gltf->warnings,
                      "%s: %" PRId64 " of %" PRIu64 " vertices have several bones, each goes with its heaviest", place,
                      mixed, s->shape->vertex_count);
    return DM_OK;
}

/* Turns counts of joints, one place further on, into where each joint's items start. */
static void sum_up(skinner* s) {
    for (uint32_t j = 0; j < s->skin.joint_count; j++) s->starts[j + 1] += s->starts[j];
}

static void clear_starts(skinner* s) {
    memset(s->starts, 0, (s->skin.joint_count + 1) * sizeof *s->starts);
}

/* Sorts vertices and faces by joint, in the order of the file where that is the same. A face goes with two of its
 * corners, or with the first. */
static void sort_by_joint(skinner* s) {
    const uint64_t vertices = s->shape->vertex_count, faces = s->shape->face_count;
    clear_starts(s);
    for (uint64_t v = 0; v < vertices; v++) s->starts[s->joints[v] + 1]++;
    sum_up(s);
    memcpy(s->vertex_starts, s->starts, (s->skin.joint_count + 1) * sizeof *s->starts);
    for (uint64_t v = 0; v < vertices; v++) s->vertices[v] = s->starts[s->joints[v]]++;
    clear_starts(s);
    for (uint64_t f = 0; f < faces; f++) {
        const uint32_t* corners = s->shape->corners + 3 * f;
        const uint32_t second = s->joints[corners[1]];
        s->face_joints[f] = second == s->joints[corners[2]] ? second : s->joints[corners[0]];
        s->starts[s->face_joints[f] + 1]++;
    }
    sum_up(s);
    for (uint64_t f = 0; f < faces; f++) s->faces[s->starts[s->face_joints[f]]++] = (uint32_t)f;
}

static void fill_vertices(skinner* s) {
    dm_gltf* gltf = s->gltf;
    for (uint64_t v = 0; v < s->shape->vertex_count; v++) {
        const uint64_t to = gltf->vertex_count + s->vertices[v];
        store_position(gltf, to, s->positions[v]);
        gltf->sources[to] = s->shape->elements[v];
        gltf->vertex_places[to] = (uint32_t)(gltf->vertex_count + v);
    }
}

static void fill_face(skinner* s, uint64_t at, uint32_t mirrored) {
    dm_gltf* gltf = s->gltf;
    const uint32_t* corners = s->shape->corners + 3 * (size_t)s->faces[at];
    uint32_t* out = gltf->indices + 3 * (gltf->face_count + at);
    for (uint32_t corner = 0; corner < 3; corner++)
        out[mirrored ? 2 - corner : corner] = (uint32_t)gltf->vertex_count + s->vertices[corners[corner]];
    gltf->face_places[gltf->face_count + at] = (uint32_t)(gltf->face_count + s->faces[at]);
}

/* Adds nodes and pieces for the sorted faces, and fills these. */
static dm_result fill_faces(skinner* s, dmi_gltf_problem* problem) {
    dm_gltf* gltf = s->gltf;
    dm_gltf_node* entry = NULL;
    dmi_gltf_piece* piece = NULL;
    uint32_t run = 0, joint = UINT32_MAX;
    for (uint64_t at = 0; at < s->shape->face_count; at++) {
        const uint32_t face = s->faces[at];
        const int new_joint = s->face_joints[face] != joint;
        if (new_joint) run = 0;
        const uint32_t old_run = run;
        while (face >= s->shape->runs[run].first_face + s->shape->runs[run].face_count) run++;
        if (!entry || new_joint) {
            joint = s->face_joints[face];
            entry = add_node(gltf, s->skin.joints[joint].node, problem);
            if (!entry) return problem->code;
            entry->first_vertex += s->vertex_starts[joint];
            entry->vertex_count = s->vertex_starts[joint + 1] - s->vertex_starts[joint];
            entry->first_face = gltf->face_count + at;
            memcpy(entry->colour, s->shape->runs[run].colour, sizeof entry->colour);
        }
        if (!piece || new_joint || run != old_run) {
            piece = add_piece(gltf, problem);
            if (!piece) return problem->code;
            *piece = (dmi_gltf_piece){.node = gltf->node_count - 1,
                                      .mesh_node = s->node,
                                      .primitive = s->shape->runs[run].primitive,
                                      .json = s->shape->runs[run].json,
                                      .mirrored = dmi_gltf_determinant(s->skin.joints[joint].matrix) < 0,
                                      .joint = (int32_t)joint,
                                      .first_face = gltf->face_count + at};
        }
        fill_face(s, at, piece->mirrored);
        piece->face_count++;
        entry->face_count++;
    }
    return DM_OK;
}

dm_result dmi_gltf_add_skinned(dm_gltf* gltf, const dmi_gltf_shape* shape, uint32_t node, dmi_gltf_problem* problem) {
    skinner s = {.gltf = gltf, .shape = shape, .node = node};
    dmi_gltf_problem here = {.code = DM_OK};
    char place[128];
    snprintf(place, sizeof place, "glTF node %u '%.80s'", node, gltf->tree[node].name);
    dm_result result = dmi_gltf_spend(gltf, shape->vertex_count, SKINNER_BYTES, place, &here);
    if (result == DM_OK) result = open_skinner(&s, place, &here);
    if (result == DM_OK) result = find_places(&s, place, &here);
    if (result == DM_OK) {
        sort_by_joint(&s);
        fill_vertices(&s);
        result = fill_faces(&s, &here);
        gltf->vertex_count += shape->vertex_count;
        gltf->face_count += shape->face_count;
    } else if (!here.fatal) {
        dmi_gltf_warn(&gltf->warnings, "%s; its skin is left out", here.text);
        result = dmi_gltf_add_rigid(gltf, shape, node, &here);
    }
    close_skinner(&s);
    if (result != DM_OK) *problem = here;
    return result;
}
