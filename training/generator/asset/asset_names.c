/* Names nodes as exporters and artists leave them: numbers that tell nothing, names that tell, in any language and
 * spelling, some that lie. Shares are set by hand. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "asset/asset_layer.h"
#include "asset/asset_words.h"

enum { LONG = 200, NAME = sizeof((dmg_asset_node*)0)->name };

/* What the names of an asset are like. */
typedef enum naming {
    NUMBERED,    /* nothing tells */
    TELLING,     /* all tell */
    MOVERS_TELL, /* those of what moves do */
    MIXED,       /* some tell */
    NAMINGS
} naming;

typedef enum spelling { SNAKE, PASCAL, CAMEL, UPPER, SPACED, HYPHENS, SPELLINGS } spelling;

typedef struct namer {
    dmg_builder* b;
    dmg_asset* asset;
    naming how;
    spelling spelt;
    uint32_t pattern, suffixes, language; /* language 0: as the generator says it; else where in the lexicon's rows */
    const char *prefix, *body;
} namer;

static const char* pick(dmg_builder* b, const char* const* list, int count) {
    return list[dmg_int(b, 0, count - 1)];
}
#define PICK(b, list) pick(b, list, (int)(sizeof(list) / sizeof *(list)))

/* ---- names that tell nothing ---- */

static void write_number(namer* n, uint32_t index, char out[LONG]) {
    static const char* const patterns[] = {"mesh_%u",  "Object_%u", "polySurface%u", "Mesh.%03u", "node_%u",
                                           "pCube%u",  "Group%u",   "geometry_%u",   "Shape_%u",  "Box%03u",
                                           "Part__%u", "mesh%u",    "default_%u",    "obj%u",     "g_%u"};
    static const char* const solids[] = {"Cube", "Cube", "Cube", "Cylinder", "Plane", "Sphere", "Circle"};
    const uint32_t count = sizeof patterns / sizeof *patterns;
    if (n->pattern >= count) {
        snprintf(out, LONG, "%s", PICK(n->b, solids)); /* made unique by a number later */
        return;
    }
    snprintf(out, LONG, patterns[n->pattern], index);
}

/* ---- names that tell ---- */

/* Writes a name in snake case in the asset's spelling. Bytes beyond ASCII stay. */
static void spell(const namer* n, const char* name, char out[LONG]) {
    size_t at = 0;
    bool start = true;
    for (const char* c = name; *c && at + 1 < LONG; ++c) {
        if (*c == '_') {
            start = true;
            if (n->spelt == SPACED) out[at++] = ' ';
            if (n->spelt == HYPHENS) out[at++] = '-';
            if (n->spelt == SNAKE || n->spelt == UPPER) out[at++] = '_';
            continue;
        }
        const bool large =
            n->spelt == UPPER || (start && (n->spelt == PASCAL || n->spelt == SPACED || (n->spelt == CAMEL && at > 0)));
        out[at++] = large && (unsigned char)*c < 128 ? (char)toupper((unsigned char)*c) : *c;
        start = false;
    }
    out[at] = '\0';
}

/* Writes what a part is called: its joint's name, or the word for it in another language with what tells twins apart.
 */
static void write_part(const namer* n, uint32_t part, char out[LONG]) {
    const char* name = n->asset->object.joints[part - 1].name;
    const int32_t row = n->language > 0 ? dmg_word_row(name) : -1;
    snprintf(out, LONG, "%s", name);
    if (row < 0) return;
    char word[LONG / 2];
    dmg_copy_word(row, n->language, word, sizeof word);
    snprintf(out, LONG, "%s_%u", word, part);
}

static void write_static(namer* n, const dmg_asset_node* node, char out[LONG]) {
    static const char* const hardware[] = {"trim", "foot",  "leg",   "panel", "back", "side",  "shelf", "top",
                                           "rail", "plate", "hinge", "screw", "pipe", "cable", "stand", "wall"};
    static const char* const things[] = {"book", "vase",  "box",  "prop",   "gem",
                                         "cup",  "decor", "item", "bottle", "coin"};
    if (node->loose)
        snprintf(out, LONG, "%s", PICK(n->b, things));
    else if (dmg_chance(n->b, 0.4f))
        snprintf(out, LONG, "%s", PICK(n->b, hardware));
    else
        snprintf(out, LONG, "%s", n->body);
}

/* Writes a name that tells what it is not. */
static void write_lie(namer* n, char out[LONG]) {
    const int32_t row = dmg_part_row(dmg_random(n->b));
    dmg_copy_word(row, n->language, out, LONG);
}

/* Adds what tells the nodes of one body apart. */
static void add_suffix(namer* n, uint32_t index, char name[LONG]) {
    static const char* const materials[] = {"wood",   "metal", "glass", "plastic",
                                            "chrome", "black", "white", "Material"};
    static const char* const pieces[] = {"panel", "handle", "frame", "glass", "trim", "low", "inner", "outer", "hinge"};
    char number[16];
    const char* more = number;
    snprintf(number, sizeof number, "%u", index);
    if (n->suffixes == 1) more = PICK(n->b, materials);
    if (n->suffixes == 2) more = PICK(n->b, pieces);
    const size_t length = strlen(name);
    snprintf(name + length, LONG - length, "_%s", more);
}

static bool is_alone(const dmg_asset* asset, uint32_t node) {
    for (uint32_t i = 0; i < asset->node_count; ++i)
        if (i != node && asset->nodes[i].face_count > 0 && asset->nodes[i].part == asset->nodes[node].part)
            return false;
    return true;
}

static void write_telling(namer* n, uint32_t index, char out[LONG]) {
    const dmg_asset_node* node = &n->asset->nodes[index];
    char plain[LONG], spelt[LONG];
    const bool lies = dmg_chance(n->b, 0.03f), own_suffix = dmg_chance(n->b, 0.8f);
    if (lies)
        write_lie(n, plain);
    else if (node->part == 0 || node->loose)
        write_static(n, node, plain);
    else
        write_part(n, node->part, plain);
    if (own_suffix && node->face_count > 0 && !is_alone(n->asset, index)) add_suffix(n, index, plain);
    spell(n, plain, spelt);
    snprintf(out, LONG, "%.16s%.150s", n->prefix, spelt);
}

/* ---- names that are there once ---- */

/* Copies as much of a name as there is room for, whole characters. */
static void copy_name(const char* from, size_t room, char* out) {
    size_t length = strlen(from);
    if (length > room) {
        length = room;
        while (length > 0 && ((unsigned char)from[length] & 0xc0u) == 0x80u) --length;
    }
    memcpy(out, from, length);
    out[length] = '\0';
}

static bool is_taken(const dmg_asset* asset, uint32_t before, const char* name) {
    for (uint32_t i = 0; i < before; ++i)
        if (strcmp(asset->nodes[i].name, name) == 0) return true;
    return false;
}

static void set_name(dmg_asset* asset, uint32_t index, const char* wanted) {
    enum { NUMBER = 6 }; /* bytes of ".0123" */
    char* name = asset->nodes[index].name;
    copy_name(wanted, NAME - 1, name);
    for (uint32_t copy = 1; name[0] && is_taken(asset, index, name); ++copy) {
        copy_name(wanted, NAME - 1 - NUMBER, name);
        const size_t length = strlen(name);
        snprintf(name + length, NAME - length, ".%03u", copy % 10000);
    }
}

static void set_mesh_name(namer* n, uint32_t index, int how) {
    dmg_asset_node* node = &n->asset->nodes[index];
    if (node->mesh != index)
        memcpy(node->mesh_name, n->asset->nodes[node->mesh].mesh_name, sizeof node->mesh_name);
    else if (how == 0)
        memcpy(node->mesh_name, node->name, sizeof node->mesh_name);
    else if (how == 1)
        snprintf(node->mesh_name, sizeof node->mesh_name, "Mesh.%03u", index);
}

static void name_empty(namer* n, uint32_t index) {
    static const char* const roots[] = {"RootNode", "Scene",      "root", "Sketchfab_model",
                                        "Armature", "Collection", "Group"};
    char name[LONG];
    const uint32_t part = n->asset->nodes[index].part;
    if (part == DMG_NO_PART && dmg_chance(n->b, 0.4f))
        snprintf(name, LONG, "%s", n->asset->object.category);
    else if (part == DMG_NO_PART)
        snprintf(name, LONG, "%s", PICK(n->b, roots));
    else if (n->how == NUMBERED)
        snprintf(name, LONG, "Empty");
    else
        write_telling(n, index, name);
    set_name(n->asset, index, name);
}

static namer draw_namer(dmg_builder* b, dmg_asset* asset) {
    static const char* const prefixes[] = {"SM_", "geo_", "Geo-", "m_", "obj_"};
    static const char* const bodies[] = {"body",   "base",  "frame",  "case",  "main",
                                         "corpus", "shell", "Korpus", "cuerpo"};
    static const float shares[NAMINGS] = {0.4f, 0.34f, 0.12f, 0.14f};
    static const float spellings[SPELLINGS] = {5, 2, 1, 0.4f, 0.6f, 0.4f};
    namer n = {.b = b, .asset = asset, .prefix = ""};
    n.how = (naming)dmg_weighted(b, shares, NAMINGS);
    n.spelt = (spelling)dmg_weighted(b, spellings, SPELLINGS);
    n.pattern = (uint32_t)dmg_int(b, 0, 24); /* those without a pattern of their own are named after solids */
    n.suffixes = (uint32_t)dmg_int(b, 0, 2);
    const uint32_t language = dmg_random(b) >> 8;
    n.language = dmg_chance(b, 0.25f) ? language : 0;
    const char *prefix = PICK(b, prefixes), *body = PICK(b, bodies);
    if (dmg_chance(b, 0.15f)) n.prefix = prefix;
    n.body = dmg_chance(b, 0.3f) ? asset->object.category : body;
    return n;
}

void dmg_name_nodes(dmg_builder* b, dmg_asset* asset) {
    namer n = draw_namer(b, asset);
    const int meshes = dmg_int(b, 0, 2); /* as the nodes, by numbers, none */
    for (uint32_t i = 0; i < asset->node_count; ++i) {
        const dmg_asset_node* node = &asset->nodes[i];
        const bool some = dmg_chance(b, 0.5f);
        const bool tells = n.how == TELLING || (n.how == MOVERS_TELL && node->part != 0) || (n.how == MIXED && some);
        char name[LONG];
        if (node->face_count == 0) {
            name_empty(&n, i);
            continue;
        }
        if (tells)
            write_telling(&n, i, name);
        else
            write_number(&n, i, name);
        set_name(asset, i, name);
        set_mesh_name(&n, i, meshes);
    }
}
