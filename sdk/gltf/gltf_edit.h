/* A document being written: JSON, and the bytes of its one buffer. The first failure is kept. Edits after it do
 * nothing, and dmi_edit_write reports it, so that an edit needs no check a line. */
#ifndef DMI_GLTF_EDIT_H
#define DMI_GLTF_EDIT_H

#include "gltf/gltf_file.h"

typedef struct dmi_edit {
    dmi_env* env;
    dm_gltf* from; /* the file that is copied; NULL: a new document */
    dmi_gltf_document document;
    uint32_t counts[DMI_GLTF_LISTS]; /* sizes of the lists, with what was added */
    uint64_t base;                   /* bytes of the old buffers, which come first */
    uint8_t* added;                  /* bytes that come behind these */
    uint64_t added_size, added_capacity;
    dmi_gltf_problem problem;
} dmi_edit;

/* An item of one of the document's lists. */
typedef struct dmi_edit_item {
    cJSON* json; /* NULL after a failure */
    int32_t index;
} dmi_edit_item;

/* Opens a copy of `from` whose buffers are one, or an empty document with one scene. */
void dmi_edit_open(dmi_edit* e, dmi_env* env, dm_gltf* from);
void dmi_edit_close(dmi_edit* e);
/* Reports progress as dmi_gltf_tell does, where a file is copied. A cancelled edit has failed. */
void dmi_edit_tell(dmi_edit* e, float share, uint64_t work);
/* Writes a .glb into memory of the host. */
dm_result dmi_edit_write(dmi_edit* e, void** out_data, size_t* out_size);

/* Removes an extension that no object has any more from the lists of extensions. */
void dmi_edit_drop_unused(dmi_edit* e, const char* extension);

/* ---- values; nothing happens where `object` or `item` is NULL ---- */

cJSON* dmi_edit_new(dmi_edit* e, cJSON* made);
cJSON* dmi_edit_set(dmi_edit* e, cJSON* object, const char* name, cJSON* item);
void dmi_edit_number(dmi_edit* e, cJSON* object, const char* name, double value);
void dmi_edit_text(dmi_edit* e, cJSON* object, const char* name, const char* value);
void dmi_edit_numbers(dmi_edit* e, cJSON* object, const char* name, const double* values, int count);
/* Returns the member `name`, which is a new list or object where it was missing. */
cJSON* dmi_edit_list(dmi_edit* e, cJSON* object, const char* name);
cJSON* dmi_edit_object(dmi_edit* e, cJSON* object, const char* name);
void dmi_edit_append(dmi_edit* e, cJSON* list, cJSON* item);
void dmi_edit_append_number(dmi_edit* e, cJSON* list, double value);

/* ---- items ---- */

/* Appends an item to one of the document's lists. json: NULL adds an empty object. */
dmi_edit_item dmi_edit_add(dmi_edit* e, dmi_gltf_list list, cJSON* json);
/* Appends bytes to the buffer, and a view of them. target: 0 for none. */
int32_t dmi_edit_add_view(dmi_edit* e, const void* data, uint64_t size, int target);
/* Adds an accessor of packed elements with 1, 3 or 4 components. minimum and maximum may be NULL. */
int32_t dmi_edit_add_accessor(dmi_edit* e, int32_t view, int type, int components, uint64_t count, const float* minimum,
                              const float* maximum);

#endif
