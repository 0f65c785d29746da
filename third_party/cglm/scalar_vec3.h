/* cglm's vectors of three floats, without vector instructions. */
#ifndef DMI_CGLM_SCALAR_VEC3_H
#define DMI_CGLM_SCALAR_VEC3_H

#pragma GCC system_header /* cglm compares floats with doubles, and so on: not ours to warn of */

#include "begin_scalar.h"

#include "upstream/vec3.h"

#include "end_scalar.h"

#endif
