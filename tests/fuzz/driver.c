/* Runs a fuzz target without a fuzzing compiler: every file given (folders: every file in them), then seeded random
 * mutations of them. A target is a file with LLVMFuzzerTestOneInput; built by clang with -fsanitize=fuzzer it needs no
 * driver.
 *
 *     fuzz_mask [-n MUTATIONS] [-s SEED] [PATH…]      default 1000 and 1; no path: mutations of nothing
 *
 * A crash repeats with the same arguments. */
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/random.h"

#define INPUT_LIMIT (1u << 22)
#define MAX_EDITS 8

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

typedef struct input {
    uint8_t* bytes;
    size_t size;
} input;

typedef struct fuzzer {
    dmi_random random;
    uint64_t runs;
    uint8_t* work; /* INPUT_LIMIT bytes */
    input* inputs;
    size_t input_count;
} fuzzer;

/* From a block of exactly its size, so that a read beyond the end is seen. */
static void run_once(fuzzer* fuzzer, const uint8_t* data, size_t size) {
    uint8_t* exact = malloc(size > 0 ? size : 1);
    if (exact == NULL) return;
    memcpy(exact, data, size);
    LLVMFuzzerTestOneInput(exact, size);
    free(exact);
    fuzzer->runs++;
}

static size_t below(fuzzer* fuzzer, size_t limit) {
    return limit > 0 ? dmi_random_u32(&fuzzer->random) % limit : 0;
}

static size_t insert(fuzzer* fuzzer, size_t size, size_t at, const uint8_t* bytes, size_t count) {
    if (count > INPUT_LIMIT - size) count = INPUT_LIMIT - size;
    memmove(fuzzer->work + at + count, fuzzer->work + at, size - at);
    memcpy(fuzzer->work + at, bytes, count);
    return size + count;
}

static size_t erase(fuzzer* fuzzer, size_t size) {
    size_t at = below(fuzzer, size), count = 1 + below(fuzzer, size - at < 64 ? size - at : 64);
    if (count > size - at) count = size - at;
    memmove(fuzzer->work + at, fuzzer->work + at + count, size - at - count);
    return size - count;
}

/* Numbers at which checks break, of 1, 2, 4 or 8 bytes. */
static void write_edge_number(fuzzer* fuzzer, size_t size) {
    static const uint64_t edges[] = {0,      1,          0x7f,       0x80,       0xff,      0x7fff,
                                     0xffff, 0x7fffffff, 0x80000000, 0xffffffff, INT64_MAX, UINT64_MAX};
    uint64_t value = edges[below(fuzzer, sizeof edges / sizeof edges[0])];
    size_t width = (size_t)1 << below(fuzzer, 4);
    if (width > size) return;
    memcpy(fuzzer->work + below(fuzzer, size - width + 1), &value, width);
}

static size_t edit(fuzzer* fuzzer, size_t size) {
    static const uint8_t tokens[] = "[]{}(),:'\"-+.0123456789eE \n\\\x00\xff";
    uint8_t piece[64];
    size_t count;
    if (size == 0) return insert(fuzzer, size, 0, tokens + below(fuzzer, sizeof tokens - 1), 1);
    switch (below(fuzzer, 7)) {
    case 0:
        fuzzer->work[below(fuzzer, size)] ^= (uint8_t)(1u << below(fuzzer, 8));
        return size;
    case 1:
        fuzzer->work[below(fuzzer, size)] = (uint8_t)below(fuzzer, 256);
        return size;
    case 2:
        write_edge_number(fuzzer, size);
        return size;
    case 3:
        return erase(fuzzer, size);
    case 4:
        return below(fuzzer, size + 1); /* cut off */
    case 5:
        return insert(fuzzer, size, below(fuzzer, size + 1), tokens + below(fuzzer, sizeof tokens - 1), 1);
    default: /* a piece of it once more somewhere else */
        count = 1 + below(fuzzer, size < sizeof piece ? size : sizeof piece);
        if (count > size) count = size;
        memcpy(piece, fuzzer->work + below(fuzzer, size - count + 1), count);
        return insert(fuzzer, size, below(fuzzer, size + 1), piece, count);
    }
}

/* Runs a change of any input. */
static void run_mutation(fuzzer* fuzzer) {
    const input* original = &fuzzer->inputs[below(fuzzer, fuzzer->input_count)];
    size_t size = original->size;
    memcpy(fuzzer->work, original->bytes, size);
    for (size_t edits = 1 + below(fuzzer, MAX_EDITS); edits > 0; edits--) size = edit(fuzzer, size);
    run_once(fuzzer, fuzzer->work, size);
}

/* Keeps the bytes, and runs them. */
static int run_input(fuzzer* fuzzer, const uint8_t* bytes, size_t size) {
    input* inputs = realloc(fuzzer->inputs, (fuzzer->input_count + 1) * sizeof *inputs);
    if (inputs != NULL) fuzzer->inputs = inputs;
    uint8_t* copy = malloc(size > 0 ? size : 1);
    if (inputs == NULL || copy == NULL) {
        free(copy);
        return 1;
    }
    memcpy(copy, bytes, size);
    inputs[fuzzer->input_count++] = (input){copy, size};
    run_once(fuzzer, copy, size);
    return 0;
}

static int run_file(fuzzer* fuzzer, const char* path) {
    FILE* file = fopen(path, "rb");
    if (file == NULL) {
        fprintf(stderr, "%s: can't be read\n", path);
        return 1;
    }
    const size_t size = fread(fuzzer->work, 1, INPUT_LIMIT, file);
    fclose(file);
    return run_input(fuzzer, fuzzer->work, size);
}

static int run_path(fuzzer* fuzzer, const char* path) {
    struct stat info;
    if (stat(path, &info) != 0 || !S_ISDIR(info.st_mode)) return run_file(fuzzer, path);
    struct dirent** entries;
    int failed = 0, count = scandir(path, &entries, NULL, alphasort); /* sorted: the same run on every file system */
    for (int i = 0; i < count; i++) {
        char inner[4096];
        snprintf(inner, sizeof inner, "%s/%s", path, entries[i]->d_name);
        if (entries[i]->d_name[0] != '.') failed |= run_path(fuzzer, inner);
        free(entries[i]);
    }
    if (count >= 0) free(entries);
    return failed || count < 0;
}

int main(int argc, char** argv) {
    fuzzer fuzzer = {.work = malloc(INPUT_LIMIT)};
    uint64_t seed = 1, mutations = 1000;
    int first = 1, failed = 0;
    for (; first + 1 < argc && argv[first][0] == '-'; first += 2) {
        uint64_t value = strtoull(argv[first + 1], NULL, 10);
        if (strcmp(argv[first], "-n") == 0)
            mutations = value;
        else if (strcmp(argv[first], "-s") == 0)
            seed = value;
        else
            break;
    }
    if (fuzzer.work == NULL || (first < argc && argv[first][0] == '-')) {
        fprintf(stderr, "usage: %s [-n mutations] [-s seed] [path...]\n", argv[0]);
        return 2;
    }
    fuzzer.random = dmi_random_make(seed, 0);
    if (first == argc) failed = run_input(&fuzzer, (const uint8_t*)"", 0);
    for (int i = first; i < argc; i++) failed |= run_path(&fuzzer, argv[i]);
    for (uint64_t m = 0; m < mutations && fuzzer.input_count > 0; m++) run_mutation(&fuzzer);
    printf("%llu inputs\n", (unsigned long long)fuzzer.runs);
    for (size_t i = 0; i < fuzzer.input_count; i++) free(fuzzer.inputs[i].bytes);
    free(fuzzer.inputs);
    free(fuzzer.work);
    return failed;
}
