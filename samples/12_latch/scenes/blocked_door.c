/* A door that a chair stands in the way of: it stops there softly, and goes on to the hand once the chair is away. */
#include "../scene.h"

enum { BODY, CHAIR, DOOR };

static const scene_part parts[] = {
    {.name = "chair", .joint = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .upper = 0.6f}},
    {.name = "door",
     .joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, -1, 0}, .origin = {0, 0, 0.02f}, .upper = 1.75f},
     .obstacle = CHAIR,
     .stops_at = 0.5f,
     .out_of_way = 0.42f},
};

static const scene_shape shapes[] = {
    BOX(BODY, -0.1f, 0, -0.06f, 0, 2.05f, 0.06f),        BOX(BODY, 0.9f, 0, -0.06f, 1, 2.05f, 0.06f),
    BOX(BODY, -0.1f, 2.05f, -0.06f, 1, 2.15f, 0.06f),    BOX(DOOR, 0.005f, 0.01f, -0.02f, 0.895f, 2.04f, 0.02f),
    BOX(DOOR, 0.78f, 0.95f, 0.02f, 0.82f, 1.15f, 0.06f), BOX(CHAIR, 0.5f, 0.42f, 0.5f, 0.9f, 0.46f, 0.9f),
    BOX(CHAIR, 0.86f, 0.46f, 0.5f, 0.9f, 0.9f, 0.9f),    BOX(CHAIR, 0.51f, 0, 0.51f, 0.55f, 0.42f, 0.55f),
    BOX(CHAIR, 0.85f, 0, 0.51f, 0.89f, 0.42f, 0.55f),    BOX(CHAIR, 0.51f, 0, 0.85f, 0.55f, 0.42f, 0.89f),
    BOX(CHAIR, 0.85f, 0, 0.85f, 0.89f, 0.42f, 0.89f),
};

static const scene_hand hands[] = {
    {.part = DOOR, /* it keeps pulling while the other hand takes the chair away */
     .begin = 0.2f,
     .grab = {0.8f, 1.05f, 0.04f},
     .way = {{0.9f, {-0.5f, 0, 0.75f}}, {2.2f, {0, 0, 0}}}},
    {.part = CHAIR, .begin = 1.6f, .grab = {0.88f, 0.8f, 0.7f}, .way = {{0.8f, {0.65f, 0, 0}}}},
};

const scene scene_blocked_door = {"blocked_door", 4.5f, parts, COUNT(parts), shapes,
                                  COUNT(shapes),  NULL, 0,     hands,        COUNT(hands)};
