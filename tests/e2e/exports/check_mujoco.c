/* check_mujoco FILE.glb FOLDER [FILE.glb FOLDER …] — loads rigged.urdf and rigged.xml of each folder in MuJoCo, drives
 * each joint through its range, and compares where all corners of all triangles are with what rig.json says. Steps
 * rigged.xml 1,000 frames. Prints a line an asset, and exits with 1 where one did not load, is off by more than 1e-4 of
 * its size, or flies off. */
#include <math.h>
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rigged_asset.h"

enum { FRAMES = 1000, STEPS = 4, MESSAGE = 1000 };
static const double tolerance = 1e-4; /* share of the asset's size */
static const double farthest = 3;     /* sizes of the asset that a body may be away after the frames; by hand */

typedef struct outcome {
    int joints, screws_left_out, uncompared;
    double worst; /* share of the size */
    bool failed;
} outcome;

/* The part of each body of the model. In what MuJoCo reads of URDF the world is the body. */
static int part_of_body(const rigged_asset* asset, const mjModel* m, int body) {
    return body == 0 ? asset->count : rigged_part_called(asset, mj_id2name(m, mjOBJ_BODY, body));
}

static void set_values(const rigged_asset* asset, const mjModel* m, mjData* d, const double* values) {
    for (int j = 0; j < m->njnt; j++) {
        const int part = part_of_body(asset, m, m->jnt_bodyid[j]);
        if (part < 0 || m->jnt_type[j] == mjJNT_FREE) continue;
        const bool advances = m->jnt_type[j] == mjJNT_SLIDE && strcmp(asset->parts[part].type, "prismatic") != 0;
        d->qpos[m->jnt_qposadr[j]] = advances ? asset->parts[part].pitch * values[part] : values[part];
    }
    mj_kinematics(m, d);
}

/* How far the corners of a mesh of the model are from those of the part, from corner `from` on; sizes of the asset. */
static double compare_geom(const rigged_asset* asset, const mjModel* m, const mjData* d, int geom, int part,
                           size_t from, size_t corners, const double* values) {
    const int mesh = m->geom_dataid[geom];
    double worst = 0;
    for (int i = 0; i < (int)corners; i++) {
        const float* v = m->mesh_vert + 3 * (m->mesh_vertadr[mesh] + m->mesh_face[3 * m->mesh_faceadr[mesh] + i]);
        const mjtNum local[3] = {(mjtNum)v[0], (mjtNum)v[1], (mjtNum)v[2]};
        mjtNum there[3];
        double here[3], off = 0;
        mju_rotVecMat(there, local, d->geom_xmat + 9 * geom);
        mju_addTo3(there, d->geom_xpos + 3 * geom);
        rigged_corner(asset, part, from + (size_t)i, values, here);
        for (int k = 0; k < 3; k++) off = fmax(off, fabs(there[k] - here[k]));
        worst = fmax(worst, off / asset->size);
    }
    return worst;
}

static void compare(const rigged_asset* asset, const mjModel* m, const mjData* d, const double* values, outcome* out) {
    size_t* seen = calloc((size_t)asset->count + 1, sizeof *seen);
    int* nodes = calloc((size_t)asset->count + 1, sizeof *nodes);
    for (int g = 0; g < m->ngeom; g++) {
        if (m->geom_type[g] != mjGEOM_MESH) continue;
        const int part = part_of_body(asset, m, m->geom_bodyid[g]);
        const size_t all = 3 * (size_t)m->mesh_facenum[m->geom_dataid[g]];
        const size_t corners = part < 0 ? 0 : rigged_node_corners(&asset->parts[part], nodes[part]++, all);
        if (corners == 0) {
            out->uncompared++;
            continue;
        }
        out->worst = fmax(out->worst, compare_geom(asset, m, d, g, part, seen[part], corners, values));
        seen[part] += corners;
    }
    for (int p = 0; p <= asset->count; p++) out->uncompared += seen[p] != asset->parts[p].corner_count;
    free(seen);
    free(nodes);
}

/* Drives one joint after the other, and then all at once. */
static void drive(const rigged_asset* asset, const mjModel* m, mjData* d, bool has_screws, outcome* out) {
    double* values = calloc((size_t)asset->count + 1, sizeof *values);
    set_values(asset, m, d, values);
    compare(asset, m, d, values, out);
    for (int p = 0; p < asset->count; p++) {
        if (!asset->parts[p].moves) continue;
        const bool left_out = strcmp(asset->parts[p].type, "screw") == 0 && !has_screws;
        out->screws_left_out += left_out;
        out->joints++;
        for (int step = 0; step <= STEPS && !left_out; step++) {
            values[p] = rigged_value(asset, p, (double)step / STEPS);
            set_values(asset, m, d, values);
            compare(asset, m, d, values, out);
        }
        values[p] = 0;
    }
    for (int p = 0; p < asset->count; p++)
        values[p] = strcmp(asset->parts[p].type, "screw") == 0 && !has_screws ? 0 : rigged_value(asset, p, 0.5);
    set_values(asset, m, d, values);
    compare(asset, m, d, values, out);
    free(values);
}

/* Lets the asset alone for some frames. */
static void step(const rigged_asset* asset, const mjModel* m, mjData* d, outcome* out) {
    mj_resetData(m, d);
    mj_kinematics(m, d);
    double* rest = calloc((size_t)m->nbody * 3, sizeof *rest);
    memcpy(rest, d->xipos, (size_t)m->nbody * 3 * sizeof *rest);
    for (int i = 0; i < FRAMES; i++) mj_step(m, d);
    for (int b = 1; b < m->nbody; b++) {
        const double away = mju_dist3(rest + 3 * b, d->xipos + 3 * b);
        if (away <= farthest * asset->size) continue;
        printf("  %s is %g sizes away after %d frames\n", mj_id2name(m, mjOBJ_BODY, b), away / asset->size, FRAMES);
        out->failed = true;
    }
    for (int w = 0; w < mjNWARNING; w++) out->failed |= d->warning[w].number > 0;
    free(rest);
}

static outcome check(const rigged_asset* asset, const char* folder, const char* name, bool is_mjcf) {
    char path[4096], message[MESSAGE] = "";
    outcome out = {.joints = 0};
    snprintf(path, sizeof path, "%s/%s", folder, name);
    mjModel* m = mj_loadXML(path, NULL, message, sizeof message);
    if (m == NULL) {
        printf("  %s: %s\n", path, message);
        return (outcome){.failed = true};
    }
    mjData* d = mj_makeData(m);
    drive(asset, m, d, is_mjcf, &out);
    if (is_mjcf) step(asset, m, d, &out);
    out.failed |= !(out.worst <= tolerance) || out.uncompared > 0;
    mj_deleteData(d);
    mj_deleteModel(m);
    return out;
}

int main(int argc, char** argv) {
    int failed = 0, joints = 0;
    double worst = 0;
    for (int i = 1; i + 1 < argc; i += 2) {
        rigged_asset asset;
        if (!rigged_open(argv[i], argv[i + 1], &asset)) {
            printf("%s: it or its rig.json can't be read\n", argv[i]);
            failed++;
            continue;
        }
        const outcome urdf = check(&asset, argv[i + 1], "rigged.urdf", false);
        const outcome mjcf = check(&asset, argv[i + 1], "rigged.xml", true);
        printf(
            "%s: %d joints, off by %.2g and %.2g of the size; %d screws that URDF has not, %d meshes not compared%s\n",
            argv[i + 1], mjcf.joints, urdf.worst, mjcf.worst, urdf.screws_left_out, urdf.uncompared + mjcf.uncompared,
            urdf.failed || mjcf.failed ? ": FAILED" : "");
        failed += urdf.failed || mjcf.failed;
        joints += mjcf.joints;
        worst = fmax(worst, fmax(urdf.worst, mjcf.worst));
        rigged_close(&asset);
    }
    printf("MuJoCo %s: %d assets, %d joints, %d failed, off by %.2g of the size at most\n", mj_versionString(),
           (argc - 1) / 2, joints, failed, worst);
    return failed > 0;
}
