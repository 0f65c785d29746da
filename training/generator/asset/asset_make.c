/* Makes an asset: draws an object, changes it as asset_layer.h says, poses it, and deals it to nodes. */
#include <stdlib.h>
#include <string.h>

#include "asset/asset_layer.h"
#include "core/make.h"

/* Opens some parts of some assets, which their authors left so. Messy objects are opened by dmg_finish. */
static void open_parts(dmg_builder* b) {
    const bool open = dmg_chance(b, 0.15f), wide = dmg_chance(b, 0.5f);
    const float share = dmg_range(b, 0.3f, 1.0f);
    for (uint32_t i = 0; i < b->part_count; ++i) {
        dmg_part* part = &b->parts[i];
        if (part->keep_rest || part->joint.type == DM_JOINT_CONTINUOUS || !dmg_chance(b, share) || !open) continue;
        const float far = part->joint.upper > -part->joint.lower ? part->joint.upper : part->joint.lower;
        part->rest = wide ? far : dmg_range(b, part->joint.lower, part->joint.upper);
    }
}

/* Draws the object and all that the layer adds, at rest. Returns the first piece that lies loose; writes their end. */
static uint32_t draw_asset(dmg_builder* b, uint32_t category, uint64_t seed, uint32_t flags, uint32_t* out_end) {
    dmg_draw_category(b, category, seed, flags);
    b->frame_depth = 0;
    b->frames[0] = dmg_frame_identity(); /* a category's last frame must not move what is added */
    b->mirrored[0] = false;
    b->lone = true;
    dmg_use(b, 0);
    if (!dmg_make_still(b)) dmg_fix_parts(b);
    dmg_cut_boards(b);
    dmg_add_fixtures(b);
    dmg_add_carried(b);
    const uint32_t first = b->piece_count;
    dmg_add_things(b);
    *out_end = b->piece_count;
    if (!b->messy) open_parts(b);
    dmg_finish(b);
    return first;
}

int dmg_make_asset(uint32_t category, uint64_t seed, uint32_t flags, dmg_asset* out_asset) {
    if (category >= dmg_category_count()) return 1;
    dmg_asset asset = {0};
    dmg_builder* b = malloc(sizeof *b);
    if (!b) return 1;
    uint32_t thing_end;
    const uint32_t first_thing = draw_asset(b, category, seed, flags, &thing_end);
    const bool soup = b->messy && dmg_chance(b, 0.15f);
    int failed = dmg_take_object(b, category, soup, &asset.object);
    failed = failed || dmg_split_nodes(b, first_thing, thing_end, &asset);
    failed = failed || dmg_plant_nodes(b, &asset);
    if (!failed) dmg_name_nodes(b, &asset);
    dmg_builder_free(b);
    free(b);
    if (failed) {
        dmg_asset_release(&asset);
        return 1;
    }
    *out_asset = asset;
    return 0;
}

void dmg_asset_release(dmg_asset* asset) {
    dmg_object_release(&asset->object);
    free(asset->face_node);
    free(asset->nodes);
    memset(asset, 0, sizeof *asset);
}
