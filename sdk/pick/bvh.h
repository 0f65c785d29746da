/* The backend of a context and what it keeps; the trees of an object, as the scene uses them. */
#ifndef DMI_PICK_BVH_H
#define DMI_PICK_BVH_H

#include "pick/backend.h"
#include "pick/pick.h"

/* ---- the backend of a context ---- */

struct dmi_picker {
    dmi_env* env;
    const dmi_pick_backend* backend; /* NULL: this context picks nothing */
    void* device;
    int32_t choice;              /* DM_PICK_*, of the host */
    char why[DMI_PICK_WHY_SIZE]; /* it picks nothing */
};

/* ---- trees ---- */

typedef struct dmi_bvh_part {
    uint32_t id; /* the host's */
    uint32_t first_face;
    float low[3], high[3]; /* box of its triangles at rest */
    void* tree;            /* the backend's; NULL: no triangle of the part has an area */
    bool (*first_hit)(const void* tree, const dmi_part_ray* ray, dmi_part_hit* out_hit); /* the backend's */
    const dmi_packed_mesh* mesh;                                                         /* the bvh's */
} dmi_bvh_part;

struct dmi_bvh {
    dmi_env* env;
    const dmi_pick_backend* backend;
    void* device;
    const dmi_packed_mesh* mesh; /* the object's; outlives this */
    uint32_t part_count;
    dmi_bvh_part parts[];
};

/* Index of the part with the host's id; -1 when there is none. */
int32_t dmi_bvh_find_part(const dmi_bvh* bvh, uint32_t id);
/* Corners a, b, c of the face that the backend calls `face` of a part. */
static inline void dmi_bvh_corners(const dmi_bvh_part* part, uint32_t face, const float* out[3]) {
    const dmi_packed_mesh* mesh = part->mesh;
    const size_t at = ((size_t)part->first_face + face) * 3;
    if (mesh->narrow != NULL) {
        for (size_t i = 0; i < 3; i++) out[i] = mesh->positions + (size_t)mesh->narrow[at + i] * 3;
    } else {
        for (size_t i = 0; i < 3; i++) out[i] = mesh->positions + (size_t)mesh->wide[at + i] * 3;
    }
}

#endif
