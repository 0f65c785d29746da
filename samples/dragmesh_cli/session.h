/* One run of the tool: a context with its weights, and the file and object that the last job worked on. */
#ifndef CLI_SESSION_H
#define CLI_SESSION_H

#include "cli.h"
#include "dragmesh/dragmesh.h"
#include "dragmesh/ext/gltf.h"

/* What answers: rows of the table that compares them. */
enum session_method {
    METHOD_FULL,     /* network, geometric candidates, ranker */
    METHOD_KPP,      /* the network alone (the paper's plain KPP-Net) */
    METHOD_GEOMETRY, /* no network */
    METHOD_RULES     /* rules set by hand in the ranker's place */
};

typedef struct session {
    dm_context* context;
    dm_model model; /* 0: geometry alone */
    enum session_method method;
    int has_motion;   /* the model has motion weights */
    char error[1024]; /* "DM_ERROR_NAME: what and where", of the last failure */

    char* path; /* of the file below; NULL: none */
    dm_gltf* gltf;
    dm_mesh_desc mesh; /* into gltf, no part ids */

    dm_object object;  /* of the last job; 0: none */
    uint8_t* part_ids; /* it was prepared with; NULL when it came from elsewhere than the file */
    size_t part_id_count;
    int32_t part_id_scope, joint_type;
} session;

/* models: a folder, "none", or NULL (DRAGMESH_MODELS, then beside the program). allocator NULL: malloc. Prints what is
 * wrong and answers an exit status. */
int session_open(session* session, const char* models, const dm_allocator* allocator);
int session_open_method(session* session, const char* models, enum session_method method);
void session_close(session* session);

/* Notes an error of the tool's own in session->error and returns `code`. */
dm_result session_fail(session* session, dm_result code, const char* format, ...) __attribute__((format(printf, 3, 4)));

/* Makes `path` the session's file; nothing to do when it is already. */
dm_result session_use_file(session* session, const char* path);
/* Notes what the object just prepared is made of; ids is the session's from now on. */
void session_take_part_ids(session* session, uint8_t* ids, size_t count, int32_t scope, int32_t joint_type);
/* Forgets the last job's object. */
void session_drop_object(session* session);

#endif
