/* Makes safetensors files in memory: either from tensors, or from any header text, right or wrong. */
#ifndef DM_TEST_SAFETENSORS_H
#define DM_TEST_SAFETENSORS_H

#include "test_host.h"

typedef struct test_file {
    unsigned char* data;
    size_t size;
} test_file;

/* The header as given, then `numbers` floats 0, 1, 2 … */
static inline test_file test_file_of(const char* header, size_t numbers) {
    const size_t length = strlen(header);
    test_file file = {NULL, 8 + length + numbers * sizeof(float)};
    file.data = malloc(file.size);
    for (int i = 0; i < 8; ++i) file.data[i] = (unsigned char)((uint64_t)length >> (8 * i));
    memcpy(file.data + 8, header, length);
    for (size_t i = 0; i < numbers; ++i) {
        const float number = (float)i;
        memcpy(file.data + 8 + length + i * sizeof number, &number, sizeof number);
    }
    return file;
}

#endif
