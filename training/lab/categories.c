/* The generator's categories and the layout of the lab's structs, for bindings. */
#include "dragmesh_lab.h"
#include "generator.h"

uint32_t dm_lab_category_count(void) {
    return dmg_category_count();
}

const char* dm_lab_category_name(uint32_t index) {
    return dmg_category_name(index);
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
