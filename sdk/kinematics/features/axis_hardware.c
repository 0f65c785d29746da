/* Looks for hardware among the patches of part and body, and among the part's points that touch the body. */
#include "kinematics/features/feature_groups.h"

#include "math/elementary.h"
#include "math/linear3.h"

#define ROUND 0.12f       /* most residual of a patch that turns about a line, as for candidates; by hand */
#define SLANT 0.05f       /* sine between two lines at which a likeness falls to 1 / e; by hand */
#define OFFSET 0.012f     /* diagonals: distance from the axis at which a likeness falls to 1 / e; by hand */
#define ON_AXIS 0.3f      /* likeness from which something counts for the span; by hand */
#define SMALL 0.7f        /* diagonals: largest shell that may be hardware; by hand */
#define MOST 6            /* highest count; by hand */
#define WIDEST 2          /* diagonals: largest size or span; by hand */
#define CONTACT_POINTS 32 /* points of a contact region, at most about twice as many; by hand */
#define LEAST_CONTACT 5   /* points: a smaller region says nothing; by hand */
#define NEGLIGIBLE 20     /* exponent from which a likeness is 0 */
#define HARDWARE_REGION 1 /* the contact region whose gap is at most 0.03 of the part's diagonal */

/* An interval along the axis. */
typedef struct interval {
    float low, high;
} interval;

/* Makes the interval hold a value. */
static void stretch(interval* r, float at) {
    r->low = dmi_min(r->low, at), r->high = dmi_max(r->high, at);
}

/* Returns the length of an interval over a size; 0 for one that holds at most one value. */
static float length_of(const interval* r, float size) {
    return r->high > r->low ? dmi_min((r->high - r->low) / size, WIDEST) : 0;
}

/* Returns a Gaussian likeness. Most of what is asked about lies far off and costs no exponential. */
static float likeness(float x, float scale) {
    const float square = x * x / (scale * scale);
    return square < NEGLIGIBLE ? dmi_expf(-square) : 0;
}

/* Returns the sine of the angle between two unit vectors. */
static float slant(const float u[3], const float v[3]) {
    float across[3];
    dmi_cross3(u, v, across);
    return dmi_length3(across);
}

/* Returns how well a patch turns about the candidate's axis; for a slide, about any line along it. */
static float round_about(const dmi_part_analysis* a, const dmi_candidate* c, const dmi_patch* p) {
    if (!(p->residual < ROUND)) return 0;
    const float aligned = likeness(slant(p->axis, c->axis), SLANT);
    if (c->type == DM_JOINT_PRISMATIC) return aligned;
    return aligned * likeness(dmi_line_distance3(p->point, c->axis, c->origin), OFFSET * a->diagonal);
}

static void round_patches(const dmi_part_analysis* a, const dmi_candidate* c, const dmi_patch* patches, uint32_t count,
                          float* out_count, float* out_size, float sure[DMI_MAX_PATCHES], interval* all) {
    *out_count = *out_size = 0;
    for (uint32_t i = 0; i < count; i++) {
        const dmi_patch* p = &patches[i];
        sure[i] = round_about(a, c, p);
        *out_count = dmi_min(*out_count + sure[i], MOST);
        *out_size = dmi_max(*out_size, sure[i] * dmi_min(p->diagonal / a->diagonal, WIDEST));
        if (sure[i] > ON_AXIS) stretch(all, dmi_dot3(p->box_centre, c->axis));
    }
}

static float best_pair(const dmi_part_analysis* a, const dmi_candidate* c, const float* own, const float* near) {
    float best = 0;
    for (uint32_t i = 0; i < a->part_patch_count; i++) {
        if (own[i] < ON_AXIS) continue;
        for (uint32_t k = 0; k < a->near_patch_count; k++) {
            const float both = own[i] * near[k];
            if (both <= best) continue;
            const float off = dmi_line_distance3(a->near_patches[k].point, c->axis, a->part_patches[i].point);
            best = dmi_max(best, both * likeness(off, OFFSET * a->diagonal));
        }
    }
    return best;
}

/* Counts shells that are small beside the part: a knuckle, a screw, a bolt. */
static float centred_shells(const dmi_part_analysis* a, const dmi_candidate* c, const dmi_patch* patches,
                            uint32_t count, interval* all) {
    float sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        const dmi_patch* p = &patches[i];
        if (!p->is_shell || p->diagonal > SMALL * a->diagonal) continue;
        const float on = likeness(dmi_line_distance3(p->box_centre, c->axis, c->origin), OFFSET * a->diagonal);
        sum = dmi_min(sum + on, MOST);
        if (on > ON_AXIS) stretch(all, dmi_dot3(p->box_centre, c->axis));
    }
    return sum;
}

static void contact_on_axis(const dmi_part_analysis* a, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    const dmi_contact* contact = &a->contacts[HARDWARE_REGION];
    if (contact->count < LEAST_CONTACT) return;
    interval along = {INFINITY, -INFINITY};
    float close = 0, n = 0;
    const uint32_t step = contact->count / CONTACT_POINTS + 1;
    for (uint32_t i = 0; i < contact->count; i += step, n++) {
        const float* x = a->points[contact->points[i]];
        const float on = likeness(dmi_line_distance3(x, c->axis, c->origin), 2 * OFFSET * a->diagonal);
        close += on;
        if (on > ON_AXIS) stretch(&along, dmi_dot3(x, c->axis));
    }
    row[DMI_FEATURE_CONTACT_SPAN] = length_of(&along, a->diagonal);
    row[DMI_FEATURE_CONTACT_CLOSE] = close / n;
}

void dmi_axis_hardware_features(const dmi_part_analysis* a, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    float own[DMI_MAX_PATCHES], near[DMI_MAX_PATCHES];
    interval all = {INFINITY, -INFINITY};
    for (int k = DMI_FEATURE_ROUND_PART_COUNT; k <= DMI_FEATURE_CONTACT_CLOSE; k++) row[k] = 0;
    round_patches(a, c, a->part_patches, a->part_patch_count, &row[DMI_FEATURE_ROUND_PART_COUNT],
                  &row[DMI_FEATURE_ROUND_PART_SIZE], own, &all);
    round_patches(a, c, a->near_patches, a->near_patch_count, &row[DMI_FEATURE_ROUND_BODY_COUNT],
                  &row[DMI_FEATURE_ROUND_BODY_SIZE], near, &all);
    row[DMI_FEATURE_ROUND_PAIR] = best_pair(a, c, own, near);
    if (c->type == DM_JOINT_PRISMATIC) return;
    row[DMI_FEATURE_CENTRED_PART_COUNT] = centred_shells(a, c, a->part_patches, a->part_patch_count, &all);
    row[DMI_FEATURE_CENTRED_BODY_COUNT] = centred_shells(a, c, a->near_patches, a->near_patch_count, &all);
    row[DMI_FEATURE_HARDWARE_SPAN] = length_of(&all, a->diagonal);
    contact_on_axis(a, c, row);
}
