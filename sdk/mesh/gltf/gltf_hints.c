/* What a file says of a node beside its mesh: the names on the way to it, where it is, and its axes. */
#include "mesh/gltf/gltf_hints.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/fp_environment.h"
#include "mesh/gltf/gltf_matrix.h"
#include "mesh/gltf/gltf_names.h"
#include "mesh/gltf/gltf_pivots.h"

enum { COLUMN = DMI_GLTF_COLUMN, ORIGIN = DMI_GLTF_ORIGIN };

/* Puts `name` and a '/' before what stands in the last `used` bytes of `out`. Returns the bytes used then: as before
 * where the name does not fit. */
static size_t put_before(char* out, size_t size, size_t used, const char* name) {
    const size_t length = strlen(name), more = length + (used > 1);
    if (length == 0 || more > size - used) return used;
    char* at = out + size - used - more;
    memcpy(at, name, length); /* NOLINT(bugprone-not-null-terminated-result): what stands behind it ends the text */
    if (used > 1) at[length] = '/';
    return used + more;
}

const char* dmi_gltf_mesh_name(const dm_gltf* gltf, const dmi_gltf_tree_node* node) {
    const cJSON* mesh = dmi_gltf_item(&gltf->document, DMI_GLTF_MESHES, node->mesh);
    const char* name = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(mesh, "name"));
    return name ? name : "";
}

/* Writes the names of the nodes that carry a node, of its mesh and its own. Where not all fit, the innermost ones of
 * the nodes above stay. */
static void write_path(const dm_gltf* gltf, const dmi_gltf_tree_node* node, char* out, size_t size) {
    size_t used = put_before(out, size, 1, node->name);
    out[size - 1] = 0;
    used = put_before(out, size, used, dmi_gltf_mesh_name(gltf, node));
    for (int32_t index = node->named; index >= 0; index = gltf->tree[index].named) {
        const size_t before = used;
        used = put_before(out, size, used, gltf->tree[index].name);
        if (used == before) break;
    }
    memmove(out, out + size - used, used);
}

static bool fit_floats(const double* numbers, int count) {
    for (int i = 0; i < count; i++)
        if (!(fabs(numbers[i]) <= FLT_MAX)) return false;
    return true;
}

bool dmi_gltf_write_pivot(const dm_gltf* gltf, const double world[16], dm_pivot* out) {
    float origin[3];
    *out = (dm_pivot){{0, 0, 0}, {0}};
    if (!fit_floats(world, ORIGIN + 3)) return false;
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++) out->axes[3 * column + row] = (float)world[COLUMN * column + row];
    for (int row = 0; row < 3; row++) origin[row] = (float)(world[ORIGIN + row] - gltf->origin[row]);
    out->origin = (dm_vec3){origin[0], origin[1], origin[2]};
    return true;
}

int32_t dm_gltf_pivots_are_lost(const dm_gltf* gltf) {
    return gltf && gltf->pivots_are_lost;
}

dm_result dm_gltf_get_pivot_kind(const dm_gltf* gltf, const char* name, int32_t* out_kind) {
    DMI_OWN_FP;
    if (!gltf || !name || !out_kind) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_gltf_namesakes found = dmi_gltf_find_nodes(gltf, name);
    if (found.count == 0 || !gltf->tree[found.first->node].placed) return DM_ERROR_NOT_FOUND;
    *out_kind = dmi_gltf_pivot_kind(gltf, found.first->node);
    return DM_OK;
}

dm_result dm_gltf_get_hints(const dm_gltf* gltf, const char* name, char* out_label, size_t label_size,
                            dm_pivot* out_pivot) {
    DMI_OWN_FP;
    if (!gltf || !name || (out_label && label_size == 0)) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_gltf_namesakes found = dmi_gltf_find_nodes(gltf, name);
    const dmi_gltf_tree_node* node = found.count > 0 ? &gltf->tree[found.first->node] : NULL;
    if (!node || !node->placed) return DM_ERROR_NOT_FOUND;
    if (out_label) write_path(gltf, node, out_label, label_size);
    if (out_pivot) dmi_gltf_write_pivot(gltf, node->world, out_pivot);
    return DM_OK;
}
