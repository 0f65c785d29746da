/* What both programs do: they find the command, and run it or call the program that has it. */
#ifndef CLI_PROGRAM_H
#define CLI_PROGRAM_H

#include "commands.h"

/* argv[0] is the command's name. Returns an exit status, or CLI_HELPED. */
typedef int command_run(const cli_command* command, int argc, char** argv);

/* runs: by command; NULL for those of the other program. Returns the exit status. */
int program_main(enum cli_program program, command_run* const runs[COMMANDS], int argc, char** argv);

#endif
