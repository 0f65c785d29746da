/* Folders of object.glb + joints.json: objects whose joints are known. */
#ifndef CLI_DATASET_H
#define CLI_DATASET_H

#include <stdbool.h>

#include "job.h"
#include "vec.h"

enum { DATASET_DRAGS = 8 }; /* drags of a joint that are read; by hand, datasets have fewer */

typedef struct known_drag {
    vec point, vector;
} known_drag;

typedef struct known_joint {
    char* name;
    bool slides; /* prismatic; else it turns */
    vec axis, origin;
    double lower, upper; /* NAN: not given */
    double weight;
    name_list moving;
    char* label;    /* path of the asset's names, file/…/node; "": none */
    bool has_pivot; /* the two below */
    vec pivot, pivot_axes[3];
    known_drag drags[DATASET_DRAGS];
    int drag_count;
} known_joint;

typedef struct known_object {
    char *name, *glb, *category;
    char up;          /* 'x', 'y' or 'z' */
    vec up_direction; /* the same as a unit vector */
    known_joint* joints;
    int joint_count;
} known_object;

/* Returns the names of the sub-folders of `folder` that have a file of that name, sorted; an empty list with errno set
 * when the folder can't be read. */
name_list dataset_list(const char* folder, const char* file);
/* 0, or -1 with a message in `error`. */
int dataset_read(const char* folder, const char* name, known_object* out_object, char* error, size_t error_size);
/* Takes places into a frame whose origin is at `origin` of the file: that of a merged mesh, dm_gltf_get_origin. */
void dataset_enter_frame(known_object* object, const double origin[3]);
void dataset_free(known_object* object);
/* Returns the source that a folder's name stands for: "flightgear", "webxr", "partnet", "simulation". */
const char* dataset_source(const char* name);

#endif
