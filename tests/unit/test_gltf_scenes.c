/* glTF in: random scenes, each triangle where a plain walk up from its node puts it. */
#include <math.h>
#include <stdio.h>

#include "base/random.h"
#include "test_glb.h"
#include "test_gltf.h"

enum { TEXT = 1 << 15, ACCESSORS = 4, MESHES = 4, NODES = 9, PRIMITIVES = 3, FACES = 7, MOST = 400, SCENES = 300 };

typedef struct primitive {
    int accessor, faces;
    uint16_t corners[FACES * 3];
} primitive;

typedef struct scene {
    int counts[ACCESSORS];
    float xyz[ACCESSORS][MOST][3];
    int primitive_counts[MESHES];
    primitive primitives[MESHES][PRIMITIVES];
    struct {
        int parent, mesh; /* -1: none */
        double move[3], turn[4], scale[3];
    } nodes[NODES];
} scene;

static int below(dmi_random* random, int count) {
    const int n = (int)(dmi_random_unit(random) * (float)count);
    return n < count ? n : count - 1;
}

static double number(dmi_random* random) {
    return (double)dmi_random_unit(random) * 4 - 2;
}

static void make_scene(scene* s, uint64_t seed) {
    dmi_random random = dmi_random_make(seed, 1);
    for (int a = 0; a < ACCESSORS; a++) {
        s->counts[a] = a % 2 ? MOST - below(&random, 70) : 3 + below(&random, 9);
        for (int v = 0; v < s->counts[a]; v++)
            for (int k = 0; k < 3; k++) s->xyz[a][v][k] = (float)number(&random);
    }
    for (int m = 0; m < MESHES; m++) {
        s->primitive_counts[m] = 1 + below(&random, PRIMITIVES);
        for (int p = 0; p < s->primitive_counts[m]; p++) {
            primitive* made = &s->primitives[m][p];
            made->accessor = below(&random, ACCESSORS);
            made->faces = 1 + below(&random, FACES);
            for (int c = 0; c < 3 * made->faces; c++)
                made->corners[c] = (uint16_t)below(&random, s->counts[made->accessor]);
        }
    }
    for (int n = 0; n < NODES; n++) {
        double length = 0;
        s->nodes[n].parent = below(&random, n + 1) - 1;
        s->nodes[n].mesh = n == 0 ? 0 : below(&random, MESHES + 1) - 1;
        for (int k = 0; k < 4; k++) {
            s->nodes[n].turn[k] = number(&random);
            length += s->nodes[n].turn[k] * s->nodes[n].turn[k];
        }
        for (int k = 0; k < 4; k++) s->nodes[n].turn[k] /= sqrt(length);
        for (int k = 0; k < 3; k++) {
            const double size = 0.7 + fabs(number(&random)) / 4;
            s->nodes[n].move[k] = number(&random);
            s->nodes[n].scale[k] = below(&random, 3) ? size : -size;
        }
    }
}

static size_t add(char* text, size_t length, const char* more) {
    const size_t size = strlen(more);
    assert_true(length + size < TEXT);
    memcpy(text + length, more, size + 1);
    return length + size;
}

/* Every accessor in a view of its own, then the indices of every primitive. */
static test_glb write_scene(const scene* s) {
    static uint8_t bytes[1 << 16];
    static char json[TEXT], views[TEXT], accessors[TEXT];
    char line[512];
    size_t size = 0, at = 0, a_length = 0, v_length = 0;
    int index = ACCESSORS;
    views[0] = accessors[0] = 0;
    for (int a = 0; a < ACCESSORS; a++) {
        const size_t own = 12 * (size_t)s->counts[a];
        memcpy(bytes + size, s->xyz[a], own);
        snprintf(line, sizeof line, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}", a ? "," : "", size, own);
        v_length = add(views, v_length, line);
        snprintf(line, sizeof line, "%s{\"bufferView\":%d,\"componentType\":5126,\"count\":%d,\"type\":\"VEC3\"}",
                 a ? "," : "", a, s->counts[a]);
        a_length = add(accessors, a_length, line);
        size += own;
    }
    at = add(json, at, "{\"asset\":{\"version\":\"2.0\"},\"meshes\":[");
    for (int m = 0; m < MESHES; m++) {
        at = add(json, at, m ? "]},{\"primitives\":[" : "{\"primitives\":[");
        for (int p = 0; p < s->primitive_counts[m]; p++, index++) {
            const primitive* from = &s->primitives[m][p];
            const size_t own = 6 * (size_t)from->faces;
            memcpy(bytes + size, from->corners, own);
            snprintf(line, sizeof line, ",{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}", size, own);
            v_length = add(views, v_length, line);
            snprintf(line, sizeof line, ",{\"bufferView\":%d,\"componentType\":5123,\"count\":%d,\"type\":\"SCALAR\"}",
                     index, 3 * from->faces);
            a_length = add(accessors, a_length, line);
            snprintf(line, sizeof line, "%s{\"attributes\":{\"POSITION\":%d},\"indices\":%d}", p ? "," : "",
                     from->accessor, index);
            at = add(json, at, line);
            size += own;
        }
    }
    at = add(json, at, "]}],\"nodes\":[");
    for (int n = 0; n < NODES; n++) {
        snprintf(line, sizeof line,
                 "%s{\"name\":\"n%d\",\"translation\":[%.17g,%.17g,%.17g],\"rotation\":[%.17g,%.17g,%.17g,%.17g],"
                 "\"scale\":[%.17g,%.17g,%.17g]",
                 n ? "," : "", n, s->nodes[n].move[0], s->nodes[n].move[1], s->nodes[n].move[2], s->nodes[n].turn[0],
                 s->nodes[n].turn[1], s->nodes[n].turn[2], s->nodes[n].turn[3], s->nodes[n].scale[0],
                 s->nodes[n].scale[1], s->nodes[n].scale[2]);
        at = add(json, at, line);
        snprintf(line, sizeof line, ",\"mesh\":%d", s->nodes[n].mesh);
        if (s->nodes[n].mesh >= 0) at = add(json, at, line);
        int children = 0;
        for (int c = 0; c < NODES; c++) {
            if (s->nodes[c].parent != n) continue;
            snprintf(line, sizeof line, "%s%d", children++ ? "," : ",\"children\":[", c);
            at = add(json, at, line);
        }
        at = add(json, at, children ? "]}" : "}");
    }
    at = add(json, at, "],\"bufferViews\":[");
    at = add(json, at, views);
    at = add(json, at, "],\"accessors\":[");
    at = add(json, at, accessors);
    snprintf(line, sizeof line, "],\"buffers\":[{\"byteLength\":%zu}]}", size);
    add(json, at, line);
    return test_glb_pack(json, bytes, size);
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* Where a node's vertex is in the scene: scaled, turned and moved by the node, and by all above it. */
static void place(const scene* s, int node, const float from[3], double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = (double)from[k];
    for (; node >= 0; node = s->nodes[node].parent) {
        const double* q = s->nodes[node].turn;
        double a[3], b[3];
        for (int k = 0; k < 3; k++) out[k] *= s->nodes[node].scale[k];
        cross(q, out, a);
        for (int k = 0; k < 3; k++) a[k] += q[3] * out[k];
        cross(q, a, b);
        for (int k = 0; k < 3; k++) out[k] += 2 * b[k] + s->nodes[node].move[k];
    }
}

static bool is_mirrored(const scene* s, int node) {
    bool mirrored = false;
    for (; node >= 0; node = s->nodes[node].parent)
        for (int k = 0; k < 3; k++) mirrored ^= s->nodes[node].scale[k] < 0;
    return mirrored;
}

static bool carries(const scene* s, int above, int node) {
    for (; node >= 0; node = s->nodes[node].parent)
        if (node == above) return true;
    return false;
}

/* Vertices that a mesh takes: of an accessor that it alone has all, of one that another shown mesh has too its own. */
static int vertices_of(const scene* s, int mesh) {
    int sum = 0;
    for (int a = 0; a < ACCESSORS; a++) {
        bool used[MOST] = {false}, has = false, shared = false;
        int own = 0;
        for (int n = 0; n < NODES; n++) {
            const int m = s->nodes[n].mesh;
            for (int p = 0; m >= 0 && p < s->primitive_counts[m]; p++) {
                const primitive* from = &s->primitives[m][p];
                if (from->accessor != a) continue;
                shared |= m != mesh, has |= m == mesh;
                for (int c = 0; m == mesh && c < 3 * from->faces; c++) used[from->corners[c]] = true;
            }
        }
        for (int v = 0; v < s->counts[a]; v++) own += used[v];
        sum += !has ? 0 : shared ? own : s->counts[a];
    }
    return sum;
}

/* The nodes that have triangles, in the file's order; which of them carries which. */
static void check_nodes(const scene* s, const dm_gltf* gltf, const int faces_of[NODES]) {
    int entries[NODES], next = 0, first_face = 0, first_vertex = 0;
    for (int n = 0; n < NODES; n++) entries[n] = s->nodes[n].mesh < 0 ? -1 : next++;
    assert_int_equal(dm_gltf_node_count(gltf), next);
    for (int n = 0; n < NODES; n++) {
        dm_gltf_node node;
        char name[8];
        int above = s->nodes[n].parent;
        if (entries[n] < 0) continue;
        while (above >= 0 && entries[above] < 0) above = s->nodes[above].parent;
        assert_int_equal(dm_gltf_get_node(gltf, (uint32_t)entries[n], &node), DM_OK);
        snprintf(name, sizeof name, "n%d", n);
        assert_string_equal(node.name, name);
        assert_int_equal(node.node, n);
        assert_int_equal(node.carrier, above < 0 ? DM_GLTF_NO_CARRIER : (uint32_t)entries[above]);
        assert_int_equal(node.first_face, first_face);
        assert_int_equal(node.face_count, faces_of[n]);
        assert_int_equal(node.first_vertex, first_vertex);
        assert_int_equal(node.vertex_count, vertices_of(s, s->nodes[n].mesh));
        first_face += faces_of[n], first_vertex += vertices_of(s, s->nodes[n].mesh);
    }
}

static void check_scene(const scene* s, const dm_gltf* gltf) {
    dm_mesh_desc mesh;
    int owners[NODES * PRIMITIVES * FACES], faces_of[NODES] = {0};
    uint64_t face = 0;
    assert_int_equal(dm_gltf_get_mesh(gltf, &mesh), DM_OK);
    const float* positions = mesh.positions;
    const uint32_t* indices = mesh.indices;
    for (int n = 0; n < NODES; n++) {
        const int m = s->nodes[n].mesh;
        for (int p = 0; m >= 0 && p < s->primitive_counts[m]; p++) {
            const primitive* from = &s->primitives[m][p];
            for (int f = 0; f < from->faces; f++, face++) {
                assert_true(3 * face < mesh.index_count);
                owners[face] = n, faces_of[n]++;
                for (int c = 0; c < 3; c++) {
                    const float* got = positions + 3 * (size_t)indices[3 * face + (uint64_t)c];
                    double want[3];
                    const int corner = from->corners[3 * f + (is_mirrored(s, n) ? 2 - c : c)];
                    place(s, n, s->xyz[from->accessor][corner], want);
                    for (int k = 0; k < 3; k++)
                        if (!(fabs((double)got[k] - want[k]) < 1e-5)) fail_msg("node %d, face %d of it", n, f);
                }
            }
        }
    }
    assert_int_equal(mesh.index_count, 3 * face);
    check_nodes(s, gltf, faces_of);
    for (int n = 0; n < NODES; n++) { /* a name stands for what the node carries */
        uint8_t ids[NODES * PRIMITIVES * FACES] = {0};
        char name[8];
        const char* names[1] = {name};
        int all = 0;
        snprintf(name, sizeof name, "n%d", n);
        for (uint64_t f = 0; f < face; f++) all += carries(s, n, owners[f]);
        assert_int_equal(dm_gltf_mark_faces(gltf, names, 1, 7, ids, face), all ? DM_OK : DM_ERROR_NOT_FOUND);
        for (uint64_t f = 0; f < face; f++) assert_int_equal(ids[f], carries(s, n, owners[f]) ? 7 : 0);
    }
}

static void every_triangle_is_where_its_node_puts_it(void** state) {
    (void)state;
    static scene s;
    for (uint64_t seed = 0; seed < SCENES; seed++) {
        test_env t;
        make_scene(&s, seed);
        const test_glb glb = write_scene(&s);
        test_env_open(&t, TEST_NEVER);
        dm_gltf* gltf = test_gltf_open(&t, glb.data, glb.size);
        check_scene(&s, gltf);
        dm_gltf_close(gltf);
        test_env_close(&t);
        free(glb.data);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_triangle_is_where_its_node_puts_it),
    };
    return cmocka_run_group_tests_name("gltf_scenes", tests, NULL, NULL);
}
