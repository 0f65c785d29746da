/* Reads the names and the tree of an asset's nodes. */
#include "assets/node_labels.h"

#include <string.h>

#include "assets/asset_grouping.h"
#include "kinematics/hints/label_words.h"

bool dmi_kind_is_part(dmi_part_kind kind) {
    static const bool parts[] = {
#define PART true
#define OBJECT false
#define KIND(name, group, words) group,
#include "kinematics/hints/kinds.def"
#undef KIND
#undef OBJECT
#undef PART
    };
    return parts[kind];
}

/* Reads the node's own name, or where that says nothing its mesh's. */
static dmi_part_kind kind_of_node(const dmi_asset_node* node) {
    dmi_part_kind kind = node->name != NULL ? dmi_kind_of_label(node->name).kind : DMI_KIND_NOTHING;
    if (kind == DMI_KIND_NOTHING && node->mesh_name != NULL) kind = dmi_kind_of_label(node->mesh_name).kind;
    return kind;
}

static uint8_t name_class(dmi_part_kind kind) {
    if (kind == DMI_KIND_NOTHING) return DMI_NAME_SILENT;
    if (kind == DMI_KIND_HANDLE || kind == DMI_KIND_LATCH) return DMI_NAME_GRIP;
    return dmi_kind_is_part(kind) ? DMI_NAME_PART : DMI_NAME_OBJECT;
}

/* Returns whether two names are the same word for word; numbers are no words. */
static bool have_one_stem(const char* a, const char* b) {
    dmi_label_words x, y;
    if (a == NULL || b == NULL) return false;
    dmi_split_label(a, strlen(a), &x);
    dmi_split_label(b, strlen(b), &y);
    if (x.count == 0 || x.count != y.count) return false;
    for (size_t i = 0; i < x.count; i++)
        if (strcmp(x.words[i], y.words[i]) != 0) return false;
    return true;
}

static void read_names(dmi_node_labels* labels) {
    uint32_t told = 0;
    for (uint32_t u = 0; u < labels->unit_count; u++) {
        const dmi_asset_node* node = &labels->nodes[labels->unit_node[u]];
        const dmi_part_kind kind = kind_of_node(node);
        labels->kind[u] = (uint8_t)kind;
        labels->name[u] = name_class(kind);
        told += labels->name[u] >= DMI_NAME_PART;
        for (uint32_t earlier = 0; earlier < u && labels->stem[u] == u; earlier++)
            if (have_one_stem(labels->nodes[labels->unit_node[earlier]].name, node->name))
                labels->stem[u] = labels->stem[earlier];
    }
    labels->told = labels->unit_count > 0 ? (float)told / (float)labels->unit_count : 0;
}

static void read_tree(dmi_node_labels* labels, uint32_t node_count) {
    for (uint32_t u = 0; u < labels->unit_count; u++) {
        uint32_t node = labels->unit_node[u];
        for (uint32_t depth = 0; node != DMI_ASSET_BODY && depth <= node_count; depth++) {
            labels->units_below[node]++;
            node = labels->nodes[node].parent;
        }
    }
    for (uint32_t n = 0; n < node_count; n++)
        labels->has_tree |= labels->units_below[n] > 1 && labels->units_below[n] < labels->unit_count;
}

dm_result dmi_node_labels_make(dmi_arena* arena, const dmi_asset_node* nodes, uint32_t node_count,
                               const uint32_t* unit_node, uint32_t unit_count, bool use_names, dmi_node_labels* out) {
    *out = (dmi_node_labels){.nodes = nodes, .unit_count = unit_count, .unit_node = unit_node};
    out->name = dmi_arena_push(arena, unit_count + 1);
    out->kind = dmi_arena_push(arena, unit_count + 1);
    out->stem = dmi_arena_push(arena, (unit_count + 1) * sizeof *out->stem);
    out->units_below = dmi_arena_push(arena, (node_count + 1) * sizeof *out->units_below);
    if (out->name == NULL || out->kind == NULL || out->stem == NULL || out->units_below == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    memset(out->name, DMI_NAME_SILENT, unit_count);
    memset(out->kind, DMI_KIND_NOTHING, unit_count);
    memset(out->units_below, 0, node_count * sizeof *out->units_below);
    for (uint32_t u = 0; u < unit_count; u++) out->stem[u] = u;
    if (use_names) {
        read_names(out);
        read_tree(out, node_count);
    }
    return DM_OK;
}

static bool is_above(const dmi_node_labels* labels, uint32_t node, uint32_t unit) {
    uint32_t at = labels->unit_node[unit];
    while (at != DMI_ASSET_BODY && at != node) at = labels->nodes[at].parent;
    return at == node;
}

uint32_t dmi_units_of_group(const dmi_node_labels* labels, const uint32_t* units, uint32_t count) {
    if (!labels->has_tree) return labels->unit_count;
    uint32_t node = labels->unit_node[units[0]];
    for (uint32_t i = 1; i < count && node != DMI_ASSET_BODY; i++)
        while (node != DMI_ASSET_BODY && !is_above(labels, node, units[i])) node = labels->nodes[node].parent;
    return node == DMI_ASSET_BODY ? labels->unit_count : labels->units_below[node];
}

bool dmi_unit_is_below(const dmi_node_labels* labels, uint32_t a, uint32_t b) {
    return labels->has_tree && a != b && is_above(labels, labels->unit_node[b], a);
}

/* ---- order of nodes: those above come first ---- */

enum { UNSEEN, ON_THE_WAY, PLACED };

uint32_t dmi_asset_order_nodes(const uint32_t* above, uint32_t count, uint32_t* out_order, uint8_t* done) {
    memset(done, UNSEEN, count);
    for (uint32_t i = 0, placed = 0; i < count; i++) {
        uint32_t end = count, node = i;
        for (; node != DM_ASSET_NO_NODE && done[node] == UNSEEN; node = above[node]) {
            done[node] = ON_THE_WAY;
            out_order[--end] = node; /* the way lies at the end of the list, which is free so far */
        }
        if (node != DM_ASSET_NO_NODE && done[node] == ON_THE_WAY) return node;
        for (; end < count; end++) {
            done[out_order[end]] = PLACED;
            out_order[placed++] = out_order[end];
        }
    }
    return DM_ASSET_NO_NODE;
}
