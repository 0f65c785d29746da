/* Infers the joint of one part: mesh + part (+ drag) -> ranked joint hypotheses, from networks and geometry together.
 * Everything is in the object-normalised frame. */
#ifndef DMI_INFERENCE_JOINT_INFERENCE_H
#define DMI_INFERENCE_JOINT_INFERENCE_H

#include "kinematics/hints/hint_features.h"
#include "kinematics/inference/hypotheses.h"
#include "kinematics/inference/joint_models.h"
#include "kinematics/kpp/kpp_net.h"
#include "kinematics/ranking/alternatives.h"

/* The weights that are loaded, and how to run them. */
typedef struct dmi_inference_models {
    const dmi_kpp_net* kpp;         /* NULL: geometry alone */
    const dmi_joint_models* joints; /* NULL: candidates are ranked by rules */
    dmi_isa isa;
} dmi_inference_models;

typedef struct dmi_inference_query {
    const dmi_mesh* mesh;
    const dmi_cloud* cloud; /* cloud of `part` */
    dmi_inference_models models;
    const dmi_drag_hint* hint;          /* NULL: none */
    const dmi_asset_hints* asset_hints; /* NULL: none */
    const uint32_t* welded; /* dmi_weld_vertices of the mesh, for many parts to share; NULL: they are welded anew */
    const dmi_progress* progress; /* progress of this inference; NULL: none */
    dmi_arena* scratch;           /* comes back as it was; NULL: the inference takes memory of its own */
    uint32_t part;                /* index in mesh->parts */
    int32_t given_type;           /* DM_JOINT_*; UNKNOWN: to be inferred */
    int network_alone;            /* KPP-Net's answers are the only candidates, with its probabilities */
} dmi_inference_query;

/* Infers the joint. out_alternatives: gets what a pull may choose from beside the hypotheses; may be NULL. */
dm_result dmi_joint_inference_run(dmi_env* env, const dmi_inference_query* query, dmi_hypotheses* out_hypotheses,
                                  dmi_alternatives* out_alternatives);

/* Reads a straight pull, along a chord of a turn or along an axis of the room, as the first movement of that turn.
 * Returns whether the drag is a straight pull of a candidate. It is one when the candidate explains it, as `features`
 * say, although the dragged point starts to move another way, and when the hand holds the part far from the axis.
 * out_hint becomes a drag along that other way, as long as the pull. */
bool dmi_straight_pull_read(const dmi_candidate* candidate, const float features[DMI_FEATURE_COUNT],
                            const dmi_drag_hint* hint, dmi_drag_hint* out_hint);

#endif
