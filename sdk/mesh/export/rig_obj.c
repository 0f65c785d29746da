/* Meshes as files beside those of the formats, written once. */
#include "mesh/export/rig_formats.h"

void dmi_rig_print_obj(const dmi_rig_mesh* mesh, dmi_text* out) {
    dmi_text_put(out, "# metres, Z up\no %s\n", mesh->name);
    for (uint32_t i = 0; i < mesh->point_count; i++)
        dmi_text_put(out, "v %s %s %s\n", dmi_digits_of_float(mesh->points[i][0]).text,
                     dmi_digits_of_float(mesh->points[i][1]).text, dmi_digits_of_float(mesh->points[i][2]).text);
    for (uint32_t f = 0; f < mesh->face_count; f++)
        dmi_text_put(out, "f %u %u %u\n", mesh->faces[f][0] + 1, mesh->faces[f][1] + 1, mesh->faces[f][2] + 1);
}
