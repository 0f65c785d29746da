/* Adds each face of a mesh to the measures of its part, in the frame of the mesh. */
#include "mesh/part_pivots.h"

#include "math/vec3.h"

static void begin(const dmi_frame* frame, const dm_pivot* pivot, dmi_pivot_gauge* out) {
    float origin[3], axes[9];
    dmi_frame_point_in(frame, dmi_xyz_f64(pivot->origin).v, origin);
    for (int i = 0; i < 9; i += 3) dmi_frame_direction_in(frame, pivot->axes + i, axes + i);
    dmi_pivot_gauge_begin((const double[]){(double)origin[0], (double)origin[1], (double)origin[2]}, axes, out);
}

static void read_corners(const dmi_mesh* mesh, uint32_t face, double out[3][3]) {
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 3; k++)
            out[i][k] = (double)mesh->positions[3 * (size_t)mesh->indices[3 * (size_t)face + i] + k];
}

void dmi_part_pivots_measure(const dmi_mesh* mesh, const dm_pivot* const* pivots, dmi_pivot_gauge* scratch,
                             dmi_pivot_witness* out) {
    for (uint32_t i = 0; i < mesh->part_count; i++)
        if (pivots[i] != NULL) begin(&mesh->frame, pivots[i], &scratch[i]);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        double corners[3][3];
        if (pivots[mesh->face_part[f]] == NULL) continue;
        read_corners(mesh, f, corners);
        dmi_pivot_gauge_add_face(&scratch[mesh->face_part[f]], (const double(*)[3])corners);
    }
    for (uint32_t i = 0; i < mesh->part_count; i++)
        out[i] = pivots[i] != NULL ? dmi_pivot_gauge_finish(&scratch[i]) : (dmi_pivot_witness){.rules = 0};
}
