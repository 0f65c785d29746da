/* Finds hidden nodes, colliders and levels of detail, and the nodes with which they go. */
#include "gltf/gltf_roles.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "gltf/gltf_lod.h"
#include "gltf/gltf_names.h"

/* Most bytes of a collider's name whose node is searched for; by hand. */
#define LONGEST_NAME 256

/* ---- colliders ---- */

/* Names that exporters give to shapes for collisions alone: those of Unreal, those of Godot, and the common suffix. */
static const char* const prefixes[] = {"UCX_", "UBX_", "USP_", "UCP_"};
static const char* const suffixes[] = {"_collider", "-colonly", "-convcolonly"};

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
    int32_t found = finest[index] >= 0 ? dmi_gltf_find_finer(gltf, finest[index], index) : -1;
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
        result = dmi_gltf_find_finest(gltf, solid, problem, finest);
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
