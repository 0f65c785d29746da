/* Where nodes are, what is above what, and where they are put when their parts move. */
#include <stdlib.h>

#include "body.h"
#include "library.h"

static affine transform_of(const gd_value* node) {
    affine out = affine_identity();
    gd_value transform = gd_get(node, "transform");
    if (gd_is(&transform, GDEXTENSION_VARIANT_TYPE_TRANSFORM3D)) gd_transform(&transform, out.m);
    gd_free(&transform);
    return out;
}

affine body_place_of(const body* b, const gd_value* node) {
    affine place = affine_identity();
    gd_value above = gd_copy(node);
    while (gd_object(&above) && gd_object(&above) != b->object) {
        const affine own = transform_of(&above);
        place = affine_after(&own, &place);
        gd_value parent = gd_parent(&above);
        gd_free(&above);
        above = parent;
    }
    gd_free(&above);
    return place;
}

/* How many nodes there are from the body down to one. */
static uint32_t depth_of(const body* b, GDObjectInstanceID id) {
    uint32_t depth = 0;
    gd_value above = gd_node(id);
    while (gd_object(&above) && gd_object(&above) != b->object) {
        gd_value parent = gd_parent(&above);
        gd_free(&above);
        above = parent;
        depth++;
    }
    gd_free(&above);
    return depth;
}

static int by_depth(const void* a, const void* b) {
    const member *first = a, *second = b;
    return (first->above > second->above) - (first->above < second->above);
}

/* The member that a node is or lies below: its place + 1; 0 = none. */
static uint32_t member_at(const body* b, const gd_value* node) {
    uint32_t found = 0;
    gd_value at = gd_copy(node);
    while (!found && gd_object(&at) && gd_object(&at) != b->object) {
        const GDObjectInstanceID id = gd_id(&at);
        for (uint32_t i = 0; i < b->member_count && !found; i++)
            if (b->members[i].node == id) found = i + 1;
        gd_value parent = gd_parent(&at);
        gd_free(&at);
        at = parent;
    }
    gd_free(&at);
    return found;
}

void body_find_above(body* b) {
    for (uint32_t i = 0; i < b->member_count; i++) {
        gd_value node = gd_node(b->members[i].node), parent = gd_parent(&node);
        b->members[i].above = member_at(b, &parent);
        gd_free(&parent);
        gd_free(&node);
    }
}

void body_place_marked(body* b) {
    b->members = calloc((size_t)b->part_count + 1, sizeof *b->members);
    if (!b->members) {
        body_forget_parts(b);
        return;
    }
    b->member_count = b->part_count;
    for (uint32_t i = 0; i < b->part_count; i++) {
        const part* p = &b->parts[i];
        b->members[i] = (member){.node = p->node, .rest = p->rest, .part = p->id, .placed = true};
        b->members[i].above = depth_of(b, p->node); /* what they are sorted by, first */
    }
    qsort(b->members, b->member_count, sizeof *b->members, by_depth);
    body_find_above(b);
}

/* The path of a node after those before it, with a colon between, which no name has; frees `before`. */
static char* with_path(const gd_value* self, GDObjectInstanceID id, char* before) {
    gd_value node = gd_node(id);
    if (!gd_object(&node)) return before; /* it was freed meanwhile */
    gd_value path = gd_call(self, "get_path_to", 1, &node);
    char* text = gd_text(&path);
    if (before) text = body_joined(before, text, ':');
    gd_free(&path);
    gd_free(&node);
    return text;
}

/* The paths of the nodes of a part; part 0: of those with triangles that the body of an asset has. */
static gd_value paths_of(const body* b, const gd_value* self, uint32_t part) {
    char* text = NULL;
    for (uint32_t i = 0; i < b->member_count; i++) {
        const member* m = &b->members[i];
        if (m->part == part && (m->solid || !b->whole)) text = with_path(self, m->node, text);
    }
    const gd_value value = gd_of_text(text ? text : "");
    free(text);
    return value;
}

gd_value body_part_paths(const body* b) {
    gd_value paths = gd_new(GDEXTENSION_VARIANT_TYPE_PACKED_STRING_ARRAY), self = body_self(b);
    for (uint32_t id = 1; id <= b->part_count; id++) gd_append(&paths, paths_of(b, &self, id));
    if (b->whole) gd_append(&paths, paths_of(b, &self, 0));
    gd_free(&self);
    return paths;
}

static dm_pose identity_pose(void) {
    return (dm_pose){.real = {0, 0, 0, 1}};
}

dm_pose body_carrier(body* b, const part* p) {
    const part* carrier = body_part(b, p->parent);
    dm_pose out = identity_pose();
    if (!carrier) return out;
    const dm_pose above = body_carrier(b, carrier), own = carrier->moved ? carrier->state.pose : out;
    dm_pose_multiply(&above, &own, &out);
    return out;
}

/* Puts a node where its part is now. */
static void place(body* b, const member* m) {
    const part* p = body_part(b, m->part);
    dm_pose pose = p ? body_carrier(b, p) : identity_pose();
    if (p && p->moved) dm_pose_multiply(&pose, &p->state.pose, &pose);
    gd_value node = gd_node(m->node), parent = gd_parent(&node);
    if (gd_object(&node)) {
        const affine moved = affine_of_pose(&pose), wanted = affine_after(&moved, &m->rest);
        const affine from = body_place_of(b, &parent), back = affine_inverse(&from),
                     local = affine_after(&back, &wanted);
        gd_value transform = gd_of_transform(local.m);
        gd_do(&node, "set_transform", 1, &transform);
        gd_free(&transform);
    }
    gd_free(&parent);
    gd_free(&node);
}

/* Whether a member moves when a part does: with it, or since the scene has it below what moves. */
static bool is_moved_by(body* b, const member* m, const part* p) {
    for (; !part_is_carried_by(b, body_part(b, m->part), p); m = &b->members[m->above - 1])
        if (!m->above) return false;
    return true;
}

void body_show(body* b, part* p) {
    b->walking++;
    for (uint32_t i = 0; i < b->member_count; i++)
        if (b->members[i].placed && is_moved_by(b, &b->members[i], p)) place(b, &b->members[i]);
    for (uint32_t i = 0; b->scene && i < b->part_count; i++) {
        const part* moved = &b->parts[i];
        if (!part_is_carried_by(b, moved, p)) continue;
        dm_pose pose = body_carrier(b, moved);
        if (moved->moved) dm_pose_multiply(&pose, &moved->state.pose, &pose);
        dm_scene_move(library_context(), b->scene, b->instance, moved->id, &pose);
    }
    b->walking--;
}
