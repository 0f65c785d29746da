/* Writing JSON with cJSON: numbers with as many digits as they have, null for those that are none. */
#ifndef CLI_JSON_H
#define CLI_JSON_H

#include <cjson/cJSON.h>

#include "dragmesh/dragmesh.h"

/* digits: significant ones. */
void json_add_number(cJSON* object, const char* name, double number, int digits);
void json_add_vector(cJSON* object, const char* name, dm_vec3 vector);
/* The sum of `point` and `origin`. */
void json_add_point(cJSON* object, const char* name, dm_vec3 point, const double origin[3]);
/* Valid UTF-8 to standard output, without a line's end; releases the object. */
void json_print_piece(cJSON* object);
/* One line of valid UTF-8 to standard output, flushed; releases the object. */
void json_print_line(cJSON* object);
/* Indented, to standard output; releases the object. */
void json_print(cJSON* object);

#endif
