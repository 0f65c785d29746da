/* Measures how fast objects are made: per category, and the mean over all in turn, as training makes them. */
#include "bench.h"

#include <stdio.h>
#include <time.h>

#include "generator.h"

/* Returns the processor time in seconds. */
static double now(void) {
    return (double)clock() / CLOCKS_PER_SEC;
}

int bench(const uint32_t* categories, uint32_t count, uint32_t flags) {
    enum { OBJECTS = 200 };
    double seconds = 0.0, triangles = 0.0, parts = 0.0;
    for (uint32_t c = 0; c < count; ++c) {
        const double start = now();
        double own_triangles = 0.0;
        for (uint64_t seed = 0; seed < OBJECTS; ++seed) {
            dmg_object object;
            if (dmg_make(categories[c], seed, flags, &object) != 0) {
                fprintf(stderr, "dragmesh_generate: out of memory\n");
                return 1;
            }
            own_triangles += object.face_count;
            parts += object.joint_count;
            dmg_object_release(&object);
        }
        const double own = now() - start;
        seconds += own;
        triangles += own_triangles;
        printf("%-20s %8.0f objects/s %8.0f triangles\n", dmg_category_name(categories[c]), OBJECTS / own,
               own_triangles / OBJECTS);
    }
    const double made = (double)OBJECTS * count;
    printf("%-20s %8.0f objects/s %8.0f triangles %6.1f parts\n", "all", made / seconds, triangles / made,
           parts / made);
    return 0;
}
