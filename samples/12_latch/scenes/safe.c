/* A safe: a dial with twelve detents frees the bolt from the eighth on, the bolt frees the heavy door. */
#include "../scene.h"

#define DETENT 0.5235988f /* rad: 30 degrees */

enum { BODY, DOOR, DIAL, BOLT };

static const scene_part parts[] = {
    {.name = "door",
     .joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, -1, 0}, .origin = {0.02f, 0, 0.03f}, .upper = 1.8f},
     .feel = {.smoothing_time = 0.06f, .coast_time = 0.2f}},
    {.name = "dial",
     .parent = DOOR,
     .joint = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, -1}, .origin = {0.4f, 0.33f, 0}},
     .feel = {.detent = DETENT}},
    {.name = "bolt",
     .parent = DOOR,
     .joint = {.type = DM_JOINT_PRISMATIC, .axis = {-1, 0, 0}, .upper = 0.06f},
     .feel = {.coast_time = -1}},
};

static const scene_shape shapes[] = {
    BOX(BODY, 0, 0, -0.5f, 0.6f, 0.6f, -0.48f),
    BOX(BODY, 0, 0, -0.48f, 0.02f, 0.6f, 0.02f),
    BOX(BODY, 0.58f, 0, -0.48f, 0.6f, 0.6f, 0.02f),
    BOX(BODY, 0.02f, 0, -0.48f, 0.58f, 0.02f, 0.02f),
    BOX(BODY, 0.02f, 0.58f, -0.48f, 0.58f, 0.6f, 0.02f),
    BOX(DOOR, 0.022f, 0.022f, -0.02f, 0.578f, 0.578f, 0.03f),
    WHEEL(DIAL, 0.4f, 0.33f, 0.08f, 0.03f, 0.06f, 12),
    BOX(DIAL, 0.395f, 0.36f, 0.06f, 0.405f, 0.405f, 0.064f), /* its mark */
    BOX(BOLT, 0.17f, 0.31f, 0.03f, 0.27f, 0.35f, 0.07f),
};

static const dm_link links[] = {
    {.driver = DIAL, .driven = BOLT, .kind = DM_LINK_FREES, .from = 7.5f * DETENT},
    {.driver = BOLT, .driven = DOOR, .kind = DM_LINK_FREES, .from = 0.05f},
};

static const scene_hand hands[] = {
    {.part = BOLT, .begin = 0.2f, .grab = {0.2f, 0.33f, 0.05f}, .way = {{0.3f, {-0.06f, 0, 0}}}}, /* it is held */
    {.part = DIAL,
     .begin = 0.8f,
     .grab = {0.4f, 0.4f, 0.06f},
     .way = {{0.4f, {0.0606f, -0.035f, 0}},
             {0.4f, {0, -0.07f, 0}},
             {0.4f, {-0.0606f, -0.035f, 0}},
             {0.4f, {-0.0606f, 0.035f, 0}}}},
    {.part = BOLT, .begin = 2.8f, .grab = {0.2f, 0.33f, 0.05f}, .way = {{0.4f, {-0.07f, 0, 0}}}},
    {.part = DOOR, .begin = 3.4f, .grab = {0.5f, 0.5f, 0.03f}, .way = {{1.2f, {-0.25f, 0, 0.42f}}}},
};

const scene scene_safe = {"safe",        6,     parts,        COUNT(parts), shapes,
                          COUNT(shapes), links, COUNT(links), hands,        COUNT(hands)};
