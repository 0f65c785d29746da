/* Binned splits by the surface area heuristic. */
#include "pick/box_split.h"

#include <math.h>
#include <stdbool.h>

#include "pick/lanes.h"

#define BINS 16          /* an axis; by hand: 32 build 15 % slower and trace no faster */
#define MANY 64          /* items from which on DMI_SPLIT_FAST looks along one axis; by hand */
#define BIN_EDGE 0.9999f /* factor of BINS: keeps the largest centre in the last bin; by hand */

typedef struct bins {
    dmi_box box[3][BINS];
    uint32_t count[3][BINS];
} bins;

/* Bins along each axis: (centre - low) * scale. */
typedef struct binning {
    float low[4], scale[4];
    int bins;        /* BINS, or as many as items */
    int first, last; /* axes that are looked at */
} binning;

typedef struct split {
    float cost;
    int axis, bin; /* the first bin of the second group */
} split;

static dmi_lanes item_low(const dmi_box_item* item) {
    return dmi_lanes_load(item->low);
}

static dmi_lanes item_high(const dmi_box_item* item) {
    return dmi_lanes_load(item->high);
}

static void clear(dmi_box* box) {
    dmi_lanes_store(box->low, dmi_lanes_all(INFINITY));
    dmi_lanes_store(box->high, dmi_lanes_all(-INFINITY));
}

static void grow(dmi_box* box, dmi_lanes low, dmi_lanes high) {
    dmi_lanes_store(box->low, dmi_lanes_min(low, dmi_lanes_load(box->low)));
    dmi_lanes_store(box->high, dmi_lanes_max(high, dmi_lanes_load(box->high)));
}

static void start(dmi_box_range* range, uint32_t first) {
    clear(&range->box);
    clear(&range->centres);
    range->first = first;
    range->count = 0;
}

static void add(dmi_box_range* range, const dmi_box_item* item) {
    const dmi_lanes low = item_low(item), high = item_high(item), centre = dmi_lanes_add(low, high);
    grow(&range->box, low, high);
    grow(&range->centres, centre, centre);
    range->count++;
}

void dmi_box_range_measure(const dmi_box_item* items, dmi_box_range* range) {
    const uint32_t count = range->count;
    start(range, range->first);
    for (uint32_t i = 0; i < count; i++) add(range, &items[range->first + i]);
}

static int longest_axis(const dmi_box* box) {
    int longest = 0;
    for (int axis = 1; axis < 3; axis++)
        if (box->high[axis] - box->low[axis] > box->high[longest] - box->low[longest]) longest = axis;
    return longest;
}

static binning make_binning(const dmi_box* centres, uint32_t count, dmi_box_splits how) {
    binning b = {{0}, {0}, count < BINS ? (int)count : BINS, 0, 2};
    if (how == DMI_SPLIT_FAST && count >= MANY) b.first = b.last = longest_axis(centres);
    for (int axis = 0; axis < 3; axis++) {
        const float extent = centres->high[axis] - centres->low[axis];
        b.low[axis] = centres->low[axis];
        const float scale = extent > 0 ? (float)b.bins * BIN_EDGE / extent : 0;
        b.scale[axis] = isfinite(scale) ? scale : 0;
    }
    return b;
}

static void find_bins(const binning* b, dmi_lanes centre, float out[4]) {
    dmi_lanes_store(out, dmi_lanes_mul(dmi_lanes_sub(centre, dmi_lanes_load(b->low)), dmi_lanes_load(b->scale)));
}

static void clear_bins(const binning* b, bins* out) {
    for (int axis = b->first; axis <= b->last; axis++)
        for (int i = 0; i < b->bins; i++) {
            clear(&out->box[axis][i]);
            out->count[axis][i] = 0;
        }
}

static inline void put_into_bins(const dmi_box_item* item, const binning* b, bins* out) {
    const dmi_lanes low = item_low(item), high = item_high(item);
    float bin[4];
    find_bins(b, dmi_lanes_add(low, high), bin);
    for (int axis = b->first; axis <= b->last; axis++) {
        const int k = (int)bin[axis];
        grow(&out->box[axis][k], low, high);
        out->count[axis][k]++;
    }
}

/* Neighbours in the array mostly fall into the same bins, and each would wait for the one before it: of many items,
 * every second one goes into bins of its own. */
static void fill_bins(const dmi_box_item* items, uint32_t count, const binning* b, bins* out) {
    bins others;
    uint32_t i = 0;
    clear_bins(b, out);
    if (count >= MANY) {
        clear_bins(b, &others);
        for (; i + 2 <= count; i += 2) {
            put_into_bins(&items[i], b, out);
            put_into_bins(&items[i + 1], b, &others);
        }
        for (int axis = b->first; axis <= b->last; axis++)
            for (int k = 0; k < b->bins; k++) {
                const dmi_box* more = &others.box[axis][k];
                grow(&out->box[axis][k], dmi_lanes_load(more->low), dmi_lanes_load(more->high));
                out->count[axis][k] += others.count[axis][k];
            }
    }
    for (; i < count; i++) put_into_bins(&items[i], b, out);
}

static float group_cost(const dmi_box* box, uint32_t count, uint32_t block) {
    const uint32_t blocks = (count + block - 1) / block;
    return dmi_box_area(box) * (float)blocks;
}

/* Takes the best split of an axis where it beats `best`. */
static void sweep(const bins* b, int size, int axis, uint32_t block, split* best) {
    float behind[BINS]; /* cost of the bins from i on */
    dmi_box box;
    uint32_t count = 0;
    clear(&box);
    for (int i = size - 1; i > 0; i--) {
        grow(&box, dmi_lanes_load(b->box[axis][i].low), dmi_lanes_load(b->box[axis][i].high));
        count += b->count[axis][i];
        behind[i] = count > 0 ? group_cost(&box, count, block) : INFINITY;
    }
    clear(&box);
    count = 0;
    for (int i = 1; i < size; i++) {
        grow(&box, dmi_lanes_load(b->box[axis][i - 1].low), dmi_lanes_load(b->box[axis][i - 1].high));
        count += b->count[axis][i - 1];
        const float cost = count > 0 ? group_cost(&box, count, block) + behind[i] : INFINITY;
        if (cost < best->cost) *best = (split){cost, axis, i};
    }
}

static void halves(const dmi_box_item* items, const dmi_box_range* range, dmi_box_range out[2]) {
    const uint32_t first = range->first, count = range->count, half = count / 2;
    out[0].first = first;
    out[0].count = half;
    out[1].first = first + half;
    out[1].count = count - half;
    dmi_box_range_measure(items, &out[0]);
    dmi_box_range_measure(items, &out[1]);
}

/* The box of the items in some bins of an axis. */
static void unite_bins(const bins* b, int axis, int first, int end, dmi_box* out) {
    clear(out);
    for (int i = first; i < end; i++)
        grow(out, dmi_lanes_load(b->box[axis][i].low), dmi_lanes_load(b->box[axis][i].high));
}

/* Sorts the items by their bins, whose boxes make those of the groups. */
static void part(dmi_box_item* items, const dmi_box_range* range, const binning* b, const bins* filled, const split* s,
                 dmi_box_range out[2]) {
    const uint32_t first = range->first, end = first + range->count;
    uint32_t low = first, high = end;
    dmi_box centres[2];
    clear(&centres[0]);
    clear(&centres[1]);
    while (low < high) {
        float bin[4];
        const dmi_lanes centre = dmi_lanes_add(item_low(&items[low]), item_high(&items[low]));
        find_bins(b, centre, bin);
        if ((int)bin[s->axis] < s->bin) {
            grow(&centres[0], centre, centre);
            low++;
        } else {
            grow(&centres[1], centre, centre);
            const dmi_box_item item = items[low];
            items[low] = items[--high];
            items[high] = item;
        }
    }
    out[0] = (dmi_box_range){.centres = centres[0], .first = first, .count = low - first};
    out[1] = (dmi_box_range){.centres = centres[1], .first = low, .count = end - low};
    unite_bins(filled, s->axis, 0, s->bin, &out[0].box);
    unite_bins(filled, s->axis, s->bin, b->bins, &out[1].box);
}

/* Tells of a large range that one more pass is done. Returns whether to go on. */
static bool tell(const dmi_box_range* range, const dmi_progress* progress) {
    return range->count < DMI_PROGRESS_STEP || dmi_progress_tell(progress, 0) == DM_OK;
}

/* Sorts a range of two items or more into two, neither empty; `out` may include `range`. False when it is cancelled. */
static bool split_range(dmi_box_item* items, const dmi_box_range* range, uint32_t block, dmi_box_splits how,
                        const dmi_progress* progress, dmi_box_range out[2]) {
    const binning b = make_binning(&range->centres, range->count, how);
    split best = {INFINITY, 0, 0};
    bins filled;
    if (how != DMI_SPLIT_IN_HALVES) {
        fill_bins(items + range->first, range->count, &b, &filled);
        for (int axis = b.first; axis <= b.last; axis++) {
            if (b.scale[axis] > 0) sweep(&filled, b.bins, axis, block, &best);
        }
    }
    if (!tell(range, progress)) return false;
    if (best.cost < INFINITY)
        part(items, range, &b, &filled, &best, out);
    else
        halves(items, range, out);
    return tell(range, progress);
}

/* Index of the range with the largest box of those of more than `block` items; `count` when there is none. */
static uint32_t largest(const dmi_box_range* ranges, uint32_t count, uint32_t block) {
    uint32_t best = count;
    float best_area = -1;
    for (uint32_t i = 0; i < count; i++) {
        if (ranges[i].count <= block) continue;
        const float area = dmi_box_area(&ranges[i].box);
        if (area <= best_area) continue;
        best_area = area;
        best = i;
    }
    return best;
}

uint32_t dmi_box_split_up(dmi_box_item* items, uint32_t block, dmi_box_splits how, dmi_box_range* ranges, uint32_t most,
                          const dmi_progress* progress) {
    uint32_t count = 1;
    while (count < most) {
        const uint32_t i = largest(ranges, count, block);
        if (i == count) break;
        dmi_box_range two[2];
        if (!split_range(items, &ranges[i], block, how, progress, two)) return 0;
        ranges[i] = two[0];
        ranges[count++] = two[1];
    }
    return count;
}
