/* Where the weights are, and loading them. */
#ifndef CLI_MODELS_H
#define CLI_MODELS_H

#include "session.h"

/* See session_open. */
dm_result models_load(session* session, const char* models);

#endif
