/* A gear train that moves a rack. The part with limits is on top of the tree of links: when the rack is at its end, the
 * gears stop too, whichever is turned. */
#include "../scene.h"

#define RACK_RATIO 12.5f   /* rad of the small gear a metre of the rack: one over its radius */
#define GEAR_RATIO (-0.5f) /* 8 teeth drive 16 */

enum { BODY, RACK, SMALL, LARGE };

static const scene_part parts[] = {
    {.name = "rack", .joint = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = -0.05f, .upper = 0.25f}},
    {.name = "small", .joint = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}, .origin = {-0.06f, 0, 0}}},
    {.name = "large", .joint = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}, .origin = {-0.3f, 0, 0}}},
};

#define TOOTH(x) BOX(RACK, x, -0.1f, 0.01f, (x) + 0.03f, -0.08f, 0.05f)

static const scene_shape shapes[] = {
    BOX(BODY, -0.55f, -0.25f, -0.04f, 0.5f, 0.25f, 0),
    WHEEL(SMALL, -0.06f, 0, 0.085f, 0.01f, 0.05f, 8),
    WHEEL(SMALL, -0.06f, 0, 0.02f, 0.05f, 0.07f, ROUND),
    WHEEL(LARGE, -0.3f, 0, 0.165f, 0.01f, 0.05f, 16),
    WHEEL(LARGE, -0.3f, 0, 0.03f, 0.05f, 0.07f, ROUND),
    WHEEL(LARGE, -0.3f, 0.12f, 0.015f, 0.05f, 0.12f, ROUND), /* its crank */
    BOX(RACK, -0.25f, -0.14f, 0.01f, 0.2f, -0.1f, 0.05f),
    TOOTH(-0.25f),
    TOOTH(-0.19f),
    TOOTH(-0.13f),
    TOOTH(-0.07f),
    TOOTH(-0.01f),
    TOOTH(0.05f),
    TOOTH(0.11f),
    TOOTH(0.17f),
};

static const dm_link links[] = {
    {.driver = RACK, .driven = SMALL, .ratio = RACK_RATIO, .flags = DM_LINK_BOTH_WAYS},
    {.driver = SMALL, .driven = LARGE, .ratio = GEAR_RATIO, .flags = DM_LINK_BOTH_WAYS},
};

static const scene_hand hands[] = {
    {.part = LARGE, /* clockwise by 135 degrees; the rack stops it at 90 */
     .begin = 0.2f,
     .grab = {-0.3f, 0.12f, 0.12f},
     .way = {{0.4f, {0.085f, -0.035f, 0}}, {0.4f, {0.035f, -0.085f, 0}}, {0.4f, {-0.035f, -0.085f, 0}}}},
    {.part = RACK, .begin = 2.2f, .grab = {-0.02f, -0.12f, 0.05f}, .way = {{0.8f, {-0.25f, 0, 0}}}},
};

const scene scene_gears = {"gears",       3.5f,  parts,        COUNT(parts), shapes,
                           COUNT(shapes), links, COUNT(links), hands,        COUNT(hands)};
