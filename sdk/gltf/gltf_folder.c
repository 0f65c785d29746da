/* The one place that opens files: it reads a document, and the files beside it, from its folder and from nowhere else.
 * Paths are UTF-8, wide characters on Windows, POSIX elsewhere. */
#include "gltf/gltf_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define PATH_SIZE 4096 /* bytes of the longest path; Linux' limit */
/* Most bytes of one read. Windows counts them in 32 bits. */
#define READ_MOST ((size_t)1 << 30)

#if defined(_WIN32)

#include <io.h>
#include <windows.h>

typedef struct _stat64 file_info;
typedef int read_count;

/* Writes `path` as UTF-16. Returns false with errno set where it is too long or not UTF-8. */
static bool widen(const char* path, wchar_t out[PATH_SIZE]) {
    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, out, PATH_SIZE) > 0) return true;
    errno = GetLastError() == ERROR_INSUFFICIENT_BUFFER ? ENAMETOOLONG : EILSEQ;
    return false;
}

/* Opens a file. _wopen answers EACCES for a folder. */
static int open_descriptor(const char* path) {
    wchar_t wide[PATH_SIZE];
    file_info info;
    if (!widen(path, wide)) return -1;
    if (_wstat64(wide, &info) == 0 && (info.st_mode & _S_IFMT) == _S_IFDIR) {
        errno = EISDIR;
        return -1;
    }
    return _wopen(wide, _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

static int get_info(int file, file_info* out) {
    return _fstat64(file, out);
}

static read_count read_some(int file, void* data, size_t size) {
    return _read(file, data, (unsigned)size);
}

static void close_file(int file) {
    _close(file);
}

/* Writes the absolute path without links, with '/' between names. Returns false when there is no such file. */
static bool find_real_path(const char* path, char out[PATH_SIZE]) {
    wchar_t wide[PATH_SIZE];
    if (!widen(path, wide)) return false;
    const HANDLE file =
        CreateFileW(wide, 0, FILE_SHARE_READ | FILE_SHARE_WRITE, NULL, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL);
    if (file == INVALID_HANDLE_VALUE) return false;
    const DWORD length = GetFinalPathNameByHandleW(file, wide, PATH_SIZE, FILE_NAME_NORMALIZED);
    CloseHandle(file);
    if (length == 0 || length >= PATH_SIZE) return false;
    if (WideCharToMultiByte(CP_UTF8, 0, wide, -1, out, PATH_SIZE, NULL, NULL) == 0) return false;
    for (char* at = out; *at; at++) {
        if (*at == '\\') *at = '/';
    }
    return true;
}

const char* dmi_gltf_last_separator(const char* path) {
    const char *slash = strrchr(path, '/'), *back = strrchr(path, '\\');
    return slash != NULL && (back == NULL || slash > back) ? slash : back;
}

#else

#include <limits.h>
#include <unistd.h>

typedef struct stat file_info;
typedef ssize_t read_count;

static int open_descriptor(const char* path) {
    return open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK); /* a pipe without a writer opens too */
}

static int get_info(int file, file_info* out) {
    return fstat(file, out);
}

static read_count read_some(int file, void* data, size_t size) {
    return read(file, data, size);
}

static void close_file(int file) {
    close(file);
}

static bool find_real_path(const char* path, char out[PATH_SIZE]) {
    _Static_assert(PATH_MAX <= PATH_SIZE, "realpath writes as much");
    return realpath(path, out) != NULL;
}

const char* dmi_gltf_last_separator(const char* path) {
    return strrchr(path, '/');
}

#endif

/* Opens a regular file for reading and writes its size. Returns a descriptor, or -1 with errno set. Pipes and devices,
 * which may never end, are refused with EINVAL, a folder with EISDIR. */
static int open_file(const char* path, uint64_t* out_size) {
    file_info info;
    const int file = open_descriptor(path);
    if (file < 0) return -1;
    int reason = errno;
    if (get_info(file, &info) == 0) {
        if (S_ISREG(info.st_mode)) {
            *out_size = (uint64_t)info.st_size;
            return file;
        }
        reason = S_ISDIR(info.st_mode) ? EISDIR : EINVAL;
    }
    close_file(file);
    errno = reason;
    return -1;
}

/* Reads all of `size` bytes. Returns false when there are fewer. */
static bool read_bytes(int file, void* data, size_t size) {
    size_t have = 0;
    while (have < size) {
        const size_t left = size - have;
        const read_count got = read_some(file, (uint8_t*)data + have, left < READ_MOST ? left : READ_MOST);
        if (got <= 0) return false;
        have += (size_t)got;
    }
    return true;
}

/* ---- the folder of a document ---- */

/* Reads all that the file has. Returns DM_OK, NOT_FOUND with errno set, OUT_OF_MEMORY or TOO_LARGE. */
static dm_result read_descriptor(dmi_env* env, int file, uint64_t size, dmi_gltf_contents* out) {
    if (size > UINT32_MAX) return DM_ERROR_TOO_LARGE;
    out->size = (size_t)size;
    out->data = dmi_alloc(env, out->size, 16);
    if (!out->data) return DM_ERROR_OUT_OF_MEMORY;
    if (read_bytes(file, out->data, out->size)) return DM_OK;
    dmi_free(env, out->data, out->size);
    errno = EIO;
    return DM_ERROR_NOT_FOUND;
}

dm_result dmi_gltf_read_file(dmi_env* env, const char* path, dmi_gltf_contents* out) {
    uint64_t size;
    const int file = open_file(path, &size);
    if (file < 0) return DM_ERROR_NOT_FOUND;
    const dm_result result = read_descriptor(env, file, size, out);
    const int reason = errno;
    close_file(file);
    errno = reason;
    return result;
}

/* Writes the file's path. Returns 0 when links lead out of the folder. */
static int find_inside(const char* folder, const char* path, char out[PATH_SIZE]) {
    char base[PATH_SIZE], joined[PATH_SIZE];
    if (!find_real_path(folder, base)) return 0;
    const size_t length = strlen(base), whole = (size_t)snprintf(joined, sizeof joined, "%s/%s", base, path);
    if (whole >= sizeof joined || !find_real_path(joined, out)) return 0;
    return strcmp(base, "/") == 0 || (strncmp(out, base, length) == 0 && out[length] == '/');
}

static int32_t DM_CALL open_beside(void* user, const char* path, const void** out_data, size_t* out_size) {
    dm_gltf* gltf = user;
    char inside[PATH_SIZE];
    dmi_gltf_contents found;
    if (!find_inside(gltf->on_disk.folder, path, inside)) return DM_ERROR_NOT_FOUND;
    const dm_result result = dmi_gltf_read_file(&gltf->env, inside, &found);
    if (result != DM_OK) return result;
    *out_data = found.data;
    *out_size = found.size;
    return DM_OK;
}

static void DM_CALL close_beside(void* user, const void* data, size_t size) {
    dm_gltf* gltf = user;
    dmi_free(&gltf->env, (void*)data, size);
}

dm_gltf_files dmi_gltf_folder_files(dm_gltf* gltf) {
    return (dm_gltf_files){.user = gltf, .open = open_beside, .close = close_beside};
}
