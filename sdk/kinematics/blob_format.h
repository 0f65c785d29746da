/* The layout of a .dmo file. Little-endian, every number spelt out byte by byte, nothing of a struct's layout.
 *
 *   0  "DMO1"      4  u32 version       8  u32 CRC-32 (IEEE) of all bytes from 12 on
 *  12  u32 number of sections          16  u64 size of the file
 *  24  a table entry a section: u32 tag, u32 zero, u64 offset, u64 size; then the sections
 *
 * OBJ  f64 centre[3] size (canonical metres), f32 box min[3] max[3] (object-normalised), u64 vertices triangles seed,
 *      u32 parts (with the body), u32 zero
 * PART for each part: u32 id, parent index, triangles; f32 box min[3] max[3], centre[3], area; i32 given type
 * JNT  for each part but the body: u32 n hypotheses, i32 k (the one in force, or -1), n joints, for k = -1 one more
 * PNT  for each part but the body: f32 [512][3]
 * ALT  for each part but the body: u32 n, n times: i32 type, f32 confidence, axis[3], origin[3]
 *      (absent in files made before there were any)
 * TRI  u64 vertices, triangles; f32 [][3] positions, u32 [][3] corners, u16 [] part index
 *      (absent without picking)
 *
 * A joint: i32 type, f32 type confidence, confidence, pitch, axis[3], origin[3], lower, upper, i32 source.
 * Joints are object-normalised like all else, so a file serves hosts of any axes and unit. A reader skips tags that it
 * does not know; whatever old readers must not skip raises the version. */
#ifndef DMI_KINEMATICS_BLOB_FORMAT_H
#define DMI_KINEMATICS_BLOB_FORMAT_H

#include "kinematics/object.h"

#define DMI_BLOB_VERSION 1
#define DMI_BLOB_HEADER_SIZE 24
#define DMI_BLOB_ENTRY_SIZE 24
#define DMI_BLOB_MAX_SECTIONS 64 /* that a file of any version may list */
#define DMI_BLOB_PART_SIZE (3 * 4 + 10 * 4 + 4)
#define DMI_BLOB_POINTS_SIZE (DMI_OBJECT_POINTS * 3 * 4)
#define DMI_BLOB_TAG(a, b, c, d) ((uint32_t)(a) | (uint32_t)(b) << 8 | (uint32_t)(c) << 16 | (uint32_t)(d) << 24)
#define DMI_BLOB_MAGIC DMI_BLOB_TAG('D', 'M', 'O', '1')

enum {
    DMI_BLOB_OBJECT,
    DMI_BLOB_PARTS,
    DMI_BLOB_JOINTS,
    DMI_BLOB_POINTS,
    DMI_BLOB_ALTERNATIVES,
    DMI_BLOB_TRIANGLES,
    DMI_BLOB_SECTIONS
};
static const uint32_t dmi_blob_tags[DMI_BLOB_SECTIONS] = {
    DMI_BLOB_TAG('O', 'B', 'J', ' '), DMI_BLOB_TAG('P', 'A', 'R', 'T'), DMI_BLOB_TAG('J', 'N', 'T', ' '),
    DMI_BLOB_TAG('P', 'N', 'T', ' '), DMI_BLOB_TAG('A', 'L', 'T', ' '), DMI_BLOB_TAG('T', 'R', 'I', ' ')};

/* CRC-32 as of IEEE 802.3, zlib and PNG. */
uint32_t dmi_blob_crc(const uint8_t* bytes, size_t size);

#endif
