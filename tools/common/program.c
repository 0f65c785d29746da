/* dragmesh: the command-line tool. Picks the subcommand. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "cli.h"
#include "dragmesh/dragmesh.h"
#include "help.h"
#include "platform.h"

static const cli_command* const commands[] = {&cli_rig,   &cli_infer, &cli_animate, &cli_film,
                                              &cli_nodes, &cli_pick,  &cli_prepare, &cli_show,
                                              &cli_eval,  &cli_bench, &cli_demo,    &cli_dragbot};
enum { COMMANDS = sizeof commands / sizeof(void*) };

/* Writes 0.3.0, or 0.3.0-dev for an odd number (DM_VERSION). */
static void print_version(FILE* out, uint32_t version) {
    const uint32_t odd = version & 1, release = version + odd;
    fprintf(out, "%u.%u.%u%s", release >> 22, release >> 12 & 1023, release & 4095, odd ? "-dev" : "");
}

static void print_help(FILE* out) {
    fprintf(out, "dragmesh ");
    print_version(out, DM_VERSION);
    fprintf(out, ": how the parts of an object move, and moves them.\n\n");
    for (int i = 0; i < COMMANDS; i++)
        fprintf(out, "dragmesh %s %s\n    %s\n", commands[i]->name, commands[i]->usage, commands[i]->summary);
    fprintf(out,
            "\nEvery command that infers takes --models DIR (weights; without it DRAGMESH_MODELS, then beside the\n"
            "program) or --models none (geometry alone). dragmesh COMMAND --help says what the words stand for.\n"
            "Exit status: 0 answered, 1 something failed, 2 bad arguments.\n");
}

static const cli_command* find_command(const char* name) {
    for (int i = 0; i < COMMANDS; i++) {
        if (strcmp(name, commands[i]->name) == 0) return commands[i];
    }
    return NULL;
}

static bool is_help(const char* text) {
    return strcmp(text, "--help") == 0 || strcmp(text, "-h") == 0 || strcmp(text, "help") == 0;
}

/* dragmesh help [COMMAND] */
static int help(const char* name) {
    const cli_command* command = name != NULL ? find_command(name) : NULL;
    if (command != NULL) help_print(command);
    if (name == NULL) print_help(stdout);
    if (command == NULL && name != NULL) fprintf(stderr, "dragmesh: no command '%.200s'; see dragmesh --help\n", name);
    return command != NULL || name == NULL ? CLI_OK : CLI_USAGE;
}

static int run(int argc, char** argv) {
    if (argc < 2) {
        print_help(stderr);
        return CLI_USAGE;
    }
    const cli_command* command = find_command(argv[1]);
    if (command != NULL) {
        const int status = command->run(argc - 1, argv + 1);
        return status == CLI_HELPED ? CLI_OK : status;
    }
    if (is_help(argv[1])) return help(argc > 2 && !is_help(argv[2]) ? argv[2] : NULL);
    if (strcmp(argv[1], "--version") == 0) {
        print_version(stdout, dm_version());
        printf("\n");
        return CLI_OK;
    }
    fprintf(stderr, "dragmesh: no command '%.200s'; see dragmesh --help\n", argv[1]);
    return CLI_USAGE;
}

/* An answer counts once it has arrived: the disk may be full, or the standard output closed. */
int main(int argc, char** argv) {
    platform_start(&argc, &argv);
    const int status = run(argc, argv);
    if (fflush(stdout) == 0 && !ferror(stdout)) return status;
    fprintf(stderr, "dragmesh: the standard output takes no more\n");
    return status == CLI_OK ? CLI_FAILED : status;
}
