/* Finds hidden nodes, colliders and levels of detail, and the nodes with which they go. */
#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "gltf/gltf_file.h"
#include "gltf/gltf_tree.h"

/* ---- levels of detail: the same thing again, with fewer triangles ---- */

/* The bounds are set by hand: no exporter nests groups so deep, has so many levels, or so long names. */
enum { DEEPEST = 256, MOST_DIGITS = 2, LONGEST_NAME = 256, MOST_NAMESAKES = 64 };

/* A name with a level in it: door_LOD1.001 is "door", 1 and ".001". */
typedef struct level {
    const char* name;
    size_t stem; /* bytes before the level, without what separates them */
    const char* tail;
    int32_t parent; /* -1: none */
    uint32_t number, node;
} level;

static bool is_separator(char c) {
    return c == '_' || c == '-' || c == '.' || c == ' ';
}

/* Reads the level at `at` of the name: "LOD", a separator or none, and a number that ends there. */
static bool read_level(const char* name, size_t at, level* out) {
    const char* digits = name + at + 3;
    if (at > 0 && !is_separator(name[at - 1])) return false;
    if (strncasecmp(name + at, "lod", 3) != 0) return false;
    if (is_separator(*digits)) digits++;
    int count = 0;
    out->number = 0;
    for (; isdigit((unsigned char)digits[count]) && count <= MOST_DIGITS; count++)
        out->number = 10 * out->number + (uint32_t)(digits[count] - '0');
    if (count == 0 || count > MOST_DIGITS || isalnum((unsigned char)digits[count])) return false;
    out->name = name;
    out->tail = digits + count;
    for (out->stem = at; out->stem > 0 && is_separator(name[out->stem - 1]);) out->stem--;
    return true;
}

static bool split_name(const char* name, level* out) {
    for (size_t at = 0; name[at] != 0; at++)
        if (read_level(name, at, out)) return true;
    return false;
}

static int compare_stems(const level* a, const level* b) {
    const int stems = strncasecmp(a->name, b->name, a->stem < b->stem ? a->stem : b->stem);
    if (stems != 0 || a->stem != b->stem) return stems != 0 ? stems : (a->stem > b->stem) - (a->stem < b->stem);
    return strcasecmp(a->tail, b->tail);
}

/* Sorts levels so that those of one thing lie side by side, those of one parent among them, the finest first. */
static int compare_levels(const void* x, const void* y) {
    const level *a = x, *b = y;
    const int names = compare_stems(a, b);
    if (names != 0) return names;
    if (a->parent != b->parent) return a->parent > b->parent ? 1 : -1;
    if (a->number != b->number) return a->number > b->number ? 1 : -1;
    return (a->node > b->node) - (a->node < b->node);
}

/* ---- the tree ---- */

static bool is_below(const dm_gltf* gltf, int32_t node, int32_t above) {
    for (int depth = 0; node >= 0 && depth < DEEPEST; depth++, node = gltf->tree[node].parent)
        if (node == above) return true;
    return false;
}

/* Returns whether the node lies in a coarser level, as far as these are known. */
static bool is_coarser(const dm_gltf* gltf, const int32_t* finest, int32_t node) {
    for (int depth = 0; node >= 0 && depth < DEEPEST; depth++, node = gltf->tree[node].parent)
        if (finest[node] >= 0) return true;
    return false;
}

/* Notes that `coarse` is a coarser level of `fine`, unless that would hide `fine` as well. */
static void set_finest(const dm_gltf* gltf, int32_t coarse, int32_t fine, int32_t* finest) {
    if (finest[coarse] >= 0 || is_below(gltf, fine, coarse) || is_coarser(gltf, finest, fine)) return;
    finest[coarse] = fine;
}

/* ---- MSFT_lod ---- */

static void read_extensions(const dm_gltf* gltf, const uint8_t* solid, int32_t* finest) {
    for (uint32_t at = 0; at < gltf->order_count; at++) {
        const int32_t node = (int32_t)gltf->order[at];
        const cJSON* extension = dmi_json_get(dmi_json_get(gltf->tree[node].json, "extensions"), "MSFT_lod");
        const cJSON* id;
        if (!extension || !solid[node]) continue;
        cJSON_ArrayForEach(id, dmi_json_get(extension, "ids")) {
            const double index = cJSON_IsNumber(id) ? id->valuedouble : DMI_GLTF_NO_INDEX;
            const int64_t coarse = dmi_gltf_position(&gltf->document, DMI_GLTF_NODES, index);
            if (coarse >= 0 && gltf->tree[coarse].placed) set_finest(gltf, (int32_t)coarse, node, finest);
        }
    }
}

/* ---- levels by name ---- */

/* Returns the solid node beside the level, or above it and with a mesh, that has the same name without a level, or -1
 * when there is none. */
static int32_t find_unnumbered(const dm_gltf* gltf, const uint8_t* solid, const level* of) {
    char name[LONGEST_NAME];
    const int length = snprintf(name, sizeof name, "%.*s%s", (int)of->stem, of->name, of->tail);
    if (of->stem == 0 || length < 0 || (size_t)length >= sizeof name) return -1;
    const dmi_gltf_namesakes found = dmi_gltf_find_nodes(gltf, name);
    for (uint32_t i = 0; i < found.count && i < MOST_NAMESAKES; i++) {
        const int32_t node = (int32_t)found.first[i].node;
        const bool beside = gltf->tree[node].parent == of->parent, above = node == of->parent;
        if (solid[node] && (beside || (above && gltf->tree[node].mesh >= 0))) return node;
    }
    return -1;
}

/* Returns the end of the levels from `first` on that belong to one thing, and to one parent where `one_parent`. */
static const level* find_end(const level* first, const level* end, bool one_parent) {
    const level* at = first;
    while (at < end && compare_stems(at, first) == 0 && (!one_parent || at->parent == first->parent)) at++;
    return at;
}

/* Returns the finest of levels of one thing that may have several parents. */
static const level* find_least(const level* first, const level* end) {
    const level* least = first;
    for (const level* at = first; at < end; at++)
        if (at->number < least->number || (at->number == least->number && at->node < least->node)) least = at;
    return least;
}

/* Links the levels of one thing and one parent, the finest first, to the finest. That one may have another parent, or
 * no level in its name. Of two that are finest, both stay. */
static void link_levels(const dm_gltf* gltf, const uint8_t* solid, const level* first, const level* end,
                        const level* least, int32_t* finest) {
    int32_t best = (int32_t)first->node;
    if (first->stem > 0 && least->number < first->number)
        best = (int32_t)least->node;
    else if (first->number > 0 && find_unnumbered(gltf, solid, first) >= 0)
        best = find_unnumbered(gltf, solid, first);
    for (const level* at = first; at < end; at++)
        if (best != (int32_t)first->node || at->number > first->number)
            set_finest(gltf, (int32_t)at->node, best, finest);
}

static uint32_t list_levels(const dm_gltf* gltf, const uint8_t* solid, const int32_t* finest, level* out) {
    uint32_t count = 0;
    for (uint32_t at = 0; at < gltf->order_count; at++) {
        const int32_t node = (int32_t)gltf->order[at];
        if (!solid[node] || finest[node] >= 0 || !split_name(gltf->tree[node].name, &out[count])) continue;
        out[count].node = (uint32_t)node;
        out[count++].parent = gltf->tree[node].parent;
    }
    return count;
}

static void read_names(const dm_gltf* gltf, const uint8_t* solid, level* levels, int32_t* finest) {
    const uint32_t count = list_levels(gltf, solid, finest, levels);
    if (count > 0) qsort(levels, count, sizeof *levels, compare_levels);
    const level* end = levels + count;
    for (const level *thing = levels, *next_thing; thing < end; thing = next_thing) {
        next_thing = find_end(thing, end, false);
        const level* least = find_least(thing, next_thing);
        for (const level *at = thing, *next; at < next_thing; at = next) {
            next = find_end(at, next_thing, true);
            link_levels(gltf, solid, at, next, least, finest);
        }
    }
}

/* Marks what lies in a coarser level as coarser too. */
static void spread_levels(const dm_gltf* gltf, int32_t* finest) {
    for (uint32_t at = 0; at < gltf->order_count; at++) {
        const uint32_t node = gltf->order[at];
        const int32_t parent = gltf->tree[node].parent;
        if (finest[node] < 0 && parent >= 0) finest[node] = finest[parent];
    }
}

/* Writes for each node the finest level whose coarser one it is, or lies in; -1: it is no coarser level. `shown` must
 * be known except for levels of detail. `solid`: 1 for a node when it or something below it is shown and has a mesh. */
static dm_result gltf_find_finest(dm_gltf* gltf, const uint8_t* solid, dmi_gltf_problem* problem, int32_t* out_finest) {
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    const dm_result result = dmi_gltf_spend(gltf, count, sizeof(level), "glTF: the nodes", problem);
    if (result != DM_OK) return result;
    level* levels = dmi_alloc(&gltf->env, count * sizeof *levels, 16);
    if (!levels) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u nodes", count);
    for (uint32_t i = 0; i < count; i++) out_finest[i] = -1;
    read_extensions(gltf, solid, out_finest);
    read_names(gltf, solid, levels, out_finest);
    spread_levels(gltf, out_finest);
    dmi_free(&gltf->env, levels, count * sizeof *levels);
    return DM_OK;
}

/* ---- the same in the finest level ---- */

/* Writes a name without its level and without the number that Blender puts behind one that is there already. */
static void write_plain(const char* name, char out[LONGEST_NAME]) {
    level split;
    const bool has_level = split_name(name, &split);
    snprintf(out, LONGEST_NAME, "%.*s%s", has_level ? (int)split.stem : (int)strlen(name), name,
             has_level ? split.tail : "");
    char* dot = strrchr(out, '.');
    if (dot && dot[1] && strspn(dot + 1, "0123456789") == strlen(dot + 1)) *dot = 0;
}

/* Returns the node at or below `finest` that is called as `node`, which lies in a coarser level of it, or `finest`
 * where none is. */
static int32_t gltf_find_finer(const dm_gltf* gltf, int32_t finest, int32_t node) {
    char plain[LONGEST_NAME];
    write_plain(gltf->tree[node].name, plain);
    if (plain[0] == 0) return finest;
    const dmi_gltf_namesakes found = dmi_gltf_find_nodes(gltf, plain);
    for (uint32_t i = 0; i < found.count && i < MOST_NAMESAKES; i++) {
        const int32_t other = (int32_t)found.first[i].node;
        if (other != node && is_below(gltf, other, finest)) return other;
    }
    return finest;
}

/* ---- colliders ---- */

/* Names that exporters give to shapes for collisions alone: those of Unreal, those of Godot, and common suffixes. */
static const char* const prefixes[] = {"UCX_", "UBX_", "USP_", "UCP_"};
static const char* const suffixes[] = {"_collider", "-collider", "_collision",  "-collision",
                                       "_hitbox",   "-colonly",  "-convcolonly"};

/* Returns the length of a name without the number that Blender and others put behind it: door-colonly.001,
 * door_collider2. */
static size_t length_without_number(const char* name, size_t length) {
    while (length > 0 && (isdigit((unsigned char)name[length - 1]) || strchr("._ ", name[length - 1]))) length--;
    return length;
}

/* Finds the part of a collider's name that names the node whose shape it is: from `*out_first` on, `*out_length` long.
 * Returns whether the name is that of a collider. */
static bool split_collider_name(const char* name, size_t* out_first, size_t* out_length) {
    const size_t length = name ? strlen(name) : 0;
    for (size_t i = 0; name && i < sizeof prefixes / sizeof *prefixes; i++) {
        *out_first = strlen(prefixes[i]);
        *out_length = length - *out_first;
        if (strncmp(name, prefixes[i], *out_first) == 0) return true;
    }
    const size_t end = name ? length_without_number(name, length) : 0;
    for (size_t i = 0; i < sizeof suffixes / sizeof *suffixes; i++) {
        const size_t size = strlen(suffixes[i]);
        *out_first = 0;
        *out_length = end - size;
        if (end >= size && strncasecmp(name + end - size, suffixes[i], size) == 0) return true;
    }
    return false;
}

static bool is_collider_name(const char* name) {
    size_t first, length;
    return split_collider_name(name, &first, &length);
}

static const char* mesh_name_of(const dm_gltf* gltf, const dmi_gltf_tree_node* node) {
    return node->mesh < 0 ? NULL : dmi_json_text(gltf->document.items[DMI_GLTF_MESHES][node->mesh], "name");
}

/* Returns the first solid node of this name, or -1 when there is none. */
static int32_t find_solid(const dm_gltf* gltf, const uint8_t* solid, const char* name, size_t length) {
    char text[LONGEST_NAME];
    if (length == 0 || length >= sizeof text) return -1;
    snprintf(text, sizeof text, "%.*s", (int)length, name);
    const dmi_gltf_namesakes found = dmi_gltf_find_nodes(gltf, text);
    for (uint32_t i = 0; i < found.count; i++)
        if (solid[found.first[i].node]) return (int32_t)found.first[i].node;
    return -1;
}

/* Returns the node that the name of a collider names, with or without a number behind it, or -1 when it names none.
 * UCX_door_01 belongs to door_01, or to door. */
static int32_t find_collided(const dm_gltf* gltf, const uint8_t* solid, const char* name) {
    size_t first, length;
    if (!split_collider_name(name, &first, &length)) return -1;
    const int32_t found = find_solid(gltf, solid, name + first, length);
    return found >= 0 ? found : find_solid(gltf, solid, name + first, length_without_number(name + first, length));
}

/* ---- what is shown ---- */

static bool is_hidden(const cJSON* node) {
    const cJSON* extension = dmi_json_get(dmi_json_get(node, "extensions"), "KHR_node_visibility");
    return cJSON_IsFalse(dmi_json_get(extension, "visible"));
}

/* Finds which nodes are shown. A hidden node and a named group of colliders hide what they hold; a collider with a mesh
 * hides itself alone. */
static void show_nodes(dm_gltf* gltf) {
    for (uint32_t at = 0; at < gltf->order_count; at++) {
        dmi_gltf_tree_node* node = &gltf->tree[gltf->order[at]];
        const bool above = node->parent < 0 || gltf->tree[node->parent].shown;
        const bool is_group = node->mesh < 0 && is_collider_name(node->name);
        node->shown = node->in_scene && above && !is_hidden(node->json) && !is_group;
    }
    for (uint32_t i = 0; i < gltf->document.counts[DMI_GLTF_NODES]; i++) {
        dmi_gltf_tree_node* node = &gltf->tree[i];
        if (node->mesh >= 0 && (is_collider_name(node->name) || is_collider_name(mesh_name_of(gltf, node))))
            node->shown = 0;
    }
}

/* Marks the nodes that have a shown mesh, or carry one. */
static void mark_solid(const dm_gltf* gltf, uint8_t* solid) {
    for (uint32_t at = gltf->order_count; at-- > 0;) {
        const dmi_gltf_tree_node* node = &gltf->tree[gltf->order[at]];
        solid[gltf->order[at]] |= node->shown && node->mesh >= 0;
        if (node->parent >= 0) solid[node->parent] |= solid[gltf->order[at]];
    }
}

static void hide_coarser(dm_gltf* gltf, const int32_t* finest) {
    for (uint32_t i = 0; i < gltf->document.counts[DMI_GLTF_NODES]; i++) {
        if (finest[i] < 0) continue;
        gltf->tree[i].shown = 0;
        gltf->tree[i].in_scene |= gltf->tree[finest[i]].in_scene;
    }
}

/* ---- who goes with whom ---- */

static int32_t find_solid_above(const dm_gltf* gltf, const uint8_t* solid, int32_t node) {
    do {
        node = gltf->tree[node].parent;
    } while (node >= 0 && !solid[node]);
    return node;
}

static int32_t find_followed(const dm_gltf* gltf, const uint8_t* solid, const int32_t* finest, int32_t index) {
    const dmi_gltf_tree_node* node = &gltf->tree[index];
    int32_t found = finest[index] >= 0 ? gltf_find_finer(gltf, finest[index], index) : -1;
    if (found >= 0 && !solid[found]) found = finest[index];
    if (found < 0) found = find_collided(gltf, solid, node->name);
    if (found < 0) found = find_collided(gltf, solid, mesh_name_of(gltf, node));
    return found >= 0 && solid[found] ? found : find_solid_above(gltf, solid, index);
}

static void find_all_followed(dm_gltf* gltf, const uint8_t* solid, const int32_t* finest) {
    for (uint32_t i = 0; i < gltf->document.counts[DMI_GLTF_NODES]; i++) {
        dmi_gltf_tree_node* node = &gltf->tree[i];
        if (node->placed && node->in_scene && !node->shown && node->mesh >= 0)
            node->follows = find_followed(gltf, solid, finest, (int32_t)i);
    }
}

dm_result dmi_gltf_find_roles(dm_gltf* gltf, dmi_gltf_problem* problem) {
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    dm_result result = dmi_gltf_spend(gltf, count, 1 + sizeof(int32_t), "glTF: the nodes", problem);
    if (result != DM_OK) return result;
    uint8_t* solid = dmi_alloc_zeroed(&gltf->env, count, 1);
    int32_t* finest = dmi_alloc(&gltf->env, count * sizeof *finest, 16);
    if (!solid || !finest)
        result = dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u nodes", count);
    if (result == DM_OK) {
        show_nodes(gltf);
        mark_solid(gltf, solid);
        result = gltf_find_finest(gltf, solid, problem, finest);
    }
    if (result == DM_OK) {
        hide_coarser(gltf, finest);
        memset(solid, 0, count);
        mark_solid(gltf, solid);
        find_all_followed(gltf, solid, finest);
    }
    dmi_free(&gltf->env, solid, count);
    dmi_free(&gltf->env, finest, count * sizeof *finest);
    return result;
}
