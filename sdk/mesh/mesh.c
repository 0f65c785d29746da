/* The checked copy of a host mesh: normalised positions, areas and normals of faces, boxes and centres of parts. */
#include "mesh/mesh.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/env.h"
#include "mesh/mesh_read.h"

#define ALIGNMENT 64
#define MIN_SIZE 1e-18 /* metres: a smaller object is a point; by hand */
/* Readable bytes behind the last vertex: Embree loads 16 bytes a vertex. */
#define POSITION_PADDING 16
/* Normalised coordinates are rounded to 3e-8: a triangle of less height has no area and no direction. */
#define SLIVER_HEIGHT 1e-7

/* ---- memory ---- */

static size_t positions_size(const dmi_mesh* mesh) {
    return (size_t)mesh->vertex_count * 3 * sizeof(float) + POSITION_PADDING;
}

static dm_result allocate(dmi_env* env, uint32_t vertex_count, uint32_t face_count, dmi_mesh** out_mesh) {
    dmi_mesh* mesh = dmi_alloc_zeroed(env, sizeof *mesh, ALIGNMENT);
    *out_mesh = mesh;
    if (mesh != NULL) {
        size_t faces = face_count;
        mesh->vertex_count = vertex_count;
        mesh->face_count = face_count;
        mesh->positions = dmi_scratch_alloc(env, positions_size(mesh));
        mesh->indices = dmi_scratch_alloc(env, faces * 3 * sizeof(uint32_t));
        mesh->face_part = dmi_scratch_alloc(env, faces * sizeof(uint32_t));
        mesh->face_area = dmi_scratch_alloc(env, faces * sizeof(float));
        mesh->face_normal = dmi_scratch_alloc(env, faces * 3 * sizeof(float));
        if (mesh->positions && mesh->indices && mesh->face_part && mesh->face_area && mesh->face_normal) return DM_OK;
    }
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for a mesh of %u vertices and %u triangles", vertex_count,
                    face_count);
}

void dmi_mesh_destroy(dmi_env* env, dmi_mesh* mesh) {
    if (mesh == NULL) return;
    dmi_scratch_free(env, mesh->positions);
    dmi_scratch_free(env, mesh->indices);
    dmi_scratch_free(env, mesh->face_part);
    dmi_scratch_free(env, mesh->face_area);
    dmi_scratch_free(env, mesh->face_normal);
    dmi_free(env, mesh->parts, mesh->part_count * sizeof(dmi_part));
    dmi_free(env, mesh, sizeof *mesh);
}

/* ---- normalisation (paper §3.2) ---- */

/* Box, in canonical metres, of the vertices that some triangle uses. */
static dm_result measure_box(dmi_env* env, const dmi_mesh_reader* reader, const dmi_mesh* mesh, const dmi_axes* axes,
                             double low[3], double high[3]) {
    uint8_t* used = dmi_scratch_alloc(env, mesh->vertex_count);
    if (used == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u vertices", mesh->vertex_count);
    memset(used, 0, mesh->vertex_count);
    for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++) used[mesh->indices[i]] = 1;
    for (int k = 0; k < 3; k++) {
        low[k] = DBL_MAX;
        high[k] = -DBL_MAX;
    }
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        if (!used[v]) continue;
        double host[3], p[3];
        dmi_mesh_read_position(reader, v, host);
        dmi_axes_point_in(axes, host, p);
        for (int k = 0; k < 3; k++) {
            if (p[k] < low[k]) low[k] = p[k];
            if (p[k] > high[k]) high[k] = p[k];
        }
    }
    dmi_scratch_free(env, used);
    return DM_OK;
}

static dm_result set_frame(dmi_env* env, const dmi_mesh_reader* reader, const dmi_axes* axes, dmi_mesh* mesh) {
    double low[3] = {0}, high[3] = {0}, size = 0;
    dm_result result = measure_box(env, reader, mesh, axes, low, high);
    if (result != DM_OK) return result;
    for (int k = 0; k < 3; k++) {
        mesh->frame.centre[k] = 0.5 * (low[k] + high[k]);
        if (high[k] - low[k] > size) size = high[k] - low[k];
    }
    mesh->frame.axes = *axes;
    mesh->frame.size = size;
    if (size < MIN_SIZE) {
        return dmi_fail(env, DM_ERROR_DEGENERATE_MESH,
                        "dm_mesh_desc.positions: all triangles lie in one point (size %g m)", size);
    }
    if (dmi_frame_is_usable(&mesh->frame)) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                    "dm_mesh_desc.positions: the object is %g m large, with its centre at (%g, %g, %g) m and a unit of "
                    "%g m: too large, too small or too far away to compute with",
                    size, mesh->frame.centre[0], mesh->frame.centre[1], mesh->frame.centre[2], (double)axes->unit);
}

static void set_positions(const dmi_mesh_reader* reader, dmi_mesh* mesh) {
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        double host[3];
        float* p = mesh->positions + (size_t)v * 3;
        dmi_mesh_read_position(reader, v, host);
        dmi_frame_point_in(&mesh->frame, host, p);
        /* Vertices of no triangle may lie anywhere; the others are inside anyway. */
        for (int k = 0; k < 3; k++) p[k] = p[k] < -1 ? -1 : p[k] > 1 ? 1 : p[k];
    }
    memset(mesh->positions + (size_t)mesh->vertex_count * 3, 0, POSITION_PADDING);
}

/* ---- faces ---- */

static void load_corners(const dmi_mesh* mesh, uint32_t face, double corner[3][3]) {
    for (int i = 0; i < 3; i++) {
        const float* p = mesh->positions + (size_t)mesh->indices[(size_t)face * 3 + (size_t)i] * 3;
        for (int k = 0; k < 3; k++) corner[i][k] = (double)p[k];
    }
}

static void cross(const double a[3], const double b[3], double out[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static double larger(double a, double b) {
    return a > b ? a : b;
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Area (0 for a sliver) and unit normal; returns six times the signed volume between the face and the centre. */
static double measure_face(dmi_mesh* mesh, uint32_t face) {
    double corner[3][3], e1[3], e2[3], e3[3], n[3];
    load_corners(mesh, face, corner);
    for (int k = 0; k < 3; k++) {
        e1[k] = corner[1][k] - corner[0][k];
        e2[k] = corner[2][k] - corner[0][k];
        e3[k] = corner[2][k] - corner[1][k];
    }
    cross(e1, e2, n);
    double longest = larger(dot(e1, e1), larger(dot(e2, e2), dot(e3, e3))), square = dot(n, n);
    double twice_area = square <= SLIVER_HEIGHT * SLIVER_HEIGHT * longest ? 0 : sqrt(square);
    double inverse = twice_area > 0 ? 1 / twice_area : 0;
    mesh->face_area[face] = (float)(0.5 * twice_area);
    for (int k = 0; k < 3; k++) mesh->face_normal[(size_t)face * 3 + (size_t)k] = (float)(n[k] * inverse);
    return dot(corner[0], n);
}

/* Left-handed hosts wind triangles the other way round to keep their fronts outside. A clearly negative volume tells;
 * flat or open objects without one keep their winding. */
static dm_result measure_faces(const dmi_progress* progress, dmi_mesh* mesh) {
    double volume = 0, magnitude = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        double six_volumes = measure_face(mesh, f);
        volume += six_volumes;
        magnitude += fabs(six_volumes);
        if (dmi_progress_step(progress, f, mesh->face_count) != DM_OK) return DM_ERROR_CANCELLED;
    }
    mesh->winding = volume < -1e-6 - 1e-4 * magnitude ? -1.0f : 1.0f;
    if (mesh->winding > 0) return DM_OK;
    for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++) mesh->face_normal[i] = -mesh->face_normal[i];
    return DM_OK;
}

/* ---- parts ---- */

typedef struct part_sums {
    double area, moment[3];
} part_sums;

static void add_face(dmi_mesh* mesh, uint32_t face, part_sums* sums) {
    const uint32_t* index = mesh->indices + (size_t)face * 3;
    const float* a = mesh->positions + (size_t)index[0] * 3;
    const float* b = mesh->positions + (size_t)index[1] * 3;
    const float* c = mesh->positions + (size_t)index[2] * 3;
    dmi_part* part = &mesh->parts[mesh->face_part[face]];
    part_sums* sum = &sums[mesh->face_part[face]];
    double area = (double)mesh->face_area[face];
    sum->area += area;
    for (int k = 0; k < 3; k++) {
        float low = a[k] < b[k] ? a[k] : b[k], high = a[k] < b[k] ? b[k] : a[k];
        low = low < c[k] ? low : c[k];
        high = high > c[k] ? high : c[k];
        if (low < part->box_min[k]) part->box_min[k] = low;
        if (high > part->box_max[k]) part->box_max[k] = high;
        sum->moment[k] += area * ((double)a[k] + (double)b[k] + (double)c[k]) / 3;
    }
}

static dm_result check_any_area(dmi_env* env, const dmi_mesh* mesh) {
    double area = 0;
    for (uint32_t p = 0; p < mesh->part_count; p++) area += (double)mesh->parts[p].area;
    if (area > 0) return DM_OK;
    return dmi_fail(env, DM_ERROR_DEGENERATE_MESH, "dm_mesh_desc.indices: no triangle has an area");
}

static dm_result check_areas(dmi_env* env, const dmi_mesh* mesh) {
    dm_result result = check_any_area(env, mesh);
    if (result != DM_OK) return result;
    for (uint32_t p = 0; p < mesh->part_count; p++) {
        const dmi_part* part = &mesh->parts[p];
        if (part->area > 0 || part->face_count == 0) continue;
        return dmi_fail(env, DM_ERROR_DEGENERATE_MESH,
                        "dm_mesh_desc.part_ids: none of the %u triangles of part %u%s has an area", part->face_count,
                        part->id, p == 0 ? " (the body)" : "");
    }
    return DM_OK;
}

/* Gives a part without triangles (the body of a door leaf alone) the object's centre as its box. */
static void put_in_the_middle(dmi_part* part) {
    memset(part->box_min, 0, sizeof part->box_min);
    memset(part->box_max, 0, sizeof part->box_max);
}

dm_result dmi_mesh_measure_parts(dmi_env* env, dmi_mesh* mesh) {
    part_sums* sums = dmi_alloc_zeroed(env, mesh->part_count * sizeof *sums, ALIGNMENT);
    if (sums == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u parts", mesh->part_count);
    for (uint32_t p = 0; p < mesh->part_count; p++) {
        for (int k = 0; k < 3; k++) {
            mesh->parts[p].box_min[k] = FLT_MAX;
            mesh->parts[p].box_max[k] = -FLT_MAX;
        }
    }
    for (uint32_t f = 0; f < mesh->face_count; f++) add_face(mesh, f, sums);
    for (uint32_t p = 0; p < mesh->part_count; p++) {
        mesh->parts[p].area = (float)sums[p].area;
        if (mesh->parts[p].face_count == 0) put_in_the_middle(&mesh->parts[p]);
        if (!(sums[p].area > 0)) continue;
        for (int k = 0; k < 3; k++) mesh->parts[p].centre[k] = (float)(sums[p].moment[k] / sums[p].area);
    }
    dmi_free(env, sums, mesh->part_count * sizeof *sums);
    return DM_OK;
}

dm_result dmi_mesh_measure(dmi_env* env, const dmi_progress* progress, dmi_mesh* mesh) {
    const dmi_progress faces = dmi_progress_piece(progress, 0, DMI_STAGE_MEASURE_FACES_DONE);
    dm_result result = measure_faces(&faces, mesh);
    if (result == DM_OK) result = dmi_mesh_measure_parts(env, mesh);
    return result == DM_OK ? check_areas(env, mesh) : result;
}

/* ---- the whole ---- */

/* Each step passes once over the mesh, and takes about as long as another. */
enum { INDICES_READ = 1, POSITIONS_CHECKED, PARTS_ASSIGNED, FRAME_SET, POSITIONS_SET, FACES_MEASURED, STEPS };

static dm_result tell(const dmi_progress* progress, int steps) {
    return dmi_progress_tell(progress, (float)steps / STEPS);
}

/* What a step is of the whole. */
static dmi_progress step_of(const dmi_progress* progress, int step) {
    return dmi_progress_piece(progress, (float)(step - 1) / STEPS, (float)step / STEPS);
}

static dm_result fill_shape(dmi_env* env, const dmi_mesh_reader* reader, const dmi_axes* axes,
                            const dmi_progress* progress, dmi_mesh* mesh) {
    dm_result result = set_frame(env, reader, axes, mesh);
    if (result == DM_OK) result = tell(progress, FRAME_SET);
    if (result != DM_OK) return result;
    set_positions(reader, mesh);
    result = tell(progress, POSITIONS_SET);
    if (result != DM_OK) return result;
    const dmi_progress faces = step_of(progress, FACES_MEASURED);
    result = measure_faces(&faces, mesh);
    if (result == DM_OK) result = tell(progress, FACES_MEASURED);
    return result == DM_OK ? dmi_mesh_measure_parts(env, mesh) : result;
}

static dm_result fill(dmi_env* env, const dmi_mesh_reader* reader, const dmi_axes* axes, const dm_part_desc* parts,
                      uint32_t part_count, const dmi_progress* progress, dmi_mesh* mesh) {
    dm_result result = dmi_mesh_read_indices(env, reader, mesh->indices);
    if (result == DM_OK) result = tell(progress, INDICES_READ);
    if (result == DM_OK) result = dmi_mesh_check_positions(env, reader);
    if (result == DM_OK) result = tell(progress, POSITIONS_CHECKED);
    if (result == DM_OK) result = dmi_mesh_assign_parts(env, reader, parts, part_count, mesh);
    if (result == DM_OK) result = tell(progress, PARTS_ASSIGNED);
    if (result == DM_OK) result = fill_shape(env, reader, axes, progress, mesh);
    return result == DM_OK ? check_areas(env, mesh) : result;
}

/* piece_count: of numbered pieces; NULL: they are those whose ids occur. */
static dm_result fill_pieces(dmi_env* env, const dmi_mesh_reader* reader, const dmi_axes* axes,
                             const uint32_t* piece_count, const dmi_progress* progress, dmi_mesh* mesh) {
    dm_result result = dmi_mesh_read_indices(env, reader, mesh->indices);
    if (result == DM_OK) result = tell(progress, INDICES_READ);
    if (result == DM_OK) result = dmi_mesh_check_positions(env, reader);
    if (result == DM_OK) result = tell(progress, POSITIONS_CHECKED);
    if (result == DM_OK)
        result = piece_count != NULL ? dmi_mesh_assign_numbered(env, reader, *piece_count, mesh)
                                     : dmi_mesh_assign_pieces(env, reader, mesh);
    if (result == DM_OK) result = tell(progress, PARTS_ASSIGNED);
    if (result == DM_OK) result = fill_shape(env, reader, axes, progress, mesh);
    return result == DM_OK ? check_any_area(env, mesh) : result;
}

dm_result dmi_mesh_create(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc, const dm_part_desc* parts,
                          uint32_t part_count, const dmi_progress* progress, dmi_mesh** out_mesh) {
    dmi_mesh_reader reader;
    dmi_mesh* mesh = NULL;
    dm_result result = dmi_mesh_reader_open(env, desc, &reader);
    if (result == DM_OK) result = allocate(env, reader.vertex_count, reader.face_count, &mesh);
    if (result == DM_OK) result = fill(env, &reader, axes, parts, part_count, progress, mesh);
    if (result != DM_OK) {
        dmi_mesh_destroy(env, mesh);
        return result;
    }
    *out_mesh = mesh;
    return DM_OK;
}

static dm_result create_pieces(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc,
                               const uint32_t* piece_count, const dmi_progress* progress, dmi_mesh** out_mesh) {
    dmi_mesh_reader reader;
    dmi_mesh* mesh = NULL;
    dm_result result = dmi_mesh_reader_open(env, desc, &reader);
    if (result == DM_OK) result = allocate(env, reader.vertex_count, reader.face_count, &mesh);
    if (result == DM_OK) result = fill_pieces(env, &reader, axes, piece_count, progress, mesh);
    if (result != DM_OK) {
        dmi_mesh_destroy(env, mesh);
        return result;
    }
    *out_mesh = mesh;
    return DM_OK;
}

dm_result dmi_mesh_create_pieces(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc,
                                 const dmi_progress* progress, dmi_mesh** out_mesh) {
    return create_pieces(env, axes, desc, NULL, progress, out_mesh);
}

dm_result dmi_mesh_create_numbered(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc, uint32_t piece_count,
                                   const dmi_progress* progress, dmi_mesh** out_mesh) {
    return create_pieces(env, axes, desc, &piece_count, progress, out_mesh);
}

dm_result dmi_mesh_restore(dmi_env* env, const dmi_frame* frame, uint32_t vertex_count, uint32_t face_count,
                           uint32_t part_count, dmi_mesh** out_mesh) {
    dmi_mesh* mesh = NULL;
    dm_result result = allocate(env, vertex_count, face_count, &mesh);
    if (result == DM_OK) {
        mesh->parts = dmi_alloc_zeroed(env, part_count * sizeof(dmi_part), ALIGNMENT);
        if (mesh->parts == NULL) result = dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u parts", part_count);
    }
    if (result != DM_OK) {
        dmi_mesh_destroy(env, mesh);
        return result;
    }
    mesh->frame = *frame;
    mesh->part_count = part_count;
    memset(mesh->positions + (size_t)vertex_count * 3, 0, POSITION_PADDING);
    *out_mesh = mesh;
    return DM_OK;
}
