/* The one context of the extension: made when Godot loads it, destroyed with everything in it when Godot unloads it. */
#ifndef DRAGMESH_GODOT_LIBRARY_H
#define DRAGMESH_GODOT_LIBRARY_H

#include <stdbool.h>

#include "dragmesh/dragmesh.h"

/* False, after an error message: no context could be made. */
bool library_begin(void);
void library_end(void);

dm_context* library_context(void);

/* The weights in the folder that the project setting dragmesh/models names, read once; 0 where it has none: geometry
 * alone. On the main thread. */
dm_model library_model(void);

#endif
