/* dm_gltf_open_file: what lies in the file's folder is read, nothing else is; which names mean which file; what becomes
 * of data: URIs, and of images beside the file when it is written elsewhere. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cjson/cJSON.h>

#include "base/utf8.h"
#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

enum { PATH = 512, TEXT = 4096 };

static char folder[64];

static char* in_folder(const char* name) {
    static char paths[4][PATH];
    static int next;
    char* path = paths[next++ % 4];
    snprintf(path, PATH, "%s/%s", folder, name);
    return path;
}

static void write_file(const char* name, const void* data, size_t size) {
    FILE* file = fopen(in_folder(name), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, size, file), size);
    fclose(file);
}

static const float triangle[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

#define REST                                                                                                           \
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"      \
    "\"count\":3,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"               \
    "\"nodes\":[{\"mesh\":0}]}"

/* A document whose buffer has this URI, in the file `name` of the folder. */
static void write_document(const char* name, const char* uri, int length) {
    char* json = malloc(strlen(uri) + TEXT);
    sprintf(json, "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%d,\"uri\":\"%s\"}]," REST, length,
            uri);
    write_file(name, json, strlen(json));
    free(json);
}

static int make_folder(void** state) {
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/dragmesh_folder_XXXXXX");
    if (!mkdtemp(folder)) return -1;
    const char* const folders[] = {"in", "in/parts", "inside", "in/deep"};
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++)
        if (mkdir(in_folder(folders[i]), 0700) != 0) return -1;
    write_file("in/x.bin", triangle, sizeof triangle);
    write_file("in/parts/y.bin", triangle, sizeof triangle);
    write_file("inside/z.bin", triangle, sizeof triangle);
    write_file("out.bin", triangle, sizeof triangle);
    return 0;
}

static int remove_folder(void** state) {
    (void)state;
    char command[PATH + 16];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    return system(command);
}

typedef struct opened {
    test_env t;
    dm_gltf* gltf;
    dm_result result;
} opened;

static void open_path(opened* o, const char* path, int64_t fail_at) {
    memset(o, 0, sizeof *o);
    test_env_open(&o->t, fail_at);
    const dm_gltf_desc desc = {
        .struct_size = sizeof desc, .allocator = test_allocator(&o->t.memory), .log = test_log(&o->t.messages)};
    o->result = dm_gltf_open_file(path, &desc, &o->gltf);
}

/* Opens, asks for the result, and closes. says: what the message holds. */
static void expect(const char* path, dm_result result, const char* says) {
    opened o;
    open_path(&o, path, TEST_NEVER);
    if (o.result != result || (says && !strstr(o.t.messages.text, says)))
        fail_msg("%s: %d '%s', not %d '%s'", path, o.result, o.t.messages.text, result, says ? says : "");
    if (result == DM_OK) {
        dm_mesh_desc mesh;
        assert_int_equal(dm_gltf_get_mesh(o.gltf, &mesh), DM_OK);
        assert_int_equal(mesh.vertex_count, 3);
        assert_memory_equal(mesh.positions, triangle, sizeof triangle);
    }
    dm_gltf_close(o.gltf);
    test_env_close(&o.t);
}

/* ---- which file ---- */

static void names_of_files_beside(void** state) {
    (void)state;
    static const struct {
        const char* uri;
        dm_result result;
        const char* says;
    } uris[] = {{"x.bin", DM_OK, NULL},
                {"./x.bin", DM_OK, NULL},
                {"././x.bin", DM_OK, NULL},
                {"parts/y.bin", DM_OK, NULL},
                {"parts/./y.bin", DM_OK, NULL},
                {"parts%2Fy.bin", DM_OK, NULL},
                {"parts%2fy.bin", DM_OK, NULL},
                {"%78%2eb%69n", DM_OK, NULL},
                {"a b.bin", DM_OK, NULL},
                {"a%20b.bin", DM_OK, NULL},
                {"%zz.bin", DM_OK, NULL},
                {"%4.bin", DM_OK, NULL},
                {"..x.bin", DM_OK, NULL},
                {"x..", DM_OK, NULL},
                {"X.bin", DM_ERROR_NOT_FOUND, "the file 'X.bin' is not there"},
                {"parts/x.bin", DM_ERROR_NOT_FOUND, "is not there"},
                {"parts", DM_ERROR_NOT_FOUND, "is not there"},
                {"../out.bin", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"parts/../x.bin", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"parts/../../out.bin", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"%2e%2e/out.bin", DM_ERROR_BAD_DATA, "'%2e%2e/out.bin' is no file beside this one"},
                {"..%2Fout.bin", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"..", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {".", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"/x.bin", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"parts//y.bin", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"parts/", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"c:x.bin", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"https://host/x.bin", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"parts%5Cy.bin", DM_ERROR_BAD_DATA, "is no file beside this one"},
                {"x.bin%00", DM_ERROR_BAD_DATA, "'x.bin%00' holds %00"},
                {"x.bin%00.png", DM_ERROR_BAD_DATA, "holds %00"},
                {"%00x.bin", DM_ERROR_BAD_DATA, "holds %00"},
                {"parts/%00/../y.bin", DM_ERROR_BAD_DATA, "holds %00"},
                {"x.bin\\u0000", DM_ERROR_BAD_DATA, "zero byte"},
                {"x.bin\\u0000.png", DM_ERROR_BAD_DATA, "zero byte"},
                {"\\u0000x.bin", DM_ERROR_BAD_DATA, "zero byte"}};
    static const char* const odd[] = {"in/a b.bin", "in/%zz.bin", "in/%4.bin", "in/..x.bin", "in/x.."};
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++) write_file(odd[i], triangle, sizeof triangle);
    for (size_t i = 0; i < sizeof uris / sizeof *uris; i++) {
        write_document("in/a.gltf", uris[i].uri, sizeof triangle);
        expect(in_folder("in/a.gltf"), uris[i].result, uris[i].says);
    }
}

/* Schemes and their words count in any case of letters. */
static void schemes_in_any_case(void** state) {
    (void)state;
    static const char* const heads[] = {"data:application/octet-stream;base64,",
                                        "DATA:application/octet-stream;BASE64,", "Data:;Base64,",
                                        "dAtA:x;charset=y;bAsE64,"};
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        char uri[128];
        snprintf(uri, sizeof uri, "%sAAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA", heads[i]); /* the triangle */
        write_document("in/a.gltf", uri, sizeof triangle);
        expect(in_folder("in/a.gltf"), DM_OK, NULL);
    }
    write_document("in/a.gltf", "DATA:text/plain,hello", sizeof triangle);
    expect(in_folder("in/a.gltf"), DM_ERROR_UNSUPPORTED, "not base64");
    write_document("in/a.gltf", "HTTP://host/x.bin", sizeof triangle);
    expect(in_folder("in/a.gltf"), DM_ERROR_BAD_DATA, "is no file beside this one");
}

/* Messages show the beginning of a long URI, whatever is wrong with it, and are whole UTF-8. */
static void messages_do_not_echo_long_uris(void** state) {
    (void)state;
    static const char* const heads[] = {"",     "../",      "http://",      "data:", "data:;base64,*",
                                        "x%00", "\xc3\xa9", "z\xe2\x82\xac"};
    enum { LONG = 100000 };
    char* uri = malloc(LONG + 64);
    assert_non_null(uri);
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        const char* unit = i >= 6 ? heads[i] : "x";
        size_t length = (size_t)sprintf(uri, "%s", heads[i]);
        while (length < LONG) length += (size_t)sprintf(uri + length, "%s", unit);
        write_document("in/a.gltf", uri, sizeof triangle);
        opened o;
        open_path(&o, in_folder("in/a.gltf"), TEST_NEVER);
        assert_int_not_equal(o.result, DM_OK);
        if (strlen(o.t.messages.text) > 200 || !strstr(o.t.messages.text, "…'") ||
            !dmi_utf8_is_valid(o.t.messages.text, strlen(o.t.messages.text)))
            fail_msg("%zu bytes: %.300s", strlen(o.t.messages.text), o.t.messages.text);
        test_env_close(&o.t);
    }
    free(uri);
}

/* Links are followed where they stay in the folder; beginning like its name is not enough. */
static void links_do_not_lead_out(void** state) {
    (void)state;
    static const struct {
        const char *link, *to;
        dm_result result;
    } links[] = {{"in/near.bin", "x.bin", DM_OK},
                 {"in/below.bin", "parts/y.bin", DM_OK},
                 {"in/there_and_back.bin", "../in/x.bin", DM_OK},
                 {"in/out.bin", "../out.bin", DM_ERROR_NOT_FOUND},
                 {"in/other.bin", "../inside/z.bin", DM_ERROR_NOT_FOUND},
                 {"in/nowhere.bin", "gone.bin", DM_ERROR_NOT_FOUND},
                 {"in/ring.bin", "ring.bin", DM_ERROR_NOT_FOUND}};
    for (size_t i = 0; i < sizeof links / sizeof *links; i++) {
        assert_int_equal(symlink(links[i].to, in_folder(links[i].link)), 0);
        write_document("in/b.gltf", links[i].link + 3, sizeof triangle);
        expect(in_folder("in/b.gltf"), links[i].result, links[i].result == DM_OK ? NULL : "is not there");
    }
    write_document("in/b.gltf", "x.bin", sizeof triangle);
    assert_int_equal(symlink("in", in_folder("linked")), 0); /* the folder's own name may be a link */
    expect(in_folder("linked/b.gltf"), DM_OK, NULL);
}

static void the_folder_of_a_bare_name_is_the_current_one(void** state) {
    (void)state;
    char before[PATH];
    assert_non_null(getcwd(before, sizeof before));
    write_document("in/c.gltf", "x.bin", sizeof triangle);
    assert_int_equal(chdir(in_folder("in")), 0);
    expect("c.gltf", DM_OK, NULL);
    expect("./c.gltf", DM_OK, NULL);
    expect("parts/../c.gltf", DM_OK, NULL);
    assert_int_equal(chdir(before), 0);
}

static void what_is_no_file_is_named(void** state) {
    (void)state;
    char* deep = malloc(20000);
    memset(deep, 'a', 19999);
    deep[19999] = 0;
    write_file("in/empty.gltf", "", 0);
    assert_int_equal(mkfifo(in_folder("in/pipe.gltf"), 0600), 0);
    expect(in_folder("in/none.gltf"), DM_ERROR_NOT_FOUND, strerror(ENOENT));
    expect(in_folder("in/parts"), DM_ERROR_NOT_FOUND, strerror(EISDIR));
    expect(in_folder("in/empty.gltf"), DM_ERROR_BAD_DATA, "is empty");
    expect(in_folder("in/pipe.gltf"), DM_ERROR_NOT_FOUND, "it is a pipe or a device, not a file");
    expect(deep, DM_ERROR_NOT_FOUND, "can't read");
    expect(in_folder("in/x.bin"), DM_ERROR_BAD_DATA, "not a GLB");
    for (int kind = 0; kind < 2; kind++) { /* a pipe, and nothing, where a buffer should be */
        write_document("in/d.gltf", kind ? "pipe.gltf" : "none.bin", sizeof triangle);
        expect(in_folder("in/d.gltf"), DM_ERROR_NOT_FOUND, "is not there");
    }
    write_document("in/d.gltf", deep, sizeof triangle);
    expect(in_folder("in/d.gltf"), DM_ERROR_NOT_FOUND, "is not there");
    write_document("in/d.gltf", "x.bin", sizeof triangle + 1);
    expect(in_folder("in/d.gltf"), DM_ERROR_BAD_DATA, "byteLength is 37, its binary size 36");
    write_document("in/d.gltf", "x.bin", sizeof triangle - 1);
    expect(in_folder("in/d.gltf"), DM_ERROR_BAD_DATA, "leaves its buffer of 35");
    free(deep);
}

static int32_t DM_CALL open_nothing(void* user, const char* path, const void** out_data, size_t* out_size) {
    (void)user, (void)path, (void)out_data, (void)out_size;
    return DM_ERROR_NOT_FOUND;
}

static void DM_CALL close_nothing(void* user, const void* data, size_t size) {
    (void)user, (void)data, (void)size;
}

static void the_path_stands_for_bytes_and_files(void** state) {
    (void)state;
    test_env t;
    dm_gltf* gltf = NULL;
    test_env_open(&t, TEST_NEVER);
    write_document("in/e.gltf", "x.bin", sizeof triangle);
    const char* path = in_folder("in/e.gltf");
    const dm_gltf_desc good = {
        .struct_size = sizeof good, .allocator = test_allocator(&t.memory), .log = test_log(&t.messages)};
    dm_gltf_desc desc = good;
    assert_int_equal(dm_gltf_open_file(NULL, &desc, &gltf), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_open_file(path, NULL, &gltf), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_open_file(path, &desc, NULL), DM_ERROR_INVALID_ARGUMENT);
    desc.data = "x", desc.size = 1;
    assert_int_equal(dm_gltf_open_file(path, &desc, &gltf), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(t.messages.text, "the file's name stands for it"));
    desc = good;
    desc.files = (dm_gltf_files){NULL, open_nothing, close_nothing};
    assert_int_equal(dm_gltf_open_file(path, &desc, &gltf), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(t.messages.text, "the folder stands for them"));
    desc.files.close = NULL;
    assert_int_equal(dm_gltf_open_file(path, &desc, &gltf), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(t.messages.text, "files: both functions or none"));
    desc = good;
    desc.allocator.release = NULL;
    assert_int_equal(dm_gltf_open_file(path, &desc, &gltf), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(t.messages.text, "allocator: both functions or none"));
    desc = good;
    desc.struct_size = 8;
    assert_int_equal(dm_gltf_open_file(path, &desc, &gltf), DM_ERROR_STRUCT_SIZE);
    desc = good; /* as callers have it that were built before there was progress */
    desc.struct_size = offsetof(dm_gltf_desc, progress);
    assert_int_equal(dm_gltf_open_file(path, &desc, &gltf), DM_OK);
    dm_gltf_close(gltf);
    gltf = NULL;
    desc.struct_size--;
    assert_int_equal(dm_gltf_open_file(path, &desc, &gltf), DM_ERROR_STRUCT_SIZE);
    desc = good;
    assert_int_equal(dm_gltf_open(&desc, &gltf), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(t.messages.text, "dm_gltf_desc.data is empty"));
    assert_null(gltf);
    test_env_close(&t);
}

static void a_file_beside_needs_somebody_who_opens_it(void** state) {
    (void)state;
    test_env t;
    dm_gltf* gltf = NULL;
    char json[TEXT];
    test_env_open(&t, TEST_NEVER);
    snprintf(json, sizeof json,
             "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36,\"uri\":\"x.bin\"}]," REST);
    dm_gltf_desc desc = {.struct_size = sizeof desc,
                         .data = json,
                         .size = strlen(json),
                         .allocator = test_allocator(&t.memory),
                         .log = test_log(&t.messages)};
    assert_int_equal(dm_gltf_open(&desc, &gltf), DM_ERROR_NOT_FOUND);
    assert_non_null(strstr(t.messages.text, "'x.bin' lies beside the file; dm_gltf_desc.files hands it over"));
    desc.files = (dm_gltf_files){NULL, open_nothing, close_nothing};
    assert_int_equal(dm_gltf_open(&desc, &gltf), DM_ERROR_NOT_FOUND);
    assert_non_null(strstr(t.messages.text, "the file 'x.bin' is not there"));
    test_env_close(&t);
}

static void every_allocation_may_fail(void** state) {
    (void)state;
    write_document("in/f.gltf", "parts/y.bin", sizeof triangle);
    int64_t n = 0;
    for (dm_result result = DM_ERROR_OUT_OF_MEMORY; result != DM_OK; n++) {
        opened o;
        open_path(&o, in_folder("in/f.gltf"), n);
        result = o.result;
        assert_int_equal(result, o.t.memory.calls > n ? DM_ERROR_OUT_OF_MEMORY : DM_OK);
        if (result != DM_OK) assert_non_null(strstr(o.t.messages.text, "no memory"));
        dm_gltf_close(o.gltf);
        test_env_close(&o.t);
    }
    assert_true(n > 20);
}

/* ---- data: URIs ---- */

static void base64_of_any_bytes_and_length(void** state) {
    (void)state;
    static const char* const alphabets[] = {"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/",
                                            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_"};
    enum { MOST = 600 };
    for (int way = 0; way < 2 * 2 * 12; way++) {
        const int pads = way & 1, length = MOST - way / 4;
        const char* alphabet = alphabets[way >> 1 & 1];
        uint8_t bytes[MOST + 2] = {0};
        char text[2 * MOST], json[2 * TEXT];
        size_t at = 0;
        for (int i = 0; i < length; i++) bytes[i] = (uint8_t)(i * 181 + way);
        for (int i = 0; i < length; i += 3) {
            const uint32_t bits = (uint32_t)bytes[i] << 16 | (uint32_t)bytes[i + 1] << 8 | bytes[i + 2];
            const int digits = length - i >= 3 ? 4 : length - i + 1;
            for (int d = 0; d < digits; d++) text[at++] = alphabet[bits >> (18 - 6 * d) & 63];
            for (int d = digits; pads && d < 4; d++) text[at++] = '=';
        }
        text[at] = 0;
        const int vertices = length / 9 * 3;
        for (int wrong = 0; wrong < 3; wrong++) {
            if (wrong == 1) text[way] = '!';
            snprintf(json, sizeof json,
                     "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%d,\"uri\":\"data:%s,%s\"}],"
                     "\"bufferViews\":[{\"buffer\":0,\"byteLength\":%d}],\"accessors\":[{\"bufferView\":0,"
                     "\"componentType\":5121,\"count\":%d,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{"
                     "\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[{\"mesh\":0}]}",
                     length, wrong == 2 ? "text/plain;base65" : ";base64", text, length, vertices);
            write_file("in/g.gltf", json, strlen(json));
            opened o;
            open_path(&o, in_folder("in/g.gltf"), TEST_NEVER);
            static const dm_result results[] = {DM_OK, DM_ERROR_BAD_DATA, DM_ERROR_UNSUPPORTED};
            static const char* const says[] = {"", "whose base64 is broken", "that is not base64"};
            if (o.result != results[wrong] || !strstr(o.t.messages.text, says[wrong]))
                fail_msg("way %d %d: %d '%s'", way, wrong, o.result, o.t.messages.text);
            if (o.result == DM_OK) {
                dm_mesh_desc mesh;
                dm_gltf_get_mesh(o.gltf, &mesh);
                assert_int_equal(mesh.vertex_count, vertices);
                for (int i = 0; i < 3 * vertices; i++)
                    assert_true(((const float*)mesh.positions)[i] == (float)bytes[i]);
            }
            dm_gltf_close(o.gltf);
            test_env_close(&o.t);
        }
    }
}

/* ---- images ---- */

/* What is written elsewhere has the images that lay beside the file; what is no image, not there, or in the document
 * stays as it was. */
static void images_beside_go_along(void** state) {
    (void)state;
    static const struct {
        const char *name, *bytes;
        size_t size;
        const char* type; /* NULL: it stays */
    } images[] = {{"a.png", "\x89PNG", 4, "image/png"},
                  {"b.jpg", "\xFF\xD8\xFF", 3, "image/jpeg"},
                  {"c.ktx", "\xABKTX 20", 7, "image/ktx2"},
                  {"d.dds", "DDS ", 4, "image/vnd-ms.dds"},
                  {"e.webp", "RIFF0000WEBP", 12, "image/webp"},
                  {"f.png", "\x89PN", 3, NULL},
                  {"g.jpg", "\xFF\xD8", 2, NULL},
                  {"h.webp", "RIFF0000WEB", 11, NULL},
                  {"i.wav", "RIFF0000WAVE", 12, NULL},
                  {"gone.png", NULL, 0, NULL},
                  {"data:image/png;base64,AAAA", NULL, 0, NULL},
                  {"..%2Fout.png", NULL, 0, NULL}};
    enum { IMAGES = sizeof images / sizeof *images };
    char json[TEXT];
    size_t length = (size_t)snprintf(
        json, sizeof json, "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36,\"uri\":\"x.bin\"}],");
    for (int i = 0; i < IMAGES; i++) {
        char path[64];
        snprintf(path, sizeof path, "in/%s", images[i].name);
        if (images[i].bytes) write_file(path, images[i].bytes, images[i].size);
        length += (size_t)snprintf(json + length, sizeof json - length, "%s{\"uri\":\"%s\",\"name\":\"%d\"}",
                                   i ? "," : "\"images\":[", images[i].name, i);
    }
    snprintf(json + length, sizeof json - length, "]," REST);
    write_file("in/h.gltf", json, strlen(json));
    opened o;
    open_path(&o, in_folder("in/h.gltf"), TEST_NEVER);
    assert_int_equal(o.result, DM_OK);
    const uint8_t ids[1] = {1};
    const float time = 0;
    const dm_pose still = {{0, 0, 0, 1}, {0}};
    const dm_gltf_track track = {.face_ids = ids, .value = 1, .poses = &still, .times = &time, .key_count = 1};
    void* data;
    size_t size;
    uint32_t bin_size;
    assert_int_equal(dm_gltf_export(o.gltf, &track, 1, &data, &size), DM_OK);
    char* text = test_glb_json(data);
    const uint8_t* bin = test_glb_bin(data, &bin_size);
    cJSON* root = cJSON_Parse(text);
    const cJSON *list = cJSON_GetObjectItem(root, "images"), *views = cJSON_GetObjectItem(root, "bufferViews");
    assert_int_equal(cJSON_GetArraySize(list), IMAGES);
    for (int i = 0; i < IMAGES; i++) {
        const cJSON* image = cJSON_GetArrayItem(list, i);
        const cJSON* uri = cJSON_GetObjectItem(image, "uri");
        if (!images[i].type) {
            assert_string_equal(uri->valuestring, images[i].name);
            assert_null(cJSON_GetObjectItem(image, "bufferView"));
            continue;
        }
        assert_null(uri);
        assert_string_equal(cJSON_GetObjectItem(image, "mimeType")->valuestring, images[i].type);
        const cJSON* view = cJSON_GetArrayItem(views, cJSON_GetObjectItem(image, "bufferView")->valueint);
        const int at = cJSON_GetObjectItem(view, "byteOffset")->valueint;
        assert_int_equal(cJSON_GetObjectItem(view, "byteLength")->valueint, images[i].size);
        assert_int_equal(at % 4, 0);
        assert_true((size_t)at + images[i].size <= bin_size);
        assert_memory_equal(bin + at, images[i].bytes, images[i].size);
    }
    cJSON_Delete(root);
    free(text);
    dm_gltf_release_bytes(o.gltf, data, size);
    dm_gltf_close(o.gltf);
    test_env_close(&o.t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_of_files_beside),
        cmocka_unit_test(schemes_in_any_case),
        cmocka_unit_test(messages_do_not_echo_long_uris),
        cmocka_unit_test(links_do_not_lead_out),
        cmocka_unit_test(the_folder_of_a_bare_name_is_the_current_one),
        cmocka_unit_test(what_is_no_file_is_named),
        cmocka_unit_test(the_path_stands_for_bytes_and_files),
        cmocka_unit_test(a_file_beside_needs_somebody_who_opens_it),
        cmocka_unit_test(every_allocation_may_fail),
        cmocka_unit_test(base64_of_any_bytes_and_length),
        cmocka_unit_test(images_beside_go_along),
    };
    return cmocka_run_group_tests_name("gltf_folder", tests, make_folder, remove_folder);
}
