/* Fuzz target: the bytes of a glTF file; also as a mask for the mesh in it. */
#include "use_gltf.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    use_gltf(data, size);
    return 0;
}
