/* Every update of the scripted player's drags as lines of JSON, for others to score. */
#include <stdlib.h>

#include "dragbot.h"
#include "json.h"

static void print_vector(output_file* out, const char* name, dm_vec3 v) {
    output_print(out, "\"%s\": [%.9g, %.9g, %.9g]", name, (double)v.x, (double)v.y, (double)v.z);
}

static void print_frame(output_file* out, const bot_frame* frame) {
    output_print(out, "\"pose\": [");
    for (int k = 0; k < 8; k++)
        output_print(out, k ? ", %.9g" : "%.9g", (double)(k < 4 ? frame->pose.real[k] : frame->pose.dual[k - 4]));
    output_print(out, "], \"value\": %.9g, \"joint\": {\"type\": %d, ", (double)frame->value, frame->joint.type);
    print_vector(out, "axis", frame->joint.axis);
    output_print(out, ", ");
    print_vector(out, "origin", frame->joint.origin);
    output_print(out, "}, \"ray\": {");
    print_vector(out, "origin", frame->ray.origin);
    output_print(out, ", ");
    print_vector(out, "direction", frame->ray.direction);
    output_print(out, "}}\n");
}

void bot_poses_write(const bot_case* played, const bot_frame* frames, int count) {
    cJSON* id = cJSON_CreateString(played->id);
    char* quoted = cJSON_PrintUnformatted(id);
    dm_gltf_mend_text(quoted);
    for (int i = 0; i < count; i++) {
        output_print(played->poses, "{\"id\": %s, \"given\": %s, \"frame\": %d, ", quoted,
                     played->given ? "true" : "false", i);
        print_frame(played->poses, &frames[i]);
    }
    cJSON_free(quoted);
    cJSON_Delete(id);
}
