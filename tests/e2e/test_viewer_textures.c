/* The viewer shows base colour textures: a door with four colours on it, seen from its front. */
#include <png.h>

#include "test_glb.h"
#include "test_tool.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { CAN_DRAW = 0 }; /* the software OpenGL driver leaks, and races on purpose */
#else
enum { CAN_DRAW = 1 };
#endif

enum { NO_OPENGL = 3, SIDE = 16, PICTURE = 240 /* pixels */ };

static tool_output out;

/* Colours of the quarters: top left, top right, bottom left, bottom right. */
static const uint8_t quarters[4][3] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}};

/* The same picture by libjpeg 2.1.5 at quality 60. */
static const uint8_t jpeg[] = {
    0xff, 0xd8, 0xff, 0xdb, 0x00, 0x43, 0x00, 0x0d, 0x09, 0x0a, 0x0b, 0x0a, 0x08, 0x0d, 0x0b, 0x0a, 0x0b, 0x0e, 0x0e,
    0x0d, 0x0f, 0x13, 0x20, 0x15, 0x13, 0x12, 0x12, 0x13, 0x27, 0x1c, 0x1e, 0x17, 0x20, 0x2e, 0x29, 0x31, 0x30, 0x2e,
    0x29, 0x2d, 0x2c, 0x33, 0x3a, 0x4a, 0x3e, 0x33, 0x36, 0x46, 0x37, 0x2c, 0x2d, 0x40, 0x57, 0x41, 0x46, 0x4c, 0x4e,
    0x52, 0x53, 0x52, 0x32, 0x3e, 0x5a, 0x61, 0x5a, 0x50, 0x60, 0x4a, 0x51, 0x52, 0x4f, 0xff, 0xdb, 0x00, 0x43, 0x01,
    0x0e, 0x0e, 0x0e, 0x13, 0x11, 0x13, 0x26, 0x15, 0x15, 0x26, 0x4f, 0x35, 0x2d, 0x35, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f,
    0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f,
    0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f,
    0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0x4f, 0xff, 0xc0, 0x00, 0x11, 0x08, 0x00, 0x10, 0x00, 0x10, 0x03, 0x01, 0x11,
    0x00, 0x02, 0x11, 0x01, 0x03, 0x11, 0x01, 0xff, 0xc4, 0x00, 0x15, 0x00, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x06, 0x07, 0xff, 0xc4, 0x00, 0x14, 0x10, 0x01, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xff, 0xc4, 0x00, 0x17, 0x01,
    0x00, 0x03, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x05, 0x07, 0x08,
    0x06, 0xff, 0xc4, 0x00, 0x14, 0x11, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0xff, 0xda, 0x00, 0x0c, 0x03, 0x01, 0x00, 0x02, 0x11, 0x03, 0x11, 0x00, 0x3f, 0x00, 0x3e,
    0x0c, 0x64, 0x97, 0x04, 0x27, 0x94, 0xd0, 0xf9, 0x6c, 0x57, 0x94, 0xda, 0x30, 0xff, 0xd9,
};

static size_t make_png(uint8_t* out_png, size_t room) {
    uint8_t rgb[SIDE][SIDE][3];
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) memcpy(rgb[y][x], quarters[2 * (y >= SIDE / 2) + (x >= SIDE / 2)], 3);
    png_image image = {.version = PNG_IMAGE_VERSION, .width = SIDE, .height = SIDE, .format = PNG_FORMAT_RGB};
    png_alloc_size_t size = room;
    assert_true(png_image_write_to_memory(&image, out_png, &size, 0, rgb, 0, NULL));
    return size;
}

/* A door of 1 x 1 with the image on it, and a body behind it. */
static void write_door(const char* path, const void* image, size_t image_size) {
    struct {
        float positions[8][3], uv[4][2];
        uint16_t indices[12];
        uint8_t image[4096];
    } bin = {.positions = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
             .uv = {{0, 1}, {1, 1}, {0, 0}, {1, 0}},
             .indices = {0, 1, 2, 2, 1, 3, 0, 1, 2, 2, 1, 3}};
    char json[2048];
    assert_true(image_size <= sizeof bin.image);
    memcpy(bin.image, image, image_size);
    snprintf(json, sizeof json,
             "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%zu}],\"bufferViews\":["
             "{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":48},"
             "{\"buffer\":0,\"byteOffset\":96,\"byteLength\":32},{\"buffer\":0,\"byteOffset\":128,\"byteLength\":24},"
             "{\"buffer\":0,\"byteOffset\":152,\"byteLength\":%zu}],\"accessors\":["
             "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"
             "{\"bufferView\":1,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"
             "{\"bufferView\":2,\"componentType\":5126,\"count\":4,\"type\":\"VEC2\"},"
             "{\"bufferView\":3,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"}],"
             "\"images\":[{\"bufferView\":4}],\"textures\":[{\"source\":0}],\"materials\":[{\"pbrMetallicRoughness\":"
             "{\"baseColorTexture\":{\"index\":0}}}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,"
             "\"TEXCOORD_0\":2},\"indices\":3,\"material\":0}]},{\"primitives\":[{\"attributes\":{\"POSITION\":1},"
             "\"indices\":3}]}],\"nodes\":[{\"name\":\"door\",\"mesh\":0},{\"name\":\"body\",\"mesh\":1}]}",
             sizeof bin, image_size);
    const test_glb glb = test_glb_pack(json, &bin, sizeof bin);
    tool_write(path, glb.data, glb.size);
    free(glb.data);
}

/* Draws the door with this image on it, from straight ahead. */
static void draw_door(const void* image, size_t image_size, uint8_t rgb[PICTURE][PICTURE][3]) {
    static const char session[] =
        "dragmesh-session 1\nsize 240 240\nup y\npart door\n0 camera 0 0 2.2 0.5 0.5 0.9\n1 move 2 2\n";
    char folder[TOOL_PATH], path[TOOL_PATH + 32], script[TOOL_PATH + 32];
    tool_folder_make(folder);
    snprintf(path, sizeof path, "%s/door.glb", folder);
    snprintf(script, sizeof script, "%s/s.session", folder);
    write_door(path, image, image_size);
    tool_write(script, session, strlen(session));
    tool_run(&out, "dragmesh_viewer", NULL, "%s|--models|none|--replay|%s|--png|%s", path, script, folder);
    if (out.status == NO_OPENGL) {
        tool_folder_remove(folder);
        print_message("skipped: no OpenGL 3.3 can be made here: %s\n", out.errors);
        skip();
    }
    if (out.status != 0) fail_msg("%s", out.errors);
    png_image picture = {.version = PNG_IMAGE_VERSION};
    snprintf(path, sizeof path, "%s/frame_000.png", folder);
    assert_true(png_image_begin_read_from_file(&picture, path));
    assert_true(picture.width == PICTURE && picture.height == PICTURE);
    picture.format = PNG_FORMAT_RGB;
    assert_true(png_image_finish_read(&picture, NULL, rgb, 0, NULL));
    tool_folder_remove(folder);
}

/* Whether a pixel has the channels of a colour and not the others. */
static int is_coloured(const uint8_t pixel[3], const uint8_t colour[3]) {
    for (int k = 0; k < 3; k++)
        if ((pixel[k] > 128) != (colour[k] > 128)) return 0;
    return 1;
}

static void need_viewer(void) {
    char program[TOOL_PATH];
    tool_find("dragmesh_viewer", program);
    if (access(program, X_OK) == 0 && CAN_DRAW) return;
    print_message("skipped: the viewer is not built, or cannot draw in this build\n");
    skip();
}

static void assert_quarters(const void* image, size_t size) {
    static uint8_t rgb[PICTURE][PICTURE][3];
    draw_door(image, size, rgb);
    for (int q = 0; q < 4; q++) {
        /* The door fills most of the picture's middle. */
        const int x = PICTURE / 2 + (q % 2 ? 40 : -40), y = PICTURE / 2 + (q / 2 ? 40 : -40);
        if (!is_coloured(rgb[y][x], quarters[q]))
            fail_msg("quarter %d is (%d, %d, %d)", q, rgb[y][x][0], rgb[y][x][1], rgb[y][x][2]);
    }
}

static void shows_png(void** state) {
    (void)state;
    need_viewer();
    uint8_t png[4096];
    assert_quarters(png, make_png(png, sizeof png));
}

static void shows_jpeg(void** state) {
    (void)state;
    need_viewer();
    static uint8_t rgb[PICTURE][PICTURE][3];
    draw_door(jpeg, sizeof jpeg, rgb);
    if (strstr(out.errors, "no libjpeg")) skip();
    assert_quarters(jpeg, sizeof jpeg);
}

/* Broken images, and formats that nobody reads, are left out with a line; the door is drawn all the same. */
static void leaves_broken_images_out(void** state) {
    (void)state;
    need_viewer();
    static uint8_t rgb[PICTURE][PICTURE][3];
    uint8_t png[4096];
    const size_t size = make_png(png, sizeof png);
    const struct {
        const void* data;
        size_t size;
    } broken[] = {{png, size / 2}, {jpeg, 40}, {"RIFF....WEBPVP8 ", 16}};
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
        draw_door(broken[i].data, broken[i].size, rgb);
        assert_non_null(strstr(out.errors, "an image is left out"));
        const uint8_t* pixel = rgb[PICTURE / 2][PICTURE / 2];
        assert_true(abs(pixel[0] - pixel[1]) < 40 && abs(pixel[1] - pixel[2]) < 40);
    }
}

int main(void) {
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
    setenv("XDG_RUNTIME_DIR", "/tmp", 0);
    const struct CMUnitTest tests[] = {cmocka_unit_test(shows_png), cmocka_unit_test(shows_jpeg),
                                       cmocka_unit_test(leaves_broken_images_out)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
