/* Joints that a part may have beside its hypotheses. They are many, have no limits, and a pull chooses from them. */
#ifndef DMI_RANKING_ALTERNATIVES_H
#define DMI_RANKING_ALTERNATIVES_H

#include "kinematics/candidates/candidates.h"
#include "kinematics/ranking/ranker.h"
#include "math/joint.h"

#define DMI_ALTERNATIVES 48

/* A joint without limits. */
typedef struct dmi_alternative {
    int32_t type; /* DM_JOINT_REVOLUTE, CONTINUOUS or PRISMATIC */
    float confidence;
    float axis[3], origin[3];
    dmi_free_range free_range;
} dmi_alternative;

static inline dm_joint dmi_alternative_joint(const dmi_alternative* a) {
    return (dm_joint){.type = a->type,
                      .type_confidence = a->confidence,
                      .joint_confidence = a->confidence,
                      .axis = {a->axis[0], a->axis[1], a->axis[2]},
                      .origin = {a->origin[0], a->origin[1], a->origin[2]},
                      .source = DM_JOINT_FROM_GEOMETRY};
}

typedef struct dmi_alternatives {
    dmi_alternative list[DMI_ALTERNATIVES]; /* most probable first */
    uint32_t count;
    /* Free ranges of slides along the axes of the canonical frame, which a pull may fall back on. */
    dmi_free_range slides[3];
} dmi_alternatives;

/* Finds the candidates, most probable first, that move the part unlike every hypothesis and every candidate before
 * them. dragged: the probabilities are those with a drag. */
dm_result dmi_alternatives_find(dmi_arena* arena, const dmi_part_analysis* analysis, const dmi_ranker* ranker,
                                int dragged, const dm_joint* hypotheses, uint32_t hypothesis_count,
                                const dmi_candidate* candidates, const float* probability, uint32_t count,
                                dmi_alternatives* out);

#endif
