/* Triangles, names and transforms of a glTF file by tinygltf alone: in doubles, and with none of the project's code. */
#include "tinygltf_scene.h"

#include <tiny_gltf.h>

#include <array>
#include <cstring>
#include <limits>
#include <list>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using matrix = std::array<double, 16>;
using point = std::array<double, 3>;

struct storage {
    tinygltf::Model file;
    std::list<std::vector<double>> corners;
    std::map<int, tinygltf_node> by_index;
    std::vector<tinygltf_node> nodes;
};

matrix multiply(const matrix& a, const matrix& b) {
    matrix out{};
    for (size_t column = 0; column < 4; column++)
        for (size_t row = 0; row < 4; row++)
            for (size_t k = 0; k < 4; k++) out[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    return out;
}

matrix local_matrix(const tinygltf::Node& node) {
    matrix out{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    if (node.matrix.size() == 16) {
        std::copy(node.matrix.begin(), node.matrix.end(), out.begin());
        return out;
    }
    const std::vector<double> r = node.rotation.size() == 4 ? node.rotation : std::vector<double>{0, 0, 0, 1};
    const std::vector<double> s = node.scale.size() == 3 ? node.scale : std::vector<double>{1, 1, 1};
    const double x = r[0], y = r[1], z = r[2], w = r[3];
    const double turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
                               {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
                               {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
    for (size_t column = 0; column < 3; column++)
        for (size_t row = 0; row < 3; row++) out[4 * column + row] = turn[column][row] * s[column];
    for (size_t row = 0; row < node.translation.size(); row++) out[12 + row] = node.translation[row];
    return out;
}

/* Returns number k of element i, normalised where the accessor says so. */
double number(const tinygltf::Model& file, const tinygltf::Accessor& accessor, size_t i, size_t k) {
    if (accessor.bufferView < 0 || accessor.sparse.isSparse) throw std::runtime_error("no plain accessor");
    const tinygltf::BufferView& view = file.bufferViews.at(size_t(accessor.bufferView));
    const std::vector<unsigned char>& bytes = file.buffers.at(size_t(view.buffer)).data;
    const size_t size = size_t(tinygltf::GetComponentSizeInBytes(uint32_t(accessor.componentType)));
    const size_t at = view.byteOffset + accessor.byteOffset + i * size_t(accessor.ByteStride(view)) + k * size;
    const bool is_signed = accessor.componentType == TINYGLTF_COMPONENT_TYPE_BYTE ||
                           accessor.componentType == TINYGLTF_COMPONENT_TYPE_SHORT;
    if (is_signed) throw std::runtime_error("numbers with a sign are not compared");
    if (size > 4 || at + size > bytes.size()) throw std::runtime_error("an accessor ends beyond its buffer");
    if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) {
        float value;
        memcpy(&value, &bytes[at], sizeof value);
        return double(value);
    }
    uint32_t value = 0;
    memcpy(&value, &bytes[at], size);
    return accessor.normalized ? value / double((uint64_t(1) << 8 * size) - 1) : value;
}

point corner(const tinygltf::Model& file, const tinygltf::Accessor& positions, size_t vertex, const matrix& to_scene) {
    point out{};
    for (size_t row = 0; row < 3; row++) {
        out[row] = to_scene[12 + row];
        for (size_t k = 0; k < 3; k++) out[row] += to_scene[4 * k + row] * number(file, positions, vertex, k);
    }
    return out;
}

void read_primitive(const tinygltf::Model& file, const tinygltf::Primitive& primitive, const matrix& to_scene,
                    std::vector<double>& out) {
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES) throw std::runtime_error("a primitive is not made of triangles");
    const tinygltf::Accessor& positions = file.accessors.at(size_t(primitive.attributes.at("POSITION")));
    const tinygltf::Accessor* indices = primitive.indices < 0 ? nullptr : &file.accessors.at(size_t(primitive.indices));
    for (size_t i = 0; i < (indices ? indices->count : positions.count); i++) {
        const size_t vertex = indices ? size_t(number(file, *indices, i, 0)) : i;
        const point at = corner(file, positions, vertex, to_scene);
        out.insert(out.end(), at.begin(), at.end());
    }
}

void read_node(storage& from, int index, const matrix& parent) {
    const tinygltf::Node& node = from.file.nodes.at(size_t(index));
    const matrix to_scene = multiply(parent, local_matrix(node));
    if (node.mesh >= 0) {
        from.corners.emplace_back();
        std::vector<double>& corners = from.corners.back();
        for (const auto& primitive : from.file.meshes.at(size_t(node.mesh)).primitives)
            read_primitive(from.file, primitive, to_scene, corners);
        tinygltf_node& out = from.by_index[index];
        out = {node.name.c_str(), uint32_t(index), {}, corners.data(), corners.size() / 3};
        std::copy(to_scene.begin(), to_scene.end(), out.to_scene);
    }
    for (int child : node.children) read_node(from, child, to_scene);
}

/* Nodes that no other node has below it: the scene, where the file names none. */
std::vector<int> roots(const tinygltf::Model& file) {
    if (!file.scenes.empty()) return file.scenes.at(size_t(file.defaultScene < 0 ? 0 : file.defaultScene)).nodes;
    std::vector<bool> is_child(file.nodes.size());
    for (const auto& node : file.nodes)
        for (int child : node.children) is_child.at(size_t(child)) = true;
    std::vector<int> out;
    for (size_t i = 0; i < file.nodes.size(); i++)
        if (!is_child[i]) out.push_back(int(i));
    return out;
}

bool skip_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
    return true;
}

void read_file(const std::string& path, storage& out) {
    tinygltf::TinyGLTF tinygltf;
    std::string error, warning;
    tinygltf.SetImageLoader(skip_image, nullptr);
    const bool is_binary = path.size() > 4 && path.substr(path.size() - 4) == ".glb";
    if (!(is_binary ? tinygltf.LoadBinaryFromFile(&out.file, &error, &warning, path)
                    : tinygltf.LoadASCIIFromFile(&out.file, &error, &warning, path)))
        throw std::runtime_error(error);
    for (int root : roots(out.file)) read_node(out, root, local_matrix(tinygltf::Node()));
    for (const auto& node : out.by_index) out.nodes.push_back(node.second);
}

} // namespace

const char* tinygltf_scene_read(const char* path, tinygltf_scene* out) {
    static std::string problem;
    storage* read = new storage;
    try {
        read_file(path, *read);
        *out = {read->nodes.data(), uint32_t(read->nodes.size()), read};
        return nullptr;
    } catch (const std::exception& e) {
        delete read;
        problem = e.what();
        return problem.c_str();
    }
}

void tinygltf_scene_free(tinygltf_scene* scene) {
    delete static_cast<storage*>(scene->storage);
    *scene = {};
}
