/* Reads surfaces: triangles with one material, the image of its base colour, and where their corners lie in it. */
#include "gltf/gltf_shape.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "base/fp_environment.h"
#include "gltf/gltf_buffers.h"
#include "gltf/gltf_geometry.h"

const cJSON* dmi_gltf_material_of(const dm_gltf* gltf, const cJSON* primitive, float out_colour[4]) {
    const double index = dmi_json_number(primitive, "material", DMI_GLTF_NO_INDEX);
    const cJSON* material = dmi_gltf_item(&gltf->document, DMI_GLTF_MATERIALS, index);
    double colour[4] = {1, 1, 1, 1};
    dmi_json_numbers(dmi_json_get(material, "pbrMetallicRoughness"), "baseColorFactor", 4, colour);
    for (int i = 0; i < 4; i++) out_colour[i] = (float)colour[i];
    return material;
}

/* Returns what the material says of its base colour texture, or NULL when it has none. */
static const cJSON* texture_info(const cJSON* material) {
    return dmi_json_get(dmi_json_get(material, "pbrMetallicRoughness"), "baseColorTexture");
}

/* Returns the item of a list that a member names, or NULL when there is none. */
static const cJSON* item_of(const dm_gltf* gltf, dmi_gltf_list list, const cJSON* object, const char* member) {
    return dmi_gltf_item(&gltf->document, list, dmi_json_number(object, member, DMI_GLTF_NO_INDEX));
}

/* ---- the image ---- */

/* Returns the position of the texture's image, or -1 when there is none. An image of an extension counts where there is
 * no other one. */
static int64_t image_of(const dm_gltf* gltf, const cJSON* texture) {
    static const char* const formats[] = {"EXT_texture_webp", "KHR_texture_basisu", "MSFT_texture_dds"};
    double source = dmi_json_number(texture, "source", DMI_GLTF_NO_INDEX);
    for (size_t i = 0; source < 0 && i < sizeof formats / sizeof *formats; i++)
        source =
            dmi_json_number(dmi_json_get(dmi_json_get(texture, "extensions"), formats[i]), "source", DMI_GLTF_NO_INDEX);
    return dmi_gltf_position(&gltf->document, DMI_GLTF_IMAGES, source);
}

static dm_result open_image(dm_gltf* gltf, const cJSON* image, const char* place, dmi_gltf_problem* problem,
                            dmi_gltf_buffer* out) {
    const char* uri = dmi_json_text(image, "uri");
    dmi_gltf_view view;
    if (uri) return dmi_gltf_open_uri(gltf, uri, problem, out);
    const double index = dmi_json_number(image, "bufferView", DMI_GLTF_NO_INDEX);
    const dm_result result = dmi_gltf_find_view(gltf, index, place, problem, &view);
    if (result == DM_OK) *out = (dmi_gltf_buffer){.data = view.data, .size = view.size};
    return result;
}

/* Finds the bytes of the texture's image, once. */
static dm_result find_image(dm_gltf* gltf, const cJSON* texture, dm_gltf_surface* out) {
    const uint32_t count = gltf->document.counts[DMI_GLTF_IMAGES];
    const int64_t position = image_of(gltf, texture);
    dmi_gltf_problem problem;
    char place[64];
    if (position < 0) return DM_OK;
    if (!gltf->images) gltf->images = dmi_alloc_zeroed(&gltf->env, count * sizeof *gltf->images, 16);
    if (!gltf->images) return dmi_fail(&gltf->env, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u images", count);
    dmi_gltf_buffer* image = &gltf->images[position];
    snprintf(place, sizeof place, "glTF image %d", (int)position);
    if (!image->data) {
        const cJSON* json = gltf->document.items[DMI_GLTF_IMAGES][position];
        const dm_result result = open_image(gltf, json, place, &problem, image);
        if (result == DM_ERROR_OUT_OF_MEMORY) return dmi_fail(&gltf->env, result, "%s", problem.text);
        static const uint8_t nothing[1];
        if (result != DM_OK) {
            dmi_gltf_warn(&gltf->warnings, "%s; the image is left out", problem.text);
            *image = (dmi_gltf_buffer){.data = nothing}; /* an image that is missing is not looked for again */
        }
    }
    out->image = image->size > 0 ? image->data : NULL;
    out->image_size = (size_t)image->size;
    return DM_OK;
}

static int32_t wrap_of(const cJSON* sampler, const char* name) {
    const double number = dmi_json_number(sampler, name, DM_GLTF_WRAP_REPEAT);
    if (number == DM_GLTF_WRAP_CLAMP) return DM_GLTF_WRAP_CLAMP;
    return number == DM_GLTF_WRAP_MIRROR ? DM_GLTF_WRAP_MIRROR : DM_GLTF_WRAP_REPEAT;
}

uint32_t dm_gltf_surface_count(const dm_gltf* gltf) {
    return gltf ? gltf->piece_count : 0;
}

dm_result dm_gltf_get_surface(dm_gltf* gltf, uint32_t index, dm_gltf_surface* out_surface) {
    DMI_OWN_FP;
    if (!gltf || !out_surface) return DM_ERROR_INVALID_ARGUMENT;
    if (index >= gltf->piece_count) return DM_ERROR_NOT_FOUND;
    const dmi_gltf_piece* piece = &gltf->pieces[index];
    dm_gltf_surface out = {.first_face = piece->first_face, .face_count = piece->face_count};
    const cJSON* info = texture_info(dmi_gltf_material_of(gltf, piece->json, out.colour));
    const cJSON* texture = item_of(gltf, DMI_GLTF_TEXTURES, info, "index");
    const cJSON* sampler = item_of(gltf, DMI_GLTF_SAMPLERS, texture, "sampler");
    out.wrap_u = wrap_of(sampler, "wrapS");
    out.wrap_v = wrap_of(sampler, "wrapT");
    const dm_result result = find_image(gltf, texture, &out);
    dmi_gltf_log_warnings(&gltf->env, &gltf->warnings);
    if (result == DM_OK) *out_surface = out;
    return result;
}

/* ---- coordinates ---- */

/* Reads a transform: u' = m[0] u + m[1] v + m[2], v' = m[3] u + m[4] v + m[5] (KHR_texture_transform). */
static void read_transform(const cJSON* transform, double m[6]) {
    double offset[2] = {0, 0}, scale[2] = {1, 1};
    const double turn = dmi_json_number(transform, "rotation", 0);
    dmi_json_numbers(transform, "offset", 2, offset);
    dmi_json_numbers(transform, "scale", 2, scale);
    m[0] = cos(turn) * scale[0], m[1] = -sin(turn) * scale[1], m[2] = offset[0];
    m[3] = sin(turn) * scale[0], m[4] = cos(turn) * scale[1], m[5] = offset[1];
}

/* Writes the coordinates. They are 0 for corners without any, and where they are not finite. */
static void write_coordinates(const dm_gltf* gltf, const dmi_gltf_piece* piece, const dmi_gltf_elements* from,
                              const double m[6], float* out) {
    for (uint64_t i = 0; i < 3 * piece->face_count; i++) {
        const uint64_t element = gltf->sources[gltf->indices[3 * piece->first_face + i]];
        const bool has = element < from->count;
        const double u = has ? dmi_gltf_value(from, element, 0) : 0, v = has ? dmi_gltf_value(from, element, 1) : 0;
        const float turned[2] = {(float)(m[0] * u + m[1] * v + m[2]), (float)(m[3] * u + m[4] * v + m[5])};
        for (int k = 0; k < 2; k++) out[2 * i + k] = isfinite(turned[k]) ? turned[k] : 0;
    }
}

dm_result dm_gltf_get_texture_coordinates(dm_gltf* gltf, uint32_t index, float* out_uv, uint64_t corner_count) {
    DMI_OWN_FP;
    if (!gltf || !out_uv) return DM_ERROR_INVALID_ARGUMENT;
    if (index >= gltf->piece_count) return DM_ERROR_NOT_FOUND;
    const dmi_gltf_piece* piece = &gltf->pieces[index];
    if (corner_count < 3 * piece->face_count) return DM_ERROR_BUFFER_TOO_SMALL;
    const cJSON* primitive = piece->json;
    float colour[4];
    const cJSON* info = texture_info(dmi_gltf_material_of(gltf, primitive, colour));
    const cJSON* transform = dmi_json_get(dmi_json_get(info, "extensions"), "KHR_texture_transform");
    char name[32];
    snprintf(name, sizeof name, "TEXCOORD_%.0f",
             dmi_json_number(transform, "texCoord", dmi_json_number(info, "texCoord", 0)));
    const cJSON* accessor = dmi_json_get(dmi_json_get(primitive, "attributes"), name);
    if (!info || !accessor) return DM_ERROR_NOT_FOUND;
    dmi_gltf_problem problem;
    dmi_gltf_elements from;
    const dm_result result =
        dmi_gltf_draco_of(gltf, primitive)
            ? dmi_gltf_find_in_draco(gltf, primitive, name, "glTF: texture coordinates", &problem, &from)
            : dmi_gltf_find_elements(gltf, accessor->valuedouble, "glTF: texture coordinates", &problem, &from);
    dmi_gltf_log_warnings(&gltf->env, &gltf->warnings);
    if (result != DM_OK) return dmi_fail(&gltf->env, result, "%s", problem.text);
    if (from.components != 2)
        return dmi_fail(&gltf->env, DM_ERROR_BAD_DATA, "glTF: %s has %d components", name, from.components);
    double m[6];
    read_transform(transform, m);
    write_coordinates(gltf, piece, &from, m, out_uv);
    return DM_OK;
}
