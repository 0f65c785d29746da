/* Fuzz target: compressed streams in a glTF file that is right: the codecs and filters of meshopt, and Draco. The
 * decoders are the work of others, and what reaches them is a stranger's. The first bytes choose codec, filter and
 * sizes; the rest is the stream. */
#include <stdarg.h>
#include <stdio.h>

#include "../include/test_glb.h"
#include "input.h"
#include "use_gltf.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

enum { MOST_JSON = 2048, MOST_STREAM = 1 << 16, POINTS = 64, DRACO = 3 };
enum { FLOAT = 5126, UINT = 5125, USHORT = 5123, SHORT = 5122, UBYTE = 5121, BYTE = 5120 }; /* of glTF */

#define STREAM_AT (POINTS * sizeof(dm_vec3))

static char json[MOST_JSON];
static size_t json_size;

static void say(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int size = vsnprintf(json + json_size, sizeof json - json_size, format, arguments);
    va_end(arguments);
    json_size += (size_t)size;
    fuzz_expect(json_size < sizeof json);
}

/* ---- the JSON: buffer 0 has the points that indices may name, then the stream ---- */

static void say_asset(const char* extension) {
    say("{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],");
    say("\"nodes\":[{\"mesh\":0,\"name\":\"door\"}],\"extensionsRequired\":[\"%s\",\"KHR_mesh_quantization\"],",
        extension);
}

/* Elements of the stream are positions, or indices of the points. */
static void say_meshopt(fuzz_input* in, uint32_t codec) {
    static const char* const modes[] = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
    static const char* const filters[] = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
    static const int types[] = {FLOAT, USHORT, SHORT, UBYTE, BYTE}, strides[] = {12, 8, 8, 4, 4};
    const char* filter = filters[fuzz_below(in, 4)];
    const uint32_t element = fuzz_below(in, 5), low = fuzz_byte(in), count = low | fuzz_below(in, 16) << 8;
    const int is_wide = element % 2, is_position = codec == 0;
    const int stride = is_position ? strides[element] : is_wide ? 4 : 2;
    const int type = is_position ? types[element] : is_wide ? UINT : USHORT;
    say_asset("EXT_meshopt_compression");
    say("\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":%d}%s}]}],", !is_position,
        is_position ? "" : ",\"indices\":0");
    say("\"accessors\":[{\"bufferView\":0,\"componentType\":%d,\"count\":%u,\"type\":\"%s\"},", type, count,
        is_position ? "VEC3" : "SCALAR");
    say("{\"bufferView\":1,\"componentType\":%d,\"count\":%d,\"type\":\"VEC3\"}],", FLOAT, POINTS);
    say("\"bufferViews\":[{\"buffer\":1,\"byteLength\":%u,", count * (uint32_t)stride);
    if (is_position) say("\"byteStride\":%d,", stride);
    say("\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,", STREAM_AT,
        in->size);
    say("\"byteStride\":%d,\"count\":%u,\"mode\":\"%s\",\"filter\":\"%s\"}}},", stride, count, modes[codec], filter);
    say("{\"buffer\":0,\"byteLength\":%zu}],\"buffers\":[{\"byteLength\":%zu},", STREAM_AT, STREAM_AT + in->size);
    say("{\"byteLength\":%u,\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}]}",
        count * (uint32_t)stride);
}

/* The stream's attributes have small ids; which is what is for it to say. */
static void say_draco(fuzz_input* in) {
    const uint32_t points = fuzz_byte(in), faces = fuzz_byte(in), position = fuzz_below(in, 4), uv = fuzz_below(in, 4);
    say_asset("KHR_draco_mesh_compression");
    say("\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"indices\":2,");
    say("\"extensions\":{\"KHR_draco_mesh_compression\":{\"bufferView\":0,\"attributes\":{\"POSITION\":%u,", position);
    say("\"TEXCOORD_0\":%u}}}}]}],", uv);
    say("\"accessors\":[{\"componentType\":%d,\"count\":%u,\"type\":\"VEC3\"},", FLOAT, points);
    say("{\"componentType\":%d,\"count\":%u,\"type\":\"VEC2\"},", FLOAT, points);
    say("{\"componentType\":%d,\"count\":%u,\"type\":\"SCALAR\"}],", UINT, faces * 3);
    say("\"bufferViews\":[{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}],", STREAM_AT, in->size);
    say("\"buffers\":[{\"byteLength\":%zu}]}", STREAM_AT + in->size);
}

/* The points, then the stream. */
static test_glb make_file(const fuzz_input* stream) {
    static uint8_t bin[STREAM_AT + MOST_STREAM];
    for (int i = 0; i < POINTS; i++) {
        const dm_vec3 point = {(float)(i % 4), (float)(i / 4 % 4), (float)(i / 16)};
        memcpy(bin + (size_t)i * sizeof point, &point, sizeof point);
    }
    if (stream->size > 0) memcpy(bin + STREAM_AT, stream->data, stream->size);
    return test_glb_pack(json, bin, STREAM_AT + stream->size);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    fuzz_input in = {data, size < MOST_STREAM ? size : MOST_STREAM};
    const uint32_t codec = fuzz_below(&in, DRACO + 1);
    json_size = 0;
    if (codec == DRACO)
        say_draco(&in);
    else
        say_meshopt(&in, codec);
    const test_glb file = make_file(&in);
    use_gltf(file.data, file.size);
    free(file.data);
    return 0;
}
