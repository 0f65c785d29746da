/* The function table: another way into the library, and the one symbol that a dynamic host looks up. */
#include <string.h>

#include "dragmesh/dragmesh.h"

#define ENTRY(result, name, arguments) .name = dm_##name,
static const dm_core_1 core_1 = {.struct_size = sizeof(dm_core_1), DM_CORE_FUNCTIONS(ENTRY)};
#undef ENTRY

const void* DM_CALL dm_get_interface(const char* id) {
    return id != NULL && strcmp(id, "dm.core/1") == 0 ? &core_1 : NULL;
}
