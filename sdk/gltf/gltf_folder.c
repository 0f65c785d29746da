/* The files beside a document, read from its folder and from nowhere else. */
#include "gltf/gltf_folder.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "gltf/gltf_disk.h"

/* Reads all that the file has. Returns DM_OK, NOT_FOUND with errno set, OUT_OF_MEMORY or TOO_LARGE. */
static dm_result read_descriptor(dmi_env* env, int file, uint64_t size, dmi_gltf_contents* out) {
    if (size > UINT32_MAX) return DM_ERROR_TOO_LARGE;
    out->size = (size_t)size;
    out->data = dmi_alloc(env, out->size, 16);
    if (!out->data) return DM_ERROR_OUT_OF_MEMORY;
    if (dmi_disk_read(file, out->data, out->size)) return DM_OK;
    dmi_free(env, out->data, out->size);
    errno = EIO;
    return DM_ERROR_NOT_FOUND;
}

dm_result dmi_gltf_read_file(dmi_env* env, const char* path, dmi_gltf_contents* out) {
    uint64_t size;
    const int file = dmi_disk_open(path, &size);
    if (file < 0) return DM_ERROR_NOT_FOUND;
    const dm_result result = read_descriptor(env, file, size, out);
    const int reason = errno;
    dmi_disk_close(file);
    errno = reason;
    return result;
}

/* Writes the file's path. Returns 0 when links lead out of the folder. */
static int find_inside(const char* folder, const char* path, char out[DMI_DISK_PATH]) {
    char base[DMI_DISK_PATH], joined[DMI_DISK_PATH];
    if (!dmi_disk_real_path(folder, base)) return 0;
    const size_t length = strlen(base), whole = (size_t)snprintf(joined, sizeof joined, "%s/%s", base, path);
    if (whole >= sizeof joined || !dmi_disk_real_path(joined, out)) return 0;
    return strcmp(base, "/") == 0 || (strncmp(out, base, length) == 0 && out[length] == '/');
}

static int32_t DM_CALL open_beside(void* user, const char* path, const void** out_data, size_t* out_size) {
    dm_gltf* gltf = user;
    char inside[DMI_DISK_PATH];
    dmi_gltf_contents found;
    if (!find_inside(gltf->on_disk.folder, path, inside)) return DM_ERROR_NOT_FOUND;
    const dm_result result = dmi_gltf_read_file(&gltf->env, inside, &found);
    if (result != DM_OK) return result;
    *out_data = found.data;
    *out_size = found.size;
    return DM_OK;
}

static void DM_CALL close_beside(void* user, const void* data, size_t size) {
    dm_gltf* gltf = user;
    dmi_free(&gltf->env, (void*)data, size);
}

dm_gltf_files dmi_gltf_folder_files(dm_gltf* gltf) {
    return (dm_gltf_files){.user = gltf, .open = open_beside, .close = close_beside};
}
