/* glTF in: random skins. Vertices lie where their bones blend them, and everything is sorted by bones; masks, which are
 * in the file's order, find their triangles and vertices again. */
#include <math.h>
#include <stdio.h>

#include "base/random.h"
#include "test_glb.h"
#include "test_gltf.h"

enum { VERTICES = 40, FACES = 30, JOINTS = 5, SETS = 2, SKINS = 200, TEXT = 8192 };

typedef struct skin {
    float xyz[VERTICES][3], weights[SETS][VERTICES][4];
    uint8_t joints[SETS][VERTICES][4];
    uint8_t corners[FACES][3], pad[2];
} skin;

static int below(dmi_random* random, int count) {
    const int n = (int)(dmi_random_unit(random) * (float)count);
    return n < count ? n : count - 1;
}

static void make_skin(skin* s, float moves[JOINTS][3], uint64_t seed) {
    dmi_random random = dmi_random_make(seed, 3);
    memset(s, 0, sizeof *s);
    for (int j = 0; j < JOINTS; j++)
        for (int k = 0; k < 3; k++) moves[j][k] = 4 * dmi_random_unit(&random) - 2;
    for (int v = 0; v < VERTICES; v++) {
        for (int k = 0; k < 3; k++) s->xyz[v][k] = dmi_random_unit(&random);
        for (int i = 0; i < 4 * SETS; i++) {
            s->joints[i / 4][v][i % 4] = (uint8_t)below(&random, JOINTS + 1); /* one more than there are */
            s->weights[i / 4][v][i % 4] = below(&random, 2) ? 0 : (float)(1 + below(&random, 5)) / 4;
        }
        s->joints[0][v][0] = (uint8_t)below(&random, JOINTS); /* every vertex has a bone */
        s->weights[0][v][0] = 0.75f;
    }
    for (int f = 0; f < FACES; f++)
        for (int c = 0; c < 3; c++) s->corners[f][c] = (uint8_t)below(&random, VERTICES);
}

/* The bone with the largest weight, of equal ones the first; where all of them together have the vertex. */
static int blend(const skin* s, float moves[JOINTS][3], int v, double out[3]) {
    double sum = 0, heaviest = 0;
    int best = -1;
    for (int k = 0; k < 3; k++) out[k] = 0;
    for (int i = 0; i < 4 * SETS; i++) {
        const int joint = s->joints[i / 4][v][i % 4];
        const double weight = (double)s->weights[i / 4][v][i % 4];
        if (joint >= JOINTS) continue;
        sum += weight;
        for (int k = 0; k < 3; k++) out[k] += weight * (double)(s->xyz[v][k] + moves[joint][k]);
        if (weight > heaviest) heaviest = weight, best = joint;
    }
    for (int k = 0; k < 3; k++) out[k] /= sum;
    return best;
}

static test_glb write_skin(const skin* s, float moves[JOINTS][3]) {
    char json[TEXT];
    size_t at = (size_t)snprintf(
        json, sizeof json,
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%zu}],\"bufferViews\":["
        "{\"buffer\":0,\"byteLength\":%zu},{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu},"
        "{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu},{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%d}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%d,\"type\":\"VEC3\"},",
        sizeof *s, sizeof s->xyz, offsetof(skin, weights), sizeof s->weights, offsetof(skin, joints), sizeof s->joints,
        offsetof(skin, corners), 3 * FACES, VERTICES);
    for (int set = 0; set < SETS; set++)
        at += (size_t)snprintf(
            json + at, sizeof json - at,
            "{\"bufferView\":1,\"byteOffset\":%zu,\"componentType\":5126,\"count\":%d,\"type\":\"VEC4\"},"
            "{\"bufferView\":2,\"byteOffset\":%zu,\"componentType\":5121,\"count\":%d,\"type\":\"VEC4\"},",
            set * sizeof s->weights[0], VERTICES, set * sizeof s->joints[0], VERTICES);
    at += (size_t)snprintf(json + at, sizeof json - at,
                           "{\"bufferView\":3,\"componentType\":5121,\"count\":%d,\"type\":\"SCALAR\"}],\"meshes\":[{"
                           "\"primitives\":[{\"attributes\":{\"POSITION\":0,\"WEIGHTS_0\":1,\"JOINTS_0\":2,"
                           "\"WEIGHTS_1\":3,\"JOINTS_1\":4},\"indices\":5}]}],\"skins\":[{\"joints\":[1,2,3,4,5]}],"
                           "\"nodes\":[{\"mesh\":0,\"skin\":0,\"translation\":[9,9,9]}",
                           3 * FACES);
    for (int j = 0; j < JOINTS; j++)
        at += (size_t)snprintf(json + at, sizeof json - at, ",{\"name\":\"b%d\",\"translation\":[%.9g,%.9g,%.9g]}", j,
                               (double)moves[j][0], (double)moves[j][1], (double)moves[j][2]);
    snprintf(json + at, sizeof json - at, "]}");
    return test_glb_pack(json, s, sizeof *s);
}

/* Masks are written in the file's order, and read in that of the mesh. */
static void check_mask(const dm_gltf* gltf, const int* order, int count, int32_t scope, uint64_t seed) {
    dmi_random random = dmi_random_make(seed, 4);
    char text[512] = "[";
    uint8_t values[VERTICES], ids[VERTICES];
    int32_t found = -1;
    for (int i = 0; i < count; i++) {
        values[i] = i == 0 ? 1 : i == 1 ? 0 : (uint8_t)below(&random, 2);
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%d", i ? "," : "", values[i]);
    }
    strcat(text, "]");
    assert_int_equal(dm_gltf_read_mask(gltf, text, strlen(text), NULL, ids, &found, NULL), DM_OK);
    assert_int_equal(found, scope);
    for (int i = 0; i < count; i++) assert_int_equal(ids[i], values[order[i]]);
}

static void check_skin(const skin* s, float moves[JOINTS][3], const dm_gltf* gltf, uint64_t seed) {
    int joints[VERTICES], of_faces[FACES], vertices[VERTICES], faces[FACES], count = 0;
    double want[VERTICES][3];
    dm_mesh_desc mesh;
    assert_int_equal(dm_gltf_get_mesh(gltf, &mesh), DM_OK);
    assert_int_equal(mesh.vertex_count, VERTICES);
    assert_int_equal(mesh.index_count, 3 * FACES);
    for (int v = 0; v < VERTICES; v++) joints[v] = blend(s, moves, v, want[v]);
    for (int j = 0; j < JOINTS; j++)
        for (int v = 0; v < VERTICES; v++)
            if (joints[v] == j) vertices[count++] = v;
    for (int f = 0; f < FACES; f++) { /* goes with two corners, else with the first */
        const int a = joints[s->corners[f][0]], b = joints[s->corners[f][1]], c = joints[s->corners[f][2]];
        of_faces[f] = b == c ? b : a;
    }
    count = 0;
    for (int j = 0; j < JOINTS; j++)
        for (int f = 0; f < FACES; f++)
            if (of_faces[f] == j) faces[count++] = f;
    const float* positions = mesh.positions;
    const uint32_t* indices = mesh.indices;
    for (int f = 0; f < FACES; f++)
        for (int c = 0; c < 3; c++) {
            const uint32_t at = indices[3 * f + c];
            assert_int_equal(vertices[at], s->corners[faces[f]][c]);
            for (int k = 0; k < 3; k++)
                assert_true(fabs((double)positions[3 * at + (uint32_t)k] - want[vertices[at]][k]) < 1e-5);
        }
    uint32_t entry = 0;
    for (int j = 0; j < JOINTS; j++) {
        int first = 0, own = 0;
        dm_gltf_node node;
        for (int f = 0; f < FACES; f++) first += of_faces[f] < j, own += of_faces[f] == j;
        if (own == 0) continue;
        assert_int_equal(dm_gltf_get_node(gltf, entry++, &node), DM_OK);
        assert_int_equal(node.node, j + 1);
        assert_int_equal(node.first_face, first);
        assert_int_equal(node.face_count, own);
    }
    assert_int_equal(dm_gltf_node_count(gltf), entry);
    check_mask(gltf, faces, FACES, DM_PER_FACE, seed);
    check_mask(gltf, vertices, VERTICES, DM_PER_VERTEX, seed);
}

static void everything_goes_with_its_bones(void** state) {
    (void)state;
    for (uint64_t seed = 0; seed < SKINS; seed++) {
        skin s;
        float moves[JOINTS][3];
        test_env t;
        make_skin(&s, moves, seed);
        const test_glb glb = write_skin(&s, moves);
        test_env_open(&t, TEST_NEVER);
        dm_gltf* gltf = test_gltf_open(&t, glb.data, glb.size);
        check_skin(&s, moves, gltf, seed);
        dm_gltf_close(gltf);
        test_env_close(&t);
        free(glb.data);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_goes_with_its_bones),
    };
    return cmocka_run_group_tests_name("gltf_skins", tests, NULL, NULL);
}
