/* A glTF document: its JSON with its lists, addressed by index, and the check of its fields
 * (gltf_fields.c). */
#ifndef DMI_GLTF_DOCUMENT_H
#define DMI_GLTF_DOCUMENT_H

#include <cjson/cJSON.h>

#include "gltf/gltf_problem.h"

/* ---- members of JSON objects (gltf_json.c); a missing object has none ---- */

#define DMI_GLTF_NO_INDEX (-1.0) /* an index that a file does not give */

const cJSON* dmi_json_get(const cJSON* object, const char* name);
/* Returns a text, or NULL when it is missing or no string. */
const char* dmi_json_text(const cJSON* object, const char* name);
double dmi_json_number(const cJSON* object, const char* name, double otherwise);
/* Reads `count` numbers of a list. Returns 0, and leaves `out` as it was, when the list is missing or has another
 * length. */
int dmi_json_numbers(const cJSON* object, const char* name, int count, double* out);
/* Reads a whole number from 0 to `most`, or takes `otherwise` where it is missing. Answers BAD_DATA with what `place`
 * has instead. */
dm_result dmi_json_whole(const cJSON* object, const char* name, double otherwise, double most, const char* place,
                         dmi_gltf_problem* problem, uint64_t* out);
/* Reads a text of `length` bytes, which must be one JSON value. Strings are valid UTF-8 then, except URIs. Every name
 * is in an object once; of repeated ones the last counts. */
dm_result dmi_json_parse(const char* text, size_t length, dmi_gltf_problem* problem, cJSON** out);

/* ---- the document ---- */

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
