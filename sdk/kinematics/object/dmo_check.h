/* Checks of numbers read from a .dmo file. */
#ifndef DMI_OBJECT_DMO_CHECK_H
#define DMI_OBJECT_DMO_CHECK_H

#include <stdbool.h>

#include "kinematics/object/object.h"

/* Object-normalised coordinates of a surface lie within 0.5, those of unused vertices within 1. */
#define DMI_DMO_MAX_COORDINATE 1.0f

/* Each of these functions returns whether the values are ones that an object may have. A NaN never is. */
bool dmi_dmo_within(const float* values, size_t count, float limit); /* |values[i]| <= limit */
bool dmi_dmo_valid_object(const dmi_object* object);                 /* frame, box and counts */
bool dmi_dmo_valid_shape(const dmi_part* shape);
bool dmi_dmo_valid_tree(const dmi_object* object);       /* ids rise, every chain of parents ends at the body */
bool dmi_dmo_valid_joint_numbers(const dm_joint* joint); /* checks the numbers in whatever frame they are */
/* Returns whether a joint is valid in the inner frame and in the host's, where its numbers may be too large. */
bool dmi_dmo_valid_joint(const dmi_frame* frame, const dm_joint* inner);
bool dmi_dmo_valid_alternative(const dmi_frame* frame, const dmi_alternative* alternative);

#endif
