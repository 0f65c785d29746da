/* Files and arguments by the calls of the operating system: wide characters on Windows, POSIX elsewhere. */
#include "platform.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <string.h>
#include <sys/stat.h>

#include <dirent.h>

enum { PROGRAM_NAME = 64 }; /* bytes of the longest name of a program, a separator before it; by hand */

#if defined(_WIN32)

#include <direct.h>
#include <io.h>
#include <process.h>
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

static bool read_info(const char* path, struct stat* out) {
    wchar_t wide[WIDE_PATH];
    struct _stat64 info;
    if (!widen(path, wide, WIDE_PATH) || _wstat64(wide, &info) != 0) return false;
    out->st_mode = info.st_mode;
    out->st_mtime = info.st_mtime;
    return true;
}

bool platform_may_write(const char* path) {
    wchar_t wide[WIDE_PATH];
    const int descriptor = widen(path, wide, WIDE_PATH) ? _wopen(wide, _O_WRONLY | _O_BINARY | _O_NOINHERIT) : -1;
    return descriptor >= 0 && close(descriptor) == 0;
}

static int create_descriptor(const char* path) {
    wchar_t wide[WIDE_PATH];
    if (!widen(path, wide, WIDE_PATH)) return -1;
    return _wopen(wide, _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}

void platform_copy_mode(const char* path, FILE* to) {
    (void)path;
    (void)to;
}

int platform_sync(FILE* file) {
    return _commit(_fileno(file));
}

enum {
    RENAMES = 100,
    RENAME_WAIT = 10
}; /* tries and ms between them: a reader holds the old file for as long; by hand */

int platform_replace(const char* from, const char* to) {
    wchar_t wide_from[WIDE_PATH], wide_to[WIDE_PATH];
    if (!widen(from, wide_from, WIDE_PATH) || !widen(to, wide_to, WIDE_PATH)) return -1;
    for (int i = 0; i < RENAMES; i++) {
        if (MoveFileExW(wide_from, wide_to, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH)) return 0;
        const DWORD reason = GetLastError();
        errno = reason == ERROR_DISK_FULL ? ENOSPC : EACCES;
        if (reason != ERROR_ACCESS_DENIED && reason != ERROR_SHARING_VIOLATION) return -1;
        Sleep(RENAME_WAIT);
    }
    return -1;
}

void platform_remove(const char* path) {
    wchar_t wide[WIDE_PATH];
    if (widen(path, wide, WIDE_PATH)) _wunlink(wide);
}

bool platform_read_link(const char* path, char* out, size_t size) {
    (void)path;
    (void)out;
    (void)size;
    return false;
}

bool platform_is_separator(char c) {
    return c == '/' || c == '\\' || c == ':';
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

/* Adds an argument to a command line as CommandLineToArgvW takes it apart. Returns false where there is no room. */
static bool append_argument(const char* argument, char* line, size_t size) {
    size_t used = strlen(line), slashes = 0;
    if (used + 2 * strlen(argument) + 4 > size) return false;
    if (used > 0) line[used++] = ' ';
    line[used++] = '"';
    for (const char* c = argument; *c != 0; c++) {
        if (*c == '"')
            for (size_t i = 0; i <= slashes; i++) line[used++] = '\\';
        slashes = *c == '\\' ? slashes + 1 : 0;
        line[used++] = *c;
    }
    for (size_t i = 0; i < slashes; i++) line[used++] = '\\';
    line[used++] = '"';
    line[used] = 0;
    return true;
}

static bool start_program(const wchar_t* program, wchar_t* line, platform_child* out_child) {
    STARTUPINFOW start = {.cb = sizeof start};
    PROCESS_INFORMATION made;
    if (!CreateProcessW(program, line, NULL, NULL, TRUE, 0, NULL, NULL, &start, &made)) {
        errno = GetLastError() == ERROR_FILE_NOT_FOUND ? ENOENT : EAGAIN;
        return false;
    }
    CloseHandle(made.hThread);
    out_child->process = (intptr_t)made.hProcess;
    return true;
}

bool platform_start_child(char* const* arguments, platform_child* out_child) {
    static char line[2 * WIDE_PATH];
    static wchar_t program[WIDE_PATH], wide[2 * WIDE_PATH];
    const DWORD length = GetModuleFileNameW(NULL, program, WIDE_PATH);
    line[0] = 0;
    errno = E2BIG;
    for (int i = 0; arguments[i] != NULL; i++)
        if (!append_argument(arguments[i], line, sizeof line)) return false;
    if (length == 0 || length == WIDE_PATH || !widen(line, wide, 2 * WIDE_PATH)) return false;
    return start_program(program, wide, out_child);
}

/* Windows can't replace a running program: this one waits for the other one, and ends with its status. */
void platform_become(const char* name, char* const* arguments) {
    (void)arguments; /* the other program reads the same line */
    char folder[WIDE_PATH], path[WIDE_PATH + PROGRAM_NAME];
    wchar_t wide[WIDE_PATH];
    platform_child child;
    DWORD status;
    errno = ENAMETOOLONG;
    if (!platform_program_folder(folder, sizeof folder)) return;
    snprintf(path, sizeof path, "%s\\%s.exe", folder, name);
    wchar_t* line = _wcsdup(GetCommandLineW());
    if (line != NULL && widen(path, wide, WIDE_PATH) && start_program(wide, line, &child)) {
        WaitForSingleObject((HANDLE)child.process, INFINITE);
        exit(GetExitCodeProcess((HANDLE)child.process, &status) ? (int)status : EXIT_FAILURE);
    }
    free(line);
}

int platform_wait_child(const platform_child* children, int count, int* out_status) {
    HANDLE handles[MAXIMUM_WAIT_OBJECTS] = {NULL};
    const DWORD waited = count < MAXIMUM_WAIT_OBJECTS ? (DWORD)count : MAXIMUM_WAIT_OBJECTS;
    for (DWORD i = 0; i < waited; i++) handles[i] = (HANDLE)children[i].process;
    const DWORD ended = WaitForMultipleObjects(waited, handles, FALSE, INFINITE) - WAIT_OBJECT_0;
    DWORD status = 0;
    if (ended >= waited || !GetExitCodeProcess(handles[ended], &status)) exit(EXIT_FAILURE);
    CloseHandle(handles[ended]);
    *out_status = status <= INT_MAX ? (int)status : -1;
    return (int)ended;
}

#else

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

extern char** environ;

bool platform_start_child(char* const* arguments, platform_child* out_child) {
    pid_t process;
    errno = posix_spawn(&process, "/proc/self/exe", NULL, NULL, arguments, environ);
    if (errno != 0) return false;
    out_child->process = process;
    return true;
}

int platform_wait_child(const platform_child* children, int count, int* out_status) {
    for (;;) {
        int status;
        const pid_t ended = wait(&status);
        if (ended < 0 && errno != EINTR) exit(EXIT_FAILURE);
        for (int i = 0; i < count; i++) {
            if (children[i].process != ended) continue;
            *out_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
            return i;
        }
    }
}

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

static bool read_info(const char* path, struct stat* out) {
    return stat(path, out) == 0;
}

bool platform_may_write(const char* path) {
    const int descriptor = open(path, O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    return descriptor >= 0 && close(descriptor) == 0;
}

static int create_descriptor(const char* path) {
    return open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

/* Where the owner stays another, rights to run as the owner go. */
void platform_copy_mode(const char* path, FILE* to) {
    struct stat old = {0}, new = {0};
    const int descriptor = fileno(to);
    if (stat(path, &old) != 0 || fstat(descriptor, &new) != 0) return;
    const bool same = old.st_uid == new.st_uid&& old.st_gid == new.st_gid;
    const mode_t most = same || fchown(descriptor, old.st_uid, old.st_gid) == 0 ? 07777 : 0777;
    if ((old.st_mode & 07777) != (new.st_mode & 07777)) fchmod(descriptor, old.st_mode & most);
}

/* Some file systems can't wait (EINVAL); there the file is as safe as it gets. */
int platform_sync(FILE* file) {
    return fsync(fileno(file)) == 0 || errno == EINVAL ? 0 : -1;
}

int platform_replace(const char* from, const char* to) {
    return rename(from, to);
}

void platform_remove(const char* path) {
    unlink(path);
}

bool platform_read_link(const char* path, char* out, size_t size) {
    const ssize_t length = readlink(path, out, size - 1);
    if (length <= 0) return false;
    out[length] = 0;
    return true;
}

bool platform_is_separator(char c) {
    return c == '/';
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

#if defined(__APPLE__)
static bool read_program_path(char* out_path, size_t size) {
    char given[PATH_MAX], real[PATH_MAX]; /* real: without links */
    uint32_t room = sizeof given;
    if (_NSGetExecutablePath(given, &room) != 0 || realpath(given, real) == NULL) return false;
    return snprintf(out_path, size, "%s", real) < (int)size;
}
#else
static bool read_program_path(char* out_path, size_t size) {
    return platform_read_link("/proc/self/exe", out_path, size);
}
#endif

bool platform_program_folder(char* out_path, size_t size) {
    if (!read_program_path(out_path, size)) return false;
    *strrchr(out_path, '/') = 0;
    return true;
}

void platform_become(const char* name, char* const* arguments) {
    char folder[PATH_MAX], path[PATH_MAX + PROGRAM_NAME];
    errno = ENAMETOOLONG;
    if (!platform_program_folder(folder, sizeof folder)) return;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    execv(path, arguments);
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

double platform_modified(const char* path) {
    struct stat info = {0};
    return read_info(path, &info) ? (double)info.st_mtime : 0;
}

enum platform_kind platform_kind_of(const char* path) {
    struct stat info = {0};
    if (!read_info(path, &info)) return PLATFORM_NOTHING;
    if (S_ISDIR(info.st_mode)) return PLATFORM_FOLDER;
    return S_ISREG(info.st_mode) ? PLATFORM_FILE : PLATFORM_STREAM;
}

FILE* platform_create(const char* path) {
    const int descriptor = create_descriptor(path);
    return descriptor >= 0 ? fdopen(descriptor, "wb") : NULL;
}

FILE* platform_duplicate(int descriptor) {
    const int copy = dup(descriptor);
    return copy >= 0 ? fdopen(copy, "wb") : NULL;
}

long platform_process(void) {
    return (long)getpid();
}
