/* Picks the command, and answers --help and --version. */
#include "program.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "cli.h"
#include "dragmesh/dragmesh.h"
#include "platform.h"

static const char* const program_names[PROGRAMS] = {
    [PROGRAM_DRAGMESH] = "dragmesh", [PROGRAM_EVALUATE] = "dragmesh-evaluate"};

/* Writes 0.3.0, or 0.3.0-dev for an odd number (DM_VERSION). */
static void print_version(FILE* out, uint32_t version) {
    const uint32_t odd = version & 1, release = version + odd;
    fprintf(out, "%u.%u.%u%s", release >> 22, release >> 12 & 1023, release & 4095, odd ? "-dev" : "");
}

static void print_commands(FILE* out, enum cli_program program) {
    for (const cli_command* command = cli_commands; command < cli_commands + COMMANDS; command++)
        if (command->program == program)
            fprintf(out, "dragmesh %s %s\n    %s\n", command->name, command->usage, command->summary);
}

static void print_help(FILE* out) {
    fprintf(out, "dragmesh ");
    print_version(out, DM_VERSION);
    fprintf(out, ": how the parts of an object move, and moves them.\n\n");
    print_commands(out, PROGRAM_DRAGMESH);
    fprintf(out, "\nThe laboratory, which measures the library; %s beside this program runs these commands:\n\n",
            program_names[PROGRAM_EVALUATE]);
    print_commands(out, PROGRAM_EVALUATE);
    fprintf(out,
            "\nEvery command that infers takes --models DIR (weights; without it DRAGMESH_MODELS, then beside the\n"
            "program) or --models none (geometry alone). dragmesh COMMAND --help says what the words stand for.\n"
            "Exit status: 0 answered, 1 something failed, 2 bad arguments.\n");
}

static bool is_help(const char* text) {
    return strcmp(text, "--help") == 0 || strcmp(text, "-h") == 0 || strcmp(text, "help") == 0;
}

static int refuse_name(const char* name) {
    fprintf(stderr, "dragmesh: no command '%.200s'; see dragmesh --help\n", name);
    return CLI_USAGE;
}

/* dragmesh help [COMMAND] */
static int help(const char* name) {
    const cli_command* command = name != NULL ? command_find(name) : NULL;
    if (command == NULL && name != NULL) return refuse_name(name);
    if (command != NULL)
        command_print_help(command);
    else
        print_help(stdout);
    return CLI_OK;
}

/* Becomes the program that has the command; returns where there is none. */
static int call(const cli_command* command, char** argv) {
    const char* name = program_names[command->program];
    platform_become(name, argv);
    fprintf(stderr, "dragmesh %s: can't run %s, which belongs beside this program: %s\n", command->name, name,
            strerror(errno));
    return CLI_FAILED;
}

static int run(command_run* const runs[COMMANDS], enum cli_program program, int argc, char** argv) {
    if (argc < 2) {
        print_help(stderr);
        return CLI_USAGE;
    }
    const cli_command* command = command_find(argv[1]);
    if (command != NULL && command->program != program) return call(command, argv);
    if (command != NULL) {
        const int status = runs[command - cli_commands](command, argc - 1, argv + 1);
        return status == CLI_HELPED ? CLI_OK : status;
    }
    if (is_help(argv[1])) return help(argc > 2 && !is_help(argv[2]) ? argv[2] : NULL);
    if (strcmp(argv[1], "--version") != 0) return refuse_name(argv[1]);
    print_version(stdout, dm_version());
    printf("\n");
    return CLI_OK;
}

/* An answer counts once it has arrived: the disk may be full, or the standard output closed. */
int program_main(enum cli_program program, command_run* const runs[COMMANDS], int argc, char** argv) {
    platform_start(&argc, &argv);
    const int status = run(runs, program, argc, argv);
    if (fflush(stdout) == 0 && !ferror(stdout)) return status;
    fprintf(stderr, "dragmesh: the standard output takes no more\n");
    return status == CLI_OK ? CLI_FAILED : status;
}
