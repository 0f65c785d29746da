/* An OpenAI-compatible endpoint: a question of texts and pictures, and the text that it answers. */
#ifndef SAMPLE_ENDPOINT_H
#define SAMPLE_ENDPOINT_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cjson/cJSON.h>
#include <curl/curl.h>

typedef struct endpoint {
    const char *url, *key, *model;
} endpoint;

typedef struct reply {
    char text[65536];
    size_t size;
} reply;

/* ---- the question ---- */

static inline cJSON* question_new(const endpoint* endpoint, cJSON** out_content) {
    cJSON *question = cJSON_CreateObject(), *message = cJSON_CreateObject();
    cJSON_AddStringToObject(question, "model", endpoint->model);
    cJSON_AddNumberToObject(question, "temperature", 0);
    cJSON_AddStringToObject(message, "role", "user");
    *out_content = cJSON_AddArrayToObject(message, "content");
    cJSON_AddItemToArray(cJSON_AddArrayToObject(question, "messages"), message);
    return question;
}

static inline void add_text(cJSON* content, const char* words) {
    cJSON* text = cJSON_CreateObject();
    cJSON_AddStringToObject(text, "type", "text");
    cJSON_AddStringToObject(text, "text", words);
    cJSON_AddItemToArray(content, text);
}

static inline void add_picture(cJSON* content, const char* url) {
    cJSON* image = cJSON_CreateObject();
    cJSON_AddStringToObject(image, "type", "image_url");
    cJSON_AddStringToObject(cJSON_AddObjectToObject(image, "image_url"), "url", url);
    cJSON_AddItemToArray(content, image);
}

/* ---- asking ---- */

static inline size_t keep(char* data, size_t size, size_t count, void* user) {
    reply* r = user;
    const size_t more = size * count;
    if (r->size + more >= sizeof r->text) return 0; /* too long to be an answer: curl gives up */
    memcpy(r->text + r->size, data, more);
    r->size += more;
    return more;
}

static inline int post(const endpoint* endpoint, const char* question, reply* out) {
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
    curl_easy_setopt(curl, CURLOPT_TIMEOUT, 60L);
    curl_easy_setopt(curl, CURLOPT_FAILONERROR, 1L);
    const CURLcode code = curl_easy_perform(curl);
    if (code != CURLE_OK) fprintf(stderr, "%s: %s; the library's answer stays\n", url, curl_easy_strerror(code));
    curl_slist_free_all(headers);
    curl_easy_cleanup(curl);
    return code == CURLE_OK ? 0 : -1;
}

/* The first number in choices[0].message.content, whatever else it says; 0 when there is none. */
static inline long first_number(const reply* r) {
    cJSON* json = cJSON_ParseWithLength(r->text, r->size);
    const cJSON* choice = cJSON_GetArrayItem(cJSON_GetObjectItem(json, "choices"), 0);
    const char* content = cJSON_GetStringValue(cJSON_GetObjectItem(cJSON_GetObjectItem(choice, "message"), "content"));
    const char* digit = content != NULL ? strpbrk(content, "0123456789") : NULL;
    const long number = digit != NULL ? strtol(digit, NULL, 10) : 0;
    cJSON_Delete(json);
    return number;
}

#endif
