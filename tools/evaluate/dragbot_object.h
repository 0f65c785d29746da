/* An object prepared and placed for the scripted player, and where it looks at a part from. */
#ifndef CLI_DRAGBOT_OBJECT_H
#define CLI_DRAGBOT_OBJECT_H

#include "dragbot.h"

enum { BOT_MAX_PARTS = 250 }; /* whose ids fit a byte; by hand */

typedef struct bot_object {
    session* session;
    known_object known;
    uint8_t* face_parts;
    uint32_t* part_of_joint; /* 0: none of its own */
    uint32_t part_count;
    int hints;   /* HINTS_*: what the library is told of what the dataset has */
    vec told_up; /* the upward direction that it is told; zeros: none */
    vec up, centre;
    double radius, size;
    dm_scene scene;
    bot_view view;
} bot_object;

/* Prepares all parts at once. object->session, known, up and hints must be set; to be taken down whatever is returned.
 */
dm_result bot_object_set_up(bot_object* object);
/* Prepares the part of one joint, with all that it carries; whatever else the object has is its body. */
dm_result bot_object_set_up_alone(bot_object* object, int joint);
void bot_object_take_down(bot_object* object);
/* Whether a face is the joint's part's own. */
bool bot_object_owns(const bot_object* object, int joint, uint64_t face);
/* Fills the ids of the parts that go with a joint: its own, and what that carries. */
void bot_object_moving(const bot_object* object, int joint, bool out_moves[BOT_MAX_PARTS + 1]);
/* Draws points of the surface of some parts, evenly by area and in random order. */
void bot_object_sample(const bot_object* object, const bool parts[BOT_MAX_PARTS + 1], random_state* random,
                       vec* out_points, int count);
bot_part bot_object_part(const bot_object* object, int joint);

/* ---- where the camera is ---- */

enum bot_sight {
    BOT_AROUND, /* directions spread round the object */
    BOT_END_ON, /* on the way of the grabbed point, looking at it; pulls to four sides */
    BOT_ABOVE,
    BOT_BEHIND /* on the side opposite to the opening */
};

/* Returns how many places a sight has. */
int bot_sight_places(enum bot_sight sight);
/* Looks at a joint's part from a place of a sight and chooses what to grab and where to pull. Returns 1; 0: the part is
 * not visible; -1: visible, but no point of it has a path that a mouse can draw. */
int bot_sight_choose(bot_object* object, int joint, const bot_part* part, enum bot_sight sight, int place,
                     random_state* random, bot_pull* out_pull);

#endif
