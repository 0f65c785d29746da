/* Edits of a document. */
#include "gltf/gltf_edit.h"

#include <inttypes.h>
#include <string.h>

#include "base/utf8.h"
#include "gltf/gltf_buffers.h"
#include "gltf/gltf_meshopt.h"

#define ELEMENT_BYTES 12 /* bytes of a triangle, or of a vertex' position */

static void run_out(dmi_edit* e) {
    if (e->problem.code == DM_OK)
        dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory to write the document");
}

/* ---- values ---- */

cJSON* dmi_edit_new(dmi_edit* e, cJSON* made) {
    if (!made) run_out(e);
    return made;
}

cJSON* dmi_edit_set(dmi_edit* e, cJSON* object, const char* name, cJSON* item) {
    if (!item) run_out(e);
    if (item && object && e->problem.code == DM_OK) {
        cJSON_DeleteItemFromObjectCaseSensitive(object, name);
        if (cJSON_AddItemToObject(object, name, item)) return item;
        run_out(e);
    }
    cJSON_Delete(item);
    return NULL;
}

void dmi_edit_number(dmi_edit* e, cJSON* object, const char* name, double value) {
    dmi_edit_set(e, object, name, cJSON_CreateNumber(value));
}

void dmi_edit_text(dmi_edit* e, cJSON* object, const char* name, const char* value) {
    cJSON* item = cJSON_CreateString(value);
    if (item) dmi_utf8_mend(item->valuestring);
    dmi_edit_set(e, object, name, item);
}

void dmi_edit_numbers(dmi_edit* e, cJSON* object, const char* name, const double* values, int count) {
    dmi_edit_set(e, object, name, cJSON_CreateDoubleArray(values, count));
}

static cJSON* find(cJSON* object, const char* name) {
    return object ? cJSON_GetObjectItemCaseSensitive(object, name) : NULL;
}

cJSON* dmi_edit_list(dmi_edit* e, cJSON* object, const char* name) {
    cJSON* found = find(object, name);
    return cJSON_IsArray(found) ? found : dmi_edit_set(e, object, name, cJSON_CreateArray());
}

cJSON* dmi_edit_object(dmi_edit* e, cJSON* object, const char* name) {
    cJSON* found = find(object, name);
    return cJSON_IsObject(found) ? found : dmi_edit_set(e, object, name, cJSON_CreateObject());
}

void dmi_edit_append(dmi_edit* e, cJSON* list, cJSON* item) {
    if (!item) run_out(e);
    if (!item || !list || !cJSON_AddItemToArray(list, item)) cJSON_Delete(item);
}

void dmi_edit_append_number(dmi_edit* e, cJSON* list, double value) {
    dmi_edit_append(e, list, cJSON_CreateNumber(value));
}

/* ---- items ---- */

dmi_edit_item dmi_edit_add(dmi_edit* e, dmi_gltf_list list, cJSON* json) {
    const dmi_edit_item none = {NULL, -1};
    if (!json) json = dmi_edit_new(e, cJSON_CreateObject());
    cJSON* items = dmi_edit_list(e, e->document.root, dmi_gltf_list_names[list]);
    if (!json || !items || e->problem.code != DM_OK) {
        cJSON_Delete(json);
        return none;
    }
    dmi_edit_append(e, items, json);
    return (dmi_edit_item){json, (int32_t)e->counts[list]++};
}

/* Appends to the buffer on a boundary of 4 bytes. Returns the offset in the whole buffer. */
static uint64_t append_bytes(dmi_edit* e, const void* data, uint64_t size) {
    const uint64_t at = (e->added_size + 3) & ~(uint64_t)3, needed = at + size;
    if (needed > e->added_capacity) {
        const uint64_t capacity = 2 * needed;
        uint8_t* larger = dmi_alloc(e->env, capacity, 16);
        if (!larger) {
            run_out(e);
            return 0;
        }
        if (e->added_size) memcpy(larger, e->added, e->added_size);
        dmi_free(e->env, e->added, e->added_capacity);
        e->added = larger;
        e->added_capacity = capacity;
    }
    memset(e->added + e->added_size, 0, at - e->added_size);
    memcpy(e->added + at, data, size);
    e->added_size = needed;
    return e->base + at;
}

int32_t dmi_edit_add_view(dmi_edit* e, const void* data, uint64_t size, int target) {
    if (e->problem.code != DM_OK) return -1;
    const uint64_t offset = append_bytes(e, data, size);
    dmi_edit_tell(e, 0, size / ELEMENT_BYTES);
    const dmi_edit_item view = dmi_edit_add(e, DMI_GLTF_VIEWS, NULL);
    dmi_edit_number(e, view.json, "buffer", 0);
    dmi_edit_number(e, view.json, "byteOffset", (double)offset);
    dmi_edit_number(e, view.json, "byteLength", (double)size);
    if (target) dmi_edit_number(e, view.json, "target", target);
    return view.index;
}

int32_t dmi_edit_add_accessor(dmi_edit* e, int32_t view, int type, int components, uint64_t count, const float* minimum,
                              const float* maximum) {
    static const char* const types[] = {[1] = "SCALAR", [2] = "VEC2", [3] = "VEC3", [4] = "VEC4"};
    const dmi_edit_item accessor = dmi_edit_add(e, DMI_GLTF_ACCESSORS, NULL);
    dmi_edit_number(e, accessor.json, "bufferView", view);
    dmi_edit_number(e, accessor.json, "componentType", type);
    dmi_edit_number(e, accessor.json, "count", (double)count);
    dmi_edit_text(e, accessor.json, "type", types[components]);
    for (int which = 0; which < 2; which++) {
        const float* from = which ? maximum : minimum;
        double values[4];
        for (int k = 0; from && k < components; k++) values[k] = (double)from[k];
        if (from) dmi_edit_numbers(e, accessor.json, which ? "max" : "min", values, components);
    }
    return accessor.index;
}

/* ---- one buffer ---- */

/* Addresses bytes of a view, or of its compressed data, in the new buffers. One that has no bytes was left out together
 * with what needs it, so it must not name the bytes that now follow its buffer's. */
static void move_view(dmi_edit* e, cJSON* view, const uint32_t* buffers, const uint64_t* offsets) {
    const double index = dmi_json_number(view, "buffer", DMI_GLTF_NO_INDEX);
    const int64_t old = dmi_gltf_position(&e->from->document, DMI_GLTF_BUFFERS, index);
    if (old < 0 || !cJSON_IsObject(view)) return;
    dmi_gltf_problem broken;
    dmi_gltf_view bytes;
    if (e->from->buffers[old].data && dmi_gltf_find_stored(e->from, view, "", &broken, &bytes) != DM_OK)
        dmi_edit_number(e, view, "byteLength", UINT32_MAX);
    if (buffers[old] != (uint32_t)old) dmi_edit_number(e, view, "buffer", buffers[old]);
    if (offsets[old] > 0)
        dmi_edit_number(e, view, "byteOffset", dmi_json_number(view, "byteOffset", 0) + (double)offsets[old]);
}

/* Joins the buffers that have bytes, in their order, into the first one. Those without bytes, which hold the place of
 * decompressed data, stay behind it. */
static void join_buffers(dmi_edit* e) {
    const dm_gltf* gltf = e->from;
    const uint32_t count = gltf->document.counts[DMI_GLTF_BUFFERS];
    uint32_t* buffers = dmi_alloc(e->env, count * sizeof *buffers, 16);
    uint64_t* offsets = dmi_alloc_zeroed(e->env, count * sizeof *offsets, 16);
    cJSON* list = dmi_edit_new(e, cJSON_CreateArray());
    cJSON* first = dmi_edit_new(e, cJSON_CreateObject());
    const int room = buffers && offsets;
    uint32_t empty = 0; /* buffers without bytes so far */
    if (!room) run_out(e);
    for (uint32_t i = 0; room && e->problem.code == DM_OK && i < count; i++) {
        cJSON* old = e->document.items[DMI_GLTF_BUFFERS][i];
        if (gltf->buffers[i].data) {
            buffers[i] = 0;
            offsets[i] = e->base;
            e->base = (e->base + gltf->buffers[i].size + 3) & ~(uint64_t)3;
            cJSON_DeleteItemFromObjectCaseSensitive(old, "uri");
            if (i > 0) continue;
            cJSON_Delete(first);
            first = dmi_edit_new(e, cJSON_Duplicate(old, 1));
        } else {
            buffers[i] = ++empty;
            dmi_edit_append(e, list, cJSON_Duplicate(old, 1));
        }
    }
    for (uint32_t i = 0; room && e->problem.code == DM_OK && i < e->document.counts[DMI_GLTF_VIEWS]; i++) {
        cJSON* view = e->document.items[DMI_GLTF_VIEWS][i];
        cJSON* compressed = (cJSON*)dmi_meshopt_of(view);
        move_view(e, view, buffers, offsets);
        if (compressed) move_view(e, compressed, buffers, offsets);
    }
    if (e->problem.code != DM_OK || !cJSON_InsertItemInArray(list, 0, first)) cJSON_Delete(first);
    dmi_edit_set(e, e->document.root, "buffers", list);
    dmi_free(e->env, buffers, count * sizeof *buffers);
    dmi_free(e->env, offsets, count * sizeof *offsets);
}

static cJSON* empty_document(dmi_edit* e) {
    cJSON* root = dmi_edit_new(e, cJSON_CreateObject());
    cJSON* asset = dmi_edit_object(e, root, "asset");
    dmi_edit_text(e, asset, "version", "2.0");
    dmi_edit_text(e, asset, "generator", "dragmesh");
    dmi_edit_number(e, root, "scene", 0);
    cJSON* scenes = dmi_edit_list(e, root, "scenes");
    dmi_edit_append(e, scenes, cJSON_CreateObject());
    cJSON* buffers = dmi_edit_list(e, root, "buffers");
    dmi_edit_append(e, buffers, cJSON_CreateObject());
    return root;
}

void dmi_edit_tell(dmi_edit* e, float share, uint64_t work) {
    if (e->from && e->problem.code == DM_OK) dmi_gltf_tell(e->from, share, work, &e->problem);
}

void dmi_edit_open(dmi_edit* e, dmi_env* env, dm_gltf* from) {
    *e = (dmi_edit){.env = env, .from = from};
    cJSON* root = from ? dmi_edit_new(e, cJSON_Duplicate(from->document.root, 1)) : empty_document(e);
    if (dmi_gltf_document_open(env, root, &e->problem, &e->document) != DM_OK) return;
    memcpy(e->counts, e->document.counts, sizeof e->counts);
    if (from && e->problem.code == DM_OK) join_buffers(e);
}

/* ---- extensions ---- */

/* Returns whether `json`, or something that it holds, has the extension. */
static int has_extension(const cJSON* json, const char* name) {
    if (dmi_json_get(dmi_json_get(json, "extensions"), name)) return 1;
    for (const cJSON* child = json->child; child; child = child->next) {
        if (child->child && has_extension(child, name)) return 1;
    }
    return 0;
}

static void drop_name(cJSON* root, const char* list_name, const char* name) {
    cJSON* list = cJSON_GetObjectItemCaseSensitive(root, list_name);
    for (cJSON *item = list ? list->child : NULL, *next; item; item = next) {
        next = item->next;
        if (cJSON_IsString(item) && strcmp(item->valuestring, name) == 0)
            cJSON_Delete(cJSON_DetachItemViaPointer(list, item));
    }
    if (list && !list->child) cJSON_DeleteItemFromObjectCaseSensitive(root, list_name);
}

void dmi_edit_drop_unused(dmi_edit* e, const char* extension) {
    if (e->problem.code != DM_OK || has_extension(e->document.root, extension)) return;
    drop_name(e->document.root, "extensionsUsed", extension);
    drop_name(e->document.root, "extensionsRequired", extension);
}

void dmi_edit_close(dmi_edit* e) {
    dmi_gltf_document_close(e->env, &e->document);
    dmi_free(e->env, e->added, e->added_capacity);
}
