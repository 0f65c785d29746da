/* Gives bindings the generator's categories and the layout of the lab's structs. */
#include <string.h>

#include "dragmesh_lab.h"
#include "generator.h"

#define KIND_SEEDS 24
#define MOST_KINDS 64

uint32_t dm_lab_category_count(void) {
    return dmg_category_count();
}

const char* dm_lab_category_name(uint32_t row) {
    return dmg_category_name(row);
}

uint32_t dm_lab_category_id(uint32_t row) {
    return dmg_category_id(row);
}

int32_t dm_lab_category_set(uint32_t row) {
    return dmg_category_set(row);
}

uint32_t dm_lab_category_id_limit(void) {
    return dmg_category_id_limit();
}

/* Returns the length of a joint's name without its trailing number. */
static size_t stem(const char* name) {
    size_t length = strlen(name);
    while (length > 0 && (name[length - 1] == '_' || (name[length - 1] >= '0' && name[length - 1] <= '9'))) length--;
    return length;
}

uint32_t dm_lab_category_kinds(uint32_t row) {
    char kinds[MOST_KINDS][sizeof((dmg_joint*)0)->name];
    uint32_t count = 0;
    for (uint64_t seed = 0; seed < KIND_SEEDS; seed++) {
        dmg_object object;
        if (dmg_make(row, seed, 0, &object) != 0) continue;
        for (uint32_t j = 0; j < object.joint_count; j++) {
            const char* name = object.joints[j].name;
            const size_t length = stem(name);
            uint32_t k = 0;
            while (k < count && (strlen(kinds[k]) != length || strncmp(kinds[k], name, length) != 0)) k++;
            if (k < count || count == MOST_KINDS) continue;
            memcpy(kinds[count], name, length);
            kinds[count++][length] = 0;
        }
        dmg_object_release(&object);
    }
    return count;
}

uint32_t dm_lab_layout(uint32_t which) {
    switch (which) {
    case 0:
        return sizeof(dm_lab_options);
    case 1:
        return sizeof(dm_lab_kpp);
    case 2:
        return sizeof(dm_lab_vae);
    default:
        return 0;
    }
}
