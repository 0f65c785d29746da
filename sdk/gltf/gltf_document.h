/* A glTF document: its JSON with its lists, addressed by index, and the check of its fields
 * (gltf_fields.c). */
#ifndef DMI_GLTF_DOCUMENT_H
#define DMI_GLTF_DOCUMENT_H

#include "gltf/gltf_json.h"

/* Lists that other parts of a document address by index. */
typedef enum dmi_gltf_list {
    DMI_GLTF_ACCESSORS,
    DMI_GLTF_BUFFERS,
    DMI_GLTF_IMAGES,
    DMI_GLTF_MATERIALS,
    DMI_GLTF_MESHES,
    DMI_GLTF_NODES,
    DMI_GLTF_SAMPLERS,
    DMI_GLTF_SCENES,
    DMI_GLTF_SKINS,
    DMI_GLTF_TEXTURES,
    DMI_GLTF_VIEWS,
    DMI_GLTF_LISTS
} dmi_gltf_list;

typedef struct dmi_gltf_document {
    cJSON* root;
    cJSON** items[DMI_GLTF_LISTS];
    uint32_t counts[DMI_GLTF_LISTS];
} dmi_gltf_document;

/* Name of a list in the file. */
extern const char* const dmi_gltf_list_names[DMI_GLTF_LISTS];

/* Lists the parts of `root`. It takes `root` over, also where it fails. */
dm_result dmi_gltf_document_open(dmi_env* env, cJSON* root, dmi_gltf_problem* problem, dmi_gltf_document* out);
/* Lists the parts of one list anew, after some were added to it. */
dm_result dmi_gltf_list_again(dmi_env* env, dmi_gltf_document* document, dmi_gltf_list list, dmi_gltf_problem* problem);
void dmi_gltf_document_close(dmi_env* env, dmi_gltf_document* document);

/* Returns an item of a list, or NULL when there is none. `index` is as the file has it: perhaps negative, broken or
 * huge. */
cJSON* dmi_gltf_item(const dmi_gltf_document* document, dmi_gltf_list list, double index);
/* Returns the position in the list of an index that dmi_gltf_item finds, or -1 for others. */
int64_t dmi_gltf_position(const dmi_gltf_document* document, dmi_gltf_list list, double index);

/* Returns whether the file cannot be read without an extension. */
int dmi_gltf_requires(const dmi_gltf_document* document, const char* extension);
/* Checks "asset", and that every required extension is one that this library reads or may ignore. */
dm_result dmi_gltf_check_asset(const dmi_gltf_document* document, dmi_gltf_problem* problem);

/* glTF's own numbers. */
enum {
    DMI_GLTF_BYTE = 5120,
    DMI_GLTF_UBYTE = 5121,
    DMI_GLTF_SHORT = 5122,
    DMI_GLTF_USHORT = 5123,
    DMI_GLTF_UINT = 5125,
    DMI_GLTF_FLOAT = 5126
};
enum { DMI_GLTF_TRIANGLES = 4, DMI_GLTF_STRIP = 5, DMI_GLTF_FAN = 6 };
enum { DMI_GLTF_VERTEX_TARGET = 34962, DMI_GLTF_INDEX_TARGET = 34963 };

/* Checks the fields that this library reads without another check: an index must be one, a list of numbers as long as
 * glTF has it, a name text, and an object an object. Answers BAD_DATA, with the field, what it must be and what it is.
 * Other faults of counts, sizes and offsets are refused where these are read. */
dm_result dmi_gltf_check_fields(const dmi_gltf_document* document, dmi_gltf_problem* problem);

#endif
