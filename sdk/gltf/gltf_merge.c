/* The merged mesh: every triangle that the scene shows, node by node, primitive by primitive, in the scene's frame. */
#include "gltf/gltf_merge.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "gltf/gltf_tree.h"

/* An object this many times its size away from the scene's origin gets an origin of its own: a float there holds a
 * 65000th of its size. By hand. */
#define FAR_AWAY 256

typedef struct merger {
    dm_gltf* gltf;
    dmi_gltf_builder builder;
    uint32_t* instances; /* nodes that are merged, in the order of the file, not of the walk */
    uint32_t instance_count;
    double low[3], high[3]; /* box about where they are, in the scene */
    int skinned;
} merger;

/* Returns whether the columns of the matrix span a plane at least. Otherwise a triangle becomes a line or a point. */
static int spans_plane(const double m[16]) {
    double most = 0;
    for (int a = 0; a < 3; a++) {
        const double *u = m + 4 * (size_t)a, *v = m + 4 * (size_t)((a + 1) % 3);
        const double cross[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        most = fmax(most, fabs(cross[0]) + fabs(cross[1]) + fabs(cross[2]));
    }
    return most > 0;
}

static int is_skinned(const dm_gltf* gltf, uint32_t node) {
    return dmi_json_get(gltf->tree[node].json, "skin") != NULL;
}

/* Computes the box of the shape's box in the scene. Returns 0 when floats cannot hold it. */
static int place_box(const double m[16], const dmi_gltf_shape* shape, double low[3], double high[3]) {
    for (int row = 0; row < 3; row++) {
        low[row] = high[row] = m[12 + row];
        for (int column = 0; column < 3; column++) {
            const double a = m[4 * column + row] * (double)shape->low[column];
            const double b = m[4 * column + row] * (double)shape->high[column];
            low[row] += fmin(a, b);
            high[row] += fmax(a, b);
        }
        if (!(fabs(low[row]) <= FLT_MAX && fabs(high[row]) <= FLT_MAX)) return 0;
    }
    return 1;
}

/* Finds the matrix by which the node's mesh is about where the scene has it: the node's, or that of its skin's first
 * bone. */
static dm_result find_matrix(dm_gltf* gltf, uint32_t node, double out[16], dmi_gltf_problem* problem) {
    dmi_gltf_skin skin = {NULL, 0};
    dmi_gltf_problem here = {.code = DM_OK};
    memcpy(out, gltf->tree[node].world, 16 * sizeof *out);
    if (!is_skinned(gltf, node)) return DM_OK;
    const double index = dmi_json_number(gltf->tree[node].json, "skin", DMI_GLTF_NO_INDEX);
    if (dmi_gltf_open_skin(gltf, index, "glTF", &here, &skin) == DM_OK)
        memcpy(out, skin.joints[0].matrix, sizeof skin.joints->matrix);
    dmi_gltf_close_skin(&gltf->env, &skin);
    if (!here.fatal) return DM_OK; /* a faulty skin is left out later */
    *problem = here;
    return problem->code;
}

/* Adds a node when its mesh has triangles and its transform leaves something of them. */
static dm_result enter_node(merger* m, uint32_t index, dmi_gltf_problem* problem) {
    dm_gltf* gltf = m->gltf;
    const dmi_gltf_tree_node* node = &gltf->tree[index];
    dmi_gltf_problem here = {.code = DM_OK};
    double matrix[16], low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    dm_result result = dmi_gltf_build_shape(&m->builder, index, problem);
    if (result == DM_OK) result = find_matrix(gltf, index, matrix, problem);
    if (result != DM_OK) return result;
    const dmi_gltf_shape* shape = &m->builder.shapes[node->mesh];
    if (shape->face_count == 0) return DM_OK;
    if (!place_box(matrix, shape, low, high))
        dmi_gltf_refuse(&here, DM_ERROR_NOT_FINITE, "glTF node %u '%.80s': its transform is not finite", index,
                        node->name);
    else if (!is_skinned(gltf, index) && !spans_plane(node->world))
        dmi_gltf_refuse(&here, DM_ERROR_DEGENERATE_MESH, "glTF node %u '%.80s': its scale is zero", index, node->name);
    if (here.code != DM_OK) {
        dmi_gltf_leave_out(gltf, &here);
        return DM_OK;
    }
    for (int k = 0; k < 3; k++) {
        m->low[k] = fmin(m->low[k], low[k]);
        m->high[k] = fmax(m->high[k], high[k]);
    }
    m->skinned |= is_skinned(gltf, index);
    m->instances[m->instance_count++] = index;
    gltf->vertex_capacity += shape->vertex_count;
    gltf->face_capacity += shape->face_count;
    if (gltf->vertex_capacity <= DM_MAX_ELEMENTS && gltf->face_capacity <= DM_MAX_ELEMENTS) return DM_OK;
    return dmi_gltf_refuse(problem, DM_ERROR_TOO_LARGE,
                           "glTF node %u: the scene has more than %d vertices or triangles so far", index,
                           DM_MAX_ELEMENTS);
}

static dm_result enter_nodes(merger* m, dmi_gltf_problem* problem) {
    const uint32_t count = m->gltf->document.counts[DMI_GLTF_NODES];
    for (uint32_t i = 0; i < count; i++) {
        const dmi_gltf_tree_node* node = &m->gltf->tree[i];
        if (node->mesh < 0 || !node->shown || !node->placed) continue;
        const float done = DMI_STAGE_GLTF_TREE_READ +
                           (DMI_STAGE_GLTF_SHAPES_BUILT - DMI_STAGE_GLTF_TREE_READ) * (float)i / (float)count;
        dm_result result = dmi_gltf_tell(m->gltf, done, 1, problem);
        if (result == DM_OK) result = enter_node(m, i, problem);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

/* Rounds to a float. It is a function of its own because gcc 12 takes (double)(float)x for x where the SLP vectorizer
 * makes vectors of it at -O3. Nothing else in the library rounds so (docs/research/decisions.md, 45). */
DMI_NO_INLINE static double to_float(double x) {
    return (double)(float)x;
}

static void choose_origin(merger* m) {
    double size = 0, distance = 0;
    for (int k = 0; k < 3; k++) {
        size = fmax(size, m->high[k] - m->low[k]);
        distance = fmax(distance, fabs(m->high[k] + m->low[k]) / 2);
    }
    for (int k = 0; distance > FAR_AWAY * size && k < 3; k++)
        m->gltf->origin[k] = to_float((m->high[k] + m->low[k]) / 2); /* floats hold it, so viewers can */
}

static dm_result take_room(merger* m, dmi_gltf_problem* problem) {
    dm_gltf* gltf = m->gltf;
    dmi_env* env = &gltf->env;
    const uint64_t vertices = gltf->vertex_capacity, faces = gltf->face_capacity;
    const size_t vertex = 3 * sizeof(float) + 2 * sizeof(uint32_t), face = 4 * sizeof(uint32_t);
    dm_result result = dmi_gltf_spend(gltf, vertices, vertex, "glTF: the vertices", problem);
    if (result == DM_OK) result = dmi_gltf_spend(gltf, faces, face, "glTF: the triangles", problem);
    if (result != DM_OK) return result;
    gltf->positions = dmi_alloc(env, vertices * 3 * sizeof *gltf->positions, 16);
    gltf->indices = dmi_alloc(env, faces * 3 * sizeof *gltf->indices, 16);
    gltf->sources = dmi_alloc(env, vertices * sizeof *gltf->sources, 16);
    if (m->skinned) {
        gltf->vertex_places = dmi_alloc(env, vertices * sizeof *gltf->vertex_places, 16);
        gltf->face_places = dmi_alloc(env, faces * sizeof *gltf->face_places, 16);
    }
    if (gltf->positions && gltf->indices && gltf->sources &&
        (!m->skinned || (gltf->vertex_places && gltf->face_places)))
        return DM_OK;
    return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY,
                           "glTF: no memory for %" PRIu64 " vertices and %" PRIu64 " triangles", vertices, faces);
}

/* Finds for every node which one carries it: the nearest above it that has triangles. A bone that several meshes have
 * goes with its first. */
static dm_result find_carriers(dm_gltf* gltf, dmi_gltf_problem* problem) {
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    const dm_result result = dmi_gltf_spend(gltf, count, 2 * sizeof(uint32_t), "glTF: the nodes", problem);
    if (result != DM_OK) return result;
    /* The nodes' own entries, and behind them what carries each. */
    uint32_t* own = dmi_alloc(&gltf->env, 2 * (size_t)count * sizeof *own, 16);
    if (!own) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u nodes", count);
    uint32_t* above = own + count;
    for (uint32_t i = 0; i < 2 * count; i++) own[i] = DM_GLTF_NO_CARRIER;
    for (uint32_t i = gltf->node_count; i-- > 0;) own[gltf->nodes[i].node] = i;
    for (uint32_t at = 0; at < gltf->order_count; at++) {
        const uint32_t node = gltf->order[at];
        const int32_t parent = gltf->tree[node].parent;
        if (parent >= 0) above[node] = own[parent] != DM_GLTF_NO_CARRIER ? own[parent] : above[parent];
    }
    for (uint32_t i = 0; i < gltf->node_count; i++) {
        const uint32_t node = gltf->nodes[i].node;
        gltf->nodes[i].carrier = own[node] != i ? own[node] : above[node];
    }
    dmi_free(&gltf->env, own, 2 * (size_t)count * sizeof *own);
    return DM_OK;
}

static dm_result merge_nodes(merger* m, dmi_gltf_problem* problem) {
    dm_gltf* gltf = m->gltf;
    const uint32_t nodes = gltf->document.counts[DMI_GLTF_NODES];
    dm_result result = dmi_gltf_spend(gltf, nodes, sizeof *m->instances, "glTF: the nodes", problem);
    if (result != DM_OK) return result;
    m->instances = dmi_alloc(&gltf->env, nodes * sizeof *m->instances, 16);
    if (!m->instances) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for its nodes");
    result = dmi_gltf_builder_open(gltf, problem, &m->builder);
    if (result == DM_OK) result = enter_nodes(m, problem);
    if (result != DM_OK) return result;
    if (m->instance_count == 0) {
        if (gltf->left_out.code == DM_OK)
            return dmi_gltf_refuse(problem, DM_ERROR_DEGENERATE_MESH, "glTF: the scene has no triangle");
        *problem = gltf->left_out;
        return problem->code;
    }
    choose_origin(m);
    result = take_room(m, problem);
    for (uint32_t i = 0; i < m->instance_count && result == DM_OK; i++) {
        const uint32_t node = m->instances[i];
        const dmi_gltf_shape* shape = &m->builder.shapes[gltf->tree[node].mesh];
        result = is_skinned(gltf, node) ? dmi_gltf_add_skinned(gltf, shape, node, problem)
                                        : dmi_gltf_add_rigid(gltf, shape, node, problem);
        const float done =
            DMI_STAGE_GLTF_SHAPES_BUILT + (1 - DMI_STAGE_GLTF_SHAPES_BUILT) * (float)i / (float)m->instance_count;
        if (result == DM_OK) result = dmi_gltf_tell(gltf, done, 1, problem);
    }
    if (result == DM_OK) result = dmi_gltf_judge_pivots(gltf, problem);
    return result == DM_OK ? find_carriers(gltf, problem) : result;
}

dm_result dmi_gltf_merge(dm_gltf* gltf, dmi_gltf_problem* problem) {
    merger m = {.gltf = gltf,
                .builder = {.gltf = gltf},
                .low = {INFINITY, INFINITY, INFINITY},
                .high = {-INFINITY, -INFINITY, -INFINITY}};
    dmi_gltf_mark_joints(gltf);
    const dm_result result = merge_nodes(&m, problem);
    dmi_free(&gltf->env, m.instances, gltf->document.counts[DMI_GLTF_NODES] * sizeof *m.instances);
    dmi_gltf_builder_close(&m.builder);
    return result;
}
