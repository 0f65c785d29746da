// Draco's decoder behind gltf_draco.h: the one file of C++. Exceptions stop in `guarded`.
#include "gltf/gltf_draco.h"

#include <cstdio>
#include <memory>
#include <new>

#include "base/compiler.h"

#if defined(DMI_NO_DRACO)

struct dmi_draco {};

int dmi_draco_available(void) {
    return 0;
}

dm_result dmi_draco_open(const void*, size_t, uint32_t, uint32_t, char* reason, size_t reason_size, dmi_draco**) {
    std::snprintf(reason, reason_size, "this build lacks Draco");
    return DM_ERROR_UNSUPPORTED;
}

void dmi_draco_close(dmi_draco*) {
}

uint32_t dmi_draco_points(const dmi_draco*) {
    return 0;
}

uint32_t dmi_draco_faces(const dmi_draco*) {
    return 0;
}

void dmi_draco_read_faces(const dmi_draco*, uint32_t*) {
}

uint32_t dmi_draco_components(const dmi_draco*, uint32_t) {
    return 0;
}

int dmi_draco_read(const dmi_draco*, uint32_t, int, void*) {
    return 0;
}

#else

DMI_FOREIGN_HEADERS_BEGIN
#include <draco/compression/decode.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
DMI_FOREIGN_HEADERS_END

struct dmi_draco {
    std::unique_ptr<draco::Mesh> mesh;
};

namespace {

constexpr int OLDEST_MAJOR = 2, OLDEST_MINOR = 2; // bitstream of KHR_draco_mesh_compression
enum { SEQUENTIAL = 0, EDGEBREAKER = 1, MESH = 1, FLAG_METADATA = 0x8000 };

// Runs `body` and turns what it throws into a result.
template <typename Body> dm_result guarded(char* reason, size_t size, Body body) noexcept {
    try {
        return body();
    } catch (const std::bad_alloc&) {
        std::snprintf(reason, size, "no memory");
        return DM_ERROR_OUT_OF_MEMORY;
    } catch (...) {
        std::snprintf(reason, size, "a C++ exception");
        return DM_ERROR_BAD_DATA;
    }
}

bool read_count(draco::DecoderBuffer& buffer, uint32_t most) {
    uint32_t count = 0;
    return draco::DecodeVarint(&count, &buffer) && count <= most;
}

bool skip_metadata(draco::DecoderBuffer& buffer) {
    draco::GeometryMetadata skipped;
    return draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &skipped);
}

// Reads what the stream claims to hold, before the decoder takes memory for it.
const char* check_claims(const char* data, size_t size, uint32_t most_points, uint32_t most_faces) {
    draco::DecoderBuffer buffer;
    buffer.Init(data, size);
    char magic[5];
    uint8_t major, minor, kind, method, traversal;
    uint16_t flags;
    if (!buffer.Decode(magic, sizeof magic) || std::memcmp(magic, "DRACO", sizeof magic) != 0) return "no Draco stream";
    if (!buffer.Decode(&major) || !buffer.Decode(&minor) || !buffer.Decode(&kind) || !buffer.Decode(&method) ||
        !buffer.Decode(&flags))
        return "a truncated Draco header";
    if (kind != MESH) return "a Draco point cloud";
    if (major != OLDEST_MAJOR || minor < OLDEST_MINOR) return "a Draco bitstream of another version than 2.2";
    buffer.set_bitstream_version(static_cast<uint16_t>(major << 8 | minor));
    if ((flags & FLAG_METADATA) && !skip_metadata(buffer)) return "broken Draco metadata";
    if (method == SEQUENTIAL)
        return read_count(buffer, most_faces) && read_count(buffer, most_points) ? nullptr : "more than glTF says";
    if (method != EDGEBREAKER || !buffer.Decode(&traversal)) return "an unknown Draco method";
    return read_count(buffer, most_points) && read_count(buffer, most_faces) ? nullptr : "more than glTF says";
}

// Draco has 64 bits and bool besides. A stream's bool may have any byte, and reading it as one is undefined.
bool is_gltf_type(draco::DataType type) {
    return (type >= draco::DT_INT8 && type <= draco::DT_UINT32) || type == draco::DT_FLOAT32;
}

// Returns NULL for an attribute that is not there, and for one of a type that glTF has not.
const draco::PointAttribute* find(const dmi_draco* mesh, uint32_t id) {
    const draco::PointAttribute* found = mesh->mesh->GetAttributeByUniqueId(id);
    return found && is_gltf_type(found->data_type()) ? found : nullptr;
}

template <typename T> bool read_values(const draco::Mesh& mesh, const draco::PointAttribute& from, void* out) {
    T* to = static_cast<T*>(out);
    const int8_t components = static_cast<int8_t>(from.num_components());
    for (uint32_t i = 0; i < mesh.num_points(); i++, to += components) {
        if (!from.ConvertValue<T>(from.mapped_index(draco::PointIndex(i)), components, to)) return false;
    }
    return true;
}

} // namespace

int dmi_draco_available(void) {
    return 1;
}

dm_result dmi_draco_open(const void* data, size_t size, uint32_t most_points, uint32_t most_faces, char* reason,
                         size_t reason_size, dmi_draco** out) {
    return guarded(reason, reason_size, [&]() -> dm_result {
        const char* bytes = static_cast<const char*>(data);
        const char* wrong = check_claims(bytes, size, most_points, most_faces);
        std::snprintf(reason, reason_size, "%s", wrong ? wrong : "");
        if (wrong) return DM_ERROR_BAD_DATA;
        draco::DecoderBuffer buffer;
        buffer.Init(bytes, size);
        draco::Decoder decoder;
        auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
        std::snprintf(reason, reason_size, "%s", decoded.ok() ? "more than glTF says" : decoded.status().error_msg());
        if (!decoded.ok()) return DM_ERROR_BAD_DATA;
        std::unique_ptr<dmi_draco> mesh(new dmi_draco{std::move(decoded).value()});
        if (mesh->mesh->num_points() > most_points || mesh->mesh->num_faces() > most_faces) return DM_ERROR_BAD_DATA;
        *out = mesh.release();
        return DM_OK;
    });
}

void dmi_draco_close(dmi_draco* mesh) {
    delete mesh;
}

uint32_t dmi_draco_points(const dmi_draco* mesh) {
    return mesh->mesh->num_points();
}

uint32_t dmi_draco_faces(const dmi_draco* mesh) {
    return mesh->mesh->num_faces();
}

void dmi_draco_read_faces(const dmi_draco* mesh, uint32_t* out) {
    for (uint32_t i = 0; i < mesh->mesh->num_faces(); i++) {
        const draco::Mesh::Face& face = mesh->mesh->face(draco::FaceIndex(i));
        for (size_t k = 0; k < 3; k++) *out++ = face[k].value();
    }
}

uint32_t dmi_draco_components(const dmi_draco* mesh, uint32_t id) {
    const draco::PointAttribute* found = find(mesh, id);
    return found ? static_cast<uint32_t>(found->num_components()) : 0;
}

int dmi_draco_read(const dmi_draco* mesh, uint32_t id, int type, void* out) {
    const draco::PointAttribute* from = find(mesh, id);
    if (!from) return 0;
    switch (type) {
    case 5120:
        return read_values<int8_t>(*mesh->mesh, *from, out);
    case 5121:
        return read_values<uint8_t>(*mesh->mesh, *from, out);
    case 5122:
        return read_values<int16_t>(*mesh->mesh, *from, out);
    case 5123:
        return read_values<uint16_t>(*mesh->mesh, *from, out);
    case 5125:
        return read_values<uint32_t>(*mesh->mesh, *from, out);
    case 5126:
        return read_values<float>(*mesh->mesh, *from, out);
    default:
        return 0;
    }
}

#endif
