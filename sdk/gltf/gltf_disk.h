/* The one place that opens files: by UTF-8 paths, wide characters on Windows, POSIX elsewhere. */
#ifndef DMI_GLTF_DISK_H
#define DMI_GLTF_DISK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define DMI_DISK_PATH 4096 /* bytes of the longest path; Linux' limit */

/* Opens a regular file for reading and writes its size. Returns a descriptor, or -1 with errno set. Pipes and devices,
 * which may never end, are refused with EINVAL, a folder with EISDIR. */
int dmi_disk_open(const char* path, uint64_t* out_size);
void dmi_disk_close(int file);
/* Reads all of `size` bytes. Returns false when there are fewer. */
bool dmi_disk_read(int file, void* data, size_t size);
/* Writes the absolute path without links, with '/' between names. Returns false when there is no such file. */
bool dmi_disk_real_path(const char* path, char out[DMI_DISK_PATH]);
/* Returns the last character that separates names, or NULL when there is one name alone. */
const char* dmi_disk_last_separator(const char* path);

#endif
