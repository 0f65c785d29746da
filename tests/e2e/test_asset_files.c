/* dragmesh_generate --asset: the scene that a reader of glTF finds is the asset, node for node, and asset.json has the
 * labels of its nodes and parts. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "asset.h"
#include "dragmesh/ext/gltf.h"
#include "test_tool.h"

static const char* const kinds[] = {"cabinet", "chest", "keyboard", "car", "robot_arm", "jar"};
enum { SEEDS = 4 };

typedef struct box {
    float low[3], high[3];
} box;

static void grow(box* around, const float at[3]) {
    for (int k = 0; k < 3; ++k) {
        around->low[k] = fminf(around->low[k], at[k]);
        around->high[k] = fmaxf(around->high[k], at[k]);
    }
}

static const box nothing = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static box box_of_node(const dmg_asset* asset, uint32_t node) {
    box out = nothing;
    for (uint32_t i = 0; i < 3 * asset->object.face_count; ++i)
        if (asset->face_node[i / 3] == node) grow(&out, asset->object.positions + 3 * (size_t)asset->object.indices[i]);
    return out;
}

static const dmg_asset_node* find_node(const dmg_asset* asset, const char* name) {
    for (uint32_t i = 0; i < asset->node_count; ++i)
        if (strcmp(asset->nodes[i].name, name) == 0) return &asset->nodes[i];
    fail_msg("no node '%s'", name);
    return NULL;
}

/* Compares what the reader finds, in the scene's frame, with the asset's nodes. */
static void check_scene(const char* path, const dmg_asset* asset) {
    const dm_gltf_desc desc = {.struct_size = sizeof desc};
    dm_gltf* gltf;
    dm_mesh_desc mesh;
    uint32_t with_faces = 0;
    double origin[3];
    assert_int_equal(dm_gltf_open_file(path, &desc, &gltf), DM_OK);
    assert_int_equal(dm_gltf_get_mesh(gltf, &mesh), DM_OK);
    dm_gltf_get_origin(gltf, origin);
    for (uint32_t i = 0; i < asset->node_count; ++i) with_faces += asset->nodes[i].face_count > 0;
    assert_int_equal(dm_gltf_node_count(gltf), with_faces);
    for (uint32_t i = 0; i < with_faces; ++i) {
        dm_gltf_node node;
        box own = nothing;
        assert_int_equal(dm_gltf_get_node(gltf, i, &node), DM_OK);
        const dmg_asset_node* expected = find_node(asset, node.name);
        assert_int_equal(node.face_count, expected->face_count);
        for (uint64_t v = node.first_vertex; v < node.first_vertex + node.vertex_count; ++v) {
            float at[3];
            for (int k = 0; k < 3; ++k) at[k] = (float)((double)((const float*)mesh.positions)[3 * v + k] + origin[k]);
            grow(&own, at);
        }
        const box its = box_of_node(asset, (uint32_t)(expected - asset->nodes));
        for (int k = 0; k < 3; ++k) {
            const float slack =
                1e-5f * (fabsf(its.high[k]) + fabsf(its.low[k]) + 10.0f * (its.high[0] - its.low[0])) + 1e-5f;
            assert_true(fabsf(own.low[k] - its.low[k]) < slack && fabsf(own.high[k] - its.high[k]) < slack);
        }
    }
    dm_gltf_close(gltf);
}

static void check_labels(const char* path, const dmg_asset* asset) {
    size_t size;
    char* text = tool_read(path, &size);
    cJSON* json = cJSON_Parse(text);
    assert_non_null(json);
    const cJSON *nodes = cJSON_GetObjectItem(json, "nodes"), *parts = cJSON_GetObjectItem(json, "parts"), *at;
    cJSON_ArrayForEach(at, nodes) {
        const char* says = find_node(asset, at->string)->part == 0 ? "static" : "mover";
        assert_string_equal(at->valuestring, says);
    }
    assert_int_equal(cJSON_GetArraySize(parts), asset->object.joint_count);
    for (int i = 0; i < cJSON_GetArraySize(parts); ++i) {
        const cJSON *part = cJSON_GetArrayItem(parts, i), *parent = cJSON_GetObjectItem(part, "parent");
        const dmg_joint* joint = &asset->object.joints[i];
        cJSON_ArrayForEach(at, cJSON_GetObjectItem(part, "nodes"))
            assert_int_equal(find_node(asset, at->valuestring)->part, i + 1);
        if (joint->parent == 0)
            assert_true(cJSON_IsNull(parent));
        else
            assert_int_equal(parent->valueint, joint->parent - 1);
        if (joint->type == DM_JOINT_CONTINUOUS) continue;
        assert_true(fabs(cJSON_GetObjectItem(part, "closed")->valuedouble - (double)joint->closed) < 1e-6);
        assert_true(fabs(cJSON_GetObjectItem(part, "upper")->valuedouble - (double)joint->upper) < 1e-6);
    }
    cJSON_Delete(json);
    free(text);
}

static void files_hold_the_asset(void** state) {
    (void)state;
    char folder[TOOL_PATH], path[TOOL_PATH + 16];
    static tool_output output;
    tool_folder_make(folder);
    for (uint32_t i = 0; i < sizeof kinds / sizeof *kinds * SEEDS; ++i) {
        const char* kind = kinds[i / SEEDS];
        const uint32_t seed = i % SEEDS, messy = seed % 2;
        dmg_asset asset;
        assert_int_equal(dmg_make_asset((uint32_t)dmg_category_find(kind), seed, messy ? DMG_MESSY : 0, &asset), 0);
        tool_run(&output, "dragmesh_generate", NULL, "--asset|--category|%s|--seed|%u|-o|%s%s", kind, seed, folder,
                 messy ? "|--messy" : "");
        assert_int_equal(output.status, 0);
        snprintf(path, sizeof path, "%s/object.glb", folder);
        check_scene(path, &asset);
        snprintf(path, sizeof path, "%s/asset.json", folder);
        check_labels(path, &asset);
        dmg_asset_release(&asset);
    }
    tool_folder_remove(folder);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(files_hold_the_asset)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
