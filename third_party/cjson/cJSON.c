/* Compiles cJSON under the names of cJSON.h. */
#define ENABLE_LOCALES /* numbers have a point in every locale of the host */
#include "cJSON.h"

#include "upstream/cJSON.c"
