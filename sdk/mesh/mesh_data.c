/* Looks up the parts of a mesh. */
#include "mesh/mesh_data.h"

#include "base/ids.h"

int32_t dmi_mesh_find_part(const dmi_mesh* mesh, uint32_t id) {
    return dmi_find_id(&mesh->parts->id, sizeof *mesh->parts, mesh->part_count, id);
}

int dmi_mesh_moves_with(const dmi_mesh* mesh, uint32_t index, uint32_t ancestor) {
    while (index != ancestor && index != 0) index = mesh->parts[index].parent;
    return index == ancestor;
}
