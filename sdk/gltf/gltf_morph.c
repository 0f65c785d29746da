/* Morph targets (glTF 2.0 §3.7.2.2): a vertex stands where its position and the weighted sum of its targets is. */
#include "gltf/gltf_geometry.h"

#include <math.h>
#include <stdbool.h>

/* Most targets of one primitive; by hand: faces have some 50. */
#define MOST_TARGETS 256
/* Bytes of a value of cJSON with its name; counted. */
#define BYTES_A_VALUE 128

/* ---- weights ---- */

static double weight_at(const cJSON* item) {
    return cJSON_IsNumber(item) && isfinite(item->valuedouble) ? item->valuedouble : 0;
}

static bool are_zeros(const cJSON* weights) {
    const cJSON* item;
    cJSON_ArrayForEach(item, weights) {
        if (weight_at(item) != 0) return false;
    }
    return true;
}

static const cJSON* mesh_of(const dm_gltf* gltf, const cJSON* node) {
    return dmi_gltf_item(&gltf->document, DMI_GLTF_MESHES, dmi_json_number(node, "mesh", DMI_GLTF_NO_INDEX));
}

const cJSON* dmi_gltf_weights_of(const dm_gltf* gltf, const cJSON* node) {
    const cJSON *own = dmi_json_get(node, "weights"), *common = dmi_json_get(mesh_of(gltf, node), "weights");
    const cJSON* weights = cJSON_IsArray(own) ? own : common;
    return cJSON_IsArray(weights) && !are_zeros(weights) ? weights : NULL;
}

/* Returns whether two lists of weights are equal. NULL stands for zeros. */
static bool are_equal(const cJSON* a, const cJSON* b) {
    const cJSON *x = a ? a->child : NULL, *y = b ? b->child : NULL;
    for (; x || y; x = x ? x->next : NULL, y = y ? y->next : NULL)
        if (weight_at(x) != weight_at(y)) return false;
    return true;
}

/* ---- meshes with several weights ---- */

static bool has_targets(const cJSON* mesh) {
    const cJSON* primitive;
    cJSON_ArrayForEach(primitive, dmi_json_get(mesh, "primitives")) {
        if (dmi_json_get(primitive, "targets")) return true;
    }
    return false;
}

static uint64_t count_values(const cJSON* json) {
    uint64_t count = 1;
    for (const cJSON* child = json->child; child; child = child->next) count += count_values(child);
    return count;
}

/* Hands the node a copy of its mesh that has its weights. */
static dm_result part_mesh(dm_gltf* gltf, cJSON* node, uint32_t* inout_meshes, dmi_gltf_problem* problem) {
    const cJSON *mesh = mesh_of(gltf, node), *weights = dmi_gltf_weights_of(gltf, node);
    const dm_result result = dmi_gltf_spend(gltf, count_values(mesh), BYTES_A_VALUE, "glTF: morph targets", problem);
    if (result != DM_OK) return result;
    cJSON *copy = cJSON_Duplicate(mesh, 1), *index = cJSON_GetObjectItemCaseSensitive(node, "mesh");
    if (!copy) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for a mesh");
    cJSON_DeleteItemFromObjectCaseSensitive(copy, "weights");
    cJSON* own = weights ? cJSON_Duplicate(weights, 1) : NULL;
    if ((weights && !own) || (own && !cJSON_AddItemToObject(copy, "weights", own))) {
        cJSON_Delete(own);
        cJSON_Delete(copy);
        return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for a mesh");
    }
    cJSON_AddItemToArray(cJSON_GetObjectItemCaseSensitive(gltf->document.root, "meshes"), copy);
    cJSON_SetNumberHelper(index, (*inout_meshes)++);
    return DM_OK;
}

dm_result dmi_gltf_part_morphs(dm_gltf* gltf, dmi_gltf_problem* problem) {
    const uint32_t before = gltf->document.counts[DMI_GLTF_MESHES];
    dmi_env* env = &gltf->env;
    uint32_t meshes = before;
    dm_result result = dmi_gltf_spend(gltf, before, sizeof(cJSON*), "glTF: the meshes", problem);
    if (result != DM_OK) return result;
    cJSON** firsts = dmi_alloc_zeroed(env, before * sizeof *firsts, 16); /* per mesh: the first node that has it */
    if (!firsts) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u meshes", before);
    for (uint32_t i = 0; i < gltf->document.counts[DMI_GLTF_NODES] && result == DM_OK; i++) {
        cJSON* node = gltf->document.items[DMI_GLTF_NODES][i];
        const int64_t mesh =
            dmi_gltf_position(&gltf->document, DMI_GLTF_MESHES, dmi_json_number(node, "mesh", DMI_GLTF_NO_INDEX));
        if (mesh < 0 || !has_targets(gltf->document.items[DMI_GLTF_MESHES][mesh])) continue;
        if (!firsts[mesh])
            firsts[mesh] = node;
        else if (!are_equal(dmi_gltf_weights_of(gltf, firsts[mesh]), dmi_gltf_weights_of(gltf, node)))
            result = part_mesh(gltf, node, &meshes, problem);
    }
    dmi_free(env, firsts, before * sizeof *firsts);
    if (result != DM_OK || meshes == before) return result;
    return dmi_gltf_list_again(env, &gltf->document, DMI_GLTF_MESHES, problem);
}

/* ---- vertices ---- */

int dmi_gltf_is_morphed(const cJSON* primitive, const cJSON* weights) {
    return weights && dmi_json_get(primitive, "targets") && dmi_json_get(primitive, "targets")->child;
}

static dm_result find_offsets(dm_gltf* gltf, const dmi_gltf_morphed* m, double accessor, dmi_gltf_problem* problem,
                              dmi_gltf_elements* out) {
    const dm_result result = dmi_gltf_find_elements(gltf, accessor, m->place, problem, out);
    if (result != DM_OK) return result;
    for (uint64_t v = 0; v < m->count; v++) {
        const uint64_t element = m->elements[v];
        if (out->components != 3 || element >= out->count)
            return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: a morph target does not fit its vertices",
                                   m->place);
        for (int k = 0; k < 3; k++)
            if (!isfinite(dmi_gltf_value(out, element, k)))
                return dmi_gltf_refuse(problem, DM_ERROR_NOT_FINITE, "%s: a morph target is not finite", m->place);
    }
    return DM_OK;
}

static dm_result apply_target(dm_gltf* gltf, const dmi_gltf_morphed* m, const cJSON* target, double weight,
                              dmi_gltf_problem* problem) {
    const cJSON* accessor = dmi_json_get(target, "POSITION");
    dmi_gltf_elements offsets;
    dmi_gltf_problem here = {.code = DM_OK};
    if (!cJSON_IsNumber(accessor)) return DM_OK;
    const dm_result result = find_offsets(gltf, m, accessor->valuedouble, &here, &offsets);
    if (result != DM_OK && !here.fatal) {
        dmi_gltf_warn(&gltf->warnings, "%s; left out", here.text);
        return DM_OK;
    }
    if (result != DM_OK) {
        *problem = here;
        return result;
    }
    for (uint64_t v = 0; v < m->count; v++)
        for (uint64_t k = 0; k < 3; k++) {
            float* p = &m->positions[3 * v + k];
            *p = (float)((double)*p + weight * dmi_gltf_value(&offsets, m->elements[v], (int)k));
        }
    return dmi_gltf_tell(gltf, 0, m->count, problem);
}

dm_result dmi_gltf_morph(dm_gltf* gltf, const dmi_gltf_morphed* morphed, dmi_gltf_problem* problem) {
    const cJSON* target = dmi_json_get(morphed->primitive, "targets")->child;
    const cJSON* weight = morphed->weights->child;
    for (int i = 0; target && weight && i < MOST_TARGETS; i++, target = target->next, weight = weight->next) {
        if (weight_at(weight) == 0) continue;
        const dm_result result = apply_target(gltf, morphed, target, weight_at(weight), problem);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}
