/* Prints what tests/e2e/category_ids.sh compares between tables of categories: of every kind its id, its set, a hash of
 * which seeds are in which split, and a hash of objects; then hashes of training cases drawn from the kinds whose ids
 * are below the first argument. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../training/lab/case.h"
#include "core/build.h"
#include "generator.h"
#include "test_object_hash.h"

enum { SEEDS = 4, SPLIT_SEEDS = 1000, CASES = 60, MOST_IDS = 1 << 16 };

/* The kind that the script adds to the table. */
void dmg_build_added_kind(dmg_builder* b);
void dmg_build_added_kind(dmg_builder* b) {
    dmg_box(b, v3(0, 0.5f, 0), v3(1, 1, 1));
    dmg_hinge(b, 0, "door", v3(-0.5f, 0.5f, 0.5f), v3(0, 1, 0), 0, 1.5f);
    dmg_box(b, v3(0, 0.5f, 0.52f), v3(1, 1, 0.02f));
}

static int print_kind(uint32_t row) {
    uint64_t splits = TEST_HASH_START, objects = splits;
    for (uint64_t seed = 0; seed < SPLIT_SEEDS; seed++) {
        const int32_t split = dmg_split(row, seed);
        splits = test_hash_bytes(splits, &split, sizeof split);
    }
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        dmg_object object;
        if (dmg_make(row, seed, seed % 2 == 0 ? DMG_MESSY : 0, &object) != 0) return 0;
        objects = test_hash_object(objects, &object);
        dmg_object_release(&object);
    }
    printf("kind %s %" PRIu32 " set %" PRId32 " %016" PRIx64 " %016" PRIx64 "\n", dmg_category_name(row),
           dmg_category_id(row), dmg_category_set(row), splits, objects);
    return 1;
}

static int print_cases(uint32_t id_end) {
    static uint8_t weights[MOST_IDS];
    static lab_case made;
    if (id_end > MOST_IDS || dmg_category_id_limit() > MOST_IDS) return 0;
    for (uint32_t id = 0; id < id_end; id++) weights[id] = dmg_category_with_id(id) >= 0 ? (uint8_t)(1 + id % 3) : 0;
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    const dm_lab_options options = {
        .seed = 5, .categories = weights, .messy = 0.5f, .mask_noise = 0.3f, .rotated = 0.5f};
    for (uint64_t i = 0; i < CASES; i++) {
        if (lab_case_make(&env, &options, i, &made) != DM_OK) return 0;
        const uint64_t hash = test_hash_object(TEST_HASH_START, &made.object);
        printf("case %" PRIu64 " of %" PRIu32 " %" PRIu32 " %016" PRIx64 "\n", i, made.category_id, made.part, hash);
        lab_case_release(&env, &made);
    }
    return 1;
}

int main(int count, char** arguments) {
    if (count != 2) return 2;
    for (uint32_t row = 0; row < dmg_category_count(); row++)
        if (!print_kind(row)) return 1;
    return print_cases((uint32_t)strtoul(arguments[1], NULL, 10)) ? 0 : 1;
}
