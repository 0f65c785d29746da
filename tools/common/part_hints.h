/* What an asset says of a part beside its shape: its label and pivot, as dm_part_desc takes them. */
#ifndef CLI_PART_HINTS_H
#define CLI_PART_HINTS_H

#include <stdbool.h>

#include "dragmesh/dragmesh.h"
#include "dragmesh/ext/gltf.h"

typedef struct part_hints {
    char label[DM_MAX_LABEL + 1]; /* "": none */
    bool has_pivot;
    dm_pivot pivot;
    int32_t pivot_kind; /* DM_PIVOT_* */
} part_hints;

/* Takes label and pivot of a node from its file; `path`, whose last name begins the label, may be NULL. Both stay empty
 * where no node has the name. */
void part_hints_of_node(const dm_gltf* gltf, const char* path, const char* node, part_hints* out);
/* Writes a file's name without folders and ending. */
void part_hints_file_stem(const char* path, char* out, size_t size);
void part_hints_set_label(part_hints* hints, const char* label);
bool part_hints_equal(const part_hints* a, const part_hints* b);
/* Enters the hints into a descriptor, which points to them. */
void part_hints_enter(const part_hints* hints, dm_part_desc* part);

#endif
