/* Numbers of a .dmo file: reads and writes them, little-endian, in a block of bytes, and checks those that were read.
 */
#ifndef DMI_OBJECT_DMO_BYTES_H
#define DMI_OBJECT_DMO_BYTES_H

#include <stdbool.h>
#include <stddef.h>

#include "kinematics/object/object.h"

/* A reader of a block of bytes. It reads zeros beyond the end, and sets `overrun`. */
typedef struct dmi_dmo_reader {
    const uint8_t* at;
    uint64_t left; /* bytes */
    bool overrun;
} dmi_dmo_reader;

uint32_t dmi_get_u16(dmi_dmo_reader* r);
uint32_t dmi_get_u32(dmi_dmo_reader* r);
uint64_t dmi_get_u64(dmi_dmo_reader* r);
float dmi_get_f32(dmi_dmo_reader* r);
double dmi_get_f64(dmi_dmo_reader* r);
/* Reads `count` numbers of 32 bits, of any type. */
void dmi_get_words(dmi_dmo_reader* r, void* out, size_t count);
/* Reads `count` numbers of 16 bits. */
void dmi_get_halves(dmi_dmo_reader* r, uint32_t* out, size_t count);
void dmi_get_signed_halves(dmi_dmo_reader* r, int16_t* out, size_t count);
void dmi_get_floats(dmi_dmo_reader* r, float* out, size_t count);
void dmi_get_joint(dmi_dmo_reader* r, dm_joint* out);

/* Counts bytes and, if `out` is given, writes them. */
typedef struct dmi_dmo_writer {
    uint8_t* out; /* NULL: count alone */
    size_t size;
} dmi_dmo_writer;

void dmi_put_u16(dmi_dmo_writer* w, uint32_t value);
void dmi_put_u32(dmi_dmo_writer* w, uint32_t value);
void dmi_put_u64(dmi_dmo_writer* w, uint64_t value);
void dmi_put_f32(dmi_dmo_writer* w, float value);
void dmi_put_f64(dmi_dmo_writer* w, double value);
void dmi_put_words(dmi_dmo_writer* w, const void* values, size_t count);
void dmi_put_signed_halves(dmi_dmo_writer* w, const int16_t* values, size_t count);
void dmi_put_floats(dmi_dmo_writer* w, const float* values, size_t count);
void dmi_put_joint(dmi_dmo_writer* w, const dm_joint* joint);

/* ---- dmo_check.c: checks of numbers that were read ---- */

/* Object-normalised coordinates of a surface lie within 0.5, those of unused vertices within 1. */
#define DMI_DMO_MAX_COORDINATE 1.0f

/* Each of these functions returns whether the values are ones that an object may have. A NaN never is. */
bool dmi_dmo_within(const float* values, size_t count, float limit); /* |values[i]| <= limit */
bool dmi_dmo_valid_object(const dmi_object* object);                 /* frame, box and counts */
bool dmi_dmo_valid_shape(const dmi_part* shape);
bool dmi_dmo_valid_tree(const dmi_object* object);       /* ids rise, every chain of parents ends at the body */
bool dmi_dmo_valid_joint_numbers(const dm_joint* joint); /* checks the numbers in whatever frame they are */
/* Returns whether a joint is valid in the inner frame and in the host's, where its numbers may be too large. */
bool dmi_dmo_valid_joint(const dmi_frame* frame, const dm_joint* inner);
bool dmi_dmo_valid_alternative(const dmi_frame* frame, const dmi_alternative* alternative);

#endif
