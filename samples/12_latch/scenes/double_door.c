/* A double door: its leaves go together, whichever is pulled. */
#include "../scene.h"

enum { BODY, LEFT, RIGHT };

static const scene_part parts[] = {
    {.name = "left",
     .joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, -1, 0}, .origin = {-0.9f, 0, 0.02f}, .upper = 1.6f}},
    {.name = "right",
     .joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .origin = {0.9f, 0, 0.02f}, .upper = 1.6f}},
};

static const scene_shape shapes[] = {
    BOX(BODY, -1, 0, -0.06f, -0.9f, 2.05f, 0.06f),       BOX(BODY, 0.9f, 0, -0.06f, 1, 2.05f, 0.06f),
    BOX(BODY, -1, 2.05f, -0.06f, 1, 2.15f, 0.06f),       BOX(LEFT, -0.895f, 0.01f, -0.02f, -0.003f, 2.04f, 0.02f),
    BOX(LEFT, -0.12f, 0.9f, 0.02f, -0.08f, 1.2f, 0.06f), BOX(RIGHT, 0.003f, 0.01f, -0.02f, 0.895f, 2.04f, 0.02f),
    BOX(RIGHT, 0.08f, 0.9f, 0.02f, 0.12f, 1.2f, 0.06f),
};

/* Both joints open by a positive value, so the ratio is 1. */
static const dm_link links[] = {{.driver = LEFT, .driven = RIGHT, .ratio = 1, .flags = DM_LINK_BOTH_WAYS}};

static const scene_hand hands[] = {
    {.part = LEFT,
     .begin = 0.2f,
     .grab = {-0.1f, 1.05f, 0.04f},
     .way = {{0.5f, {-0.1f, 0, 0.45f}}, {0.5f, {-0.41f, 0, 0.3f}}}},
    {.part = RIGHT,
     .begin = 2,
     .grab = {0.1f, 1.05f, 0.04f},
     .way = {{0.6f, {-0.41f, 0, -0.3f}}, {0.6f, {-0.12f, 0, -0.46f}}}},
};

const scene scene_double_door = {"double_door", 4,     parts,        COUNT(parts), shapes,
                                 COUNT(shapes), links, COUNT(links), hands,        COUNT(hands)};
