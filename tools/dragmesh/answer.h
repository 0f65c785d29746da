/* Answers as JSON and as text. */
#ifndef DRAGMESH_ANSWER_H
#define DRAGMESH_ANSWER_H

#include "job.h"

/* Adds type, axis, origin … to a result object. */
void answer_to_json(const joint_answer* answer, cJSON* out);
void answer_print(const joint_answer* answer);
/* frame: origin of the joint's frame, which is added to the joint's own. */
void joint_to_json(const dm_joint* joint, const double frame[3], cJSON* out);
/* Says what the percentages of joint_print are. */
void confidence_print(void);
void joint_print(const dm_joint* joint, const double frame[3]);

#endif
