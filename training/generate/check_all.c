/* Runs the generator's checks over many objects: prints a line per category, and the worst cases by name. */
#include "check_all.h"

#include <stdio.h>

#include "core/check.h"
#include "generator.h"

#define DEEP 0.02f   /* of the object's size: more than the interpenetration that objects have on purpose; by hand */
#define LOOSE 0.08f  /* of the object's size: more than the play of a joint; by hand */
#define MOST_PARTS 6 /* checked of an object */

typedef struct tally {
    uint32_t parts, deep, loose;
} tally;

static int check_object(uint32_t category, uint64_t seed, int verbose, tally* out) {
    dmg_object object;
    if (dmg_make(category, seed, 0, &object) != 0) return -1;
    int result = 0;
    /* Many parts are alike, such as a keyboard's keys: checks a few spread over the object. */
    const uint32_t step = 1 + object.joint_count / MOST_PARTS;
    for (uint32_t part = 1; part <= object.joint_count && result == 0; part += step) {
        const dmg_joint* joint = &object.joints[part - 1];
        dmg_finding finding;
        result = dmg_check(&object, part, &finding);
        /* Lids, caps and trays may be lifted off. */
        const int loose = finding.gap > LOOSE && joint->type != DM_JOINT_PRISMATIC && joint->type != DM_JOINT_SCREW;
        /* A button sinks into a case that is modelled solid. */
        const int sinks = joint->type == DM_JOINT_PRISMATIC && joint->upper - joint->lower < 0.15f * finding.size;
        const int deep = finding.depth > DEEP && !sinks;
        ++out->parts;
        out->deep += (uint32_t)deep;
        out->loose += (uint32_t)loose;
        if (verbose && (deep || loose))
            printf("  seed %llu %s: depth %.3f at %.3f of [%.3f, %.3f], gap %.3f\n", (unsigned long long)seed,
                   joint->name, (double)finding.depth, (double)finding.depth_value, (double)joint->lower,
                   (double)joint->upper, (double)finding.gap);
    }
    dmg_object_release(&object);
    return result;
}

int check_all(const uint32_t* categories, uint32_t count, uint32_t seeds, uint64_t first_seed, int verbose) {
    tally all = {0, 0, 0};
    for (uint32_t c = 0; c < count; ++c) {
        tally own = {0, 0, 0};
        for (uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
            if (check_object(categories[c], seed, verbose, &own) == 0) continue;
            fprintf(stderr, "dragmesh_generate: out of memory\n");
            return 1;
        }
        printf("%-20s %5u parts %5.1f %% run into the body %5.1f %% come off\n", dmg_category_name(categories[c]),
               own.parts, 100.0 * own.deep / own.parts, 100.0 * own.loose / own.parts);
        fflush(stdout);
        all.parts += own.parts;
        all.deep += own.deep;
        all.loose += own.loose;
    }
    printf("%-20s %5u parts %5.1f %% run into the body %5.1f %% come off\n", "all", all.parts,
           100.0 * all.deep / all.parts, 100.0 * all.loose / all.parts);
    return 0;
}
