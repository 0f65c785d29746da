/* The floating-point environment that the library computes in, whatever the host's is: to the nearest, denormal numbers
 * kept, no exception trapped. */
#ifndef DMI_BASE_FP_ENVIRONMENT_H
#define DMI_BASE_FP_ENVIRONMENT_H

#include "base/compiler.h"

#if defined(__SSE__)
#define DMI_FP_OWN 0x1f80   /* MXCSR with all exceptions masked */
#define DMI_FP_STATUS 0x3fu /* its flags of what has happened */
#else
#define DMI_FP_OWN 0 /* FPCR of Arm, as after a reset */
#define DMI_FP_STATUS 0u
#endif

/* Takes the library's environment; returns the host's. */
static inline uint64_t dmi_fp_take(void) {
    const uint64_t host = dmi_fp_control();
    if ((host & ~(uint64_t)DMI_FP_STATUS) != DMI_FP_OWN) dmi_set_fp_control(DMI_FP_OWN);
    return host;
}

/* Gives the host's back, its flags with it. Where it was the library's own, the flags stay as they are. */
static inline void dmi_fp_give_back(const uint64_t* host) {
    if ((*host & ~(uint64_t)DMI_FP_STATUS) != DMI_FP_OWN) dmi_set_fp_control(*host);
}

/* First in a function that the host calls: its body runs in the library's environment. */
#define DMI_OWN_FP DMI_AT_EXIT(dmi_fp_give_back) const uint64_t host_fp = dmi_fp_take()

#endif
