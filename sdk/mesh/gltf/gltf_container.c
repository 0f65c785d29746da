/* What is checked of a glTF file before it is parsed: magic, version, chunk lengths, how deep its JSON nests, and the
 * numbers that tinygltf would cut off. */
#include <inttypes.h>
#include <string.h>

#include "mesh/gltf/gltf_container.h"

/* Deeper JSON is hostile: tinygltf reads extras by recursion. */
#define DEEPEST_JSON 128

enum { HEADER_BYTES = 12, CHUNK_BYTES = 8 };
static const uint32_t chunk_json = 0x4E4F534Au;

static uint32_t read_u32(const uint8_t* bytes) {
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

/* Numbers by which a file addresses its bytes. tinygltf keeps only the low 32 bits of some, and takes others for 0 when
 * they are negative, have a fraction or don't fit 64 bits; so they are checked where they are still text. */
static const struct {
    const char* name;
    uint64_t most;
} limited[] = {{"buffer", INT32_MAX},      {"bufferView", INT32_MAX},  {"byteOffset", UINT32_MAX},
               {"byteLength", UINT32_MAX}, {"byteStride", UINT32_MAX}, {"count", UINT32_MAX}};

/* A place in the JSON. */
typedef struct cursor {
    const uint8_t* json;
    size_t size, at;
} cursor;

static void skip_blanks(cursor* c) {
    while (c->at < c->size && memchr(" \t\r\n", c->json[c->at], 4)) c->at++;
}

/* Moves from a string's opening quote past its closing one; returns the length between them. */
static size_t skip_string(cursor* c) {
    const size_t first = ++c->at;
    while (c->at < c->size && c->json[c->at] != '"') c->at += c->json[c->at] == '\\' ? 2 : 1;
    if (c->at > c->size) c->at = c->size;
    const size_t length = c->at - first;
    if (c->at < c->size) c->at++;
    return length;
}

static int is_named(const uint8_t* text, size_t length, const char* name) {
    return strlen(name) == length && memcmp(text, name, length) == 0;
}

/* The cursor is at a value: when that is a number, it must be whole and from 0 to `most`. */
static dm_result check_number(dmi_env* env, const cursor* c, const char* name, uint64_t most) {
    const uint8_t* text = c->json + c->at;
    const size_t left = c->size - c->at;
    size_t length = 0;
    int whole = 1;
    uint64_t value = 0; /* stays at 2^32 and more once it is that large */
    while (length < left && memchr("0123456789+-.eE", text[length], 15)) {
        const int is_digit = text[length] >= '0' && text[length] <= '9';
        whole &= is_digit;
        if (is_digit && value <= UINT32_MAX) value = 10 * value + (uint64_t)(text[length] - '0');
        length++;
    }
    if (length == 0 || (whole && value <= most)) return DM_OK;
    return dmi_fail(env, DM_ERROR_BAD_DATA, "glTF: %s %.*s at byte %zu of the JSON, it must be whole and 0 to %" PRIu64,
                    name, (int)(length < 40 ? length : 40), (const char*)text, c->at, most);
}

/* Checks how deep the JSON nests, and the limited numbers outside of extras. */
static dm_result check_json(dmi_env* env, const uint8_t* json, size_t size) {
    cursor c = {json, size, 0};
    int depth = 0, extras = 0; /* extras: the depth of the object whose extras these are; 0: none */
    while (c.at < size) {
        if (json[c.at] == '{' || json[c.at] == '[') {
            if (++depth > DEEPEST_JSON)
                return dmi_fail(env, DM_ERROR_BAD_DATA, "glTF: the JSON nests deeper than %d at byte %zu", DEEPEST_JSON,
                                c.at);
        } else if (json[c.at] == '}' || json[c.at] == ']') {
            if (--depth < extras) extras = 0;
        }
        if (json[c.at] != '"') {
            c.at++;
            continue;
        }
        const uint8_t* name = json + c.at + 1;
        const size_t length = skip_string(&c);
        skip_blanks(&c);
        if (c.at == size || json[c.at] != ':') continue;
        c.at++;
        skip_blanks(&c);
        if (depth <= extras) extras = 0;
        if (!extras && is_named(name, length, "extras")) extras = depth;
        for (size_t i = 0; i < sizeof limited / sizeof *limited && !extras; i++) {
            if (!is_named(name, length, limited[i].name)) continue;
            const dm_result result = check_number(env, &c, limited[i].name, limited[i].most);
            if (result != DM_OK) return result;
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
    return check_json(env, data + HEADER_BYTES + CHUNK_BYTES, json_size);
}

/* 1 for a text that begins as an object, after an optional byte order mark. */
static int is_object(const uint8_t* data, size_t size) {
    cursor c = {data, size, size >= 3 && memcmp(data, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0};
    skip_blanks(&c);
    return c.at < size && data[c.at] == '{';
}

dm_result dmi_gltf_check_container(dmi_env* env, const uint8_t* data, size_t size, int* out_binary) {
    if (size > UINT32_MAX) return dmi_fail(env, DM_ERROR_TOO_LARGE, "glTF: %zu bytes, 4 GB is the most", size);
    *out_binary = size >= 4 && memcmp(data, "glTF", 4) == 0;
    if (*out_binary) return check_glb(env, data, size);
    if (is_object(data, size)) return check_json(env, data, size);
    return dmi_fail(env, DM_ERROR_BAD_DATA, "not a GLB or glTF file: no 'glTF' magic and no JSON object (%zu bytes)",
                    size);
}
