/* What `dragmesh rig` writes and says. */
#ifndef CLI_RIG_OUTPUT_H
#define CLI_RIG_OUTPUT_H

#include "file_set.h"
#include "rig.h"

enum {
    RIG_FORMATS_TEXT = 64,
    RIG_OPTIONS_TEXT = 256
}; /* bytes of a list of all formats, of rig_options_text; by hand */

typedef struct rig_output {
    const char* path; /* ends in .json: the answer alone; else a folder */
    bool as_json;     /* on standard output */
    bool is_worker;   /* of a folder's run, which tells what this process leaves in its folder */
} rig_output;

/* Whether `path` gets the answer alone: the name of a .json. */
bool rig_output_is_answer(const char* path);
/* Writes all files of an asset, rig.json last. */
dm_result rig_output_write(session* session, const rig* rig, const rig_options* options, const rig_output* output);
/* Prints how it went. */
void rig_output_report(const session* session, const rig_output* output, const char* file, bool is_done, const rig* rig,
                       const rig_options* options);
/* Leaves a line about how it went for the folder's run. */
void rig_output_leave_word(const rig_output* output, bool is_done, const rig* rig, const char* error);

/* Rigs all assets of a folder, `workers` of them at a time, each in a process of its own. Returns an exit status. */
int rig_folder(const char* folder, const char* models, const rig_output* output, const rig_options* options,
               int workers);

/* Adds `nodes` and `node_indices` of a part: the names of its nodes, and their indices in the file. */
void rig_nodes_to_json(const session* session, const rig* rig, uint32_t index, cJSON* out);
/* Returns what was asked for, as text: with another text, an answer is another. */
const char* rig_options_text(const rig_options* options, char* out, size_t size);
/* Returns the answer: parts with nodes, carriers, joints and probabilities, and warnings. */
cJSON* rig_to_json(const session* session, const rig* rig, const rig_options* options);

/* Reads a list of formats, "glb,urdf". Returns their bits; 0, and the name that is none: one is unknown. */
uint32_t rig_read_formats(const char* list, char* out_unknown, size_t size);
/* Writes the list for bits. */
void rig_format_names(uint32_t formats, char* out, size_t size);
/* Writes the files of the formats into a folder. Where nothing moves there is no GLB: it would be the file itself. */
dm_result rig_write_formats(file_set* set, const rig* rig, uint32_t formats, const char* folder);
/* Writes a strip of pictures from closed to open, with the axes of the parts. up: 'x', 'y' or 'z'. */
dm_result rig_write_film(file_set* set, const rig* rig, char up, const char* path);

#define RIG_ANSWER "rig.json"
#define RIG_WORD "status.txt" /* one line: how it went */

#endif
