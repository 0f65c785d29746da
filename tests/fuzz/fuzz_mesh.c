/* Fuzz target: hostile meshes, into dm_object_prepare, dm_mesh_find_part and dm_gltf_write. An input says the host's
 * axes and unit, formats, strides and sizes of the buffers, and then numbers of vertices, corners and part ids; few
 * bytes make a mesh.
 *
 * Whatever the mesh: an error of the header's that leaves outputs untouched, or an object whose numbers are finite, and
 * faces that are 0 or 1, and a file that can be opened. Nothing is read beyond a buffer, nothing is lost; memory may
 * run out at any time. */
#include "dragmesh/ext/gltf.h"
#include "use_object.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

enum { MOST_VERTICES = 64, MOST_FACES = 96, MOST_STRIDE = 40 };
enum { WRITES = 224, MOST_NAME = 8 };       /* even bytes from here on write a file; bytes of a name in it */
enum { UNTOUCHED = 0xa5, FULL_SIZES = 12 }; /* one in FULL_SIZES buffers has another size than the description says */

static fuzz_input in;

/* ---- buffers of exactly the size that is stated, so that a read beyond the end is seen ---- */

typedef struct buffer {
    uint8_t* bytes;
    size_t size;
} buffer;

static buffer make_buffer(size_t elements, size_t stride, size_t element_size) {
    size_t size = elements > 0 ? (elements - 1) * stride + element_size : 0;
    const size_t other = fuzz_one_in(&in, FULL_SIZES) ? size * fuzz_below(&in, 8) / 4 : 0;
    if (other > 0) size = other; /* 0 says that no size is stated */
    return (buffer){calloc(1, size > 0 ? size : 1), size};
}

/* What does not fit is left out. */
static void put(buffer* to, size_t at, const void* bytes, size_t size) {
    if (at + size <= to->size) memcpy(to->bytes + at, bytes, size);
}

/* Round numbers mostly, so that surfaces meet. */
static double coordinate(void) {
    static const double scales[] = {1, 1, 1, 1, 1e-3, 1e3, 1e8, 1e-20, 1e20, 1e36, 1e-38};
    const uint8_t kind = fuzz_byte(&in);
    if (kind < 224) return (double)(kind % 16) / 4 - 2;
    return (double)fuzz_number(&in) * scales[fuzz_below(&in, sizeof scales / sizeof *scales)];
}

static uint32_t stride(uint32_t size) {
    return fuzz_one_in(&in, 6) ? size + fuzz_below(&in, MOST_STRIDE) : fuzz_one_in(&in, 50) ? fuzz_byte(&in) : 0;
}

static buffer make_positions(dm_mesh_desc* mesh) {
    const bool wide = fuzz_one_in(&in, 4);
    const uint32_t size = wide ? 3 * sizeof(double) : 3 * sizeof(float);
    mesh->position_format = wide ? DM_FLOAT64 : DM_FLOAT32;
    mesh->position_stride = stride(size);
    mesh->vertex_count = fuzz_below(&in, MOST_VERTICES + 1);
    const size_t step = mesh->position_stride > 0 ? mesh->position_stride : size;
    buffer out = make_buffer(mesh->vertex_count, step, size);
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        const double xyz[3] = {coordinate(), coordinate(), coordinate()};
        const float narrow[3] = {(float)xyz[0], (float)xyz[1], (float)xyz[2]};
        put(&out, v * step, wide ? (const void*)xyz : (const void*)narrow, size);
    }
    mesh->positions = out.bytes;
    mesh->position_bytes = out.size;
    return out;
}

static size_t integer_bytes(int32_t format) {
    return format == DM_UINT8 ? 1 : format == DM_UINT16 ? 2 : 4;
}

static buffer make_indices(dm_mesh_desc* mesh) {
    const uint32_t limit = mesh->vertex_count > 0 ? (uint32_t)mesh->vertex_count : 1;
    mesh->index_format = (int32_t)fuzz_below(&in, 3);
    mesh->index_count = 3 * fuzz_below(&in, MOST_FACES + 1);
    const size_t size = integer_bytes(mesh->index_format);
    buffer out = make_buffer(mesh->index_count, size, size);
    for (size_t i = 0; i < mesh->index_count; i++) {
        const uint8_t byte = fuzz_byte(&in);
        const uint32_t index = byte < 254 ? byte % limit : byte == 254 ? limit : UINT32_MAX;
        put(&out, i * size, &index, size);
    }
    mesh->indices = out.bytes;
    mesh->index_bytes = out.size;
    return out;
}

static buffer make_part_ids(dm_mesh_desc* mesh) {
    mesh->part_id_format = (int32_t)fuzz_below(&in, 4);
    mesh->part_id_scope = (int32_t)fuzz_below(&in, 2);
    const uint32_t size = (uint32_t)integer_bytes(mesh->part_id_format);
    mesh->part_id_stride = stride(size);
    const size_t step = mesh->part_id_stride > 0 ? mesh->part_id_stride : size;
    const uint64_t faces = (mesh->indices != NULL ? mesh->index_count : mesh->vertex_count) / 3;
    const size_t count = mesh->part_id_scope == DM_PER_FACE ? faces : mesh->vertex_count;
    buffer out = make_buffer(count, step, size);
    for (size_t i = 0; i < count; i++) {
        const uint8_t byte = fuzz_byte(&in);
        const uint32_t id = byte < 250 ? byte % 4u : UINT32_MAX - byte;
        put(&out, i * step, &id, size);
    }
    mesh->part_ids = out.bytes;
    mesh->part_id_bytes = out.size;
    return out;
}

/* ---- calls ---- */

static void check_error(dm_result result) {
    fuzz_expect_result(result);
    fuzz_expect(result != DM_ERROR_STALE_HANDLE && result != DM_ERROR_NO_MODEL && result != DM_ERROR_BAD_DATA);
}

static dm_drag_hint any_hint(void) {
    return (dm_drag_hint){fuzz_vector(&in), fuzz_vector(&in)};
}

static void prepare(dm_context* context, fuzz_host* host, const dm_mesh_desc* mesh) {
    const dm_drag_hint hint = any_hint();
    const dm_pivot pivot = {.origin = fuzz_vector(&in), .axes = {fuzz_number(&in), 0, 0, 0, 1, 0, 0, 0, 1}};
    const dm_part_desc parts[2] = {{.struct_size = sizeof *parts, .id = 1, .drag = &hint, .label = "cabinet/door"},
                                   {.struct_size = sizeof *parts, .id = 2, .parent = 1, .pivot = &pivot}};
    dm_object_desc desc = {.struct_size = sizeof desc,
                           .flags = fuzz_below(&in, 2),
                           .mesh = mesh,
                           .seed = fuzz_byte(&in),
                           .up = {0, fuzz_one_in(&in, 8) ? fuzz_number(&in) : 0, 0},
                           .progress = fuzz_progress,
                           .progress_user = host};
    if (fuzz_one_in(&in, 2)) desc.parts = parts, desc.part_count = 1 + fuzz_below(&in, 2);
    dm_object object, untouched;
    memset(&object, UNTOUCHED, sizeof object);
    untouched = object;
    const dm_result result = dm_object_prepare(context, &desc, &object);
    host->refuse_in = 0;
    if (result != DM_OK) {
        check_error(result);
        fuzz_expect(object == untouched);
        return;
    }
    use_object(context, object);
    fuzz_expect(dm_object_destroy(context, object) == DM_OK);
}

static void find_part(dm_context* context, fuzz_host* host, const dm_mesh_desc* mesh) {
    const dm_drag_hint hint = any_hint();
    const uint64_t count = (mesh->indices != NULL ? mesh->index_count : mesh->vertex_count) / 3;
    uint8_t* faces = malloc(count > 0 ? count : 1);
    fuzz_expect(faces != NULL);
    memset(faces, UNTOUCHED, count);
    const dm_result result = dm_mesh_find_part(context, mesh, &hint, faces, count);
    host->refuse_in = 0;
    if (result != DM_OK) check_error(result);
    for (uint64_t i = 0; i < count; i++) fuzz_expect(result == DM_OK ? faces[i] <= 1 : faces[i] == UNTOUCHED);
    free(faces);
}

static void open_again(const void* data, size_t size) {
    const dm_gltf_desc desc = {.struct_size = sizeof desc, .data = data, .size = size};
    dm_gltf* gltf;
    fuzz_expect(dm_gltf_open(&desc, &gltf) == DM_OK);
    dm_gltf_close(gltf);
}

/* A mesh that has no stride: as an exporter hands it over. */
static void write_file(fuzz_host* host, const dm_mesh_desc* mesh) {
    char name[MOST_NAME + 1] = {0};
    for (int i = 0; i < MOST_NAME; i++) name[i] = (char)fuzz_byte(&in);
    const dm_gltf_part part = {.name = name,
                               .positions = mesh->positions,
                               .indices = mesh->indices,
                               .vertex_count = mesh->position_bytes / sizeof(dm_vec3),
                               .index_count = mesh->index_bytes / sizeof(uint32_t),
                               .colour = {fuzz_number(&in), fuzz_number(&in), fuzz_number(&in), fuzz_number(&in)}};
    const dm_allocator allocator = {host, fuzz_allocate, fuzz_release};
    const dm_log log = {host, fuzz_message};
    void* data = NULL;
    size_t size = 0;
    const dm_result result = dm_gltf_write(&part, 1, &allocator, &log, &data, &size);
    host->refuse_in = 0;
    if (result == DM_OK)
        open_again(data, size);
    else
        check_error(result);
    fuzz_expect((data != NULL) == (result == DM_OK));
    if (data != NULL) fuzz_release(host, data, size);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (contexts[0] == NULL) open_contexts();
    in = (fuzz_input){data, size};
    const uint32_t which = fuzz_below(&in, HOSTS);
    fuzz_host* host = &hosts[which];
    host->in = &in;
    dm_mesh_desc mesh = {.struct_size = sizeof mesh};
    buffer positions = make_positions(&mesh), indices = {NULL, 0}, part_ids = {NULL, 0};
    if (!fuzz_one_in(&in, 6)) indices = make_indices(&mesh);
    if (!fuzz_one_in(&in, 6)) part_ids = make_part_ids(&mesh);
    if (fuzz_one_in(&in, 10)) host->refuse_in = 1u + fuzz_byte(&in);
    const uint8_t call = fuzz_byte(&in);
    if (call % 2 == 1)
        prepare(contexts[which], host, &mesh);
    else if (call >= WRITES)
        write_file(host, &mesh);
    else
        find_part(contexts[which], host, &mesh);
    free(positions.bytes);
    free(indices.bytes);
    free(part_ids.bytes);
    fuzz_expect(host->live <= CONTEXT_BLOCKS);
    return 0;
}
