/* Converts numbers byte by byte, and computes the checksum of bytes. */
#include "kinematics/object/dmo_bytes.h"

#include <string.h>

#include "base/compiler.h"
#include "kinematics/object/dmo_format.h"

enum { BYTE_BITS = 8 };

/* Returns whether numbers lie in memory as in the file, so that arrays can be copied. */
static bool is_little_endian(void) {
    const uint16_t one = 1;
    uint8_t low;
    memcpy(&low, &one, sizeof low);
    return low == 1;
}

/* ---- reader ---- */

static uint64_t get_number(dmi_dmo_reader* r, uint32_t bytes) {
    if (r->left < bytes) {
        r->overrun = true;
        r->left = 0;
        return 0;
    }
    uint64_t value = 0;
    for (uint32_t i = 0; i < bytes; i++) value |= (uint64_t)r->at[i] << (BYTE_BITS * i);
    r->at += bytes;
    r->left -= bytes;
    return value;
}

uint32_t dmi_get_u16(dmi_dmo_reader* r) {
    return (uint32_t)get_number(r, sizeof(uint16_t));
}

uint32_t dmi_get_u32(dmi_dmo_reader* r) {
    return (uint32_t)get_number(r, sizeof(uint32_t));
}

uint64_t dmi_get_u64(dmi_dmo_reader* r) {
    return get_number(r, sizeof(uint64_t));
}

float dmi_get_f32(dmi_dmo_reader* r) {
    uint32_t bits = dmi_get_u32(r);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

double dmi_get_f64(dmi_dmo_reader* r) {
    uint64_t bits = dmi_get_u64(r);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

void dmi_get_words(dmi_dmo_reader* r, void* out, size_t count) {
    const size_t size = count * sizeof(uint32_t);
    if (is_little_endian() && r->left >= size) {
        memcpy(out, r->at, size);
        r->at += size;
        r->left -= size;
        return;
    }
    for (size_t i = 0; i < count; i++) {
        const uint32_t word = dmi_get_u32(r);
        memcpy((uint8_t*)out + i * sizeof word, &word, sizeof word);
    }
}

void dmi_get_halves(dmi_dmo_reader* r, uint32_t* out, size_t count) {
    const uint8_t* at = r->at;
    if (r->left < count * sizeof(uint16_t)) {
        for (size_t i = 0; i < count; i++) out[i] = dmi_get_u16(r);
        return;
    }
    for (size_t i = 0; i < count; i++) out[i] = (uint32_t)at[2 * i] | (uint32_t)at[2 * i + 1] << BYTE_BITS;
    r->at += count * sizeof(uint16_t);
    r->left -= count * sizeof(uint16_t);
}

void dmi_get_signed_halves(dmi_dmo_reader* r, int16_t* out, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const uint16_t half = (uint16_t)dmi_get_u16(r);
        memcpy(&out[i], &half, sizeof half);
    }
}

void dmi_get_floats(dmi_dmo_reader* r, float* out, size_t count) {
    dmi_get_words(r, out, count);
}

static dm_vec3 get_vec3(dmi_dmo_reader* r) {
    float v[3];
    dmi_get_floats(r, v, 3);
    return (dm_vec3){v[0], v[1], v[2]};
}

void dmi_get_joint(dmi_dmo_reader* r, dm_joint* out) {
    *out = (dm_joint){.type = (int32_t)dmi_get_u32(r)};
    out->type_confidence = dmi_get_f32(r);
    out->joint_confidence = dmi_get_f32(r);
    out->pitch = dmi_get_f32(r);
    out->axis = get_vec3(r);
    out->origin = get_vec3(r);
    out->lower = dmi_get_f32(r);
    out->upper = dmi_get_f32(r);
    out->source = (int32_t)dmi_get_u32(r);
}

/* ---- writer ---- */

static void put_number(dmi_dmo_writer* w, uint64_t value, size_t bytes) {
    for (size_t i = 0; w->out != NULL && i < bytes; i++) w->out[w->size + i] = (uint8_t)(value >> (BYTE_BITS * i));
    w->size += bytes;
}

void dmi_put_u16(dmi_dmo_writer* w, uint32_t value) {
    put_number(w, value, sizeof(uint16_t));
}

void dmi_put_u32(dmi_dmo_writer* w, uint32_t value) {
    put_number(w, value, sizeof value);
}

void dmi_put_u64(dmi_dmo_writer* w, uint64_t value) {
    put_number(w, value, sizeof value);
}

void dmi_put_f32(dmi_dmo_writer* w, float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    dmi_put_u32(w, bits);
}

void dmi_put_f64(dmi_dmo_writer* w, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    dmi_put_u64(w, bits);
}

void dmi_put_words(dmi_dmo_writer* w, const void* values, size_t count) {
    const size_t size = count * sizeof(uint32_t);
    if (is_little_endian()) {
        if (w->out != NULL) memcpy(w->out + w->size, values, size);
        w->size += size;
        return;
    }
    for (size_t i = 0; i < count; i++) {
        uint32_t word;
        memcpy(&word, (const uint8_t*)values + i * sizeof word, sizeof word);
        dmi_put_u32(w, word);
    }
}

void dmi_put_signed_halves(dmi_dmo_writer* w, const int16_t* values, size_t count) {
    for (size_t i = 0; i < count; i++) dmi_put_u16(w, (uint16_t)values[i]);
}

void dmi_put_floats(dmi_dmo_writer* w, const float* values, size_t count) {
    dmi_put_words(w, values, count);
}

static void put_vec3(dmi_dmo_writer* w, dm_vec3 v) {
    dmi_put_f32(w, v.x);
    dmi_put_f32(w, v.y);
    dmi_put_f32(w, v.z);
}

void dmi_put_joint(dmi_dmo_writer* w, const dm_joint* joint) {
    dmi_put_u32(w, (uint32_t)joint->type);
    dmi_put_f32(w, joint->type_confidence);
    dmi_put_f32(w, joint->joint_confidence);
    dmi_put_f32(w, joint->pitch);
    put_vec3(w, joint->axis);
    put_vec3(w, joint->origin);
    dmi_put_f32(w, joint->lower);
    dmi_put_f32(w, joint->upper);
    dmi_put_u32(w, (uint32_t)joint->source);
}

/* ---- checksum ---- */

#define POLYNOMIAL 0xedb88320 /* polynomial of IEEE 802.3, bits reversed */
#define ALL_BITS 0xffffffff
#define MANY 8192 /* bytes from which on sixteen at a time are faster; measured */

enum { BYTE_VALUES = 256, BYTE_MASK = 255, FEW_SLICES = 4, MANY_SLICES = 16 };

/* Sets table[k][b] to the contribution of byte b when k more bytes follow it. This takes a microsecond or two, so every
 * call does it. */
static void make_table(uint32_t (*table)[BYTE_VALUES], int slices) {
    for (uint32_t b = 0; b < BYTE_VALUES; b++) {
        uint32_t crc = b;
        for (int bit = 0; bit < BYTE_BITS; bit++) crc = crc >> 1 ^ (POLYNOMIAL & -(crc & 1));
        table[0][b] = crc;
    }
    for (int k = 1; k < slices; k++)
        for (uint32_t b = 0; b < BYTE_VALUES; b++)
            table[k][b] = table[0][table[k - 1][b] & BYTE_MASK] ^ table[k - 1][b] >> BYTE_BITS;
}

DMI_ALWAYS_INLINE static inline uint32_t crc_by(uint32_t (*table)[BYTE_VALUES], size_t slices, const uint8_t* bytes,
                                                size_t size) {
    uint32_t crc = ALL_BITS;
    make_table(table, (int)slices);
    for (; size >= slices; size -= slices, bytes += slices) {
        uint32_t next = 0;
        for (uint32_t k = 0; k < slices; k++) {
            const uint32_t byte = k < sizeof crc ? crc >> BYTE_BITS * k & BYTE_MASK : 0;
            next ^= table[slices - 1 - k][bytes[k] ^ byte];
        }
        crc = next;
    }
    for (size_t i = 0; i < size; i++) crc = table[0][(crc ^ bytes[i]) & BYTE_MASK] ^ crc >> BYTE_BITS;
    return ~crc;
}

uint32_t dmi_dmo_crc(const uint8_t* bytes, size_t size) {
    uint32_t table[MANY_SLICES][BYTE_VALUES];
    return size < MANY ? crc_by(table, FEW_SLICES, bytes, size) : crc_by(table, MANY_SLICES, bytes, size);
}
