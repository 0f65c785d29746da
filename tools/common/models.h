/* Finds and loads the weights: --models, DRAGMESH_MODELS, or a folder beside the program. */
#ifndef CLI_MODELS_H
#define CLI_MODELS_H

#include "session.h"

/* Loads the weights into session->model. models: see session_open.h. */
dm_result models_load(session* session, const char* models);

#endif
