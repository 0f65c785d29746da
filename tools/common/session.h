/* State of one run of the tool: a context with its weights, and the file and object of the last job. */
#ifndef CLI_SESSION_H
#define CLI_SESSION_H

#include <stdbool.h>

#include <cjson/cJSON.h>

#include "cli.h"
#include "dragmesh/dragmesh.h"
#include "dragmesh/ext/gltf.h"
#include "part_hints.h"
#include "platform.h"

/* Which inference method answers; docs/accuracy.md compares them. */
enum session_method {
    METHOD_FULL,     /* network, geometric candidates, ranker */
    METHOD_KPP,      /* the network alone (the paper's plain KPP-Net) */
    METHOD_GEOMETRY, /* no network */
    METHOD_RULES     /* rules set by hand in the ranker's place */
};

/* Beside the library's results, which are 0 and below: a file could not be written. */
#define SESSION_NOT_WRITTEN ((dm_result)1)

typedef struct warnings {
    char** texts;
    int count;
} warnings;

typedef struct session {
    dm_context* context;
    dm_model model; /* 0: geometry alone */
    enum session_method method;
    bool has_motion;  /* the model has motion weights */
    char error[1024]; /* "DM_ERROR_NAME: what and where", of the last failure */

    /* What was warned of: of the file below, and of the object below. */
    warnings file_warnings, object_warnings;
    bool opens_file;
    char* warned;  /* the last warning on standard error; NULL: none */
    bool is_quiet; /* warnings are kept, and not printed */

    char* path; /* of the file below; NULL: none */
    dm_gltf* gltf;
    dm_mesh_desc mesh; /* into gltf, no part ids */
    double origin[3];  /* of the mesh, in the file's frame */

    dm_object object;  /* of the last job; 0: none */
    uint8_t* part_ids; /* it was prepared with; NULL when it came from elsewhere than the file */
    size_t part_id_count;
    int32_t part_id_scope, joint_type;
    part_hints hints; /* it was prepared with */
} session;

/* Creates the context; false with session->error set on failure. allocator NULL: malloc. */
bool session_init(session* session, const dm_allocator* allocator, enum session_method method);
void session_close(session* session);

/* Sets session->error to an error of the tool's own and returns `code`. */
dm_result session_fail(session* session, dm_result code, const char* format, ...) PLATFORM_PRINTF(3, 4);
/* Adds where it was to session->error, such as " (in 'FILE')", unless it names the path already. */
void session_add_place(session* session, const char* preposition, const char* path);
/* Sets session->error to what errno says of a file that could not be written, and returns SESSION_NOT_WRITTEN. */
dm_result session_fail_to_write(session* session, const char* path);
/* Writes a whole file; session->error. */
dm_result session_write(session* session, const char* path, const void* data, size_t size);

/* The log that keeps the library's messages in the session. */
dm_log session_log(session* session);

/* DM_PREPARE_* for an object of the session's file and method. */
uint32_t session_prepare_flags(const session* session);

/* Makes `path` the session's file; does nothing when it is already. */
dm_result session_use_file(session* session, const char* path);
/* A point of the file's frame in the mesh's. */
dm_vec3 session_point(const session* session, const double point[3]);
/* Stores the part ids that the object was just prepared with; takes ownership of `ids`. */
void session_own_part_ids(session* session, uint8_t* ids, size_t count, int32_t scope, int32_t joint_type);
/* Adds the warnings of file and object to an answer, as its member `warnings`; none: adds nothing. */
void session_warnings_to_json(const session* session, cJSON* out);
/* Destroys the last job's object. */
void session_release_object(session* session);

/* Returns 1 for the faces of the moving part, else 0; what a picture or an animation shows. To be freed. */
uint8_t* session_moving_faces(const session* session);

#endif
