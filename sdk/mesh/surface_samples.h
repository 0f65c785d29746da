/* Uniform samples of a surface that depend on where the surface is, and not on how triangles cut it.
 *
 * The samples are points where a jittered lattice of lines along each coordinate axis meets the surface. Each hit is
 * kept with the probability that makes the density the same for all directions of the surface. The samples do not
 * depend on the order of faces and corners, nor on which diagonal cuts a flat polygon. */
#ifndef DMI_MESH_SURFACE_SAMPLES_H
#define DMI_MESH_SURFACE_SAMPLES_H

#include "mesh/surface_area.h"

typedef struct dmi_surface {
    const dmi_mesh* mesh;
    const uint8_t* wanted;  /* part -> 1: its faces belong to the surface */
    const dmi_bounds* clip; /* what is outside does not belong to it; NULL: nothing is cut off */
    double area;            /* the surface's area, roughly */
} dmi_surface;

/* Draws `count` samples of a surface whose area is not 0. count: a power of two. The order has low discrepancy: the
 * first few samples are spread as evenly as all. */
dm_result dmi_surface_sample(dmi_env* env, const dmi_surface* surface, uint64_t seed, uint32_t count,
                             float (*out_xyz)[3], float (*out_normal)[3]);

#endif
