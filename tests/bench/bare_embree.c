/* Scenes and rays of Embree 3 or 4. */
#include "bare_embree.h"

#include <math.h>
#include <string.h>

RTCScene bare_embree_part(RTCDevice device, const bench_mesh* mesh, uint32_t part, enum RTCSceneFlags flags) {
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, flags);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    uint32_t count = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) count += part == BARE_EMBREE_ALL || mesh->part_ids[f] == part;
    float* xyz = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                         mesh->vertex_count);
    uint32_t* corners =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), count);
    memcpy(xyz, mesh->positions, (size_t)mesh->vertex_count * 3 * sizeof(float));
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (part != BARE_EMBREE_ALL && mesh->part_ids[f] != part) continue;
        memcpy(corners, mesh->indices + 3 * (size_t)f, 3 * sizeof(uint32_t));
        corners += 3;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

static void attach_instance(RTCDevice device, RTCScene top, RTCScene part, const float* place) {
    float transform[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    if (place != NULL) memcpy(transform + 9, place, 3 * sizeof(float));
    RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, part);
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, transform);
    rtcCommitGeometry(instance);
    rtcAttachGeometry(top, instance);
    rtcReleaseGeometry(instance);
}

RTCScene bare_embree_instances(RTCDevice device, const bench_mesh* mesh, uint32_t count, const float* places,
                               enum RTCSceneFlags flags) {
    RTCScene top = rtcNewScene(device);
    rtcSetSceneFlags(top, flags);
    for (uint32_t part = 0; part <= mesh->parts; part++) {
        RTCScene scene = bare_embree_part(device, mesh, part, flags);
        for (uint32_t i = 0; i < count; i++)
            attach_instance(device, top, scene, places != NULL ? places + 3 * (size_t)i : NULL);
        rtcReleaseScene(scene);
    }
    rtcCommitScene(top);
    return top;
}

static void intersect(RTCScene scene, struct RTCRayHit* hit) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, hit, NULL);
#else
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, hit);
#endif
}

int bare_embree_hits(RTCScene scene, const float origin[3], const float direction[3]) {
    struct RTCRayHit hit = {
        .ray = {.org_x = origin[0],
                .org_y = origin[1],
                .org_z = origin[2],
                .dir_x = direction[0],
                .dir_y = direction[1],
                .dir_z = direction[2],
                .tfar = INFINITY,
                .mask = 0xffffffffu},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID,
                .primID = RTC_INVALID_GEOMETRY_ID,
                .instID = {RTC_INVALID_GEOMETRY_ID}},
    };
    intersect(scene, &hit);
    return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}
