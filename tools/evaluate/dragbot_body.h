/* Whether a part of an object goes through what does not move with it.
 *
 * Points of the part's surface are followed along its motion. A point that crosses a triangle of the body is as deep in
 * it as it lies beyond the triangle's plane, until it comes back, but no deeper than it is off the way on which the
 * true joint takes it. Closed bodies and single sheets count alike. Points that cross the body in the true motion as
 * well, or lie inside it at rest, say nothing. */
#ifndef CLI_DRAGBOT_BODY_H
#define CLI_DRAGBOT_BODY_H

#include "dragbot_object.h"

typedef struct bot_body bot_body;

/* Follows the true motion of a joint's part and remembers which points go through the body then. To be freed. */
bot_body* bot_body_new(const bot_object* object, int joint);
void bot_body_free(bot_body* body);
/* Returns how deep the part gets in the course of its poses, share of the object's size. */
double bot_body_depth(bot_body* body, const bot_part* part, const bot_frame* frames, int count);

#endif
