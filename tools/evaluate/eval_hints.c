/* Tells the library what the dataset says of a joint, or a lie. */
#include "eval_hints.h"

#include <string.h>

int eval_hints_of(const char* name) {
    if (strcmp(name, "names") == 0) return HINTS_NAMES;
    if (strcmp(name, "pivots") == 0) return HINTS_PIVOTS;
    return strcmp(name, "both") == 0 ? HINTS_NAMES | HINTS_PIVOTS : 0;
}

dm_pivot eval_hints_pivot(vec origin, const vec axes[3]) {
    dm_pivot pivot = {.origin = vec_out(origin)};
    for (int i = 0; i < 3; i++) {
        const float row[3] = {(float)axes[i].x, (float)axes[i].y, (float)axes[i].z};
        memcpy(pivot.axes + 3 * (size_t)i, row, sizeof row);
    }
    return pivot;
}

static void enter_pivot(vec origin, const vec axes[3], job* out) {
    out->has_pivot = 1;
    out->no_pivot = 0;
    out->pivot = eval_hints_pivot(origin, axes);
}

/* Draws a point of the box and three perpendicular directions. */
static void enter_lying_pivot(vec low, vec high, random_state* random, job* out) {
    const double x = random_unit(random), y = random_unit(random), z = random_unit(random);
    const vec side = sub(high, low), at = add(low, (vec){x * side.x, y * side.y, z * side.z});
    const vec first = {random_normal(random), random_normal(random), random_normal(random)};
    const vec second = {random_normal(random), random_normal(random), random_normal(random)};
    const vec a = unit(first), b = unit(cross(a, second)), axes[3] = {a, b, cross(a, b)};
    enter_pivot(at, axes, out);
}

/* Returns the label of the next joint; of an object's only joint, one of the other type. */
static const char* lying_label(const known_object* object, int index) {
    if (object->joint_count > 1) return object->joints[(index + 1) % object->joint_count].label;
    return object->joints[index].slides ? "Scene/Lid" : "Scene/Drawer";
}

void eval_hints_set(int which, double lies, const known_object* object, int index, vec low, vec high,
                    random_state* random, job* out) {
    const known_joint* joint = &object->joints[index];
    const bool lie = lies > 0 && random_unit(random) < lies;
    out->label = "";
    out->no_pivot = 1;
    out->up = vec_out(object->up_direction);
    if (which & HINTS_NAMES) out->label = lie ? lying_label(object, index) : joint->label;
    if (!(which & HINTS_PIVOTS) || !joint->has_pivot) return;
    if (lie)
        enter_lying_pivot(low, high, random, out);
    else
        enter_pivot(joint->pivot, joint->pivot_axes, out);
}
