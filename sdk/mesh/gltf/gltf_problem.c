/* Problems of files, as text. */
#include "mesh/gltf/gltf_problem.h"

#include <stdarg.h>
#include <stdio.h>

#include "base/utf8.h"

dm_result dmi_gltf_refuse(dmi_gltf_problem* problem, dm_result code, const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(problem->text, sizeof problem->text, format, arguments);
    va_end(arguments);
    problem->fatal = code == DM_ERROR_OUT_OF_MEMORY || code == DM_ERROR_CANCELLED;
    return problem->code = code;
}

void dmi_gltf_warn(dmi_env* env, const char* format, ...) {
    if (!env->log.message) return;
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    dmi_utf8_mend(text);
    env->log.message(env->log.user, DM_LOG_WARNING, DM_OK, text);
}
