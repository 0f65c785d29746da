/* Parses mask files: NumPy's .npy format (versions 1 to 3) and flat JSON arrays; every byte is checked. The JSON parser
 * here keeps all 64 bits of a value and uses the host's allocator, which cJSON does not. */
#include "mesh/mask.h"

#include <stdbool.h>
#include <string.h>

#define NPY_MAGIC "\x93NUMPY"
#define NPY_MAGIC_SIZE 6     /* bytes */
#define MAX_SHOWN 32         /* bytes of the file quoted in a message; by hand */
#define NPY_MAX_HEADER 65536 /* bytes; by hand: a header of one dimension has under 128 */

/* ---- text ---- */

typedef struct text {
    const char *at, *end;
} text;

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

static void skip_spaces(text* t) {
    while (t->at < t->end && (*t->at == ' ' || *t->at == '\t' || *t->at == '\n' || *t->at == '\r')) t->at++;
}

/* Skips spaces and consumes `word`; false when something else follows. */
static bool take(text* t, const char* word) {
    size_t length = strlen(word);
    skip_spaces(t);
    if ((size_t)(t->end - t->at) < length || memcmp(t->at, word, length) != 0) return false;
    t->at += length;
    return true;
}

/* Consumes digits; false when there is none or the number exceeds `limit`. */
static bool take_digits(text* t, uint64_t limit, uint64_t* out) {
    uint64_t value = 0;
    if (t->at >= t->end || !is_digit(*t->at)) return false;
    for (; t->at < t->end && is_digit(*t->at); t->at++) {
        uint64_t digit = (uint64_t)(*t->at - '0');
        if (digit > limit || value > (limit - digit) / 10) return false;
        value = value * 10 + digit;
    }
    *out = value;
    return true;
}

static dm_result allocate_values(dmi_env* env, uint64_t count, int64_t** out_values) {
    if (count > DM_MAX_ELEMENTS) {
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "mask: %llu values, at most %d", (unsigned long long)count,
                        DM_MAX_ELEMENTS);
    }
    *out_values = dmi_alloc(env, (size_t)count * sizeof(int64_t), DMI_ALIGNMENT);
    if (*out_values != NULL) return DM_OK;
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for a mask of %llu values", (unsigned long long)count);
}

/* ---- .npy (numpy.lib.format) ---- */

typedef struct npy_header {
    char kind;   /* b, u or i */
    size_t size; /* bytes a value */
    uint64_t count;
    bool has_descr, has_order, has_shape;
} npy_header;

/* Consumes a quoted Python string; escapes do not occur in these headers. */
static bool take_string(text* t, text* out) {
    skip_spaces(t);
    if (t->at >= t->end || (*t->at != '\'' && *t->at != '"')) return false;
    char quote = *t->at++;
    out->at = t->at;
    while (t->at < t->end && *t->at != quote && *t->at != '\\') t->at++;
    if (t->at >= t->end || *t->at != quote) return false;
    out->end = t->at++;
    return true;
}

static bool string_is(const text* string, const char* word) {
    return (size_t)(string->end - string->at) == strlen(word) && memcmp(string->at, word, strlen(word)) == 0;
}

/* Reads a type such as "<i4" or "|b1": byte order, kind, size. */
static dm_result read_descr(dmi_env* env, text* t, npy_header* header) {
    text descr;
    if (!take_string(t, &descr)) return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: 'descr' is not a plain type");
    static const char* const types[] = {"|b1", "|u1", "|i1", "<u2", "<i2", "<u4", "<i4", "<u8", "<i8"};
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        if (!string_is(&descr, types[i])) continue;
        header->kind = types[i][1];
        header->size = (size_t)(types[i][2] - '0');
        header->has_descr = true;
        return DM_OK;
    }
    return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: values of type '%.*s', must be bool or little-endian integers",
                    (int)(descr.end - descr.at < MAX_SHOWN ? descr.end - descr.at : MAX_SHOWN), descr.at);
}

/* Reads a shape such as "(12,)": one dimension. */
static dm_result read_shape(dmi_env* env, text* t, npy_header* header) {
    bool good = take(t, "(");
    skip_spaces(t);
    good = good && take_digits(t, UINT64_MAX, &header->count);
    if (good) {
        take(t, "L"); /* Python 2 wrote long integers so */
        take(t, ",");
        good = take(t, ")");
    }
    if (!good) return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: 'shape' is not of one dimension");
    header->has_shape = true;
    return DM_OK;
}

static dm_result read_entry(dmi_env* env, text* t, npy_header* header) {
    text key;
    if (!take_string(t, &key) || !take(t, ":"))
        return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: header is no dictionary");
    if (string_is(&key, "descr")) return read_descr(env, t, header);
    if (string_is(&key, "shape")) return read_shape(env, t, header);
    if (string_is(&key, "fortran_order")) {
        /* One dimension lies in memory the same way in both orders. */
        header->has_order = take(t, "False") || take(t, "True");
        if (header->has_order) return DM_OK;
    }
    return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: header entry '%.*s' can't be read",
                    (int)(key.end - key.at < MAX_SHOWN ? key.end - key.at : MAX_SHOWN), key.at);
}

static dm_result read_header(dmi_env* env, text t, npy_header* header) {
    *header = (npy_header){0};
    if (!take(&t, "{")) return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: header is no dictionary");
    while (!take(&t, "}")) {
        dm_result result = read_entry(env, &t, header);
        if (result != DM_OK) return result;
        take(&t, ",");
    }
    skip_spaces(&t);
    if (t.at == t.end && header->has_descr && header->has_order && header->has_shape) return DM_OK;
    return dmi_fail(env, DM_ERROR_BAD_DATA,
                    "mask.npy: header has no 'descr', 'fortran_order' or 'shape', or more behind it");
}

static uint64_t little_endian(const uint8_t* bytes, size_t size) {
    uint64_t value = 0;
    for (size_t i = size; i-- > 0;) value = value << 8 | bytes[i];
    return value;
}

/* Values above INT64_MAX (a segmenter's "none" as all bits set) come out negative: still non-zero, still distinct. */
static int64_t npy_value(const uint8_t* bytes, const npy_header* header) {
    uint64_t value = little_endian(bytes, header->size);
    if (header->kind == 'i' && header->size < 8) {
        uint64_t sign = 1ull << (8 * header->size - 1);
        value = (value ^ sign) - sign;
    }
    int64_t out;
    memcpy(&out, &value, sizeof out);
    return out;
}

static dm_result parse_npy(dmi_env* env, const uint8_t* bytes, size_t size, int64_t** out_values, size_t* out_count) {
    size_t prefix =
        size > NPY_MAGIC_SIZE && bytes[NPY_MAGIC_SIZE] >= 2 ? 12 : 10; /* bytes before the header, by version */
    if (size < prefix) return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: %zu bytes, the header is cut off", size);
    if (bytes[6] < 1 || bytes[6] > 3) {
        return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: format version %d, known are 1 to 3", bytes[6]);
    }
    uint64_t length = little_endian(bytes + 8, prefix - 8);
    if (length > size - prefix || length > NPY_MAX_HEADER) {
        return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: a header of %llu bytes in a file of %zu",
                        (unsigned long long)length, size);
    }
    const char* start = (const char*)bytes + prefix;
    npy_header header;
    dm_result result = read_header(env, (text){start, start + length}, &header);
    if (result != DM_OK) return result;
    size_t rest = size - prefix - (size_t)length;
    if (header.count == 0) return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: no values");
    if (rest % header.size != 0 || rest / header.size != header.count) {
        return dmi_fail(env, DM_ERROR_BAD_DATA, "mask.npy: %llu values of %zu bytes announced, %zu bytes follow",
                        (unsigned long long)header.count, header.size, rest);
    }
    int64_t* values;
    result = allocate_values(env, header.count, &values);
    if (result != DM_OK) return result;
    const uint8_t* data = bytes + prefix + length;
    for (size_t i = 0; i < header.count; i++) values[i] = npy_value(data + i * header.size, &header);
    *out_values = values;
    *out_count = (size_t)header.count;
    return DM_OK;
}

/* ---- JSON ---- */

/* Consumes an integer (possibly with a fraction of zeros), true or false. */
static bool take_value(text* t, int64_t* out) {
    if (take(t, "true")) {
        *out = 1;
        return true;
    }
    if (take(t, "false")) {
        *out = 0;
        return true;
    }
    const bool negative = take(t, "-");
    uint64_t magnitude, fraction;
    if (!take_digits(t, (uint64_t)INT64_MAX, &magnitude)) return false;
    if (t->at < t->end && *t->at == '.') {
        t->at++;
        if (!take_digits(t, 0, &fraction)) return false;
    }
    *out = negative ? -(int64_t)magnitude : (int64_t)magnitude;
    return true;
}

/* Consumes values up to the closing bracket; false when something else follows. */
static bool take_array(text* t, int64_t* values, size_t* count) {
    do {
        if (!take_value(t, &values[*count])) return false;
        ++*count;
    } while (take(t, ","));
    if (!take(t, "]")) return false;
    skip_spaces(t);
    return t->at == t->end;
}

static dm_result parse_json(dmi_env* env, const char* data, size_t size, int64_t** out_values, size_t* out_count) {
    text t = {data, data + size};
    take(&t, "\xEF\xBB\xBF"); /* the byte order mark some editors write */
    if (!take(&t, "[")) return dmi_fail(env, DM_ERROR_BAD_DATA, "mask: neither .npy nor a JSON array");
    uint64_t capacity = 1; /* one value more than commas */
    for (const char* c = t.at; c < t.end; c++) capacity += *c == ',';
    int64_t* values;
    dm_result result = allocate_values(env, capacity, &values);
    if (result != DM_OK) return result;
    size_t count = 0;
    if (take_array(&t, values, &count)) {
        *out_values = values;
        *out_count = count;
        return DM_OK;
    }
    dmi_free(env, values, (size_t)capacity * sizeof(int64_t));
    return dmi_fail(env, DM_ERROR_BAD_DATA, "mask: not a flat JSON array of integers (at byte %zu, after %zu values)",
                    (size_t)(t.at - data), count);
}

/* ---- both formats ---- */

dm_result dmi_mask_parse(dmi_env* env, const void* data, size_t size, int64_t** out_values, size_t* out_count) {
    if (data == NULL || size == 0) return dmi_fail(env, DM_ERROR_BAD_DATA, "mask: no bytes");
    if (size >= NPY_MAGIC_SIZE && memcmp(data, NPY_MAGIC, NPY_MAGIC_SIZE) == 0) {
        return parse_npy(env, data, size, out_values, out_count);
    }
    return parse_json(env, data, size, out_values, out_count);
}

dm_result dmi_mask_to_part_ids(dmi_env* env, const int64_t* values, size_t count, const int64_t* mask_value,
                               size_t vertex_count, size_t face_count, uint8_t* out_part_ids, int32_t* out_scope,
                               int* out_ambiguous) {
    if (count != vertex_count && count != face_count) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "mask: %zu values for %zu vertices and %zu triangles", count,
                        vertex_count, face_count);
    }
    for (size_t i = 0; i < count; i++) out_part_ids[i] = mask_value != NULL ? values[i] == *mask_value : values[i] != 0;
    *out_scope = count == vertex_count ? DM_PER_VERTEX : DM_PER_FACE;
    *out_ambiguous = vertex_count == face_count;
    return DM_OK;
}
