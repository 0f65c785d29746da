/* A vision-language model chooses among the joints that the library proposes: an OpenAI-compatible endpoint is shown a
 * picture of each hypothesis, through dm_object_desc.choose, while the object is prepared. Without an endpoint, or when
 * its answer is no use, the library's own answer stays.
 *   DRAGMESH_VLM_URL    such as http://localhost:8000/v1; DRAGMESH_VLM_KEY, DRAGMESH_VLM_MODEL
 *   sample_vlm_intent [sdk/models [FOLDER]]      FOLDER: the pictures are written there too */
#include <errno.h>
#include <stdbool.h>
#include <string.h>

#include "../common/cabinet.h"
#include "../common/output_file.h"
#include "../common/weights.h"
#include "endpoint.h"
#include "pictures.h"

typedef struct adviser {
    endpoint endpoint;
    studio studio;
    const char* folder; /* NULL: pictures are not written */
} adviser;

static void write_picture(const char* folder, uint32_t part, uint32_t number, const void* png, size_t size) {
    char path[1024];
    snprintf(path, sizeof path, "%s/part%u_%u.png", folder, (unsigned)part, (unsigned)number);
    if (output_write(path, png, size) != 0) fprintf(stderr, "can't write %s: %s\n", path, strerror(errno));
}

/* The hypothesis in words, and its picture. Numbers that people read begin at 1. */
static void add_hypothesis(const adviser* a, uint32_t part, uint32_t number, const dm_hypothesis* h, cJSON* content) {
    char words[256];
    size_t size;
    const dm_joint* j = h->joint;
    snprintf(words, sizeof words, "Picture %u: %s, axis (%.2f, %.2f, %.2f), from %.2f to %.2f %s, probability %.2f.",
             (unsigned)number, joint_name(j->type), (double)j->axis.x, (double)j->axis.y, (double)j->axis.z,
             (double)h->ends[0].value, (double)h->ends[1].value, j->type == DM_JOINT_PRISMATIC ? "m" : "rad",
             (double)j->joint_confidence);
    add_text(content, words);
    void* png = draw_hypothesis(&a->studio, part, h, &size);
    char* url = data_url(png, size);
    if (url != NULL) add_picture(content, url);
    if (a->folder != NULL) write_picture(a->folder, part, number, png, size);
    free(url);
    free(png);
}

static char* make_question(const adviser* a, const dm_choice* choice) {
    char words[512];
    cJSON *content, *question = question_new(&a->endpoint, &content);
    snprintf(
        words, sizeof words,
        "Part number %u of an object, orange in the pictures, can move. Each picture shows one way in which it may "
        "do so: at one end of its range, at rest, at the other end. Which one is how such a thing really moves? "
        "Answer with the number of the picture alone, or 0 if none is right.",
        (unsigned)choice->part->id);
    add_text(content, words);
    for (uint32_t i = 0; i < choice->count; i++)
        add_hypothesis(a, choice->part->id, i + 1, choice->hypotheses[i], content);
    char* text = cJSON_PrintUnformatted(question);
    cJSON_Delete(question);
    return text;
}

/* The library asks while it prepares. */
static int32_t DM_CALL ask(void* user, const dm_choice* choice) {
    const adviser* a = user;
    reply* answer = calloc(1, sizeof *answer);
    char* question = make_question(a, choice);
    long number = 0;
    if (answer != NULL && question != NULL && post(&a->endpoint, question, answer) == 0) number = first_number(answer);
    free(question);
    free(answer);
    const bool picked = number >= 1 && number <= (long)choice->count;
    if (picked)
        printf("part %u: the model picks %ld of %u\n", (unsigned)choice->part->id, number, (unsigned)choice->count);
    else
        printf("part %u: the model picks none\n", (unsigned)choice->part->id);
    return picked ? (int32_t)number - 1 : DM_CHOICE_KEEP;
}

static const char* setting(const char* name, const char* otherwise) {
    const char* value = getenv(name);
    return value != NULL && value[0] ? value : otherwise;
}

static void print_joints(dm_context* context, dm_object object) {
    for (uint32_t part = CABINET_DOOR; part <= CABINET_DRAWER; part++) {
        dm_joint joint = {.struct_size = sizeof joint};
        dm_object_get_joint(context, object, part, &joint);
        printf("part %u moves: %s, axis (%.2f, %.2f, %.2f), %s\n", (unsigned)part, joint_name(joint.type),
               (double)joint.axis.x, (double)joint.axis.y, (double)joint.axis.z,
               joint.source == DM_JOINT_CHOSEN ? "chosen" : "as the library found it");
    }
}

int main(int argc, char** argv) {
    static cabinet shape;
    adviser a = {.endpoint = {.url = setting("DRAGMESH_VLM_URL", NULL),
                              .key = setting("DRAGMESH_VLM_KEY", ""),
                              .model = setting("DRAGMESH_VLM_MODEL", "default")},
                 .folder = argc > 2 ? argv[2] : NULL};
    const dm_context_desc host = {.struct_size = sizeof host, .log = {NULL, print_message}};
    const dm_mesh_desc mesh = cabinet_make(&shape);
    dm_context* context;
    dm_model model;
    dm_object object;
    curl_global_init(CURL_GLOBAL_DEFAULT);
    if (dm_context_create(&host, &context) != DM_OK || studio_open(&host, &mesh, &a.studio) != DM_OK) return 1;
    if (load_weights(context, argc > 1 ? argv[1] : "sdk/models", &model) != DM_OK) return 1;
    if (a.endpoint.url == NULL) printf("DRAGMESH_VLM_URL is not set: the library's answer stays\n");
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .mesh = &mesh,
                                 .model = model,
                                 .choose = a.endpoint.url != NULL ? ask : NULL,
                                 .choose_user = &a};
    if (dm_object_prepare(context, &desc, &object) != DM_OK) return 1;
    print_joints(context, object);
    dm_context_destroy(context);
    dm_context_destroy(a.studio.context);
    curl_global_cleanup();
    return 0;
}
