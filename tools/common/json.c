/* Writing JSON with cJSON: numbers with as many digits as they have, null for those that are none. */
#include "json.h"

#include <math.h>
#include <stdio.h>

#include "dragmesh/ext/gltf.h"

static cJSON* number_item(double number, int digits) {
    char text[40];
    if (!isfinite(number)) return cJSON_CreateNull();
    snprintf(text, sizeof text, "%.*g", digits, number == 0 ? 0.0 : number);
    return cJSON_CreateRaw(text);
}

void json_add_number(cJSON* object, const char* name, double number, int digits) {
    cJSON_AddItemToObject(object, name, number_item(number, digits));
}

void json_add_vector(cJSON* object, const char* name, dm_vec3 vector) {
    cJSON* list = cJSON_AddArrayToObject(object, name);
    const float numbers[3] = {vector.x, vector.y, vector.z};
    for (int i = 0; i < 3; i++) cJSON_AddItemToArray(list, number_item((double)numbers[i], 9));
}

/* 9 digits tell floats apart; what was added to a large origin may need all that a double has. */
void json_add_point(cJSON* object, const char* name, dm_vec3 point, const double origin[3]) {
    cJSON* list = cJSON_AddArrayToObject(object, name);
    const float numbers[3] = {point.x, point.y, point.z};
    for (int i = 0; i < 3; i++)
        cJSON_AddItemToArray(list, number_item((double)numbers[i] + origin[i], origin[i] != 0 ? 15 : 9));
}

/* Ids, paths and names come back as they came in, which may be no UTF-8. */
static void print_and_delete(cJSON* object, char* text) {
    dm_gltf_mend_text(text);
    if (text != NULL) fputs(text, stdout);
    cJSON_free(text);
    cJSON_Delete(object);
}

static void end_line(void) {
    putchar('\n');
    fflush(stdout);
}

void json_print_piece(cJSON* object) {
    print_and_delete(object, cJSON_PrintUnformatted(object));
}

void json_print_line(cJSON* object) {
    json_print_piece(object);
    end_line();
}

void json_print(cJSON* object) {
    print_and_delete(object, cJSON_Print(object));
    end_line();
}
