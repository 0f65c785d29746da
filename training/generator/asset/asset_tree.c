/* Gives nodes their pivots and puts empty nodes over them, as exporters leave them. Shares are set by hand; those of
 * pivots on the axis are by the counts of training/lab/hint_draw.c. */
#include <stdlib.h>
#include <string.h>

#include "asset/asset_layer.h"

/* What the nodes hang from. */
typedef enum tree {
    FLAT,
    ROOTED,        /* one empty node over all */
    LINK_GROUPS,   /* an empty node over what moves as one, below that of its carrier or beside it */
    FIRST_CARRIES, /* the first node of what moves as one is over its other nodes and over what it carries */
    FALSE_GROUPS,  /* empty nodes over nodes that move apart: collections, materials */
    TREES
} tree;

typedef enum spot { SPOT_ORIGIN, SPOT_CENTRE, SPOT_CORNER, SPOT_BOTTOM, SPOT_ARTIST, SPOTS } spot;

typedef struct planter {
    dmg_builder* b;
    dmg_asset* asset;
    uint32_t meshes;                                               /* nodes with faces, which come first */
    dmg_bounds* boxes;                                             /* of those */
    uint32_t first[DMG_PART_LIMIT + 1], group[DMG_PART_LIMIT + 1]; /* of each part: its first node, its empty node */
    dmg_frame frame; /* rotation and scale that all nodes have in the scene */
} planter;

/* ---- empty nodes ---- */

static uint32_t add_empty(planter* p, uint32_t part, uint32_t parent) {
    dmg_asset_node* node = &p->asset->nodes[p->asset->node_count];
    *node = (dmg_asset_node){.parent = parent, .part = part, .mesh = DMG_NO_NODE};
    return p->asset->node_count++;
}

/* Returns the nearest carrier of the part that has a node in `of`, or DMG_NO_NODE. */
static uint32_t carrier_in(const planter* p, const uint32_t* of, uint32_t part) {
    while (part != 0) {
        part = p->asset->object.joints[part - 1].parent;
        if (of[part] != DMG_NO_NODE) return of[part];
    }
    return DMG_NO_NODE;
}

static void group_links(planter* p) {
    const bool nested = dmg_chance(p->b, 0.6f), lone_too = dmg_chance(p->b, 0.5f), body_too = dmg_chance(p->b, 0.7f);
    for (uint32_t part = 0; part <= p->asset->object.joint_count; ++part) {
        uint32_t own = 0;
        for (uint32_t i = 0; i < p->meshes; ++i) own += p->asset->nodes[i].part == part;
        if (own == 0 || (own == 1 && !lone_too) || (part == 0 && !body_too)) continue;
        p->group[part] = add_empty(p, part, nested ? carrier_in(p, p->group, part) : DMG_NO_NODE);
    }
    for (uint32_t i = 0; i < p->meshes; ++i) {
        dmg_asset_node* node = &p->asset->nodes[i];
        node->parent = p->group[node->part];
        if (node->parent == DMG_NO_NODE && nested) node->parent = carrier_in(p, p->group, node->part);
    }
}

static void carry_by_first(planter* p) {
    const bool siblings = dmg_chance(p->b, 0.6f);
    for (uint32_t i = 0; i < p->meshes; ++i) {
        dmg_asset_node* node = &p->asset->nodes[i];
        const bool is_first = p->first[node->part] == i;
        if (!is_first && siblings) node->parent = p->first[node->part];
        if (is_first) node->parent = carrier_in(p, p->first, node->part);
    }
}

static void group_falsely(planter* p) {
    uint32_t groups[3];
    const int count = dmg_int(p->b, 1, 3);
    for (int i = 0; i < count; ++i) groups[i] = add_empty(p, DMG_NO_PART, DMG_NO_NODE);
    for (uint32_t i = 0; i < p->meshes; ++i)
        if (dmg_chance(p->b, 0.8f)) p->asset->nodes[i].parent = groups[dmg_int(p->b, 0, count - 1)];
}

/* Draws what one node over all turns and scales: up axes and centimetres of other programs. */
static dmg_frame draw_root_frame(dmg_builder* b) {
    dmg_frame frame = dmg_frame_identity();
    const bool turned = dmg_chance(b, 0.4f), scaled = dmg_chance(b, 0.3f);
    if (turned) frame = dmg_frame_screw(v3(0, 0, 0), v3(1, 0, 0), -0.5f * DMG_PI, 0.0f);
    for (int i = 0; scaled && i < 3; ++i) frame.column[i] = v3_scale(frame.column[i], 0.01f);
    return frame;
}

static void add_root(planter* p) {
    const uint32_t below = p->asset->node_count, root = add_empty(p, DMG_NO_PART, DMG_NO_NODE);
    p->frame = draw_root_frame(p->b);
    for (uint32_t i = 0; i < below; ++i)
        if (p->asset->nodes[i].parent == DMG_NO_NODE) p->asset->nodes[i].parent = root;
}

static void grow(planter* p) {
    static const float shares[TREES] = {0.4f, 0.14f, 0.22f, 0.16f, 0.08f};
    const tree how = (tree)dmg_weighted(p->b, shares, TREES);
    const bool rooted = dmg_chance(p->b, 0.5f);
    if (how == LINK_GROUPS) group_links(p);
    if (how == FIRST_CARRIES) carry_by_first(p);
    if (how == FALSE_GROUPS) group_falsely(p);
    if (how == ROOTED || (how != FLAT && rooted)) add_root(p);
}

/* ---- pivots ---- */

static void grow_boxes(planter* p) {
    const dmg_object* object = &p->asset->object;
    for (uint32_t i = 0; i < p->meshes; ++i) p->boxes[i] = dmg_bounds_none();
    for (uint32_t i = 0; i < 3 * object->face_count; ++i)
        dmg_bounds_grow(&p->boxes[p->asset->face_node[i / 3]],
                        v3_from(object->positions + 3 * (size_t)object->indices[i]));
}

static dmg_bounds box_of_part(const planter* p, uint32_t part) {
    dmg_bounds box = dmg_bounds_none();
    for (uint32_t i = 0; i < p->meshes; ++i) {
        if (p->asset->nodes[i].part != part) continue;
        dmg_bounds_grow(&box, p->boxes[i].low);
        dmg_bounds_grow(&box, p->boxes[i].high);
    }
    return box;
}

static dmg_vec bottom_of(const dmg_bounds* box) {
    const dmg_vec middle = v3_lerp(box->low, box->high, 0.5f);
    return v3(middle.x, box->low.y, middle.z);
}

/* Returns where who knows how a part moves puts its pivot: on the axis, at an end of the part or half way; that of what
 * slides in its middle; that of the body at its bottom. */
static dmg_vec artist_spot(planter* p, uint32_t part) {
    const dmg_bounds box = box_of_part(p, part);
    const dmg_vec middle = v3_lerp(box.low, box.high, 0.5f);
    static const float places[] = {0.25f, 0.1f, 0.65f};
    const int place = dmg_weighted(p->b, places, 3);
    if (part == 0) return bottom_of(&box);
    const dmg_joint* joint = &p->asset->object.joints[part - 1];
    if (joint->type == DM_JOINT_PRISMATIC) return middle;
    const dmg_vec axis = v3_from(joint->axis), origin = v3_from(joint->origin), size = v3_sub(box.high, box.low);
    const float half = 0.5f * (fabsf(axis.x) * size.x + fabsf(axis.y) * size.y + fabsf(axis.z) * size.z);
    const float along = v3_dot(v3_sub(middle, origin), axis);
    return v3_mad(origin, axis, place == 0 ? along - half : place == 1 ? along + half : along);
}

static void set_pivot(const planter* p, uint32_t node, dmg_vec at) {
    float* m = p->asset->nodes[node].transform;
    memset(m, 0, 16 * sizeof *m);
    for (int k = 0; k < 3; ++k) v3_to(p->frame.column[k], m + 4 * k);
    v3_to(at, m + 12);
    m[15] = 1.0f;
}

static dmg_vec default_spot(const dmg_bounds* box, spot where) {
    if (where == SPOT_CENTRE) return v3_lerp(box->low, box->high, 0.5f);
    if (where == SPOT_CORNER) return box->low;
    return where == SPOT_BOTTOM ? bottom_of(box) : v3(0, 0, 0);
}

static void set_pivots(planter* p) {
    static const float shares[SPOTS] = {0.36f, 0.15f, 0.05f, 0.09f, 0.35f};
    const spot where = (spot)dmg_weighted(p->b, shares, SPOTS);
    const bool all_at_links = dmg_chance(p->b, 0.6f), careful = dmg_chance(p->b, 0.7f);
    dmg_vec link[DMG_PART_LIMIT + 1];
    for (uint32_t part = 0; part <= p->asset->object.joint_count; ++part) {
        const dmg_vec at = artist_spot(p, part);
        link[part] = where == SPOT_ARTIST && (careful || dmg_chance(p->b, 0.7f)) ? at : v3(0, 0, 0);
    }
    for (uint32_t i = 0; i < p->meshes; ++i) {
        const uint32_t part = p->asset->nodes[i].part;
        const bool at_link = p->first[part] == i || all_at_links;
        dmg_vec at = default_spot(&p->boxes[i], where == SPOT_ARTIST ? SPOT_CENTRE : where);
        if (where == SPOT_ARTIST && at_link) at = link[part];
        set_pivot(p, i, at);
    }
    for (uint32_t i = p->meshes; i < p->asset->node_count; ++i) {
        const uint32_t part = p->asset->nodes[i].part;
        set_pivot(p, i, part == DMG_NO_PART ? v3(0, 0, 0) : link[part]);
    }
}

/* ---- all of it ---- */

static int open_planter(planter* p, dmg_builder* b, dmg_asset* asset) {
    *p = (planter){.b = b, .asset = asset, .meshes = asset->node_count, .frame = dmg_frame_identity()};
    const size_t most = asset->node_count + DMG_PART_LIMIT + 8;
    dmg_asset_node* nodes = realloc(asset->nodes, most * sizeof *nodes);
    if (nodes) asset->nodes = nodes;
    p->boxes = malloc((asset->node_count + 1) * sizeof *p->boxes);
    for (uint32_t part = 0; part <= DMG_PART_LIMIT; ++part) p->first[part] = p->group[part] = DMG_NO_NODE;
    for (uint32_t i = asset->node_count; nodes && i-- > 0;) p->first[nodes[i].part] = i;
    return !nodes || !p->boxes;
}

int dmg_plant_nodes(dmg_builder* b, dmg_asset* asset) {
    planter p;
    int failed = open_planter(&p, b, asset);
    if (!failed) {
        grow_boxes(&p);
        grow(&p);
        set_pivots(&p);
        if (dmg_chance(b, 0.4f)) failed = dmg_share_meshes(asset);
    }
    free(p.boxes);
    return failed;
}
