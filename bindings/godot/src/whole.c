/* Parts that nobody has marked: all nodes below the body are handed over as one asset, and the answer says which move.
 */
#include <stdlib.h>
#include <string.h>

#include "body.h"
#include "library.h"

#define UNKNOWN UINT32_MAX /* member.part of a node without triangles, until those about it are known */

static gd_value mesh_of(const gd_value* node) {
    gd_value mesh = gd_get(node, "mesh");
    if (gd_object(&mesh)) return mesh;
    gd_free(&mesh);
    return gd_nil();
}

/* ---- members ---- */

/* Whether a node is shown from near by: it is visible, and no coarser level of detail. */
static bool is_shown(const gd_value* node) {
    gd_value visible = gd_get(node, "visible"), begin = gd_get(node, "visibility_range_begin");
    const bool shown = gd_bool(&visible) && !(gd_float(&begin) > 0);
    gd_free(&begin);
    gd_free(&visible);
    return shown;
}

/* What is hidden, or hangs on what is hidden, is not looked at: it goes with what is above it. */
static void find_solid(body* b) {
    bool* hidden = calloc((size_t)b->member_count + 1, sizeof *hidden);
    for (uint32_t i = 0; hidden && i < b->member_count; i++) {
        member* m = &b->members[i];
        gd_value node = gd_node(m->node), mesh = mesh_of(&node);
        hidden[i] = !is_shown(&node) || (m->above && hidden[m->above - 1]);
        m->solid = !hidden[i] && gd_object(&mesh) && preparation_has_triangles(&mesh);
        gd_free(&mesh);
        gd_free(&node);
    }
    free(hidden);
}

void whole_find_members(body* b) {
    body_forget_parts(b);
    b->whole = true;
    b->walking++;
    gd_value nodes = body_nodes(b, "Node3D");
    const int64_t count = gd_count(&nodes);
    b->members = calloc((size_t)count + 1, sizeof *b->members);
    for (int64_t i = 0; b->members && i < count; i++) {
        gd_value node = gd_at(&nodes, i);
        b->members[b->member_count++] = (member){.node = gd_id(&node), .rest = body_place_of(b, &node)};
        gd_free(&node);
    }
    gd_free(&nodes);
    body_find_above(b);
    find_solid(b);
    b->walking--;
}

/* The name of a node; NULL: it has none but what Godot has given it, which says nothing. */
static char* name_of(const gd_value* node) {
    static const char* const given[] = {"@", "DragMeshBody3D"};
    char* name = body_text_of(node, "name");
    for (size_t i = 0; name && i < sizeof given / sizeof *given; i++)
        if (strncmp(name, given[i], strlen(given[i])) == 0) free(name), name = NULL;
    return name;
}

/* Whether a node is the root of a scene that has been put there: it stands for the file, and no file has it as a node.
 */
static bool is_file(const member* m, const gd_value* node) {
    char* path = m->solid ? NULL : body_text_of(node, "scene_file_path");
    const bool file = path && *path;
    free(path);
    return file;
}

/* Names of the whole: the body's, then those of the files that hang on it. */
static void add_label(preparation* p, const gd_value* node) {
    char* name = name_of(node);
    if (name) p->label = p->label ? body_joined(p->label, name, '/') : name;
}

preparation* whole_collect(body* b) {
    preparation* p = preparation_new(0, b->member_count + 1);
    uint32_t* parents = calloc((size_t)b->member_count + 1, sizeof *parents); /* of what hangs on a member: place + 1 */
    if (!p || !parents) {
        if (p) preparation_free(p);
        free(parents);
        return NULL;
    }
    const bool names = gd_bool(&b->properties[PROPERTY_NAMES]), pivots = gd_bool(&b->properties[PROPERTY_PIVOTS]);
    p->asset_flags = names ? 0 : DM_ASSET_WITHOUT_NAMES;
    gd_value self = body_self(b);
    if (names) add_label(p, &self);
    gd_free(&self);
    for (uint32_t i = 0; i < b->member_count; i++) {
        const member* m = &b->members[i];
        const uint32_t parent = m->above ? parents[m->above - 1] : 0;
        gd_value node = gd_node(m->node), mesh = m->solid ? mesh_of(&node) : gd_nil();
        const bool file = is_file(m, &node), named = names && !file;
        if (names && file && !parent) add_label(p, &node);
        parents[i] = file ? parent : i + 1;
        preparation_add_node(p, &mesh, &m->rest, parent, named ? name_of(&node) : NULL,
                             named && m->solid ? body_text_of(&mesh, "resource_name") : NULL,
                             pivots ? 0 : DM_ASSET_NODE_NO_PIVOT);
        gd_free(&mesh);
        gd_free(&node);
    }
    free(parents);
    return p;
}

/* ---- parts ---- */

/* Returns the nearest part that is, or carries, both; 0 = the body. */
static uint32_t common_carrier(const body* b, uint32_t first, uint32_t second) {
    for (; first; first = b->parts[first - 1].parent) {
        uint32_t other = second;
        while (other && other != first) other = b->parts[other - 1].parent;
        if (other) return first;
    }
    return 0;
}

/* A node without triangles, as a group or a light, goes with what all that hangs on it goes with, or hangs on what is
 * above it. */
static void place_others(body* b) {
    for (uint32_t i = b->member_count; i-- > 0;) {
        const member* m = &b->members[i];
        member* above = m->above ? &b->members[m->above - 1] : NULL;
        if (!above || above->solid || m->part == UNKNOWN) continue;
        above->part = above->part == UNKNOWN ? m->part : common_carrier(b, above->part, m->part);
    }
    for (uint32_t i = 0; i < b->member_count; i++) {
        member* m = &b->members[i];
        const uint32_t above = m->above ? b->members[m->above - 1].part : 0;
        if (m->part == UNKNOWN) m->part = above;
        m->placed = m->part != above;
    }
}

/* Returns the highest node of a part above its largest one; NULL: it has none. */
static const member* main_member(const body* b, uint32_t part) {
    const member* found = NULL;
    double largest = -1;
    for (uint32_t i = 0; i < b->member_count; i++) {
        const member* m = &b->members[i];
        if (!m->solid || m->part != part) continue;
        gd_value node = gd_node(m->node);
        const double size = gd_object(&node) ? body_size_of(b, &node) : 0;
        if (size > largest) largest = size, found = m;
        gd_free(&node);
    }
    while (found && found->above && b->members[found->above - 1].part == part) found = &b->members[found->above - 1];
    return found;
}

/* Makes the parts of an object, when the members with triangles have theirs. */
static dm_result make_parts(body* b, dm_object object) {
    dm_object_info info = dm_object_info_default();
    dm_result result = dm_object_get_info(library_context(), object, &info);
    if (result != DM_OK) return result;
    b->parts = calloc((size_t)info.part_count + 1, sizeof *b->parts);
    if (!b->parts) return DM_ERROR_OUT_OF_MEMORY;
    b->part_count = info.part_count;
    for (uint32_t i = 0; i < info.part_count && result == DM_OK; i++) {
        dm_part_info part = dm_part_info_default();
        result = dm_object_get_part(library_context(), object, i, &part);
        if (result == DM_OK && (part.id != i + 1 || part.parent > info.part_count)) result = DM_ERROR_NOT_FOUND;
        b->parts[i].parent = part.parent;
    }
    if (result == DM_OK) place_others(b);
    for (uint32_t i = 0; i < info.part_count && result == DM_OK; i++) {
        const member* m = main_member(b, i + 1);
        gd_value node = m ? gd_node(m->node) : gd_nil();
        if (m) body_fill_part(&b->parts[i], i + 1, m);
        if (!gd_object(&node)) result = DM_ERROR_NOT_FOUND; /* it was freed meanwhile */
        gd_free(&node);
    }
    return result;
}

static void forget_owners(body* b) {
    for (uint32_t i = 0; i < b->member_count; i++) b->members[i].part = b->members[i].solid ? 0 : UNKNOWN;
}

dm_result whole_take_answer(body* b, const preparation* p, dm_object object) {
    if (p->node_count != b->member_count) return DM_ERROR_OUT_OF_MEMORY;
    forget_owners(b);
    for (uint32_t i = 0; i < b->member_count; i++)
        if (b->members[i].solid) b->members[i].part = p->parts_of_nodes[i];
    return make_parts(b, object);
}

/* Gives the nodes of one string of `dmo_parts` to a part; false: one is not there. */
static bool give(body* b, char* paths, uint32_t part) {
    gd_value self = body_self(b);
    bool found = true;
    for (char *path = paths, *end; found && path && *path; path = end) {
        end = strchr(path, ':');
        if (end) *end++ = '\0';
        gd_value text = gd_of_text(path), node = gd_call(&self, "get_node_or_null", 1, &text);
        const GDObjectInstanceID id = gd_id(&node);
        found = false;
        for (uint32_t i = 0; i < b->member_count; i++)
            if (b->members[i].node == id && b->members[i].solid) b->members[i].part = part, found = true;
        gd_free(&node);
        gd_free(&text);
    }
    gd_free(&self);
    return found;
}

dm_result whole_take_paths(body* b, dm_object object) {
    const gd_value* all = &b->properties[PROPERTY_DMO_PARTS];
    const int64_t count = gd_count(all);
    bool found = count > 1;
    forget_owners(b);
    for (int64_t i = 0; i + 1 < count && found; i++) {
        gd_value paths = gd_at(all, i);
        char* text = gd_text(&paths);
        found = text && give(b, text, (uint32_t)i + 1);
        free(text);
        gd_free(&paths);
    }
    dm_object_info info = dm_object_info_default();
    dm_result result = dm_object_get_info(library_context(), object, &info);
    if (result == DM_OK && (!found || info.part_count + 1 != (uint64_t)count)) result = DM_ERROR_NOT_FOUND;
    return result == DM_OK ? make_parts(b, object) : result;
}
