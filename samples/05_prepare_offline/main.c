/* The build machine finds the joints and writes a .dmo; the game reads it and needs no weights.
 *   sample_prepare_offline FILE.glb BODY OUT.dmo [sdk/models]    every node but BODY may move
 *   sample_prepare_offline OUT.dmo                               what the game does */
#include <errno.h>
#include <stdbool.h>
#include <string.h>
#include <time.h>

#include "../common/cabinet.h"
#include "../common/output_file.h"
#include "../common/shown.h"
#include "../common/weights.h"
#include "dragmesh/ext/gltf.h"

static double now_ms(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static void print_parts(dm_context* context, dm_object object) {
    dm_object_info info = {.struct_size = sizeof info};
    dm_object_get_info(context, object, &info);
    for (uint32_t i = 0; i < info.part_count; i++) {
        dm_part_info part = {.struct_size = sizeof part};
        dm_joint joint = {.struct_size = sizeof joint};
        dm_object_get_part(context, object, i, &part);
        dm_object_get_joint(context, object, part.id, &joint);
        printf("  part %u: %s, axis (%.2f, %.2f, %.2f), %.3f to %.3f\n", (unsigned)part.id, joint_name(joint.type),
               shown((double)joint.axis.x, 2), shown((double)joint.axis.y, 2), shown((double)joint.axis.z, 2),
               shown((double)joint.lower, 3), shown((double)joint.upper, 3));
    }
}

/* Part ids a face: the nodes in order, 1 .., and 0 for the body. */
static uint8_t* number_parts(const dm_gltf* gltf, const char* body, uint64_t faces) {
    uint8_t* ids = calloc(faces, 1);
    uint8_t next = 1;
    for (uint32_t i = 0; ids != NULL && i < dm_gltf_node_count(gltf) && next < 255; i++) {
        dm_gltf_node node;
        dm_gltf_get_node(gltf, i, &node);
        if (strcmp(node.name, body) == 0) continue;
        memset(ids + node.first_face, next++, node.face_count);
    }
    return ids;
}

static int write_object(dm_context* context, dm_object object, const char* path) {
    size_t size = 0;
    dm_object_save(context, object, NULL, 0, &size);
    void* data = malloc(size);
    if (data == NULL || dm_object_save(context, object, data, size, &size) != DM_OK) return 1;
    const bool wrote = output_write(path, data, size) == 0;
    if (wrote)
        printf("%s: %zu bytes\n", path, size);
    else
        fprintf(stderr, "can't write %s: %s\n", path, strerror(errno));
    free(data);
    return !wrote;
}

/* On the build machine. */
static int prepare(dm_context* context, const char* file, const char* body, const char* out, const char* models) {
    const dm_gltf_desc source = {.struct_size = sizeof source, .log = {NULL, print_message}};
    dm_gltf* gltf;
    dm_model model;
    dm_mesh_desc mesh;
    dm_object object;
    if (load_weights(context, models, &model) != DM_OK || dm_gltf_open_file(file, &source, &gltf) != DM_OK) return 1;
    dm_gltf_get_mesh(gltf, &mesh);
    uint8_t* parts = number_parts(gltf, body, mesh.index_count / 3);
    mesh.part_ids = parts, mesh.part_id_bytes = mesh.index_count / 3;
    mesh.part_id_format = DM_UINT8, mesh.part_id_scope = DM_PER_FACE;
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = model};
    const double start = now_ms();
    const dm_result result = dm_object_prepare(context, &desc, &object);
    printf("prepared in %.1f ms\n", now_ms() - start);
    free(parts);
    dm_gltf_close(gltf);
    if (result != DM_OK) return 1;
    print_parts(context, object);
    return write_object(context, object, out);
}

/* In the game: no weights, no network, no glTF. */
static int load(dm_context* context, const char* path) {
    size_t size;
    void* bytes = read_whole(path, &size);
    dm_object object;
    const double start = now_ms();
    const dm_result result = dm_object_load(context, bytes, size, 0, &object);
    printf("loaded in %.2f ms\n", now_ms() - start);
    free(bytes);
    if (result != DM_OK) return 1;
    print_parts(context, object);
    return 0;
}

int main(int argc, char** argv) {
    const dm_context_desc host = {.struct_size = sizeof host, .log = {NULL, print_message}};
    dm_context* context;
    if (argc != 2 && argc != 4 && argc != 5) {
        fprintf(stderr, "%s FILE.glb BODY OUT.dmo [MODELS] | OUT.dmo\n", argv[0]);
        return 2;
    }
    if (dm_context_create(&host, &context) != DM_OK) return 1;
    const int status = argc == 2 ? load(context, argv[1])
                                 : prepare(context, argv[1], argv[2], argv[3], argc == 5 ? argv[4] : "sdk/models");
    dm_context_destroy(context);
    return status;
}
