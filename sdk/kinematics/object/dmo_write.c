/* Writes a prepared object as .dmo bytes. */
#include <string.h>

#include "kinematics/object/dmo_bytes.h"
#include "kinematics/object/dmo_format.h"
#include "pick/backend.h"

typedef struct saved {
    const dmi_object* object;
    const dmi_bvh* trees; /* trees of its triangles; NULL: none */
} saved;

static void write_object(dmi_dmo_writer* w, const saved* from) {
    const dmi_object* object = from->object;
    for (int i = 0; i < 3; i++) dmi_put_f64(w, object->frame.centre[i]);
    dmi_put_f64(w, object->frame.size);
    dmi_put_floats(w, object->box_min, 3);
    dmi_put_floats(w, object->box_max, 3);
    dmi_put_u64(w, object->vertex_count);
    dmi_put_u64(w, object->triangle_count);
    dmi_put_u64(w, object->seed);
    dmi_put_u32(w, object->part_count);
    dmi_put_u32(w, 0);
}

static void write_parts(dmi_dmo_writer* w, const saved* from) {
    const dmi_object* object = from->object;
    for (uint32_t i = 0; i < object->part_count; i++) {
        const dmi_part* shape = &object->parts[i].shape;
        dmi_put_u32(w, shape->id);
        dmi_put_u32(w, shape->parent);
        dmi_put_u32(w, shape->face_count);
        dmi_put_floats(w, shape->box_min, 3);
        dmi_put_floats(w, shape->box_max, 3);
        dmi_put_floats(w, shape->centre, 3);
        dmi_put_f32(w, shape->area);
        dmi_put_u32(w, (uint32_t)object->parts[i].given_type);
    }
}

/* Returns the hypothesis whose bits are those of the joint in force, so that loading restores these bits. Returns -1
 * when the joint is the host's. */
static int32_t hypothesis_in_force(const dmi_object* object, const dmi_object_part* part) {
    for (uint32_t i = 0; i < part->hypotheses.count; i++) {
        const dm_joint joint = dmi_frame_joint_out(&object->frame, &part->hypotheses.joints[i]);
        /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked, and it has no padding */
        if (memcmp(&joint, &part->joint, sizeof joint) == 0) return (int32_t)i;
    }
    return -1;
}

static void write_joints(dmi_dmo_writer* w, const saved* from) {
    const dmi_object* object = from->object;
    for (uint32_t i = 1; i < object->part_count; i++) {
        const dmi_object_part* part = &object->parts[i];
        int32_t in_force = hypothesis_in_force(object, part);
        dmi_put_u32(w, part->hypotheses.count);
        dmi_put_u32(w, (uint32_t)in_force);
        for (uint32_t j = 0; j < part->hypotheses.count; j++) dmi_put_joint(w, &part->hypotheses.joints[j]);
        if (in_force >= 0) continue;
        const dm_joint joint = dmi_frame_joint_in(&object->frame, &part->joint);
        dmi_put_joint(w, &joint);
    }
}

static void write_host_joints(dmi_dmo_writer* w, const saved* from) {
    const dmi_object* object = from->object;
    const dmi_axes* axes = &object->frame.axes;
    dmi_put_floats(w, axes->to_canonical, DMI_DMO_AXES);
    dmi_put_f32(w, axes->unit);
    for (uint32_t i = 1; i < object->part_count; i++) {
        if (hypothesis_in_force(object, &object->parts[i]) < 0) dmi_put_joint(w, &object->parts[i].joint);
    }
}

static bool has_host_joints(const dmi_object* object) {
    for (uint32_t i = 1; i < object->part_count; i++) {
        if (hypothesis_in_force(object, &object->parts[i]) < 0) return true;
    }
    return false;
}

static void write_points(dmi_dmo_writer* w, const saved* from) {
    const dmi_object* object = from->object;
    for (uint32_t i = 1; i < object->part_count; i++) {
        dmi_put_signed_halves(w, object->parts[i].points.at[0], (size_t)DMI_PART_POINTS * 3);
    }
}

static void write_alternatives(dmi_dmo_writer* w, const saved* from) {
    const dmi_object* object = from->object;
    for (uint32_t i = 1; i < object->part_count; i++) {
        const dmi_alternatives* all = &object->parts[i].alternatives;
        dmi_put_u32(w, all->count);
        for (uint32_t j = 0; j < all->count; j++) {
            dmi_put_u32(w, (uint32_t)all->list[j].type);
            dmi_put_f32(w, all->list[j].confidence);
            dmi_put_floats(w, all->list[j].axis, 3);
            dmi_put_floats(w, all->list[j].origin, 3);
        }
    }
}

static void write_free_range(dmi_dmo_writer* w, dmi_free_range range) {
    const float numbers[2] = {range.lower, range.upper};
    dmi_put_floats(w, numbers, 2);
}

static void write_free_ranges(dmi_dmo_writer* w, const saved* from) {
    const dmi_object* object = from->object;
    for (uint32_t i = 1; i < object->part_count; i++) {
        const dmi_hypotheses* hypotheses = &object->parts[i].hypotheses;
        const dmi_alternatives* alternatives = &object->parts[i].alternatives;
        for (uint32_t j = 0; j < hypotheses->count; j++) write_free_range(w, hypotheses->free_range[j]);
        for (uint32_t j = 0; j < alternatives->count; j++) write_free_range(w, alternatives->list[j].free_range);
        for (int j = 0; j < 3; j++) write_free_range(w, alternatives->slides[j]);
    }
}

static void write_degraded(dmi_dmo_writer* w, const saved* from) {
    const dmi_object* object = from->object;
    dmi_put_u32(w, object->degraded);
}

static void write_closed(dmi_dmo_writer* w, const saved* from) {
    const dmi_object* object = from->object;
    for (uint32_t i = 1; i < object->part_count; i++) {
        const dmi_object_part* part = &object->parts[i];
        for (uint32_t j = 0; j < part->hypotheses.count; j++) dmi_put_f32(w, part->hypotheses.joints[j].closed);
        if (hypothesis_in_force(object, part) >= 0) continue;
        dmi_put_f32(w, dmi_frame_joint_in(&object->frame, &part->joint).closed);
        dmi_put_f32(w, part->joint.closed);
    }
}

static bool has_closed(const dmi_object* object) {
    for (uint32_t i = 1; i < object->part_count; i++) {
        const dmi_object_part* part = &object->parts[i];
        if (part->joint.closed != 0) return true;
        for (uint32_t j = 0; j < part->hypotheses.count; j++)
            if (part->hypotheses.joints[j].closed != 0) return true;
    }
    return false;
}

/* Returns a writer for element `i` of an array that begins at `begin`. */
static dmi_dmo_writer element_writer(const dmi_dmo_writer* w, size_t begin, size_t i, size_t size) {
    return (dmi_dmo_writer){w->out, begin + i * size};
}

/* Writes the triangles in the order that the mesh had. */
static void write_triangles(dmi_dmo_writer* w, const saved* from) {
    enum { CORNERS_SIZE = 3 * sizeof(uint32_t) };
    const dmi_packed_mesh* mesh = from->object->mesh;
    dmi_put_u64(w, mesh->vertex_count);
    dmi_put_u64(w, mesh->face_count);
    dmi_put_floats(w, mesh->positions, (size_t)mesh->vertex_count * 3);
    const size_t corners = w->size, parts = corners + (size_t)mesh->face_count * CORNERS_SIZE;
    w->size = parts + (size_t)mesh->face_count * sizeof(uint16_t);
    for (uint32_t p = 0; w->out != NULL && p < mesh->part_count; p++) {
        const uint32_t first = mesh->parts[p].first_face, end = first + mesh->parts[p].face_count;
        for (uint32_t f = first; f < end; f++) {
            const uint32_t face = dmi_packed_of_mesh(mesh, f);
            dmi_dmo_writer corner = element_writer(w, corners, face, CORNERS_SIZE),
                           part = element_writer(w, parts, face, 2);
            for (int i = 0; i < 3; i++) dmi_put_u32(&corner, dmi_packed_corner(mesh, f, i));
            dmi_put_u16(&part, p);
        }
    }
}

static void write_tree(dmi_dmo_writer* w, const dmi_tree_shape* shape) {
    for (uint32_t n = 0; n < shape->node_count; n++)
        dmi_put_words(w, shape->child + n * shape->child_step, DMI_DMO_NODE_NUMBERS);
    for (uint32_t n = 0; n < shape->block_count; n++)
        dmi_put_words(w, shape->face + n * shape->face_step, DMI_DMO_BLOCK_NUMBERS);
}

static void write_trees(dmi_dmo_writer* w, const saved* from) {
    const uint32_t parts = from->object->part_count;
    dmi_tree_shape shape;
    dmi_put_u32(w, DMI_DMO_TREE_LAYOUT);
    dmi_put_u32(w, 0);
    for (uint32_t p = 0; p < parts; p++) {
        dmi_bvh_shapes(from->trees, p, &shape);
        dmi_put_u32(w, shape.node_count);
        dmi_put_u32(w, shape.block_count);
    }
    for (uint32_t p = 0; p < parts; p++) {
        dmi_bvh_shapes(from->trees, p, &shape);
        write_tree(w, &shape);
    }
}

/* Lists the sections that an object has. Returns how many there are. */
static uint32_t list_sections(const saved* from, bool out_present[DMI_DMO_SECTIONS]) {
    const dmi_object* object = from->object;
    uint32_t count = 0;
    for (int i = 0; i < DMI_DMO_SECTIONS; i++) out_present[i] = true;
    out_present[DMI_DMO_HOST_JOINTS] = has_host_joints(object);
    out_present[DMI_DMO_DEGRADED] = object->degraded != 0;
    out_present[DMI_DMO_CLOSED] = has_closed(object);
    out_present[DMI_DMO_TRIANGLES] = object->mesh != NULL;
    out_present[DMI_DMO_TREES] = from->trees != NULL;
    out_present[DMI_DMO_PLAIN_POINTS] = false;
    for (int i = 0; i < DMI_DMO_SECTIONS; i++) count += out_present[i];
    return count;
}

static void write_all(dmi_dmo_writer* w, const saved* from) {
    static void (*const writers[DMI_DMO_SECTIONS])(dmi_dmo_writer*, const saved*) = {
        write_object,      write_parts,    write_joints,    write_points, write_alternatives, write_free_ranges,
        write_host_joints, write_degraded, write_triangles, write_closed, write_trees,        NULL};
    bool present[DMI_DMO_SECTIONS];
    const uint32_t count = list_sections(from, present);
    dmi_dmo_writer table = {w->out, DMI_DMO_HEADER_SIZE};
    w->size = DMI_DMO_HEADER_SIZE + count * DMI_DMO_ENTRY_SIZE;
    for (uint32_t i = 0; i < DMI_DMO_SECTIONS; i++) {
        if (!present[i]) continue;
        size_t begin = w->size;
        writers[i](w, from);
        dmi_put_u32(&table, dmi_dmo_tags[i]);
        dmi_put_u32(&table, 0);
        dmi_put_u64(&table, begin);
        dmi_put_u64(&table, w->size - begin);
    }
    dmi_dmo_writer header = {w->out, DMI_DMO_CHECKED_FROM};
    dmi_put_u32(&header, count);
    dmi_put_u64(&header, w->size);
}

size_t dmi_dmo_size(const dmi_object* object, const dmi_bvh* trees) {
    const saved from = {object, trees};
    dmi_dmo_writer w = {NULL, 0};
    write_all(&w, &from);
    return w.size;
}

void dmi_dmo_write(const dmi_object* object, const dmi_bvh* trees, uint8_t* out) {
    const saved from = {object, trees};
    dmi_dmo_writer w = {out, 0};
    write_all(&w, &from);
    dmi_dmo_writer header = {out, 0};
    dmi_put_u32(&header, DMI_DMO_MAGIC);
    dmi_put_u32(&header, DMI_DMO_VERSION);
    dmi_put_u32(&header, dmi_dmo_crc(out + DMI_DMO_CHECKED_FROM, w.size - DMI_DMO_CHECKED_FROM));
}
