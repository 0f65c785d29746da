/* What `dragmesh rig` writes and says. */
#ifndef CLI_RIG_OUTPUT_H
#define CLI_RIG_OUTPUT_H

#include "rig.h"

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

#define RIG_ANSWER "rig.json"
#define RIG_WORD "status.txt" /* one line: how it went */

#endif
