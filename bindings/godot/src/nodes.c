/* The parts that a body has, its nodes, and what they are called. */
#include <stdlib.h>
#include <string.h>

#include "body.h"
#include "library.h"

gd_value body_self(const body* b) {
    return gd_of_object(b->object);
}

gd_value part_node(const part* p) {
    return gd_node(p->node);
}

part* body_part(body* b, uint32_t id) {
    return id && id <= b->part_count ? &b->parts[id - 1] : NULL;
}

part* body_part_of(body* b, const gd_value* node) {
    const GDObjectInstanceID id = gd_id(node);
    for (uint32_t i = 0; id && i < b->part_count; i++)
        if (b->parts[i].node == id) return &b->parts[i];
    for (uint32_t i = 0; id && b->whole && i < b->member_count; i++)
        if (b->members[i].node == id) return body_part(b, b->members[i].part);
    return NULL;
}

bool part_is_carried_by(body* b, const part* p, const part* other) {
    while (p && p != other) p = body_part(b, p->parent);
    return p != NULL;
}

void part_end(part* p) {
    if (!p->drag) return;
    dm_part_state end = dm_part_state_default();
    if (dm_drag_end(library_context(), p->drag, &end) == DM_OK) p->state = end, p->moved = true;
    p->drag = 0;
    p->held = p->by_mouse = false;
}

void body_forget_parts(body* b) {
    for (uint32_t i = 0; i < b->part_count; i++) part_end(&b->parts[i]);
    free(b->parts);
    free(b->members);
    b->parts = NULL, b->part_count = 0;
    b->members = NULL, b->member_count = 0;
    b->whole = false;
}

gd_value body_nodes(const body* b, const char* class_name) {
    gd_value self = body_self(b);
    gd_value arguments[4] = {gd_of_text("*"), gd_of_text(class_name), gd_of_bool(true), gd_of_bool(false)};
    const gd_value nodes = gd_call(&self, "find_children", 4, arguments);
    for (int i = 0; i < 4; i++) gd_free(&arguments[i]);
    gd_free(&self);
    return nodes;
}

char* body_joined(char* above, char* name, char between) {
    const size_t first = above ? strlen(above) : 0, second = name ? strlen(name) : 0;
    char* text = above && name ? malloc(first + second + 2) : NULL;
    if (text) {
        memcpy(text, above, first); /* NOLINT(bugprone-not-null-terminated-result): more follows */
        text[first] = between;
        memcpy(text + first + 1, name, second + 1);
    }
    free(above);
    free(name);
    return text;
}

char* body_text_of(const gd_value* object, const char* property) {
    gd_value value = gd_get(object, property);
    char* text = gd_text(&value);
    gd_free(&value);
    return text;
}
