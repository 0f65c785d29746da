// tinygltf behind gltf_tiny.h: a glTF document read, edited and written. Exceptions stop in `guarded` and `edit`.
#include "mesh/gltf/gltf_tiny.h"

#include <cstdio>
#include <cstring>
#include <new>
#include <sstream>

// Debian's library decodes images with stb; here they only pass through, so neither its reader nor its writer is named.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_FS
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wpedantic"
#endif
#include <tiny_gltf.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

struct dmi_tiny {
    tinygltf::Model model;
    std::string written;
    dm_result failure = DM_OK;
};

namespace {

void say(char* message, size_t size, const char* text) {
    if (message && size > 0) {
        std::snprintf(message, size, "%s", text);
        for (char* c = message; *c; c++) {
            if (*c == '\n') *c = ' ';
        }
    }
}

// Runs `body` and turns what it throws into a result.
template <typename Body> dm_result guarded(char* message, size_t size, Body body) {
    try {
        return body();
    } catch (const std::bad_alloc&) {
        say(message, size, "no memory");
        return DM_ERROR_OUT_OF_MEMORY;
    } catch (const std::exception& error) {
        say(message, size, error.what());
        return DM_ERROR_BAD_DATA;
    } catch (...) {
        say(message, size, "an unknown C++ exception");
        return DM_ERROR_INTERNAL;
    }
}

// Runs an edit that answers an index, unless an earlier one failed.
template <typename Body> int32_t edit(dmi_tiny* tiny, Body body) {
    if (tiny->failure != DM_OK) return -1;
    int32_t index = -1;
    tiny->failure = guarded(nullptr, 0, [&] {
        index = static_cast<int32_t>(body(tiny->model));
        return DM_OK;
    });
    return tiny->failure == DM_OK ? index : -1;
}

template <typename List> bool inside(const List& list, int64_t index) {
    return index >= 0 && static_cast<uint64_t>(index) < list.size();
}

template <typename List> int last(const List& list) {
    return static_cast<int>(list.size()) - 1;
}

bool keep_image_bytes(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                      int size, void*) {
    // An image in a view stays there (and its range is not checked yet); one from a data URI has no other home.
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

// Gives back what the file says. Counts and offsets of sparse accessors are int, or size_t (offsets since 2.9); an int
// is negative for 2^31 and more, and dmi_gltf_check_container lets nothing of 2^32 or more through.
uint64_t widen(int number) {
    return static_cast<uint32_t>(number);
}

[[maybe_unused]] uint64_t widen(size_t number) {
    return number;
}

// Sets the callback that only tinygltf 2.9 and later has; it takes none of them unless all are there.
template <typename Callbacks> auto refuse_sizes(Callbacks& callbacks, int) -> decltype(callbacks.GetFileSizeInBytes)* {
    callbacks.GetFileSizeInBytes = [](size_t*, std::string*, const std::string&, void*) { return false; };
    return nullptr;
}

template <typename Callbacks> void refuse_sizes(Callbacks&, ...) {
}

tinygltf::FsCallbacks no_files() {
    tinygltf::FsCallbacks callbacks = {};
    callbacks.FileExists = [](const std::string&, void*) { return false; };
    callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>*, std::string*, const std::string&, void*) {
        return false;
    };
    callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
        return false;
    };
    refuse_sizes(callbacks, 0);
    return callbacks;
}

// Column-major matrix of translation, rotation, scale (glTF 2.0 §5.25).
void compose(const tinygltf::Node& node, double out[16]) {
    double q[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1}, t[3] = {0, 0, 0};
    if (node.rotation.size() == 4) std::copy(node.rotation.begin(), node.rotation.end(), q);
    if (node.scale.size() == 3) std::copy(node.scale.begin(), node.scale.end(), s);
    if (node.translation.size() == 3) std::copy(node.translation.begin(), node.translation.end(), t);
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& component : q) component = length > 0 ? component / length : (&component == &q[3] ? 1.0 : 0.0);
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double r[9] = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z),     2 * (x * z - w * y),
                         2 * (x * y - w * z),     1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
                         2 * (x * z + w * y),     2 * (y * z - w * x),     1 - 2 * (x * x + y * y)};
    for (int column = 0; column < 3; column++) {
        for (int row = 0; row < 3; row++) out[4 * column + row] = r[3 * column + row] * s[column];
        out[4 * column + 3] = 0;
        out[12 + column] = t[column];
    }
    out[15] = 1;
}

// Appends to the embedded buffer on a 4-byte boundary; answers the offset.
size_t append(tinygltf::Model& model, const void* data, size_t size) {
    if (model.buffers.empty()) model.buffers.emplace_back();
    std::vector<unsigned char>& bytes = model.buffers[0].data;
    bytes.resize((bytes.size() + 3) & ~static_cast<size_t>(3));
    const size_t offset = bytes.size();
    const unsigned char* first = static_cast<const unsigned char*>(data);
    bytes.insert(bytes.end(), first, first + size);
    return offset;
}

int add_view(tinygltf::Model& model, const void* data, size_t size, int target) {
    tinygltf::BufferView view;
    view.byteOffset = append(model, data, size);
    view.byteLength = size;
    view.buffer = 0;
    view.target = target;
    model.bufferViews.push_back(std::move(view));
    return last(model.bufferViews);
}

int tinygltf_type(int components) {
    return components == 1 ? TINYGLTF_TYPE_SCALAR : components == 3 ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_VEC4;
}

} // namespace

extern "C" {

dm_result dmi_tiny_parse(const void* data, size_t size, int binary, dmi_tiny** out_tiny, char* message,
                         size_t message_size) {
    dmi_tiny* tiny = dmi_tiny_new();
    if (!tiny) return DM_ERROR_OUT_OF_MEMORY;
    const dm_result result = guarded(message, message_size, [&] {
        tinygltf::TinyGLTF loader;
        loader.SetImageLoader(keep_image_bytes, nullptr);
        loader.SetFsCallbacks(no_files());
        std::string error, warning;
        const unsigned length = static_cast<unsigned>(size);
        tiny->model = tinygltf::Model();
        const bool read = binary ? loader.LoadBinaryFromMemory(&tiny->model, &error, &warning,
                                                               static_cast<const unsigned char*>(data), length)
                                 : loader.LoadASCIIFromString(&tiny->model, &error, &warning,
                                                              static_cast<const char*>(data), length, "");
        if (read) return static_cast<dm_result>(DM_OK);
        say(message, message_size, error.empty() ? "unreadable" : error.c_str());
        return static_cast<dm_result>(DM_ERROR_BAD_DATA);
    });
    if (result == DM_OK)
        *out_tiny = tiny;
    else
        dmi_tiny_free(tiny);
    return result;
}

dmi_tiny* dmi_tiny_new(void) {
    try {
        dmi_tiny* tiny = new dmi_tiny;
        tiny->model.asset.version = "2.0";
        tiny->model.asset.generator = "dragmesh";
        tiny->model.scenes.emplace_back();
        tiny->model.defaultScene = 0;
        return tiny;
    } catch (...) {
        return nullptr;
    }
}

dmi_tiny* dmi_tiny_clone(const dmi_tiny* tiny) {
    try {
        return new dmi_tiny(*tiny);
    } catch (...) {
        return nullptr;
    }
}

void dmi_tiny_free(dmi_tiny* tiny) {
    delete tiny;
}

uint32_t dmi_tiny_node_count(const dmi_tiny* tiny) {
    return static_cast<uint32_t>(tiny->model.nodes.size());
}

int dmi_tiny_get_view(const dmi_tiny* tiny, int32_t index, dmi_tiny_view* out) {
    if (!inside(tiny->model.bufferViews, index)) return 0;
    const tinygltf::BufferView& view = tiny->model.bufferViews[static_cast<size_t>(index)];
    if (!inside(tiny->model.buffers, view.buffer)) return 0;
    const std::vector<unsigned char>& bytes = tiny->model.buffers[static_cast<size_t>(view.buffer)].data;
    *out = {bytes.data(), bytes.size(), view.byteOffset, view.byteLength, view.byteStride};
    return 1;
}

int dmi_tiny_get_accessor(const dmi_tiny* tiny, int32_t index, dmi_tiny_accessor* out) {
    if (!inside(tiny->model.accessors, index)) return 0;
    const tinygltf::Accessor& from = tiny->model.accessors[static_cast<size_t>(index)];
    *out = {};
    out->view = from.bufferView;
    out->component_type = from.componentType;
    out->components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(from.type));
    out->normalized = from.normalized;
    out->offset = from.byteOffset;
    out->count = from.count;
    out->sparse = from.sparse.isSparse;
    if (!out->sparse) return 1;
    out->sparse_count = widen(from.sparse.count);
    out->index_view = from.sparse.indices.bufferView;
    out->index_offset = widen(from.sparse.indices.byteOffset);
    out->index_type = from.sparse.indices.componentType;
    out->value_view = from.sparse.values.bufferView;
    out->value_offset = widen(from.sparse.values.byteOffset);
    return 1;
}

int dmi_tiny_get_node(const dmi_tiny* tiny, uint32_t index, dmi_tiny_node* out) {
    if (!inside(tiny->model.nodes, index)) return 0;
    const tinygltf::Node& node = tiny->model.nodes[index];
    out->name = node.name.c_str();
    out->mesh = node.mesh;
    out->skin = node.skin;
    out->children = node.children.data();
    out->child_count = static_cast<uint32_t>(node.children.size());
    out->instanced = node.extensions.count("EXT_mesh_gpu_instancing") != 0;
    if (node.matrix.size() == 16)
        std::copy(node.matrix.begin(), node.matrix.end(), out->matrix);
    else
        compose(node, out->matrix);
    return 1;
}

int dmi_tiny_has_mesh(const dmi_tiny* tiny, int32_t index) {
    return inside(tiny->model.meshes, index);
}

uint32_t dmi_tiny_primitive_count(const dmi_tiny* tiny, int32_t mesh) {
    if (!inside(tiny->model.meshes, mesh)) return 0;
    return static_cast<uint32_t>(tiny->model.meshes[static_cast<size_t>(mesh)].primitives.size());
}

int dmi_tiny_get_primitive(const dmi_tiny* tiny, int32_t mesh, uint32_t index, dmi_tiny_primitive* out) {
    if (index >= dmi_tiny_primitive_count(tiny, mesh)) return 0;
    const tinygltf::Primitive& from = tiny->model.meshes[static_cast<size_t>(mesh)].primitives[index];
    const auto positions = from.attributes.find("POSITION");
    out->mode = from.mode < 0 ? DMI_TINY_TRIANGLES : from.mode;
    out->positions = positions == from.attributes.end() ? -1 : positions->second;
    out->indices = from.indices;
    out->material = from.material;
    out->compressed = from.extensions.count("KHR_draco_mesh_compression") != 0;
    out->morphs = !from.targets.empty();
    return 1;
}

void dmi_tiny_get_colour(const dmi_tiny* tiny, int32_t material, float out[4]) {
    for (int i = 0; i < 4; i++) out[i] = 1;
    if (!inside(tiny->model.materials, material)) return;
    const std::vector<double>& colour =
        tiny->model.materials[static_cast<size_t>(material)].pbrMetallicRoughness.baseColorFactor;
    for (size_t i = 0; i < 4 && colour.size() == 4; i++) out[i] = static_cast<float>(colour[i]);
}

const int* dmi_tiny_scene_roots(const dmi_tiny* tiny, uint32_t* out_count) {
    const tinygltf::Model& model = tiny->model;
    *out_count = 0;
    if (model.scenes.empty()) return nullptr;
    const size_t shown = inside(model.scenes, model.defaultScene) ? static_cast<size_t>(model.defaultScene) : 0;
    *out_count = static_cast<uint32_t>(model.scenes[shown].nodes.size());
    return model.scenes[shown].nodes.data();
}

const char* dmi_tiny_foreign_extension(const dmi_tiny* tiny) {
    for (const std::string& name : tiny->model.extensionsRequired) {
        if (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression") return name.c_str();
    }
    return nullptr;
}

void dmi_tiny_embed(dmi_tiny* tiny) {
    edit(tiny, [](tinygltf::Model& model) {
        for (size_t i = 1; i < model.buffers.size(); i++) {
            const std::vector<unsigned char>& bytes = model.buffers[i].data;
            const size_t offset = append(model, bytes.data(), bytes.size());
            for (tinygltf::BufferView& view : model.bufferViews) {
                if (view.buffer != static_cast<int>(i)) continue;
                view.byteOffset += offset;
                view.buffer = 0;
            }
        }
        if (model.buffers.empty()) model.buffers.emplace_back();
        model.buffers.resize(1);
        model.buffers[0].uri.clear();
        for (tinygltf::Image& image : model.images) {
            if (!image.image.empty()) image.bufferView = add_view(model, image.image.data(), image.image.size(), 0);
        }
        return 0;
    });
}

int32_t dmi_tiny_add_view(dmi_tiny* tiny, const void* data, size_t size, int32_t target) {
    return edit(tiny, [&](tinygltf::Model& model) { return add_view(model, data, size, target); });
}

int32_t dmi_tiny_add_accessor(dmi_tiny* tiny, int32_t view, int32_t component_type, int32_t components, uint64_t count,
                              const float* minimum, const float* maximum) {
    return edit(tiny, [&](tinygltf::Model& model) {
        tinygltf::Accessor accessor;
        accessor.bufferView = view;
        accessor.componentType = component_type;
        accessor.type = tinygltf_type(components);
        accessor.count = static_cast<size_t>(count);
        if (minimum) accessor.minValues.assign(minimum, minimum + components);
        if (maximum) accessor.maxValues.assign(maximum, maximum + components);
        model.accessors.push_back(std::move(accessor));
        return last(model.accessors);
    });
}

int32_t dmi_tiny_add_material(dmi_tiny* tiny, const float colour[4]) {
    return edit(tiny, [&](tinygltf::Model& model) {
        tinygltf::Material material;
        material.pbrMetallicRoughness.baseColorFactor.assign(colour, colour + 4);
        material.pbrMetallicRoughness.metallicFactor = 0;
        material.pbrMetallicRoughness.roughnessFactor = 0.8;
        material.doubleSided = true;
        model.materials.push_back(std::move(material));
        return last(model.materials);
    });
}

int32_t dmi_tiny_add_mesh(dmi_tiny* tiny, const char* name, int32_t like) {
    return edit(tiny, [&](tinygltf::Model& model) {
        tinygltf::Mesh mesh;
        if (like >= 0) {
            mesh = model.meshes.at(static_cast<size_t>(like));
            mesh.primitives.clear();
        }
        if (name) mesh.name = name;
        model.meshes.push_back(std::move(mesh));
        return last(model.meshes);
    });
}

void dmi_tiny_add_primitive(dmi_tiny* tiny, int32_t mesh, int32_t positions, int32_t indices, int32_t material) {
    edit(tiny, [&](tinygltf::Model& model) {
        tinygltf::Primitive primitive;
        primitive.attributes["POSITION"] = positions;
        primitive.indices = indices;
        primitive.material = material;
        primitive.mode = DMI_TINY_TRIANGLES;
        model.meshes.at(static_cast<size_t>(mesh)).primitives.push_back(std::move(primitive));
        return 0;
    });
}

void dmi_tiny_copy_primitive(dmi_tiny* tiny, int32_t mesh, uint32_t primitive, int32_t to_mesh, int32_t indices) {
    edit(tiny, [&](tinygltf::Model& model) {
        tinygltf::Primitive copy = model.meshes.at(static_cast<size_t>(mesh)).primitives.at(primitive);
        if (indices >= 0) {
            copy.indices = indices;
            copy.mode = DMI_TINY_TRIANGLES;
        }
        model.meshes.at(static_cast<size_t>(to_mesh)).primitives.push_back(std::move(copy));
        return 0;
    });
}

int32_t dmi_tiny_add_node(dmi_tiny* tiny, const char* name, int32_t mesh) {
    return edit(tiny, [&](tinygltf::Model& model) {
        tinygltf::Node node;
        if (name) node.name = name;
        node.mesh = mesh;
        model.nodes.push_back(std::move(node));
        return last(model.nodes);
    });
}

void dmi_tiny_set_mesh(dmi_tiny* tiny, int32_t node, int32_t mesh) {
    edit(tiny, [&](tinygltf::Model& model) { return model.nodes.at(static_cast<size_t>(node)).mesh = mesh; });
}

void dmi_tiny_set_translation(dmi_tiny* tiny, int32_t node, const double translation[3]) {
    edit(tiny, [&](tinygltf::Model& model) {
        model.nodes.at(static_cast<size_t>(node)).translation.assign(translation, translation + 3);
        return 0;
    });
}

void dmi_tiny_copy_transform(dmi_tiny* tiny, int32_t from, int32_t to) {
    edit(tiny, [&](tinygltf::Model& model) {
        const tinygltf::Node& source = model.nodes.at(static_cast<size_t>(from));
        tinygltf::Node& target = model.nodes.at(static_cast<size_t>(to));
        target.translation = source.translation;
        target.rotation = source.rotation;
        target.scale = source.scale;
        target.matrix = source.matrix;
        return 0;
    });
}

void dmi_tiny_add_root(dmi_tiny* tiny, int32_t node) {
    edit(tiny, [&](tinygltf::Model& model) {
        if (model.scenes.empty()) {
            model.scenes.emplace_back();
            std::vector<bool> carried(model.nodes.size());
            for (const tinygltf::Node& parent : model.nodes) {
                for (int child : parent.children) carried.at(static_cast<size_t>(child)) = true;
            }
            for (int i = 0; i <= last(model.nodes); i++) {
                if (!carried[static_cast<size_t>(i)] && i != node) model.scenes[0].nodes.push_back(i);
            }
        }
        if (!inside(model.scenes, model.defaultScene)) model.defaultScene = 0;
        model.scenes[static_cast<size_t>(model.defaultScene)].nodes.push_back(node);
        return 0;
    });
}

void dmi_tiny_add_child(dmi_tiny* tiny, int32_t parent, int32_t child) {
    edit(tiny, [&](tinygltf::Model& model) {
        model.nodes.at(static_cast<size_t>(parent)).children.push_back(child);
        return 0;
    });
}

void dmi_tiny_unhook(dmi_tiny* tiny, int32_t node) {
    edit(tiny, [&](tinygltf::Model& model) {
        const int stand_in = model.nodes.at(static_cast<size_t>(node)).children.empty() ? -1 : last(model.nodes) + 1;
        const auto replace = [&](std::vector<int>& list) {
            for (auto at = list.begin(); at != list.end();) {
                if (*at == node && stand_in >= 0) *at = stand_in;
                at = *at == node ? list.erase(at) : at + 1;
            }
        };
        if (stand_in >= 0) {
            model.nodes.emplace_back();
            tinygltf::Node &moved = model.nodes[static_cast<size_t>(node)], &stays = model.nodes.back();
            stays.children.swap(moved.children);
            stays.translation = moved.translation;
            stays.rotation = moved.rotation;
            stays.scale = moved.scale;
            stays.matrix = moved.matrix;
        }
        for (tinygltf::Node& parent : model.nodes) replace(parent.children);
        for (tinygltf::Scene& scene : model.scenes) replace(scene.nodes);
        return 0;
    });
}

int32_t dmi_tiny_add_animation(dmi_tiny* tiny, const char* name) {
    return edit(tiny, [&](tinygltf::Model& model) {
        tinygltf::Animation animation;
        animation.name = name;
        model.animations.insert(model.animations.begin(), std::move(animation));
        return 0;
    });
}

void dmi_tiny_add_channel(dmi_tiny* tiny, int32_t animation, int32_t node, const char* path, int32_t times,
                          int32_t values) {
    edit(tiny, [&](tinygltf::Model& model) {
        tinygltf::Animation& target = model.animations.at(static_cast<size_t>(animation));
        tinygltf::AnimationSampler sampler;
        sampler.input = times;
        sampler.output = values;
        target.samplers.push_back(std::move(sampler));
        tinygltf::AnimationChannel channel;
        channel.sampler = last(target.samplers);
        channel.target_node = node;
        channel.target_path = path;
        target.channels.push_back(std::move(channel));
        return 0;
    });
}

dm_result dmi_tiny_write(dmi_tiny* tiny, const void** out_data, size_t* out_size, char* message, size_t message_size) {
    if (tiny->failure != DM_OK) {
        say(message, message_size, "an edit of the document failed");
        return tiny->failure;
    }
    if (!tiny->model.buffers.empty() && tiny->model.buffers[0].data.size() > 0xF0000000u) {
        say(message, message_size, "more than 4 GB, which a .glb can't hold");
        return DM_ERROR_TOO_LARGE;
    }
    return guarded(message, message_size, [&] {
        std::ostringstream stream;
        tinygltf::TinyGLTF writer;
        if (!writer.WriteGltfSceneToStream(&tiny->model, stream, false, true)) {
            say(message, message_size, "tinygltf could not write the document");
            return static_cast<dm_result>(DM_ERROR_INTERNAL);
        }
        tiny->written = stream.str();
        *out_data = tiny->written.data();
        *out_size = tiny->written.size();
        return static_cast<dm_result>(DM_OK);
    });
}

} // extern "C"
