/* Deals an object's faces to nodes as exporters do: a node a link, a node a shape, a node a material, or a node for
 * what lies near to each other. The atoms that are dealt are the shapes that a category drew, or their shells. Shares
 * are set by hand after counts of public assets: from 2 nodes of game props to some 30, sometimes 100, of scanned
 * catalogues. */
#include <stdlib.h>
#include <string.h>

#include "asset/asset_layer.h"

enum { NODE_LIMIT = 160, SHELL_LIMIT = 12 };

typedef enum way { WHOLE, EACH, NEAR, MATERIAL, WAYS } way;

typedef struct atom {
    uint32_t part, faces;
    uint32_t group; /* in its part */
    uint32_t node;
    bool thing; /* lies loose */
    dmg_bounds box;
} atom;

typedef struct dealer {
    dmg_builder* b;
    atom* atoms;
    uint32_t* face_atom;
    uint32_t count, capacity;
    uint32_t first_thing, thing_end; /* pieces */
    bool things_apart;               /* things have nodes of their own, also where all else is one */
    bool by_shell;
    way ways[DMG_PART_LIMIT + 1];
    uint32_t* own; /* the atoms of the part that is dealt */
    uint32_t own_count, node_count;
} dealer;

/* ---- atoms ---- */

static bool open_dealer(dealer* d, dmg_builder* b) {
    d->b = b;
    d->capacity = b->piece_count * 2 + 64;
    d->atoms = calloc(d->capacity, sizeof *d->atoms);
    d->face_atom = malloc((b->face_count + 1) * sizeof *d->face_atom);
    d->own = malloc(d->capacity * sizeof *d->own);
    return d->atoms && d->face_atom && d->own;
}

static void close_dealer(dealer* d) {
    free(d->atoms);
    free(d->face_atom);
    free(d->own);
}

static void put_face(dealer* d, uint32_t face, uint32_t to) {
    const dmg_builder* b = d->b;
    d->face_atom[face] = to;
    ++d->atoms[to].faces;
    for (uint32_t k = 0; k < 3; ++k) dmg_bounds_grow(&d->atoms[to].box, b->vertices[b->indices[3 * face + k]]);
}

/* Makes the atoms of shapes: that of piece p at p. */
static void make_atoms(dealer* d) {
    const dmg_builder* b = d->b;
    d->count = b->piece_count;
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        d->atoms[p].part = b->pieces[p].part;
        d->atoms[p].thing = p >= d->first_thing && p < d->thing_end;
        d->atoms[p].box = dmg_bounds_none();
    }
    for (uint32_t p = 0; p < b->piece_count; ++p)
        for (uint32_t f = b->pieces[p].first_face; f < dmg_piece_face_end(b, p); ++f)
            put_face(d, f, b->pieces[p].drawn_as);
}

/* ---- shells: what hangs together at equal positions ---- */

typedef struct corner_place {
    dmg_vec at;
    uint32_t face;
} corner_place;

static int compare_places(const void* left, const void* right) {
    const corner_place *a = left, *b = right;
    const int order = memcmp(&a->at, &b->at, sizeof a->at);
    return order != 0 ? order : (a->face > b->face) - (a->face < b->face);
}

static uint32_t root_of(uint32_t* above, uint32_t i) {
    while (above[i] != i) i = above[i] = above[above[i]];
    return i;
}

/* Joins faces that share a position. faces: `count` faces of one atom; above: their forest, by index in faces. */
static void join_faces(const dmg_builder* b, const uint32_t* faces, uint32_t count, corner_place* places,
                       uint32_t* above) {
    for (uint32_t i = 0; i < count; ++i) {
        above[i] = i;
        for (uint32_t k = 0; k < 3; ++k)
            places[3 * i + k] = (corner_place){b->vertices[b->indices[3 * faces[i] + k]], i};
    }
    qsort(places, 3 * (size_t)count, sizeof *places, compare_places);
    for (uint32_t i = 1; i < 3 * count; ++i)
        if (memcmp(&places[i].at, &places[i - 1].at, sizeof places->at) == 0)
            above[root_of(above, places[i].face)] = root_of(above, places[i - 1].face);
}

/* Splits an atom into its shells, if there are 2 to SHELL_LIMIT. */
static void split_shells(dealer* d, uint32_t at, uint32_t* faces, corner_place* places, uint32_t* above) {
    uint32_t count = 0, shells = 0, first = UINT32_MAX, made[SHELL_LIMIT], roots[SHELL_LIMIT];
    for (uint32_t f = 0; f < d->b->face_count; ++f)
        if (d->face_atom[f] == at) faces[count++] = f;
    join_faces(d->b, faces, count, places, above);
    for (uint32_t i = 0; i < count; ++i) {
        if (root_of(above, i) != i) continue;
        if (shells == SHELL_LIMIT) return;
        if (first == UINT32_MAX) first = i;
        roots[shells++] = i;
    }
    if (shells < 2 || d->count + shells > d->capacity) return;
    const atom old = d->atoms[at];
    for (uint32_t s = 0; s < shells; ++s) {
        made[s] = s == 0 ? at : d->count++;
        d->atoms[made[s]] = (atom){.part = old.part, .thing = old.thing, .box = dmg_bounds_none()};
    }
    for (uint32_t i = 0; i < count; ++i) {
        uint32_t s = 0;
        while (roots[s] != root_of(above, i)) ++s;
        put_face(d, faces[i], made[s]);
    }
}

static int split_all_shells(dealer* d) {
    const uint32_t room = d->b->face_count + 1, shapes = d->count;
    uint32_t *faces = malloc(room * sizeof *faces), *above = malloc(room * sizeof *above);
    corner_place* places = calloc(3 * (size_t)room, sizeof *places);
    for (uint32_t i = 0; faces && above && places && i < shapes; ++i)
        if (d->atoms[i].faces > 0) split_shells(d, i, faces, places, above);
    const int failed = !faces || !above || !places;
    free(faces);
    free(above);
    free(places);
    return failed;
}

/* ---- dealing the atoms of a part into groups ---- */

static atom* own_atom(const dealer* d, uint32_t i) {
    return &d->atoms[d->own[i]];
}

/* Returns how far boxes are apart, and a little more the farther their middles are. */
static float box_gap(const dmg_bounds* a, const dmg_bounds* b) {
    const dmg_vec gap = v3(fmaxf(fmaxf(a->low.x - b->high.x, b->low.x - a->high.x), 0),
                           fmaxf(fmaxf(a->low.y - b->high.y, b->low.y - a->high.y), 0),
                           fmaxf(fmaxf(a->low.z - b->high.z, b->low.z - a->high.z), 0));
    const dmg_vec off = v3_sub(v3_lerp(a->low, a->high, 0.5f), v3_lerp(b->low, b->high, 0.5f));
    return v3_length(gap) + 0.1f * v3_length(off);
}

/* Deals atoms to the nearest of a few of them. */
static void deal_near(dealer* d, uint32_t groups) {
    uint32_t middle[NODE_LIMIT];
    for (uint32_t g = 0; g < groups; ++g) middle[g] = (uint32_t)dmg_int(d->b, 0, (int)d->own_count - 1);
    for (uint32_t i = 0; i < d->own_count; ++i) {
        float nearest = 1e30f;
        for (uint32_t g = 0; g < groups; ++g) {
            const float gap = box_gap(&own_atom(d, i)->box, &own_atom(d, middle[g])->box);
            if (gap < nearest) nearest = gap, own_atom(d, i)->group = g;
        }
    }
}

/* Deals atoms by what they may be made of: large and small ones, flat-sided and round ones. */
static void deal_material(dealer* d) {
    const bool by_size = dmg_chance(d->b, 0.7f), by_shape = dmg_chance(d->b, 0.6f);
    float largest = 0.0f;
    for (uint32_t i = 0; i < d->own_count; ++i) largest = fmaxf(largest, dmg_largest_side(&own_atom(d, i)->box));
    for (uint32_t i = 0; i < d->own_count; ++i) {
        atom* one = own_atom(d, i);
        const uint32_t small = by_size && dmg_largest_side(&one->box) < 0.35f * largest;
        const uint32_t round = by_shape && one->faces > 24;
        one->group = small + 2 * round;
    }
}

static void deal_each(dealer* d) {
    for (uint32_t i = 0; i < d->own_count; ++i) own_atom(d, i)->group = i;
}

/* Deals the part's atoms into at most `most` groups. */
static void deal_part(dealer* d, uint32_t part, uint32_t most) {
    const uint32_t few = part == 0 ? 12 : 4, wanted = 1 + (uint32_t)dmg_int(d->b, 0, (int)few - 1);
    const way how = d->ways[part];
    if (how == NEAR || (how == EACH && d->own_count > most))
        deal_near(d, how == EACH || wanted > most ? most : wanted);
    else if (how == EACH)
        deal_each(d);
    else if (how == MATERIAL && most >= 4)
        deal_material(d);
    if (!d->things_apart || how == EACH || d->own_count + 4 > most) return;
    for (uint32_t i = 0; i < d->own_count; ++i)
        if (own_atom(d, i)->thing) own_atom(d, i)->group = NODE_LIMIT + i;
}

/* Makes nodes of the groups. */
static void number_nodes(dealer* d) {
    for (uint32_t i = 0; i < d->own_count; ++i) {
        uint32_t j = 0;
        while (own_atom(d, j)->group != own_atom(d, i)->group) ++j;
        own_atom(d, i)->node = j < i ? own_atom(d, j)->node : d->node_count++;
    }
}

static void deal(dealer* d) {
    for (uint32_t part = 0; part <= d->b->part_count; ++part) {
        d->own_count = 0;
        for (uint32_t i = 0; i < d->count; ++i)
            if (d->atoms[i].part == part && d->atoms[i].faces > 0) d->own[d->own_count++] = i;
        const uint32_t left = NODE_LIMIT - d->node_count - (d->b->part_count - part);
        if (d->own_count > 0) deal_part(d, part, left);
        number_nodes(d);
    }
}

/* ---- the asset's style ---- */

/* Returns the first part that is called like this one up to a running number: twins are modelled alike. */
static uint32_t first_twin(const dmg_builder* b, uint32_t part) {
    const char* name = b->parts[part - 1].joint.name;
    const size_t stem = strcspn(name, "_0123456789");
    for (uint32_t i = 1; i < part; ++i)
        if (stem > 0 && strncmp(b->parts[i - 1].joint.name, name, stem) == 0) return i;
    return part;
}

static void draw_style(dealer* d) {
    static const float styles[] = {0.24f, 0.32f, 0.1f, 0.14f, 0.2f}; /* WHOLE … MATERIAL, a mixture */
    static const float mixed[WAYS] = {0.4f, 0.25f, 0.2f, 0.15f};
    const int style = dmg_weighted(d->b, styles, WAYS + 1);
    d->things_apart = dmg_chance(d->b, 0.6f);
    d->by_shell = dmg_chance(d->b, 0.5f) && style != WHOLE;
    for (uint32_t part = 0; part <= d->b->part_count; ++part) {
        const way own = (way)dmg_weighted(d->b, mixed, WAYS);
        const uint32_t twin = part > 0 ? first_twin(d->b, part) : 0;
        d->ways[part] = style != WAYS ? (way)style : twin < part ? d->ways[twin] : own;
    }
}

/* ---- nodes ---- */

/* Draws the order of the nodes in the file: body first, body last, or any. */
static void draw_order(dmg_builder* b, uint32_t* order, uint32_t count) {
    const int how = dmg_int(b, 0, 3);
    for (uint32_t i = 0; i < count; ++i) order[i] = how == 1 ? count - 1 - i : i;
    for (uint32_t i = count; how >= 2 && i-- > 1;) {
        const uint32_t j = (uint32_t)dmg_int(b, 0, (int)i), kept = order[i];
        order[i] = order[j];
        order[j] = kept;
    }
}

static int write_nodes(dealer* d, dmg_asset* asset) {
    uint32_t order[NODE_LIMIT];
    asset->nodes = calloc(d->node_count + 1, sizeof *asset->nodes);
    asset->face_node = malloc((d->b->face_count + 1) * sizeof *asset->face_node);
    if (!asset->nodes || !asset->face_node) return 1;
    asset->node_count = d->node_count;
    draw_order(d->b, order, d->node_count);
    for (uint32_t i = 0; i < d->node_count; ++i)
        asset->nodes[i] = (dmg_asset_node){
            .parent = DMG_NO_NODE, .mesh = i, .loose = 1, .transform = {[0] = 1, [5] = 1, [10] = 1, [15] = 1}};
    for (uint32_t f = 0; f < d->b->face_count; ++f) {
        const atom* one = &d->atoms[d->face_atom[f]];
        dmg_asset_node* node = &asset->nodes[order[one->node]];
        asset->face_node[f] = order[one->node];
        node->part = one->part;
        node->loose &= one->thing;
        ++node->face_count;
    }
    return 0;
}

int dmg_split_nodes(dmg_builder* b, uint32_t first_thing, uint32_t thing_end, dmg_asset* asset) {
    dealer d = {.first_thing = first_thing, .thing_end = thing_end};
    int failed = !open_dealer(&d, b);
    if (!failed) {
        make_atoms(&d);
        draw_style(&d);
        failed = d.by_shell && split_all_shells(&d);
    }
    if (!failed) {
        deal(&d);
        failed = write_nodes(&d, asset);
    }
    close_dealer(&d);
    return failed;
}
