/* A cabinet of three drawers, of which one opens at a time, so that it does not tip over. */
#include "../scene.h"

enum { BODY, TOP, MIDDLE, BOTTOM };

#define DRAWER(title)                                                                                                  \
    {                                                                                                                  \
        .name = (title), .joint = {.type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .upper = 0.32f }                     \
    }
#define DRAWER_SHAPES(part, y)                                                                                         \
    BOX(part, 0.01f, y, 0.402f, 0.49f, (y) + 0.22f, 0.42f),                                                            \
        BOX(part, 0.2f, (y) + 0.1f, 0.42f, 0.3f, (y) + 0.12f, 0.45f),                                                  \
        BOX(part, 0.03f, (y) + 0.01f, 0.03f, 0.47f, (y) + 0.02f, 0.402f),                                              \
        BOX(part, 0.03f, (y) + 0.02f, 0.03f, 0.04f, (y) + 0.18f, 0.402f),                                              \
        BOX(part, 0.46f, (y) + 0.02f, 0.03f, 0.47f, (y) + 0.18f, 0.402f),                                              \
        BOX(part, 0.04f, (y) + 0.02f, 0.03f, 0.46f, (y) + 0.18f, 0.04f)
#define HOLDS(open, other)                                                                                             \
    { .driver = (open), .driven = (other), .kind = DM_LINK_HOLDS, .from = 0.02f }

static const scene_part parts[] = {DRAWER("top"), DRAWER("middle"), DRAWER("bottom")};

static const scene_shape shapes[] = {
    BOX(BODY, 0, 0, 0, 0.5f, 0.72f, 0.02f),
    BOX(BODY, 0, 0, 0.02f, 0.02f, 0.72f, 0.4f),
    BOX(BODY, 0.48f, 0, 0.02f, 0.5f, 0.72f, 0.4f),
    BOX(BODY, 0, 0.72f, 0, 0.5f, 0.74f, 0.42f),
    BOX(BODY, 0.02f, 0, 0.02f, 0.48f, 0.015f, 0.4f),
    DRAWER_SHAPES(TOP, 0.49f),
    DRAWER_SHAPES(MIDDLE, 0.255f),
    DRAWER_SHAPES(BOTTOM, 0.02f),
};

static const dm_link links[] = {
    HOLDS(TOP, MIDDLE),    HOLDS(TOP, BOTTOM), HOLDS(MIDDLE, TOP),
    HOLDS(MIDDLE, BOTTOM), HOLDS(BOTTOM, TOP), HOLDS(BOTTOM, MIDDLE),
};

static const scene_hand hands[] = {
    {.part = TOP, .begin = 0.2f, .grab = {0.25f, 0.6f, 0.45f}, .way = {{0.6f, {0, 0, 0.3f}}}},
    {.part = BOTTOM, .begin = 1.2f, .grab = {0.25f, 0.13f, 0.45f}, .way = {{0.4f, {0, 0, 0.2f}}}}, /* it is held */
    {.part = TOP, .begin = 2, .grab = {0.25f, 0.6f, 0.45f}, .way = {{0.6f, {0, 0, -0.31f}}}},
    {.part = BOTTOM, .begin = 3.2f, .grab = {0.25f, 0.13f, 0.45f}, .way = {{0.6f, {0, 0, 0.33f}}}},
};

const scene scene_drawers = {"drawers",     4.5f,  parts,        COUNT(parts), shapes,
                             COUNT(shapes), links, COUNT(links), hands,        COUNT(hands)};
