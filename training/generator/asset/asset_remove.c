/* Removes parts and pieces from an object that is drawn already. */
#include <stdlib.h>
#include <string.h>

#include "asset/asset_layer.h"

/* Moves the piece's vertices and faces down to the ends of what is kept; `vertices` maps old vertices to new ones. */
static void keep_piece(dmg_builder* b, uint32_t from_vertex, uint32_t vertex_end, uint32_t from_face, uint32_t face_end,
                       uint32_t* vertices) {
    for (uint32_t v = from_vertex; v < vertex_end; ++v) {
        b->vertices[b->vertex_count] = b->vertices[v];
        vertices[v] = b->vertex_count++;
    }
    for (uint32_t f = from_face; f < face_end; ++f) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t v = vertices[b->indices[3 * f + k]];
            if (v == UINT32_MAX) b->failed = true; /* a piece would use another's vertices */
            b->indices[3 * b->face_count + k] = v;
        }
        b->face_part[b->face_count++] = b->face_part[f];
    }
}

void dmg_drop_pieces(dmg_builder* b, const bool* drop) {
    const uint32_t pieces = b->piece_count, all_vertices = b->vertex_count, all_faces = b->face_count;
    uint32_t* vertices = malloc((all_vertices + 1) * sizeof *vertices);
    if (!vertices) {
        b->failed = true;
        return;
    }
    memset(vertices, 0xff, (all_vertices + 1) * sizeof *vertices);
    b->piece_count = b->vertex_count = b->face_count = 0;
    uint32_t vertex = 0, face = 0;
    for (uint32_t p = 0; p < pieces; ++p) {
        const uint32_t vertex_end = p + 1 < pieces ? b->pieces[p + 1].first_vertex : all_vertices;
        const uint32_t face_end = p + 1 < pieces ? b->pieces[p + 1].first_face : all_faces;
        if (!drop[p]) {
            b->pieces[b->piece_count] = (dmg_piece){b->vertex_count, b->face_count, b->pieces[p].part, b->piece_count};
            ++b->piece_count;
            keep_piece(b, vertex, vertex_end, face, face_end, vertices);
        }
        vertex = vertex_end;
        face = face_end;
    }
    free(vertices);
}

/* Makes the fate of a part that of what carries it where that goes. */
static void settle_fates(const dmg_builder* b, dmg_fate* fates) {
    for (uint32_t i = 0; i < b->part_count; ++i) {
        const uint32_t carrier = b->parts[i].joint.parent;
        if (carrier != 0 && fates[carrier - 1] == DMG_DROPPED) fates[i] = DMG_DROPPED;
    }
}

static void drop_pieces_of(dmg_builder* b, const dmg_fate* fates) {
    bool* drop = calloc(b->piece_count + 1, sizeof *drop);
    if (!drop) {
        b->failed = true;
        return;
    }
    for (uint32_t p = 0; p < b->piece_count; ++p)
        drop[p] = b->pieces[p].part != 0 && fates[b->pieces[p].part - 1] == DMG_DROPPED;
    dmg_drop_pieces(b, drop);
    free(drop);
}

void dmg_part_fates(dmg_builder* b, dmg_fate fates[DMG_PART_LIMIT]) {
    uint32_t id[DMG_PART_LIMIT + 1] = {0}, kept = 0;
    settle_fates(b, fates);
    drop_pieces_of(b, fates);
    for (uint32_t i = 0; i < b->part_count; ++i) {
        dmg_part part = b->parts[i];
        part.joint.parent = id[part.joint.parent];
        id[i + 1] = part.joint.parent;
        if (fates[i] != DMG_KEPT) continue;
        b->parts[kept] = part;
        id[i + 1] = ++kept;
    }
    b->part_count = kept;
    for (uint32_t p = 0; p < b->piece_count; ++p) b->pieces[p].part = id[b->pieces[p].part];
    for (uint32_t f = 0; f < b->face_count; ++f) b->face_part[f] = id[b->face_part[f]];
    dmg_use(b, 0);
}
