/* Which faces move together with a point of the surface that a player grabs: the part, when no mask names it. */
#ifndef DMI_KINEMATICS_PART_FINDER_H
#define DMI_KINEMATICS_PART_FINDER_H

#include "kinematics/part_pieces.h"

typedef struct dmi_part_query {
    const dmi_mesh* mesh; /* of dmi_mesh_create_pieces: its parts, when there are several, are rigid pieces */
    float point[3];       /* on or near the surface; object-normalised */
    float drag[3];        /* unit; zeros: none */
} dmi_part_query;

/* out_faces: 1 for the faces that move, 0 for the others. */
dm_result dmi_part_find(dmi_env* env, const dmi_part_query* query, uint8_t* out_faces);

/* ---- growing, one piece after the other (also what its weights are fitted on) ---- */

#define DMI_GROWTH_FEATURES 26

typedef struct dmi_growth {
    const dmi_pieces* pieces;
    const uint32_t* shells;                 /* piece -> shell over shared vertices */
    float drag[3];                          /* unit; zeros: none */
    uint8_t* inside;                        /* a piece: of the part */
    float (*features)[DMI_GROWTH_FEATURES]; /* a piece that touches the part */
    uint32_t* touching;                     /* such pieces … */
    uint32_t touching_count;                /* … and how many */
    uint32_t member_count;
    struct dmi_piece_shape* shapes; /* a piece */
    struct dmi_touch_sums* sums;    /* a piece */
} dmi_growth;

/* Everything lives in the arena; no piece is inside yet. */
dm_result dmi_growth_make(dmi_arena* arena, const dmi_pieces* pieces, const uint32_t* shells, const float drag[3],
                          dmi_growth* out);
void dmi_growth_add(dmi_growth* growth, uint32_t piece);
/* Fills touching and their features. */
void dmi_growth_look(dmi_growth* growth);
/* Log odds that a piece with these features belongs to the part. */
float dmi_growth_score(const float features[DMI_GROWTH_FEATURES]);
/* Sheets of surface as pieces, and each one's shell. In the arena. */
dm_result dmi_part_sheets(dmi_arena* arena, const dmi_mesh* mesh, dmi_pieces* out_pieces, uint32_t** out_shells);

#endif
