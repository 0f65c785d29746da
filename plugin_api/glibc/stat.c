/* stat and fstat, which were inline functions of the header before glibc 2.33. */
#include "pin.h"

#include <sys/stat.h>

#if defined(__x86_64__)
#define STAT_VERSION 1 /* glibc's _STAT_VER: the layout of struct stat */
#else
#define STAT_VERSION 0
#endif

#if defined(DMI_PIN_GLIBC) /* elsewhere Debian 12's linker would leave nameless symbols of what nothing calls */

PIN(__fxstat);
PIN(__xstat);

int pinned___fxstat(int version, int file, struct stat* out);
int pinned___xstat(int version, const char* path, struct stat* out);

int __wrap_fstat(int file, struct stat* out);
int __wrap_stat(const char* path, struct stat* out);

int __wrap_fstat(int file, struct stat* out) {
    return pinned___fxstat(STAT_VERSION, file, out);
}

int __wrap_stat(const char* path, struct stat* out) {
    return pinned___xstat(STAT_VERSION, path, out);
}

#endif
