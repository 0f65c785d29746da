/* Reads and writes little-endian numbers in a block of bytes. */
#ifndef DMI_OBJECT_DMO_BYTES_H
#define DMI_OBJECT_DMO_BYTES_H

#include <stdbool.h>
#include <stddef.h>

#include "dragmesh/dragmesh.h"

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

#endif
