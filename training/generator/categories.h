/* Every category: one function that draws it, one row here that names it. */
#ifndef DMG_CATEGORIES_H
#define DMG_CATEGORIES_H

#include "build.h"

#define DMG_CATEGORIES(X)                                                                                              \
    /* storage.c */                                                                                                    \
    X(kitchen_cabinet)                                                                                                 \
    X(cabinet)                                                                                                         \
    X(drawers)                                                                                                         \
    /* appliances.c */                                                                                                 \
    X(microwave)                                                                                                       \
    X(oven)                                                                                                            \
    /* lids.c */                                                                                                       \
    X(chest)                                                                                                           \
    X(bucket)                                                                                                          \
    /* slabs.c */                                                                                                      \
    X(laptop)                                                                                                          \
    /* openings.c */                                                                                                   \
    X(door)                                                                                                            \
    X(sliding_window)                                                                                                  \
    /* controls.c */                                                                                                   \
    X(knob)                                                                                                            \
    X(faucet)                                                                                                          \
    X(button)                                                                                                          \
    /* wheels.c */                                                                                                     \
    X(wheel)

#define DMG_DECLARE(name) void dmg_build_##name(dmg_builder* b);
DMG_CATEGORIES(DMG_DECLARE)
#undef DMG_DECLARE

#endif
