/* two_copies LIBRARY OTHER — one process holds the library that it is linked with, exported to all, and two copies of
 * libraries that it opens: each does its own work, and one may go while the other works on. Prints the versions. */
#include <stdio.h>
#include <string.h>

#include "dragmesh/dragmesh_loader.h"

static const float positions[16][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1},
                                       {0, 1, 1}, {1, 1, 1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1},
                                       {0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {1, 1, 2}};
static uint16_t indices[72];
static const uint8_t parts[16] = {[8] = 1, 1, 1, 1, 1, 1, 1, 1};

static void make_boxes(void) {
    static const uint8_t corners[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                        2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    for (int i = 0; i < 72; i++) indices[i] = (uint16_t)(corners[i % 36] + i / 36 * 8);
}

/* A context of a library with one object of two boxes, and the joint of the second. */
typedef struct work {
    const dm_core_1* dm;
    dm_context* context;
    dm_object object;
    dm_joint joint;
} work;

static int begin(work* w, const dm_core_1* dm) {
    const dm_mesh_desc mesh = {.struct_size = sizeof mesh,
                               .positions = positions,
                               .vertex_count = 16,
                               .indices = indices,
                               .index_count = 72,
                               .index_format = DM_UINT16,
                               .part_ids = parts,
                               .part_id_bytes = sizeof parts,
                               .part_id_format = DM_UINT8};
    const dm_object_desc object = {.struct_size = sizeof object, .mesh = &mesh};
    const dm_context_desc host = {.struct_size = sizeof host};
    w->dm = dm;
    w->joint = (dm_joint){.struct_size = sizeof w->joint};
    return dm->context_create(&host, &w->context) == DM_OK &&
           dm->object_prepare(w->context, &object, &w->object) == DM_OK &&
           dm->object_get_joint(w->context, w->object, 1, &w->joint) == DM_OK;
}

static int end(work* w) {
    const int worked = w->dm->object_destroy(w->context, w->object) == DM_OK;
    w->dm->context_destroy(w->context);
    return worked;
}

#define CHECK(what)                                                                                                    \
    if (!(what)) return fprintf(stderr, "two_copies: not so: %s\n", #what), 1

int main(int argc, char** argv) {
    dm_library first, second;
    work mine, one, two;
    CHECK(argc == 3);
    make_boxes();
    const dm_core_1 *dm1 = dm_library_open(&first, argv[1]), *dm2 = dm_library_open(&second, argv[2]);
    CHECK(dm1 != NULL && dm2 != NULL);
    CHECK(dm1 != dm2 && dm1->version != dm2->version && dm1->version != dm_version && dm2->version != dm_version);
    printf("linked %x, opened %x and %x\n", dm_version(), dm1->version(), dm2->version());
    CHECK(begin(&mine, (const dm_core_1*)dm_get_interface("dm.core/1")) && begin(&one, dm1) && begin(&two, dm2));
    CHECK(memcmp(&mine.joint, &one.joint, sizeof one.joint) == 0);
    CHECK(memcmp(&mine.joint, &two.joint, sizeof two.joint) == 0);
    CHECK(end(&one));
    dm_library_close(&first);
    CHECK(two.dm->object_get_joint(two.context, two.object, 1, &two.joint) == DM_OK);
    CHECK(end(&two) && end(&mine));
    dm_library_close(&second);
    return 0;
}
