/* Splits a file into its parts, and reads the bytes of a document from its binary chunk, from data: URIs and from files
 * that the host hands over. */
#include "gltf/gltf_buffers.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "gltf/gltf_meshopt.h"

/* ---- the parts of a .glb or .gltf file ---- */

enum { HEADER_BYTES = 12, CHUNK_BYTES = 8 };
static const uint32_t chunk_json = 0x4E4F534Au, chunk_bin = 0x004E4942u;

static uint32_t read_u32(const uint8_t* bytes) {
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

/* Finds the first binary chunk. Chunks of other kinds are skipped. */
static dm_result find_bin(const uint8_t* next, size_t left, dmi_gltf_problem* problem, dmi_gltf_container* out) {
    while (left > 0) {
        if (left < CHUNK_BYTES || read_u32(next) > left - CHUNK_BYTES)
            return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA,
                                   "GLB: truncated, the second chunk does not fit the %zu bytes after the JSON", left);
        const size_t size = read_u32(next);
        if (read_u32(next + 4) == chunk_bin) {
            out->bin = next + CHUNK_BYTES;
            out->bin_size = size;
            return DM_OK;
        }
        next += CHUNK_BYTES + size;
        left -= CHUNK_BYTES + size;
    }
    return DM_OK;
}

static dm_result split_glb(const uint8_t* data, size_t size, dmi_gltf_problem* problem, dmi_gltf_container* out) {
    if (size < HEADER_BYTES + CHUNK_BYTES)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "GLB: truncated, %zu bytes don't hold a header and a chunk",
                               size);
    const uint32_t version = read_u32(data + 4), length = read_u32(data + 8);
    if (version != 2)
        return dmi_gltf_refuse(problem, version > 2 ? DM_ERROR_VERSION : DM_ERROR_UNSUPPORTED,
                               "GLB: version %u, only 2 can be read", version);
    if (length > size)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA,
                               "GLB: truncated, the header promises %u bytes and %zu are there", length, size);
    const uint32_t json_size = read_u32(data + HEADER_BYTES), kind = read_u32(data + HEADER_BYTES + 4);
    if (kind != chunk_json) return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "GLB: the first chunk is not JSON");
    if (length < HEADER_BYTES + CHUNK_BYTES || json_size > length - HEADER_BYTES - CHUNK_BYTES)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "GLB: the JSON chunk claims %u bytes of a file of %u",
                               json_size, length);
    out->json = (const char*)data + HEADER_BYTES + CHUNK_BYTES;
    out->json_size = json_size;
    const uint32_t left = length - HEADER_BYTES - CHUNK_BYTES - json_size;
    return find_bin(data + (length - left), left, problem, out);
}

/* Returns 1 for a text that begins as an object, after an optional byte order mark. */
static int is_object(const uint8_t* data, size_t size) {
    static const char blanks[] = {' ', '\t', '\r', '\n'};
    size_t at = size >= 3 && memcmp(data, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    while (at < size && memchr(blanks, data[at], sizeof blanks)) at++;
    return at < size && data[at] == '{';
}

dm_result dmi_gltf_split(const uint8_t* data, size_t size, dmi_gltf_problem* problem, dmi_gltf_container* out) {
    *out = (dmi_gltf_container){.json = (const char*)data, .json_size = size};
    if (size > UINT32_MAX)
        return dmi_gltf_refuse(problem, DM_ERROR_TOO_LARGE, "glTF: %zu bytes, 4 GB is the most", size);
    if (size >= 4 && memcmp(data, "glTF", 4) == 0) return split_glb(data, size, problem, out);
    if (is_object(data, size)) return DM_OK;
    return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA,
                           "not a GLB or glTF file: no 'glTF' magic and no JSON object (%zu bytes)", size);
}

/* ---- buffers ---- */

static dm_result open_file(dm_gltf* gltf, const char* uri, dmi_gltf_problem* problem, dmi_gltf_buffer* out) {
    const size_t room = strlen(uri) + 1;
    char* path = dmi_alloc(&gltf->env, room, 1);
    if (!path) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for a path");
    dm_result result = dmi_uri_to_path(uri, problem, path);
    size_t size = 0;
    if (result == DM_OK && !gltf->files.open) {
        result = dmi_gltf_refuse(problem, DM_ERROR_NOT_FOUND,
                                 "glTF: '%s' lies beside the file; dm_gltf_desc.files hands it over",
                                 dmi_uri_shorten(path).text);
    } else if (result == DM_OK) {
        const dm_result opened = gltf->files.open(gltf->files.user, path, &out->file, &size);
        const int no_memory = opened == DM_ERROR_OUT_OF_MEMORY;
        if (opened != DM_OK)
            result =
                dmi_gltf_refuse(problem, no_memory ? opened : DM_ERROR_NOT_FOUND,
                                no_memory ? "glTF: no memory for the file '%s'" : "glTF: the file '%s' is not there",
                                dmi_uri_shorten(path).text);
    }
    if (result != DM_OK) out->file = NULL;
    out->file_size = result == DM_OK ? size : 0;
    dmi_free(&gltf->env, path, room);
    return result;
}

dm_result dmi_gltf_open_uri(dm_gltf* gltf, const char* uri, dmi_gltf_problem* problem, dmi_gltf_buffer* out) {
    dm_result result;
    if (dmi_uri_is_data(uri)) {
        result = dmi_uri_decode(&gltf->env, uri, problem, &out->decoded, &out->decoded_size);
        out->data = out->decoded;
        out->size = out->decoded_size;
    } else {
        result = open_file(gltf, uri, problem, out);
        out->data = out->file;
        out->size = out->file_size;
    }
    return result;
}

/* Finds the bytes of one buffer. */
static dm_result fill_buffer(dm_gltf* gltf, uint32_t index, dmi_gltf_problem* problem) {
    dmi_gltf_buffer* out = &gltf->buffers[index];
    const cJSON* json = gltf->document.items[DMI_GLTF_BUFFERS][index];
    const char* uri = dmi_json_text(json, "uri");
    char place[64];
    uint64_t length;
    snprintf(place, sizeof place, "glTF buffer %u", index);
    dm_result result = dmi_json_whole(json, "byteLength", 0, UINT32_MAX, place, problem, &length);
    if (result != DM_OK) return result;
    if (!uri && (index > 0 || !gltf->bin)) return DM_OK;
    if (uri) {
        result = dmi_gltf_open_uri(gltf, uri, problem, out);
    } else {
        out->data = gltf->bin;
        out->size = gltf->bin_size;
    }
    if (result != DM_OK) return result;
    if (length > out->size)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: byteLength is %" PRIu64 ", its binary size %" PRIu64,
                               place, length, out->size);
    out->size = length;
    return DM_OK;
}

dm_result dmi_gltf_read_buffers(dm_gltf* gltf, const dmi_gltf_container* from, dmi_gltf_problem* problem) {
    const uint32_t count = gltf->document.counts[DMI_GLTF_BUFFERS], views = gltf->document.counts[DMI_GLTF_VIEWS];
    uint64_t bytes = from->json_size + from->bin_size;
    gltf->buffers = dmi_alloc_zeroed(&gltf->env, count * sizeof *gltf->buffers, 16);
    gltf->decoded = dmi_alloc_zeroed(&gltf->env, views * sizeof *gltf->decoded, 16);
    gltf->sparse_fit = dmi_alloc_zeroed(&gltf->env, gltf->document.counts[DMI_GLTF_ACCESSORS], 1);
    const int borrowed = from->bin && !gltf->on_disk.data; /* the bytes are borrowed for the call alone */
    gltf->bin_copy = borrowed ? dmi_alloc(&gltf->env, from->bin_size, 16) : NULL;
    gltf->bin_size = from->bin_size; /* the size of the copy, also when the rest fails */
    if (!gltf->buffers || !gltf->decoded || !gltf->sparse_fit || (borrowed && !gltf->bin_copy))
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %zu bytes", from->bin_size);
    gltf->bin = borrowed ? memcpy(gltf->bin_copy, from->bin, from->bin_size) : from->bin;
    for (uint32_t i = 0; i < count; i++) {
        const dm_result result = fill_buffer(gltf, i, problem);
        if (result != DM_OK) return result;
        bytes += gltf->buffers[i].file_size;
    }
    gltf->bytes_left = gltf->bytes_most = DMI_GLTF_BYTES_ALWAYS + DMI_GLTF_BYTES_PER_BYTE * bytes;
    gltf->draco_left = bytes;
    const dm_result result = dmi_gltf_spend(gltf, count, sizeof *gltf->buffers, "glTF: the buffers", problem);
    return result == DM_OK ? dmi_gltf_spend(gltf, views, sizeof *gltf->decoded, "glTF: the buffer views", problem)
                           : result;
}

static void release_list(dm_gltf* gltf, dmi_gltf_buffer* list, uint32_t count) {
    for (uint32_t i = 0; list && i < count; i++) {
        dmi_free(&gltf->env, list[i].decoded, list[i].decoded_size);
        if (list[i].file && gltf->files.close)
            gltf->files.close(gltf->files.user, list[i].file, (size_t)list[i].file_size);
    }
    dmi_free(&gltf->env, list, count * sizeof *list);
}

void dmi_gltf_release_buffers(dm_gltf* gltf) {
    dmi_env* env = &gltf->env;
    release_list(gltf, gltf->buffers, gltf->document.counts[DMI_GLTF_BUFFERS]);
    release_list(gltf, gltf->images, gltf->document.counts[DMI_GLTF_IMAGES]);
    dmi_free(env, gltf->sparse_fit, gltf->document.counts[DMI_GLTF_ACCESSORS]);
    dmi_free(env, gltf->bin_copy, gltf->bin_size);
}

/* ---- views ---- */

dm_result dmi_gltf_find_stored(dm_gltf* gltf, const cJSON* view, const char* place, dmi_gltf_problem* problem,
                               dmi_gltf_view* out) {
    const double index = dmi_json_number(view, "buffer", DMI_GLTF_NO_INDEX);
    const int64_t position = dmi_gltf_position(&gltf->document, DMI_GLTF_BUFFERS, index);
    uint64_t offset;
    if (position < 0)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: buffer %.17g does not exist", place, index);
    dm_result result = dmi_json_whole(view, "byteOffset", 0, UINT32_MAX, place, problem, &offset);
    if (result == DM_OK) result = dmi_json_whole(view, "byteLength", 0, UINT32_MAX, place, problem, &out->size);
    if (result == DM_OK) result = dmi_json_whole(view, "byteStride", 0, UINT32_MAX, place, problem, &out->stride);
    if (result != DM_OK) return result;
    const dmi_gltf_buffer* buffer = &gltf->buffers[position];
    if (!buffer->data)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: buffer %.17g has no bytes", place, index);
    if (offset > buffer->size || out->size > buffer->size - offset)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA,
                               "%s: a buffer view, bytes %" PRIu64 " + %" PRIu64 ", leaves its buffer of %" PRIu64,
                               place, offset, out->size, buffer->size);
    out->data = buffer->data + offset;
    return DM_OK;
}

static dm_result decode_meshopt(dm_gltf* gltf, const cJSON* extension, const char* place, dmi_gltf_problem* problem,
                                dmi_gltf_decoded* out) {
    dmi_gltf_view stored;
    dm_result result = dmi_gltf_find_stored(gltf, extension, place, problem, &stored);
    if (result != DM_OK) return result;
    dmi_meshopt_view view = {.data = stored.data,
                             .size = stored.size,
                             .stride = stored.stride,
                             .mode = dmi_json_text(extension, "mode"),
                             .filter = dmi_json_text(extension, "filter")};
    result = dmi_json_whole(extension, "count", 0, UINT32_MAX, place, problem, &view.count);
    if (result == DM_OK) result = dmi_meshopt_check(&view, place, problem);
    if (result == DM_OK) result = dmi_gltf_spend(gltf, view.count, view.stride, place, problem);
    if (result != DM_OK) return result;
    const uint64_t size = view.count * view.stride;
    uint8_t* data = dmi_alloc(&gltf->env, size, DMI_ALIGNMENT);
    if (!data) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "%s: no memory for %" PRIu64, place, size);
    result = dmi_meshopt_decode(&view, place, problem, data);
    if (result == DM_OK) {
        out->data = data;
        out->size = size;
    } else {
        dmi_free(&gltf->env, data, size);
    }
    return result;
}

/* Takes a view's plain bytes when its compressed ones do not decode, where the file has them and does not need the
 * extension. Else returns `problem`. */
static dm_result refuse_meshopt(dm_gltf* gltf, const cJSON* view, dmi_gltf_decoded* decoded, const char* place,
                                dmi_gltf_problem* problem, dmi_gltf_view* out) {
    dmi_gltf_problem none = {.code = DM_OK};
    if (problem->fatal || dmi_gltf_requires(&gltf->document, dmi_meshopt_name_of(view)) ||
        dmi_gltf_find_stored(gltf, view, place, &none, out) != DM_OK)
        return problem->code;
    decoded->refused = 1;
    dmi_gltf_warn(&gltf->warnings, "%s; its plain data is read", problem->text);
    *problem = (dmi_gltf_problem){.code = DM_OK};
    return DM_OK;
}

dm_result dmi_gltf_find_view(dm_gltf* gltf, double index, const char* place, dmi_gltf_problem* problem,
                             dmi_gltf_view* out) {
    const int64_t position = dmi_gltf_position(&gltf->document, DMI_GLTF_VIEWS, index);
    if (position < 0)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: buffer view %.17g does not exist", place, index);
    const cJSON *view = gltf->document.items[DMI_GLTF_VIEWS][position], *extension = dmi_meshopt_of(view);
    if (!extension || (!dmi_meshopt_available() && dmi_gltf_find_stored(gltf, view, place, problem, out) == DM_OK))
        return dmi_gltf_find_stored(gltf, view, place, problem, out);
    dmi_gltf_decoded* decoded = &gltf->decoded[position];
    if (decoded->refused) return dmi_gltf_find_stored(gltf, view, place, problem, out);
    if (!decoded->data) {
        const dm_result result = decode_meshopt(gltf, extension, place, problem, decoded);
        if (result != DM_OK) return refuse_meshopt(gltf, view, decoded, place, problem, out);
    }
    *out = (dmi_gltf_view){decoded->data, decoded->size, 0};
    return dmi_json_whole(extension, "byteStride", 0, UINT32_MAX, place, problem, &out->stride);
}
