/* Looks for what lies on a candidate's axis among the patches of part and body, and among the points that touch. */
#include "kinematics/features/axis_hardware.h"

#include "math/linear3.h"

#define ROUND 0.12f       /* most residual of a patch that turns about a line, as for candidates */
#define SLANT 0.05f       /* sine at which a patch's line counts for 1 / e */
#define OFFSET 0.012f     /* of the part's diagonal: distance from the axis at which something counts for 1 / e */
#define ON_AXIS 0.3f      /* surely enough to count for how far things reach */
#define SMALL 0.7f        /* of the part's diagonal: most of a shell that may be hardware */
#define MOST 6            /* counts beyond it say no more */
#define WIDEST 2          /* diagonals of the part */
#define CONTACT_POINTS 32 /* of those that touch, at most */

typedef struct reach {
    float low, high;
} reach;

static void stretch(reach* r, float at) {
    r->low = dmi_min(r->low, at), r->high = dmi_max(r->high, at);
}

static float length_of(const reach* r, float size) {
    return r->high > r->low ? dmi_min((r->high - r->low) / size, WIDEST) : 0;
}

/* A bell; most of what is asked about lies far off and costs no exponential. */
static float fades(float x, float scale) {
    const float square = x * x / (scale * scale);
    return square < 20 ? expf(-square) : 0;
}

static float slant(const float a[3], const float b[3]) {
    float across[3];
    dmi_cross3(a, b, across);
    return dmi_length3(across);
}

/* How surely a patch turns about the candidate's axis; for a slide, about any line along it. */
static float round_about(const dmi_part_analysis* s, const dmi_candidate* c, const dmi_patch* p) {
    if (!(p->residual < ROUND)) return 0;
    const float aligned = fades(slant(p->axis, c->axis), SLANT);
    if (c->type == DM_JOINT_PRISMATIC) return aligned;
    return aligned * fades(dmi_line_distance3(p->point, c->axis, c->origin), OFFSET * s->diagonal);
}

static void round_patches(const dmi_part_analysis* s, const dmi_candidate* c, const dmi_patch* patches, uint32_t count,
                          float out_round[2], float sure[DMI_MAX_PATCHES], reach* all) {
    for (uint32_t i = 0; i < count; i++) {
        const dmi_patch* p = &patches[i];
        sure[i] = round_about(s, c, p);
        out_round[0] = dmi_min(out_round[0] + sure[i], MOST);
        out_round[1] = dmi_max(out_round[1], sure[i] * dmi_min(p->diagonal / s->diagonal, WIDEST));
        if (sure[i] > ON_AXIS) stretch(all, dmi_dot3(p->box_centre, c->axis));
    }
}

static float best_pair(const dmi_part_analysis* s, const dmi_candidate* c, const float* own, const float* near) {
    float best = 0;
    for (uint32_t i = 0; i < s->part_patch_count; i++) {
        if (own[i] < ON_AXIS) continue;
        for (uint32_t k = 0; k < s->near_patch_count; k++) {
            const float both = own[i] * near[k];
            if (both <= best) continue;
            const float off = dmi_line_distance3(s->near_patches[k].point, c->axis, s->part_patches[i].point);
            best = dmi_max(best, both * fades(off, OFFSET * s->diagonal));
        }
    }
    return best;
}

/* Shells that are small beside the part: a knuckle, a screw, a bolt. */
static float centred_shells(const dmi_part_analysis* s, const dmi_candidate* c, const dmi_patch* patches,
                            uint32_t count, reach* all) {
    float sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        const dmi_patch* p = &patches[i];
        if (!p->is_shell || p->diagonal > SMALL * s->diagonal) continue;
        const float on = fades(dmi_line_distance3(p->box_centre, c->axis, c->origin), OFFSET * s->diagonal);
        sum = dmi_min(sum + on, MOST);
        if (on > ON_AXIS) stretch(all, dmi_dot3(p->box_centre, c->axis));
    }
    return sum;
}

static void contact_on_axis(const dmi_part_analysis* s, const dmi_candidate* c, float out[DMI_HARDWARE_COUNT]) {
    const dmi_contact* contact = &s->contacts[1];
    if (contact->count < 5) return;
    reach along = {INFINITY, -INFINITY};
    float close = 0, n = 0;
    const uint32_t step = contact->count / CONTACT_POINTS + 1;
    for (uint32_t i = 0; i < contact->count; i += step, n++) {
        const float* x = s->points[contact->points[i]];
        const float on = fades(dmi_line_distance3(x, c->axis, c->origin), 2 * OFFSET * s->diagonal);
        close += on;
        if (on > ON_AXIS) stretch(&along, dmi_dot3(x, c->axis));
    }
    out[DMI_HARDWARE_SPAN + 1] = length_of(&along, s->diagonal);
    out[DMI_HARDWARE_CLOSE] = close / n;
}

void dmi_axis_hardware_features(const dmi_part_analysis* s, const dmi_candidate* c, float out[DMI_HARDWARE_COUNT]) {
    float own[DMI_MAX_PATCHES], near[DMI_MAX_PATCHES];
    reach all = {INFINITY, -INFINITY};
    memset(out, 0, DMI_HARDWARE_COUNT * sizeof *out);
    round_patches(s, c, s->part_patches, s->part_patch_count, out + DMI_HARDWARE_ROUND, own, &all);
    round_patches(s, c, s->near_patches, s->near_patch_count, out + DMI_HARDWARE_ROUND + 2, near, &all);
    out[DMI_HARDWARE_PAIR] = best_pair(s, c, own, near);
    if (c->type == DM_JOINT_PRISMATIC) return;
    out[DMI_HARDWARE_CENTRED] = centred_shells(s, c, s->part_patches, s->part_patch_count, &all);
    out[DMI_HARDWARE_CENTRED + 1] = centred_shells(s, c, s->near_patches, s->near_patch_count, &all);
    out[DMI_HARDWARE_SPAN] = length_of(&all, s->diagonal);
    contact_on_axis(s, c, out);
}
