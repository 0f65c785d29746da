/* Prepared object -> .dmo bytes. */
#include <string.h>

#include "kinematics/object/dmo.h"
#include "kinematics/object/dmo_format.h"

#define SLICES 8 /* bytes at a time */

/* table[k][b]: what byte b does to the sum when k more bytes follow it. Made anew each time: a microsecond or two. */
static void make_crc_table(uint32_t table[SLICES][256]) {
    for (uint32_t b = 0; b < 256; b++) {
        uint32_t crc = b;
        for (int bit = 0; bit < 8; bit++) crc = crc >> 1 ^ (0xedb88320 & -(crc & 1));
        table[0][b] = crc;
    }
    for (int k = 1; k < SLICES; k++)
        for (uint32_t b = 0; b < 256; b++) table[k][b] = table[0][table[k - 1][b] & 255] ^ table[k - 1][b] >> 8;
}

/* CRC-32 as zlib and PNG have it, sliced (Kounavis and Berry 2005). */
uint32_t dmi_dmo_crc(const uint8_t* bytes, size_t size) {
    uint32_t table[SLICES][256], crc = 0xffffffff;
    make_crc_table(table);
    for (; size >= SLICES; size -= SLICES, bytes += SLICES) {
        uint32_t next = 0;
        for (uint32_t k = 0; k < SLICES; k++)
            next ^= table[SLICES - 1 - k][bytes[k] ^ (k < 4 ? crc >> 8 * k & 255 : 0)];
        crc = next;
    }
    for (size_t i = 0; i < size; i++) crc = table[0][(crc ^ bytes[i]) & 255] ^ crc >> 8;
    return ~crc;
}

/* Counts, and writes too when it has somewhere to. */
typedef struct writer {
    uint8_t* out; /* NULL: count alone */
    size_t size;
} writer;

static void put(writer* w, uint64_t value, int bytes) {
    for (int i = 0; w->out && i < bytes; i++) w->out[w->size + (size_t)i] = (uint8_t)(value >> (8 * i));
    w->size += (size_t)bytes;
}

static void put_u32(writer* w, uint32_t value) {
    put(w, value, 4);
}

static void put_f32(writer* w, float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put(w, bits, 4);
}

static void put_f64(writer* w, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put(w, bits, 8);
}

static void put_floats(writer* w, const float* values, size_t count) {
    for (size_t i = 0; i < count; i++) put_f32(w, values[i]);
}

static void put_vec3(writer* w, dm_vec3 v) {
    put_f32(w, v.x);
    put_f32(w, v.y);
    put_f32(w, v.z);
}

static void put_joint(writer* w, const dm_joint* joint) {
    put_u32(w, (uint32_t)joint->type);
    put_f32(w, joint->type_confidence);
    put_f32(w, joint->confidence);
    put_f32(w, joint->pitch);
    put_vec3(w, joint->axis);
    put_vec3(w, joint->origin);
    put_f32(w, joint->lower);
    put_f32(w, joint->upper);
    put_u32(w, (uint32_t)joint->source);
}

static void write_object(writer* w, const dmi_object* object) {
    for (int i = 0; i < 3; i++) put_f64(w, object->frame.centre[i]);
    put_f64(w, object->frame.size);
    put_floats(w, object->box_min, 3);
    put_floats(w, object->box_max, 3);
    put(w, object->vertex_count, 8);
    put(w, object->triangle_count, 8);
    put(w, object->seed, 8);
    put_u32(w, object->part_count);
    put_u32(w, 0);
}

static void write_parts(writer* w, const dmi_object* object) {
    for (uint32_t i = 0; i < object->part_count; i++) {
        const dmi_part* shape = &object->parts[i].shape;
        put_u32(w, shape->id);
        put_u32(w, shape->parent);
        put_u32(w, shape->face_count);
        put_floats(w, shape->box_min, 3);
        put_floats(w, shape->box_max, 3);
        put_floats(w, shape->centre, 3);
        put_f32(w, shape->area);
        put_u32(w, (uint32_t)object->parts[i].given_type);
    }
}

/* Which hypothesis is in force, told by its bits, so that loading gives these very bits back; -1 for a joint of the
 * host. */
static int32_t hypothesis_in_force(const dmi_object* object, const dmi_object_part* part) {
    for (uint32_t i = 0; i < part->hypotheses.count; i++) {
        const dm_joint joint = dmi_frame_joint_out(&object->frame, &part->hypotheses.joints[i]);
        if (memcmp(&joint, &part->joint, sizeof joint) == 0) return (int32_t)i;
    }
    return -1;
}

static void write_joints(writer* w, const dmi_object* object) {
    for (uint32_t i = 1; i < object->part_count; i++) {
        const dmi_object_part* part = &object->parts[i];
        int32_t in_force = hypothesis_in_force(object, part);
        put_u32(w, part->hypotheses.count);
        put_u32(w, (uint32_t)in_force);
        for (uint32_t j = 0; j < part->hypotheses.count; j++) put_joint(w, &part->hypotheses.joints[j]);
        if (in_force >= 0) continue;
        const dm_joint joint = dmi_frame_joint_in(&object->frame, &part->joint);
        put_joint(w, &joint);
    }
}

static void write_points(writer* w, const dmi_object* object) {
    for (uint32_t i = 1; i < object->part_count; i++) {
        put_floats(w, &object->parts[i].points[0][0], (size_t)DMI_OBJECT_POINTS * 3);
    }
}

static void write_alternatives(writer* w, const dmi_object* object) {
    for (uint32_t i = 1; i < object->part_count; i++) {
        const dmi_alternatives* all = &object->parts[i].alternatives;
        put_u32(w, all->count);
        for (uint32_t j = 0; j < all->count; j++) {
            put_u32(w, (uint32_t)all->list[j].type);
            put_f32(w, all->list[j].confidence);
            put_floats(w, all->list[j].axis, 3);
            put_floats(w, all->list[j].origin, 3);
        }
    }
}

static void write_triangles(writer* w, const dmi_object* object) {
    const dmi_mesh* mesh = object->mesh;
    put(w, mesh->vertex_count, 8);
    put(w, mesh->face_count, 8);
    put_floats(w, mesh->positions, (size_t)mesh->vertex_count * 3);
    for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++) put_u32(w, mesh->indices[i]);
    for (size_t i = 0; i < mesh->face_count; i++) put(w, mesh->face_part[i], 2);
}

static void write_all(writer* w, const dmi_object* object) {
    static void (*const writers[DMI_DMO_SECTIONS])(writer*, const dmi_object*) = {
        write_object, write_parts, write_joints, write_points, write_alternatives, write_triangles};
    uint32_t count = object->mesh ? DMI_DMO_SECTIONS : DMI_DMO_TRIANGLES;
    writer table = {w->out, DMI_DMO_HEADER_SIZE};
    w->size = DMI_DMO_HEADER_SIZE + count * DMI_DMO_ENTRY_SIZE;
    for (uint32_t i = 0; i < count; i++) {
        size_t begin = w->size;
        writers[i](w, object);
        put_u32(&table, dmi_dmo_tags[i]);
        put_u32(&table, 0);
        put(&table, begin, 8);
        put(&table, w->size - begin, 8);
    }
    writer header = {w->out, 12};
    put_u32(&header, count);
    put(&header, w->size, 8);
}

size_t dmi_dmo_size(const dmi_object* object) {
    writer w = {NULL, 0};
    write_all(&w, object);
    return w.size;
}

void dmi_dmo_write(const dmi_object* object, uint8_t* out) {
    writer w = {out, 0};
    write_all(&w, object);
    writer header = {out, 0};
    put_u32(&header, DMI_DMO_MAGIC);
    put_u32(&header, DMI_DMO_VERSION);
    put_u32(&header, dmi_dmo_crc(out + 12, w.size - 12));
}
