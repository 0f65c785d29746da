/* Keeps problems of files as text. */
#include "gltf/gltf_problem.h"

#include <stdarg.h>
#include <stdio.h>

#include "base/utf8.h"

/* Most bytes of a warning where several are quoted; by hand: three of them, and the words between, fit a log
 * message. */
#define QUOTE_SIZE 144

dm_result dmi_gltf_refuse(dmi_gltf_problem* problem, dm_result code, const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(problem->text, sizeof problem->text, format, arguments);
    va_end(arguments);
    problem->fatal = code == DM_ERROR_OUT_OF_MEMORY || code == DM_ERROR_CANCELLED;
    return problem->code = code;
}

void dmi_gltf_warn(dmi_gltf_warnings* warnings, const char* format, ...) {
    va_list arguments;
    if (warnings->count++ >= DMI_GLTF_NAMED_WARNINGS) return;
    char* text = warnings->texts[warnings->count - 1];
    va_start(arguments, format);
    vsnprintf(text, sizeof *warnings->texts, format, arguments);
    va_end(arguments);
    dmi_utf8_mend(text);
}

/* Writes the quotes, each cut to QUOTE_SIZE, and how many warnings go without one. */
static void join_quotes(const dmi_gltf_warnings* warnings, char* out, size_t size) {
    const uint32_t quoted = warnings->count < DMI_GLTF_NAMED_WARNINGS ? warnings->count : DMI_GLTF_NAMED_WARNINGS;
    int length = snprintf(out, size, "glTF: %u warnings", warnings->count);
    for (uint32_t i = 0; i < quoted; i++)
        length += snprintf(out + length, size - (size_t)length, "%s %.*s", i == 0 ? ":" : ";", QUOTE_SIZE,
                           warnings->texts[i]);
    if (warnings->count > quoted)
        snprintf(out + length, size - (size_t)length, "; and %u more", warnings->count - quoted);
}

void dmi_gltf_log_warnings(dmi_env* env, dmi_gltf_warnings* warnings) {
    char all[sizeof *warnings->texts];
    const char* text = warnings->texts[0];
    if (warnings->count > 1) {
        join_quotes(warnings, all, sizeof all);
        dmi_utf8_mend(all);
        text = all;
    }
    if (warnings->count > 0 && env->log.message) env->log.message(env->log.user, DM_LOG_WARNING, DM_OK, text);
    warnings->count = 0;
}
