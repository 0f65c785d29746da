/* Reads safetensors files: 8 bytes of header length, a JSON header, packed tensors. Everything in the file is checked.
 */
#include "nn/weights.h"

#include <cjson/cJSON.h>
#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/compiler.h"
#include "base/cpu.h"

#define LENGTH_BYTES 8 /* bytes of the header length, as the format has it */
/* Bytes of the header; by hand: ours have about 10 KB. Bounds what a malicious file makes the JSON parser allocate. */
#define MAX_HEADER ((size_t)1 << 20)
#define MAX_TENSORS 4096 /* set by hand: ours have under 200 */
#define MAX_DIMENSIONS 8 /* set by hand: ours have 2 */

typedef struct tensor {
    const char* name;  /* a string of the JSON tree */
    size_t begin, end; /* bytes, from the start of the tensors */
    uint32_t shape[MAX_DIMENSIONS];
    uint32_t dimensions;
    bool is_half; /* float16; else float32 */
} tensor;

struct dmi_weights {
    dmi_env* env;
    const unsigned char* tensors_data;
    size_t tensors_size;
    cJSON* header;
    const cJSON* metadata;
    tensor* tensors; /* sorted by name */
    uint32_t tensor_count;
    size_t tensors_bytes; /* size of the allocation of `tensors` */
};

static dm_result parse_header(dmi_weights* weights, const unsigned char* data, size_t size) {
    uint64_t length = 0;
    if (size < LENGTH_BYTES)
        return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: %zu bytes are no safetensors file", size);
    for (int i = 0; i < LENGTH_BYTES; i++) length |= (uint64_t)data[i] << (8 * i);
    if (length > size - LENGTH_BYTES || length > MAX_HEADER)
        return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: header length %llu in a file of %zu bytes",
                        (unsigned long long)length, size);
    char* text = dmi_alloc(weights->env, (size_t)length + 1, 1);
    if (text == NULL) return dmi_fail(weights->env, DM_ERROR_OUT_OF_MEMORY, "weights: no memory for the header");
    memcpy(text, data + LENGTH_BYTES, (size_t)length);
    text[length] = 0;
    const char* stop = NULL;
    errno = 0; /* cJSON does not tell a failed malloc from a bad text */
    weights->header = cJSON_ParseWithOpts(text, &stop, 0);
    const bool no_memory = weights->header == NULL && errno == ENOMEM;
    const bool whole =
        weights->header != NULL && cJSON_IsObject(weights->header) && stop + strspn(stop, " \t\r\n") == text + length;
    dmi_free(weights->env, text, (size_t)length + 1);
    if (no_memory)
        return dmi_fail(weights->env, DM_ERROR_OUT_OF_MEMORY, "weights: no memory for a header of %llu bytes",
                        (unsigned long long)length);
    if (!whole) return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: the header is not one JSON object");
    weights->tensors_data = data + LENGTH_BYTES + length;
    weights->tensors_size = size - LENGTH_BYTES - (size_t)length;
    return DM_OK;
}

/* Reads a whole number in [0, limit]. */
static bool read_count(const cJSON* item, size_t limit, size_t* out) {
    if (!cJSON_IsNumber(item) || !(item->valuedouble >= 0) || item->valuedouble > (double)limit) return false;
    *out = (size_t)item->valuedouble;
    return (double)*out == item->valuedouble && *out <= limit;
}

/* Reads a shape and its size in bytes; false when it is not one. */
static bool read_shape(const cJSON* shape, tensor* out, size_t limit, size_t* out_bytes) {
    size_t bytes = out->is_half ? sizeof(uint16_t) : sizeof(float);
    if (!cJSON_IsArray(shape)) return false;
    for (const cJSON* item = shape->child; item != NULL; item = item->next) {
        size_t side = 0;
        if (out->dimensions == MAX_DIMENSIONS || !read_count(item, UINT32_MAX, &side)) return false;
        if (side != 0 && bytes > limit / side) return false;
        bytes *= side;
        out->shape[out->dimensions++] = (uint32_t)side;
    }
    *out_bytes = bytes;
    return true;
}

static dm_result read_tensor(const dmi_weights* weights, const cJSON* item, tensor* out) {
    const cJSON* dtype = cJSON_GetObjectItemCaseSensitive(item, "dtype");
    const cJSON* offsets = cJSON_GetObjectItemCaseSensitive(item, "data_offsets");
    const cJSON* first = cJSON_IsArray(offsets) ? offsets->child : NULL;
    size_t bytes = 0;
    *out = (tensor){.name = item->string};
    out->is_half = cJSON_IsString(dtype) && strcmp(dtype->valuestring, "F16") == 0;
    if (!out->is_half && (!cJSON_IsString(dtype) || strcmp(dtype->valuestring, "F32") != 0))
        return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: tensor '%s' is of neither dtype F32 nor F16",
                        item->string);
    if (!read_shape(cJSON_GetObjectItemCaseSensitive(item, "shape"), out, weights->tensors_size, &bytes))
        return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: tensor '%s' has no usable shape", item->string);
    if (first == NULL || first->next == NULL || first->next->next != NULL ||
        !read_count(first, weights->tensors_size, &out->begin) ||
        !read_count(first->next, weights->tensors_size, &out->end) || out->end < out->begin ||
        out->end - out->begin != bytes)
        return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: tensor '%s' has wrong data_offsets", item->string);
    return DM_OK;
}

static int compare_begin(const void* a, const void* b) {
    const tensor *left = a, *right = b;
    if (left->begin != right->begin) return left->begin < right->begin ? -1 : 1;
    return (left->end > right->end) - (left->end < right->end);
}

static int compare_name(const void* a, const void* b) {
    return strcmp(((const tensor*)a)->name, ((const tensor*)b)->name);
}

/* Checks that the tensors fill their bytes without overlap or gap, and that names are unique. */
static dm_result check_layout(dmi_weights* weights) {
    size_t end = 0;
    qsort(weights->tensors, weights->tensor_count, sizeof(tensor), compare_begin);
    for (uint32_t i = 0; i < weights->tensor_count; i++) {
        if (weights->tensors[i].begin != end)
            return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: tensor '%s' overlaps another or leaves a hole",
                            weights->tensors[i].name);
        end = weights->tensors[i].end;
    }
    if (end != weights->tensors_size)
        return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: tensors take %zu of %zu bytes", end,
                        weights->tensors_size);
    qsort(weights->tensors, weights->tensor_count, sizeof(tensor), compare_name);
    for (uint32_t i = 1; i < weights->tensor_count; i++)
        if (strcmp(weights->tensors[i - 1].name, weights->tensors[i].name) == 0)
            return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: two tensors named '%s'",
                            weights->tensors[i].name);
    return DM_OK;
}

static dm_result read_tensors(dmi_weights* weights) {
    const int entries = cJSON_GetArraySize(weights->header);
    if (entries > MAX_TENSORS)
        return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: %d tensors, more than %d", entries, MAX_TENSORS);
    weights->tensors_bytes = (size_t)entries * sizeof(tensor);
    weights->tensors = dmi_alloc(weights->env, weights->tensors_bytes, _Alignof(tensor));
    if (weights->tensors == NULL)
        return dmi_fail(weights->env, DM_ERROR_OUT_OF_MEMORY, "weights: no memory for the index");
    for (const cJSON* item = weights->header->child; item != NULL; item = item->next) {
        if (strcmp(item->string, "__metadata__") == 0) {
            if (weights->metadata != NULL || !cJSON_IsObject(item))
                return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: __metadata__ is not one object");
            weights->metadata = item;
            continue;
        }
        const dm_result result = read_tensor(weights, item, &weights->tensors[weights->tensor_count]);
        if (result != DM_OK) return result;
        weights->tensor_count++;
    }
    return check_layout(weights);
}

static dm_result check_metadata(const dmi_weights* weights, const char* architecture, int max_version) {
    const char* found = dmi_weights_metadata(weights, "architecture");
    const char* version = dmi_weights_metadata(weights, "version");
    if (found == NULL || strcmp(found, architecture) != 0)
        return dmi_fail(weights->env, DM_ERROR_WRONG_MODEL, "weights: architecture '%.64s', expected '%s'",
                        found != NULL ? found : "", architecture);
    char* stop = NULL;
    const long number = version != NULL ? strtol(version, &stop, 10 /* decimal */) : 0;
    if (version == NULL || stop == version || *stop || number < 1)
        return dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: version '%.64s' is no number",
                        version != NULL ? version : "");
    if (number > max_version)
        return dmi_fail(weights->env, DM_ERROR_VERSION, "weights: version %ld, this library reads up to %d", number,
                        max_version);
    return DM_OK;
}

dm_result dmi_weights_open(dmi_env* env, const void* data, size_t size, const char* architecture, int max_version,
                           dmi_weights** out_weights) {
    dmi_weights* weights = dmi_alloc_zeroed(env, sizeof *weights, _Alignof(dmi_weights));
    if (weights == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "weights: no memory");
    weights->env = env;
    dm_result result = parse_header(weights, data, size);
    if (result == DM_OK) result = read_tensors(weights);
    if (result == DM_OK) result = check_metadata(weights, architecture, max_version);
    if (result != DM_OK) {
        dmi_weights_close(weights);
        return result;
    }
    *out_weights = weights;
    return DM_OK;
}

void dmi_weights_close(dmi_weights* weights) {
    if (weights == NULL) return;
    dmi_env* env = weights->env;
    cJSON_Delete(weights->header);
    if (weights->tensors != NULL) dmi_free(env, weights->tensors, weights->tensors_bytes);
    dmi_free(env, weights, sizeof *weights);
}

/* Converts IEEE 754 binary16 to binary32 exactly, with subnormals, infinities and NaN, and without a branch. Sets all
 * bits of `special` where it is infinity or NaN. */
static inline float widen(uint16_t half, uint32_t* found) {
    const uint32_t special = 0u - (uint32_t)((half & 0x7c00u) == 0x7c00u);
    *found |= special;
    const uint32_t magnitude = (half & 0x7fffu) << 13;
    uint32_t bits;
    float value;
    memcpy(&value, &magnitude, sizeof value);
    value *= 0x1p112f; /* the difference of the exponents' biases; also makes a subnormal normal */
    memcpy(&bits, &value, sizeof bits);
    bits |= (uint32_t)(half & 0x8000u) << 16 | (special & (0x7f800000u | magnitude));
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Converts halves, which are little-endian; where the machine is too, the loop becomes vector code. Returns whether all
 * are finite. */
DMI_ALWAYS_INLINE static inline bool widen_each(const unsigned char* data, size_t count, float* out) {
    uint32_t found = 0;
    for (size_t i = 0; i < count; i++) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
        uint16_t half;
        memcpy(&half, data + 2 * i, sizeof half);
        out[i] = widen(half, &found);
#else
        out[i] = widen((uint16_t)(data[2 * i] | data[2 * i + 1] << 8), &found);
#endif
    }
    return found == 0;
}

static bool widen_plain(const unsigned char* data, size_t count, float* out) {
    return widen_each(data, count, out);
}

#if defined(__x86_64__)
DMI_TARGET("avx2") static bool widen_avx2(const unsigned char* data, size_t count, float* out) {
    return widen_each(data, count, out);
}
#endif

static bool widen_all(const unsigned char* data, size_t count, float* out) {
#if defined(__x86_64__)
    if (dmi_isa_has_avx2(dmi_cpu_best_isa())) return widen_avx2(data, count, out);
#endif
    return widen_plain(data, count, out);
}

/* Has no branch, so that it becomes vector code. */
static bool are_finite(const float* numbers, size_t count) {
    const uint32_t exponent = 0x7f800000u;
    uint32_t found = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        found |= (uint32_t)((bits & exponent) == exponent);
    }
    return found == 0;
}

/* Returns the tensor; NULL, and a log line, when there is none of this shape. */
static const tensor* find_tensor(const dmi_weights* weights, const char* name, uint32_t rows, uint32_t cols) {
    const tensor key = {.name = name};
    const tensor* found = weights->tensor_count == 0
                              ? NULL
                              : bsearch(&key, weights->tensors, weights->tensor_count, sizeof(tensor), compare_name);
    const uint32_t dimensions = cols ? 2 : 1;
    if (found == NULL || found->dimensions != dimensions || found->shape[0] != rows ||
        (cols && found->shape[1] != cols)) {
        dmi_fail(weights->env, DM_ERROR_BAD_DATA, "weights: no tensor '%s' of %u x %u numbers", name, rows,
                 cols ? cols : 1);
        return NULL;
    }
    return found;
}

bool dmi_weights_read(const dmi_weights* weights, const char* name, uint32_t rows, uint32_t cols, float* out,
                      bool* out_finite) {
    const tensor* found = find_tensor(weights, name, rows, cols);
    if (found == NULL) return false;
    const unsigned char* data = weights->tensors_data + found->begin;
    bool finite;
    if (!found->is_half) {
        memcpy(out, data, found->end - found->begin);
        finite = are_finite(out, (found->end - found->begin) / sizeof *out);
    } else {
        finite = widen_all(data, (found->end - found->begin) / sizeof(uint16_t), out);
    }
    if (out_finite != NULL) *out_finite = finite;
    return true;
}

const char* dmi_weights_metadata(const dmi_weights* weights, const char* key) {
    const cJSON* item = cJSON_GetObjectItemCaseSensitive(weights->metadata, key);
    return cJSON_IsString(item) ? item->valuestring : NULL;
}
