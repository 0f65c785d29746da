/* The area of a surface inside a box. */
#ifndef DMI_MESH_SURFACE_AREA_H
#define DMI_MESH_SURFACE_AREA_H

#include "mesh/mesh.h"

typedef struct dmi_bounds {
    float low[3], high[3];
} dmi_bounds;

/* Returns the area inside the box of the faces of the wanted parts. wanted: part -> 1. */
double dmi_area_inside(const dmi_mesh* mesh, const uint8_t* wanted, const dmi_bounds* box);

#endif
