/* Splits the mesh of a node between what stays and what moves. Where the triangles alone tell the halves apart, they
 * share their vertices; compressed vertices, and those that bones have placed, are copied. */
#include "gltf/gltf_split.h"

#include <string.h>

#include "gltf/gltf_copy.h"
#include "gltf/gltf_geometry.h"
#include "gltf/gltf_skin.h"

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
        made = dmi_copy_primitive(e, &copy);
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
