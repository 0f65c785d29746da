/* What a dm_gltf holds: the document and its bytes, its tree of nodes and the merged mesh. */
#ifndef DMI_GLTF_FILE_H
#define DMI_GLTF_FILE_H

#include "base/arena.h"
#include "base/progress.h"
#include "dragmesh/ext/gltf.h"
#include "gltf/gltf_document.h"
#include "gltf/gltf_draco.h"
#include "mesh/pivot_rule.h"

/* Bytes of memory that the reader may take for a byte of the file, besides cJSON's, and what it may take in any case.
 * By hand: 309 objects that people made took 4 at most (28 November 2026), and files repeat a mesh some times over. */
#define DMI_GLTF_BYTES_PER_BYTE 64
#define DMI_GLTF_BYTES_ALWAYS (64u << 20)
/* The same for a byte of a Draco stream, which holds half a vertex and a triangle; by hand. */
#define DMI_GLTF_BYTES_PER_DRACO_BYTE 256

/* Bytes of a buffer of the file. */
typedef struct dmi_gltf_buffer {
    const uint8_t* data; /* NULL: it has none, which is right for the fallback of compressed views */
    uint64_t size;
    uint8_t* decoded; /* bytes of a data: URI; owned */
    uint64_t decoded_size;
    const void* file; /* the host's handle, which dm_gltf_files.close gets back */
    uint64_t file_size;
} dmi_gltf_buffer;

typedef struct dmi_gltf_block dmi_gltf_block;
typedef struct dmi_gltf_asset dmi_gltf_asset;

/* What a compressed view holds, once it was asked for: bytes, or a Draco mesh and the elements read from it. */
typedef struct dmi_gltf_decoded {
    uint8_t* data;
    uint64_t size;
    dmi_draco* draco;
    dmi_gltf_block* blocks;
    uint8_t refused; /* 1: the compressed data does not decode, and the plain data stands for it */
} dmi_gltf_decoded;

/* A node of the file. */
typedef struct dmi_gltf_tree_node {
    const cJSON* json;
    const char* name;   /* "" when it has none */
    int32_t parent;     /* -1: none */
    int32_t named;      /* the nearest node above that has a name; -1: none */
    int32_t mesh;       /* -1: none */
    int32_t follows;    /* node with which one that is not shown goes; -1: none */
    uint8_t placed;     /* it hangs below a root, so that it has a place in the world */
    uint8_t in_scene;   /* the scene has it, or a level of detail of what the scene has */
    uint8_t shown;      /* the scene has it, and it is visible, no collider and no coarser level of detail */
    uint8_t joint;      /* it is a joint of a skin */
    uint8_t pivot_kind; /* dmi_pivot_kind */
    double world[16];   /* node to scene, column-major */
} dmi_gltf_tree_node;

typedef struct dmi_gltf_name {
    const char* name;
    uint32_t node; /* node of the file */
} dmi_gltf_name;

/* Triangles of one primitive that move with one node, as they lie in the merged mesh. */
typedef struct dmi_gltf_piece {
    uint32_t node;      /* position in dm_gltf.nodes */
    uint32_t mesh_node; /* node of the file that has the mesh */
    uint32_t primitive; /* position in that node's mesh */
    const cJSON* json;  /* the primitive */
    uint32_t mirrored;  /* the node's transform mirrors, so the triangles were turned over */
    int32_t joint;      /* joint of the skin that places most of the vertices; -1: the node does */
    uint64_t first_face, face_count;
} dmi_gltf_piece;

/* What dm_gltf_open_file has read: the file's folder and its bytes. Zeros: the host hands over files and bytes. */
typedef struct dmi_gltf_on_disk {
    char* folder;
    size_t folder_size;
    void* data;
    size_t size;
} dmi_gltf_on_disk;

struct dm_gltf {
    dmi_env env;
    dm_gltf_files files;
    dmi_gltf_on_disk on_disk;
    dmi_progress progress; /* progress of the call that runs */
    float told;
    uint64_t untold;           /* vertices and triangles since the last report */
    dmi_gltf_problem left_out; /* the first thing that was left out */
    uint8_t has_one_of_instances, pivots_are_lost;
    dmi_gltf_warnings warnings; /* warnings of the call that runs */
    dmi_gltf_document document;
    uint8_t* bin_copy; /* copy of the binary chunk; NULL where the bytes stay */
    const uint8_t* bin;
    uint64_t bin_size;
    dmi_gltf_buffer* buffers;        /* one a buffer of the document */
    dmi_gltf_decoded* decoded;       /* one a view of the document */
    uint8_t* sparse_fit;             /* one an accessor of the document: what is known of its sparse changes */
    dmi_gltf_buffer* images;         /* one an image of the document; NULL until one is asked for */
    uint64_t bytes_most, bytes_left; /* bytes of memory that a call may take, and may still take */
    uint64_t draco_left;             /* bytes of the file that no Draco stream has taken yet */
    dmi_gltf_tree_node* tree;        /* one a node of the document */
    dmi_gltf_name* names;            /* names of all nodes, sorted; nodes of one name are in the file's order */
    uint32_t* order;                 /* placed nodes, parents before children */
    uint32_t order_count;
    dm_gltf_node* nodes; /* what has triangles: nodes with a mesh, and bones */
    uint32_t node_count, node_capacity;
    dmi_gltf_piece* pieces;
    uint32_t piece_count, piece_capacity;
    double origin[3]; /* origin of the merged mesh in the scene */
    float* positions;
    uint32_t* indices;
    uint32_t* sources; /* per vertex: its position in the primitive's accessors */
    /* Position that a vertex and a face have in the file's order; NULL: the same as here. Skins sort by bones. */
    uint32_t *vertex_places, *face_places;
    uint64_t vertex_count, face_count;
    uint64_t vertex_capacity, face_capacity;
    dmi_gltf_asset* asset; /* NULL until one is asked for */
};

void dmi_gltf_release_on_disk(dmi_env* env, const dmi_gltf_on_disk* on_disk);
/* Counts vertices and triangles that were worked on, and reports after DMI_PROGRESS_STEP of them that `share` of the
 * call is done; a lower share than before: as much as before. CANCELLED, as a problem, when the host asks to stop. */
dm_result dmi_gltf_tell(dm_gltf* gltf, float share, uint64_t work, dmi_gltf_problem* problem);
/* Takes memory out of what the file may cost. Answers TOO_LARGE when it is used up. */
dm_result dmi_gltf_spend(dm_gltf* gltf, uint64_t count, uint64_t element, const char* place, dmi_gltf_problem* problem);
/* Takes memory of the arena, within what the file may cost; NULL: says why, as a problem. */
void* dmi_gltf_push(dm_gltf* gltf, dmi_arena* arena, uint64_t count, size_t element, dmi_gltf_problem* problem);
/* Adds what a Draco stream of `size` bytes may take; no byte of the file counts twice. Returns how much that is, for
 * dmi_gltf_take_back where the stream does not decode. */
uint64_t dmi_gltf_grant_draco(dm_gltf* gltf, uint64_t size);
void dmi_gltf_take_back(dm_gltf* gltf, uint64_t granted);

/* Warns that a piece of the file is left out. When nothing else is there, the first such problem is the error. */
void dmi_gltf_leave_out(dm_gltf* gltf, const dmi_gltf_problem* problem);

/* ---- files of the disk (gltf_folder.c) ---- */

/* Bytes of a file. */
typedef struct dmi_gltf_contents {
    void* data;
    size_t size;
} dmi_gltf_contents;

/* Reads a whole file into new memory of the host. Returns DM_OK, NOT_FOUND with errno set, OUT_OF_MEMORY or TOO_LARGE.
 */
dm_result dmi_gltf_read_file(dmi_env* env, const char* path, dmi_gltf_contents* out);
/* Returns the files of gltf->on_disk.folder. */
dm_gltf_files dmi_gltf_folder_files(dm_gltf* gltf);
/* Returns the last character that separates names, or NULL when there is one name alone. */
const char* dmi_gltf_last_separator(const char* path);

#endif
