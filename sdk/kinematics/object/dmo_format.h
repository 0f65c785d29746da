/* The layout of a .dmo file. Little-endian; every number is written byte by byte, independent of the layout of structs.
 *
 *   0  "DMO1"      4  u32 version       8  u32 CRC-32 (IEEE) of all bytes from 12 on
 *  12  u32 number of sections          16  u64 size of the file
 *  24  a table entry per section: u32 tag, u32 zero, u64 offset, u64 size; then the sections
 *
 * OBJ  f64 centre[3] size (canonical metres), f32 box min[3] max[3] (object-normalised), u64 vertices triangles seed,
 *      u32 parts (with the body), u32 zero
 * PART for each part: u32 id, parent index, triangles; f32 box min[3] max[3], centre[3], area; i32 given type
 * JNT  for each part but the body: u32 n hypotheses, i32 k (the one in force, or -1), n joints, for k = -1 one more
 * PT16 for each part but the body: i16 [64][3], in 1/65536 of the object's size (dmi_part_points)
 * PNT  for each part but the body: f32 [512][3]; read are points 0, 8, 16 … (in version 1, in place of PT16)
 * ALT  for each part but the body: u32 n, n times: i32 type, f32 confidence, axis[3], origin[3]
 *      (absent in files made before there were any)
 * FRE  for each part but the body: free ranges, f32 lower, upper each: of the hypotheses, of the alternatives, of
 *      slides along x, y, z; -FLT_MAX or FLT_MAX: no bound (absent in files made before there were any: no bounds)
 * HST  f32 axes[9] and unit of the host that saved (dmi_axes); for each part with k = -1 its joint in that host's
 * object frame, whose bits a host with the same axes and unit gets back (absent where no part has k = -1, and in files
 *      made before there was any)
 * LES  u32 DM_DEGRADED_*: what the object was prepared without (absent where that is nothing, and in files made before
 *      there was any)
 * CLO  for each part but the body: f32 joint value at which it is closed, of each hypothesis, then for k = -1 of its
 *      joint, inner and in HST (absent where all are 0, and in files made before there were any)
 * TRI  u64 vertices, triangles; f32 [][3] positions, u32 [][3] corners, u16 [] part index (absent without picking)
 * TREE u32 layout, zero; for each part: u32 nodes, blocks; then for each part: u32 [nodes][8] references, u32
 * [blocks][4] triangles (absent without TRI, in files of a library that has no portable trees, and in files made before
 * there were any). The portable trees of TRI's triangles with an area, which are counted within a part. A reference: 0:
 *      none; 0x80000000 | index of a block, which rise by one as they are met; else the index of a node farther on. A
 *      block of fewer than four triangles has its first one again. A layout that a reader does not know is left out
 *
 * A joint: i32 type, f32 type confidence, confidence, pitch, axis[3], origin[3], lower, upper, i32 source.
 * Joints are object-normalised like everything else but HST, so a file is independent of the host's axes and unit. A
 * reader skips tags that it does not know; a section that old readers must not skip raises the version. */
#ifndef DMI_OBJECT_DMO_FORMAT_H
#define DMI_OBJECT_DMO_FORMAT_H

#include "kinematics/object/object.h"

#define DMI_DMO_VERSION 2                      /* readers of version 1 require PNT, which version 2 lacks */
#define DMI_DMO_CHECKED_FROM 12                /* bytes before the checksummed part */
#define DMI_DMO_HEADER_SIZE 24                 /* bytes */
#define DMI_DMO_ENTRY_SIZE 24                  /* bytes */
#define DMI_DMO_MAX_SECTIONS 64                /* that a file of any version may list; by hand */
#define DMI_DMO_AXES 9                         /* numbers of dmi_axes.to_canonical in HST */
#define DMI_DMO_PART_SIZE (3 * 4 + 10 * 4 + 4) /* bytes of a part in PART */
#define DMI_DMO_POINTS_SIZE (3 * (size_t)2 * DMI_PART_POINTS)        /* bytes of a part in PT16 */
#define DMI_DMO_OLD_POINTS 512                                       /* points of a part in PNT */
#define DMI_DMO_OLD_POINTS_SIZE (3 * (size_t)4 * DMI_DMO_OLD_POINTS) /* bytes of a part in PNT */
#define DMI_DMO_VERTEX_SIZE (3 * (size_t)4)                          /* bytes of a vertex in TRI */
#define DMI_DMO_TRIANGLE_SIZE (3 * 4 + 2)                            /* bytes of a triangle in TRI */
#define DMI_DMO_TREE_LAYOUT 1
#define DMI_DMO_TREE_HEAD (2 * 4) /* bytes before the parts of TREE, and of each part there */
#define DMI_DMO_NODE_NUMBERS 8    /* numbers of a node in TREE */
#define DMI_DMO_BLOCK_NUMBERS 4   /* numbers of a block in TREE */
#define DMI_DMO_TAG(a, b, c, d) ((uint32_t)(a) | (uint32_t)(b) << 8 | (uint32_t)(c) << 16 | (uint32_t)(d) << 24)
#define DMI_DMO_MAGIC DMI_DMO_TAG('D', 'M', 'O', '1')

enum {
    DMI_DMO_OBJECT,
    DMI_DMO_PARTS,
    DMI_DMO_JOINTS,
    DMI_DMO_POINTS,
    DMI_DMO_ALTERNATIVES,
    DMI_DMO_FREE_RANGES,
    DMI_DMO_HOST_JOINTS,
    DMI_DMO_DEGRADED,
    DMI_DMO_TRIANGLES,
    DMI_DMO_CLOSED,
    DMI_DMO_TREES,
    DMI_DMO_PLAIN_POINTS, /* PNT, never written */
    DMI_DMO_SECTIONS
};
static const uint32_t dmi_dmo_tags[DMI_DMO_SECTIONS] = {
    DMI_DMO_TAG('O', 'B', 'J', ' '), DMI_DMO_TAG('P', 'A', 'R', 'T'), DMI_DMO_TAG('J', 'N', 'T', ' '),
    DMI_DMO_TAG('P', 'T', '1', '6'), DMI_DMO_TAG('A', 'L', 'T', ' '), DMI_DMO_TAG('F', 'R', 'E', ' '),
    DMI_DMO_TAG('H', 'S', 'T', ' '), DMI_DMO_TAG('L', 'E', 'S', ' '), DMI_DMO_TAG('T', 'R', 'I', ' '),
    DMI_DMO_TAG('C', 'L', 'O', ' '), DMI_DMO_TAG('T', 'R', 'E', 'E'), DMI_DMO_TAG('P', 'N', 'T', ' ')};

/* Returns the CRC-32 of IEEE 802.3, zlib and PNG. */
uint32_t dmi_dmo_crc(const uint8_t* bytes, size_t size);

/* Returns the number of bytes that dmi_dmo_write writes. trees: those of its triangles (dmi_object_stored_trees); NULL:
 * none. */
size_t dmi_dmo_size(const dmi_object* object, const dmi_bvh* trees);
void dmi_dmo_write(const dmi_object* object, const dmi_bvh* trees, uint8_t* out);
/* Reads bytes from any source, and checks all of them. Returns a valid object, DM_ERROR_BAD_DATA or DM_ERROR_VERSION.
 * axes: those of the host that loads, which need not be those of the host that saved. progress: may be NULL. */
dm_result dmi_dmo_read(dmi_env* env, dmi_picker* picker, const dmi_axes* axes, const void* data, size_t size,
                       const dmi_progress* progress, dmi_object** out_object);

#endif
