/* A second opinion on our glTF reader: tinygltf gives the same names, transforms and triangles, of every glTF file of
 * the tree outside tests/fuzz and of a prop in all the ways in which props are shipped. A table says where not, and
 * why. Runs from the repository's root. */
#include <ftw.h>
#include <math.h>

#include "dragmesh/ext/gltf.h"
#include "test_tool.h"

#include "test_prop.h"
#include "tinygltf_scene.h"

#define SLACK 1e-6 /* of a number's size, or of the file's largest one: rounding of floats */

enum { FILES = 13 }; /* at least so many are in the tree */

/* Where the two differ. Each row is checked: a difference that goes must leave the table. */
static const struct {
    test_prop_way way;
    const char* difference;
    const char* why;
} differences[] = {
    {TEST_PROP_SKIN, "nodes", "our reader makes a node of each bone, because bones are what moves"},
    {TEST_PROP_MIRRORED, "winding", "our reader turns triangles round where a node mirrors them, as glTF says"},
    {TEST_PROP_MESHOPT, "triangles", "tinygltf passes over EXT_meshopt_compression and reads the empty fallback"},
    {TEST_PROP_DRACO, "unread", "Debian builds tinygltf without Draco"},
    {TEST_PROP_COLLIDERS, "nodes", "our reader leaves out colliders and what is invisible: they are no body"},
};

typedef struct pair {
    dm_gltf* ours;
    dm_mesh_desc mesh;
    double origin[3]; /* of our mesh in the scene */
    tinygltf_scene theirs;
} pair;

static int is_near(double a, double b, double size) {
    return fabs(a - b) <= SLACK * fmax(size, fabs(b));
}

/* Returns the largest coordinate of a node, as tinygltf has it. */
static double size_of(const tinygltf_node* node) {
    double size = 0;
    for (uint64_t i = 0; i < 3 * node->corner_count; i++) size = fmax(size, fabs(node->corners[i]));
    return size;
}

/* order: which of the three corners of ours is first, second and third of theirs. */
static int have_same_corners(const pair* p, const dm_gltf_node* ours, const tinygltf_node* theirs,
                             const uint64_t order[3]) {
    const float* positions = p->mesh.positions;
    const uint32_t* indices = p->mesh.indices;
    const double size = size_of(theirs);
    if (3 * ours->face_count != theirs->corner_count) return 0;
    for (uint64_t i = 0; i < theirs->corner_count; i++) {
        const float* at = positions + 3 * (size_t)indices[3 * (ours->first_face + i / 3) + order[i % 3]];
        for (int k = 0; k < 3; k++)
            if (!is_near((double)at[k] + p->origin[k], theirs->corners[3 * i + (uint64_t)k], size)) return 0;
    }
    return 1;
}

static int have_same_place(const pair* p, const dm_gltf_node* ours, const tinygltf_node* theirs) {
    char name[16];
    dm_pivot pivot;
    snprintf(name, sizeof name, "#%u", (unsigned)ours->node);
    if (dm_gltf_get_hints(p->ours, name, NULL, 0, &pivot) != DM_OK) return 0;
    const float origin[3] = {pivot.origin.x, pivot.origin.y, pivot.origin.z};
    for (int k = 0; k < 3; k++)
        if (!is_near((double)origin[k] + p->origin[k], theirs->to_scene[12 + k], size_of(theirs))) return 0;
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < 3; k++)
            if (!is_near((double)pivot.axes[3 * axis + k], theirs->to_scene[4 * axis + k], 1)) return 0;
    return 1;
}

/* Returns what the two readers do not agree on; NULL when they agree on all. */
static const char* difference_of(const pair* p) {
    static const uint64_t forwards[3] = {0, 1, 2}, backwards[3] = {2, 1, 0};
    if (dm_gltf_node_count(p->ours) != p->theirs.node_count) return "nodes";
    for (uint32_t i = 0; i < p->theirs.node_count; i++) {
        const tinygltf_node* theirs = &p->theirs.nodes[i];
        dm_gltf_node ours;
        assert_int_equal(dm_gltf_get_node(p->ours, i, &ours), DM_OK);
        if (ours.node != theirs->node) return "nodes";
        if (strcmp(ours.name, theirs->name) != 0) return "names";
        if (!have_same_place(p, &ours, theirs)) return "transforms";
        if (have_same_corners(p, &ours, theirs, backwards)) return "winding";
        if (!have_same_corners(p, &ours, theirs, forwards)) return "triangles";
    }
    return NULL;
}

/* Reads a file twice. Returns as difference_of does, or "unread" where tinygltf does not take it. */
static const char* compare(const char* path) {
    const dm_gltf_desc desc = {.struct_size = sizeof desc};
    pair p;
    assert_int_equal(dm_gltf_open_file(path, &desc, &p.ours), DM_OK);
    assert_int_equal(dm_gltf_get_mesh(p.ours, &p.mesh), DM_OK);
    dm_gltf_get_origin(p.ours, p.origin);
    const char* found = "unread";
    const char* problem = tinygltf_scene_read(path, &p.theirs);
    if (problem == NULL) {
        found = difference_of(&p);
        tinygltf_scene_free(&p.theirs);
    } else {
        print_message("%s: tinygltf: %s\n", path, problem);
    }
    dm_gltf_close(p.ours);
    return found;
}

static int compared; /* files of the tree */

static int visit(const char* path, const struct stat* status, int kind, struct FTW* at) {
    static const char* const left_out[] = {"./.git", "./build", "./out", "./tests/fuzz", "./training/runs"};
    (void)status;
    for (size_t i = 0; kind == FTW_D && i < sizeof left_out / sizeof *left_out; i++)
        if (strcmp(path, left_out[i]) == 0) return FTW_SKIP_SUBTREE;
    if (kind == FTW_D && strcmp(path + at->base, "node_modules") == 0) return FTW_SKIP_SUBTREE;
    const char* ending = strrchr(path, '.');
    if (kind != FTW_F || (strcmp(ending, ".glb") != 0 && strcmp(ending, ".gltf") != 0)) return FTW_CONTINUE;
    const char* difference = compare(path);
    if (difference != NULL) fail_msg("%s: tinygltf has other %s", path, difference);
    compared++;
    return FTW_CONTINUE;
}

static void files_of_the_tree_are_the_same_to_tinygltf(void** state) {
    (void)state;
    assert_int_equal(nftw(".", visit, 16, FTW_PHYS | FTW_ACTIONRETVAL), 0);
    assert_true(compared >= FILES);
}

/* Writes the file, and the one beside it. */
static void write_prop(const test_prop* prop, const char* folder, char out_path[TOOL_PATH]) {
    char path[TOOL_PATH + 32];
    snprintf(out_path, TOOL_PATH, "%.400s/prop.%s", folder, prop->data[0] == '{' ? "gltf" : "glb");
    tool_write(out_path, prop->data, prop->size);
    if (prop->beside == NULL) return;
    snprintf(path, sizeof path, "%s/parts", folder);
    mkdir(path, 0700);
    snprintf(path, sizeof path, "%s/parts/the cabinet.bin", folder);
    tool_write(path, prop->beside, prop->beside_size);
}

static const char* expected_difference(int way) {
    for (size_t i = 0; i < sizeof differences / sizeof *differences; i++) {
        if (differences[i].way != (test_prop_way)way) continue;
        print_message("way %d: other %s: %s\n", way, differences[i].difference, differences[i].why);
        return differences[i].difference;
    }
    return "nothing";
}

static void compare_prop(const test_prop* prop, int way) {
    char folder[TOOL_PATH], path[TOOL_PATH];
    tool_folder_make(folder);
    write_prop(prop, folder, path);
    const char *found = compare(path), *expected = expected_difference(way);
    if (found == NULL) found = "nothing";
    if (strcmp(found, expected) != 0)
        fail_msg("way %d: the readers differ in: %s; the table says: %s", way, found, expected);
    tool_folder_remove(folder);
}

static void shipped_props_are_the_same_to_tinygltf_but_for_the_table(void** state) {
    (void)state;
    for (int way = 0; way < TEST_PROP_WAYS; way++) {
        test_prop prop;
        if (test_prop_make(&prop, (test_prop_way)way)) compare_prop(&prop, way);
        test_prop_free(&prop);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_of_the_tree_are_the_same_to_tinygltf),
        cmocka_unit_test(shipped_props_are_the_same_to_tinygltf_but_for_the_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
