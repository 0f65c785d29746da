/* Computes the CRC-32 by slices (Kounavis and Berry 2005): sixteen bytes at a time, or four where a larger table would
 * take longer to make than the bytes. */
#include "kinematics/object/dmo_format.h"

#include "base/compiler.h"

#define POLYNOMIAL 0xedb88320 /* polynomial of IEEE 802.3, bits reversed */
#define ALL_BITS 0xffffffff
#define MANY 8192 /* bytes from which on sixteen at a time are faster; measured */

enum { BYTE_BITS = 8, BYTE_VALUES = 256, BYTE_MASK = 255, FEW_SLICES = 4, MANY_SLICES = 16 };

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
