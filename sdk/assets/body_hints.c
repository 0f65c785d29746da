/* A body is called as its largest node. It turns where that node has its origin; a body of several nodes where the
 * highest node has it that is over nothing else. Its joint is that which the file states, or that of a clip where it
 * states none. */
#include "assets/body_hints.h"

#include <string.h>

#include "assets/asset_mesh.h"
#include "assets/clip_joint.h"
#include "base/label_path.h"
#include "math/linear3.h"
#include "mesh/pivot_rule.h"

enum { COLUMN = 4, ORIGIN = 12 }; /* offsets in a transform of 16 numbers: from column to column; of the translation */
#define SEVERAL (DMI_ASSET_BODY - 1) /* nodes of several bodies, or of the body that stays */
#define NOTHING DMI_ASSET_BODY       /* no node with a mesh */

/* ---- origins ---- */

bool dmi_asset_node_pivot(const dm_asset_node* node, dm_pivot* out_pivot) {
    if (node->flags & DM_ASSET_NODE_NO_PIVOT) return false;
    if (node->pivot != NULL) {
        *out_pivot = *node->pivot;
        return true;
    }
    const float* m = node->transform;
    if (m == NULL) return false;
    out_pivot->origin = (dm_vec3){m[ORIGIN], m[ORIGIN + 1], m[ORIGIN + 2]};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) out_pivot->axes[3 * i + k] = m[COLUMN * i + k];
    return true;
}

/* Judges the pivots of all nodes, each by its own faces: parts[i + 1] of the mesh are those of node i. */
static dm_result judge_pivots(dmi_env* env, const dmi_asset_query* query, const dm_asset_node* nodes,
                              dmi_pivot_kind* out) {
    const uint32_t count = query->node_count, parts = query->mesh->part_count;
    dm_pivot* pivots = dmi_arena_push(query->arena, parts * sizeof *pivots);
    const dm_pivot** known = dmi_arena_push(query->arena, parts * sizeof *known);
    dmi_pivot_gauge* gauges = dmi_arena_push(query->arena, parts * sizeof *gauges);
    dmi_pivot_witness* witnesses = dmi_arena_push(query->arena, parts * sizeof *witnesses);
    if (pivots == NULL || known == NULL || gauges == NULL || witnesses == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_asset_create: no memory for the pivots of %u nodes", count);
    known[0] = NULL;
    for (uint32_t i = 0; i < count; i++)
        known[i + 1] = dmi_asset_node_pivot(&nodes[i], &pivots[i + 1]) ? &pivots[i + 1] : NULL;
    dmi_part_pivots_measure(query->mesh, known, gauges, witnesses);
    dmi_pivots_judge(witnesses + 1, count, out);
    return DM_OK;
}

/* ---- the nodes of a body ---- */

typedef struct body_nodes {
    uint32_t* largest; /* node of each body with the largest surface */
    uint32_t* count;   /* number of its nodes with meshes */
    uint32_t* only;    /* one a node: the body of all meshes at it and below, SEVERAL or NOTHING */
} body_nodes;

static bool has_faces(const dmi_asset_query* query, uint32_t node) {
    return query->mesh->parts[node + 1].face_count > 0;
}

static uint32_t joined(uint32_t a, uint32_t b) {
    return a == NOTHING || a == b ? b : b == NOTHING ? a : SEVERAL;
}

static dm_result find_nodes(dmi_env* env, const dmi_asset_query* query, const dmi_asset_bodies* bodies,
                            body_nodes* out) {
    const uint32_t nodes = query->node_count;
    out->largest = dmi_arena_push(query->arena, bodies->count * sizeof *out->largest);
    out->count = dmi_arena_push(query->arena, bodies->count * sizeof *out->count);
    out->only = dmi_arena_push(query->arena, nodes * sizeof *out->only);
    if (out->largest == NULL || out->count == NULL || out->only == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_asset_create: no memory for %u nodes", nodes);
    memset(out->count, 0, bodies->count * sizeof *out->count);
    for (uint32_t i = 0; i < nodes; i++) {
        const uint32_t body = bodies->body_of_node[i];
        out->only[i] = !has_faces(query, i) ? NOTHING : body == DMI_ASSET_BODY ? SEVERAL : body;
        if (!has_faces(query, i) || body == DMI_ASSET_BODY) continue;
        const dmi_part* parts = query->mesh->parts;
        if (out->count[body]++ == 0 || parts[i + 1].area > parts[out->largest[body] + 1].area) out->largest[body] = i;
    }
    for (uint32_t k = nodes; k-- > 0;) {
        const uint32_t i = query->order[k], above = query->nodes[i].parent;
        if (above != DMI_ASSET_BODY) out->only[above] = joined(out->only[above], out->only[i]);
    }
    return DM_OK;
}

/* Returns the node at whose origin a body turns. */
static uint32_t find_pivot_node(const dmi_asset_query* query, const body_nodes* found, uint32_t body) {
    uint32_t node = found->largest[body];
    if (found->count[body] == 1) return node;
    for (uint32_t above = query->nodes[node].parent; above != DMI_ASSET_BODY && found->only[above] == body;
         above = query->nodes[above].parent)
        node = above;
    return node;
}

/* ---- labels ---- */

/* Writes the names of the nodes above a node, of its mesh and its own. The innermost ones stay where not all fit.
 * Returns the bytes with the zero. */
static size_t write_path(const dmi_asset_query* query, uint32_t index, char out[DM_MAX_LABEL + 1]) {
    const size_t size = DM_MAX_LABEL + 1;
    const dmi_asset_node* node = &query->nodes[index];
    out[size - 1] = 0;
    size_t used = dmi_put_name_before(out, size, 1, node->name);
    used = dmi_put_name_before(out, size, used, node->mesh_name);
    for (uint32_t above = node->parent; above != DMI_ASSET_BODY; above = query->nodes[above].parent)
        used = dmi_put_name_before(out, size, used, query->nodes[above].name);
    memmove(out, out + size - used, used);
    return used;
}

static const char* make_label(const dmi_asset_query* query, uint32_t node) {
    char path[DM_MAX_LABEL + 1];
    const size_t size = write_path(query, node, path);
    char* label = dmi_arena_push(query->arena, size);
    if (label != NULL) memcpy(label, path, size);
    return label;
}

/* Writes the pivot of a body and what is known of it, where that may say something. */
static void describe_pivot(const dm_asset_node* node, dmi_pivot_kind kind, dm_pivot* pivot, dm_part_desc* out_part) {
    if (kind == DMI_PIVOT_UNSET || !dmi_asset_node_pivot(node, pivot)) return;
    out_part->pivot = pivot;
    out_part->pivot_kind = kind == DMI_PIVOT_SET ? DM_PIVOT_SET : DM_PIVOT_UNKNOWN;
}

dm_result dmi_asset_describe_bodies(dmi_env* env, const dmi_asset_query* query, const dm_asset_node* nodes,
                                    const dmi_asset_bodies* bodies, dm_part_desc* out_parts) {
    body_nodes found;
    dm_pivot* pivots = dmi_arena_push(query->arena, bodies->count * sizeof *pivots);
    dmi_pivot_kind* kinds = dmi_arena_push(query->arena, query->node_count * sizeof *kinds);
    dm_result result = find_nodes(env, query, bodies, &found);
    if (result == DM_OK && (pivots == NULL || kinds == NULL))
        result = dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_asset_create: no memory for the pivots of parts");
    if (result == DM_OK) result = judge_pivots(env, query, nodes, kinds);
    for (uint32_t i = 0; i < bodies->count && result == DM_OK; i++) {
        const uint32_t turns_at = find_pivot_node(query, &found, i);
        if (query->use_names) out_parts[i].label = make_label(query, found.largest[i]);
        if (query->use_names && out_parts[i].label == NULL)
            result = dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_asset_create: no memory for the names of a part");
        describe_pivot(&nodes[turns_at], kinds[turns_at], &pivots[i], &out_parts[i]);
    }
    return result;
}

/* ---- joints that the asset states for its nodes ---- */

static void take_joint(const dm_joint* joint, dmi_asset_given* out) {
    out->basis = DM_ASSET_FROM_FILE;
    out->joint = *joint;
    out->joint.type_confidence = out->joint.joint_confidence = 1;
    out->joint.source = DM_JOINT_FROM_HOST;
    memset(out->joint.evidence, 0, sizeof out->joint.evidence);
}

/* The point near which the origin of a clip's joint lies: the node's own, or the middle of the asset. */
static void find_centre(const dm_asset_node* node, const dmi_frame* frame, float out[3]) {
    static const float middle[3] = {0, 0, 0};
    dm_pivot pivot;
    if (dmi_asset_node_pivot(node, &pivot))
        memcpy(out, dmi_xyz(pivot.origin).v, 3 * sizeof *out);
    else
        dmi_frame_point_out(frame, middle, out);
}

/* Takes the joint of the node's clips. Returns warnings. */
static uint32_t take_clips(const dm_asset_node* node, const dmi_frame* frame, dmi_asset_given* out) {
    float centre[3];
    find_centre(node, frame, centre);
    const dmi_clip_joint found =
        dmi_clip_find_joint(node->clips, node->clip_count, centre, dmi_frame_length_out(frame));
    if (found.is_found)
        *out = (dmi_asset_given){.basis = DM_ASSET_FROM_CLIP, .duration = found.duration, .joint = found.joint};
    return found.left_out ? DM_ASSET_CLIP_LEFT_OUT : 0;
}

void dmi_asset_read_given(const dm_asset_node* nodes, uint32_t count, bool use_clips, const dmi_frame* frame,
                          dmi_asset_given* out_given, uint32_t* out_warnings) {
    *out_warnings = 0;
    for (uint32_t i = 0; i < count; i++) {
        out_given[i] = (dmi_asset_given){0};
        if (nodes[i].joint != NULL)
            take_joint(nodes[i].joint, &out_given[i]);
        else if (use_clips && nodes[i].clip_count > 0 && !(nodes[i].flags & DM_ASSET_NODE_FOLLOWS))
            *out_warnings |= take_clips(&nodes[i], frame, &out_given[i]);
    }
}
