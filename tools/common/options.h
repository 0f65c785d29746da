/* Command-line arguments, read by a table. */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H

#include <stddef.h>

#include "cli.h"
#include "commands.h"
#include "platform.h"

/* Names from a comma-separated list; the option may come several times. */
typedef struct name_list {
    char** names; /* own copies */
    unsigned count;
} name_list;

enum option_kind {
    OPTION_FLAG,     /* int*: set to 1 */
    OPTION_TEXT,     /* const char** */
    OPTION_INTEGER,  /* int* */
    OPTION_SEED,     /* int*: the integer that follows, or 1 when something else does */
    OPTION_NUMBER,   /* double* */
    OPTION_OPTIONAL, /* double*: the number that follows; stays as it is when something else does */
    OPTION_NUMBERS,  /* float[count]: comma-separated */
    OPTION_DOUBLES,  /* double[count]: the same */
    OPTION_NAMES,    /* name_list* */
    OPTION_CHOICE    /* const char**: one of `choices` that follows, or the last of them when something else does */
};

typedef struct option_spec {
    const char* name; /* with its dashes */
    enum option_kind kind;
    int count; /* of OPTION_NUMBERS */
    void* value;
    int* given;                 /* may be NULL: set to 1 when the option was there */
    const char* const* choices; /* of OPTION_CHOICE; NULL ends them */
} option_spec;

/* Reads argv[1..]; at most one argument may stand alone, and goes to *out_operand (NULL: none may). After "--" no
 * argument is an option. Returns CLI_OK, CLI_USAGE after a line about what is wrong, or CLI_HELPED where -h or --help
 * is among them. */
int options_read(const cli_command* command, int argc, char** argv, const option_spec* options, size_t option_count,
                 const char** out_operand);
/* Whether a file of that suffix may be written to `path`: any case of letters, and any name of a pipe or a device.
 * Returns CLI_OK, or prints a message and returns CLI_USAGE. option: the one that names it. */
int options_check_output(const cli_command* command, const char* option, const char* path, const char* suffix);
/* Prints a message and the usage; answers CLI_USAGE. */
int options_refuse(const cli_command* command, const char* format, ...) PLATFORM_PRINTF(2, 3);

void name_list_add(name_list* list, const char* name, size_t length);
void name_list_free(name_list* list);

#endif
