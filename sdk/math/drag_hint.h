/* A drag as input of joint inference: the grabbed point and the direction of the pull. */
#ifndef DMI_MATH_DRAG_HINT_H
#define DMI_MATH_DRAG_HINT_H

/* A drag that is evidence for a joint, in the object-normalised frame. */
typedef struct dmi_drag_hint {
    float point[3];
    float vector[3]; /* non-zero */
} dmi_drag_hint;

#endif
