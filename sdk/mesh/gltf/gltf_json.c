/* JSON read by cJSON, whose memory comes from malloc: its hooks belong to the whole process, so they stay as they are.
 * A text of n bytes takes at most 40 n (a value of one byte and a comma: 64 bytes and the heap's own 16). */
#include "mesh/gltf/gltf_json.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "base/utf8.h"

/* Deeper JSON is hostile: cJSON reads, copies and writes by recursion. */
#define DEEPEST_JSON 128

const cJSON* dmi_json_get(const cJSON* object, const char* name) {
    return cJSON_IsObject(object) ? cJSON_GetObjectItemCaseSensitive(object, name) : NULL;
}

const char* dmi_json_text(const cJSON* object, const char* name) {
    const cJSON* found = dmi_json_get(object, name);
    return cJSON_IsString(found) ? found->valuestring : NULL;
}

double dmi_json_number(const cJSON* object, const char* name, double otherwise) {
    const cJSON* found = dmi_json_get(object, name);
    return cJSON_IsNumber(found) ? found->valuedouble : otherwise;
}

int dmi_json_numbers(const cJSON* object, const char* name, int count, double* out) {
    const cJSON *list = dmi_json_get(object, name), *item;
    int found = 0;
    if (!cJSON_IsArray(list)) return 0;
    cJSON_ArrayForEach(item, list) found = found < count && cJSON_IsNumber(item) ? found + 1 : count + 1;
    if (found != count) return 0;
    cJSON_ArrayForEach(item, list)* out++ = item->valuedouble;
    return 1;
}

dm_result dmi_json_whole(const cJSON* object, const char* name, double otherwise, double most, const char* place,
                         dmi_gltf_problem* problem, uint64_t* out) {
    const cJSON* found = dmi_json_get(object, name);
    const double value = dmi_json_number(object, name, otherwise);
    if (found && !cJSON_IsNumber(found))
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: %s is no number", place, name);
    if (!(value >= 0) || value > most || value != floor(value))
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: %s is %.17g, it must be whole and 0 to %.0f", place,
                               name, value, most);
    *out = (uint64_t)value;
    return DM_OK;
}

/* Returns how deep the text nests. */
static int nesting(const char* text, size_t length) {
    int depth = 0, deepest = 0;
    for (size_t i = 0; i < length; i++) {
        if (text[i] == '"') {
            for (i++; i < length && text[i] != '"'; i++) i += text[i] == '\\';
        } else if (text[i] == '{' || text[i] == '[') {
            deepest = ++depth > deepest ? depth : deepest;
        } else if (text[i] == '}' || text[i] == ']') {
            depth--;
        }
    }
    return deepest;
}

/* Makes names and values UTF-8. A URI stays as it is, because files may be called so. */
static void mend_strings(cJSON* item) {
    const int is_uri = item->string && strcmp(item->string, "uri") == 0;
    if (item->string) dmi_utf8_mend(item->string);
    if (cJSON_IsString(item) && !is_uri) dmi_utf8_mend(item->valuestring);
    for (cJSON* child = item->child; child; child = child->next) mend_strings(child);
}

dm_result dmi_json_parse(const char* text, size_t length, dmi_gltf_problem* problem, cJSON** out) {
    const int deepest = nesting(text, length);
    if (deepest > DEEPEST_JSON)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "the JSON nests %d deep, %d is the most", deepest,
                               DEEPEST_JSON);
    const char* end = NULL;
    errno = 0; /* cJSON does not tell a failed malloc from a bad text */
    cJSON* root = cJSON_ParseWithLengthOpts(text, length, &end, 0);
    if (!root && errno == ENOMEM)
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "no memory for %zu bytes of JSON", length);
    while (root && end < text + length && memchr(" \t\r\n", *end, 5)) end++; /* exporters pad with NUL too */
    if (root && end == text + length) {
        if (!dmi_utf8_is_valid(text, length)) mend_strings(root);
        *out = root;
        return DM_OK;
    }
    cJSON_Delete(root);
    const size_t at = end && end >= text ? (size_t)(end - text) : 0;
    return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "the JSON can't be parsed, from byte %zu of %zu on", at, length);
}
