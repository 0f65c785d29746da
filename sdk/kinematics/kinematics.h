/* Mesh + part (+ drag) -> ranked joint hypotheses: network and geometry together. Object-normalised frame throughout.
 */
#ifndef DMI_KINEMATICS_KINEMATICS_H
#define DMI_KINEMATICS_KINEMATICS_H

#include "kinematics/alternatives.h"
#include "kinematics/kpp_net.h"
#include "kinematics/ranker.h"
#include "math/joint.h"

typedef struct dmi_hypotheses {
    dm_joint joints[DM_MAX_HYPOTHESES]; /* best first, inner frame */
    uint32_t count;
} dmi_hypotheses;

typedef struct dmi_kinematics_query {
    const dmi_mesh* mesh;
    const dmi_cloud* cloud;    /* of `part` */
    const dmi_kpp_net* net;    /* NULL: geometry alone */
    const dmi_ranker* ranker;  /* NULL: candidates are ranked by rules */
    const dmi_drag_hint* hint; /* NULL: none */
    const uint32_t* welded;    /* dmi_weld_vertices of the mesh, for many parts to share; NULL: welded anew */
    dmi_arena* scratch;        /* left as it was found; NULL: memory of its own */
    uint32_t part;             /* index in mesh->parts */
    int32_t given_type;        /* DM_JOINT_*; UNKNOWN = find out */
    int network_alone;         /* the net's own answers are the only candidates, by its own probabilities */
    dmi_isa isa;
} dmi_kinematics_query;

/* out_alternatives: NULL, or what a pull may choose from beside the hypotheses. */
dm_result dmi_kinematics_infer(dmi_env* env, const dmi_kinematics_query* query, dmi_hypotheses* out_hypotheses,
                               dmi_alternatives* out_alternatives);

/* Orders hypotheses by how well they explain a drag, and turns their signs so that positive follows it. Microseconds.
 */
void dmi_hypotheses_rerank(const dmi_hypotheses* hypotheses, const dmi_drag_hint* hint, dmi_hypotheses* out);
/* Signs the joint so that a positive step moves the drag's point along its vector (limits swap with the sign). */
void dmi_joint_orient(dm_joint* joint, const dmi_drag_hint* hint);

#endif
