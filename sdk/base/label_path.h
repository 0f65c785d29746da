/* Labels: the names of the nodes on the way to a node, outermost first, joined by '/'. They are written from the end,
 * so that the innermost names stay where not all fit. */
#ifndef DMI_BASE_LABEL_PATH_H
#define DMI_BASE_LABEL_PATH_H

#include <string.h>

/* Puts `name` and a '/' before what stands in the last `used` bytes of `out`, the terminating zero among them. Returns
 * the bytes used then: as before where the name is empty or does not fit. */
static inline size_t dmi_put_name_before(char* out, size_t size, size_t used, const char* name) {
    const size_t length = strlen(name), more = length + (used > 1);
    if (length == 0 || more > size - used) return used;
    char* at = out + size - used - more;
    memcpy(at, name, length); /* NOLINT(bugprone-not-null-terminated-result): what stands behind it ends the text */
    if (used > 1) at[length] = '/';
    return used + more;
}

#endif
