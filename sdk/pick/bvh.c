/* Builds one bounding volume hierarchy for each part, over vertices that all parts share. */
#include "pick/bvh.h"

#include <math.h>
#include <string.h>

#include "base/ids.h"

#define POSITION_PADDING 16 /* bytes that Embree may read at the last vertex */

static size_t positions_size(const dmi_bvh* bvh) {
    return (size_t)bvh->vertex_count * 3 * sizeof(float) + POSITION_PADDING;
}

void dmi_bvh_corners(const dmi_bvh* bvh, uint32_t part, uint32_t primitive, const float* out[3]) {
    const uint32_t* corners = bvh->corners + ((size_t)bvh->parts[part].first_face + primitive) * 3;
    for (int i = 0; i < 3; i++) out[i] = bvh->positions + (size_t)corners[i] * 3;
}

int32_t dmi_bvh_find_part(const dmi_bvh* bvh, uint32_t id) {
    return dmi_find_id(&bvh->parts->id, sizeof *bvh->parts, bvh->part_count, id);
}

/* ---- building ---- */

static dm_result allocate(dmi_picker* picker, const dmi_mesh* mesh, dmi_bvh** out_bvh) {
    dmi_env* env = picker->env;
    dmi_bvh* bvh = dmi_alloc_zeroed(env, sizeof *bvh, DMI_ALIGNMENT);
    *out_bvh = bvh;
    if (bvh != NULL) {
        size_t faces = mesh->face_count;
        bvh->picker = picker;
        bvh->vertex_count = mesh->vertex_count;
        bvh->face_count = mesh->face_count;
        bvh->part_count = mesh->part_count;
        bvh->positions = dmi_alloc(env, positions_size(bvh), DMI_ALIGNMENT);
        bvh->corners = dmi_alloc(env, faces * 3 * sizeof(uint32_t), DMI_ALIGNMENT);
        bvh->faces = dmi_alloc(env, faces * sizeof(uint32_t), DMI_ALIGNMENT);
        bvh->parts = dmi_alloc_zeroed(env, mesh->part_count * sizeof(dmi_bvh_part), DMI_ALIGNMENT);
        if (bvh->positions != NULL && bvh->corners != NULL && bvh->faces != NULL && bvh->parts != NULL) return DM_OK;
    }
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory to pick among %u triangles", mesh->face_count);
}

/* Copies the mesh with its faces in order of their parts. */
static void copy_mesh(dmi_bvh* bvh, const dmi_mesh* mesh) {
    memcpy(bvh->positions, mesh->positions, (size_t)mesh->vertex_count * 3 * sizeof(float));
    memset(bvh->positions + (size_t)mesh->vertex_count * 3, 0, POSITION_PADDING);
    uint32_t first = 0;
    for (uint32_t p = 0; p < mesh->part_count; p++) {
        dmi_bvh_part* part = &bvh->parts[p];
        part->id = mesh->parts[p].id;
        part->first_face = first;
        first += mesh->parts[p].face_count;
    }
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        dmi_bvh_part* part = &bvh->parts[mesh->face_part[f]];
        uint32_t place = part->first_face + part->face_count++;
        bvh->faces[place] = f;
        memcpy(bvh->corners + (size_t)place * 3, mesh->indices + (size_t)f * 3, 3 * sizeof(uint32_t));
    }
}

static dm_result build_part(dmi_bvh* bvh, dmi_bvh_part* part) {
    RTCDevice device = bvh->picker->device;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    part->scene = rtcNewScene(device);
    if (geometry != NULL && part->scene != NULL) {
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, bvh->positions, 0,
                                   3 * sizeof(float), bvh->vertex_count);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   bvh->corners + (size_t)part->first_face * 3, 0, 3 * sizeof(uint32_t),
                                   part->face_count);
        rtcCommitGeometry(geometry);
        /* Robust: no ray slips between two triangles that share an edge. */
        rtcSetSceneFlags(part->scene, RTC_SCENE_FLAG_ROBUST);
        rtcAttachGeometry(part->scene, geometry);
        dmi_picker_commit(bvh->picker, part->scene);
    }
    if (geometry != NULL) rtcReleaseGeometry(geometry);
    return dmi_picker_status(bvh->picker);
}

dm_result dmi_bvh_create(dmi_picker* picker, const dmi_mesh* mesh, dmi_bvh** out_bvh) {
    dmi_bvh* bvh;
    dm_result result = allocate(picker, mesh, &bvh);
    if (result == DM_OK) copy_mesh(bvh, mesh);
    for (uint32_t p = 0; result == DM_OK && p < mesh->part_count; p++) result = build_part(bvh, &bvh->parts[p]);
    if (result != DM_OK) {
        dmi_bvh_destroy(bvh);
        return result;
    }
    *out_bvh = bvh;
    return DM_OK;
}

void dmi_bvh_destroy(dmi_bvh* bvh) {
    if (bvh == NULL) return;
    dmi_env* env = bvh->picker->env;
    for (uint32_t p = 0; bvh->parts != NULL && p < bvh->part_count; p++) {
        if (bvh->parts[p].scene != NULL) rtcReleaseScene(bvh->parts[p].scene);
    }
    dmi_free(env, bvh->positions, positions_size(bvh));
    dmi_free(env, bvh->corners, (size_t)bvh->face_count * 3 * sizeof(uint32_t));
    dmi_free(env, bvh->faces, (size_t)bvh->face_count * sizeof(uint32_t));
    dmi_free(env, bvh->parts, bvh->part_count * sizeof(dmi_bvh_part));
    dmi_free(env, bvh, sizeof *bvh);
}
