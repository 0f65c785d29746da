/* Functions of the C library by the versions that glibc 2.31 (Debian 11, Ubuntu 20.04) has too, so that a library built
 * on a newer system runs there. The release build links with --wrap=NAME: each call of NAME goes to __wrap_NAME, which
 * calls what glibc 2.31 exports. tests/abi/symbols.sh finds a newer version that is left. */
#ifndef DMI_GLIBC_PIN_H
#define DMI_GLIBC_PIN_H

/* The version of all functions that glibc's first release for the processor had. */
#if defined(__x86_64__)
#define GLIBC_FIRST "GLIBC_2.2.5"
#elif defined(__aarch64__)
#define GLIBC_FIRST "GLIBC_2.17"
#endif

/* Makes `pinned_NAME` the first version of NAME. */
#define PIN(name) __asm__(".symver pinned_" #name "," #name "@" GLIBC_FIRST)

#endif
