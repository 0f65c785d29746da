/* Opens a session: a context, and the weights for it. */
#include "session_open.h"

#include <stdio.h>

#include "models.h"

static int open_with(session* session, const char* models, const dm_allocator* allocator, enum session_method method) {
    if (!session_init(session, allocator, method)) {
        fprintf(stderr, "dragmesh: %s\n", session->error);
        return CLI_FAILED;
    }
    if (models_load(session, models) == DM_OK) return CLI_OK;
    fprintf(stderr, "dragmesh: %s\n", session->error);
    session_close(session);
    return CLI_USAGE;
}

int session_open(session* session, const char* models, const dm_allocator* allocator) {
    return open_with(session, models, allocator, METHOD_FULL);
}

int session_open_method(session* session, const char* models, enum session_method method) {
    return open_with(session, models, NULL, method);
}
