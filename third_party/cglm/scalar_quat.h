/* cglm's vectors of three and four floats, matrices and quaternions, without vector instructions. */
#ifndef DMI_CGLM_SCALAR_QUAT_H
#define DMI_CGLM_SCALAR_QUAT_H

#pragma GCC system_header /* cglm compares floats with doubles, and so on: not ours to warn of */

#include "begin_scalar.h"

#include "upstream/quat.h"

#include "end_scalar.h"

#endif
