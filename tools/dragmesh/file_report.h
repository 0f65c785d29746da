/* Commands that print what one file holds: their arguments are the file and --json, and they need no weights. */
#ifndef DRAGMESH_FILE_REPORT_H
#define DRAGMESH_FILE_REPORT_H

#include "commands.h"
#include "session.h"

/* Prints what the file at `path` holds; session->error says what is wrong. */
typedef dm_result file_report(session* session, const char* path, int as_json);
/* Reads the arguments and prints the report. Returns an exit status. */
int file_report_run(const cli_command* command, int argc, char** argv, file_report* print);

#endif
