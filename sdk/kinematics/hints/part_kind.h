/* Kinds of parts, told by the names that an asset carries: a door, a lid, a lever. */
#ifndef DMI_HINTS_PART_KIND_H
#define DMI_HINTS_PART_KIND_H

#include <stddef.h>
#include <stdint.h>

#include "kinematics/hints/label_words.h"

typedef enum dmi_part_kind {
#define KIND(name, group, words) DMI_KIND_##name,
#include "kinematics/hints/kinds.def"
#undef KIND
    DMI_KIND_COUNT
} dmi_part_kind;

/* What a label says. */
typedef struct dmi_label_kind {
    dmi_part_kind kind; /* DMI_KIND_NOTHING: no word of the lexicon */
    uint32_t depth;     /* names between the one that says it and the last; 0: the last */
    dmi_label_modifiers modifiers;
} dmi_label_kind;

/* Finds the kind that a label tells: a path of names, outermost first, joined by '/', each UTF-8. The last name that
 * tells a part's kind counts; without one, the last that tells an object's kind. Modifiers are those of all names. A
 * label of NULL is DMI_KIND_NOTHING. */
dmi_label_kind dmi_kind_of_label(const char* label);
/* Returns the kind's name in kinds.def, or NULL beyond the last kind. */
const char* dmi_kind_name(dmi_part_kind kind);

#endif
