/* Fuzz target: prepared objects (.dmo). The checksum is set right first, so that the fuzzer reaches what lies behind
 * it; its own four bytes, which do not count then, say in whose axes and unit the file is loaded.
 *
 * Whatever the bytes: an error and nothing kept, or an object of which every number is finite in the host's frame,
 * whose parts can be dragged and picked, and that is the same bytes each time that it is saved and loaded. Memory stays
 * in proportion to the file. */
#include <stdlib.h>
#include <string.h>

#include "kinematics/object/dmo_format.h"
#include "use_object.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

enum { CHECKSUM_AT = 8 };

#define MEMORY_BASE ((size_t)64 << 10) /* docs/reliability.md, of .dmo files */
#define MEMORY_FACTOR 16

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (contexts[0] == NULL) open_contexts();
    const int which = size > CHECKSUM_AT ? data[CHECKSUM_AT] % HOSTS : 0;
    fuzz_host* host = &hosts[which];
    dm_context* context = contexts[which];
    uint8_t* bytes = malloc(size > 0 ? size : 1);
    if (bytes == NULL) return 0;
    memcpy(bytes, data, size);
    if (size > DMI_DMO_CHECKED_FROM) {
        const uint32_t crc = dmi_dmo_crc(bytes + DMI_DMO_CHECKED_FROM, size - DMI_DMO_CHECKED_FROM);
        for (int i = 0; i < 4; i++) bytes[CHECKSUM_AT + i] = (uint8_t)(crc >> (8 * i));
    }
    dm_object object = 0;
    host->peak = host->bytes;
    const dm_result result = dm_object_load(context, bytes, size, 0, &object);
    fuzz_expect(result == DM_OK || result == DM_ERROR_BAD_DATA || result == DM_ERROR_VERSION);
    fuzz_expect(host->peak - host->bytes <= MEMORY_BASE + MEMORY_FACTOR * size);
    free(bytes);
    if (result == DM_OK) {
        use_object(context, object);
        fuzz_expect(dm_object_destroy(context, object) == DM_OK);
    }
    fuzz_expect(host->live <= CONTEXT_BLOCKS);
    return 0;
}
