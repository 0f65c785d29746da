/* Which nodes are marked as parts, and what they tell of their joints. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "library.h"
#include "settings.h"

#define SAME_PLACE 1e-5 /* m between the origins of two nodes that are one; by hand */

/* The part that a node belongs to: itself or the nearest above it; NULL: the body. */
static part* owner_of(body* b, const gd_value* node) {
    part* found = NULL;
    gd_value above = gd_copy(node);
    while (gd_object(&above) && gd_object(&above) != b->object) {
        found = body_part_of(b, &above);
        if (found) break;
        gd_value parent = gd_parent(&above);
        gd_free(&above);
        above = parent;
    }
    gd_free(&above);
    return found;
}

double body_size_of(const body* b, const gd_value* node) {
    gd_value box = gd_call(node, "get_aabb", 0, NULL), size = gd_get(&box, "size");
    const affine place = body_place_of(b, node);
    double sides[3], sum = 0;
    gd_vector3(&size, sides);
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++) {
            const double length = place.m[3 * row + column] * sides[column];
            sum += length * length;
        }
    gd_free(&size);
    gd_free(&box);
    return sum;
}

bool body_is_marked(const body* b) {
    char* stays = gd_text(&b->properties[PROPERTY_BODY]);
    const bool marked = gd_count(&b->properties[PROPERTY_PARTS]) > 0 || (stays && *stays);
    free(stays);
    return marked;
}

/* The node that stays: the one that the property names, else the largest. */
static GDObjectInstanceID body_node(const body* b, const gd_value* nodes) {
    gd_value self = body_self(b), named = gd_call(&self, "get_node_or_null", 1, &b->properties[PROPERTY_BODY]);
    GDObjectInstanceID chosen = gd_id(&named);
    if (chosen == gd_id(&self)) chosen = 0; /* an empty path */
    gd_free(&named);
    gd_free(&self);
    if (chosen) return chosen;
    double largest = -1;
    for (int64_t i = 0; i < gd_count(nodes); i++) {
        gd_value node = gd_at(nodes, i);
        const double size = body_size_of(b, &node);
        if (size > largest) largest = size, chosen = gd_id(&node);
        gd_free(&node);
    }
    return chosen;
}

static void add_part(body* b, const gd_value* node, const gd_value* entry) {
    part* p = &b->parts[b->part_count];
    memset(p, 0, sizeof *p);
    p->id = ++b->part_count;
    p->node = gd_id(node);
    p->rest = body_place_of(b, node);
    settings_read(&p->settings, entry, &p->locked);
}

void body_fill_part(part* p, uint32_t id, const member* m) {
    gd_value none = gd_nil();
    p->id = id, p->node = m->node, p->rest = m->rest;
    settings_read(&p->settings, &none, &p->locked);
}

/* The node that a NodePath names, from the body on; nil: none. */
static gd_value node_at(const body* b, const gd_value* path) {
    gd_value self = body_self(b);
    const gd_value node = gd_call(&self, "get_node_or_null", 1, path);
    gd_free(&self);
    return node;
}

static void add_listed_part(body* b, const gd_value* entry) {
    gd_value path = gd_get(entry, "node"), node = node_at(b, &path);
    if (gd_object(&node) && gd_object(&node) != b->object && !body_part_of(b, &node)) add_part(b, &node, entry);
    gd_free(&node);
    gd_free(&path);
}

/* What an entry says of other parts: what carries it, what opens its latch. */
static void find_others(body* b, const gd_value* entry) {
    gd_value path = gd_get(entry, "node"), node = node_at(b, &path), handles = gd_get(entry, "handles");
    gd_value carrier_path = gd_get(entry, "carrier"), carrier_node = node_at(b, &carrier_path);
    part *p = body_part_of(b, &node), *carrier = body_part_of(b, &carrier_node);
    if (p && carrier && !part_is_carried_by(b, carrier, p)) p->parent = carrier->id;
    for (int64_t i = 0; p && i < gd_count(&handles) && i < HANDLES; i++) {
        gd_value handle_path = gd_at(&handles, i), handle = node_at(b, &handle_path);
        const part* found = body_part_of(b, &handle);
        p->settings.handles[i] = found ? found->id : 0;
        gd_free(&handle);
        gd_free(&handle_path);
    }
    gd_free(&carrier_node);
    gd_free(&carrier_path);
    gd_free(&handles);
    gd_free(&node);
    gd_free(&path);
}

/* Whether a node is, or lies below, one of the first `count` parts. */
static bool is_listed(body* b, const gd_value* node, uint32_t count) {
    const part* owner = owner_of(b, node);
    return owner && owner->id <= count;
}

void body_find_parts(body* b) {
    body_forget_parts(b);
    b->walking++;
    const gd_value* listed = &b->properties[PROPERTY_PARTS];
    const int64_t listed_count = gd_count(listed);
    gd_value nodes = body_nodes(b, "MeshInstance3D");
    const int64_t mesh_count = gd_count(&nodes), most = listed_count + mesh_count;
    b->parts = calloc((size_t)most + 1, sizeof *b->parts);
    for (int64_t i = 0; b->parts && i < listed_count; i++) {
        gd_value entry = gd_at(listed, i);
        add_listed_part(b, &entry);
        gd_free(&entry);
    }
    const uint32_t listed_parts = b->part_count;
    const GDObjectInstanceID stays = body_node(b, &nodes);
    for (int64_t i = 0; b->parts && i < mesh_count; i++) {
        gd_value node = gd_at(&nodes, i), none = gd_nil();
        if (gd_id(&node) != stays && !is_listed(b, &node, listed_parts)) add_part(b, &node, &none);
        gd_free(&node);
    }
    gd_free(&nodes);
    for (uint32_t i = 0; b->parts && i < b->part_count; i++) {
        gd_value node = part_node(&b->parts[i]), above = gd_parent(&node);
        const part* carrier = owner_of(b, &above);
        b->parts[i].parent = carrier ? carrier->id : 0;
        gd_free(&above);
        gd_free(&node);
    }
    for (int64_t i = 0; b->parts && i < listed_count; i++) {
        gd_value entry = gd_at(listed, i);
        find_others(b, &entry);
        gd_free(&entry);
    }
    body_place_marked(b);
    b->walking--;
}

/* The names of the nodes from the body down to the part, and of its mesh. */
static char* label_of(const body* b, const gd_value* node) {
    char* label = body_text_of(node, "name");
    gd_value above = gd_copy(node), mesh = gd_get(node, "mesh");
    while (gd_object(&above) && gd_object(&above) != b->object) {
        gd_value parent = gd_parent(&above);
        gd_free(&above);
        above = parent;
        if (gd_object(&above)) label = body_joined(body_text_of(&above, "name"), label, '/');
    }
    char* mesh_name = gd_object(&mesh) ? body_text_of(&mesh, "resource_name") : NULL;
    if (mesh_name && *mesh_name)
        label = body_joined(label, mesh_name, '/');
    else
        free(mesh_name);
    gd_free(&mesh);
    gd_free(&above);
    return label;
}

static void add_node(body* b, preparation* p, const gd_value* node) {
    gd_value mesh = gd_get(node, "mesh");
    const part* owner = owner_of(b, node);
    const affine place = body_place_of(b, node);
    if (gd_object(&mesh)) preparation_add_mesh(p, &mesh, &place, owner ? owner->id : 0);
    gd_free(&mesh);
}

/* Whether all nodes with a mesh stand at one place: then the file has lost its pivots, and theirs say nothing. */
static bool pivots_are_lost(const body* b, const gd_value* nodes) {
    double first[3] = {0};
    bool same = true;
    for (int64_t i = 0; same && i < gd_count(nodes); i++) {
        gd_value node = gd_at(nodes, i);
        const affine place = body_place_of(b, &node);
        for (int k = 0; k < 3; k++) {
            if (i == 0) first[k] = place.m[9 + k];
            same &= fabs(place.m[9 + k] - first[k]) <= SAME_PLACE;
        }
        gd_free(&node);
    }
    return same;
}

preparation* body_collect(body* b) {
    preparation* p = preparation_new(b->part_count, 0);
    if (!p) return NULL;
    gd_value nodes = body_nodes(b, "MeshInstance3D");
    for (int64_t i = 0; i < gd_count(&nodes); i++) {
        gd_value node = gd_at(&nodes, i);
        add_node(b, p, &node);
        gd_free(&node);
    }
    const bool names = gd_bool(&b->properties[PROPERTY_NAMES]),
               pivots = gd_bool(&b->properties[PROPERTY_PIVOTS]) && !pivots_are_lost(b, &nodes);
    gd_free(&nodes);
    for (uint32_t i = 0; i < b->part_count; i++) {
        const part* q = &b->parts[i];
        gd_value node = part_node(q);
        preparation_add_part(p, q->id, q->parent, q->settings.joint_type, names ? label_of(b, &node) : NULL,
                             pivots ? &q->rest : NULL);
        gd_free(&node);
    }
    return p;
}
