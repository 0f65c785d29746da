/* What --help says of a command. */
#ifndef CLI_HELP_H
#define CLI_HELP_H

#include "cli.h"

/* Prints usage, summary, and what the words of the usage stand for. */
void help_print(const cli_command* command);

#endif
