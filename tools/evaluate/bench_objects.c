/* Times the preparation of real objects, without picking: every node but the largest is a part. */
#include "bench_objects.h"

#include <stdio.h>
#include <stdlib.h>

#include "dataset.h"
#include "json.h"
#include "nodes.h"
#include "timing.h"

enum { MAX_PARTS = 8, MAX_TRIANGLES = 100000, ROUNDS = 3 }; /* by hand, for the time of a run */

typedef struct costs {
    double *first, *further; /* ms, one an object */
    size_t first_count, further_count;
    int skipped;
} costs;

/* Returns the thread's own processor time, which other programs on the machine hardly affect. */
static double thread_ms(void) {
    return 1e-6 * timing_now_ns(CLOCK_THREAD_CPUTIME_ID);
}

/* Lists the nodes with triangles that are not the body as parts. */
static uint32_t list_parts(const session* session, uint32_t body, dm_part_desc out[MAX_PARTS]) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < dm_gltf_node_count(session->gltf) && count < MAX_PARTS; i++) {
        dm_gltf_node node;
        dm_gltf_get_node(session->gltf, i, &node);
        if (node_part_id(session, i, body) == i + 1 && node.face_count > 0)
            out[count++] = (dm_part_desc){.struct_size = sizeof out[0], .id = i + 1};
    }
    return count;
}

/* Returns the least time of some rounds, ms; negative on failure. */
static double time_prepare(session* session, const dm_mesh_desc* mesh, const dm_part_desc* parts, uint32_t count) {
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .flags = DM_PREPARE_WITHOUT_PICKING,
                                 .mesh = mesh,
                                 .parts = parts,
                                 .part_count = count,
                                 .model = session->model};
    double least = -1;
    for (int i = 0; i < ROUNDS; i++) {
        dm_object object;
        const double start = thread_ms();
        const dm_result result = dm_object_prepare(session->context, &desc, &object);
        const double taken = thread_ms() - start;
        if (result != DM_OK) return -1;
        dm_object_destroy(session->context, object);
        if (least < 0 || taken < least) least = taken;
    }
    return least;
}

static void measure(session* session, costs* out) {
    const uint32_t body = largest_node(session);
    uint16_t* ids = node_part_ids(session, body);
    dm_part_desc parts[MAX_PARTS];
    dm_mesh_desc mesh = session->mesh;
    mesh.part_ids = ids;
    mesh.part_id_bytes = mesh.index_count / 3 * sizeof *ids;
    mesh.part_id_format = DM_UINT16;
    mesh.part_id_scope = DM_PER_FACE;
    const uint32_t count = list_parts(session, body, parts);
    const double first = count > 0 ? time_prepare(session, &mesh, parts, 1) : -1;
    const double all = count > 1 && first >= 0 ? time_prepare(session, &mesh, parts, count) : -1;
    if (first >= 0) out->first[out->first_count++] = first;
    if (all >= 0) out->further[out->further_count++] = (all - first) / (count - 1);
    out->skipped += first < 0 || (count > 1 && all < 0);
    free(ids);
}

static double quantile(const double* sorted, size_t count, double share) {
    return count ? sorted[(size_t)(share * (double)(count - 1))] : 0;
}

static void show(costs* c, int as_json) {
    timing_sort(c->first, c->first_count);
    timing_sort(c->further, c->further_count);
    const double first[2] = {quantile(c->first, c->first_count, 0.5), quantile(c->first, c->first_count, 0.9)};
    const double further[2] = {quantile(c->further, c->further_count, 0.5),
                               quantile(c->further, c->further_count, 0.9)};
    if (!as_json) {
        printf("%zu objects, first part    median %6.2f ms  p90 %6.2f ms\n", c->first_count, first[0], first[1]);
        printf("%zu objects, further parts median %6.2f ms  p90 %6.2f ms each\n", c->further_count, further[0],
               further[1]);
        printf("%d left out\n", c->skipped);
        return;
    }
    cJSON* out = cJSON_CreateObject();
    cJSON_AddNumberToObject(out, "objects", (double)c->first_count);
    json_add_number(out, "first_part_median_ms", first[0], 4);
    json_add_number(out, "first_part_p90_ms", first[1], 4);
    json_add_number(out, "further_part_median_ms", further[0], 4);
    json_add_number(out, "further_part_p90_ms", further[1], 4);
    cJSON_AddNumberToObject(out, "left_out", c->skipped);
    json_print(out);
}

int bench_objects(session* session, const char* folder, int as_json) {
    name_list names = dataset_list(folder, "joints.json");
    if (names.count == 0) {
        fprintf(stderr, "dragmesh bench: '%s' has no folders with a joints.json\n", folder);
        return CLI_USAGE;
    }
    costs c = {.first = cli_alloc(names.count * sizeof *c.first),
               .further = cli_alloc(names.count * sizeof *c.further)};
    for (unsigned i = 0; i < names.count; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s/object.glb", folder, names.names[i]);
        if (session_use_file(session, path) != DM_OK || session->mesh.index_count / 3 > MAX_TRIANGLES)
            c.skipped++;
        else
            measure(session, &c);
    }
    show(&c, as_json);
    free(c.first);
    free(c.further);
    name_list_free(&names);
    return CLI_OK;
}
