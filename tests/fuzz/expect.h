/* What must hold of every answer. An expectation that fails ends the process, which a fuzzer takes for a crash. */
#ifndef DM_FUZZ_EXPECT_H
#define DM_FUZZ_EXPECT_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "dragmesh/dragmesh.h"

#define FUZZ_UNIT_TOLERANCE 1e-3f /* of a squared length; by hand */

/* Like assert, in every configuration. */
#define fuzz_expect(right) fuzz_expect_at(right, #right, __FILE__, __LINE__)

static inline void fuzz_expect_at(bool right, const char* text, const char* file, int line) {
    if (right) return;
    fprintf(stderr, "%s:%d: not so: %s\n", file, line, text);
    abort();
}

static inline void fuzz_expect_result(dm_result result) {
    fuzz_expect(result <= DM_OK && result > DM_ERROR_INTERNAL);
}

static inline void fuzz_expect_finite(const float* numbers, size_t count) {
    for (size_t i = 0; i < count; i++) fuzz_expect(isfinite(numbers[i]));
}

static inline void fuzz_expect_vector(const dm_vec3* vector) {
    fuzz_expect_finite(&vector->x, 3);
}

/* A box that has a size, or none. */
static inline void fuzz_expect_box(const dm_vec3* low, const dm_vec3* high) {
    fuzz_expect_vector(low);
    fuzz_expect_vector(high);
    fuzz_expect(low->x <= high->x && low->y <= high->y && low->z <= high->z);
}

static inline void fuzz_expect_pose(const dm_pose* pose) {
    float square = 0;
    fuzz_expect_finite(pose->real, 4);
    fuzz_expect_finite(pose->dual, 4);
    for (int i = 0; i < 4; i++) square += pose->real[i] * pose->real[i];
    fuzz_expect(fabsf(square - 1) < FUZZ_UNIT_TOLERANCE);
}

/* A joint that came from the host, whatever its axis and type. */
static inline void fuzz_expect_finite_joint(const dm_joint* joint) {
    const float numbers[5] = {joint->type_confidence, joint->joint_confidence, joint->pitch, joint->lower,
                              joint->upper};
    fuzz_expect_finite(numbers, 5);
    fuzz_expect_vector(&joint->axis);
    fuzz_expect_vector(&joint->origin);
}

/* A joint of an object. */
static inline void fuzz_expect_joint(const dm_joint* joint) {
    const dm_vec3* a = &joint->axis;
    fuzz_expect_finite_joint(joint);
    fuzz_expect(joint->type >= DM_JOINT_REVOLUTE && joint->type <= DM_JOINT_FIXED && joint->lower <= joint->upper);
    fuzz_expect(fabsf(a->x * a->x + a->y * a->y + a->z * a->z - 1) < FUZZ_UNIT_TOLERANCE);
    fuzz_expect(joint->type_confidence >= 0 && joint->type_confidence <= 1);
    fuzz_expect(joint->joint_confidence >= 0 && joint->joint_confidence <= 1);
}

static inline void fuzz_expect_state(const dm_drag_state* state) {
    const float numbers[4] = {state->value, state->target, state->velocity, state->impact};
    fuzz_expect_finite(numbers, 4);
    fuzz_expect_vector(&state->grab_point);
    fuzz_expect_pose(&state->pose);
}

#endif
