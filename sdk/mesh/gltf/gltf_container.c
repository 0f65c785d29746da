/* The outside of a glTF file: magic, version, chunk lengths and how deep its JSON nests, checked before it is parsed.
 */
#include <string.h>

#include "mesh/gltf/gltf_container.h"

/* Deeper JSON is hostile: tinygltf reads extras by recursion. */
#define DEEPEST_JSON 128

enum { HEADER_BYTES = 12, CHUNK_BYTES = 8 };
static const uint32_t chunk_json = 0x4E4F534Au;

static uint32_t read_u32(const uint8_t* bytes) {
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static dm_result check_nesting(dmi_env* env, const uint8_t* json, size_t size) {
    int depth = 0, quoted = 0;
    for (size_t i = 0; i < size; i++) {
        if (quoted) {
            if (json[i] == '\\')
                i++;
            else if (json[i] == '"')
                quoted = 0;
        } else if (json[i] == '"') {
            quoted = 1;
        } else if (json[i] == '{' || json[i] == '[') {
            if (++depth > DEEPEST_JSON)
                return dmi_fail(env, DM_ERROR_BAD_DATA, "glTF: the JSON nests deeper than %d at byte %zu", DEEPEST_JSON,
                                i);
        } else if (json[i] == '}' || json[i] == ']') {
            depth--;
        }
    }
    return DM_OK;
}

static dm_result check_glb(dmi_env* env, const uint8_t* data, size_t size) {
    if (size < HEADER_BYTES + CHUNK_BYTES)
        return dmi_fail(env, DM_ERROR_BAD_DATA, "GLB: truncated, %zu bytes don't hold a header and a chunk", size);
    const uint32_t version = read_u32(data + 4), length = read_u32(data + 8);
    if (version != 2)
        return dmi_fail(env, version > 2 ? DM_ERROR_VERSION : DM_ERROR_UNSUPPORTED,
                        "GLB: version %u, only 2 can be read", version);
    if (length > size)
        return dmi_fail(env, DM_ERROR_BAD_DATA, "GLB: truncated, the header promises %u bytes and %zu are there",
                        length, size);
    const uint32_t json_size = read_u32(data + HEADER_BYTES), kind = read_u32(data + HEADER_BYTES + 4);
    if (kind != chunk_json) return dmi_fail(env, DM_ERROR_BAD_DATA, "GLB: the first chunk is not JSON");
    if (length < HEADER_BYTES + CHUNK_BYTES || json_size > length - HEADER_BYTES - CHUNK_BYTES)
        return dmi_fail(env, DM_ERROR_BAD_DATA, "GLB: the JSON chunk claims %u bytes of a file of %u", json_size,
                        length);
    const uint32_t left = length - HEADER_BYTES - CHUNK_BYTES - json_size;
    const uint8_t* next = data + (length - left);
    if (left > 0 && (left < CHUNK_BYTES || read_u32(next) > left - CHUNK_BYTES))
        return dmi_fail(env, DM_ERROR_BAD_DATA,
                        "GLB: truncated, the second chunk does not fit the %u bytes after the JSON", left);
    return check_nesting(env, data + HEADER_BYTES + CHUNK_BYTES, json_size);
}

static size_t skip_blanks(const uint8_t* data, size_t size) {
    size_t at = size >= 3 && memcmp(data, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    while (at < size && (data[at] == ' ' || data[at] == '\t' || data[at] == '\r' || data[at] == '\n')) at++;
    return at;
}

dm_result dmi_gltf_check_container(dmi_env* env, const uint8_t* data, size_t size, int* out_binary) {
    if (size > UINT32_MAX) return dmi_fail(env, DM_ERROR_TOO_LARGE, "glTF: %zu bytes, 4 GB is the most", size);
    *out_binary = size >= 4 && memcmp(data, "glTF", 4) == 0;
    if (*out_binary) return check_glb(env, data, size);
    const size_t first = skip_blanks(data, size);
    if (first < size && data[first] == '{') return check_nesting(env, data, size);
    return dmi_fail(env, DM_ERROR_BAD_DATA, "not a GLB or glTF file: no 'glTF' magic and no JSON object (%zu bytes)",
                    size);
}
