/* Makes parts of nodes: bodies by their names, places and shapes; joints of all of them; then which of them move. */
#include "assets/asset.h"

#include <string.h>

#include "assets/asset_grouping.h"
#include "assets/asset_models.h"
#include "assets/body_hints.h"
#include "assets/free_bodies.h"
#include "assets/node_labels.h"

#define BLOCK ((size_t)1 << 16) /* bytes, of the arena; by hand */

/* The work of one call. */
typedef struct making {
    dmi_env* env;
    dmi_picker* picker;
    const dmi_asset_desc* desc;
    dmi_arena arena;
    dmi_mesh* mesh; /* parts[i + 1] is node i */
    dmi_asset_node* nodes;
    dmi_asset_given* given; /* one a node */
    uint32_t* given_node;   /* the node of each body with what is stated for it; DM_ASSET_NO_NODE: nothing is */
    uint32_t* order;
    dmi_asset_query query;
    dmi_asset_bodies bodies;
    dmi_object* object;
    uint32_t warnings;
} making;

static dm_result out_of_memory(dmi_env* env, uint32_t nodes) {
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_asset_create: no memory for %u nodes", nodes);
}

/* ---- the nodes ---- */

static dm_result order_nodes(making* work) {
    const uint32_t count = work->desc->node_count;
    uint32_t* above = dmi_arena_push(&work->arena, count * sizeof *above);
    uint8_t* done = dmi_arena_push(&work->arena, count);
    work->order = dmi_arena_push(&work->arena, count * sizeof *work->order);
    if (above == NULL || done == NULL || work->order == NULL) return out_of_memory(work->env, count);
    for (uint32_t i = 0; i < count; i++) above[i] = work->desc->nodes[i].parent;
    if (dmi_asset_order_nodes(above, count, work->order, done) == DM_ASSET_NO_NODE) return DM_OK;
    return dmi_fail(work->env, DM_ERROR_INTERNAL, "dm_asset_create: parents form a circle");
}

static dmi_asset_node describe_node(const dm_asset_node* given) {
    return (dmi_asset_node){.name = given->name != NULL ? given->name : "",
                            .mesh_name = given->mesh_name != NULL ? given->mesh_name : "",
                            .parent = given->parent,
                            .follows = (given->flags & DM_ASSET_NODE_FOLLOWS) != 0,
                            .is_fixed = given->joint != NULL && given->joint->type == DM_JOINT_FIXED,
                            .given_body = DMI_ASSET_BODY};
}

/* Numbers the parts that the file states: a node without a joint of its own is of the part above it. */
static void number_given_parts(making* work) {
    for (uint32_t k = 0; k < work->desc->node_count; k++) {
        const uint32_t i = work->order[k];
        dmi_asset_node* node = &work->nodes[i];
        const bool moves = work->given[i].basis != DM_ASSET_INFERRED && !node->is_fixed;
        if (moves)
            node->given_body = i;
        else if (node->parent != DMI_ASSET_BODY)
            node->given_body = work->nodes[node->parent].given_body;
    }
}

static dm_result describe_nodes(making* work) {
    const dmi_asset_desc* desc = work->desc;
    const uint32_t count = desc->node_count;
    work->nodes = dmi_arena_push(&work->arena, count * sizeof *work->nodes);
    work->given = dmi_arena_push(&work->arena, count * sizeof *work->given);
    if (work->nodes == NULL || work->given == NULL) return out_of_memory(work->env, count);
    for (uint32_t i = 0; i < count; i++) work->nodes[i] = describe_node(&desc->nodes[i]);
    dmi_asset_read_given(desc->nodes, count, desc->use_clips, &work->mesh->frame, work->given, &work->warnings);
    number_given_parts(work);
    work->query = (dmi_asset_query){.mesh = work->mesh,
                                    .nodes = work->nodes,
                                    .order = work->order,
                                    .node_count = count,
                                    .use_names = desc->use_names,
                                    .min_moves = desc->min_moves,
                                    .arena = &work->arena};
    return DM_OK;
}

/* ---- the bodies ---- */

/* Drops bodies without any surface. */
static dm_result drop_flat_bodies(making* work) {
    dmi_asset_bodies* bodies = &work->bodies;
    uint8_t* keep = dmi_arena_push(&work->arena, bodies->count);
    uint32_t* scratch = dmi_arena_push(&work->arena, bodies->count * sizeof *scratch);
    if (keep == NULL || scratch == NULL) return out_of_memory(work->env, work->desc->node_count);
    memset(keep, 0, bodies->count);
    for (uint32_t i = 0; i < work->desc->node_count; i++) {
        const uint32_t body = bodies->body_of_node[i];
        if (body != DMI_ASSET_BODY && work->mesh->parts[i + 1].area > 0) keep[body] = 1;
    }
    dmi_asset_bodies_keep(bodies, work->desc->node_count, keep, scratch);
    return DM_OK;
}

static dm_result find_bodies(making* work) {
    const dmi_progress finding =
        dmi_progress_piece(work->desc->progress, DMI_STAGE_BODIES_MESH_MEASURED, DMI_STAGE_BODIES_KNOWN);
    dmi_asset_models models;
    dm_result result = dmi_asset_models_load(work->env, dmi_asset_weights, dmi_asset_weights_size, &models);
    if (result != DM_OK) return result;
    work->query.progress = &finding;
    work->query.models = &models;
    result = dmi_asset_find_bodies(work->env, &work->query, &work->bodies);
    work->query.models = NULL;
    dmi_asset_models_release(&models);
    if (result == DM_OK) result = drop_flat_bodies(work);
    if (result == DM_OK) result = dmi_progress_tell(&finding, 1);
    work->query.progress = NULL;
    return result;
}

/* ---- joints ---- */

/* Writes the id of each face's body. Where the faces of no body have no surface, they go with the first body: they
 * would be no body by themselves. */
static void set_face_ids(const making* work) {
    dmi_asset_mesh* mesh = work->desc->mesh;
    float staying = 0;
    for (uint32_t i = 0; i < work->desc->node_count; i++)
        if (work->bodies.body_of_node[i] == DMI_ASSET_BODY) staying += work->mesh->parts[i + 1].area;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t body = work->bodies.body_of_node[work->mesh->face_part[f] - 1];
        mesh->face_id[f] = body != DMI_ASSET_BODY ? body + 1 : staying > 0 ? 0 : 1;
    }
}

/* Finds what the asset states for each body, in the order of its nodes. */
static dm_result find_given(making* work) {
    work->given_node = dmi_arena_push(&work->arena, work->bodies.count * sizeof *work->given_node);
    if (work->given_node == NULL) return out_of_memory(work->env, work->desc->node_count);
    for (uint32_t i = 0; i < work->bodies.count; i++) work->given_node[i] = DM_ASSET_NO_NODE;
    for (uint32_t k = work->desc->node_count; k-- > 0;) {
        const uint32_t i = work->order[k], body = work->bodies.body_of_node[i];
        if (body != DMI_ASSET_BODY && work->nodes[i].given_body == i) work->given_node[body] = i;
    }
    return DM_OK;
}

/* Returns what the asset states for a body; NULL: nothing. */
static const dmi_asset_given* given_of(const making* work, uint32_t body) {
    const uint32_t node = work->given_node[body];
    return node != DM_ASSET_NO_NODE ? &work->given[node] : NULL;
}

static dm_result describe_parts(making* work, dm_part_desc* out_parts) {
    for (uint32_t i = 0; i < work->bodies.count; i++) {
        const uint32_t carrier = work->bodies.bodies[i].carrier;
        const dmi_asset_given* given = given_of(work, i);
        out_parts[i] = (dm_part_desc){.struct_size = sizeof(dm_part_desc),
                                      .id = i + 1,
                                      .parent = carrier == DMI_ASSET_BODY ? 0 : carrier + 1,
                                      .joint_type = given != NULL ? given->joint.type : DM_JOINT_UNKNOWN};
    }
    return dmi_asset_describe_bodies(work->env, &work->query, work->desc->nodes, &work->bodies, out_parts);
}

static dm_result infer_joints(making* work) {
    const dmi_asset_desc* desc = work->desc;
    const dmi_progress preparing =
        dmi_progress_piece(desc->progress, DMI_STAGE_BODIES_KNOWN, DMI_STAGE_BODIES_JOINTS_KNOWN);
    dm_part_desc* parts = dmi_arena_push(&work->arena, work->bodies.count * sizeof *parts);
    if (parts == NULL) return out_of_memory(work->env, desc->node_count);
    dm_result result = find_given(work);
    if (result == DM_OK) result = describe_parts(work, parts);
    if (result != DM_OK) return result;
    set_face_ids(work);
    const dm_mesh_desc mesh = dmi_asset_mesh_describe(desc->mesh);
    dmi_object_labels labels = desc->labels;
    if (!desc->use_names) labels.label = NULL;
    const dmi_prepare_desc inner = {.axes = desc->axes,
                                    .mesh = &mesh,
                                    .parts = parts,
                                    .part_count = work->bodies.count,
                                    .models = desc->models,
                                    .labels = labels,
                                    .seed = desc->seed,
                                    .mesh_is_incomplete = desc->mesh_is_incomplete,
                                    .keep_triangles = true,
                                    .without_trees = true,
                                    .watched = &preparing};
    return dmi_object_prepare(work->env, work->picker, &inner, &work->object);
}

/* ---- the order of the parts ---- */

/* Orders the bodies by their first nodes, those of a probability of min_moves and more before the others. out_number:
 * the place that each of them had before -> its place now. All memory comes from the arena. */
static dm_result renumber_bodies(dmi_arena* arena, dmi_asset_bodies* bodies, uint32_t node_count, float min_moves,
                                 uint32_t** out_number) {
    const uint32_t count = bodies->count;
    uint32_t* number = dmi_arena_push(arena, (count + 1) * sizeof *number);
    dmi_asset_body* old = dmi_arena_push(arena, (count + 1) * sizeof *old);
    if (number == NULL || old == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memcpy(old, bodies->bodies, count * sizeof *old);
    for (uint32_t i = 0; i < count; i++) number[i] = DMI_ASSET_BODY;
    uint32_t next = 0;
    for (int moving = 1; moving >= 0; moving--)
        for (uint32_t n = 0; n < node_count; n++) {
            const uint32_t body = bodies->body_of_node[n];
            if (body == DMI_ASSET_BODY || number[body] != DMI_ASSET_BODY) continue;
            if ((old[body].moves >= min_moves) == (moving == 1)) number[body] = next++;
        }
    for (uint32_t i = 0; i < count; i++) {
        dmi_asset_body* body = &bodies->bodies[number[i]];
        *body = old[i];
        if (body->carrier != DMI_ASSET_BODY) body->carrier = number[body->carrier];
    }
    for (uint32_t n = 0; n < node_count; n++)
        if (bodies->body_of_node[n] != DMI_ASSET_BODY) bodies->body_of_node[n] = number[bodies->body_of_node[n]];
    *out_number = number;
    return DM_OK;
}

/* Joints are inferred in the order in which the bodies are found, so that what a host is told last, their numbers,
 * changes no joint. */
static dm_result order_bodies(making* work) {
    const uint32_t count = work->bodies.count;
    uint32_t *number = NULL, *given_node = dmi_arena_push(&work->arena, count * sizeof *given_node);
    if (given_node == NULL ||
        renumber_bodies(&work->arena, &work->bodies, work->desc->node_count, work->desc->min_moves, &number) != DM_OK)
        return out_of_memory(work->env, work->desc->node_count);
    for (uint32_t i = 0; i < count; i++) given_node[number[i]] = work->given_node[i];
    work->given_node = given_node;
    dmi_object* ordered;
    const dm_result result = dmi_object_reorder_parts(work->env, work->object, number, &ordered);
    if (result != DM_OK) return result;
    dmi_object_destroy(work->env, work->object);
    work->object = ordered;
    return DM_OK;
}

/* ---- what nothing holds ---- */

static void read_name(const char* name, dmi_asset_named* named) {
    const dmi_part_kind kind = dmi_kind_of_label(name).kind;
    if (kind == DMI_KIND_POT)
        named->vessel = true;
    else if (kind != DMI_KIND_NOTHING && !dmi_kind_is_part(kind))
        named->other = true;
}

/* Reads what the names call the asset. A vessel counts before other objects: a pot on a stove. */
static dmi_asset_named read_names(const making* work) {
    dmi_asset_named named = {0};
    if (!work->desc->use_names) return named;
    read_name(work->desc->labels.label, &named);
    for (uint32_t i = 0; i < work->desc->node_count; i++) {
        read_name(work->nodes[i].name, &named);
        read_name(work->nodes[i].mesh_name, &named);
    }
    named.other = named.other && !named.vessel;
    return named;
}

/* ---- the asset ---- */

/* Lists the nodes part after part. */
static void list_nodes(dmi_asset* asset) {
    for (uint32_t i = 0; i < asset->node_count; i++)
        if (asset->part_of_node[i] != DMI_ASSET_BODY) asset->parts[asset->part_of_node[i]].node_count++;
    for (uint32_t p = 0, next = 0; p < asset->part_count; p++) {
        asset->parts[p].first_node = next;
        next += asset->parts[p].node_count;
        asset->parts[p].node_count = 0;
    }
    for (uint32_t i = 0; i < asset->node_count; i++) {
        if (asset->part_of_node[i] == DMI_ASSET_BODY) continue;
        dmi_asset_part* part = &asset->parts[asset->part_of_node[i]];
        asset->nodes[part->first_node + part->node_count++] = i;
    }
}

/* Nodes that follow others are of their parts. */
static dm_result place_followers(making* work, uint32_t* body_of_node) {
    const uint32_t count = work->desc->node_count;
    uint32_t* target = dmi_arena_push(&work->arena, count * sizeof *target);
    uint32_t* order = dmi_arena_push(&work->arena, count * sizeof *order);
    uint8_t* done = dmi_arena_push(&work->arena, count);
    if (target == NULL || order == NULL || done == NULL) return out_of_memory(work->env, count);
    for (uint32_t i = 0; i < count; i++) target[i] = dmi_asset_followed(&work->desc->nodes[i]);
    dmi_asset_order_nodes(target, count, order, done);
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t i = order[k];
        if (!work->nodes[i].follows) continue;
        body_of_node[i] = target[i] != DM_ASSET_NO_NODE ? body_of_node[target[i]] : DMI_ASSET_BODY;
    }
    return DM_OK;
}

static void fill_part(const making* work, uint32_t index, dmi_asset_named named, dmi_asset_part* out) {
    const dmi_asset_body* body = &work->bodies.bodies[index];
    const dmi_asset_given* given = given_of(work, index);
    *out =
        (dmi_asset_part){.carrier = body->carrier, .state = DM_ASSET_MOVES, .moves = given != NULL ? 1 : body->moves};
    if (given != NULL) {
        out->given = *given;
        work->object->parts[index + 1].joint = given->joint;
    } else if (body->moves < work->desc->min_moves) {
        out->state = DM_ASSET_STAYS;
    } else if (dmi_body_is_free(work->object, index + 1, named)) {
        out->state = DM_ASSET_FREE;
        dmi_body_set_free(work->object, index + 1);
    }
}

static dm_result fill(making* work, dmi_asset* asset) {
    asset->part_count = work->bodies.count;
    asset->node_count = work->desc->node_count;
    asset->triangle_count = work->desc->mesh->face_count;
    asset->warnings = work->warnings;
    asset->parts = dmi_alloc_zeroed(work->env, asset->part_count * sizeof *asset->parts, DMI_ALIGNMENT);
    asset->part_of_node = dmi_alloc(work->env, asset->node_count * sizeof *asset->part_of_node, DMI_ALIGNMENT);
    asset->nodes = dmi_alloc(work->env, asset->node_count * sizeof *asset->nodes, DMI_ALIGNMENT);
    if (asset->parts == NULL || asset->part_of_node == NULL || asset->nodes == NULL)
        return out_of_memory(work->env, asset->node_count);
    const dmi_asset_named named = read_names(work);
    for (uint32_t i = 0; i < asset->part_count; i++) fill_part(work, i, named, &asset->parts[i]);
    memcpy(asset->part_of_node, work->bodies.body_of_node, asset->node_count * sizeof *asset->part_of_node);
    const dm_result result = place_followers(work, asset->part_of_node);
    if (result != DM_OK) return result;
    list_nodes(asset);
    asset->object = work->object;
    work->object = NULL;
    return DM_OK;
}

static dm_result make(making* work, dmi_asset* asset) {
    const dmi_asset_desc* desc = work->desc;
    const dmi_progress measuring = dmi_progress_piece(desc->progress, 0, DMI_STAGE_BODIES_MESH_MEASURED);
    const dm_mesh_desc mesh = dmi_asset_mesh_describe(desc->mesh);
    dm_result result =
        dmi_mesh_create_numbered(work->env, desc->axes, &mesh, desc->node_count, &measuring, &work->mesh);
    if (result == DM_OK) result = order_nodes(work);
    if (result == DM_OK) result = describe_nodes(work);
    if (result == DM_OK) result = find_bodies(work);
    if (result == DM_OK && work->bodies.count > 0) result = infer_joints(work);
    if (result == DM_OK && work->bodies.count > 0) result = order_bodies(work);
    if (result == DM_OK) result = fill(work, asset);
    return result == DM_OK ? dmi_progress_tell(desc->progress, 1) : result;
}

dm_result dmi_asset_create(dmi_env* env, dmi_picker* picker, const dmi_asset_desc* desc, dmi_asset** out_asset) {
    dmi_asset* asset = dmi_alloc_zeroed(env, sizeof *asset, _Alignof(dmi_asset));
    if (asset == NULL) return out_of_memory(env, desc->node_count);
    making work = {.env = env, .picker = picker, .desc = desc};
    dmi_arena_init(&work.arena, env, BLOCK);
    const dm_result result = make(&work, asset);
    dmi_object_destroy(env, work.object);
    dmi_mesh_destroy(env, work.mesh);
    dmi_arena_release(&work.arena);
    if (result != DM_OK) {
        dmi_asset_destroy(env, asset);
        return result;
    }
    *out_asset = asset;
    return DM_OK;
}

void dmi_asset_destroy(dmi_env* env, dmi_asset* asset) {
    if (asset == NULL) return;
    dmi_object_destroy(env, asset->object);
    dmi_free(env, asset->parts, asset->part_count * sizeof *asset->parts);
    dmi_free(env, asset->part_of_node, asset->node_count * sizeof *asset->part_of_node);
    dmi_free(env, asset->nodes, asset->node_count * sizeof *asset->nodes);
    dmi_free(env, asset, sizeof *asset);
}

dm_result dmi_asset_make_object(dmi_env* env, dmi_picker* picker, const dmi_asset* asset, bool keep_triangles,
                                dmi_object** out_object) {
    uint8_t* keep = dmi_alloc_zeroed(env, asset->part_count + 1, 1);
    if (keep == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_asset_make_object: no memory");
    bool any = false;
    for (uint32_t i = 0; i < asset->part_count; i++) {
        keep[i + 1] = asset->parts[i].state != DM_ASSET_STAYS;
        any = any || keep[i + 1];
    }
    const dm_result result =
        any ? dmi_object_select_parts(env, picker, asset->object, keep, keep_triangles, out_object)
            : dmi_fail(env, DM_ERROR_EMPTY_MASK, "dm_asset_make_object: no part of the asset moves");
    dmi_free(env, keep, asset->part_count + 1);
    return result;
}
