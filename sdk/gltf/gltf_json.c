/* Reads JSON by cJSON, whose memory comes from malloc. cJSON's hooks belong to the whole process, so they stay as they
 * are. A text of n bytes takes at most 40 n bytes: a value of one byte and a comma become 64 bytes and 16 of the heap.
 * It takes 4 n more while it is read: a member of five bytes has 16 bytes in the list of names. */
#include "gltf/gltf_json.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/utf8.h"

/* Deepest nesting that is read. cJSON reads, copies and writes by recursion, so deeper JSON could overflow the
 * stack. */
#define DEEPEST_JSON 128

const cJSON* dmi_json_get(const cJSON* object, const char* name) {
    return cJSON_IsObject(object) ? cJSON_GetObjectItemCaseSensitive(object, name) : NULL;
}

const char* dmi_json_text(const cJSON* object, const char* name) {
    const cJSON* found = dmi_json_get(object, name);
    return found && cJSON_IsString(found) ? found->valuestring : NULL;
}

double dmi_json_number(const cJSON* object, const char* name, double otherwise) {
    const cJSON* found = dmi_json_get(object, name);
    return found && cJSON_IsNumber(found) ? found->valuedouble : otherwise;
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

/* Returns the end of the string that begins at the quote `at`: the place of its last quote, or `length`. */
static size_t end_of_string(const char* text, size_t length, size_t at) {
    for (at++; at < length && text[at] != '"'; at++) at += text[at] == '\\';
    return at < length ? at : length;
}

/* Returns whether a string has a zero byte, raw or as an escape. As a text in C, the string would end there. */
static int has_zero(const char* string, size_t length) {
    for (size_t i = 0; i < length; i++) {
        if (string[i] == 0 || (length - i >= 6 && memcmp(string + i, "\\u0000", 6) == 0)) return 1;
        i += string[i] == '\\';
    }
    return 0;
}

/* Returns whether the value of a member "uri" has a zero byte. */
static int has_zero_in_uri(const char* text, size_t length) {
    static const char name[] = "\"uri\"";
    int is_uri = 0;
    for (size_t at = 0; at < length; at++) {
        if (text[at] != '"') continue;
        const size_t end = end_of_string(text, length, at);
        if (is_uri && has_zero(text + at, end - at)) return 1;
        is_uri = end < length && end - at + 1 == sizeof name - 1 && memcmp(text + at, name, sizeof name - 1) == 0;
        at = end;
    }
    return 0;
}

/* Makes names and values valid UTF-8. A URI stays as it is, because a file may have such a name. */
static void mend_strings(cJSON* item) {
    const int is_uri = item->string && strcmp(item->string, "uri") == 0;
    if (item->string) dmi_utf8_mend(item->string);
    if (cJSON_IsString(item) && !is_uri) dmi_utf8_mend(item->valuestring);
    for (cJSON* child = item->child; child; child = child->next) mend_strings(child);
}

typedef struct member {
    cJSON* item;
    uint32_t place; /* position in its object */
} member;

static int by_name_and_place(const void* a, const void* b) {
    const member *x = a, *y = b;
    const int names = strcmp(x->item->string, y->item->string);
    return names != 0 ? names : (x->place > y->place) - (x->place < y->place);
}

static dm_result keep_last_of_each_name(cJSON* object, dmi_gltf_problem* problem) {
    const size_t count = (size_t)cJSON_GetArraySize(object);
    if (count < 2) return DM_OK;
    member* members = malloc(count * sizeof *members);
    if (!members)
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "no memory for the names of %zu members", count);
    uint32_t place = 0;
    for (cJSON* item = object->child; item; item = item->next) {
        members[place] = (member){item, place};
        place++;
    }
    qsort(members, count, sizeof *members, by_name_and_place);
    for (size_t i = 0; i + 1 < count; i++)
        if (strcmp(members[i].item->string, members[i + 1].item->string) == 0)
            cJSON_Delete(cJSON_DetachItemViaPointer(object, members[i].item));
    free(members);
    return DM_OK;
}

/* Drops members whose name comes again in the same object. glTF forbids such names (2.0, section 2.7). The last one
 * counts, as in JavaScript, so that every name is written once. */
static dm_result drop_repeated_names(cJSON* item, dmi_gltf_problem* problem) {
    dm_result result = cJSON_IsObject(item) ? keep_last_of_each_name(item, problem) : DM_OK;
    for (cJSON* child = item->child; result == DM_OK && child; child = child->next)
        result = drop_repeated_names(child, problem);
    return result;
}

dm_result dmi_json_parse(const char* text, size_t length, dmi_gltf_problem* problem, cJSON** out) {
    const int deepest = nesting(text, length);
    if (deepest > DEEPEST_JSON)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "the JSON nests %d deep, %d is the most", deepest,
                               DEEPEST_JSON);
    if (has_zero_in_uri(text, length))
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "a URI holds a zero byte, as no file's name does");
    const char* end = NULL;
    errno = 0; /* cJSON does not tell a failed malloc from a bad text */
    cJSON* root = cJSON_ParseWithLengthOpts(text, length, &end, 0);
    if (!root && errno == ENOMEM)
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "no memory for %zu bytes of JSON", length);
    while (root && end < text + length && memchr(" \t\r\n", *end, 5)) end++; /* exporters pad with NUL too */
    if (root && end == text + length) {
        if (!dmi_utf8_is_valid(text, length)) mend_strings(root);
        const dm_result result = drop_repeated_names(root, problem);
        if (result == DM_OK)
            *out = root;
        else
            cJSON_Delete(root);
        return result;
    }
    cJSON_Delete(root);
    const size_t at = end && end >= text ? (size_t)(end - text) : 0;
    return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "the JSON can't be parsed, from byte %zu of %zu on", at, length);
}
