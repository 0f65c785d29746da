/* A vision-language model as the source of intent: an OpenAI-compatible endpoint is asked how each part moves, through
 * dm_object_desc.intent. Without an endpoint, or when its answer is no use, geometry decides as always.
 *   DRAGMESH_VLM_URL    such as http://localhost:8000/v1; DRAGMESH_VLM_KEY, DRAGMESH_VLM_MODEL
 *   sample_vlm_intent [sdk/models [PICTURE.png]] */
#include <string.h>

#include <cjson/cJSON.h>
#include <curl/curl.h>

#include "../common/cabinet.h"
#include "../common/weights.h"

typedef struct endpoint {
    const char *url, *key, *model;
    char* picture; /* a data: URL of the object's picture; NULL = words alone */
} endpoint;

typedef struct reply {
    char text[65536];
    size_t size;
} reply;

/* ---- a picture as base64 ---- */

static char* data_url(const char* path) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    static const char head[] = "data:image/png;base64,";
    size_t size;
    unsigned char* bytes = read_whole(path, &size);
    char *out = bytes != NULL ? malloc(sizeof head + (size + 2) / 3 * 4) : NULL, *to = out;
    if (out == NULL) return NULL;
    memcpy(out, head, sizeof head);
    to += sizeof head - 1;
    for (size_t i = 0; i < size; i += 3) {
        const unsigned b1 = i + 1 < size ? bytes[i + 1] : 0, b2 = i + 2 < size ? bytes[i + 2] : 0;
        const unsigned three = (unsigned)bytes[i] << 16 | b1 << 8 | b2;
        for (int k = 0; k < 4; k++) *to++ = digits[three >> (18 - 6 * k) & 63];
    }
    if (size % 3) to[-1] = '=';
    if (size % 3 == 1) to[-2] = '=';
    *to = 0;
    free(bytes);
    return out;
}

/* ---- asking ---- */

static char* make_question(const endpoint* endpoint, uint32_t part, dm_vec3 low, dm_vec3 high) {
    char words[1024];
    snprintf(words, sizeof words,
             "An object has a movable part number %u. Its bounding box, in metres, y up, the front facing +z: from "
             "(%.3f, %.3f, %.3f) to (%.3f, %.3f, %.3f). How does it move? Answer with one word: revolute (it turns "
             "about a hinge), prismatic (it slides), screw, continuous (it turns without end), or unknown.",
             (unsigned)part, (double)low.x, (double)low.y, (double)low.z, (double)high.x, (double)high.y,
             (double)high.z);
    cJSON *question = cJSON_CreateObject(), *content = cJSON_CreateArray();
    cJSON_AddStringToObject(question, "model", endpoint->model);
    cJSON_AddNumberToObject(question, "temperature", 0);
    cJSON* message = cJSON_CreateObject();
    cJSON_AddStringToObject(message, "role", "user");
    cJSON_AddItemToObject(message, "content", content);
    cJSON_AddItemToArray(cJSON_AddArrayToObject(question, "messages"), message);
    cJSON* text = cJSON_CreateObject();
    cJSON_AddStringToObject(text, "type", "text");
    cJSON_AddStringToObject(text, "text", words);
    cJSON_AddItemToArray(content, text);
    if (endpoint->picture != NULL) {
        cJSON* image = cJSON_CreateObject();
        cJSON_AddStringToObject(image, "type", "image_url");
        cJSON_AddStringToObject(cJSON_AddObjectToObject(image, "image_url"), "url", endpoint->picture);
        cJSON_AddItemToArray(content, image);
    }
    char* out = cJSON_PrintUnformatted(question);
    cJSON_Delete(question);
    return out;
}

static size_t keep(char* data, size_t size, size_t count, void* user) {
    reply* r = user;
    const size_t more = size * count;
    if (r->size + more >= sizeof r->text) return 0; /* too long to be an answer: curl gives up */
    memcpy(r->text + r->size, data, more);
    r->size += more;
    return more;
}

static int post(const endpoint* endpoint, const char* question, reply* out) {
    char url[1024], key[512];
    CURL* curl = curl_easy_init();
    if (curl == NULL) return -1;
    snprintf(url, sizeof url, "%s/chat/completions", endpoint->url);
    snprintf(key, sizeof key, "Authorization: Bearer %s", endpoint->key);
    struct curl_slist* headers = curl_slist_append(NULL, "Content-Type: application/json");
    if (endpoint->key[0]) headers = curl_slist_append(headers, key);
    curl_easy_setopt(curl, CURLOPT_URL, url);
    curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers);
    curl_easy_setopt(curl, CURLOPT_POSTFIELDS, question);
    curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, keep);
    curl_easy_setopt(curl, CURLOPT_WRITEDATA, out);
    curl_easy_setopt(curl, CURLOPT_TIMEOUT, 20L);
    curl_easy_setopt(curl, CURLOPT_FAILONERROR, 1L);
    const CURLcode code = curl_easy_perform(curl);
    if (code != CURLE_OK) fprintf(stderr, "%s: %s; geometry decides\n", url, curl_easy_strerror(code));
    curl_slist_free_all(headers);
    curl_easy_cleanup(curl);
    return code == CURLE_OK ? 0 : -1;
}

/* choices[0].message.content, whatever else it says, names one kind of joint: the first that appears. */
static int32_t read_answer(const reply* r) {
    cJSON* json = cJSON_ParseWithLength(r->text, r->size);
    const cJSON* choice = cJSON_GetArrayItem(cJSON_GetObjectItem(json, "choices"), 0);
    const char* content = cJSON_GetStringValue(cJSON_GetObjectItem(cJSON_GetObjectItem(choice, "message"), "content"));
    int32_t answer = DM_JOINT_UNKNOWN;
    const char* first = NULL;
    for (int32_t type = DM_JOINT_REVOLUTE; content != NULL && type <= DM_JOINT_CONTINUOUS; type++) {
        const char* at = strstr(content, joint_name(type));
        if (at == NULL || (first != NULL && at >= first)) continue;
        first = at;
        answer = type;
    }
    cJSON_Delete(json);
    return answer;
}

/* The library asks while it prepares; DM_JOINT_UNKNOWN leaves the question to it. */
static int32_t DM_CALL ask(void* user, uint32_t part, dm_vec3 low, dm_vec3 high) {
    const endpoint* endpoint = user;
    reply* answer = calloc(1, sizeof *answer);
    char* question = make_question(endpoint, part, low, high);
    int32_t type = DM_JOINT_UNKNOWN;
    if (answer != NULL && question != NULL && post(endpoint, question, answer) == 0) type = read_answer(answer);
    printf("part %u: the model says %s\n", (unsigned)part, joint_name(type));
    free(question);
    free(answer);
    return type;
}

static const char* setting(const char* name, const char* otherwise) {
    const char* value = getenv(name);
    return value != NULL && value[0] ? value : otherwise;
}

int main(int argc, char** argv) {
    static cabinet shape;
    endpoint endpoint = {.url = setting("DRAGMESH_VLM_URL", NULL),
                         .key = setting("DRAGMESH_VLM_KEY", ""),
                         .model = setting("DRAGMESH_VLM_MODEL", "default")};
    const dm_context_desc host = {.struct_size = sizeof host, .log = {NULL, print_message}};
    dm_context* context;
    dm_model model;
    dm_object object;
    curl_global_init(CURL_GLOBAL_DEFAULT);
    if (dm_context_create(&host, &context) != DM_OK) return 1;
    if (load_weights(context, argc > 1 ? argv[1] : "sdk/models", &model) != DM_OK) return 1;
    if (argc > 2) endpoint.picture = data_url(argv[2]);
    if (endpoint.url == NULL) printf("DRAGMESH_VLM_URL is not set: geometry decides\n");
    const dm_mesh_desc mesh = cabinet_make(&shape);
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .mesh = &mesh,
                                 .model = model,
                                 .intent = endpoint.url != NULL ? ask : NULL,
                                 .intent_user = &endpoint};
    if (dm_object_prepare(context, &desc, &object) != DM_OK) return 1;
    for (uint32_t part = CABINET_DOOR; part <= CABINET_DRAWER; part++) {
        dm_joint joint = {.struct_size = sizeof joint};
        dm_object_get_joint(context, object, part, &joint);
        printf("part %u moves: %s, axis (%.2f, %.2f, %.2f), confidence %.2f\n", (unsigned)part, joint_name(joint.type),
               (double)joint.axis.x, (double)joint.axis.y, (double)joint.axis.z, (double)joint.type_confidence);
    }
    free(endpoint.picture);
    dm_context_destroy(context);
    curl_global_cleanup();
    return 0;
}
