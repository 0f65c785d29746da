/* Decodes data: URIs in base64, and relative ones. */
#include "gltf/gltf_buffers.h"

#include <string.h>

static const char data_scheme[] = "data:", base64_mark[] = ";base64";

dmi_uri_excerpt dmi_uri_shorten(const char* uri) {
    dmi_uri_excerpt out;
    const size_t most = sizeof out.text - sizeof "…";
    size_t length = strnlen(uri, most + 1);
    const int whole = length <= most;
    while (!whole && length > 0 && (length > most || ((unsigned char)uri[length] & 0xC0) == 0x80)) length--;
    memcpy(out.text, uri, length);
    memcpy(out.text + length, whole ? "" : "…", whole ? 1 : sizeof "…");
    return out;
}

static char lower(char c) {
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

/* Returns whether `text` begins with `word`, which is in lower case, in any case of letters. */
static int begins(const char* text, const char* word) {
    while (*word && lower(*text) == *word) text++, word++;
    return !*word;
}

int dmi_uri_is_data(const char* uri) {
    return begins(uri, data_scheme);
}

/* Returns the value of a digit of base64, or -1 for another character. */
static int digit_of(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+' || c == '-') return 62;
    return c == '/' || c == '_' ? 63 : -1;
}

/* Decodes base64. Returns the bytes written, or -1 for a text that is none. */
static int64_t decode_base64(const char* text, size_t length, uint8_t* out) {
    uint32_t bits = 0;
    int held = 0;
    uint8_t* to = out;
    for (size_t i = 0; i < length; i++) {
        const int digit = digit_of(text[i]);
        if (digit < 0) return -1;
        bits = bits << 6 | (uint32_t)digit;
        held += 6;
        if (held < 8) continue;
        held -= 8;
        *to++ = (uint8_t)(bits >> held);
    }
    return to - out;
}

dm_result dmi_uri_decode(dmi_env* env, const char* uri, dmi_gltf_problem* problem, uint8_t** out, uint64_t* out_size) {
    const char* comma = strchr(uri, ',');
    const size_t mark = sizeof base64_mark - 1;
    if (!comma || (size_t)(comma - uri) < mark || !begins(comma - mark, base64_mark))
        return dmi_gltf_refuse(problem, DM_ERROR_UNSUPPORTED, "glTF: a data URI that is not base64: '%s'",
                               dmi_uri_shorten(uri).text);
    const char* text = comma + 1;
    size_t length = strlen(text);
    while (length > 0 && text[length - 1] == '=') length--;
    const uint64_t size = (uint64_t)length / 4 * 3 + length % 4 * 3 / 4;
    uint8_t* bytes = dmi_alloc(env, size, 16);
    if (!bytes) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for an embedded buffer");
    if (decode_base64(text, length, bytes) != (int64_t)size) {
        dmi_free(env, bytes, size);
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "glTF: a data URI whose base64 is broken: '%s'",
                               dmi_uri_shorten(uri).text);
    }
    *out = bytes;
    *out_size = size;
    return DM_OK;
}

static int hex_of(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* Decodes percent signs. Returns 0 where the path holds a zero byte. */
static int decode_percent(const char* uri, char* path) {
    while (*uri) {
        const int high = uri[0] == '%' ? hex_of(uri[1]) : -1, low = high >= 0 ? hex_of(uri[2]) : -1;
        if (high == 0 && low == 0) return 0;
        *path++ = low >= 0 ? (char)(16 * high + low) : *uri;
        uri += low >= 0 ? 3 : 1;
    }
    *path = 0;
    return 1;
}

/* Returns whether the path stays in its folder, because its steps are names. */
static int stays(const char* path) {
    if (!path[0] || strpbrk(path, "\\:")) return 0;
    for (const char* step = path;; step++) {
        const size_t length = strcspn(step, "/");
        if (length == 0 || (length == 1 && step[0] == '.' && path[1] == 0)) return 0;
        if (length == 2 && step[0] == '.' && step[1] == '.') return 0;
        step += length;
        if (!*step) return 1;
    }
}

dm_result dmi_uri_to_path(const char* uri, dmi_gltf_problem* problem, char* path) {
    if (!decode_percent(uri, path))
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "glTF: '%s' holds %%00, a zero byte, as no file's name does",
                               dmi_uri_shorten(uri).text);
    while (strncmp(path, "./", 2) == 0) memmove(path, path + 2, strlen(path) - 1);
    if (stays(path)) return DM_OK;
    return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "glTF: '%s' is no file beside this one",
                           dmi_uri_shorten(uri).text);
}
