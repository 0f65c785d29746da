/* draw_mujoco MODEL OUT.png — draws a model at rest and with all its joints at their upper limits, side by side, by
 * MuJoCo's own renderer and OSMesa, which needs no screen. scripts/pictures calls it. */
#include <GL/osmesa.h>
#include <mujoco/mujoco.h>
#include <png.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 400, HEIGHT = 320, CHANNELS = 3, DEPTH_BITS = 24, STENCIL_BITS = 8, MESSAGE = 1000 };
enum {
    GEOMS = 4000,
    FONT = 100,
    BOXES = 3
}; /* most that are drawn; size of letters, %; the group of the collision boxes */
static const float ambient = 0.4f, diffuse = 0.6f;
static const double distance = 1.6, azimuth = 120, elevation = -20; /* sizes of the model; degrees */

/* Draws one half of the picture. */
static void draw(const mjModel* m, mjData* d, mjvScene* scene, mjrContext* context, int column, unsigned char* out) {
    static unsigned char pixels[WIDTH * HEIGHT * CHANNELS];
    const mjrRect view = {0, 0, WIDTH, HEIGHT};
    mjvCamera camera;
    mjvOption option;
    mjv_defaultCamera(&camera);
    mjv_defaultOption(&option);
    option.geomgroup[BOXES] = 0;
    memcpy(camera.lookat, m->stat.center, sizeof camera.lookat);
    camera.distance = distance * m->stat.extent;
    camera.azimuth = azimuth;
    camera.elevation = elevation;
    mj_forward(m, d);
    mjv_updateScene(m, d, &option, NULL, &camera, mjCAT_ALL, scene);
    mjr_rectangle(view, 1, 1, 1, 1);
    mjr_render(view, scene, context);
    mjr_readPixels(pixels, NULL, view, context);
    for (int y = 0; y < HEIGHT; y++)
        memcpy(out + (size_t)(2 * y + column) * WIDTH * CHANNELS, pixels + (size_t)(HEIGHT - 1 - y) * WIDTH * CHANNELS,
               WIDTH * CHANNELS);
}

int main(int argc, char** argv) {
    static unsigned char screen[WIDTH * HEIGHT * 4], picture[2 * WIDTH * HEIGHT * CHANNELS];
    char message[MESSAGE] = "usage: draw_mujoco MODEL OUT.png";
    OSMesaContext osmesa = OSMesaCreateContextExt(GL_RGBA, DEPTH_BITS, STENCIL_BITS, 0, NULL);
    mjModel* m = argc == 3 ? mj_loadXML(argv[1], NULL, message, sizeof message) : NULL;
    if (m == NULL || osmesa == NULL || !OSMesaMakeCurrent(osmesa, screen, GL_UNSIGNED_BYTE, WIDTH, HEIGHT)) {
        fprintf(stderr, "draw_mujoco: %s\n", m == NULL ? message : "OSMesa does not draw");
        return 1;
    }
    mjvScene scene;
    mjrContext context;
    mjData* d = mj_makeData(m);
    for (int k = 0; k < 3; k++) {
        m->vis.headlight.ambient[k] = ambient;
        m->vis.headlight.diffuse[k] = diffuse;
    }
    mjv_defaultScene(&scene);
    mjr_defaultContext(&context);
    mjv_makeScene(m, &scene, GEOMS);
    mjr_makeContext(m, &context, FONT);
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
    draw(m, d, &scene, &context, 0, picture);
    for (int j = 0; j < m->njnt; j++) d->qpos[m->jnt_qposadr[j]] = m->jnt_limited[j] ? m->jnt_range[2 * j + 1] : 0;
    draw(m, d, &scene, &context, 1, picture);
    png_image image = {.version = PNG_IMAGE_VERSION, .width = 2 * WIDTH, .height = HEIGHT, .format = PNG_FORMAT_RGB};
    return !png_image_write_to_file(&image, argv[2], 0, picture, 0, NULL);
}
