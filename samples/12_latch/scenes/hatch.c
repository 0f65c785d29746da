/* A hatch in the floor: let go before it is upright it falls shut and bounces, beyond that it falls open. */
#include "../scene.h"

enum { BODY, LID };

static const scene_part parts[] = {
    {.name = "lid",
     .joint = {.type = DM_JOINT_REVOLUTE, .axis = {-1, 0, 0}, .origin = {0, 0.05f, 0}, .upper = 1.9f},
     .rules = {.tip_share = 0.83f, .fall_time = 0.6f, .restitution = 0.25f}},
};

static const scene_shape shapes[] = {
    BOX(BODY, -0.4f, 0, -0.4f, 0, 0.05f, 1.3f),
    BOX(BODY, 0.9f, 0, -0.4f, 1.3f, 0.05f, 1.3f),
    BOX(BODY, 0, 0, -0.4f, 0.9f, 0.05f, 0),
    BOX(BODY, 0, 0, 0.9f, 0.9f, 0.05f, 1.3f),
    BOX(LID, 0.005f, 0.005f, 0.005f, 0.895f, 0.05f, 0.895f),
    BOX(LID, 0.35f, 0.05f, 0.78f, 0.55f, 0.08f, 0.82f),
};

static const scene_hand hands[] = {
    {.part = LID, .begin = 0.2f, .grab = {0.45f, 0.08f, 0.8f}, .way = {{0.7f, {0, 0.68f, -0.4f}}}},
    {.part = LID,
     .begin = 2.4f,
     .grab = {0.45f, 0.08f, 0.8f},
     .way = {{0.5f, {0, 0.7f, -0.4f}}, {0.5f, {0, 0.12f, -0.6f}}}},
};

const scene scene_hatch = {"hatch", 4.5f, parts, COUNT(parts), shapes, COUNT(shapes), NULL, 0, hands, COUNT(hands)};
