/* A house door: a key turns back the lock, a handle the latch. Let go ajar, it falls into the latch by itself. */
#include "../scene.h"

enum { BODY, DOOR, HANDLE, KEY };

static const scene_part parts[] = {
    {.name = "door",
     .joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, -1, 0}, .origin = {0, 0, 0.02f}, .upper = 1.75f},
     .rules = {.flags = DM_RULE_LATCH, .latch_turn = 0.5f, .auto_close_share = 0.12f},
     .handle = HANDLE},
    {.name = "handle",
     .parent = DOOR,
     .pulls = 1,
     .joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}, .origin = {0.8325f, 1.0425f, 0}, .upper = 0.8f},
     .feel = {.return_time = 0.15f}},
    {.name = "key",
     .parent = DOOR,
     .joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}, .origin = {0.8325f, 0.9f, 0}, .upper = 1.57f},
     .feel = {.coast_time = -1}},
};

static const scene_shape shapes[] = {
    BOX(BODY, -0.1f, 0, -0.06f, 0, 2.05f, 0.06f), /* posts and lintel … */
    BOX(BODY, 0.9f, 0, -0.06f, 1, 2.05f, 0.06f),           BOX(BODY, -0.1f, 2.05f, -0.06f, 1, 2.15f, 0.06f),
    BOX(BODY, -0.5f, 0, -0.05f, -0.1f, 2.15f, 0.05f), /* … and walls */
    BOX(BODY, 1, 0, -0.05f, 1.4f, 2.15f, 0.05f),           BOX(DOOR, 0.005f, 0.01f, -0.02f, 0.895f, 2.04f, 0.02f),
    BOX(HANDLE, 0.7f, 1.03f, 0.05f, 0.85f, 1.055f, 0.07f), BOX(HANDLE, 0.82f, 1.03f, 0.02f, 0.845f, 1.055f, 0.05f),
    BOX(KEY, 0.827f, 0.88f, 0.02f, 0.838f, 0.92f, 0.06f),  BOX(KEY, 0.815f, 0.885f, 0.02f, 0.85f, 0.915f, 0.028f),
};

static const dm_link links[] = {{.driver = KEY, .driven = DOOR, .kind = DM_LINK_FREES, .from = 1.2f}};

static const scene_hand hands[] = {
    {.part = DOOR, .begin = 0.2f, .grab = {0.7f, 1.3f, 0.02f}, .way = {{0.6f, {0, 0, 0.3f}}}}, /* it is locked */
    {.part = KEY, .begin = 1.2f, .grab = {0.8325f, 0.918f, 0.05f}, .way = {{0.5f, {-0.02f, -0.018f, 0}}}},
    {.part = HANDLE, /* down, to the hand, and nearly shut */
     .begin = 2,
     .grab = {0.72f, 1.04f, 0.06f},
     .way = {{0.3f, {0.034f, -0.081f, 0}}, {0.9f, {-0.33f, 0, 0.6f}}, {0.9f, {0.33f, 0, -0.5f}}}},
};

const scene scene_house_door = {"house_door",  5.5f,  parts,        COUNT(parts), shapes,
                                COUNT(shapes), links, COUNT(links), hands,        COUNT(hands)};
