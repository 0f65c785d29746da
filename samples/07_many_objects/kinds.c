/* Kinds come and go on the job threads: reading, loading and preparing are calls for any thread. */
#include <stdlib.h>

#include "../common/cabinet.h"
#include "../common/weights.h"
#include "kinds.h"

static dm_result prepare(kind* k) {
    static cabinet shape; /* of the one kind that has no file */
    const dm_mesh_desc mesh = cabinet_make(&shape);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = k->owner->model};
    dm_context* context = k->owner->context;
    dm_result result = dm_object_prepare(context, &desc, &k->object);
    if (result == DM_OK) result = dm_object_save(context, k->object, NULL, 0, &k->byte_count);
    void* bytes = result == DM_OK ? malloc(k->byte_count) : NULL; /* without it, it is prepared anew the next time */
    if (bytes != NULL) result = dm_object_save(context, k->object, bytes, k->byte_count, &k->byte_count);
    k->bytes = bytes;
    return result;
}

static dm_result load(kind* k) {
    dm_context* context = k->owner->context;
    size_t size;
    if (k->bytes != NULL) return dm_object_load(context, k->bytes, k->byte_count, 0, &k->object);
    void* bytes = read_whole(k->path, &size);
    const dm_result result = dm_object_load(context, bytes, size, 0, &k->object);
    free(bytes);
    return result;
}

static void describe(kind* k) {
    k->info = (dm_object_info){.struct_size = sizeof k->info};
    dm_object_get_info(k->owner->context, k->object, &k->info);
    k->part_count = k->info.part_count < MOST_PARTS ? k->info.part_count : MOST_PARTS;
    for (uint32_t i = 0; i < k->part_count; i++) {
        k->parts[i] = (dm_part_info){.struct_size = sizeof k->parts[i]};
        dm_object_get_part(k->owner->context, k->object, i, &k->parts[i]);
    }
}

/* A job. The last store hands the kind over to the game thread. */
static void bring(void* data) {
    kind* k = data;
    const dm_result result = k->path == NULL && k->bytes == NULL ? prepare(k) : load(k);
    if (result == DM_OK)
        describe(k);
    else
        fprintf(stderr, "%s: %s\n", k->path != NULL ? k->path : "cabinet", dm_result_string(result));
    atomic_store(&k->state, result == DM_OK ? KIND_HERE : KIND_FAILED);
}

void kind_request(kind* k) {
    stream* s = k->owner;
    if (atomic_load(&k->state) != KIND_OUT || s->coming == MOST_COMING) return;
    const bool first = k->path == NULL && k->bytes == NULL;
    atomic_store(&k->state, KIND_COMING);
    k->counted = !host_start(s->host, bring, k);
    if (k->counted) { /* too many jobs wait: it is asked for again in the next frame */
        atomic_store(&k->state, KIND_OUT);
        return;
    }
    s->coming++;
    s->counts.prepared += first;
    s->counts.loaded += !first;
}

void kinds_notice(stream* s) {
    for (uint32_t i = 0; i < s->kind_count; i++) {
        kind* k = &s->kinds[i];
        const int state = atomic_load(&k->state);
        if (k->counted || state == KIND_OUT || state == KIND_COMING) continue;
        k->counted = true;
        s->coming--;
        s->here += state == KIND_HERE;
        s->failed += state == KIND_FAILED;
    }
}

void kinds_drop_one(stream* s) {
    for (uint32_t i = 0; i < s->kind_count; i++) {
        kind* k = &s->kinds[i];
        const bool idle = atomic_load(&k->state) == KIND_HERE && k->counted && k->placed == 0;
        if (!idle || k->wanted_when == s->frame) continue;
        dm_object_destroy(s->context, k->object);
        atomic_store(&k->state, KIND_OUT);
        s->here--;
        s->counts.unloaded++;
        return;
    }
}
