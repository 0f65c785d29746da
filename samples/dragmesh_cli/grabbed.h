/* --moving auto: the part that the grabbed point belongs to. */
#ifndef CLI_GRABBED_H
#define CLI_GRABBED_H

#include <stdbool.h>

#include "job.h"

/* Whether the list asks for it: the one name "auto". */
bool grabbed_asked(const name_list* moving);
/* Sets JOB_PART for the faces of the session's file that move with drag->point, 0 for the others. positions NULL: the
 * file's. merged: as if the file were one mesh without nodes. */
dm_result grabbed_mark(session* session, const float* positions, const dm_drag_hint* drag, int merged,
                       uint8_t* out_face_ids);
/* Names of the nodes that have more than half of their faces in the last job's part, for a result. */
void grabbed_to_json(const session* session, cJSON* out);
/* Writes one 0 or 1 a face, as --mask reads it. 0, or -1 with a line on standard error. */
int grabbed_write(const session* session, const char* path);

#endif
