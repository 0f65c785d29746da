/* A rigged asset as its rig.json states it, for programs that compare what consumers load with it: where every corner
 * of every part's triangles is, at any values of the joints. Z up, metres, as the files for simulators have it. */
#ifndef TESTS_EXPORTS_RIGGED_ASSET_H
#define TESTS_EXPORTS_RIGGED_ASSET_H

#include <stdbool.h>
#include <stddef.h>

typedef struct rigged_part {
    int parent; /* -1: the body */
    bool moves;
    char type[16];
    double axis[3], origin[3], lower, upper, pitch;
    double (*corners)[3]; /* of its triangles and of those of what is fixed to it, at rest, Z up */
    size_t corner_count;
    size_t* node_corners; /* of each node, in their order */
    int node_count;
} rigged_part;

typedef struct rigged_asset {
    rigged_part* parts; /* one more than rig.json has: the last is the body */
    int count;          /* without the body */
    double size;
} rigged_asset;

/* Reads an asset's file and the rig.json in a folder. Returns false where one can't be read. */
bool rigged_open(const char* file, const char* folder, rigged_asset* out);
void rigged_close(rigged_asset* asset);
/* A value of a joint at a share of its range; of one without limits, of a quarter turn or a quarter of the asset. */
double rigged_value(const rigged_asset* asset, int part, double share);
/* Writes where a corner of a part is at the joints' values. */
void rigged_corner(const rigged_asset* asset, int part, size_t corner, const double* values, double out[3]);
/* How many corners of a file's mesh are those of the node: a single triangle has another one at its back, because
 * MuJoCo 3 asks for four points. 0: the mesh is not that of the node. */
size_t rigged_node_corners(const rigged_part* part, int node, size_t corners);
/* The part that a body is called after: "part_3_door" is part 2; the body: asset->count; -1: another name. */
int rigged_part_called(const rigged_asset* asset, const char* name);

#endif
