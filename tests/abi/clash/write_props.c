/* write_props FOLDER — writes the cabinet of test_prop.h as plain.glb, meshopt.glb and draco.glb. */
#include "test_prop.h"

int main(int argc, char** argv) {
    static const struct {
        test_prop_way way;
        const char* name;
    } files[] = {{TEST_PROP_PLAIN, "plain"}, {TEST_PROP_MESHOPT, "meshopt"}, {TEST_PROP_DRACO, "draco"}};
    if (argc != 2) return 2;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char path[1024];
        test_prop p;
        snprintf(path, sizeof path, "%s/%s.glb", argv[1], files[i].name);
        FILE* file = fopen(path, "wb");
        if (file == NULL || !test_prop_make(&p, files[i].way)) return 1;
        const size_t written = fwrite(p.data, 1, p.size, file);
        if (fclose(file) != 0 || written != p.size) return 1;
        test_prop_free(&p);
    }
    return 0;
}
