/* Computes values between keys: linear, on the sphere for rotations; steps; cubic splines. */
#include "gltf/gltf_accessor.h"

#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "gltf/gltf_matrix.h"
#include "math/elementary.h"

/* A key of a spline has three values: the tangent into it, itself, the tangent out of it. */
enum { INTO = 0, ITSELF = 1, OUT_OF = 2, OF_SPLINE = 3 };

/* Cosine of half the angle between two rotations, from which on they are mixed as vectors, because the sine by which
 * the arc is divided loses its digits; by hand. */
#define ALMOST_SAME 0.9999

/* Bytes that reading a value counts as, so that channels which share their keys are limited like repeated meshes; by
 * hand. */
#define BYTES_A_VALUE 4

static dm_result check_sampler(const dmi_gltf_sampler* s, const char* place, dmi_gltf_problem* problem) {
    const uint64_t per_key = s->interpolation == DMI_GLTF_CUBIC ? OF_SPLINE : 1;
    if (s->times.components != 1 || s->values.components != s->components || s->times.count == 0 ||
        s->values.count != s->times.count * per_key)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: %" PRIu64 " keys have %" PRIu64 " values of %d numbers",
                               place, s->times.count, s->values.count, s->values.components);
    for (uint64_t i = 0; i < s->times.count; i++) {
        const double time = dmi_gltf_sample_time(s, i);
        if (!isfinite(time) || (i > 0 && time <= dmi_gltf_sample_time(s, i - 1)))
            return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: its times do not rise", place);
    }
    for (uint64_t i = 0; i < s->values.count; i++)
        for (int k = 0; k < s->components; k++)
            if (!isfinite(dmi_gltf_value(&s->values, i, k)))
                return dmi_gltf_refuse(problem, DM_ERROR_NOT_FINITE, "%s: a value is not finite", place);
    return DM_OK;
}

dm_result dmi_gltf_read_sampler(dm_gltf* gltf, const cJSON* json, int components, const char* place,
                                dmi_gltf_problem* problem, dmi_gltf_sampler* out) {
    const char* interpolation = dmi_json_text(json, "interpolation");
    const double input = dmi_json_number(json, "input", DMI_GLTF_NO_INDEX);
    const double output = dmi_json_number(json, "output", DMI_GLTF_NO_INDEX);
    *out = (dmi_gltf_sampler){.interpolation = DMI_GLTF_LINEAR, .components = components};
    if (interpolation && strcmp(interpolation, "STEP") == 0) out->interpolation = DMI_GLTF_STEP;
    if (interpolation && strcmp(interpolation, "CUBICSPLINE") == 0) out->interpolation = DMI_GLTF_CUBIC;
    dm_result result = dmi_gltf_find_elements(gltf, input, place, problem, &out->times);
    if (result == DM_OK) result = dmi_gltf_find_elements(gltf, output, place, problem, &out->values);
    if (result == DM_OK) result = dmi_gltf_spend(gltf, out->values.count, BYTES_A_VALUE, place, problem);
    return result == DM_OK ? check_sampler(out, place, problem) : result;
}

double dmi_gltf_sample_time(const dmi_gltf_sampler* sampler, uint64_t key) {
    return dmi_gltf_value(&sampler->times, key, 0);
}

/* ---- between two keys ---- */

static void read_value(const dmi_gltf_sampler* s, uint64_t key, int which, double out[4]) {
    const uint64_t element = s->interpolation == DMI_GLTF_CUBIC ? OF_SPLINE * key + (uint64_t)which : key;
    for (int k = 0; k < s->components; k++) out[k] = dmi_gltf_value(&s->values, element, k);
}

/* Writes the value a share `t` of the way from a to b. Rotations take the shorter arc. */
static void mix_values(const double a[4], const double b[4], double t, int components, double out[4]) {
    double from = 1 - t, to = t, cosine = 0;
    for (int k = 0; components == 4 && k < 4; k++) cosine += a[k] * b[k];
    const double sign = cosine < 0 ? -1 : 1;
    if (components == 4 && fabs(cosine) < ALMOST_SAME) {
        const double sine = sqrt(1 - cosine * cosine), angle = dmi_atan2(sine, fabs(cosine));
        from = dmi_circle_at((1 - t) * angle).sine / sine;
        to = dmi_circle_at(t * angle).sine / sine;
    }
    for (int k = 0; k < components; k++) out[k] = from * a[k] + to * sign * b[k];
}

/* Computes the cubic Hermite spline of glTF 2.0, appendix C.5. `t` is a share of `span`, the time between the keys. */
static void mix_cubic(const dmi_gltf_sampler* s, uint64_t key, double t, double span, double out[4]) {
    double a[4], b[4], leaving[4], coming[4];
    const double t2 = t * t, t3 = t2 * t;
    read_value(s, key, ITSELF, a);
    read_value(s, key + 1, ITSELF, b);
    read_value(s, key, OUT_OF, leaving);
    read_value(s, key + 1, INTO, coming);
    for (int k = 0; k < s->components; k++)
        out[k] = (2 * t3 - 3 * t2 + 1) * a[k] + span * (t3 - 2 * t2 + t) * leaving[k] + (3 * t2 - 2 * t3) * b[k] +
                 span * (t3 - t2) * coming[k];
}

/* Returns the last key that is not after the time, or 0 before all. */
static uint64_t find_key(const dmi_gltf_sampler* s, double time) {
    uint64_t low = 0, high = s->times.count;
    while (high - low > 1) {
        const uint64_t middle = low + (high - low) / 2;
        if (dmi_gltf_sample_time(s, middle) <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

void dmi_gltf_sample(const dmi_gltf_sampler* sampler, double time, double out[4]) {
    const uint64_t key = find_key(sampler, time);
    const double start = dmi_gltf_sample_time(sampler, key);
    read_value(sampler, key, ITSELF, out);
    if (sampler->components == 4) dmi_gltf_normalize(out);
    if (key + 1 == sampler->times.count || time <= start || sampler->interpolation == DMI_GLTF_STEP) return;
    const double span = dmi_gltf_sample_time(sampler, key + 1) - start, t = (time - start) / span;
    if (sampler->interpolation == DMI_GLTF_CUBIC) {
        mix_cubic(sampler, key, t, span, out);
    } else {
        double next[4];
        read_value(sampler, key + 1, ITSELF, next);
        if (sampler->components == 4) dmi_gltf_normalize(next);
        mix_values((double[4]){out[0], out[1], out[2], sampler->components == 4 ? out[3] : 0}, next, t,
                   sampler->components, out);
    }
    if (sampler->components == 4) dmi_gltf_normalize(out);
}
