/* dragmesh nodes: what a file has that may move, and by which names. */
#include <stdio.h>

#include "file_report.h"
#include "json.h"
#include "nodes.h"
#include "runs.h"
#include "shown.h"

/* What is printed of a node. */
typedef struct node_entry {
    dm_gltf_node node;
    double size[3]; /* sides of its box, in the file's units */
    part_hints hints;
    bool is_body; /* the largest: what prepare takes for the body */
} node_entry;

static void read_entry(const session* session, uint32_t index, uint32_t largest, node_entry* out) {
    char number[32];
    dm_gltf_get_node(session->gltf, index, &out->node);
    snprintf(number, sizeof number, "#%u", (unsigned)out->node.node);
    part_hints_of_node(session->gltf, session->path, number, &out->hints);
    node_box_size(session, index, out->size);
    out->is_body = index == largest;
}

static void print_entry(const session* session, const node_entry* entry) {
    char name[64], carrier[24] = "";
    dm_gltf_node above;
    snprintf(name, sizeof name, "'%.40s'", entry->node.name);
    if (dm_gltf_get_node(session->gltf, entry->node.carrier, &above) == DM_OK)
        snprintf(carrier, sizeof carrier, "on #%u", (unsigned)above.node);
    dm_gltf_mend_text(name);
    printf("#%-5u %-24s %9llu  %10.4f x %.4f x %.4f  %-8s %s%s\n", (unsigned)entry->node.node, name,
           (unsigned long long)entry->node.face_count, shown(entry->size[0], 4), shown(entry->size[1], 4),
           shown(entry->size[2], 4), carrier, entry->hints.label, entry->is_body ? "  (largest)" : "");
}

static cJSON* entry_to_json(const session* session, const node_entry* entry) {
    cJSON* out = cJSON_CreateObject();
    dm_gltf_node above;
    cJSON_AddNumberToObject(out, "node", entry->node.node);
    cJSON_AddStringToObject(out, "name", entry->node.name);
    cJSON_AddNumberToObject(out, "triangles", (double)entry->node.face_count);
    cJSON_AddNumberToObject(out, "vertices", (double)entry->node.vertex_count);
    cJSON* size = cJSON_AddArrayToObject(out, "size");
    for (int i = 0; i < 3; i++) cJSON_AddItemToArray(size, cJSON_CreateNumber(entry->size[i]));
    if (dm_gltf_get_node(session->gltf, entry->node.carrier, &above) == DM_OK)
        cJSON_AddNumberToObject(out, "carrier", above.node);
    else
        cJSON_AddNullToObject(out, "carrier");
    cJSON_AddStringToObject(out, "label", entry->hints.label);
    if (entry->hints.has_pivot) json_add_point(out, "pivot", entry->hints.pivot.origin, session->origin);
    cJSON_AddBoolToObject(out, "largest", entry->is_body);
    return out;
}

static void print_table(const session* session, uint32_t largest) {
    printf("%-6s %-24s %9s  %s\n", "node", "name", "triangles", "size, what carries it, names that count");
    for (uint32_t i = 0; i < dm_gltf_node_count(session->gltf); i++) {
        node_entry entry;
        read_entry(session, i, largest, &entry);
        print_entry(session, &entry);
    }
    printf("%llu triangles. --moving takes a name or a number with its #; a name that several nodes have means all of\n"
           "them. The names that count are the evidence that the asset gives of how a node moves.\n",
           (unsigned long long)(session->mesh.index_count / 3));
}

/* Prints one object, a node at a time: a file may have a million of them. */
static void print_json(const session* session, uint32_t largest) {
    printf("{\"triangles\":%llu,\"vertices\":%llu,\"nodes\":[", (unsigned long long)(session->mesh.index_count / 3),
           (unsigned long long)session->mesh.vertex_count);
    for (uint32_t i = 0; i < dm_gltf_node_count(session->gltf); i++) {
        node_entry entry;
        read_entry(session, i, largest, &entry);
        if (i > 0) putchar(',');
        json_print_piece(entry_to_json(session, &entry));
    }
    printf("]}\n");
}

static dm_result print_nodes(session* session, const char* path, int as_json) {
    const dm_result result = session_use_file(session, path);
    if (result == DM_OK) (as_json ? print_json : print_table)(session, largest_node(session));
    return result;
}

int nodes_run(const cli_command* command, int argc, char** argv) {
    return file_report_run(command, argc, argv, print_nodes);
}
