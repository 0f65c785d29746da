/* Embeds images of files beside the document, which a .glb written elsewhere would lose. */
#include "gltf/gltf_images.h"

#include <string.h>

#include "gltf/gltf_uri.h"

/* Returns the media type by the first bytes, or NULL for one that glTF and its extensions lack. */
static const char* media_type(const uint8_t* data, size_t size) {
    static const struct {
        const char* type;
        const char* start;
        size_t length;
    } types[] = {{"image/png", "\x89PNG", 4},
                 {"image/jpeg", "\xFF\xD8\xFF", 3},
                 {"image/ktx2", "\xABKTX 20", 7},
                 {"image/vnd-ms.dds", "DDS ", 4}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
        if (size >= types[i].length && memcmp(data, types[i].start, types[i].length) == 0) return types[i].type;
    }
    return size >= 12 && memcmp(data, "RIFF", 4) == 0 && memcmp(data + 8, "WEBP", 4) == 0 ? "image/webp" : NULL;
}

static void embed_image(dmi_edit* e, cJSON* image, const char* path) {
    const dm_gltf_files* files = &e->from->files;
    const void* data;
    size_t size = 0;
    const dm_result opened = files->open(files->user, path, &data, &size);
    if (opened == DM_ERROR_OUT_OF_MEMORY)
        dmi_gltf_refuse(&e->problem, opened, "glTF: no memory for the image '%s'", dmi_uri_shorten(path).text);
    if (opened != DM_OK) return;
    const char* type = media_type(data, size);
    if (type) {
        const int32_t view = dmi_edit_add_view(e, data, size, 0);
        dmi_edit_number(e, image, "bufferView", view);
        dmi_edit_text(e, image, "mimeType", type);
        cJSON_DeleteItemFromObjectCaseSensitive(image, "uri");
    }
    files->close(files->user, data, size);
}

void dmi_images_embed(dmi_edit* e) {
    for (uint32_t i = 0; e->from->files.open && i < e->document.counts[DMI_GLTF_IMAGES]; i++) {
        if (e->problem.code != DM_OK) return;
        cJSON* image = e->document.items[DMI_GLTF_IMAGES][i];
        const char* uri = dmi_json_text(image, "uri");
        if (!uri || dmi_uri_is_data(uri)) continue;
        const size_t room = strlen(uri) + 1;
        dmi_gltf_problem elsewhere;
        char* path = dmi_alloc(e->env, room, 1);
        if (!path)
            dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for a path");
        else if (dmi_uri_to_path(uri, &elsewhere, path) == DM_OK)
            embed_image(e, image, path);
        dmi_free(e->env, path, room);
    }
}
