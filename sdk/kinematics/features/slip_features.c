/* Slippage: how fast the part's surface and its contacts move along their normals. By the true joint, surfaces in
 * contact slide along themselves, so these speeds are near 0. */
#include "kinematics/features/feature_groups.h"
#include "math/linear3.h"

#define SURFACE_POINTS 96    /* points of the part; by hand */
#define CONTACT_POINTS 40    /* points of a contact region, at most about twice as many; by hand */
#define LEAST_CONTACT 5      /* points; a smaller region counts as none; by hand */
#define ON_AXIS_RADIUS 0.05f /* diagonals; a point at this distance from the axis counts half as on it; by hand */
#define LEAST_SPEED 1e-9f    /* avoids a division by 0 */

/* Returns the mean speed of the part's surface, and writes its slippage: the share of that speed along the normals. */
static float surface_speed(const dmi_part_analysis* a, const dmi_candidate* c, float* out_slip) {
    float speed = 0, normal = 0;
    for (int i = 0; i < SURFACE_POINTS; i++) {
        float v[3];
        dmi_candidate_velocity(c, a->points[i], v);
        speed += dmi_length3(v);
        normal += fabsf(dmi_dot3(v, a->normals[i]));
    }
    *out_slip = normal / (speed + LEAST_SPEED);
    return speed / SURFACE_POINTS + LEAST_SPEED;
}

/* The seven columns of a contact region. */
typedef struct contact_columns {
    int part_speed, body_speed, slip, speed, on_axis, axis_offset, share;
} contact_columns;

#define COLUMNS(region)                                                                                                \
    {                                                                                                                  \
        DMI_FEATURE_##region##_PART_NORMAL_SPEED, DMI_FEATURE_##region##_BODY_NORMAL_SPEED,                            \
            DMI_FEATURE_##region##_SLIP, DMI_FEATURE_##region##_SPEED, DMI_FEATURE_##region##_ON_AXIS,                 \
            DMI_FEATURE_##region##_AXIS_OFFSET, DMI_FEATURE_##region##_SHARE                                           \
    }
static const contact_columns columns_of[DMI_CONTACT_REGIONS] = {COLUMNS(TOUCHING), COLUMNS(NEAR), COLUMNS(NEAREST)};
#undef COLUMNS

static void clear(const contact_columns* at, float row[DMI_FEATURE_COUNT]) {
    row[at->part_speed] = row[at->body_speed] = row[at->slip] = row[at->speed] = 0;
    row[at->on_axis] = row[at->axis_offset] = row[at->share] = 0;
}

static void contact_features(const dmi_part_analysis* a, const dmi_candidate* c, const dmi_contact* contact,
                             float mean_speed, const contact_columns* at, float row[DMI_FEATURE_COUNT]) {
    clear(at, row);
    if (contact->count < LEAST_CONTACT) return;
    const bool slides = dmi_candidate_slides(c);
    float part = 0, body = 0, speed = 0, on_axis = 0;
    const uint32_t step = contact->count / CONTACT_POINTS + 1;
    uint32_t n = 0;
    for (uint32_t i = 0; i < contact->count; i += step, n++) {
        const uint32_t p = contact->points[i], q = a->nearest_near[p];
        float v[3];
        dmi_candidate_velocity(c, a->points[p], v);
        const float length = dmi_length3(v), ratio = length / (ON_AXIS_RADIUS * a->diagonal);
        speed += length;
        part += fabsf(dmi_dot3(v, a->normals[p]));
        if (q != UINT32_MAX) body += fabsf(dmi_dot3(v, a->near_normals[q]));
        if (!slides) on_axis += 1 / (1 + ratio * ratio);
    }
    const float each = 1 / (float)n;
    row[at->part_speed] = part * each / mean_speed;
    row[at->body_speed] = body * each / mean_speed;
    row[at->slip] = part / (speed + LEAST_SPEED);
    row[at->speed] = speed * each / mean_speed;
    row[at->on_axis] = on_axis * each;
    row[at->axis_offset] = slides ? 0 : dmi_line_distance3(contact->mean, c->axis, c->origin) / a->diagonal;
    row[at->share] = (float)contact->count / DMI_ANALYSIS_POINTS;
}

void dmi_slip_features(const dmi_feature_context* context, const dmi_candidate* candidate,
                       float row[DMI_FEATURE_COUNT]) {
    const dmi_part_analysis* a = context->analysis;
    const float speed = surface_speed(a, candidate, &row[DMI_FEATURE_SURFACE_SLIP]);
    for (int k = 0; k < DMI_CONTACT_REGIONS; k++)
        contact_features(a, candidate, &a->contacts[k], speed, &columns_of[k], row);
}
