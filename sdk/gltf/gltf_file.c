/* What all steps of reading a file take of its dm_gltf: progress, memory within what the file may cost, and the list of
 * what is left out. */
#include "gltf/gltf_file.h"

#include <inttypes.h>

#define PERCENT 100.0f

dm_result dmi_gltf_tell(dm_gltf* gltf, float share, uint64_t work, dmi_gltf_problem* problem) {
    if (share > gltf->told) gltf->told = share;
    gltf->untold += work;
    if (gltf->untold < DMI_PROGRESS_STEP) return DM_OK;
    gltf->untold = 0;
    const dm_result result = dmi_progress_tell(&gltf->progress, gltf->told);
    if (result == DM_OK) return DM_OK;
    return dmi_gltf_refuse(problem, result, "glTF: the progress callback asked to stop at %.0f %%",
                           (double)(gltf->told * PERCENT));
}

void dmi_gltf_leave_out(dm_gltf* gltf, const dmi_gltf_problem* problem) {
    dmi_gltf_warn(&gltf->warnings, "%s; left out", problem->text);
    if (gltf->left_out.code == DM_OK) gltf->left_out = *problem;
}

dm_result dmi_gltf_spend(dm_gltf* gltf, uint64_t count, uint64_t element, const char* place,
                         dmi_gltf_problem* problem) {
    if (count <= gltf->bytes_left / element) {
        gltf->bytes_left -= count * element;
        return DM_OK;
    }
    dmi_gltf_refuse(problem, DM_ERROR_TOO_LARGE,
                    "%s: the scene takes more than %d bytes for each of the file's, repeated meshes count", place,
                    DMI_GLTF_BYTES_PER_BYTE);
    problem->fatal = 1;
    return problem->code;
}

uint64_t dmi_gltf_grant_draco(dm_gltf* gltf, uint64_t size) {
    const uint64_t counted = size < gltf->draco_left ? size : gltf->draco_left;
    const uint64_t granted = counted * (DMI_GLTF_BYTES_PER_DRACO_BYTE - DMI_GLTF_BYTES_PER_BYTE);
    gltf->draco_left -= counted;
    gltf->bytes_most += granted;
    gltf->bytes_left += granted;
    return granted;
}

void dmi_gltf_take_back(dm_gltf* gltf, uint64_t granted) {
    gltf->bytes_most -= granted;
    gltf->bytes_left -= granted < gltf->bytes_left ? granted : gltf->bytes_left;
}

void* dmi_gltf_push(dm_gltf* gltf, dmi_arena* arena, uint64_t count, size_t element, dmi_gltf_problem* problem) {
    if (dmi_gltf_spend(gltf, count, element, "glTF: asset", problem) != DM_OK) return NULL;
    void* memory = dmi_arena_push(arena, (size_t)count * element);
    if (!memory)
        dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: asset: no memory for %" PRIu64 " bytes",
                        count * element);
    return memory;
}

void dmi_gltf_release_on_disk(dmi_env* env, const dmi_gltf_on_disk* on_disk) {
    dmi_free(env, on_disk->folder, on_disk->folder_size);
    dmi_free(env, on_disk->data, on_disk->size);
}
