/* Writes a .glb: of a document, or of meshes made elsewhere (dm_gltf_write). */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/fp_environment.h"
#include "gltf/gltf_edit.h"
#include "math/elementary.h"

/* ---- a document as the bytes of a .glb ---- */

enum { GLB_HEADER = 12, CHUNK_HEADER = 8, ALIGNMENT = 4 };

/* A double as text needs at most 17 digits, a sign, a point and an exponent. */
#define NUMBER_SIZE 32

/* Bytes between two reports: some milliseconds, where the memory is fresh; by hand. */
#define COPIED_AT_ONCE ((uint64_t)1 << 22)

/* Sets the text of a number that needs all 17 digits. cJSON writes 15 digits when they are near the number. */
static int keep_digits(cJSON* item) {
    char text[NUMBER_SIZE];
    snprintf(text, sizeof text, "%.15g", item->valuedouble);
    if (!isfinite(item->valuedouble) || strtod(text, NULL) == item->valuedouble) return 1;
    char* exact = cJSON_malloc(NUMBER_SIZE);
    if (!exact) return 0;
    snprintf(exact, NUMBER_SIZE, "%.17g", item->valuedouble);
    item->type = cJSON_Raw;
    item->valuestring = exact;
    return 1;
}

/* Does the same for an item and all that it holds. Its depth was checked when it was read. */
static int keep_all_digits(cJSON* item) {
    int kept = cJSON_IsNumber(item) ? keep_digits(item) : 1;
    for (cJSON* child = item->child; child && kept; child = child->next) kept = keep_all_digits(child);
    return kept;
}

/* Removes lists that an edit has left empty, because glTF has none. */
static void drop_empty_lists(dmi_edit* e) {
    for (int list = 0; list < DMI_GLTF_LISTS; list++) {
        cJSON* found = cJSON_GetObjectItemCaseSensitive(e->document.root, dmi_gltf_list_names[list]);
        if (cJSON_IsArray(found) && !found->child)
            cJSON_DeleteItemFromObjectCaseSensitive(e->document.root, dmi_gltf_list_names[list]);
    }
}

/* Returns the document's text, or NULL when there is no memory. It is released with cJSON_free. */
static char* print_document(dmi_edit* e, uint64_t bytes) {
    cJSON* buffers = cJSON_GetObjectItemCaseSensitive(e->document.root, "buffers");
    cJSON* first = buffers ? buffers->child : NULL;
    if (bytes > 0)
        dmi_edit_number(e, first, "byteLength", (double)bytes);
    else if (first && !first->next)
        cJSON_DeleteItemFromObjectCaseSensitive(e->document.root, "buffers");
    drop_empty_lists(e);
    if (e->problem.code != DM_OK || !keep_all_digits(e->document.root)) return NULL;
    return cJSON_PrintUnformatted(e->document.root);
}

static void put_u32(uint8_t* at, uint64_t value) {
    for (int i = 0; i < 4; i++) at[i] = (uint8_t)(value >> (8 * i));
}

/* Writes a block, padded to a boundary of 4 bytes. */
static void put_block(dmi_edit* e, uint8_t* out, const uint8_t* data, uint64_t size) {
    for (uint64_t at = 0; at < size && e->problem.code == DM_OK; at += COPIED_AT_ONCE) {
        memcpy(out + at, data + at, size - at < COPIED_AT_ONCE ? size - at : COPIED_AT_ONCE);
        dmi_edit_tell(e, 0, DMI_PROGRESS_STEP);
    }
    memset(out + size, 0, -size % ALIGNMENT);
}

/* Writes the old buffers, each on a boundary of 4 bytes, and what was added. */
static void put_bytes(dmi_edit* e, uint8_t* out) {
    uint64_t at = 0;
    for (uint32_t i = 0; e->from && i < e->from->document.counts[DMI_GLTF_BUFFERS]; i++) {
        const dmi_gltf_buffer* buffer = &e->from->buffers[i];
        if (!buffer->data) continue;
        put_block(e, out + at, buffer->data, buffer->size);
        at = (at + buffer->size + 3) & ~(uint64_t)3;
    }
    put_block(e, out + e->base, e->added, e->added_size);
}

static uint8_t* put_chunk(uint8_t* at, const char* kind, uint64_t size) {
    put_u32(at, size);
    memcpy(at + 4, kind, 4);
    return at + CHUNK_HEADER;
}

dm_result dmi_edit_write(dmi_edit* e, void** out_data, size_t* out_size) {
    const uint64_t bytes = e->base + e->added_size, padded = (bytes + 3) & ~(uint64_t)3;
    char* text = print_document(e, bytes);
    if (!text && e->problem.code == DM_OK)
        dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory to write the document");
    if (!text) return dmi_fail(e->env, e->problem.code, "%s", e->problem.text);
    const uint64_t length = strlen(text), json = (length + 3) & ~(uint64_t)3;
    const uint64_t size = GLB_HEADER + CHUNK_HEADER + json + (bytes > 0 ? CHUNK_HEADER + padded : 0);
    uint8_t* out = size > UINT32_MAX ? NULL : dmi_alloc(e->env, size, 16);
    if (out) {
        /* NOLINTBEGIN(bugprone-not-null-terminated-result): bytes of a file, no strings */
        memcpy(out, "glTF", 4);
        put_u32(out + 4, 2);
        put_u32(out + 8, size);
        uint8_t* at = put_chunk(out + GLB_HEADER, "JSON", json);
        memset(at, ' ', json);
        memcpy(at, text, length);
        /* NOLINTEND(bugprone-not-null-terminated-result) */
        if (bytes > 0) {
            at = put_chunk(at + json, "BIN", padded);
            put_bytes(e, at);
        }
        dmi_edit_tell(e, 1, DMI_PROGRESS_STEP);
    }
    cJSON_free(text);
    if (e->problem.code != DM_OK) {
        dmi_free(e->env, out, size);
        return dmi_fail(e->env, e->problem.code, "%s", e->problem.text);
    }
    if (out) {
        *out_data = out;
        *out_size = size;
        return DM_OK;
    }
    return dmi_fail(e->env, size > UINT32_MAX ? DM_ERROR_TOO_LARGE : DM_ERROR_OUT_OF_MEMORY,
                    "glTF: a file of %" PRIu64 " bytes, 4 GB is the most, or no memory for it", size);
}

void dm_gltf_release_bytes(const dm_gltf* gltf, void* data, size_t size) {
    if (!gltf) return;
    dmi_env env;
    dmi_env_init(&env, &gltf->env.allocator, NULL, NULL);
    dmi_free(&env, data, size);
}

/* ---- meshes made elsewhere ---- */

static dm_result check_part(dmi_env* env, const dm_gltf_part* part, uint32_t which) {
    if (!part->positions || !part->indices || part->vertex_count == 0 || part->index_count == 0 ||
        part->index_count % 3 != 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "part %u: %" PRIu64 " vertices and %" PRIu64 " indices", which,
                        part->vertex_count, part->index_count);
    if (part->vertex_count > DM_MAX_ELEMENTS || part->index_count / 3 > DM_MAX_ELEMENTS)
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "part %u: more than %d vertices or triangles", which, DM_MAX_ELEMENTS);
    for (int i = 0; i < 4; i++) {
        if (!isfinite(part->colour[i]))
            return dmi_fail(env, DM_ERROR_NOT_FINITE, "part %u: colour[%d] is not finite", which, i);
    }
    for (uint64_t i = 0; i < 3 * part->vertex_count; i++) {
        if (!isfinite(part->positions[i]))
            return dmi_fail(env, DM_ERROR_NOT_FINITE, "part %u: vertex %" PRIu64 " is not finite", which, i / 3);
    }
    for (uint64_t i = 0; i < part->index_count; i++) {
        if (part->indices[i] >= part->vertex_count)
            return dmi_fail(env, DM_ERROR_INDEX_OUT_OF_RANGE, "part %u: index %" PRIu64 " names vertex %u of %" PRIu64,
                            which, i, part->indices[i], part->vertex_count);
    }
    return DM_OK;
}

static int32_t add_material(dmi_edit* e, const float colour[4]) {
    const dmi_edit_item material = dmi_edit_add(e, DMI_GLTF_MATERIALS, NULL);
    cJSON* surface = dmi_edit_object(e, material.json, "pbrMetallicRoughness");
    double values[4];
    for (int i = 0; i < 4; i++)
        values[i] = (double)dmi_fmaxf(0, dmi_fminf(1, colour[i])); /* glTF's range of a colour */
    dmi_edit_numbers(e, surface, "baseColorFactor", values, 4);
    dmi_edit_number(e, surface, "metallicFactor", 0);
    dmi_edit_number(e, surface, "roughnessFactor", 0.8);
    dmi_edit_set(e, material.json, "doubleSided", cJSON_CreateTrue());
    return material.index;
}

static void add_part(dmi_edit* e, const dm_gltf_part* part) {
    float low[3], high[3];
    for (int k = 0; k < 3; k++) low[k] = high[k] = part->positions[k];
    for (uint64_t v = 0; v < part->vertex_count; v++) {
        for (int k = 0; k < 3; k++) {
            low[k] = dmi_fminf(low[k], part->positions[3 * v + (uint64_t)k]);
            high[k] = dmi_fmaxf(high[k], part->positions[3 * v + (uint64_t)k]);
        }
    }
    const uint64_t vertex_bytes = part->vertex_count * 3 * sizeof(float);
    const int32_t vertices = dmi_edit_add_view(e, part->positions, vertex_bytes, DMI_GLTF_VERTEX_TARGET);
    const int32_t triangles =
        dmi_edit_add_view(e, part->indices, part->index_count * sizeof(uint32_t), DMI_GLTF_INDEX_TARGET);
    const int32_t positions = dmi_edit_add_accessor(e, vertices, DMI_GLTF_FLOAT, 3, part->vertex_count, low, high);
    const int32_t indices = dmi_edit_add_accessor(e, triangles, DMI_GLTF_UINT, 1, part->index_count, NULL, NULL);
    const int32_t material = add_material(e, part->colour);
    cJSON* primitive = dmi_edit_new(e, cJSON_CreateObject());
    dmi_edit_number(e, dmi_edit_object(e, primitive, "attributes"), "POSITION", positions);
    dmi_edit_number(e, primitive, "indices", indices);
    dmi_edit_number(e, primitive, "material", material);
    const dmi_edit_item mesh = dmi_edit_add(e, DMI_GLTF_MESHES, NULL), node = dmi_edit_add(e, DMI_GLTF_NODES, NULL);
    dmi_edit_append(e, dmi_edit_list(e, mesh.json, "primitives"), primitive);
    dmi_edit_number(e, node.json, "mesh", mesh.index);
    if (part->name) dmi_edit_text(e, mesh.json, "name", part->name);
    if (part->name) dmi_edit_text(e, node.json, "name", part->name);
    cJSON* scene = e->document.counts[DMI_GLTF_SCENES] ? e->document.items[DMI_GLTF_SCENES][0] : NULL;
    dmi_edit_append_number(e, dmi_edit_list(e, scene, "nodes"), node.index);
}

dm_result dm_gltf_write(const dm_gltf_part* parts, uint32_t part_count, const dm_allocator* allocator,
                        const dm_log* log, void** out_data, size_t* out_size) {
    DMI_OWN_FP;
    dmi_env env;
    dmi_env_init(&env, allocator, log, NULL);
    if (!parts || part_count == 0 || !out_data || !out_size)
        return dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_write: no part, or no place for the result");
    for (uint32_t i = 0; i < part_count; i++) {
        const dm_result result = check_part(&env, &parts[i], i);
        if (result != DM_OK) return result;
    }
    dmi_edit edit;
    dmi_edit_open(&edit, &env, NULL);
    for (uint32_t i = 0; i < part_count; i++) add_part(&edit, &parts[i]);
    const dm_result result = dmi_edit_write(&edit, out_data, out_size);
    dmi_edit_close(&edit);
    return result;
}
