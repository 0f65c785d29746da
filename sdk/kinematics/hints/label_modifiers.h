/* Words of a label beside its noun that say how a leaf moves or where it hangs: sliding, garage, left. */
#ifndef DMI_HINTS_LABEL_MODIFIERS_H
#define DMI_HINTS_LABEL_MODIFIERS_H

#include <stddef.h>
#include <stdint.h>

typedef enum dmi_modifier {
#define MODIFIER(name, words) DMI_MODIFIER_##name,
#include "kinematics/hints/modifiers.def"
#undef MODIFIER
    DMI_MODIFIER_COUNT
} dmi_modifier;

/* Returns the modifiers that one folded word tells, a bit each. out_rest: what follows the longest modifier that begins
 * a longer word, such as "tor" in "rolltor"; else NULL. */
uint32_t dmi_modifiers_of_word(const char* word, const char** out_rest);
/* Returns the modifiers that all names of a label tell, by how near they stand: [0] of the last name, [1] of the names
 * above it. label NULL: none. */
typedef struct dmi_label_modifiers {
    uint32_t own, above;
} dmi_label_modifiers;
dmi_label_modifiers dmi_modifiers_of_label(const char* label);

#endif
