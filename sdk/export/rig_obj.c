/* Prints a mesh as a Wavefront OBJ file, once for all formats that refer to it. */
#include "export/flat_mesh.h"
#include "export/rig_formats.h"

static void put_point(const float p[3], dmi_text* out) {
    dmi_text_put(out, "v %s %s %s\n", dmi_digits_of_float(p[0]).text, dmi_digits_of_float(p[1]).text,
                 dmi_digits_of_float(p[2]).text);
}

void dmi_rig_print_obj(const dmi_rig_mesh* mesh, dmi_text* out) {
    dmi_text_put(out, "# metres, Z up\no %s\n", mesh->name);
    for (uint32_t i = 0; i < mesh->point_count; i++) put_point(mesh->points[i], out);
    for (uint32_t f = 0; f < mesh->face_count; f++)
        dmi_text_put(out, "f %u %u %u\n", mesh->faces[f][0] + 1, mesh->faces[f][1] + 1, mesh->faces[f][2] + 1);
    uint32_t face;
    float point[3];
    if (!dmi_find_fourth_point(mesh, &face, point)) return;
    put_point(point, out);
    dmi_text_put(out, "f %u %u %u\n", mesh->faces[face][1] + 1, mesh->faces[face][0] + 1, mesh->point_count + 1);
}
