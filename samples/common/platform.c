/* Files and arguments by the calls of the operating system: wide characters on Windows, POSIX elsewhere. */
#include "platform.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>

#include <dirent.h>

#if defined(_WIN32)

#include <direct.h>
#include <io.h>
#include <windows.h>

#include <shellapi.h>

#define WIDE_PATH 4096 /* characters of the longest path; by hand */

/* Writes `text` as UTF-16; false with errno set where it is too long or no UTF-8. */
static bool widen(const char* text, wchar_t* out, int room) {
    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, text, -1, out, room) > 0) return true;
    errno = GetLastError() == ERROR_INSUFFICIENT_BUFFER ? ENAMETOOLONG : EILSEQ;
    return false;
}

static bool narrow(const wchar_t* text, char* out, int room) {
    return WideCharToMultiByte(CP_UTF8, 0, text, -1, out, room, NULL, NULL) > 0;
}

/* The argument in new memory that lasts as long as the program. */
static char* new_argument(const wchar_t* text) {
    const int size = WideCharToMultiByte(CP_UTF8, 0, text, -1, NULL, 0, NULL, NULL);
    char* out = size > 0 ? malloc((size_t)size) : NULL;
    if (out == NULL || !narrow(text, out, size)) exit(EXIT_FAILURE);
    return out;
}

void platform_start(int* argc, char*** argv) {
    wchar_t** wide = CommandLineToArgvW(GetCommandLineW(), argc);
    char** arguments = wide != NULL ? calloc((size_t)*argc + 1, sizeof *arguments) : NULL;
    if (arguments == NULL) exit(EXIT_FAILURE);
    for (int i = 0; i < *argc; i++) arguments[i] = new_argument(wide[i]);
    LocalFree(wide);
    *argv = arguments;
    SetConsoleOutputCP(CP_UTF8);
    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
    _setmode(_fileno(stderr), _O_BINARY);
}

FILE* platform_open(const char* path, const char* mode) {
    wchar_t wide[WIDE_PATH], wide_mode[8];
    return widen(path, wide, WIDE_PATH) && widen(mode, wide_mode, 8) ? _wfopen(wide, wide_mode) : NULL;
}

static int open_descriptor(const char* path) {
    wchar_t wide[WIDE_PATH];
    struct _stat64 info;
    if (!widen(path, wide, WIDE_PATH)) return -1;
    if (_wstat64(wide, &info) == 0 && S_ISDIR(info.st_mode)) {
        errno = EISDIR;
        return -1;
    }
    return _wopen(wide, _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

bool platform_exists(const char* path) {
    wchar_t wide[WIDE_PATH];
    return widen(path, wide, WIDE_PATH) && GetFileAttributesW(wide) != INVALID_FILE_ATTRIBUTES;
}

int platform_make_folder(const char* path) {
    wchar_t wide[WIDE_PATH];
    return widen(path, wide, WIDE_PATH) ? _wmkdir(wide) : -1;
}

bool platform_list(const char* folder, void (*entry)(void* user, const char* name), void* user) {
    wchar_t wide[WIDE_PATH];
    _WDIR* directory = widen(folder, wide, WIDE_PATH) ? _wopendir(wide) : NULL;
    if (directory == NULL) return false;
    for (const struct _wdirent* found = _wreaddir(directory); found != NULL; found = _wreaddir(directory)) {
        char name[3 * sizeof found->d_name / sizeof *found->d_name + 1]; /* 3 bytes a character at the most */
        if (narrow(found->d_name, name, sizeof name)) entry(user, name);
    }
    _wclosedir(directory);
    return true;
}

bool platform_program_folder(char* out_path, size_t size) {
    wchar_t wide[WIDE_PATH];
    const DWORD length = GetModuleFileNameW(NULL, wide, WIDE_PATH);
    if (length == 0 || length == WIDE_PATH || !narrow(wide, out_path, (int)size)) return false;
    char* last = strrchr(out_path, '\\');
    if (last == NULL) return false;
    *last = 0;
    return true;
}

#else

#include <unistd.h>

/* Where a standard stream is closed, the next file that is opened would take its number, and its text. What holds the
 * number instead is open the other way round, so that the stream fails as before. */
void platform_start(int* argc, char*** argv) {
    (void)argc;
    (void)argv;
    for (int number = STDIN_FILENO; number <= STDERR_FILENO; number++) {
        if (fcntl(number, F_GETFD) == -1) open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

FILE* platform_open(const char* path, const char* mode) {
    return fopen(path, mode);
}

static int open_descriptor(const char* path) {
    return open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK); /* a pipe without a writer opens too */
}

bool platform_exists(const char* path) {
    struct stat info = {0};
    return stat(path, &info) == 0;
}

int platform_make_folder(const char* path) {
    return mkdir(path, 0777);
}

bool platform_list(const char* folder, void (*entry)(void* user, const char* name), void* user) {
    DIR* directory = opendir(folder);
    if (directory == NULL) return false;
    for (const struct dirent* found = readdir(directory); found != NULL; found = readdir(directory))
        entry(user, found->d_name);
    closedir(directory);
    return true;
}

bool platform_program_folder(char* out_path, size_t size) {
    const ssize_t length = readlink("/proc/self/exe", out_path, size - 1);
    if (length <= 0) return false;
    out_path[length] = 0;
    *strrchr(out_path, '/') = 0;
    return true;
}

#endif

FILE* platform_open_regular(const char* path) {
    struct stat info = {0};
    const int descriptor = open_descriptor(path);
    if (descriptor < 0) return NULL;
    if (fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode)) return fdopen(descriptor, "rb");
    close(descriptor);
    errno = S_ISDIR(info.st_mode) ? EISDIR : EINVAL;
    return NULL;
}
