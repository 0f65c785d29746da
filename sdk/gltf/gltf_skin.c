/* Applies linear blend skinning (glTF 2.0 §3.7.3.3), in the pose that the nodes of the file have. */
#include "gltf/gltf_merge.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "gltf/gltf_tree.h"

/* Least weight that counts, two steps of a byte: smaller ones are what compression leaves of 0. */
#define SMALL_WEIGHT (2.0 / 255)

void dmi_gltf_mark_joints(dm_gltf* gltf) {
    for (uint32_t s = 0; s < gltf->document.counts[DMI_GLTF_SKINS]; s++) {
        const cJSON* joint;
        cJSON_ArrayForEach(joint, dmi_json_get(gltf->document.items[DMI_GLTF_SKINS][s], "joints")) {
            const int64_t node = dmi_gltf_position(&gltf->document, DMI_GLTF_NODES, joint->valuedouble);
            if (node >= 0) gltf->tree[node].joint = 1;
        }
    }
}

static dm_result read_joints(dm_gltf* gltf, const cJSON* list, const char* place, dmi_gltf_problem* problem,
                             dmi_gltf_skin* out) {
    const cJSON* joint;
    uint32_t count = 0;
    cJSON_ArrayForEach(joint, list) {
        const int64_t node = dmi_gltf_position(&gltf->document, DMI_GLTF_NODES, joint->valuedouble);
        if (node < 0 || !gltf->tree[node].placed)
            return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: joint %.17g of its skin does not exist", place,
                                   joint->valuedouble);
        out->joints[count].node = (uint32_t)node;
        memcpy(out->joints[count++].matrix, gltf->tree[node].world, sizeof out->joints->matrix);
    }
    return DM_OK;
}

static dm_result apply_inverse_bind(dm_gltf* gltf, double accessor, const char* place, dmi_gltf_problem* problem,
                                    dmi_gltf_skin* skin) {
    dmi_gltf_elements matrices;
    const dm_result result = dmi_gltf_find_elements(gltf, accessor, place, problem, &matrices);
    if (result != DM_OK) return result;
    if (matrices.components != 16 || matrices.component_type != DMI_GLTF_FLOAT || matrices.count < skin->joint_count)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: inverseBindMatrices of its skin are too few", place);
    for (uint32_t j = 0; j < skin->joint_count; j++) {
        double inverse[16], product[16];
        for (int k = 0; k < 16; k++) inverse[k] = dmi_gltf_element(&matrices, j, k);
        dmi_gltf_multiply(skin->joints[j].matrix, inverse, product);
        memcpy(skin->joints[j].matrix, product, sizeof product);
    }
    return DM_OK;
}

dm_result dmi_gltf_open_skin(dm_gltf* gltf, double index, const char* place, dmi_gltf_problem* problem,
                             dmi_gltf_skin* out) {
    const cJSON* json = dmi_gltf_item(&gltf->document, DMI_GLTF_SKINS, index);
    const cJSON* joints = dmi_json_get(json, "joints");
    const int count = cJSON_GetArraySize(joints);
    *out = (dmi_gltf_skin){NULL, 0};
    if (count == 0)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: skin %.17g does not exist or is empty", place, index);
    dm_result result = dmi_gltf_spend(gltf, (uint64_t)count, sizeof *out->joints, place, problem);
    if (result != DM_OK) return result;
    out->joints = dmi_alloc(&gltf->env, (size_t)count * sizeof *out->joints, 16);
    if (!out->joints) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "%s: no memory for its skin", place);
    out->joint_count = (uint32_t)count;
    result = read_joints(gltf, joints, place, problem, out);
    if (result == DM_OK && dmi_json_get(json, "inverseBindMatrices"))
        result = apply_inverse_bind(gltf, dmi_json_number(json, "inverseBindMatrices", DMI_GLTF_NO_INDEX), place,
                                    problem, out);
    return result;
}

void dmi_gltf_close_skin(dmi_env* env, dmi_gltf_skin* skin) {
    dmi_free(env, skin->joints, skin->joint_count * sizeof *skin->joints);
    *skin = (dmi_gltf_skin){NULL, 0};
}

/* Writes the blended place of a vertex. Returns its heaviest joint, or -1 for none, and the sum of weights that others
 * have. */
static int64_t blend_vertex(const dmi_gltf_skin* skin, const dmi_gltf_geometry* from, uint32_t element,
                            const float local[3], double out[3], double* out_others) {
    double sum = 0, heaviest = 0, at[3] = {0, 0, 0};
    int64_t best = -1;
    for (uint32_t i = 0; i < 4 * from->joint_sets; i++) {
        const double weight = dmi_gltf_element(&from->weights[i / 4], element, i % 4);
        const double joint = dmi_gltf_element(&from->joints[i / 4], element, i % 4);
        if (!(weight > 0) || !(joint >= 0 && joint < skin->joint_count)) continue;
        const double* m = skin->joints[(uint32_t)joint].matrix;
        for (int row = 0; row < 3; row++)
            at[row] += weight * (m[row] * (double)local[0] + m[4 + row] * (double)local[1] +
                                 m[8 + row] * (double)local[2] + m[12 + row]);
        sum += weight;
        if (weight <= heaviest) continue;
        heaviest = weight;
        best = (int64_t)joint;
    }
    for (int k = 0; k < 3; k++) out[k] = at[k] / (sum > 0 ? sum : 1);
    *out_others = sum > 0 ? (sum - heaviest) / sum : 0;
    return best;
}

int64_t dmi_gltf_skin_vertices(const dmi_gltf_skin* skin, const dmi_gltf_shape* shape, uint32_t* out_joints,
                               double (*out_positions)[3]) {
    int64_t mixed = 0;
    for (uint32_t g = 0; g < shape->group_count; g++) {
        const dmi_gltf_group* group = &shape->groups[g];
        for (uint64_t v = group->first_vertex; v < group->first_vertex + group->vertex_count; v++) {
            double others;
            const int64_t joint = blend_vertex(skin, &group->geometry, shape->elements[v], shape->local + 3 * v,
                                               out_positions[v], &others);
            if (joint < 0) return -1;
            out_joints[v] = (uint32_t)joint;
            mixed += others > SMALL_WEIGHT;
        }
    }
    return mixed;
}
