/* Names of results, and the version. */
#include "dragmesh/dragmesh.h"

const char* DM_CALL dm_result_string(dm_result result) {
    switch (result) {
    case DM_OK:
        return "DM_OK";
    case DM_ERROR_INVALID_ARGUMENT:
        return "DM_ERROR_INVALID_ARGUMENT";
    case DM_ERROR_STRUCT_SIZE:
        return "DM_ERROR_STRUCT_SIZE";
    case DM_ERROR_STALE_HANDLE:
        return "DM_ERROR_STALE_HANDLE";
    case DM_ERROR_OUT_OF_MEMORY:
        return "DM_ERROR_OUT_OF_MEMORY";
    case DM_ERROR_NOT_FINITE:
        return "DM_ERROR_NOT_FINITE";
    case DM_ERROR_INDEX_OUT_OF_RANGE:
        return "DM_ERROR_INDEX_OUT_OF_RANGE";
    case DM_ERROR_EMPTY_MASK:
        return "DM_ERROR_EMPTY_MASK";
    case DM_ERROR_FULL_MASK:
        return "DM_ERROR_FULL_MASK";
    case DM_ERROR_DEGENERATE_MESH:
        return "DM_ERROR_DEGENERATE_MESH";
    case DM_ERROR_ZERO_DRAG:
        return "DM_ERROR_ZERO_DRAG";
    case DM_ERROR_DRAG_OFF_PART:
        return "DM_ERROR_DRAG_OFF_PART";
    case DM_ERROR_BAD_DATA:
        return "DM_ERROR_BAD_DATA";
    case DM_ERROR_WRONG_MODEL:
        return "DM_ERROR_WRONG_MODEL";
    case DM_ERROR_VERSION:
        return "DM_ERROR_VERSION";
    case DM_ERROR_CANCELLED:
        return "DM_ERROR_CANCELLED";
    case DM_ERROR_NO_MODEL:
        return "DM_ERROR_NO_MODEL";
    case DM_ERROR_TOO_LARGE:
        return "DM_ERROR_TOO_LARGE";
    case DM_ERROR_BUFFER_TOO_SMALL:
        return "DM_ERROR_BUFFER_TOO_SMALL";
    case DM_ERROR_NOT_FOUND:
        return "DM_ERROR_NOT_FOUND";
    case DM_ERROR_UNSUPPORTED:
        return "DM_ERROR_UNSUPPORTED";
    case DM_ERROR_INTERNAL:
        return "DM_ERROR_INTERNAL";
    default:
        return "DM_ERROR_UNKNOWN";
    }
}

uint32_t DM_CALL dm_version(void) {
    return DM_VERSION;
}
