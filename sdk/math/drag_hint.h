/* A drag as evidence about a joint: where the player takes hold of the part, and which way the pull goes. */
#ifndef DMI_MATH_DRAG_HINT_H
#define DMI_MATH_DRAG_HINT_H

/* In the object-normalised frame. */
typedef struct dmi_drag_hint {
    float point[3];
    float vector[3]; /* non-zero */
} dmi_drag_hint;

#endif
