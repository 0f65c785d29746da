/* Prints what a compiler's generator makes of every kind, clean and messy: how many vertices, and a sum over where they
 * are; of assets also how many nodes. */
#include <math.h>
#include <stdio.h>

#include "asset.h"

enum { SEEDS = 12 };

/* Sum of all coordinates, each by a weight of its own, over the farthest: rounding does not show in it. */
static double place(const dmg_object* object) {
    double sum = 0, farthest = 1e-9;
    for (uint32_t i = 0; i < 3 * object->vertex_count; i++) {
        sum += (double)object->positions[i] * (i % 7 + 1);
        farthest = fmax(farthest, fabs((double)object->positions[i]));
    }
    return sum / farthest / object->vertex_count;
}

int main(void) {
    for (uint32_t kind = 0; kind < dmg_category_count(); kind++) {
        double sum = 0;
        unsigned long vertices = 0;
        for (uint64_t seed = 1; seed <= SEEDS; seed++) {
            dmg_object object;
            if (dmg_make(kind, seed, seed % 2 == 0 ? DMG_MESSY : 0, &object) != 0) return 1;
            vertices += object.vertex_count;
            sum += place(&object);
            dmg_object_release(&object);
        }
        dmg_asset asset;
        if (dmg_make_asset(kind, 1 + kind, kind % 2 ? DMG_MESSY : 0, &asset) != 0) return 1;
        printf("%s %lu %.2f, asset of %u nodes %.2f\n", dmg_category_name(kind), vertices, sum, asset.node_count,
               place(&asset.object));
        dmg_asset_release(&asset);
    }
    return 0;
}
