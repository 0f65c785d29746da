/* Opens a session: a context, and the weights for it. */
#ifndef CLI_SESSION_OPEN_H
#define CLI_SESSION_OPEN_H

#include "session.h"

/* models: a folder, "none", or NULL (DRAGMESH_MODELS, then beside the program). allocator NULL: malloc. Prints what is
 * wrong and returns an exit status. */
int session_open(session* session, const char* models, const dm_allocator* allocator);
int session_open_method(session* session, const char* models, enum session_method method);

#endif
