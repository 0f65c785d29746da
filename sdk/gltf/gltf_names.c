/* Sorts the names of nodes, so that a name is found in the logarithm of their number. */
#include "gltf/gltf_names.h"

#include <stdlib.h>
#include <string.h>

#include "base/utf8.h"

static int compare(const void* a, const void* b) {
    const dmi_gltf_name *x = a, *y = b;
    const int names = strcmp(x->name, y->name);
    return names != 0 ? names : (x->node > y->node) - (x->node < y->node);
}

dm_result dmi_gltf_sort_names(dm_gltf* gltf, dmi_gltf_problem* problem) {
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    if (count == 0) return DM_OK;
    const dm_result result = dmi_gltf_spend(gltf, count, sizeof *gltf->names, "glTF: the names", problem);
    if (result != DM_OK) return result;
    gltf->names = dmi_alloc(&gltf->env, count * sizeof *gltf->names, _Alignof(dmi_gltf_name));
    if (!gltf->names)
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "no memory for the names of %u nodes", count);
    for (uint32_t i = 0; i < count; i++) gltf->names[i] = (dmi_gltf_name){gltf->tree[i].name, i};
    qsort(gltf->names, count, sizeof *gltf->names, compare);
    return DM_OK;
}

/* Returns the first place from `low` on whose name is `name` or comes after it. after: only one that comes after it. */
static uint32_t lower_bound(const dm_gltf* gltf, const char* name, uint32_t low, bool after) {
    uint32_t high = gltf->document.counts[DMI_GLTF_NODES];
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        const int order = dmi_utf8_compare_mended(name, gltf->names[middle].name);
        if (order > 0 || (after && order == 0))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Finds the node that "#12" stands for. It finds none where the name is not of this form, or there is no such node. */
static dmi_gltf_namesakes numbered_node(const dm_gltf* gltf, const char* name) {
    const dmi_gltf_namesakes none = {NULL, 0};
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    if (name[0] != '#' || name[1] < '0' || name[1] > '9') return none;
    char* end;
    const unsigned long index = strtoul(name + 1, &end, 10);
    if (*end != 0 || index >= count) return none;
    const dmi_gltf_name wanted = {gltf->tree[index].name, (uint32_t)index};
    return (dmi_gltf_namesakes){bsearch(&wanted, gltf->names, count, sizeof wanted, compare), 1};
}

dmi_gltf_namesakes dmi_gltf_find_nodes(const dm_gltf* gltf, const char* name) {
    const uint32_t first = lower_bound(gltf, name, 0, false), end = lower_bound(gltf, name, first, true);
    return end > first ? (dmi_gltf_namesakes){gltf->names + first, end - first} : numbered_node(gltf, name);
}
