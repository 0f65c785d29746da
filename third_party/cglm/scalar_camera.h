/* cglm's vectors, matrices, cameras and projections, without vector instructions. */
#ifndef DMI_CGLM_SCALAR_CAMERA_H
#define DMI_CGLM_SCALAR_CAMERA_H

#pragma GCC system_header /* cglm compares floats with doubles, and so on: not ours to warn of */

#include "begin_scalar.h"

#include "upstream/cam.h"
#include "upstream/quat.h"

#include "upstream/project.h" /* after quat.h: it calls what that one includes */

#include "end_scalar.h"

#endif
