/* What differs between operating systems and compilers, for the programs here: files by UTF-8 paths, arguments, memory.
 * platform.c has the functions that are not inline. */
#ifndef SAMPLES_PLATFORM_H
#define SAMPLES_PLATFORM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#if defined(_WIN32)
#include <malloc.h>
#endif

#if defined(__MINGW32__) && !defined(__clang__)
#define PLATFORM_PRINTF(text, first) __attribute__((format(gnu_printf, text, first)))
#elif defined(__GNUC__)
#define PLATFORM_PRINTF(text, first) __attribute__((format(printf, text, first)))
#else
#define PLATFORM_PRINTF(text, first)
#endif

/* Whether the processor has an instruction set, and the operating system keeps its registers. */
#define PLATFORM_CPU_HAS(set) __builtin_cpu_supports(set)

/* To be called first in main. On Windows it replaces the arguments by their UTF-8 and makes the standard streams
 * binary, as they are elsewhere. Elsewhere it keeps files from taking the place of a closed standard stream. */
void platform_start(int* argc, char*** argv);

/* fopen, by modes "rb" and "wb": text is written as it is elsewhere. */
FILE* platform_open(const char* path, const char* mode);
/* Opens a regular file for reading; NULL with errno set. Pipes and devices, which may never end, are no files: EINVAL.
 * A folder: EISDIR. */
FILE* platform_open_regular(const char* path);
bool platform_exists(const char* path);

/* What lies at a path, links followed. */
enum platform_kind { PLATFORM_NOTHING, PLATFORM_FILE, PLATFORM_FOLDER, PLATFORM_STREAM /* a pipe or a device */ };
enum platform_kind platform_kind_of(const char* path);
/* Whether an existing file may be written; false with errno set. Changes nothing. */
bool platform_may_write(const char* path);
/* Opens a new file for writing; NULL with errno EEXIST where there is one of that name. */
FILE* platform_create(const char* path);
/* Opens for writing what a descriptor of this program writes to, by a descriptor of its own. */
FILE* platform_duplicate(int descriptor);
/* Gives an open file the mode, and as far as the system lets it the owner, of the file at a path. */
void platform_copy_mode(const char* path, FILE* to);
/* Waits until the disk has what was flushed. 0, or -1 with errno set. */
int platform_sync(FILE* file);
/* Renames a file, in place of one that is there. 0, or -1 with errno set. */
int platform_replace(const char* from, const char* to);
void platform_remove(const char* path);
/* Writes what the link at a path names; false where there is no link. */
bool platform_read_link(const char* path, char* out, size_t size);
bool platform_is_separator(char c);
/* Id of the running program. */
long platform_process(void);

/* 0, or -1 with errno set. */
int platform_make_folder(const char* path);
/* Calls entry(user, name) for each name in a folder, in no order; false when there is no such folder. */
bool platform_list(const char* folder, void (*entry)(void* user, const char* name), void* user);
/* Writes the folder of the running program; false when it is unknown. */
bool platform_program_folder(char* out_path, size_t size);

/* When a file was last written, s since 1970; 0: there is none. */
double platform_modified(const char* path);

/* Ends this program with what the program `name` of its folder does, which gets the same standard streams and
 * arguments, those of main. Returns, with errno set, where that one can't be run. */
void platform_become(const char* name, char* const* arguments);

/* A process that this program has started. */
typedef struct platform_child {
    intptr_t process;
} platform_child;
/* Runs this program once more, with arguments that a NULL ends. Returns false with errno set on failure. */
bool platform_start_child(char* const* arguments, platform_child* out_child);
/* Waits for one of the children. Returns its index and its exit status, -1 where a signal or an exception ended it. */
int platform_wait_child(const platform_child* children, int count, int* out_status);

/* alignment: a power of two, at least that of a pointer. */
static inline void* platform_allocate(size_t size, size_t alignment) {
#if defined(_WIN32)
    return _aligned_malloc(size, alignment);
#else
    return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
#endif
}

static inline void platform_release(void* memory) {
#if defined(_WIN32)
    _aligned_free(memory);
#else
    free(memory);
#endif
}

/* getc without a lock. */
static inline int platform_getc(FILE* file) {
#if defined(_WIN32)
    return _getc_nolock(file);
#else
    return getc_unlocked(file);
#endif
}

#endif
