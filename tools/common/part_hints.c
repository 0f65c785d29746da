/* Labels and pivots of a file's nodes. */
#include "part_hints.h"

#include <stdio.h>
#include <string.h>

void part_hints_set_label(part_hints* hints, const char* label) {
    snprintf(hints->label, sizeof hints->label, "%s", label);
}

void part_hints_file_stem(const char* path, char* out, size_t size) {
    const char* name = strrchr(path, '/') != NULL ? strrchr(path, '/') + 1 : path;
    const char* dot = strrchr(name, '.');
    snprintf(out, size, "%.*s", (int)(dot != NULL ? dot - name : (long)strlen(name)), name);
}

void part_hints_of_node(const dm_gltf* gltf, const char* path, const char* node, part_hints* out) {
    char file[256] = "", names[DM_MAX_LABEL + 1 - sizeof file];
    *out = (part_hints){.has_pivot = false};
    if (dm_gltf_get_hints(gltf, node, names, sizeof names, &out->pivot) != DM_OK) return;
    out->has_pivot =
        dm_gltf_get_pivot_kind(gltf, node, &out->pivot_kind) == DM_OK && out->pivot_kind != DM_PIVOT_DEFAULT;
    if (path != NULL) part_hints_file_stem(path, file, sizeof file);
    snprintf(out->label, sizeof out->label, "%s/%s", file, names);
}

bool part_hints_equal(const part_hints* a, const part_hints* b) {
    /* NOLINTBEGIN(bugprone-suspicious-memory-comparison): the bits are what is asked */
    return strcmp(a->label, b->label) == 0 && a->has_pivot == b->has_pivot && a->pivot_kind == b->pivot_kind &&
           (!a->has_pivot || memcmp(&a->pivot, &b->pivot, sizeof a->pivot) == 0);
    /* NOLINTEND(bugprone-suspicious-memory-comparison) */
}

void part_hints_enter(const part_hints* hints, dm_part_desc* part) {
    part->label = hints->label[0] != 0 ? hints->label : NULL;
    part->pivot = hints->has_pivot ? &hints->pivot : NULL;
    part->pivot_kind = hints->has_pivot ? hints->pivot_kind : DM_PIVOT_UNKNOWN;
}
