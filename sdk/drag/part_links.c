/* Links that move parts form trees: a part has one driver at most, and never drives itself over others. So one pass up
 * to the root of what goes both ways and one pass down again do all. */
#include "drag/part_links.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

/* Returns the link that drives a part; NULL: none. */
static const dmi_link* driver_of(const dmi_link* links, uint32_t count, uint32_t part) {
    for (uint32_t i = 0; i < count; i++) {
        if (links[i].kind == DM_LINK_MOVES && links[i].driven == part) return &links[i];
    }
    return NULL;
}

/* Returns how many links drive a part one over the other. A number above `count` means that they form a circle. */
static uint32_t depth_of(const dmi_link* links, uint32_t count, uint32_t part) {
    uint32_t depth = 0;
    for (const dmi_link* up = driver_of(links, count, part); up != NULL && depth <= count; depth++)
        up = driver_of(links, count, up->driver);
    return depth;
}

bool dmi_links_order(dmi_link* links, uint32_t count, dmi_link* scratch) {
    uint32_t sorted = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (links[i].kind != DM_LINK_MOVES) continue;
        if (driver_of(links, count, links[i].driven) != &links[i]) return false; /* another link drives it too */
        if (depth_of(links, count, links[i].driven) > count) return false;
    }
    for (uint32_t depth = 0; depth <= count && sorted < count; depth++) {
        for (uint32_t i = 0; i < count; i++) {
            const uint32_t level = links[i].kind == DM_LINK_MOVES ? depth_of(links, count, links[i].driver) : 0;
            if (level == depth) scratch[sorted++] = links[i];
        }
    }
    if (count > 0) memcpy(links, scratch, count * sizeof *links);
    return true;
}

/* Returns how far a driver is beyond `from`, on the side of rest where that lies. */
static float way_beyond(const dmi_link* link, float value) {
    if (link->from > 0) return dmi_fmaxf(value - link->from, 0);
    if (link->from < 0) return dmi_fminf(value - link->from, 0);
    return value;
}

static void set_value(dmi_linked_joints joints, uint32_t part, float value, float* values, uint8_t* changed) {
    if (!isfinite(value)) return;
    const uint8_t* joint = (const uint8_t*)joints.first + part * joints.stride;
    values[part] = dmi_joint_clamp((const dm_joint*)(const void*)joint, value);
    changed[part] = 1;
}

void dmi_links_follow(const dmi_link* links, uint32_t count, dmi_linked_joints joints, uint32_t moved, float* values,
                      uint8_t* changed) {
    changed[moved] = 1;
    for (uint32_t i = count; i-- > 0;) { /* drivers come first in the list, so the way up begins at its end */
        const dmi_link* link = &links[i];
        if (link->kind != DM_LINK_MOVES || !link->both_ways || link->ratio == 0 || !changed[link->driven]) continue;
        if (values[link->driven] == link->offset && way_beyond(link, values[link->driver]) == 0)
            continue; /* the driven part stays as it is */
        set_value(joints, link->driver, link->from + (values[link->driven] - link->offset) / link->ratio, values,
                  changed);
    }
    for (uint32_t i = 0; i < count; i++) {
        const dmi_link* link = &links[i];
        if (link->kind != DM_LINK_MOVES || !changed[link->driver]) continue;
        set_value(joints, link->driven, link->offset + link->ratio * way_beyond(link, values[link->driver]), values,
                  changed);
    }
}

/* Returns whether a driver has reached `from`, on the side of rest where that lies. With 0 it always has. */
static bool has_reached(const dmi_link* link, float value) {
    if (link->from > 0) return value >= link->from;
    return link->from == 0 || value <= link->from;
}

void dmi_links_hold(const dmi_link* links, uint32_t count, const float* values, uint8_t* out_held,
                    uint32_t part_count) {
    memset(out_held, 0, part_count);
    for (uint32_t i = 0; i < count; i++) {
        const bool reached = has_reached(&links[i], values[links[i].driver]);
        if (links[i].kind == DM_LINK_FREES && !reached) out_held[links[i].driven] = 1;
        if (links[i].kind == DM_LINK_HOLDS && reached) out_held[links[i].driven] = 1;
    }
}
