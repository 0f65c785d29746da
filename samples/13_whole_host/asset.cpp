/* Reads a .glb by tinygltf. The C++ of the sample ends here: no exception leaves this file. */
#include "asset.h"

#include <cglm/cglm.h>
#include <tiny_gltf.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct arrays {
    std::vector<float> positions;
    std::vector<uint32_t> indices, part_ids;
    std::vector<std::string> names{"(nothing)"}; /* of the parts; the body's is put in where there is one */
    std::vector<const char*> name_pointers;
};

struct reader {
    tinygltf::Model file;
    std::string body;
    arrays* out;
};

void require(bool holds, const char* what) {
    if (!holds) throw std::runtime_error(what);
}

/* Copies element i of an accessor, `size` bytes. */
void read_element(const tinygltf::Model& file, const tinygltf::Accessor& accessor, size_t i, void* out, size_t size) {
    require(accessor.bufferView >= 0 && !accessor.sparse.isSparse, "an accessor is sparse or compressed");
    const tinygltf::BufferView& view = file.bufferViews.at(size_t(accessor.bufferView));
    require(view.extensions.empty(), "a buffer is compressed");
    const std::vector<unsigned char>& bytes = file.buffers.at(size_t(view.buffer)).data;
    const size_t at = view.byteOffset + accessor.byteOffset + i * size_t(accessor.ByteStride(view));
    require(at <= bytes.size() && size <= bytes.size() - at, "an accessor ends beyond its buffer");
    memcpy(out, bytes.data() + at, size);
}

/* Returns a corner of one, two or four bytes. */
uint32_t read_index(const tinygltf::Model& file, const tinygltf::Accessor& accessor, size_t i) {
    uint32_t value = 0; /* little-endian, as the file and every machine that this runs on */
    const size_t size = size_t(tinygltf::GetComponentSizeInBytes(uint32_t(accessor.componentType)));
    require(size <= sizeof value, "an index is no integer");
    read_element(file, accessor, i, &value, size);
    return value;
}

void read_primitive(const reader& from, const tinygltf::Primitive& primitive, mat4 to_scene, uint32_t part) {
    require(primitive.mode == TINYGLTF_MODE_TRIANGLES, "a primitive is not made of triangles");
    const tinygltf::Accessor& points = from.file.accessors.at(size_t(primitive.attributes.at("POSITION")));
    require(points.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT, "positions are not floats");
    const uint32_t first = uint32_t(from.out->part_ids.size());
    for (size_t i = 0; i < points.count; i++) {
        vec3 point;
        read_element(from.file, points, i, point, sizeof point);
        glm_mat4_mulv3(to_scene, point, 1, point);
        from.out->positions.insert(from.out->positions.end(), point, point + 3);
        from.out->part_ids.push_back(part);
    }
    if (primitive.indices < 0) {
        for (uint32_t i = 0; i < points.count; i++) from.out->indices.push_back(first + i);
        return;
    }
    const tinygltf::Accessor& corners = from.file.accessors.at(size_t(primitive.indices));
    for (size_t i = 0; i < corners.count; i++) from.out->indices.push_back(first + read_index(from.file, corners, i));
}

/* Either a matrix, or translation, rotation and scale. */
void place(const tinygltf::Node& node, mat4 out) {
    glm_mat4_identity(out);
    for (size_t i = 0; i < node.matrix.size(); i++) out[i / 4][i % 4] = float(node.matrix[i]);
    vec3 translation = {0, 0, 0}, scale = {1, 1, 1};
    versor rotation = {0, 0, 0, 1};
    for (size_t i = 0; i < node.translation.size(); i++) translation[i] = float(node.translation[i]);
    for (size_t i = 0; i < node.rotation.size(); i++) rotation[i] = float(node.rotation[i]);
    for (size_t i = 0; i < node.scale.size(); i++) scale[i] = float(node.scale[i]);
    glm_translate(out, translation);
    glm_quat_rotate(out, rotation, out);
    glm_scale(out, scale);
}

void read_node(const reader& from, int index, mat4 parent, uint32_t part) {
    const tinygltf::Node& node = from.file.nodes.at(size_t(index));
    mat4 local, to_scene;
    place(node, local);
    glm_mat4_mul(parent, local, to_scene);
    if (node.mesh >= 0 && node.name == from.body) {
        from.out->names[0] = node.name;
    } else if (node.mesh >= 0 && part == 0) {
        part = uint32_t(from.out->names.size());
        from.out->names.push_back(node.name);
    }
    for (size_t i = 0; node.mesh >= 0 && i < from.file.meshes.at(size_t(node.mesh)).primitives.size(); i++)
        read_primitive(from, from.file.meshes[size_t(node.mesh)].primitives[i], to_scene, part);
    for (int child : node.children) read_node(from, child, to_scene, part);
}

/* Pictures are not needed: tinygltf is told that each was read. */
bool skip_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
    return true;
}

void read_file(reader& from, const char* path) {
    tinygltf::TinyGLTF tinygltf;
    std::string error, warning;
    tinygltf.SetImageLoader(skip_image, nullptr);
    if (!tinygltf.LoadBinaryFromFile(&from.file, &error, &warning, path)) throw std::runtime_error(error);
    mat4 identity = GLM_MAT4_IDENTITY_INIT;
    for (int root : from.file.scenes.at(size_t(from.file.defaultScene > 0 ? from.file.defaultScene : 0)).nodes)
        read_node(from, root, identity, 0);
}

} // namespace

bool asset_read(const char* path, const char* body, asset* out) {
    arrays* read = nullptr;
    try {
        read = new arrays;
        reader from = {{}, body, read};
        read_file(from, path);
        for (const std::string& name : read->names) read->name_pointers.push_back(name.c_str());
        *out = {read->positions.data(), read->indices.data(),       read->part_ids.data(),        read->part_ids.size(),
                read->indices.size(),   read->name_pointers.data(), uint32_t(read->names.size()), read};
        return true;
    } catch (const std::exception& problem) {
        fprintf(stderr, "%s: %s\n", path, problem.what());
        delete read;
        return false;
    }
}

void asset_free(asset* asset) {
    delete static_cast<arrays*>(asset->storage);
    *asset = {};
}
