#include "file_report.h"

#include <stdio.h>

#include "options.h"
#include "session_open.h"

int file_report_run(const cli_command* command, int argc, char** argv, file_report* print) {
    const char* file = NULL;
    int as_json = 0;
    const option_spec table[] = {{.name = "--json", .kind = OPTION_FLAG, .value = &as_json}};
    session session;
    int status = options_read(command, argc, argv, table, 1, &file);
    if (status == CLI_OK && file == NULL) status = options_refuse(command, "which file?");
    if (status == CLI_OK) status = session_open(&session, "none", NULL);
    if (status != CLI_OK) return status;
    if (print(&session, file, as_json) != DM_OK) {
        fprintf(stderr, "dragmesh: %s\n", session.error);
        status = CLI_FAILED;
    }
    session_close(&session);
    return status;
}
