/* dragmesh_generate: writes one generated object as object.glb and joints.json, or as an asset of many nodes with
 * asset.json, draws contact sheets of many, checks
 * them, and measures how fast they are made.
 * joints.json: the object's fields, then for every joint its line, limits, moving nodes and three exact drags. */
#include <cjson/cJSON.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "../../samples/common/output_file.h"
#include "asset_file.h"
#include "bench.h"
#include "check_all.h"
#include "dragmesh/ext/gltf.h"
#include "generator.h"
#include "sheet.h"

enum { CATEGORY_LIMIT = 512 };

typedef struct options {
    const char* folder; /* or file */
    uint64_t seed;
    uint32_t flags, columns;
    enum { MAKE, LIST, SHEET, BENCH, CHECK } mode;
    int seeded, verbose, asset;
    uint32_t categories[CATEGORY_LIMIT], count;
} options;

static int usage(FILE* to) {
    fputs("usage: dragmesh_generate --list\n"
          "       dragmesh_generate --category NAME --seed N [--messy] [--asset] -o DIR\n"
          "       dragmesh_generate --sheet -o PICTURE.png [--category NAME]... [--columns N] [--seed N] [--messy] "
          "[--asset]\n"
          "       dragmesh_generate --bench [--category NAME]... [--messy]\n"
          "       dragmesh_generate --check [--category NAME]... [--columns OBJECTS] [--seed N] [--verbose]\n",
          to);
    return 2;
}

static int parse_number(const char* name, const char* text, uint64_t most, uint64_t* out) {
    char* end;
    errno = 0;
    *out = strtoull(text, &end, 10);
    if (!*end && end != text && !errno && *text != '-' && *out <= most) return 1;
    fprintf(stderr, "dragmesh_generate: %s %s is not a number it takes\n", name, text);
    return 0;
}

static int parse_category(const char* name, options* out) {
    const int32_t category = dmg_category_find(name);
    if (category >= 0 && out->count < CATEGORY_LIMIT) {
        out->categories[out->count++] = (uint32_t)category;
        return 1;
    }
    fprintf(stderr, "dragmesh_generate: no category '%s' (see --list)\n", name);
    return 0;
}

/* One argument with its value; 0 when it is neither known nor whole. */
static int parse_value(const char* name, const char* value, options* out) {
    uint64_t number = 0;
    if (strcmp(name, "--category") == 0) return parse_category(value, out);
    if (strcmp(name, "-o") == 0) {
        out->folder = value;
        return 1;
    }
    if (strcmp(name, "--seed") == 0) {
        out->seeded = 1;
        return parse_number(name, value, UINT64_MAX, &out->seed);
    }
    if (strcmp(name, "--columns") == 0) {
        const int ok = parse_number(name, value, 64, &number);
        out->columns = number > 0 ? (uint32_t)number : 1;
        return ok;
    }
    fprintf(stderr, "dragmesh_generate: unknown or incomplete argument %s\n", name);
    return 0;
}

static int parse(int count, char** arguments, options* out) {
    out->columns = 4;
    for (int i = 1; i < count; ++i) {
        const char* a = arguments[i];
        if (strcmp(a, "--list") == 0)
            out->mode = LIST;
        else if (strcmp(a, "--sheet") == 0)
            out->mode = SHEET;
        else if (strcmp(a, "--asset") == 0)
            out->asset = 1;
        else if (strcmp(a, "--bench") == 0)
            out->mode = BENCH;
        else if (strcmp(a, "--check") == 0)
            out->mode = CHECK;
        else if (strcmp(a, "--verbose") == 0)
            out->verbose = 1;
        else if (strcmp(a, "--messy") == 0)
            out->flags |= DMG_MESSY;
        else if (!parse_value(a, i + 1 < count ? arguments[i + 1] : "", out))
            return 0;
        else
            ++i;
    }
    if (out->mode == MAKE) return out->count == 1 && out->folder && out->seeded;
    return out->mode != SHEET || out->folder;
}

/* ---- joints.json ---- */

static const char* type_name(int32_t type) {
    if (type == DM_JOINT_PRISMATIC) return "prismatic";
    return type == DM_JOINT_SCREW ? "screw" : "revolute"; /* continuous is a revolute joint with a mark */
}

static int is_carried(const dmg_object* object, uint32_t part, uint32_t carrier) {
    while (part != 0 && part != carrier) part = object->joints[part - 1].parent;
    return part == carrier;
}

/* Joints that were made by the same call share their name up to a running number. */
static size_t stem_length(const char* name) {
    size_t length = strlen(name), end = length;
    while (end > 0 && name[end - 1] >= '0' && name[end - 1] <= '9') --end;
    return end > 0 && end < length && name[end - 1] == '_' ? end - 1 : length;
}

static int alike(const dmg_joint* a, const dmg_joint* b) {
    size_t length = stem_length(a->name);
    return a->type == b->type && length == stem_length(b->name) && strncmp(a->name, b->name, length) == 0;
}

static void add_repeats(cJSON* out, const dmg_object* object, uint32_t joint) {
    uint32_t first = joint, size = 0;
    for (uint32_t i = object->joint_count; i-- > 0;) {
        if (!alike(&object->joints[i], &object->joints[joint])) continue;
        first = i;
        ++size;
    }
    cJSON_AddBoolToObject(out, "multi_dof", 0);
    cJSON_AddNumberToObject(out, "repeat_group", first);
    cJSON_AddNumberToObject(out, "weight", 1.0 / size);
}

static const char* rest_place(const dmg_joint* joint) {
    float range = joint->upper - joint->lower;
    if (joint->type == DM_JOINT_CONTINUOUS || range <= 0.0f) return "unknown";
    float at = -joint->lower / range;
    if (at < -0.001f || at > 1.001f) return "outside";
    return at < 0.07f ? "lower" : (at > 0.93f ? "upper" : "inside");
}

static cJSON* numbers(const float* values, int count) {
    cJSON* array = cJSON_CreateArray();
    for (int i = 0; i < count; ++i) cJSON_AddItemToArray(array, cJSON_CreateNumber((double)values[i]));
    return array;
}

/* Three exact drags, a tenth of the object long. */
static void add_drags(cJSON* out, const dmg_object* object, uint32_t part, uint64_t seed, float size) {
    cJSON* drags = cJSON_AddArrayToObject(out, "drags");
    for (uint64_t i = 0; i < 3; ++i) {
        float point[3], vector[3], length = 0.0f;
        dmg_drag(object, part, 0.0f, seed * 3 + i, point, vector);
        for (int k = 0; k < 3; ++k) length += vector[k] * vector[k];
        for (int k = 0; k < 3; ++k) vector[k] *= 0.1f * size / sqrtf(length);
        cJSON* drag = cJSON_CreateObject();
        cJSON_AddItemToObject(drag, "point", numbers(point, 3));
        cJSON_AddItemToObject(drag, "vector", numbers(vector, 3));
        cJSON_AddItemToArray(drags, drag);
    }
}

static cJSON* joint_json(const dmg_object* object, uint32_t index, uint64_t seed, float size) {
    const dmg_joint* joint = &object->joints[index];
    cJSON* out = cJSON_CreateObject();
    cJSON_AddStringToObject(out, "name", joint->name);
    cJSON_AddStringToObject(out, "type", type_name(joint->type));
    if (joint->type == DM_JOINT_CONTINUOUS) cJSON_AddBoolToObject(out, "continuous", 1);
    if (joint->type == DM_JOINT_SCREW) cJSON_AddNumberToObject(out, "pitch", (double)joint->pitch);
    cJSON_AddStringToObject(out, "part", joint->name);
    cJSON_AddStringToObject(out, "parent", joint->parent ? object->joints[joint->parent - 1].name : "body");
    cJSON_AddStringToObject(out, "child", joint->name);
    cJSON* nodes = cJSON_AddArrayToObject(out, "moving_nodes");
    for (uint32_t i = 0; i < object->joint_count; ++i) {
        if (is_carried(object, i + 1, index + 1))
            cJSON_AddItemToArray(nodes, cJSON_CreateString(object->joints[i].name));
    }
    cJSON_AddItemToObject(out, "axis", numbers(joint->axis, 3));
    cJSON_AddItemToObject(out, "origin", numbers(joint->origin, 3));
    if (joint->type == DM_JOINT_CONTINUOUS) {
        cJSON_AddNullToObject(out, "lower");
        cJSON_AddNullToObject(out, "upper");
    } else {
        cJSON_AddNumberToObject(out, "lower", (double)joint->lower);
        cJSON_AddNumberToObject(out, "upper", (double)joint->upper);
    }
    cJSON_AddStringToObject(out, "rest_at", rest_place(joint));
    cJSON_AddNumberToObject(out, "drag_sign", joint->opens);
    add_drags(out, object, index + 1, seed, size);
    add_repeats(out, object, index);
    return out;
}

static char* object_json(const dmg_object* object, const options* options) {
    char name[96];
    float size = dmg_object_size(object);
    snprintf(name, sizeof name, "%s_%llu%s", object->category, (unsigned long long)options->seed,
             options->flags & DMG_MESSY ? "_messy" : "");
    cJSON* root = cJSON_CreateObject();
    cJSON_AddStringToObject(root, "object", name);
    cJSON_AddStringToObject(root, "source", "dragmesh_generate");
    cJSON_AddStringToObject(root, "path", "training/generator");
    cJSON_AddStringToObject(root, "license", "MIT");
    cJSON_AddStringToObject(root, "category", object->category);
    cJSON_AddStringToObject(root, "family", object->category);
    cJSON_AddStringToObject(root, "up", options->flags & DMG_MESSY ? "unknown" : "y");
    cJSON_AddStringToObject(root, "units", "m");
    cJSON_AddNumberToObject(root, "triangles", object->face_count);
    cJSON_AddNumberToObject(root, "largest_dimension", (double)size);
    cJSON* joints = cJSON_AddArrayToObject(root, "joints");
    for (uint32_t i = 0; i < object->joint_count; ++i) {
        cJSON_AddItemToArray(joints, joint_json(object, i, options->seed, size));
    }
    char* text = cJSON_Print(root);
    cJSON_Delete(root);
    return text;
}

/* ---- object.glb ---- */

/* One node: the faces of a part, with the vertices they use. Returns 0 when there is no memory. */
static int extract_part(const dmg_object* object, uint32_t part, dm_gltf_part* out) {
    uint32_t* remap = malloc(object->vertex_count * sizeof *remap);
    uint32_t* indices = malloc((size_t)object->face_count * 3 * sizeof *indices);
    float* positions = malloc((size_t)object->vertex_count * 3 * sizeof *positions);
    out->indices = indices;
    out->positions = positions;
    if (!remap || !indices || !positions) {
        free(remap);
        return 0;
    }
    memset(remap, 0xff, object->vertex_count * sizeof *remap);
    for (uint32_t i = 0; i < object->face_count * 3; ++i) {
        if (object->face_part[i / 3] != part) continue;
        uint32_t v = object->indices[i];
        if (remap[v] == UINT32_MAX) {
            memcpy(positions + 3 * out->vertex_count, object->positions + 3 * (size_t)v, 3 * sizeof(float));
            remap[v] = (uint32_t)out->vertex_count++;
        }
        indices[out->index_count++] = remap[v];
    }
    free(remap);
    return 1;
}

static int has_faces(const dmg_object* object, uint32_t part) {
    uint32_t f = 0;
    while (f < object->face_count && object->face_part[f] != part) ++f;
    return f < object->face_count;
}

static int write_glb(const dmg_object* object, void** data, size_t* size) {
    static const float palette[7][3] = {{0.72f, 0.16f, 0.1f}, {0.12f, 0.35f, 0.75f}, {0.15f, 0.5f, 0.15f},
                                        {0.8f, 0.5f, 0.1f},   {0.45f, 0.2f, 0.6f},   {0.1f, 0.55f, 0.55f},
                                        {0.75f, 0.3f, 0.5f}};
    uint32_t count = object->joint_count + 1, nodes = 0;
    dm_gltf_part* parts = calloc(count, sizeof *parts);
    int ok = parts != NULL;
    for (uint32_t i = 0; i < count && ok; ++i) {
        if (!has_faces(object, i)) continue; /* such as the body of leaves without a frame */
        dm_gltf_part* part = &parts[nodes];
        const float* colour = palette[(i + 6) % 7];
        part->name = i == 0 ? "body" : object->joints[i - 1].name;
        for (int k = 0; k < 3; ++k) part->colour[k] = i == 0 ? 0.6f : colour[k];
        part->colour[3] = 1.0f;
        ok = extract_part(object, i, part);
        ++nodes;
    }
    ok = ok && dm_gltf_write(parts, nodes, NULL, NULL, data, size) == DM_OK;
    for (uint32_t i = 0; i < nodes; ++i) {
        free((void*)parts[i].positions);
        free((void*)parts[i].indices);
    }
    free(parts);
    return ok;
}

/* ---- files ---- */

enum { PATH_ROOM = 4096 };

static int join(const char* folder, const char* name, char path[PATH_ROOM]) {
    if (snprintf(path, PATH_ROOM, "%s/%s", folder, name) < PATH_ROOM) return 1;
    fprintf(stderr, "dragmesh_generate: the path of %s is too long\n", name);
    return 0;
}

/* Writes the object and what is known of it, both or none. */
static int write_files(const char* folder, const void* glb, size_t size, const char* json_name, const char* json) {
    char glb_path[PATH_ROOM], json_path[PATH_ROOM];
    if (!join(folder, "object.glb", glb_path) || !join(folder, json_name, json_path)) return 0;
    const output_bytes files[2] = {{glb_path, glb, size}, {json_path, json, strlen(json)}};
    int failed;
    if (output_write_all(files, 2, &failed) == 0) return 1;
    fprintf(stderr, "dragmesh_generate: can't write %s: %s\n", files[failed].path, strerror(errno));
    return 0;
}

/* mkdir -p */
static int make_folder(const char* folder) {
    char path[4096];
    size_t length = strlen(folder);
    if (length >= sizeof path) return 0;
    memcpy(path, folder, length + 1);
    for (size_t i = 1; i <= length; ++i) {
        if (path[i] != '/' && path[i] != '\0') continue;
        path[i] = '\0';
        if (mkdir(path, 0777) != 0 && errno != EEXIST) {
            fprintf(stderr, "dragmesh_generate: can't make folder %s: %s\n", path, strerror(errno));
            return 0;
        }
        path[i] = i < length ? '/' : '\0';
    }
    return 1;
}

static int generate(const options* options) {
    dmg_object object;
    if (dmg_make(options->categories[0], options->seed, options->flags, &object) != 0) {
        fprintf(stderr, "dragmesh_generate: out of memory\n");
        return 1;
    }
    void* glb = NULL;
    size_t size = 0;
    char* json = object_json(&object, options);
    int ok = json && write_glb(&object, &glb, &size);
    if (!ok)
        fprintf(stderr, "dragmesh_generate: %s seed %llu could not be encoded\n", object.category,
                (unsigned long long)options->seed);
    ok = ok && make_folder(options->folder) && write_files(options->folder, glb, size, "joints.json", json);
    free(glb);
    free(json);
    dmg_object_release(&object);
    return ok ? 0 : 1;
}

static int generate_asset(const options* options) {
    dmg_asset asset;
    if (dmg_make_asset(options->categories[0], options->seed, options->flags, &asset) != 0) {
        fprintf(stderr, "dragmesh_generate: out of memory\n");
        return 1;
    }
    size_t size = 0;
    void* glb = asset_glb(&asset, &size);
    char* json = asset_json(&asset, options->seed, options->flags);
    int ok = glb && json;
    if (!ok) fprintf(stderr, "dragmesh_generate: out of memory\n");
    ok = ok && make_folder(options->folder) && write_files(options->folder, glb, size, "asset.json", json);
    free(glb);
    free(json);
    dmg_asset_release(&asset);
    return ok ? 0 : 1;
}

static int list(void) {
    for (uint32_t i = 0; i < dmg_category_count(); ++i) puts(dmg_category_name(i));
    return 0;
}

int main(int count, char** arguments) {
    options options = {0};
    for (int i = 1; i < count; ++i) {
        if (strcmp(arguments[i], "--help") != 0 && strcmp(arguments[i], "-h") != 0) continue;
        usage(stdout);
        return 0;
    }
    if (!parse(count, arguments, &options)) return usage(stderr);
    if (options.mode == LIST) return list();
    if (options.mode == MAKE) return options.asset ? generate_asset(&options) : generate(&options);
    const int all = options.count == 0;
    for (uint32_t i = 0; all && i < dmg_category_count() && i < CATEGORY_LIMIT; ++i)
        options.categories[options.count++] = i;
    if (options.mode == BENCH) return bench(options.categories, options.count, options.flags);
    if (options.mode == CHECK)
        return check_all(options.categories, options.count, options.columns, options.seed, options.verbose);
    return sheet_write(options.folder, options.categories, options.count, options.columns, options.seed, options.flags,
                       options.asset) == 0
               ? 0
               : 1;
}
