/* The commands: whose each one is, and what --help says of it. */
#ifndef CLI_COMMANDS_H
#define CLI_COMMANDS_H

/* The programs that share the commands: the product and the laboratory. */
enum cli_program { PROGRAM_DRAGMESH, PROGRAM_EVALUATE, PROGRAMS };

enum cli_command_id {
    COMMAND_RIG,
    COMMAND_INFER,
    COMMAND_ANIMATE,
    COMMAND_FILM,
    COMMAND_NODES,
    COMMAND_PICK,
    COMMAND_PREPARE,
    COMMAND_SHOW,
    COMMAND_DEMO,
    COMMAND_EVAL,
    COMMAND_DRAGBOT,
    COMMAND_BENCH,
    COMMANDS
};

typedef struct cli_command {
    const char* name;
    enum cli_program program; /* that runs it */
    const char* usage;
    const char* summary;
} cli_command;

extern const cli_command cli_commands[COMMANDS];

/* Returns NULL for a name that is none. */
const cli_command* command_find(const char* name);
/* Prints usage, summary, and what the words of the usage stand for. */
void command_print_help(const cli_command* command);

#endif
