/* CRC-32 by slices of sixteen bytes (Kounavis and Berry 2005). */
#include "kinematics/object/dmo_format.h"

#define POLYNOMIAL 0xedb88320 /* of IEEE 802.3, bits reversed */
#define ALL_BITS 0xffffffff

enum { BYTE_BITS = 8, BYTE_VALUES = 256, BYTE_MASK = 255, SLICES = 16 }; /* SLICES: bytes at a time */

/* Sets table[k][b] to the contribution of byte b when k more bytes follow it. Takes a microsecond or two, so that it is
 * computed in every call. */
static void make_table(uint32_t table[SLICES][BYTE_VALUES]) {
    for (uint32_t b = 0; b < BYTE_VALUES; b++) {
        uint32_t crc = b;
        for (int bit = 0; bit < BYTE_BITS; bit++) crc = crc >> 1 ^ (POLYNOMIAL & -(crc & 1));
        table[0][b] = crc;
    }
    for (int k = 1; k < SLICES; k++)
        for (uint32_t b = 0; b < BYTE_VALUES; b++)
            table[k][b] = table[0][table[k - 1][b] & BYTE_MASK] ^ table[k - 1][b] >> BYTE_BITS;
}

uint32_t dmi_dmo_crc(const uint8_t* bytes, size_t size) {
    uint32_t table[SLICES][BYTE_VALUES], crc = ALL_BITS;
    make_table(table);
    for (; size >= SLICES; size -= SLICES, bytes += SLICES) {
        uint32_t next = 0;
        for (uint32_t k = 0; k < SLICES; k++) {
            const uint32_t byte = k < sizeof crc ? crc >> BYTE_BITS * k & BYTE_MASK : 0;
            next ^= table[SLICES - 1 - k][bytes[k] ^ byte];
        }
        crc = next;
    }
    for (size_t i = 0; i < size; i++) crc = table[0][(crc ^ bytes[i]) & BYTE_MASK] ^ crc >> BYTE_BITS;
    return ~crc;
}
