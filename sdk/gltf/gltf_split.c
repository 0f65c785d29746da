/* Splits the mesh of a node between what stays and what moves. Where the triangles alone tell the halves apart, they
 * share their vertices; compressed vertices, and those that bones have placed, are copied. */
#include "gltf/gltf_moves.h"

#include <math.h>
#include <string.h>

#include "gltf/gltf_edit.h"
#include "gltf/gltf_geometry.h"
#include "gltf/gltf_merge.h"

typedef struct splitter {
    dmi_edit* e;
    const dmi_moves* moves;
    const cJSON* primitives; /* primitives of the mesh in the file */
    uint32_t node, owner, primitive_count;
    uint32_t first_piece, piece_count; /* pieces of the node */
    uint32_t* heads;                   /* per primitive: 1 + its first piece, from first_piece on; 0: none */
    uint32_t* nexts;                   /* per piece: the same of the next one */
    uint64_t* counts;                  /* per primitive: its triangles that `owner` has */
    uint64_t* totals;                  /* per primitive: all its triangles */
    int skinned;
    dmi_gltf_skin skin; /* skin of a node whose part moves */
} splitter;

/* ---- copies of a primitive with vertices of their own ---- */

/* Vertices and triangles of a copy. */
typedef struct dmi_copy {
    const cJSON* from;        /* the primitive in the file */
    const uint32_t* elements; /* per vertex: its position in the primitive's accessors */
    const uint32_t* vertices; /* per vertex: its position in the merged mesh */
    uint32_t* corners;        /* corners of the triangles, as vertices of the copy */
    uint64_t vertex_count, face_count;
    const double* placed; /* matrix that placed the vertices in the merged mesh, from which the copy takes them without
                             bones; NULL: it stays in the mesh's frame */
} dmi_copy;

enum { MOST_COMPONENTS = 16 };

/* One attribute being copied. */
typedef struct attribute {
    const char* name;
    double accessor; /* accessor in the file */
    dmi_gltf_elements from;
    uint64_t element, stride; /* bytes of an element of the copy; the same with its padding to 4 bytes */
    uint8_t* bytes;
    uint64_t size;
} attribute;

static int starts_with(const char* name, const char* start) {
    return strncmp(name, start, strlen(start)) == 0;
}

static dm_result find_attribute(dmi_edit* e, const dmi_copy* copy, const cJSON* item, attribute* out) {
    dm_gltf* gltf = (dm_gltf*)e->from; /* the file keeps what it decompresses */
    *out = (attribute){.name = item->string, .accessor = item->valuedouble};
    const dm_result result =
        dmi_gltf_draco_of(gltf, copy->from)
            ? dmi_gltf_find_in_draco(gltf, copy->from, out->name, "glTF: export", &e->problem, &out->from)
            : dmi_gltf_find_elements(gltf, out->accessor, "glTF: export", &e->problem, &out->from);
    if (result != DM_OK) return result;
    for (uint64_t v = 0; v < copy->vertex_count; v++) {
        if (copy->elements[v] >= out->from.count)
            return dmi_gltf_refuse(&e->problem, DM_ERROR_BAD_DATA, "glTF: export: %.40s has too few values", out->name);
    }
    out->element = (uint64_t)out->from.components * dmi_gltf_component_size(out->from.component_type);
    out->stride = (out->element + 3) & ~(uint64_t)3;
    out->size = copy->vertex_count * out->stride;
    out->bytes = dmi_alloc_zeroed(e->env, out->size, 16);
    if (out->bytes) return DM_OK;
    return dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: export: no memory for %.40s", out->name);
}

/* Copies the bytes as they are, with sparse changes. */
static void copy_values(const dmi_copy* copy, attribute* a) {
    const dmi_gltf_elements* from = &a->from;
    for (uint64_t v = 0; v < copy->vertex_count; v++) {
        const uint64_t element = copy->elements[v];
        const uint8_t* source = from->data ? from->data + element * from->stride : NULL;
        const uint64_t change = dmi_gltf_find_change(from, element);
        if (change < from->change_count) source = from->changes + change * from->change_stride;
        if (source) memcpy(a->bytes + v * a->stride, source, a->element);
    }
}

/* ---- vertices that bones have placed ---- */

/* Computes m * v, or for normals cofactor(m) * v, which stays perpendicular. */
static void turn_vector(const double m[16], int is_normal, const double v[3], double out[3]) {
    double c[9];
    for (int column = 0; column < 3; column++) {
        const double *p = m + 4 * (size_t)((column + 1) % 3), *q = m + 4 * (size_t)((column + 2) % 3);
        const double cross[3] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
        for (int row = 0; row < 3; row++) c[3 * column + row] = is_normal ? cross[row] : m[4 * column + row];
    }
    for (int row = 0; row < 3; row++) out[row] = c[row] * v[0] + c[3 + row] * v[1] + c[6 + row] * v[2];
    const double length = sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    for (int k = 0; k < 3; k++) out[k] = length > 0 ? out[k] / length : k == 2;
}

/* Replaces the values of positions, normals and tangents by floats in the frame of the merged mesh. */
static void place_values(dmi_edit* e, const dmi_copy* copy, attribute* a) {
    const int is_position = strcmp(a->name, "POSITION") == 0, width = strcmp(a->name, "TANGENT") == 0 ? 4 : 3;
    const int is_normal = strcmp(a->name, "NORMAL") == 0;
    const uint64_t size = copy->vertex_count * (uint64_t)width * sizeof(float);
    float* out = dmi_alloc(e->env, size, 16);
    if (!out) {
        dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: export: no memory for %s", a->name);
        return;
    }
    for (uint64_t v = 0; v < copy->vertex_count; v++) {
        float* to = out + v * (uint64_t)width;
        double from[4] = {0, 0, 0, 1}, turned[3];
        for (int k = 0; k < width && k < a->from.components; k++)
            from[k] = dmi_gltf_element(&a->from, copy->elements[v], k);
        turn_vector(copy->placed, is_normal, from, turned);
        for (int k = 0; k < 3; k++)
            to[k] = is_position ? e->from->positions[3 * (size_t)copy->vertices[v] + (size_t)k] : (float)turned[k];
        if (width == 4) to[3] = (float)from[3];
    }
    dmi_free(e->env, a->bytes, a->size);
    a->bytes = (uint8_t*)out;
    a->size = size;
    a->stride = a->element = (uint64_t)width * sizeof *out;
    a->from.component_type = DMI_GLTF_FLOAT;
    a->from.components = width;
    a->from.normalized = 0;
}

/* ---- accessors ---- */

/* Sets min and max from the bytes of the copy, which glTF demands of positions. */
static void set_limits(dmi_edit* e, const attribute* a, uint64_t count, cJSON* accessor) {
    const dmi_gltf_elements made = {.data = a->bytes,
                                    .stride = a->stride,
                                    .count = count,
                                    .component_type = a->from.component_type,
                                    .components = a->from.components};
    double low[MOST_COMPONENTS], high[MOST_COMPONENTS];
    for (int k = 0; k < made.components; k++) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
        for (uint64_t v = 0; v < count; v++) {
            low[k] = fmin(low[k], dmi_gltf_element(&made, v, k));
            high[k] = fmax(high[k], dmi_gltf_element(&made, v, k));
        }
    }
    dmi_edit_numbers(e, accessor, "min", low, made.components);
    dmi_edit_numbers(e, accessor, "max", high, made.components);
}

/* Returns whether bones move the attribute, so that a placed copy has its own values. */
static int is_placed(const char* name) {
    return strcmp(name, "POSITION") == 0 || strcmp(name, "NORMAL") == 0 || strcmp(name, "TANGENT") == 0;
}

/* Adds the accessor of an attribute of the copy. It is like the file's, but for what is different. */
static int32_t add_accessor(dmi_edit* e, const dmi_copy* copy, const attribute* a) {
    const cJSON* old = dmi_gltf_item(&e->from->document, DMI_GLTF_ACCESSORS, a->accessor);
    const char* placed_type = a->from.components == 4 ? "VEC4" : "VEC3";
    const char* type = copy->placed && is_placed(a->name) ? placed_type : dmi_json_text(old, "type");
    const int32_t view = dmi_edit_add_view(e, a->bytes, a->size, DMI_GLTF_VERTEX_TARGET);
    if (a->stride != a->element && e->problem.code == DM_OK)
        dmi_edit_number(e, dmi_json_get(e->document.root, "bufferViews")->child->prev, "byteStride", (double)a->stride);
    const dmi_edit_item made = dmi_edit_add(e, DMI_GLTF_ACCESSORS, dmi_edit_new(e, cJSON_Duplicate(old, 1)));
    static const char* const dropped[] = {"sparse", "byteOffset", "min", "max", "normalized"};
    for (size_t i = 0; made.json && i < sizeof dropped / sizeof *dropped; i++)
        cJSON_DeleteItemFromObjectCaseSensitive(made.json, dropped[i]);
    dmi_edit_number(e, made.json, "bufferView", view);
    dmi_edit_number(e, made.json, "componentType", a->from.component_type);
    dmi_edit_number(e, made.json, "count", (double)copy->vertex_count);
    dmi_edit_text(e, made.json, "type", type);
    if (a->from.normalized) dmi_edit_set(e, made.json, "normalized", cJSON_CreateTrue());
    if (strcmp(a->name, "POSITION") == 0) set_limits(e, a, copy->vertex_count, made.json);
    return made.index;
}

static void copy_attributes(dmi_edit* e, const dmi_copy* copy, const cJSON* from, cJSON* to) {
    const cJSON* item;
    cJSON_ArrayForEach(item, from) {
        attribute a;
        if (e->problem.code != DM_OK) return;
        if (copy->placed && (starts_with(item->string, "JOINTS_") || starts_with(item->string, "WEIGHTS_"))) continue;
        if (find_attribute(e, copy, item, &a) == DM_OK) {
            copy_values(copy, &a);
            if (copy->placed && is_placed(a.name)) place_values(e, copy, &a);
            dmi_edit_number(e, to, a.name, add_accessor(e, copy, &a));
        }
        dmi_free(e->env, a.bytes, a.size);
    }
}

/* ---- the primitive ---- */

/* Copies the morph targets. They move vertices in the mesh's frame, so a placed copy has none. */
static void copy_targets(dmi_edit* e, const dmi_copy* copy, cJSON* made) {
    const cJSON *targets = dmi_json_get(copy->from, "targets"), *target;
    if (!targets) return;
    if (copy->placed) {
        dmi_gltf_warn(&e->from->warnings, "dm_gltf_export: the morph targets of a moving part with bones are left out");
        cJSON_DeleteItemFromObjectCaseSensitive(made, "targets");
        return;
    }
    cJSON* list = dmi_edit_set(e, made, "targets", cJSON_CreateArray());
    cJSON_ArrayForEach(target, targets) {
        cJSON* copied = dmi_edit_new(e, cJSON_CreateObject());
        copy_attributes(e, copy, target, copied);
        dmi_edit_append(e, list, copied);
    }
}

/* Copies a primitive. Returns the new one, or NULL after a failure. */
static cJSON* copy_primitive(dmi_edit* e, const dmi_copy* copy) {
    cJSON* made = dmi_edit_new(e, cJSON_Duplicate(copy->from, 1));
    if (!made) return NULL;
    cJSON* extensions = cJSON_GetObjectItemCaseSensitive(made, "extensions");
    if (extensions) cJSON_DeleteItemFromObjectCaseSensitive(extensions, DMI_DRACO_NAME);
    if (extensions && !extensions->child) cJSON_DeleteItemFromObjectCaseSensitive(made, "extensions");
    cJSON_DeleteItemFromObjectCaseSensitive(made, "mode"); /* the copy is a list of triangles */
    const uint64_t corners = 3 * copy->face_count;
    const int32_t view = dmi_edit_add_view(e, copy->corners, corners * sizeof *copy->corners, DMI_GLTF_INDEX_TARGET);
    dmi_edit_number(e, made, "indices", dmi_edit_add_accessor(e, view, DMI_GLTF_UINT, 1, corners, NULL, NULL));
    cJSON* attributes = dmi_edit_set(e, made, "attributes", cJSON_CreateObject());
    copy_attributes(e, copy, dmi_json_get(copy->from, "attributes"), attributes);
    copy_targets(e, copy, made);
    return made;
}

/* ---- splitting ---- */

static int open_splitter(splitter* s) {
    dm_gltf* gltf = s->moves->gltf;
    dmi_env* env = s->e->env;
    const cJSON* mesh = gltf->document.items[DMI_GLTF_MESHES][gltf->tree[s->node].mesh];
    s->primitives = dmi_json_get(mesh, "primitives");
    s->primitive_count = (uint32_t)cJSON_GetArraySize(s->primitives);
    s->first_piece = s->moves->first_pieces[s->node];
    for (uint32_t p = s->first_piece; p < gltf->piece_count && gltf->pieces[p].mesh_node == s->node; p++)
        s->piece_count++;
    s->heads = dmi_alloc_zeroed(env, s->primitive_count * sizeof *s->heads, 16);
    s->nexts = dmi_alloc_zeroed(env, s->piece_count * sizeof *s->nexts, 16);
    s->counts = dmi_alloc_zeroed(env, s->primitive_count * sizeof *s->counts, 16);
    s->totals = dmi_alloc_zeroed(env, s->primitive_count * sizeof *s->totals, 16);
    if (!s->heads || !s->nexts || !s->counts || !s->totals) return 0;
    for (uint32_t p = s->piece_count; p-- > 0;) {
        const dmi_gltf_piece* piece = &gltf->pieces[s->first_piece + p];
        s->nexts[p] = s->heads[piece->primitive];
        s->heads[piece->primitive] = p + 1;
        s->counts[piece->primitive] += dmi_moves_count(s->moves, piece, s->owner);
        s->totals[piece->primitive] += piece->face_count;
        s->skinned |= piece->joint >= 0;
    }
    if (!s->skinned || s->owner == 0) return 1;
    const double skin = dmi_json_number(gltf->tree[s->node].json, "skin", DMI_GLTF_NO_INDEX);
    return dmi_gltf_open_skin(gltf, skin, "glTF: export", &s->e->problem, &s->skin) == DM_OK;
}

static void close_splitter(splitter* s) {
    dmi_env* env = s->e->env;
    dmi_free(env, s->heads, s->primitive_count * sizeof *s->heads);
    dmi_free(env, s->nexts, s->piece_count * sizeof *s->nexts);
    dmi_free(env, s->counts, s->primitive_count * sizeof *s->counts);
    dmi_free(env, s->totals, s->primitive_count * sizeof *s->totals);
    dmi_gltf_close_skin(env, &s->skin);
}

/* Writes the corners that `owner` has of a piece, as vertices of the merged mesh. Returns the end. With `keep_turn`,
 * triangles are turned as the merged mesh has them, not as the file does. */
static uint32_t* list_corners(const splitter* s, const dmi_gltf_piece* piece, int keep_turn, uint32_t* out) {
    const dm_gltf* gltf = s->moves->gltf;
    const int turned = piece->mirrored && !keep_turn;
    for (uint64_t face = piece->first_face; face < piece->first_face + piece->face_count; face++) {
        if (s->moves->owners[face] != s->owner) continue;
        for (int corner = 0; corner < 3; corner++) *out++ = gltf->indices[3 * face + (turned ? 2 - corner : corner)];
    }
    return out;
}

/* ---- the same vertices ---- */

/* Copies the primitive with other triangles of the same vertices. */
static cJSON* share_vertices(splitter* s, const cJSON* primitive, uint32_t index) {
    dmi_edit* e = s->e;
    const dm_gltf* gltf = s->moves->gltf;
    const uint64_t corners = 3 * s->counts[index];
    uint32_t* list = dmi_alloc(e->env, corners * sizeof *list, 16);
    cJSON* copy = dmi_edit_new(e, cJSON_Duplicate(primitive, 1));
    if (!list) dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory to split a mesh");
    if (list && copy) {
        uint32_t* end = list;
        for (uint32_t p = s->heads[index]; p; p = s->nexts[p - 1])
            end = list_corners(s, &gltf->pieces[s->first_piece + p - 1], 0, end);
        for (uint64_t i = 0; i < corners; i++) list[i] = gltf->sources[list[i]];
        const int32_t view = dmi_edit_add_view(e, list, corners * sizeof *list, DMI_GLTF_INDEX_TARGET);
        dmi_edit_number(e, copy, "indices", dmi_edit_add_accessor(e, view, DMI_GLTF_UINT, 1, corners, NULL, NULL));
        cJSON_DeleteItemFromObjectCaseSensitive(copy, "mode"); /* a strip has become a list */
    }
    dmi_free(e->env, list, corners * sizeof *list);
    return copy;
}

/* ---- vertices of its own ---- */

/* Numbers the vertices of the listed corners, in the order in which they come first. places: one a merged vertex,
 * zeros. */
static void number_vertices(uint32_t* places, uint32_t* corners, uint64_t count, uint32_t* vertices,
                            uint64_t* out_count) {
    *out_count = 0;
    for (uint64_t i = 0; i < count; i++) {
        uint32_t* place = &places[corners[i]];
        if (*place == 0) {
            vertices[(*out_count)++] = corners[i];
            *place = (uint32_t)*out_count;
        }
        corners[i] = *place - 1;
    }
    for (uint64_t v = 0; v < *out_count; v++) places[vertices[v]] = 0;
}

/* Copies the triangles of the pieces from `first` to before `end`, in the list of a primitive. */
static cJSON* copy_pieces(splitter* s, const cJSON* primitive, uint32_t first, uint32_t end, const double* placed) {
    dmi_edit* e = s->e;
    const dm_gltf* gltf = s->moves->gltf;
    uint64_t faces = 0;
    for (uint32_t p = first; p != end; p = s->nexts[p - 1])
        faces += dmi_moves_count(s->moves, &gltf->pieces[s->first_piece + p - 1], s->owner);
    const uint64_t bytes = 3 * faces * sizeof(uint32_t);
    uint32_t *corners = dmi_alloc(e->env, bytes, 16), *vertices = dmi_alloc(e->env, bytes, 16);
    uint32_t* elements = dmi_alloc(e->env, bytes, 16);
    cJSON* made = NULL;
    if (corners && vertices && elements) {
        uint32_t* last = corners;
        for (uint32_t p = first; p != end; p = s->nexts[p - 1])
            last = list_corners(s, &gltf->pieces[s->first_piece + p - 1], placed != NULL, last);
        dmi_copy copy = {.from = primitive,
                         .elements = elements,
                         .vertices = vertices,
                         .corners = corners,
                         .face_count = faces,
                         .placed = placed};
        number_vertices(s->moves->places, corners, 3 * faces, vertices, &copy.vertex_count);
        for (uint64_t v = 0; v < copy.vertex_count; v++) elements[v] = gltf->sources[vertices[v]];
        made = copy_primitive(e, &copy);
    } else {
        dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory to split a mesh");
    }
    dmi_free(e->env, corners, bytes);
    dmi_free(e->env, vertices, bytes);
    dmi_free(e->env, elements, bytes);
    return made;
}

/* Appends a primitive for each bone that moves some of it, because bones turn normals each in their way. */
static void place_pieces(splitter* s, const cJSON* primitive, uint32_t index, cJSON* list) {
    for (uint32_t p = s->heads[index]; p; p = s->nexts[p - 1]) {
        const dmi_gltf_piece* piece = &s->moves->gltf->pieces[s->first_piece + p - 1];
        if (dmi_moves_count(s->moves, piece, s->owner) == 0) continue;
        const double* placed = s->skin.joints[piece->joint].matrix;
        dmi_edit_append(s->e, list, copy_pieces(s, primitive, p, s->nexts[p - 1], placed));
    }
}

/* ---- meshes ---- */

static void split_primitive(splitter* s, const cJSON* primitive, uint32_t index, cJSON* list) {
    const dm_gltf* gltf = s->moves->gltf;
    const uint64_t owned = s->counts[index], total = s->totals[index];
    dmi_edit_tell(s->e, 0, total);
    if (owned == 0 && (total > 0 || s->owner != 0)) return;
    if (s->skinned && s->owner != 0)
        place_pieces(s, primitive, index, list);
    else if (owned == total)
        dmi_edit_append(s->e, list, cJSON_Duplicate(primitive, 1));
    else if (dmi_gltf_draco_of(gltf, primitive))
        dmi_edit_append(s->e, list, copy_pieces(s, primitive, s->heads[index], 0, NULL));
    else
        dmi_edit_append(s->e, list, share_vertices(s, primitive, index));
}

int32_t dmi_split_mesh(dmi_edit* e, const dmi_moves* moves, uint32_t node, uint32_t owner) {
    const dm_gltf* gltf = moves->gltf;
    splitter s = {.e = e, .moves = moves, .node = node, .owner = owner};
    dmi_edit_item mesh = {NULL, -1};
    cJSON* list = dmi_edit_new(e, cJSON_CreateArray());
    if (list && open_splitter(&s)) {
        const cJSON* primitive;
        uint32_t index = 0;
        cJSON_ArrayForEach(primitive, s.primitives) split_primitive(&s, primitive, index++, list);
    } else if (e->problem.code == DM_OK) {
        dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory to split a mesh");
    }
    if (list && list->child) {
        const cJSON* old = gltf->document.items[DMI_GLTF_MESHES][gltf->tree[node].mesh];
        mesh = dmi_edit_add(e, DMI_GLTF_MESHES, dmi_edit_new(e, cJSON_Duplicate(old, 1)));
        dmi_edit_set(e, mesh.json, "primitives", list);
        if (s.skinned && owner != 0) cJSON_DeleteItemFromObjectCaseSensitive(mesh.json, "weights");
    } else {
        cJSON_Delete(list);
    }
    close_splitter(&s);
    return mesh.index;
}
