/* Makes a prepared object of .dmo bytes. They may come from anywhere, so every number is checked before it is used. */
#include <string.h>

#include <float.h>

#include "base/env.h"
#include "kinematics/object/dmo_bytes.h"
#include "kinematics/object/dmo_format.h"
#include "kinematics/object/object.h"
#include "pick/backend.h"

typedef struct loading {
    dmi_env* env;
    const dmi_axes* axes;
    const dmi_progress* progress;
    bool same_host;                            /* the host that saved has the same axes and unit */
    dmi_dmo_reader sections[DMI_DMO_SECTIONS]; /* readers of the sections; an absent section is at NULL */
    dmi_object* object;
} loading;

static dm_result refuse_data(const loading* load, const char* what) {
    return dmi_fail(load->env, DM_ERROR_BAD_DATA, "dm_object_load: %s", what);
}

static dm_result read_header(const loading* load, const uint8_t* data, size_t size, uint32_t* out_sections) {
    dmi_dmo_reader r = {data, size, false};
    if (dmi_get_u32(&r) != DMI_DMO_MAGIC || size < DMI_DMO_HEADER_SIZE) return refuse_data(load, "not a .dmo file");
    uint32_t version = dmi_get_u32(&r), crc = dmi_get_u32(&r);
    if (version > DMI_DMO_VERSION) {
        return dmi_fail(load->env, DM_ERROR_VERSION,
                        "dm_object_load: the file has version %u, this library reads up to %d", version,
                        DMI_DMO_VERSION);
    }
    *out_sections = dmi_get_u32(&r);
    uint64_t whole = dmi_get_u64(&r);
    if (version == 0 || whole != size || *out_sections > DMI_DMO_MAX_SECTIONS ||
        size < DMI_DMO_HEADER_SIZE + (size_t)*out_sections * DMI_DMO_ENTRY_SIZE) {
        return dmi_fail(load->env, DM_ERROR_BAD_DATA, "dm_object_load: %zu bytes of a file of %llu", size,
                        (unsigned long long)whole);
    }
    return crc == dmi_dmo_crc(data + DMI_DMO_CHECKED_FROM, size - DMI_DMO_CHECKED_FROM)
               ? DM_OK
               : refuse_data(load, "the checksum is wrong");
}

static dm_result read_table(loading* load, const uint8_t* data, size_t size) {
    uint32_t count = 0;
    dm_result result = read_header(load, data, size, &count);
    if (result != DM_OK) return result;
    dmi_dmo_reader table = {data + DMI_DMO_HEADER_SIZE, (uint64_t)count * DMI_DMO_ENTRY_SIZE, false};
    for (uint32_t i = 0; i < count; i++) {
        uint32_t tag = dmi_get_u32(&table);
        dmi_get_u32(&table);
        uint64_t offset = dmi_get_u64(&table), length = dmi_get_u64(&table);
        if (offset > size || length > size - offset) return refuse_data(load, "a section lies outside the file");
        for (int s = 0; s < DMI_DMO_SECTIONS; s++) {
            if (tag != dmi_dmo_tags[s]) continue;
            if (load->sections[s].at != NULL) return refuse_data(load, "a section comes twice");
            load->sections[s] = (dmi_dmo_reader){data + offset, length, false};
        }
    }
    bool complete = load->sections[DMI_DMO_POINTS].at != NULL || load->sections[DMI_DMO_PLAIN_POINTS].at != NULL;
    for (int s = 0; s < DMI_DMO_POINTS; s++) complete = complete && load->sections[s].at != NULL;
    return complete ? DM_OK : refuse_data(load, "a section is missing");
}

/* Whether the section that holds the points has the size that these parts need. */
static bool fits_points(const loading* load, uint32_t part_count) {
    const dmi_dmo_reader *points = &load->sections[DMI_DMO_POINTS], *plain = &load->sections[DMI_DMO_PLAIN_POINTS];
    return points->at != NULL ? points->left == (uint64_t)(part_count - 1) * DMI_DMO_POINTS_SIZE
                              : plain->left == (uint64_t)(part_count - 1) * DMI_DMO_OLD_POINTS_SIZE;
}

static dm_result read_object(loading* load) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_OBJECT];
    dmi_object head = {.frame = {.axes = *load->axes}};
    for (int i = 0; i < 3; i++) head.frame.centre[i] = dmi_get_f64(r);
    head.frame.size = dmi_get_f64(r);
    dmi_get_floats(r, head.box_min, 3);
    dmi_get_floats(r, head.box_max, 3);
    head.vertex_count = dmi_get_u64(r);
    head.triangle_count = dmi_get_u64(r);
    head.seed = dmi_get_u64(r);
    uint32_t part_count = dmi_get_u32(r);
    if (r->overrun || !dmi_dmo_valid_object(&head)) return refuse_data(load, "section OBJ holds impossible numbers");
    /* The sections must have the size that these parts need, so that no number makes the reader allocate more than the
     * file holds. */
    if (part_count < 2 || part_count > DM_MAX_PARTS + 1 ||
        load->sections[DMI_DMO_PARTS].left != (uint64_t)part_count * DMI_DMO_PART_SIZE ||
        !fits_points(load, part_count)) {
        return refuse_data(load, "the number of parts does not fit the file");
    }
    dm_result result = dmi_object_create(load->env, part_count, &load->object);
    if (result != DM_OK) return result;
    head.parts = load->object->parts;
    head.part_count = part_count;
    *load->object = head;
    return DM_OK;
}

static dm_result read_parts(loading* load) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_PARTS];
    for (uint32_t i = 0; i < load->object->part_count; i++) {
        dmi_object_part* part = &load->object->parts[i];
        dmi_part* shape = &part->shape;
        shape->id = dmi_get_u32(r);
        shape->parent = dmi_get_u32(r);
        shape->face_count = dmi_get_u32(r);
        dmi_get_floats(r, shape->box_min, 3);
        dmi_get_floats(r, shape->box_max, 3);
        dmi_get_floats(r, shape->centre, 3);
        shape->area = dmi_get_f32(r);
        part->given_type = (int32_t)dmi_get_u32(r);
        if (!dmi_dmo_valid_shape(shape) || part->given_type < DM_JOINT_UNKNOWN || part->given_type > DM_JOINT_FIXED) {
            return refuse_data(load, "section PART holds impossible numbers");
        }
    }
    return dmi_dmo_valid_tree(load->object) ? DM_OK : refuse_data(load, "section PART: the parts do not form a tree");
}

/* Reads the axes and the unit of the host that saved the file. An older file has none. */
static void read_host(loading* load) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_HOST_JOINTS];
    dmi_axes saved;
    if (r->at == NULL) return;
    dmi_get_floats(r, saved.to_canonical, DMI_DMO_AXES);
    saved.unit = dmi_get_f32(r);
    /* NOLINTBEGIN(bugprone-suspicious-memory-comparison): the bits are what is asked */
    load->same_host = memcmp(saved.to_canonical, load->axes->to_canonical, sizeof saved.to_canonical) == 0 &&
                      memcmp(&saved.unit, &load->axes->unit, sizeof saved.unit) == 0;
    /* NOLINTEND(bugprone-suspicious-memory-comparison) */
}

/* Reads the value at which a joint is closed. It is rest in a file without the section. Returns whether the number is
 * valid. */
static bool read_closed(loading* load, float* out) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_CLOSED];
    *out = r->at != NULL ? dmi_get_f32(r) : 0;
    return dmi_dmo_within(out, 1, FLT_MAX);
}

/* Reads a joint that is the host's own, of which `inner` is a copy in the inner frame. */
static bool read_host_joint(loading* load, const dm_joint* inner, dm_joint* out_joint) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_HOST_JOINTS];
    dm_joint saved;
    *out_joint = dmi_frame_joint_out(&load->object->frame, inner);
    float closed;
    const bool valid = read_closed(load, &closed);
    if (r->at == NULL) return valid;
    dmi_get_joint(r, &saved);
    saved.closed = closed;
    if (load->same_host) *out_joint = saved;
    return valid && dmi_dmo_valid_joint_numbers(&saved);
}

static dm_result read_joints(loading* load) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_JOINTS];
    const dmi_frame* frame = &load->object->frame;
    read_host(load);
    for (uint32_t i = 1; i < load->object->part_count; i++) {
        dmi_object_part* part = &load->object->parts[i];
        dmi_hypotheses* all = &part->hypotheses;
        all->count = dmi_get_u32(r);
        int32_t in_force = (int32_t)dmi_get_u32(r);
        if (all->count > DM_MAX_HYPOTHESES || in_force < -1 || in_force >= (int32_t)all->count) {
            return refuse_data(load, "section JNT holds impossible numbers");
        }
        bool valid = true;
        for (uint32_t j = 0; j < all->count; j++) {
            dmi_get_joint(r, &all->joints[j]);
            valid = read_closed(load, &all->joints[j].closed) && valid;
            valid = valid && dmi_dmo_valid_joint(frame, &all->joints[j]);
        }
        if (in_force >= 0) {
            part->joint = dmi_frame_joint_out(frame, &all->joints[in_force]);
        } else {
            dm_joint inner;
            dmi_get_joint(r, &inner);
            valid = read_closed(load, &inner.closed) && valid;
            valid = valid && dmi_dmo_valid_joint(frame, &inner) && read_host_joint(load, &inner, &part->joint);
        }
        if (!valid) return refuse_data(load, "section JNT or HST holds an invalid joint");
    }
    const dmi_dmo_reader* host = &load->sections[DMI_DMO_HOST_JOINTS];
    if (host->overrun || host->left > 0) return refuse_data(load, "section HST has the wrong size");
    const dmi_dmo_reader* closed = &load->sections[DMI_DMO_CLOSED];
    if (closed->overrun || closed->left > 0) return refuse_data(load, "section CLO has the wrong size");
    return r->overrun || r->left > 0 ? refuse_data(load, "section JNT has the wrong size") : DM_OK;
}

/* Reads the points of a part from a file of version 1, which has more of them. */
static bool read_plain_points(dmi_dmo_reader* r, dmi_part_points* out) {
    float points[DMI_DMO_OLD_POINTS][3];
    dmi_get_floats(r, points[0], (size_t)DMI_DMO_OLD_POINTS * 3);
    dmi_part_points_take((const float(*)[3])points, DMI_DMO_OLD_POINTS / DMI_PART_POINTS, out);
    return dmi_dmo_within(points[0], (size_t)DMI_DMO_OLD_POINTS * 3, DMI_DMO_MAX_COORDINATE);
}

static dm_result read_points(loading* load) {
    dmi_dmo_reader *points = &load->sections[DMI_DMO_POINTS], *plain = &load->sections[DMI_DMO_PLAIN_POINTS];
    for (uint32_t i = 1; i < load->object->part_count; i++) {
        dmi_part_points* out = &load->object->parts[i].points;
        if (points->at != NULL)
            dmi_get_signed_halves(points, out->at[0], (size_t)DMI_PART_POINTS * 3);
        else if (!read_plain_points(plain, out))
            return refuse_data(load, "section PNT holds impossible numbers");
    }
    return DM_OK;
}

/* Reads the alternatives. A file without the section has none. */
static dm_result read_alternatives(loading* load) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_ALTERNATIVES];
    if (r->at == NULL) return DM_OK;
    for (uint32_t i = 1; i < load->object->part_count; i++) {
        dmi_alternatives* all = &load->object->parts[i].alternatives;
        all->count = dmi_get_u32(r);
        if (all->count > DMI_ALTERNATIVES) return refuse_data(load, "section ALT holds too many joints");
        for (uint32_t j = 0; j < all->count; j++) {
            all->list[j].type = (int32_t)dmi_get_u32(r);
            all->list[j].confidence = dmi_get_f32(r);
            dmi_get_floats(r, all->list[j].axis, 3);
            dmi_get_floats(r, all->list[j].origin, 3);
            if (!dmi_dmo_valid_alternative(&load->object->frame, &all->list[j]))
                return refuse_data(load, "section ALT holds an invalid joint");
        }
    }
    return r->overrun || r->left > 0 ? refuse_data(load, "section ALT has the wrong size") : DM_OK;
}

static bool read_free_range(dmi_dmo_reader* r, dmi_free_range* out) {
    if (r->at == NULL) {
        *out = dmi_unbounded_range();
        return true;
    }
    out->lower = dmi_get_f32(r), out->upper = dmi_get_f32(r);
    return out->lower <= 0 && out->lower >= -FLT_MAX && out->upper >= 0 && out->upper <= FLT_MAX;
}

/* Reads the free ranges. A file without the section bounds nothing. */
static dm_result read_free_ranges(loading* load) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_FREE_RANGES];
    bool valid = true;
    for (uint32_t i = 1; i < load->object->part_count; i++) {
        dmi_hypotheses* hypotheses = &load->object->parts[i].hypotheses;
        dmi_alternatives* alternatives = &load->object->parts[i].alternatives;
        for (uint32_t j = 0; j < hypotheses->count; j++) valid &= read_free_range(r, &hypotheses->free_range[j]);
        for (uint32_t j = 0; j < alternatives->count; j++)
            valid &= read_free_range(r, &alternatives->list[j].free_range);
        for (int j = 0; j < 3; j++) valid &= read_free_range(r, &alternatives->slides[j]);
    }
    if (r->overrun || r->left > 0) return refuse_data(load, "section FRE has the wrong size");
    return valid ? DM_OK : refuse_data(load, "section FRE holds an impossible range");
}

/* Reads what the object was prepared without. Bits of a later version are dropped, because this one cannot name
 * them. */
static dm_result read_degraded(loading* load) {
    const uint32_t known = DM_DEGRADED_NO_KINEMATICS | DM_DEGRADED_NO_RANKER | DM_DEGRADED_HINT | DM_DEGRADED_MESH;
    dmi_dmo_reader* r = &load->sections[DMI_DMO_DEGRADED];
    if (r->at == NULL) return DM_OK;
    load->object->degraded = dmi_get_u32(r) & known;
    return r->overrun || r->left > 0 ? refuse_data(load, "section LES has the wrong size") : DM_OK;
}

/* Triangles as the file has them, in scratch memory. */
typedef struct arrays {
    float* positions;
    uint32_t *indices, *face_part;
} arrays;

static dm_result out_of_memory(const loading* load) {
    return dmi_fail(load->env, DM_ERROR_OUT_OF_MEMORY, "dm_object_load: no memory for %llu triangles",
                    (unsigned long long)load->object->triangle_count);
}

static dm_result read_arrays(loading* load, size_t vertices, size_t faces, const arrays* to) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_TRIANGLES];
    dmi_get_floats(r, to->positions, vertices * 3);
    if (!dmi_dmo_within(to->positions, vertices * 3, DMI_DMO_MAX_COORDINATE))
        return refuse_data(load, "section TRI: a vertex lies far outside the object");
    dmi_get_words(r, to->indices, faces * 3);
    for (size_t i = 0; i < faces * 3; i++) {
        if (to->indices[i] >= vertices) return refuse_data(load, "section TRI: an index names no vertex");
    }
    dmi_get_halves(r, to->face_part, faces);
    for (size_t i = 0; i < faces; i++) {
        if (to->face_part[i] >= load->object->part_count)
            return refuse_data(load, "section TRI: a triangle of no part");
    }
    return dmi_progress_tell(load->progress, DMI_STAGE_LOAD_ARRAYS_READ);
}

/* Returns whether each part has as many triangles as it states and, where it has any, an area. */
static dm_result check_faces(const loading* load) {
    const dmi_object* object = load->object;
    for (uint32_t i = 0; i < object->part_count; i++) {
        const dmi_packed_part* part = &object->mesh->parts[i];
        if (part->face_count != object->parts[i].shape.face_count)
            return refuse_data(load, "section TRI: a part has another number of triangles");
        if (part->face_count > 0 && part->solid_count == 0)
            return refuse_data(load, "section TRI: a part without area");
    }
    return DM_OK;
}

static dm_result pack_triangles(loading* load, uint32_t vertices, uint32_t faces, bool wide, const arrays* room) {
    const dmi_progress packing =
        dmi_progress_piece(load->progress, DMI_STAGE_LOAD_ARRAYS_READ, DMI_STAGE_LOAD_TRIANGLES_READ);
    const dmi_unpacked all = {room->positions, room->indices, room->face_part,
                              vertices,        faces,         load->object->part_count};
    dm_result result = read_arrays(load, vertices, faces, room);
    if (result == DM_OK) result = dmi_object_pack(load->env, &all, wide, &packing, load->object);
    return result == DM_OK ? check_faces(load) : result;
}

static dm_result read_triangles(loading* load, bool wide) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_TRIANGLES];
    const dmi_object* object = load->object;
    const uint64_t vertices = dmi_get_u64(r), faces = dmi_get_u64(r);
    if (vertices != object->vertex_count || faces != object->triangle_count || vertices == 0 || faces == 0 ||
        r->left != vertices * DMI_DMO_VERTEX_SIZE + faces * DMI_DMO_TRIANGLE_SIZE) {
        return refuse_data(load, "section TRI has the wrong size");
    }
    const arrays room = {.positions = dmi_scratch_alloc(load->env, (size_t)vertices * 3 * sizeof(float)),
                         .indices = dmi_scratch_alloc(load->env, (size_t)faces * 3 * sizeof(uint32_t)),
                         .face_part = dmi_scratch_alloc(load->env, (size_t)faces * sizeof(uint32_t))};
    const dm_result result = room.positions != NULL && room.indices != NULL && room.face_part != NULL
                                 ? pack_triangles(load, (uint32_t)vertices, (uint32_t)faces, wide, &room)
                                 : out_of_memory(load);
    dmi_scratch_free(load->env, room.positions);
    dmi_scratch_free(load->env, room.indices);
    dmi_scratch_free(load->env, room.face_part);
    return result;
}

/* ---- trees ---- */

/* Returns whether the file has trees of a known layout. */
static bool has_trees(loading* load) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_TREES];
    if (r->at == NULL || r->left < DMI_DMO_TREE_HEAD) return false;
    const uint32_t layout = dmi_get_u32(r);
    dmi_get_u32(r);
    return layout == DMI_DMO_TREE_LAYOUT;
}

/* Fills the shapes of all parts but for their pointers. Returns whether the section has the numbers that they need. */
static bool read_tree_sizes(loading* load, dmi_tree_shape* shapes) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_TREES];
    uint64_t numbers = 0;
    for (uint32_t p = 0; p < load->object->part_count; p++) {
        shapes[p] = (dmi_tree_shape){.child_step = DMI_DMO_NODE_NUMBERS, .face_step = DMI_DMO_BLOCK_NUMBERS};
        shapes[p].node_count = dmi_get_u32(r);
        shapes[p].block_count = dmi_get_u32(r);
        numbers += (uint64_t)shapes[p].node_count * DMI_DMO_NODE_NUMBERS;
        numbers += (uint64_t)shapes[p].block_count * DMI_DMO_BLOCK_NUMBERS;
    }
    return !r->overrun && r->left == numbers * sizeof(uint32_t);
}

static dm_result make_trees(loading* load, dmi_picker* picker, const dmi_progress* progress, dmi_tree_shape* shapes,
                            uint32_t* numbers) {
    dmi_dmo_reader* r = &load->sections[DMI_DMO_TREES];
    dmi_get_words(r, numbers, (size_t)r->left / sizeof *numbers);
    for (uint32_t p = 0; p < load->object->part_count; p++) {
        shapes[p].child = numbers;
        numbers += (size_t)shapes[p].node_count * DMI_DMO_NODE_NUMBERS;
        shapes[p].face = numbers;
        numbers += (size_t)shapes[p].block_count * DMI_DMO_BLOCK_NUMBERS;
    }
    const dm_result result = dmi_object_make_trees(picker, shapes, progress, load->object);
    return result == DM_ERROR_BAD_DATA ? refuse_data(load, "section TREE: a tree that is none of its triangles")
                                       : result;
}

static dm_result read_trees(loading* load, dmi_picker* picker, const dmi_progress* progress) {
    dmi_env* env = load->env;
    dmi_tree_shape* shapes = dmi_scratch_alloc(env, load->object->part_count * sizeof *shapes);
    if (shapes == NULL) return out_of_memory(load);
    dm_result result = DM_OK;
    if (!read_tree_sizes(load, shapes)) result = refuse_data(load, "section TREE has the wrong size");
    uint32_t* numbers = result == DM_OK ? dmi_scratch_alloc(env, (size_t)load->sections[DMI_DMO_TREES].left) : NULL;
    if (numbers != NULL)
        result = make_trees(load, picker, progress, shapes, numbers);
    else if (result == DM_OK)
        result = out_of_memory(load);
    dmi_scratch_free(env, numbers);
    dmi_scratch_free(env, shapes);
    return result;
}

/* Reads the triangles, and the trees that are stored. It builds trees where there are none or the context has
 * others. */
static dm_result read_pickable(loading* load, dmi_picker* picker) {
    const dmi_progress building = dmi_progress_piece(load->progress, DMI_STAGE_LOAD_TRIANGLES_READ, 1);
    const bool stored = has_trees(load) && dmi_picker_restores(picker);
    dm_result result = read_triangles(load, !stored && dmi_picker_is_wide(picker));
    if (result == DM_OK) result = dmi_progress_tell(&building, 0);
    if (result != DM_OK) return result;
    return stored ? read_trees(load, picker, &building) : dmi_object_make_trees(picker, NULL, &building, load->object);
}

dm_result dmi_dmo_read(dmi_env* env, dmi_picker* picker, const dmi_axes* axes, const void* data, size_t size,
                       const dmi_progress* progress, dmi_object** out_object) {
    loading load = {.env = env, .axes = axes, .progress = progress};
    dm_result result = read_table(&load, data, size);
    if (result == DM_OK) result = dmi_progress_tell(progress, DMI_STAGE_LOAD_CHECKED);
    if (result == DM_OK) result = read_object(&load);
    if (result == DM_OK) result = read_parts(&load);
    if (result == DM_OK) result = read_joints(&load);
    if (result == DM_OK) result = read_points(&load);
    if (result == DM_OK) result = read_alternatives(&load);
    if (result == DM_OK) result = read_free_ranges(&load);
    if (result == DM_OK) result = read_degraded(&load);
    if (result == DM_OK && load.sections[DMI_DMO_TRIANGLES].at != NULL) result = read_pickable(&load, picker);
    if (result == DM_OK) result = dmi_progress_tell(progress, 1);
    if (result != DM_OK) {
        dmi_object_destroy(env, load.object);
        return result;
    }
    *out_object = load.object;
    return DM_OK;
}
