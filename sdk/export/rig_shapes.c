/* Makes shapes of a body from the meshes of an asset's nodes. Nodes whose triangles are alike but for where they are
 * share one mesh. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "export/rig_formats.h"
#include "math/elementary.h"
#include "mesh/mesh_read.h"

/* Share of the asset's size by which points of alike meshes may differ; by hand: float rounding of positions. */
static const double alike = 1e-6;
/* Share of the asset's size by which a corner of a flat mesh may be lifted; by hand: a tenth of what poses may be
 * off. */
static const double lift_most = 1e-5;
enum { COLUMN = 4, TRANSFORM = 16, CHANNELS = 4 };

static const float identity[TRANSFORM] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/* Takes a point of a node into the model's frame. */
static void place_point(const dmi_rig_model* model, const float m[TRANSFORM], const double p[3], double out[3]) {
    double host[3], y_up[3];
    for (int k = 0; k < 3; k++)
        host[k] = (double)m[k] * p[0] + (double)m[COLUMN + k] * p[1] + (double)m[2 * COLUMN + k] * p[2] +
                  (double)m[3 * COLUMN + k];
    dmi_axes_point_in(&model->axes, host, y_up);
    out[0] = y_up[0];
    out[1] = -y_up[2];
    out[2] = y_up[1];
}

/* Returns whether the way from the node to the model mirrors. */
static bool mirrors(const dmi_rig_model* model, const float m[TRANSFORM]) {
    double columns[3][3];
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) columns[c][k] = (double)m[COLUMN * c + k];
    const double *a = columns[0], *b = columns[1], *c = columns[2];
    const double determinant =
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    return (determinant < 0) != (model->axes.handedness < 0);
}

static void grow_box(double low[3], double high[3], const double p[3]) {
    for (int k = 0; k < 3; k++) {
        low[k] = dmi_fmin(low[k], p[k]);
        high[k] = dmi_fmax(high[k], p[k]);
    }
}

/* Reads the node's points about the middle of their box, which is out_place. */
static void read_points(const dmi_rig_model* model, const dmi_mesh_reader* reader, const float* transform,
                        dmi_rig_mesh* out, double out_place[3]) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, p[3];
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t i = 0; i < out->point_count; i++) {
            double own[3];
            dmi_mesh_read_position(reader, i, own);
            place_point(model, transform, own, p);
            if (pass == 0) grow_box(low, high, p);
            for (int k = 0; pass == 1 && k < 3; k++) out->points[i][k] = (float)(p[k] - out_place[k]);
        }
        for (int k = 0; pass == 0 && k < 3; k++) out_place[k] = (low[k] + high[k]) / 2;
    }
}

/* Reads the triangles of a node, if it has some that count. out->face_count is 0 when it has none. */
static dm_result read_mesh(dmi_rig_model* model, uint32_t node, dmi_rig_mesh* out, double out_place[3]) {
    const dm_asset_node* from = &model->desc->nodes[node];
    const float* transform = from->transform != NULL ? from->transform : identity;
    dmi_mesh_reader reader;
    *out = (dmi_rig_mesh){.face_count = 0};
    if (from->mesh == NULL || (from->flags & DM_ASSET_NODE_FOLLOWS)) return DM_OK;
    dm_result result = dmi_mesh_reader_open(model->env, from->mesh, &reader);
    if (result == DM_OK) result = dmi_mesh_check_positions(model->env, &reader);
    if (result != DM_OK) return result;
    out->point_count = reader.vertex_count;
    out->points = dmi_rig_push(model, reader.vertex_count, sizeof *out->points);
    out->faces = dmi_rig_push(model, reader.face_count, sizeof *out->faces);
    if (out->points == NULL || out->faces == NULL) return DM_ERROR_OUT_OF_MEMORY;
    result = dmi_mesh_read_indices(model->env, &reader, &out->faces[0][0]);
    if (result != DM_OK) return result;
    read_points(model, &reader, transform, out, out_place);
    out->face_count = reader.face_count;
    dmi_rig_lift_corner(out, lift_most * model->size);
    for (uint32_t f = 0; mirrors(model, transform) && f < out->face_count; f++) {
        const uint32_t second = out->faces[f][1];
        out->faces[f][1] = out->faces[f][2];
        out->faces[f][2] = second;
    }
    return DM_OK;
}

static bool are_alike(const dmi_rig_mesh* a, const dmi_rig_mesh* b, double tolerance) {
    if (a->point_count != b->point_count || a->face_count != b->face_count) return false;
    if (memcmp(a->faces, b->faces, a->face_count * sizeof *a->faces) != 0) return false;
    for (uint32_t i = 0; i < a->point_count; i++)
        for (int k = 0; k < 3; k++)
            if (!(fabs((double)a->points[i][k] - (double)b->points[i][k]) <= tolerance)) return false;
    return true;
}

/* Returns the mesh that is like this one, which may be a new one. */
static uint32_t keep_mesh(dmi_rig_model* model, uint32_t node, const dmi_rig_mesh* mesh, double tolerance) {
    for (uint32_t i = 0; i < model->mesh_count; i++)
        if (are_alike(&model->meshes[i], mesh, tolerance)) return i;
    const uint32_t index = model->mesh_count++;
    const char* name = model->desc->nodes[node].name;
    char start[DMI_RIG_NAME];
    model->meshes[index] = *mesh;
    snprintf(start, sizeof start, "mesh_%u", index + 1);
    dmi_legal_name(start, name != NULL ? name : "", model->meshes[index].name, sizeof model->meshes[index].name);
    return index;
}

/* Writes the colour that the host, or its file, has for a node. White stays where there is none. */
static void read_colour(const dm_gltf_rig_desc* desc, uint32_t node, float inout_colour[CHANNELS]) {
    dm_gltf_node from;
    if (desc->colours != NULL)
        memcpy(inout_colour, desc->colours + (size_t)CHANNELS * node, CHANNELS * sizeof *inout_colour);
    else if (desc->gltf != NULL && node < dm_gltf_node_count(desc->gltf) &&
             dm_gltf_get_node(desc->gltf, node, &from) == DM_OK)
        memcpy(inout_colour, from.colour, CHANNELS * sizeof *inout_colour);
}

/* Adds the shapes of the nodes that a body has. */
static dm_result add_shapes(dmi_rig_model* model, uint32_t body, const uint32_t* part_bodies, double tolerance) {
    const dm_gltf_rig_desc* desc = model->desc;
    model->bodies[body].first_shape = model->shape_count;
    for (uint32_t n = 0; n < desc->node_count; n++) {
        const uint32_t part = desc->node_parts[n];
        if ((part == DM_ASSET_NO_PART ? 0 : part_bodies[part]) != body) continue;
        dmi_rig_mesh mesh;
        const dmi_arena_mark mark = dmi_arena_get_mark(&model->arena);
        dmi_rig_shape shape = {.body = body, .node = n, .colour = {1, 1, 1, 1}};
        const dm_result result = read_mesh(model, n, &mesh, shape.place);
        if (result != DM_OK) return result;
        if (mesh.face_count == 0) continue;
        read_colour(desc, n, shape.colour);
        const uint32_t before = model->mesh_count;
        shape.mesh = keep_mesh(model, n, &mesh, tolerance);
        if (model->mesh_count == before) dmi_arena_rewind(&model->arena, mark);
        model->shapes[model->shape_count++] = shape;
    }
    model->bodies[body].shape_count = model->shape_count - model->bodies[body].first_shape;
    return DM_OK;
}

/* Measures the box of the nodes' meshes, by which rounding is judged. */
static dm_result measure_asset(dmi_rig_model* model) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    bool any = false;
    for (uint32_t n = 0; n < model->desc->node_count; n++) {
        const dm_asset_node* node = &model->desc->nodes[n];
        dmi_mesh_reader reader;
        if (node->mesh == NULL || (node->flags & DM_ASSET_NODE_FOLLOWS)) continue;
        dm_result result = dmi_mesh_reader_open(model->env, node->mesh, &reader);
        if (result == DM_OK) result = dmi_mesh_check_positions(model->env, &reader);
        if (result != DM_OK) return result;
        for (uint32_t i = 0; i < reader.vertex_count; i++) {
            double own[3], p[3];
            dmi_mesh_read_position(&reader, i, own);
            place_point(model, node->transform != NULL ? node->transform : identity, own, p);
            grow_box(low, high, p);
        }
        any = any || reader.face_count > 0;
    }
    if (!any) return dmi_fail(model->env, DM_ERROR_DEGENERATE_MESH, "dm_gltf_rig_make: no node has a triangle");
    for (int k = 0; k < 3; k++) model->size = dmi_fmax(model->size, high[k] - low[k]);
    return DM_OK;
}

dm_result dmi_rig_make_shapes(dmi_rig_model* model, const uint32_t* part_bodies) {
    const uint32_t count = model->desc->node_count;
    dm_result result = measure_asset(model);
    if (result != DM_OK) return result;
    model->meshes = dmi_rig_push(model, count, sizeof *model->meshes);
    model->shapes = dmi_rig_push(model, count, sizeof *model->shapes);
    if (model->meshes == NULL || model->shapes == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t body = 0; body < model->body_count && result == DM_OK; body++)
        result = add_shapes(model, body, part_bodies, alike * model->size);
    for (uint32_t i = 0; i < model->shape_count; i++)
        for (int k = 0; k < 3; k++) model->shapes[i].place[k] -= model->bodies[model->shapes[i].body].origin[k];
    return result;
}
