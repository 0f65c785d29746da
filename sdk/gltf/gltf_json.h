/* Members of JSON objects. A missing object has no members. */
#ifndef DMI_GLTF_JSON_H
#define DMI_GLTF_JSON_H

#include <cjson/cJSON.h>

#include "gltf/gltf_problem.h"

#define DMI_GLTF_NO_INDEX (-1.0) /* an index that a file does not give */

const cJSON* dmi_json_get(const cJSON* object, const char* name);
/* Returns a text, or NULL when it is missing or no string. */
const char* dmi_json_text(const cJSON* object, const char* name);
double dmi_json_number(const cJSON* object, const char* name, double otherwise);
/* Reads `count` numbers of a list. Returns 0, and leaves `out` as it was, when the list is missing or has another
 * length. */
int dmi_json_numbers(const cJSON* object, const char* name, int count, double* out);
/* Reads a whole number from 0 to `most`, or takes `otherwise` where it is missing. Answers BAD_DATA with what `place`
 * has instead. */
dm_result dmi_json_whole(const cJSON* object, const char* name, double otherwise, double most, const char* place,
                         dmi_gltf_problem* problem, uint64_t* out);
/* Reads a text of `length` bytes, which must be one JSON value. Strings are valid UTF-8 then, except URIs. Every name
 * is in an object once; of repeated ones the last counts. */
dm_result dmi_json_parse(const char* text, size_t length, dmi_gltf_problem* problem, cJSON** out);

#endif
