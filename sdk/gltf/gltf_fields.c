/* The fields of glTF 2.0 that are read, as tables, and the walk over them. */
#include "gltf/gltf_document.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "dragmesh/ext/gltf.h"
#include "gltf/gltf_draco.h"

typedef enum kind {
    OBJECT,
    TEXT,
    TRUTH,
    NUMBER,
    FLOAT, /* a number that a float holds */
    WRAP,  /* how a texture goes on beyond its image */
    CELL,  /* a number of a matrix of 4 columns, which end with 0 0 0 1 */
    INDEX, /* index of an item that is looked up where it is needed; a part of the file is left out without it */
    ITEM   /* an index that no other check covers: it must name an item that exists */
} kind;

typedef struct field {
    const char* name; /* NULL ends a table; EACH: every member */
    kind kind;
    int count;                  /* 0: one such value; ANY: a list of them; else a list of that many */
    const struct field* fields; /* fields of an object */
    dmi_gltf_list of;           /* the list that the item is in */
    const char* not_beside;     /* a member that excludes this one */
} field;

enum { ANY = -1, COLUMN = 4, CELLS = 16 };
#define EACH "*"

/* How far the last row of a matrix may be off 0 0 0 1; by hand: floats that an exporter multiplied are off by 1e-6. */
#define ROW_ERROR 1e-3

/* ---- the fields ---- */

static const field indices[] = {{EACH, .kind = INDEX}, {0}};
static const field scene[] = {{"nodes", .kind = INDEX, .count = ANY}, {0}};
static const field visibility[] = {{"visible", .kind = TRUTH}, {0}};
static const field node_extensions[] = {{"KHR_node_visibility", .kind = OBJECT, .fields = visibility}, {0}};
static const field node[] = {
    {"name", .kind = TEXT},
    {"mesh", .kind = INDEX},
    {"skin", .kind = INDEX},
    {"children", .kind = INDEX, .count = ANY},
    {"matrix", .kind = CELL, .count = CELLS},
    {"translation", .kind = NUMBER, .count = 3, .not_beside = "matrix"},
    {"rotation", .kind = NUMBER, .count = 4, .not_beside = "matrix"},
    {"scale", .kind = NUMBER, .count = 3, .not_beside = "matrix"},
    {"extensions", .kind = OBJECT, .fields = node_extensions},
    {0},
};
static const field draco[] = {
    {"bufferView", .kind = INDEX},
    {"attributes", .kind = OBJECT, .fields = indices},
    {0},
};
static const field primitive_extensions[] = {{DMI_DRACO_NAME, .kind = OBJECT, .fields = draco}, {0}};
static const field primitive[] = {
    {"attributes", .kind = OBJECT, .fields = indices},
    {"indices", .kind = INDEX},
    {"material", .kind = ITEM, .of = DMI_GLTF_MATERIALS},
    {"targets", .kind = OBJECT, .count = ANY, .fields = indices},
    {"extensions", .kind = OBJECT, .fields = primitive_extensions},
    {0},
};
static const field mesh[] = {
    {"name", .kind = TEXT},
    {"primitives", .kind = OBJECT, .count = ANY, .fields = primitive},
    {0},
};
static const field transform[] = {
    {"offset", .kind = NUMBER, .count = 2},
    {"rotation", .kind = NUMBER},
    {"scale", .kind = NUMBER, .count = 2},
    {"texCoord", .kind = INDEX},
    {0},
};
static const field use_extensions[] = {{"KHR_texture_transform", .kind = OBJECT, .fields = transform}, {0}};
static const field use_of_texture[] = {
    {"index", .kind = ITEM, .of = DMI_GLTF_TEXTURES},
    {"texCoord", .kind = INDEX},
    {"extensions", .kind = OBJECT, .fields = use_extensions},
    {0},
};
static const field surface[] = {
    {"baseColorFactor", .kind = FLOAT, .count = 4},
    {"baseColorTexture", .kind = OBJECT, .fields = use_of_texture},
    {0},
};
static const field material[] = {
    {"alphaMode", .kind = TEXT},
    {"pbrMetallicRoughness", .kind = OBJECT, .fields = surface},
    {0},
};
static const field source[] = {{"source", .kind = ITEM, .of = DMI_GLTF_IMAGES}, {0}};
static const field texture_extensions[] = {
    {"EXT_texture_webp", .kind = OBJECT, .fields = source},
    {"KHR_texture_basisu", .kind = OBJECT, .fields = source},
    {"MSFT_texture_dds", .kind = OBJECT, .fields = source},
    {0},
};
static const field texture[] = {
    {"source", .kind = ITEM, .of = DMI_GLTF_IMAGES},
    {"sampler", .kind = ITEM, .of = DMI_GLTF_SAMPLERS},
    {"extensions", .kind = OBJECT, .fields = texture_extensions},
    {0},
};
static const field sampler[] = {
    {"wrapS", .kind = WRAP},
    {"wrapT", .kind = WRAP},
    {0},
};
static const field image[] = {
    {"uri", .kind = TEXT},
    {"bufferView", .kind = INDEX},
    {0},
};
static const field skin[] = {
    {"joints", .kind = INDEX, .count = ANY},
    {"inverseBindMatrices", .kind = INDEX},
    {0},
};
static const field in_view[] = {{"bufferView", .kind = INDEX}, {0}};
static const field sparse[] = {
    {"indices", .kind = OBJECT, .fields = in_view},
    {"values", .kind = OBJECT, .fields = in_view},
    {0},
};
static const field accessor[] = {
    {"bufferView", .kind = INDEX},
    {"normalized", .kind = TRUTH},
    {"sparse", .kind = OBJECT, .fields = sparse},
    {0},
};
static const field compression[] = {
    {"buffer", .kind = INDEX},
    {"mode", .kind = TEXT},
    {"filter", .kind = TEXT},
    {0},
};
static const field view_extensions[] = {
    {"EXT_meshopt_compression", .kind = OBJECT, .fields = compression},
    {"KHR_meshopt_compression", .kind = OBJECT, .fields = compression},
    {0},
};
static const field view[] = {
    {"buffer", .kind = INDEX},
    {"extensions", .kind = OBJECT, .fields = view_extensions},
    {0},
};
static const field buffer[] = {{"uri", .kind = TEXT}, {0}};
static const field asset[] = {{"minVersion", .kind = TEXT}, {0}};
static const field root[] = {
    {"asset", .kind = OBJECT, .fields = asset},
    {"extensionsUsed", .kind = TEXT, .count = ANY},
    {"extensionsRequired", .kind = TEXT, .count = ANY},
    {"scene", .kind = ITEM, .of = DMI_GLTF_SCENES},
    {"scenes", .kind = OBJECT, .count = ANY, .fields = scene},
    {"nodes", .kind = OBJECT, .count = ANY, .fields = node},
    {"meshes", .kind = OBJECT, .count = ANY, .fields = mesh},
    {"materials", .kind = OBJECT, .count = ANY, .fields = material},
    {"textures", .kind = OBJECT, .count = ANY, .fields = texture},
    {"samplers", .kind = OBJECT, .count = ANY, .fields = sampler},
    {"images", .kind = OBJECT, .count = ANY, .fields = image},
    {"skins", .kind = OBJECT, .count = ANY, .fields = skin},
    {"accessors", .kind = OBJECT, .count = ANY, .fields = accessor},
    {"bufferViews", .kind = OBJECT, .count = ANY, .fields = view},
    {"buffers", .kind = OBJECT, .count = ANY, .fields = buffer},
    {0},
};

/* ---- places ---- */

/* The place of a field, or of an item of a list, in what holds it. */
typedef struct place {
    const struct place* in;
    const char* name;
    int index; /* index of an item; -1: the field itself */
} place;

/* Writes the place, such as nodes[3].scale. Returns its length. What does not fit is cut. */
static size_t write_place(const place* at, char* out, size_t size) {
    const size_t length = at->in ? write_place(at->in, out, size) : 0;
    const int more = at->index >= 0 ? snprintf(out + length, size - length, "[%d]", at->index)
                                    : snprintf(out + length, size - length, "%s%.40s", at->in ? "." : "", at->name);
    const size_t end = length + (size_t)more;
    return end < size ? end : size - 1;
}

/* Describes a value for a message. */
static void write_value(const cJSON* value, char* out, size_t size) {
    if (cJSON_IsNumber(value))
        snprintf(out, size, "%.17g", value->valuedouble);
    else if (cJSON_IsArray(value))
        snprintf(out, size, "a list of %d", cJSON_GetArraySize(value));
    else if (cJSON_IsBool(value))
        snprintf(out, size, cJSON_IsTrue(value) ? "true" : "false");
    else
        snprintf(out, size, "%s", cJSON_IsString(value) ? "a text" : cJSON_IsObject(value) ? "an object" : "null");
}

static dm_result refuse_field(const place* at, const char* must, const cJSON* value, dmi_gltf_problem* problem) {
    char name[192], is[40];
    write_place(at, name, sizeof name);
    write_value(value, is, sizeof is);
    return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "glTF: %s must be %s, not %s", name, must, is);
}

/* ---- values ---- */

static int is_number(const cJSON* value) {
    return cJSON_IsNumber(value) && isfinite(value->valuedouble);
}

static int is_index(const cJSON* value) {
    return is_number(value) && value->valuedouble >= 0 && value->valuedouble == floor(value->valuedouble) &&
           value->valuedouble <= UINT32_MAX;
}

static int is_wrap(const cJSON* value) {
    return cJSON_IsNumber(value) &&
           (value->valuedouble == DM_GLTF_WRAP_REPEAT || value->valuedouble == DM_GLTF_WRAP_CLAMP ||
            value->valuedouble == DM_GLTF_WRAP_MIRROR);
}

/* Returns what the number at `index` of a matrix must be, or -1 for any. A matrix that was written row by row has
 * others there. */
static int last_of_column(int index) {
    return index % COLUMN != COLUMN - 1 ? -1 : index == CELLS - 1;
}

/* ---- the walk ---- */

typedef struct checker {
    const dmi_gltf_document* document;
    dmi_gltf_problem* problem;
} checker;

static dm_result check_members(const checker* c, const field* fields, const cJSON* object, const place* at);

static dm_result check_cell(const checker* c, const cJSON* value, const place* at) {
    const int must = last_of_column(at->index);
    if (!is_number(value)) return refuse_field(at, "a number", value, c->problem);
    if (must < 0 || fabs(value->valuedouble - must) <= ROW_ERROR) return DM_OK;
    return refuse_field(at, must ? "1, as the last column ends" : "0, as columns end", value, c->problem);
}

static dm_result check_item(const checker* c, const field* f, const cJSON* value, const place* at) {
    const uint32_t count = c->document->counts[f->of];
    char must[64];
    if (is_index(value) && value->valuedouble < count) return DM_OK;
    snprintf(must, sizeof must, "the index of one of %u %s", count, dmi_gltf_list_names[f->of]);
    return refuse_field(at, must, value, c->problem);
}

static dm_result check_value(const checker* c, const field* f, const cJSON* value, const place* at) {
    switch (f->kind) {
    case OBJECT:
        if (cJSON_IsObject(value)) return check_members(c, f->fields, value, at);
        return refuse_field(at, "an object", value, c->problem);
    case TEXT:
        return cJSON_IsString(value) ? DM_OK : refuse_field(at, "a text", value, c->problem);
    case TRUTH:
        return cJSON_IsBool(value) ? DM_OK : refuse_field(at, "true or false", value, c->problem);
    case NUMBER:
        return is_number(value) ? DM_OK : refuse_field(at, "a number", value, c->problem);
    case FLOAT:
        if (is_number(value) && fabs(value->valuedouble) <= FLT_MAX) return DM_OK;
        return refuse_field(at, "a number that a float holds", value, c->problem);
    case WRAP:
        return is_wrap(value) ? DM_OK : refuse_field(at, "10497, 33071 or 33648", value, c->problem);
    case CELL:
        return check_cell(c, value, at);
    case INDEX:
        return is_index(value) ? DM_OK : refuse_field(at, "an index", value, c->problem);
    default:
        return check_item(c, f, value, at);
    }
}

static dm_result check_field(const checker* c, const field* f, const cJSON* value, const place* in) {
    const place at = {in, value->string, -1};
    place item_at = {&at, NULL, 0};
    const cJSON* item;
    char must[32] = "a list";
    if (f->count == 0) return check_value(c, f, value, &at);
    if (f->count > 0) snprintf(must, sizeof must, "a list of %d", f->count);
    if (!cJSON_IsArray(value) || (f->count > 0 && cJSON_GetArraySize(value) != f->count))
        return refuse_field(&at, must, value, c->problem);
    cJSON_ArrayForEach(item, value) {
        const dm_result result = check_value(c, f, item, &item_at);
        if (result != DM_OK) return result;
        item_at.index++;
    }
    return DM_OK;
}

static dm_result check_beside(const checker* c, const field* f, const cJSON* object, const place* in) {
    if (!f->not_beside || !dmi_json_get(object, f->not_beside)) return DM_OK;
    char name[192];
    const place at = {in, f->name, -1};
    write_place(&at, name, sizeof name);
    return dmi_gltf_refuse(c->problem, DM_ERROR_BAD_DATA, "glTF: %s must not stand beside %s", name, f->not_beside);
}

static dm_result check_members(const checker* c, const field* fields, const cJSON* object, const place* at) {
    dm_result result = DM_OK;
    for (const field* f = fields; f->name && result == DM_OK; f++) {
        const int each = strcmp(f->name, EACH) == 0;
        const cJSON* member = each ? object->child : dmi_json_get(object, f->name);
        for (; member && result == DM_OK; member = each ? member->next : NULL) {
            result = check_field(c, f, member, at);
            if (result == DM_OK) result = check_beside(c, f, object, at);
        }
    }
    return result;
}

dm_result dmi_gltf_check_fields(const dmi_gltf_document* document, dmi_gltf_problem* problem) {
    const checker c = {document, problem};
    return check_members(&c, root, document->root, NULL);
}
