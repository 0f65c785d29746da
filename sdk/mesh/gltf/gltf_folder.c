/* dm_gltf_open_file: a document and the files beside it, read from its folder and from nowhere else. */
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/fp_environment.h"
#include "mesh/gltf/gltf_disk.h"
#include "mesh/gltf/gltf_file.h"

/* Bytes of a file. */
typedef struct contents {
    void* data;
    size_t size;
} contents;

/* Reads all that the file has. Returns DM_OK, NOT_FOUND with errno set, OUT_OF_MEMORY or TOO_LARGE. */
static dm_result read_descriptor(dmi_env* env, int file, uint64_t size, contents* out) {
    if (size > UINT32_MAX) return DM_ERROR_TOO_LARGE;
    out->size = (size_t)size;
    out->data = dmi_alloc(env, out->size, 16);
    if (!out->data) return DM_ERROR_OUT_OF_MEMORY;
    if (dmi_disk_read(file, out->data, out->size)) return DM_OK;
    dmi_free(env, out->data, out->size);
    errno = EIO;
    return DM_ERROR_NOT_FOUND;
}

static dm_result read_file(dmi_env* env, const char* path, contents* out) {
    uint64_t size;
    const int file = dmi_disk_open(path, &size);
    if (file < 0) return DM_ERROR_NOT_FOUND;
    const dm_result result = read_descriptor(env, file, size, out);
    const int reason = errno;
    dmi_disk_close(file);
    errno = reason;
    return result;
}

/* Writes the file's path, if links don't lead out of the folder. */
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
    contents found;
    if (!find_inside(gltf->on_disk.folder, path, inside)) return DM_ERROR_NOT_FOUND;
    const dm_result result = read_file(&gltf->env, inside, &found);
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

/* The folder that holds the file, as new memory of *out_size bytes. */
static char* folder_of(dmi_env* env, const char* path, size_t* out_size) {
    const char* slash = dmi_disk_last_separator(path);
    const size_t length = !slash ? 1 : slash == path ? 1 : (size_t)(slash - path);
    char* folder = dmi_alloc(env, length + 1, 1);
    if (!folder) return NULL;
    memcpy(folder, slash ? path : ".", length);
    folder[length] = 0;
    *out_size = length + 1;
    return folder;
}

/* Takes `from` over. */
static dm_result open_contents(dmi_env* env, const char* path, const dm_gltf_desc* desc, const contents* from,
                               dm_gltf** out_gltf) {
    dmi_gltf_on_disk on_disk = {.data = from->data, .size = from->size};
    on_disk.folder = folder_of(env, path, &on_disk.folder_size);
    if (from->size == 0 || !on_disk.folder) {
        dmi_gltf_release_on_disk(env, &on_disk);
        return from->size == 0 ? dmi_fail(env, DM_ERROR_BAD_DATA, "'%.200s' is empty", path)
                               : dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for a path");
    }
    dm_gltf_desc whole = *desc;
    whole.data = from->data;
    whole.size = from->size;
    return dmi_gltf_open_in(&whole, &on_disk, out_gltf);
}

dm_result dm_gltf_open_file(const char* path, const dm_gltf_desc* desc, dm_gltf** out_gltf) {
    DMI_OWN_FP;
    dmi_env env;
    if (!path || !desc || !out_gltf) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env_init(&env, NULL, dmi_gltf_log_of(desc), NULL);
    dm_gltf_desc known;
    dm_result result = dmi_gltf_read_desc(&env, desc, 0, &known);
    if (result == DM_OK && known.files.open)
        result = dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_desc.files: the folder stands for them");
    if (result != DM_OK) return result;
    dmi_env_init(&env, &known.allocator, &known.log, NULL);
    contents found;
    result = read_file(&env, path, &found);
    if (result == DM_ERROR_OUT_OF_MEMORY || result == DM_ERROR_TOO_LARGE)
        return dmi_fail(&env, result, "'%.200s': no memory for it, or more than 4 GB", path);
    if (result != DM_OK)
        return dmi_fail(&env, result, "can't read '%.200s': %s", path,
                        errno == EINVAL ? "it is a pipe or a device, not a file" : strerror(errno));
    return open_contents(&env, path, &known, &found, out_gltf);
}
