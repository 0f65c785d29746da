/* --moving auto: finds the part at the grabbed point. */
#ifndef CLI_PART_AT_POINT_H
#define CLI_PART_AT_POINT_H

#include <stdbool.h>

#include <cjson/cJSON.h>

#include "options.h"
#include "session.h"

/* Whether the list is the one name "auto". */
bool part_at_point_requested(const name_list* moving);
/* Sets out_face_ids to 1 for the faces of the session's file that move with drag->point, 0 for the others. positions
 * NULL: the file's. merged: as if the file were one mesh without nodes. */
dm_result part_at_point_mark(session* session, const float* positions, const dm_drag_hint* drag, bool merged,
                             uint8_t* out_face_ids);
/* Adds the names of the nodes that have more than half of their faces in the last job's part. */
void part_at_point_to_json(const session* session, cJSON* out);
/* Writes one 0 or 1 a face, as --mask reads it. Returns 0, or -1 with a line on standard error. */
int part_at_point_write(const session* session, const char* path);

#endif
