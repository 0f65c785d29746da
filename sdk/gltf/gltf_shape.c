/* Builds shapes, which are what a mesh has of triangles. A vertex accessor of one mesh alone is taken as it is. Of one
 * that several meshes share, each takes the vertices that its triangles have. Primitives of a mesh share vertices. */
#include "gltf/gltf_shape.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Longest description of a place in a file ("node 3 'door', primitive 0"). */
#define PLACE_SIZE 192
#define SEVERAL UINT32_MAX
enum { WORD_BITS = 64 };
/* Elements of an accessor for each one that a mesh has, from which on the mesh sorts those that it has; by hand. */
enum { FEW = 64 };

/* ---- who has which vertices ---- */

static void find_users_of(dmi_gltf_builder* builder, uint32_t mesh) {
    const uint32_t keys = dmi_gltf_key_count(builder->gltf);
    const cJSON* primitive;
    builder->shapes[mesh].shown = 1;
    cJSON_ArrayForEach(primitive, dmi_json_get(builder->gltf->document.items[DMI_GLTF_MESHES][mesh], "primitives")) {
        const uint32_t key = dmi_gltf_key(builder->gltf, primitive);
        if (key == keys) continue;
        uint32_t* user = &builder->users[key];
        *user = *user == 0 || *user == mesh + 1 ? mesh + 1 : SEVERAL;
    }
}

/* Finds the users of the keys among the meshes that the scene shows. */
static void find_users(dmi_gltf_builder* builder) {
    const dm_gltf* gltf = builder->gltf;
    for (uint32_t i = 0; i < gltf->document.counts[DMI_GLTF_NODES]; i++) {
        const dmi_gltf_tree_node* node = &gltf->tree[i];
        if (node->mesh < 0 || !node->placed || !node->shown || builder->shapes[node->mesh].shown) continue;
        find_users_of(builder, (uint32_t)node->mesh);
    }
}

dm_result dmi_gltf_builder_open(dm_gltf* gltf, dmi_gltf_problem* problem, dmi_gltf_builder* out) {
    dmi_env* env = &gltf->env;
    const uint32_t keys = dmi_gltf_key_count(gltf), meshes = gltf->document.counts[DMI_GLTF_MESHES];
    const size_t key = sizeof *out->users + sizeof *out->stamps + sizeof *out->owners + sizeof *out->finite;
    *out = (dmi_gltf_builder){.gltf = gltf};
    dm_result result = dmi_gltf_spend(gltf, meshes, sizeof *out->shapes, "glTF: the meshes", problem);
    if (result == DM_OK) result = dmi_gltf_spend(gltf, keys, key, "glTF: the accessors", problem);
    if (result != DM_OK) return result;
    *out = (dmi_gltf_builder){.gltf = gltf,
                              .shapes = dmi_alloc_zeroed(env, meshes * sizeof *out->shapes, 16),
                              .users = dmi_alloc_zeroed(env, keys * sizeof *out->users, 16),
                              .stamps = dmi_alloc_zeroed(env, keys * sizeof *out->stamps, 16),
                              .owners = dmi_alloc(env, keys * sizeof *out->owners, 16),
                              .finite = dmi_alloc_zeroed(env, keys, 1)};
    if (!out->shapes || !out->users || !out->stamps || !out->owners || !out->finite)
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u meshes", meshes);
    find_users(out);
    return DM_OK;
}

static void release_shape(dmi_env* env, dmi_gltf_shape* shape) {
    dmi_free(env, shape->groups, shape->capacity * sizeof *shape->groups);
    dmi_free(env, shape->runs, shape->capacity * sizeof *shape->runs);
    dmi_free(env, shape->local, shape->vertex_capacity * 3 * sizeof *shape->local);
    dmi_free(env, shape->elements, shape->vertex_capacity * sizeof *shape->elements);
    dmi_free(env, shape->corners, shape->face_capacity * 3 * sizeof *shape->corners);
}

void dmi_gltf_builder_close(dmi_gltf_builder* builder) {
    dmi_env* env = &builder->gltf->env;
    const uint32_t keys = dmi_gltf_key_count(builder->gltf), meshes = builder->gltf->document.counts[DMI_GLTF_MESHES];
    for (uint32_t i = 0; builder->shapes && i < meshes; i++) release_shape(env, &builder->shapes[i]);
    dmi_free(env, builder->shapes, meshes * sizeof *builder->shapes);
    dmi_free(env, builder->users, keys * sizeof *builder->users);
    dmi_free(env, builder->stamps, keys * sizeof *builder->stamps);
    dmi_free(env, builder->owners, keys * sizeof *builder->owners);
    dmi_free(env, builder->finite, keys);
    const uint64_t words = builder->element_capacity / WORD_BITS;
    dmi_free(env, builder->used, words * sizeof *builder->used);
    dmi_free(env, builder->places, builder->element_capacity * sizeof *builder->places);
}

/* ---- corners ---- */

static dm_result grow_faces(dm_gltf* gltf, dmi_gltf_shape* shape, uint64_t added, const char* place,
                            dmi_gltf_problem* problem) {
    const uint64_t needed = shape->face_count + added;
    dm_result result = dmi_gltf_spend(gltf, added, 3 * sizeof *shape->corners, place, problem);
    if (result != DM_OK || needed <= shape->face_capacity) return result;
    const uint64_t capacity = shape->face_count == 0 ? needed : 2 * needed;
    if (shape->face_count > 0) result = dmi_gltf_spend(gltf, capacity, 3 * sizeof *shape->corners, place, problem);
    if (result != DM_OK) return result;
    uint32_t* corners = dmi_alloc(&gltf->env, capacity * 3 * sizeof *corners, 16);
    if (!corners)
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "%s: no memory for %" PRIu64 " triangles", place,
                               needed);
    if (shape->corners) memcpy(corners, shape->corners, shape->face_count * 3 * sizeof *corners);
    dmi_free(&gltf->env, shape->corners, shape->face_capacity * 3 * sizeof *corners);
    shape->corners = corners;
    shape->face_capacity = capacity;
    return DM_OK;
}

/* Returns corner `corner` of triangle `face`, as a position in the primitive's list (glTF 2.0 §3.7.2.1). */
static uint64_t corner_of(int32_t mode, uint64_t face, uint32_t corner) {
    if (mode == DMI_GLTF_TRIANGLES) return 3 * face + corner;
    if (mode == DMI_GLTF_FAN) return corner == 2 ? 0 : face + 1 + corner;
    return corner == 0 ? face : face + (((face & 1) != 0) == (corner == 1) ? 2 : 1);
}

/* Spreads the `count` corners of a strip or fan, which lie at the end of `out`, to whole triangles. */
static void spread_corners(int32_t mode, const uint32_t* corners, uint64_t faces, uint32_t* out) {
    for (uint64_t face = 0; face < faces; face++) {
        for (uint32_t corner = 0; corner < 3; corner++) out[3 * face + corner] = corners[corner_of(mode, face, corner)];
    }
}

/* Returns whether all positions are finite. Integers are, and floats whose exponent is not all ones. */
static int are_finite(const dmi_gltf_elements* positions) {
    const uint32_t exponent = 0x7F800000u;
    uint32_t bad = 0;
    if (positions->component_type != DMI_GLTF_FLOAT) return 1;
    for (uint64_t e = 0; positions->data && e < positions->count; e++) {
        uint32_t xyz[3];
        memcpy(xyz, positions->data + e * positions->stride, sizeof xyz);
        for (int k = 0; k < 3; k++) bad |= (xyz[k] & exponent) == exponent;
    }
    for (uint64_t i = 0; i < positions->change_count; i++) {
        for (int k = 0; k < 3; k++) bad |= !isfinite(dmi_gltf_change(positions, i, k));
    }
    return !bad;
}

/* Returns the same. It checks an accessor only once. */
static int all_finite(dmi_gltf_builder* builder, const dmi_gltf_geometry* geometry) {
    enum { UNKNOWN, FINITE, NOT_FINITE };
    if (geometry->key == dmi_gltf_key_count(builder->gltf)) return are_finite(&geometry->positions);
    uint8_t* known = &builder->finite[geometry->key];
    if (*known == UNKNOWN) *known = are_finite(&geometry->positions) ? FINITE : NOT_FINITE;
    return *known == FINITE;
}

/* Reports what is wrong with a triangle, or DM_OK for nothing. */
static dm_result check_triangle(const dmi_gltf_elements* positions, const uint32_t corners[3], uint64_t face,
                                const char* place, dmi_gltf_problem* problem) {
    for (int c = 0; c < 3; c++) {
        double xyz[3];
        if (corners[c] >= positions->count)
            return dmi_gltf_refuse(problem, DM_ERROR_INDEX_OUT_OF_RANGE,
                                   "%s: triangle %" PRIu64 " names vertex %u of %" PRIu64, place, face, corners[c],
                                   positions->count);
        for (int k = 0; k < 3; k++) xyz[k] = dmi_gltf_value(positions, corners[c], k);
        if (!isfinite(xyz[0]) || !isfinite(xyz[1]) || !isfinite(xyz[2]))
            return dmi_gltf_refuse(problem, DM_ERROR_NOT_FINITE, "%s: vertex %u is (%g, %g, %g)", place, corners[c],
                                   xyz[0], xyz[1], xyz[2]);
    }
    return DM_OK;
}

/* Removes bad triangles from the list. Returns how many stay, and the first problem. */
static uint64_t drop_bad(const dmi_gltf_elements* positions, uint32_t* corners, uint64_t faces, const char* place,
                         dmi_gltf_problem* out_first) {
    uint64_t kept = 0;
    dmi_gltf_problem here;
    for (uint64_t face = 0; face < faces; face++) {
        if (check_triangle(positions, corners + 3 * face, face, place, &here) == DM_OK)
            memmove(corners + 3 * kept++, corners + 3 * face, 3 * sizeof *corners);
        else if (out_first->code == DM_OK)
            *out_first = here;
    }
    return kept;
}

/* Leaves out triangles whose vertices do not exist or are not finite, and the whole primitive where all are so. */
static dm_result check_corners(dmi_gltf_builder* builder, const dmi_gltf_geometry* from, uint32_t* corners,
                               uint64_t* inout_faces, const char* place, dmi_gltf_problem* problem) {
    const uint64_t faces = *inout_faces;
    dmi_gltf_problem first = {.code = DM_OK}, told;
    uint32_t most = 0;
    for (uint64_t i = 0; i < 3 * faces; i++) most = corners[i] > most ? corners[i] : most;
    if (faces == 0 || (most < from->positions.count && all_finite(builder, from))) return DM_OK;
    *inout_faces = drop_bad(&from->positions, corners, faces, place, &first);
    if (first.code == DM_OK) return DM_OK;
    if (*inout_faces == 0) {
        *problem = first;
        return first.code;
    }
    dmi_gltf_refuse(&told, first.code, "%s; bad triangles: %" PRIu64 " of %" PRIu64, first.text, faces - *inout_faces,
                    faces);
    dmi_gltf_leave_out(builder->gltf, &told);
    return DM_OK;
}

/* Appends the triangles of a primitive, as positions in its accessors. */
static dm_result read_corners(dmi_gltf_builder* builder, dmi_gltf_shape* shape, const dmi_gltf_geometry* from,
                              const char* place, dmi_gltf_problem* problem, uint64_t* out_faces) {
    dm_gltf* gltf = builder->gltf;
    const uint64_t count = from->indexed ? from->indices.count : from->positions.count;
    const int listed = from->mode == DMI_GLTF_TRIANGLES;
    const uint64_t faces = listed ? count / 3 : count < 3 ? 0 : count - 2;
    *out_faces = faces;
    if (listed && count % 3 != 0)
        dmi_gltf_warn(&gltf->warnings, "%s: %" PRIu64 " corners are not a multiple of 3, the last are left out", place,
                      count);
    /* A list may have three more corners than its triangles: the odd ones. */
    dm_result result = grow_faces(gltf, shape, faces + 1, place, problem);
    if (result == DM_OK && !listed) result = dmi_gltf_spend(gltf, count, sizeof(uint32_t), place, problem);
    if (result != DM_OK) return result;
    uint32_t* out = shape->corners + 3 * shape->face_count;
    uint32_t* list = listed ? out : dmi_alloc(&gltf->env, count * sizeof *list, 16);
    if (!list) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "%s: no memory for %" PRIu64, place, count);
    if (from->indexed)
        dmi_gltf_read_indices(&from->indices, list);
    else
        for (uint64_t i = 0; i < count; i++) list[i] = (uint32_t)i;
    if (!listed) {
        spread_corners(from->mode, list, faces, out);
        dmi_free(&gltf->env, list, count * sizeof *list);
    }
    return check_corners(builder, from, out, out_faces, place, problem);
}

/* ---- primitives ---- */

/* Returns whether the material is invisible: its alpha counts and is 0. */
static int is_invisible(const dm_gltf* gltf, const cJSON* primitive) {
    float colour[4];
    const char* mode = dmi_json_text(dmi_gltf_material_of(gltf, primitive, colour), "alphaMode");
    return mode && (strcmp(mode, "BLEND") == 0 || strcmp(mode, "MASK") == 0) && colour[3] == 0;
}

/* Returns the group of the mesh whose vertices the primitive has too, or a new one. */
static uint32_t find_group(dmi_gltf_builder* builder, uint32_t mesh, const dmi_gltf_geometry* geometry) {
    dmi_gltf_shape* shape = &builder->shapes[mesh];
    const uint32_t key = geometry->key;
    if (key < dmi_gltf_key_count(builder->gltf)) {
        const uint32_t owner = builder->owners[key];
        if (builder->stamps[key] == mesh + 1 && shape->groups[owner].geometry.joint_key == geometry->joint_key)
            return owner;
        builder->stamps[key] = mesh + 1;
        builder->owners[key] = shape->group_count;
    }
    shape->groups[shape->group_count] = (dmi_gltf_group){.geometry = *geometry, .first_run = -1, .last_run = -1};
    return shape->group_count++;
}

static dmi_gltf_group* add_run(dmi_gltf_builder* builder, uint32_t mesh, const dmi_gltf_geometry* geometry,
                               const cJSON* json, uint32_t primitive, uint64_t faces) {
    dmi_gltf_shape* shape = &builder->shapes[mesh];
    const int32_t index = (int32_t)shape->run_count++;
    const uint32_t group = find_group(builder, mesh, geometry);
    dmi_gltf_group* g = &shape->groups[group];
    shape->runs[index] = (dmi_gltf_run){.primitive = primitive,
                                        .json = json,
                                        .group = group,
                                        .next = -1,
                                        .first_face = shape->face_count,
                                        .face_count = faces};
    dmi_gltf_material_of(builder->gltf, json, shape->runs[index].colour);
    if (g->last_run >= 0)
        shape->runs[g->last_run].next = index;
    else
        g->first_run = index;
    g->last_run = index;
    shape->face_count += faces;
    return g;
}

/* Adds a primitive to the shape. weights: those of the morph targets at rest; NULL: none. */
static dm_result add_primitive(dmi_gltf_builder* builder, uint32_t mesh, const cJSON* primitive, const cJSON* weights,
                               uint32_t index, const char* place, dmi_gltf_problem* problem) {
    dm_gltf* gltf = builder->gltf;
    dmi_gltf_shape* shape = &builder->shapes[mesh];
    dmi_gltf_geometry geometry;
    uint64_t faces;
    if (is_invisible(gltf, primitive)) return DM_OK;
    dm_result result = dmi_gltf_find_geometry(gltf, primitive, place, problem, &geometry);
    if (result == DM_OK) result = read_corners(builder, shape, &geometry, place, problem, &faces);
    if (result != DM_OK || faces == 0) return result;
    if (dmi_gltf_is_morphed(primitive, weights)) geometry.key = dmi_gltf_key_count(gltf); /* its vertices are its own */
    if (faces > DM_MAX_ELEMENTS - shape->face_count)
        return dmi_gltf_refuse(problem, DM_ERROR_TOO_LARGE, "%s: more than %d triangles", place, DM_MAX_ELEMENTS);
    dmi_gltf_group* group = add_run(builder, mesh, &geometry, primitive, index, faces);
    group->weights = dmi_gltf_is_morphed(primitive, weights) ? weights : NULL;
    return dmi_gltf_tell(gltf, 0, faces, problem);
}

/* ---- vertices ---- */

static dm_result grow_elements(dmi_gltf_builder* builder, uint64_t needed, dmi_gltf_problem* problem) {
    dmi_env* env = &builder->gltf->env;
    if (needed <= builder->element_capacity) return DM_OK;
    const uint64_t old = builder->element_capacity, capacity = (needed + WORD_BITS - 1) / WORD_BITS * WORD_BITS;
    const dm_result result = dmi_gltf_spend(builder->gltf, capacity, sizeof *builder->places, "glTF", problem);
    if (result != DM_OK) return result;
    dmi_free(env, builder->used, old / WORD_BITS * sizeof *builder->used);
    dmi_free(env, builder->places, old * sizeof *builder->places);
    builder->used = dmi_alloc_zeroed(env, capacity / WORD_BITS * sizeof *builder->used, 16);
    builder->places = dmi_alloc(env, capacity * sizeof *builder->places, 16);
    builder->element_capacity = capacity;
    if (builder->used && builder->places) return DM_OK;
    return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %" PRIu64 " vertices", needed);
}

static int is_marked(const dmi_gltf_builder* builder, uint64_t element) {
    return builder->used[element / WORD_BITS] >> element % WORD_BITS & 1;
}

static dm_result grow_vertices(dm_gltf* gltf, dmi_gltf_shape* shape, uint64_t added, dmi_gltf_problem* problem) {
    const uint64_t needed = shape->vertex_count + added, old = shape->vertex_capacity, kept = shape->vertex_count;
    const size_t vertex = sizeof *shape->elements + 3 * sizeof *shape->local;
    dm_result result = dmi_gltf_spend(gltf, added, vertex, "glTF: the vertices", problem);
    if (result != DM_OK || needed <= old) return result;
    const uint64_t capacity = old == 0 ? needed : 2 * needed;
    if (old > 0) result = dmi_gltf_spend(gltf, capacity, vertex, "glTF: the vertices", problem);
    if (result != DM_OK) return result;
    float* local = dmi_alloc(&gltf->env, capacity * 3 * sizeof *local, 16);
    uint32_t* elements = dmi_alloc(&gltf->env, capacity * sizeof *elements, 16);
    if (local && elements && kept > 0) {
        memcpy(local, shape->local, kept * 3 * sizeof *local);
        memcpy(elements, shape->elements, kept * sizeof *elements);
    }
    dmi_free(&gltf->env, shape->local, old * 3 * sizeof *local);
    dmi_free(&gltf->env, shape->elements, old * sizeof *elements);
    shape->local = local;
    shape->elements = elements;
    shape->vertex_capacity = capacity;
    if (local && elements) return DM_OK;
    return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %" PRIu64 " vertices", needed);
}

static void set_mark(dmi_gltf_builder* builder, uint64_t element, int on) {
    const uint64_t bit = (uint64_t)1 << element % WORD_BITS;
    uint64_t* word = &builder->used[element / WORD_BITS];
    *word = on ? *word | bit : *word & ~bit;
}

/* Marks the elements that triangles have. Returns how many there are. */
static uint64_t mark_group(dmi_gltf_builder* builder, const dmi_gltf_shape* shape, const dmi_gltf_group* group) {
    uint64_t marked = 0;
    for (int32_t r = group->first_run; r >= 0; r = shape->runs[r].next) {
        const uint32_t* corners = shape->corners + 3 * shape->runs[r].first_face;
        for (uint64_t i = 0; i < 3 * shape->runs[r].face_count; i++) {
            uint64_t* word = &builder->used[corners[i] / WORD_BITS];
            const uint64_t bit = (uint64_t)1 << corners[i] % WORD_BITS;
            marked += (*word & bit) == 0;
            *word |= bit;
        }
    }
    return marked;
}

/* Returns whether so few elements are marked that sorting them is less work than a look at the marks of all. */
static int is_few(uint64_t marked, uint64_t elements) {
    return marked < elements / FEW;
}

static void clear_marks(dmi_gltf_builder* builder, const dmi_gltf_shape* shape, const dmi_gltf_group* group) {
    const uint64_t elements = group->geometry.positions.count, words = (elements + WORD_BITS - 1) / WORD_BITS;
    if (is_few(group->vertex_count, elements))
        for (uint64_t v = group->first_vertex; v < group->first_vertex + group->vertex_count; v++)
            set_mark(builder, shape->elements[v], 0);
    else
        memset(builder->used, 0, words * sizeof *builder->used);
}

static void read_position(const dmi_gltf_elements* from, uint64_t element, float out[3]) {
    if (from->data && from->component_type == DMI_GLTF_FLOAT)
        memcpy(out, from->data + element * from->stride, 3 * sizeof *out);
    else
        for (int k = 0; k < 3; k++) out[k] = (float)dmi_gltf_element(from, element, k);
}

static void add_vertex(dmi_gltf_builder* builder, dmi_gltf_shape* shape, uint64_t element) {
    shape->elements[shape->vertex_count] = (uint32_t)element;
    builder->places[element] = (uint32_t)shape->vertex_count++;
}

/* Lists all elements. */
static void list_all(dmi_gltf_builder* builder, dmi_gltf_shape* shape, uint64_t count) {
    for (uint64_t e = 0; e < count; e++) add_vertex(builder, shape, e);
}

/* Lists the marked elements, where there are many. */
static void list_marked(dmi_gltf_builder* builder, dmi_gltf_shape* shape, uint64_t count) {
    for (uint64_t e = 0; e < count; e++) {
        if (builder->used[e / WORD_BITS] == 0) e |= WORD_BITS - 1; /* skips to the next word */
        if (e < count && is_marked(builder, e)) add_vertex(builder, shape, e);
    }
}

static int compare_elements(const void* a, const void* b) {
    const uint32_t x = *(const uint32_t*)a, y = *(const uint32_t*)b;
    return (x > y) - (x < y);
}

/* Lists the marked elements of few triangles, without a look at all others. */
static void list_few(dmi_gltf_builder* builder, dmi_gltf_shape* shape, const dmi_gltf_group* group) {
    uint32_t* listed = shape->elements + shape->vertex_count;
    uint64_t count = 0;
    for (int32_t r = group->first_run; r >= 0; r = shape->runs[r].next) {
        const uint32_t* corners = shape->corners + 3 * shape->runs[r].first_face;
        for (uint64_t i = 0; i < 3 * shape->runs[r].face_count; i++) {
            if (!is_marked(builder, corners[i])) continue;
            set_mark(builder, corners[i], 0);
            listed[count++] = corners[i];
        }
    }
    qsort(listed, count, sizeof *listed, compare_elements);
    for (uint64_t i = 0; i < count; i++) {
        set_mark(builder, listed[i], 1);
        add_vertex(builder, shape, listed[i]);
    }
}

/* Fills the vertices of a group from all elements, or from those that are marked. */
static void fill_vertices(dmi_gltf_builder* builder, dmi_gltf_shape* shape, dmi_gltf_group* group, int whole,
                          uint64_t marked) {
    const dmi_gltf_elements* from = &group->geometry.positions;
    group->first_vertex = shape->vertex_count;
    if (whole)
        list_all(builder, shape, from->count);
    else if (is_few(marked, from->count))
        list_few(builder, shape, group);
    else
        list_marked(builder, shape, from->count);
    group->vertex_count = shape->vertex_count - group->first_vertex;
    for (uint64_t v = group->first_vertex; v < shape->vertex_count; v++) {
        float* out = shape->local + 3 * v;
        read_position(from, shape->elements[v], out);
        const uint64_t change =
            from->change_count > 0 ? dmi_gltf_find_change(from, shape->elements[v]) : from->change_count;
        for (int k = 0; change < from->change_count && k < 3; k++) out[k] = (float)dmi_gltf_change(from, change, k);
    }
}

/* Replaces elements by vertices in the triangles of the group. */
static void number_corners(dmi_gltf_builder* builder, dmi_gltf_shape* shape, const dmi_gltf_group* group) {
    for (int32_t r = group->first_run; r >= 0; r = shape->runs[r].next) {
        uint32_t* corners = shape->corners + 3 * shape->runs[r].first_face;
        for (uint64_t i = 0; i < 3 * shape->runs[r].face_count; i++) corners[i] = builder->places[corners[i]];
    }
}

/* Widens the shape's box by the marked vertices. */
static void widen_box(const dmi_gltf_builder* builder, dmi_gltf_shape* shape, const dmi_gltf_group* group) {
    for (uint64_t v = group->first_vertex; v < group->first_vertex + group->vertex_count; v++) {
        if (!is_marked(builder, shape->elements[v])) continue;
        for (int k = 0; k < 3; k++) {
            const float x = shape->local[3 * v + (uint64_t)k];
            shape->low[k] = x < shape->low[k] ? x : shape->low[k];
            shape->high[k] = x > shape->high[k] ? x : shape->high[k];
        }
    }
}

/* Moves vertices that no triangle has, where they lie outside of the box or are not finite, to one that some triangle
 * has. */
static void mend_unused(dmi_gltf_shape* shape, const dmi_gltf_group* group) {
    const float* good = shape->local + 3 * (size_t)shape->corners[3 * shape->runs[group->first_run].first_face];
    for (uint64_t v = group->first_vertex; v < group->first_vertex + group->vertex_count; v++) {
        float* p = shape->local + 3 * v;
        int inside = 1;
        for (int k = 0; k < 3; k++) inside &= p[k] >= shape->low[k] && p[k] <= shape->high[k];
        if (!inside) memcpy(p, good, 3 * sizeof *p);
    }
}

/* Moves the vertices of a group of one primitive by its morph targets. */
static dm_result morph_group(dm_gltf* gltf, dmi_gltf_shape* shape, const dmi_gltf_group* group,
                             dmi_gltf_problem* problem) {
    char place[PLACE_SIZE];
    const dmi_gltf_run* run = &shape->runs[group->first_run];
    const dmi_gltf_morphed morphed = {.primitive = run->json,
                                      .weights = group->weights,
                                      .place = place,
                                      .elements = shape->elements + group->first_vertex,
                                      .positions = shape->local + 3 * group->first_vertex,
                                      .count = group->vertex_count};
    snprintf(place, sizeof place, "glTF: a mesh's primitive %u", run->primitive);
    return dmi_gltf_morph(gltf, &morphed, problem);
}

static dm_result build_group(dmi_gltf_builder* builder, dmi_gltf_shape* shape, dmi_gltf_group* group,
                             dmi_gltf_problem* problem) {
    const uint32_t key = group->geometry.key;
    const int whole = key == dmi_gltf_key_count(builder->gltf) || builder->users[key] != SEVERAL;
    dm_result result = grow_elements(builder, group->geometry.positions.count, problem);
    if (result != DM_OK) return result;
    const uint64_t marked = mark_group(builder, shape, group);
    result = dmi_gltf_tell(builder->gltf, 0, marked, problem);
    if (result != DM_OK) return result;
    group->unused = whole && marked < group->geometry.positions.count;
    result = grow_vertices(builder->gltf, shape, whole ? group->geometry.positions.count : marked, problem);
    if (result != DM_OK) return result;
    fill_vertices(builder, shape, group, whole, marked);
    result = group->weights ? morph_group(builder->gltf, shape, group, problem) : DM_OK;
    if (result == DM_OK) result = dmi_gltf_tell(builder->gltf, 0, group->vertex_count, problem);
    if (result != DM_OK) return result;
    number_corners(builder, shape, group);
    widen_box(builder, shape, group);
    clear_marks(builder, shape, group);
    return dmi_gltf_tell(builder->gltf, 0, group->vertex_count, problem);
}

dm_result dmi_gltf_build_shape(dmi_gltf_builder* builder, uint32_t node, dmi_gltf_problem* problem) {
    dm_gltf* gltf = builder->gltf;
    const uint32_t mesh = (uint32_t)gltf->tree[node].mesh;
    dmi_gltf_shape* shape = &builder->shapes[mesh];
    const cJSON* primitives = dmi_json_get(gltf->document.items[DMI_GLTF_MESHES][mesh], "primitives");
    const cJSON *primitive, *weights = dmi_gltf_weights_of(gltf, gltf->tree[node].json);
    uint32_t index = 0;
    if (shape->built) return DM_OK;
    shape->built = 1;
    for (int k = 0; k < 3; k++) {
        shape->low[k] = INFINITY;
        shape->high[k] = -INFINITY;
    }
    const uint32_t primitive_count = (uint32_t)cJSON_GetArraySize(primitives);
    const size_t item = sizeof *shape->groups + sizeof *shape->runs;
    const dm_result room = dmi_gltf_spend(gltf, primitive_count, item, "glTF: the primitives", problem);
    if (room != DM_OK) return room;
    shape->capacity = primitive_count;
    shape->groups = dmi_alloc(&gltf->env, shape->capacity * sizeof *shape->groups, 16);
    shape->runs = dmi_alloc(&gltf->env, shape->capacity * sizeof *shape->runs, 16);
    if (!shape->groups || !shape->runs)
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u primitives", shape->capacity);
    cJSON_ArrayForEach(primitive, primitives) {
        char place[PLACE_SIZE];
        dmi_gltf_problem here = {.code = DM_OK};
        snprintf(place, sizeof place, "glTF node %u '%.80s', primitive %u", node, gltf->tree[node].name, index);
        const dm_result result = add_primitive(builder, mesh, primitive, weights, index++, place, &here);
        if (result == DM_OK) continue;
        if (here.fatal) {
            *problem = here;
            return result;
        }
        dmi_gltf_leave_out(gltf, &here);
    }
    for (uint32_t g = 0; g < shape->group_count; g++) {
        const dm_result result = build_group(builder, shape, &shape->groups[g], problem);
        if (result != DM_OK) return result;
    }
    for (uint32_t g = 0; g < shape->group_count; g++) {
        if (shape->groups[g].unused) mend_unused(shape, &shape->groups[g]);
    }
    return DM_OK;
}
