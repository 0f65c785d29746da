/* .dmo bytes -> prepared object. The bytes may come from anywhere: each number is checked before it is used. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "kinematics/object/dmo.h"
#include "kinematics/object/dmo_format.h"

/* Reads zeros, and remembers, once it would run past the end. */
typedef struct reader {
    const uint8_t* at;
    uint64_t left;
    int overrun;
} reader;

static uint64_t get(reader* r, uint32_t bytes) {
    if (r->left < bytes) {
        r->overrun = 1;
        r->left = 0;
        return 0;
    }
    uint64_t value = 0;
    for (uint32_t i = 0; i < bytes; i++) value |= (uint64_t)r->at[i] << (8 * i);
    r->at += bytes;
    r->left -= bytes;
    return value;
}

static uint32_t get_u32(reader* r) {
    return (uint32_t)get(r, 4);
}

static float get_f32(reader* r) {
    uint32_t bits = get_u32(r);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static double get_f64(reader* r) {
    uint64_t bits = get(r, 8);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void get_floats(reader* r, float* out, size_t count) {
    for (size_t i = 0; i < count; i++) out[i] = get_f32(r);
}

static dm_vec3 get_vec3(reader* r) {
    float v[3];
    get_floats(r, v, 3);
    return (dm_vec3){v[0], v[1], v[2]};
}

static void get_joint(reader* r, dm_joint* out) {
    *out = (dm_joint){.type = (int32_t)get_u32(r)};
    out->type_confidence = get_f32(r);
    out->confidence = get_f32(r);
    out->pitch = get_f32(r);
    out->axis = get_vec3(r);
    out->origin = get_vec3(r);
    out->lower = get_f32(r);
    out->upper = get_f32(r);
    out->source = (int32_t)get_u32(r);
}

/* Inner coordinates of a surface run from -0.5 to 0.5, those of stray vertices to 1: more did not come from us. */
#define MOST 1.0f

static int within(const float* values, size_t count, float most) {
    for (size_t i = 0; i < count; i++) {
        if (!(fabsf(values[i]) <= most)) return 0;
    }
    return 1;
}

static int valid_joint(const dm_joint* joint) {
    const dm_vec3 a = joint->axis;
    const float numbers[6] = {joint->origin.x, joint->origin.y, joint->origin.z,
                              joint->pitch,    joint->lower,    joint->upper};
    const float shares[2] = {joint->type_confidence - 0.5f, joint->confidence - 0.5f};
    return joint->type >= DM_JOINT_REVOLUTE && joint->type <= DM_JOINT_FIXED &&
           fabsf(a.x * a.x + a.y * a.y + a.z * a.z - 1.0f) <= 1e-3f && within(numbers, 6, FLT_MAX) &&
           joint->lower <= joint->upper && within(shares, 2, 0.5f) && joint->source >= DM_JOINT_FROM_NETWORK &&
           joint->source <= DM_JOINT_FROM_HOST;
}

typedef struct loading {
    dmi_env* env;
    const dmi_axes* axes;
    reader sections[DMI_DMO_SECTIONS]; /* at NULL: absent */
    dmi_object* object;
} loading;

static dm_result bad(const loading* load, const char* what) {
    return dmi_fail(load->env, DM_ERROR_BAD_DATA, "dm_object_load: %s", what);
}

static dm_result read_header(const loading* load, const uint8_t* data, size_t size, uint32_t* out_sections) {
    reader r = {data, size, 0};
    if (get_u32(&r) != DMI_DMO_MAGIC || size < DMI_DMO_HEADER_SIZE) return bad(load, "not a .dmo file");
    uint32_t version = get_u32(&r), crc = get_u32(&r);
    if (version > DMI_DMO_VERSION) {
        return dmi_fail(load->env, DM_ERROR_VERSION,
                        "dm_object_load: the file has version %u, this library reads up to %d", version,
                        DMI_DMO_VERSION);
    }
    *out_sections = get_u32(&r);
    uint64_t whole = get(&r, 8);
    if (version == 0 || whole != size || *out_sections > DMI_DMO_MAX_SECTIONS ||
        size < DMI_DMO_HEADER_SIZE + (size_t)*out_sections * DMI_DMO_ENTRY_SIZE) {
        return dmi_fail(load->env, DM_ERROR_BAD_DATA, "dm_object_load: %zu bytes of a file of %llu", size,
                        (unsigned long long)whole);
    }
    return crc == dmi_dmo_crc(data + 12, size - 12) ? DM_OK : bad(load, "the checksum is wrong");
}

static dm_result read_table(loading* load, const uint8_t* data, size_t size) {
    uint32_t count = 0;
    dm_result result = read_header(load, data, size, &count);
    if (result != DM_OK) return result;
    reader table = {data + DMI_DMO_HEADER_SIZE, (uint64_t)count * DMI_DMO_ENTRY_SIZE, 0};
    for (uint32_t i = 0; i < count; i++) {
        uint32_t tag = get_u32(&table);
        get_u32(&table);
        uint64_t offset = get(&table, 8), length = get(&table, 8);
        if (offset > size || length > size - offset) return bad(load, "a section lies outside the file");
        for (int s = 0; s < DMI_DMO_SECTIONS; s++) {
            if (tag != dmi_dmo_tags[s]) continue;
            if (load->sections[s].at) return bad(load, "a section comes twice");
            load->sections[s] = (reader){data + offset, length, 0};
        }
    }
    for (int s = 0; s < DMI_DMO_ALTERNATIVES; s++) {
        if (!load->sections[s].at) return bad(load, "a section is missing");
    }
    return DM_OK;
}

static dm_result read_object(loading* load) {
    reader* r = &load->sections[DMI_DMO_OBJECT];
    dmi_object head = {.frame = {.axes = *load->axes}};
    for (int i = 0; i < 3; i++) head.frame.centre[i] = get_f64(r);
    head.frame.size = get_f64(r);
    get_floats(r, head.box_min, 3);
    get_floats(r, head.box_max, 3);
    head.vertex_count = get(r, 8);
    head.triangle_count = get(r, 8);
    head.seed = get(r, 8);
    uint32_t part_count = get_u32(r);
    int valid = !r->overrun && head.frame.size >= 1e-18 && head.frame.size <= 1e18 && within(head.box_min, 3, MOST) &&
                within(head.box_max, 3, MOST) && head.vertex_count <= DM_MAX_ELEMENTS &&
                head.triangle_count <= DM_MAX_ELEMENTS;
    for (int i = 0; i < 3; i++) valid = valid && fabs(head.frame.centre[i]) <= 1e38;
    if (!valid) return bad(load, "section OBJ holds impossible numbers");
    /* Sections of the size these parts need exist, so no number here makes us allocate what the file doesn't hold. */
    if (part_count < 2 || part_count > DM_MAX_PARTS + 1 ||
        load->sections[DMI_DMO_PARTS].left != (uint64_t)part_count * DMI_DMO_PART_SIZE ||
        load->sections[DMI_DMO_POINTS].left != (uint64_t)(part_count - 1) * DMI_DMO_POINTS_SIZE) {
        return bad(load, "the number of parts does not fit the file");
    }
    dm_result result = dmi_object_create(load->env, part_count, &load->object);
    if (result != DM_OK) return result;
    head.parts = load->object->parts;
    head.part_count = part_count;
    *load->object = head;
    return DM_OK;
}

static int valid_shape(const dmi_part* shape) {
    int valid = within(shape->box_min, 3, MOST) && within(shape->box_max, 3, MOST) && within(shape->centre, 3, MOST) &&
                shape->area >= 0.0f && shape->area <= 1e12f;
    for (int i = 0; i < 3; i++) valid = valid && shape->box_min[i] <= shape->box_max[i];
    return valid;
}

/* Ids rise, and every chain of parents ends at the body. */
static int valid_tree(const dmi_object* object) {
    for (uint32_t i = 0; i < object->part_count; i++) {
        const dmi_part* shape = &object->parts[i].shape;
        if (i == 0 ? shape->id != 0 || shape->parent != 0 : shape->id <= object->parts[i - 1].shape.id) return 0;
        if (shape->parent >= object->part_count) return 0;
    }
    for (uint32_t i = 1; i < object->part_count; i++) {
        uint32_t steps = 0;
        for (uint32_t p = i; p != 0; p = object->parts[p].shape.parent) {
            if (steps++ > object->part_count) return 0;
        }
    }
    return 1;
}

static dm_result read_parts(loading* load) {
    reader* r = &load->sections[DMI_DMO_PARTS];
    for (uint32_t i = 0; i < load->object->part_count; i++) {
        dmi_object_part* part = &load->object->parts[i];
        dmi_part* shape = &part->shape;
        shape->id = get_u32(r);
        shape->parent = get_u32(r);
        shape->face_count = get_u32(r);
        get_floats(r, shape->box_min, 3);
        get_floats(r, shape->box_max, 3);
        get_floats(r, shape->centre, 3);
        shape->area = get_f32(r);
        part->given_type = (int32_t)get_u32(r);
        if (!valid_shape(shape) || part->given_type < DM_JOINT_UNKNOWN || part->given_type > DM_JOINT_FIXED) {
            return bad(load, "section PART holds impossible numbers");
        }
    }
    return valid_tree(load->object) ? DM_OK : bad(load, "section PART: the parts do not form a tree");
}

static dm_result read_joints(loading* load) {
    reader* r = &load->sections[DMI_DMO_JOINTS];
    const dmi_frame* frame = &load->object->frame;
    for (uint32_t i = 1; i < load->object->part_count; i++) {
        dmi_object_part* part = &load->object->parts[i];
        dmi_hypotheses* all = &part->hypotheses;
        all->count = get_u32(r);
        int32_t in_force = (int32_t)get_u32(r);
        if (all->count > DM_MAX_HYPOTHESES || in_force < -1 || in_force >= (int32_t)all->count) {
            return bad(load, "section JNT holds impossible numbers");
        }
        int valid = 1;
        for (uint32_t j = 0; j < all->count; j++) {
            get_joint(r, &all->joints[j]);
            valid = valid && valid_joint(&all->joints[j]);
        }
        dm_joint inner;
        if (in_force >= 0) {
            inner = all->joints[in_force];
        } else {
            get_joint(r, &inner);
        }
        if (!valid || !valid_joint(&inner)) return bad(load, "section JNT holds a joint that can't be");
        part->joint = dmi_frame_joint_out(frame, &inner);
    }
    return r->overrun || r->left > 0 ? bad(load, "section JNT has the wrong size") : DM_OK;
}

static dm_result read_points(loading* load) {
    for (uint32_t i = 1; i < load->object->part_count; i++) {
        float* points = &load->object->parts[i].points[0][0];
        get_floats(&load->sections[DMI_DMO_POINTS], points, (size_t)DMI_OBJECT_POINTS * 3);
        if (!within(points, (size_t)DMI_OBJECT_POINTS * 3, MOST))
            return bad(load, "section PNT holds impossible numbers");
    }
    return DM_OK;
}

static int valid_alternative(const dmi_alternative* one) {
    const int known =
        one->type == DM_JOINT_REVOLUTE || one->type == DM_JOINT_CONTINUOUS || one->type == DM_JOINT_PRISMATIC;
    const float square = one->axis[0] * one->axis[0] + one->axis[1] * one->axis[1] + one->axis[2] * one->axis[2];
    return known && fabsf(square - 1.0f) <= 1e-3f && within(one->origin, 3, FLT_MAX) &&
           fabsf(one->confidence - 0.5f) <= 0.5f;
}

/* Absent, there are none. */
static dm_result read_alternatives(loading* load) {
    reader* r = &load->sections[DMI_DMO_ALTERNATIVES];
    if (!r->at) return DM_OK;
    for (uint32_t i = 1; i < load->object->part_count; i++) {
        dmi_alternatives* all = &load->object->parts[i].alternatives;
        all->count = get_u32(r);
        if (all->count > DMI_ALTERNATIVES) return bad(load, "section ALT holds too many joints");
        for (uint32_t j = 0; j < all->count; j++) {
            all->list[j].type = (int32_t)get_u32(r);
            all->list[j].confidence = get_f32(r);
            get_floats(r, all->list[j].axis, 3);
            get_floats(r, all->list[j].origin, 3);
            if (!valid_alternative(&all->list[j])) return bad(load, "section ALT holds a joint that can't be");
        }
    }
    return r->overrun || r->left > 0 ? bad(load, "section ALT has the wrong size") : DM_OK;
}

/* A mesh with room for what the section holds, and its numbers. */
static dm_result read_arrays(loading* load, dmi_mesh* mesh) {
    reader* r = &load->sections[DMI_DMO_TRIANGLES];
    size_t corners = (size_t)mesh->face_count * 3;
    get_floats(r, mesh->positions, (size_t)mesh->vertex_count * 3);
    if (!within(mesh->positions, (size_t)mesh->vertex_count * 3, MOST))
        return bad(load, "section TRI: a vertex lies far off");
    for (size_t i = 0; i < corners; i++) {
        mesh->indices[i] = get_u32(r);
        if (mesh->indices[i] >= mesh->vertex_count) return bad(load, "section TRI: an index names no vertex");
    }
    for (uint32_t i = 0; i < mesh->face_count; i++) {
        mesh->face_part[i] = (uint32_t)get(r, 2);
        if (mesh->face_part[i] >= mesh->part_count) return bad(load, "section TRI: a triangle of no part");
        mesh->parts[mesh->face_part[i]].face_count++;
    }
    for (uint32_t i = 0; i < mesh->part_count; i++) {
        mesh->parts[i].id = load->object->parts[i].shape.id;
        mesh->parts[i].parent = load->object->parts[i].shape.parent;
    }
    dm_result result = dmi_mesh_measure(load->env, mesh);
    return result == DM_ERROR_DEGENERATE_MESH ? bad(load, "section TRI: a part without area") : result;
}

/* Areas, normals and boxes are computed as prepare computed them, from the same bits. */
static dm_result read_triangles(loading* load) {
    reader* r = &load->sections[DMI_DMO_TRIANGLES];
    dmi_object* object = load->object;
    uint64_t vertices = get(r, 8), faces = get(r, 8);
    if (vertices != object->vertex_count || faces != object->triangle_count || vertices == 0 || faces == 0 ||
        r->left != vertices * 12 + faces * 14) {
        return bad(load, "section TRI has the wrong size");
    }
    dm_result result = dmi_mesh_restore(load->env, &object->frame, (uint32_t)vertices, (uint32_t)faces,
                                        object->part_count, &object->mesh);
    if (result == DM_OK) result = read_arrays(load, object->mesh);
    for (uint32_t i = 0; result == DM_OK && i < object->part_count; i++) {
        if (object->mesh->parts[i].face_count != object->parts[i].shape.face_count) {
            return bad(load, "section TRI: a part has another number of triangles");
        }
        object->parts[i].shape = object->mesh->parts[i];
    }
    return result;
}

dm_result dmi_dmo_read(dmi_env* env, dmi_picker* picker, const dmi_axes* axes, const void* data, size_t size,
                       dmi_object** out_object) {
    loading load = {.env = env, .axes = axes};
    dm_result result = read_table(&load, data, size);
    if (result == DM_OK) result = read_object(&load);
    if (result == DM_OK) result = read_parts(&load);
    if (result == DM_OK) result = read_joints(&load);
    if (result == DM_OK) result = read_points(&load);
    if (result == DM_OK) result = read_alternatives(&load);
    if (result == DM_OK && load.sections[DMI_DMO_TRIANGLES].at) {
        result = read_triangles(&load);
        if (result == DM_OK) result = dmi_bvh_create(picker, load.object->mesh, &load.object->bvh);
    }
    if (result != DM_OK) {
        dmi_object_destroy(env, load.object);
        return result;
    }
    *out_object = load.object;
    return DM_OK;
}
