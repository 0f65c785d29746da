/* The files of the disk: a document, and those of its folder. */
#ifndef DMI_GLTF_FOLDER_H
#define DMI_GLTF_FOLDER_H

#include "gltf/gltf_file.h"

/* Bytes of a file. */
typedef struct dmi_gltf_contents {
    void* data;
    size_t size;
} dmi_gltf_contents;

/* Reads a whole file into new memory of the host. Returns DM_OK, NOT_FOUND with errno set, OUT_OF_MEMORY or TOO_LARGE.
 */
dm_result dmi_gltf_read_file(dmi_env* env, const char* path, dmi_gltf_contents* out);
/* Returns the files of gltf->on_disk.folder. */
dm_gltf_files dmi_gltf_folder_files(dm_gltf* gltf);
/* Returns the last character that separates names, or NULL when there is one name alone. */
const char* dmi_gltf_last_separator(const char* path);

#endif
