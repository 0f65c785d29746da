#include "preparation.h"

#include <stdlib.h>

#include "library.h"

enum { ARRAY_VERTEX = 0, ARRAY_INDEX = 12, PRIMITIVE_TRIANGLES = 3 }; /* Mesh.ArrayType, Mesh.PrimitiveType */
enum { LEAST_CAPACITY = 1024 };

typedef struct asset_source {
    uint32_t parent, flags;
    char *name, *mesh_name;
    float transform[16]; /* column after column */
    size_t first_vertex, vertex_count, first_index, index_count;
} asset_source;

preparation* preparation_new(uint32_t parts, uint32_t nodes) {
    preparation* p = calloc(1, sizeof *p);
    if (!p) return NULL;
    p->task = -1;
    p->parts = calloc(parts + 1, sizeof *p->parts);
    p->pivots = calloc(parts + 1, sizeof *p->pivots);
    p->out_of_memory = !p->parts || !p->pivots;
    if (!nodes) return p;
    p->nodes = calloc(nodes, sizeof *p->nodes);
    p->parts_of_nodes = calloc(nodes, sizeof *p->parts_of_nodes);
    p->out_of_memory |= !p->nodes || !p->parts_of_nodes;
    return p;
}

static void wait_for_task(preparation* p) {
    if (p->task < 0) return;
    gd_value pool = gd_singleton("WorkerThreadPool"), task = gd_of_int(p->task);
    gd_do(&pool, "wait_for_task_completion", 1, &task);
    gd_free(&task);
    gd_free(&pool);
    p->task = -1;
}

void preparation_stop(preparation* p) {
    atomic_store(&p->cancelled, true);
    wait_for_task(p);
}

void preparation_free(preparation* p) {
    wait_for_task(p);
    for (uint32_t i = 0; p->parts && i < p->part_count; i++) free((void*)p->parts[i].label);
    for (uint32_t i = 0; i < p->node_count; i++) {
        free(p->nodes[i].name);
        free(p->nodes[i].mesh_name);
    }
    free(p->label);
    free(p->parts_of_nodes);
    free(p->nodes);
    free(p->pivots);
    free(p->parts);
    free(p->face_parts);
    free(p->indices);
    free(p->positions);
    free(p);
}

/* Makes room for `more` elements of `size` bytes; false without memory. */
static bool make_room(void** array, size_t* capacity, size_t count, size_t more, size_t size) {
    if (count + more <= *capacity) return true;
    size_t wanted = 2 * *capacity > count + more ? 2 * *capacity : count + more;
    if (wanted < LEAST_CAPACITY) wanted = LEAST_CAPACITY;
    void* grown = realloc(*array, wanted * size);
    if (!grown) return false;
    *array = grown, *capacity = wanted;
    return true;
}

static bool reserve(preparation* p, size_t vertices, size_t indices) {
    const bool reserved =
        make_room((void**)&p->positions, &p->vertex_capacity, p->vertex_count, vertices, 3 * sizeof *p->positions) &&
        make_room((void**)&p->face_parts, &p->face_capacity, p->index_count / 3, indices / 3, sizeof *p->face_parts) &&
        make_room((void**)&p->indices, &p->index_capacity, p->index_count, indices, sizeof *p->indices);
    p->out_of_memory |= !reserved;
    return reserved;
}

/* Godot's front faces are wound clockwise, glTF's and the library's counter-clockwise: two corners change places. */
static void add_faces(preparation* p, const int32_t* indices, size_t count, uint32_t part) {
    const uint32_t first = (uint32_t)p->vertex_count;
    static const size_t corner[3] = {0, 2, 1};
    for (size_t i = 0; i < count; i++) {
        const size_t from = i - i % 3 + corner[i % 3];
        p->indices[p->index_count + i] = first + (indices ? (uint32_t)indices[from] : (uint32_t)from);
    }
    for (size_t face = 0; face < count / 3; face++) p->face_parts[p->index_count / 3 + face] = part;
    p->index_count += count;
}

static void add_surface(preparation* p, const gd_value* arrays, const affine* place, uint32_t part) {
    gd_value vertices = gd_at(arrays, ARRAY_VERTEX), indices = gd_at(arrays, ARRAY_INDEX);
    const bool three = gd_is(&vertices, GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY);
    const size_t vertex_count = three ? (size_t)gd_count(&vertices) : 0;
    const int32_t* index = gd_ints(&indices);
    const size_t all = index ? (size_t)gd_count(&indices) : vertex_count, index_count = all - all % 3;
    if (index_count && reserve(p, vertex_count, index_count)) {
        add_faces(p, index, index_count, part);
        for (size_t v = 0; v < vertex_count; v++) {
            double position[3];
            gd_vector3_at(&vertices, (int64_t)v, position);
            const dm_vec3 placed = affine_point(place, position);
            float* out = p->positions + 3 * p->vertex_count++;
            out[0] = placed.x, out[1] = placed.y, out[2] = placed.z;
        }
    }
    gd_free(&indices);
    gd_free(&vertices);
}

static bool has_triangles(const gd_value* mesh, const gd_value* surface) {
    gd_value class = gd_of_text("ArrayMesh"), is_array_mesh = gd_call(mesh, "is_class", 1, &class);
    bool triangles = true; /* PrimitiveMesh has nothing else */
    if (gd_bool(&is_array_mesh)) {
        gd_value kind = gd_call(mesh, "surface_get_primitive_type", 1, surface);
        triangles = gd_int(&kind) == PRIMITIVE_TRIANGLES;
        gd_free(&kind);
    }
    gd_free(&is_array_mesh);
    gd_free(&class);
    return triangles;
}

bool preparation_has_triangles(const gd_value* mesh) {
    gd_value count = gd_call(mesh, "get_surface_count", 0, NULL);
    bool found = false;
    for (int64_t i = 0; i < gd_int(&count) && !found; i++) {
        gd_value surface = gd_of_int(i);
        found = has_triangles(mesh, &surface);
        gd_free(&surface);
    }
    gd_free(&count);
    return found;
}

void preparation_add_mesh(preparation* p, const gd_value* mesh, const affine* place, uint32_t part) {
    gd_value count = gd_call(mesh, "get_surface_count", 0, NULL);
    for (int64_t i = 0; i < gd_int(&count); i++) {
        gd_value surface = gd_of_int(i);
        if (has_triangles(mesh, &surface)) {
            gd_value arrays = gd_call(mesh, "surface_get_arrays", 1, &surface);
            add_surface(p, &arrays, place, part);
            gd_free(&arrays);
        }
        gd_free(&surface);
    }
    gd_free(&count);
}

void preparation_add_part(preparation* p, uint32_t id, uint32_t parent, int32_t joint_type, char* label,
                          const affine* pivot) {
    if (p->out_of_memory) {
        free(label);
        return;
    }
    dm_pivot* place = &p->pivots[p->part_count];
    dm_part_desc* part = &p->parts[p->part_count++];
    *part = dm_part_desc_default();
    part->id = id, part->parent = parent, part->joint_type = joint_type, part->label = label;
    if (!pivot) return;
    const double none[3] = {0};
    place->origin = affine_point(pivot, none);
    for (int axis = 0; axis < 3; axis++)
        for (int row = 0; row < 3; row++) place->axes[3 * axis + row] = (float)pivot->m[3 * row + axis];
    part->pivot = place;
}

void preparation_add_node(preparation* p, const gd_value* mesh, const affine* place, uint32_t parent, char* name,
                          char* mesh_name, uint32_t flags) {
    if (p->out_of_memory) {
        free(name);
        free(mesh_name);
        return;
    }
    asset_source* node = &p->nodes[p->node_count++];
    *node = (asset_source){.parent = parent ? parent - 1 : DM_ASSET_NO_NODE,
                           .flags = flags,
                           .name = name,
                           .mesh_name = mesh_name,
                           .first_vertex = p->vertex_count,
                           .first_index = p->index_count};
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++) node->transform[4 * column + row] = (float)place->m[3 * row + column];
    for (int row = 0; row < 3; row++) node->transform[12 + row] = (float)place->m[9 + row];
    node->transform[15] = 1;
    const affine own = affine_identity();
    if (gd_object(mesh)) preparation_add_mesh(p, mesh, &own, 0);
    node->vertex_count = p->vertex_count - node->first_vertex;
    node->index_count = p->index_count - node->first_index;
    for (size_t i = node->first_index; i < p->index_count; i++) p->indices[i] -= (uint32_t)node->first_vertex;
}

static int32_t DM_CALL report(void* user, float done) {
    preparation* p = user;
    atomic_store(&p->progress, done);
    return atomic_load(&p->cancelled);
}

static dm_mesh_desc mesh_of(const preparation* p, const asset_source* node) {
    dm_mesh_desc mesh = dm_mesh_desc_default();
    mesh.positions = p->positions + 3 * node->first_vertex, mesh.vertex_count = node->vertex_count;
    mesh.position_bytes = node->vertex_count * 3 * sizeof *p->positions;
    mesh.indices = p->indices + node->first_index, mesh.index_count = node->index_count;
    mesh.index_bytes = node->index_count * sizeof *p->indices;
    return mesh;
}

static dm_result create_asset(preparation* p, dm_asset_node* nodes, dm_mesh_desc* meshes, dm_asset* out) {
    for (uint32_t i = 0; i < p->node_count; i++) {
        const asset_source* from = &p->nodes[i];
        nodes[i] = dm_asset_node_default();
        nodes[i].parent = from->parent, nodes[i].flags = from->flags, nodes[i].follows = DM_ASSET_NO_NODE;
        nodes[i].name = from->name, nodes[i].mesh_name = from->mesh_name, nodes[i].transform = from->transform;
        meshes[i] = mesh_of(p, from);
        if (from->index_count) nodes[i].mesh = &meshes[i];
    }
    dm_asset_desc desc = dm_asset_desc_default();
    desc.nodes = p->node_count ? nodes : NULL, desc.node_count = p->node_count, desc.label = p->label,
    desc.flags = p->asset_flags;
    desc.model = p->model, desc.progress = report, desc.progress_user = p;
    return dm_asset_create(library_context(), &desc, out);
}

/* Turns the answer's indices into ids of parts: a part that stays goes with what carries it. */
static dm_result read_parts_of_nodes(preparation* p, dm_asset asset) {
    dm_result result = dm_asset_get_node_parts(library_context(), asset, p->parts_of_nodes, p->node_count);
    for (uint32_t i = 0; i < p->node_count && result == DM_OK; i++) {
        uint32_t index = p->parts_of_nodes[i];
        p->parts_of_nodes[i] = 0;
        while (index != DM_ASSET_NO_PART && !p->parts_of_nodes[i] && result == DM_OK) {
            dm_asset_part part = dm_asset_part_default();
            result = dm_asset_get_part(library_context(), asset, index, &part);
            p->parts_of_nodes[i] = part.part_id, index = part.parent;
        }
    }
    return result;
}

static dm_result run_asset(preparation* p) {
    dm_asset asset = 0;
    dm_asset_node* nodes = calloc(p->node_count + 1, sizeof *nodes);
    dm_mesh_desc* meshes = calloc(p->node_count + 1, sizeof *meshes);
    dm_result result = nodes && meshes ? create_asset(p, nodes, meshes, &asset) : DM_ERROR_OUT_OF_MEMORY;
    if (result == DM_OK) result = read_parts_of_nodes(p, asset);
    if (result == DM_OK) result = dm_asset_make_object(library_context(), asset, &p->object);
    if (asset) dm_asset_destroy(library_context(), asset);
    free(meshes);
    free(nodes);
    return result;
}

static dm_result run_parts(preparation* p) {
    dm_mesh_desc mesh = dm_mesh_desc_default();
    mesh.positions = p->positions, mesh.vertex_count = p->vertex_count;
    mesh.position_bytes = p->vertex_count * 3 * sizeof *p->positions;
    mesh.indices = p->indices, mesh.index_count = p->index_count,
    mesh.index_bytes = p->index_count * sizeof *p->indices;
    mesh.part_ids = p->face_parts, mesh.part_id_bytes = p->index_count / 3 * sizeof *p->face_parts;
    mesh.part_id_scope = DM_PER_FACE;
    dm_object_desc desc = dm_object_desc_default();
    desc.mesh = &mesh, desc.parts = p->part_count ? p->parts : NULL, desc.part_count = p->part_count;
    desc.model = p->model, desc.progress = report, desc.progress_user = p;
    return dm_object_prepare(library_context(), &desc, &p->object);
}

void preparation_run(preparation* p) {
    p->result = p->out_of_memory ? DM_ERROR_OUT_OF_MEMORY : p->nodes ? run_asset(p) : run_parts(p);
    atomic_store(&p->finished, true);
}

static void run_task(void* data) {
    preparation_run(data);
}

void preparation_start(preparation* p) {
    gd_value pool = gd_singleton("WorkerThreadPool");
    void* description = gd_string_of("dragmesh: find out the joints");
    p->task = gd.worker_thread_pool_add_native_task(gd_object(&pool), run_task, p, false, &description);
    gd_string_free(&description);
    gd_free(&pool);
}
