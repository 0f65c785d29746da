/* A large lid: heavy, so it gains speed slowly. One hand lifts it, a second one joins, the first lets go. */
#include "../scene.h"

enum { BODY, LID };

static const scene_part parts[] = {
    {.name = "lid",
     .joint = {.type = DM_JOINT_REVOLUTE, .axis = {-1, 0, 0}, .origin = {0, 0.5f, 0.05f}, .upper = 1.5f},
     .rules = {.max_speed = 0.8f, .max_acceleration = 1.5f}},
};

static const scene_shape shapes[] = {
    BOX(BODY, 0, 0, 0, 1.6f, 0.5f, 0.05f),           BOX(BODY, 0, 0, 0.75f, 1.6f, 0.5f, 0.8f),
    BOX(BODY, 0, 0, 0.05f, 0.05f, 0.5f, 0.75f),      BOX(BODY, 1.55f, 0, 0.05f, 1.6f, 0.5f, 0.75f),
    BOX(BODY, 0.05f, 0, 0.05f, 1.55f, 0.05f, 0.75f), BOX(LID, -0.02f, 0.502f, 0.04f, 1.62f, 0.58f, 0.84f),
};

static const scene_hand hands[] = {
    {.part = LID, .begin = 0.2f, .grab = {0.3f, 0.54f, 0.84f}, .way = {{0.8f, {0, 0.35f, -0.1f}}, {1.2f, {0, 0, 0}}}},
    {.part = LID,
     .begin = 0.8f,
     .grab = {1.3f, 0.54f, 0.84f},
     .way = {{0.4f, {0, 0, 0}}, {1.2f, {0, 0.4f, -0.3f}}, {1, {0, 0.1f, -0.4f}}}},
};

const scene scene_two_hands = {"two_hands",   4.5f, parts, COUNT(parts), shapes,
                               COUNT(shapes), NULL, 0,     hands,        COUNT(hands)};
