/* Splits a glTF file: the chunks of a .glb, or JSON alone. */
#include "gltf/gltf_container.h"

#include <string.h>

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
