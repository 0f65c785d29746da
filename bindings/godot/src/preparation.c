#include "preparation.h"

#include <stdlib.h>

#include "library.h"

enum { ARRAY_VERTEX = 0, ARRAY_INDEX = 12, PRIMITIVE_TRIANGLES = 3 }; /* Mesh.ArrayType, Mesh.PrimitiveType */
enum { LEAST_CAPACITY = 1024 };

preparation* preparation_new(uint32_t parts) {
    preparation* p = calloc(1, sizeof *p);
    if (!p) return NULL;
    p->task = -1;
    p->parts = calloc(parts + 1, sizeof *p->parts);
    p->pivots = calloc(parts + 1, sizeof *p->pivots);
    p->out_of_memory = !p->parts || !p->pivots;
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

static int32_t DM_CALL report(void* user, float done) {
    preparation* p = user;
    atomic_store(&p->progress, done);
    return atomic_load(&p->cancelled);
}

void preparation_run(preparation* p) {
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
    p->result = p->out_of_memory ? DM_ERROR_OUT_OF_MEMORY : dm_object_prepare(library_context(), &desc, &p->object);
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
