/* Opens, reads and finds files with the calls of the operating system. */
#include "gltf/gltf_disk.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Most bytes of one read. Windows counts them in 32 bits. */
#define READ_MOST ((size_t)1 << 30)

#if defined(_WIN32)

#include <io.h>
#include <windows.h>

typedef struct _stat64 file_info;
typedef int read_count;

/* Writes `path` as UTF-16. Returns false with errno set where it is too long or not UTF-8. */
static bool widen(const char* path, wchar_t out[DMI_DISK_PATH]) {
    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, out, DMI_DISK_PATH) > 0) return true;
    errno = GetLastError() == ERROR_INSUFFICIENT_BUFFER ? ENAMETOOLONG : EILSEQ;
    return false;
}

/* Opens a file. _wopen answers EACCES for a folder. */
static int open_descriptor(const char* path) {
    wchar_t wide[DMI_DISK_PATH];
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

void dmi_disk_close(int file) {
    _close(file);
}

bool dmi_disk_real_path(const char* path, char out[DMI_DISK_PATH]) {
    wchar_t wide[DMI_DISK_PATH];
    if (!widen(path, wide)) return false;
    const HANDLE file =
        CreateFileW(wide, 0, FILE_SHARE_READ | FILE_SHARE_WRITE, NULL, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL);
    if (file == INVALID_HANDLE_VALUE) return false;
    const DWORD length = GetFinalPathNameByHandleW(file, wide, DMI_DISK_PATH, FILE_NAME_NORMALIZED);
    CloseHandle(file);
    if (length == 0 || length >= DMI_DISK_PATH) return false;
    if (WideCharToMultiByte(CP_UTF8, 0, wide, -1, out, DMI_DISK_PATH, NULL, NULL) == 0) return false;
    for (char* at = out; *at; at++) {
        if (*at == '\\') *at = '/';
    }
    return true;
}

const char* dmi_disk_last_separator(const char* path) {
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

void dmi_disk_close(int file) {
    close(file);
}

bool dmi_disk_real_path(const char* path, char out[DMI_DISK_PATH]) {
    _Static_assert(PATH_MAX <= DMI_DISK_PATH, "realpath writes as much");
    return realpath(path, out) != NULL;
}

const char* dmi_disk_last_separator(const char* path) {
    return strrchr(path, '/');
}

#endif

int dmi_disk_open(const char* path, uint64_t* out_size) {
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
    dmi_disk_close(file);
    errno = reason;
    return -1;
}

bool dmi_disk_read(int file, void* data, size_t size) {
    size_t have = 0;
    while (have < size) {
        const size_t left = size - have;
        const read_count got = read_some(file, (uint8_t*)data + have, left < READ_MOST ? left : READ_MOST);
        if (got <= 0) return false;
        have += (size_t)got;
    }
    return true;
}
