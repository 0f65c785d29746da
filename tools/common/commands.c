/* What --help says of a command. */
#include "help.h"

#include <stdio.h>
#include <string.h>

#include "dragmesh/dragmesh.h"
#include "joint_type.h"

/* Words of usages, and what they stand for. */
static const struct {
    const char *word, *meaning;
} words[] = {
    {"FILE.glb", "FILE.glb: a .glb, a .gltf with the files beside it, or - for standard input."},
    {"NODE", "NODE: the name of a node, which takes along what it carries, or #N for node N of the file;\n"
             "    'dragmesh nodes FILE.glb' lists them."},
    {"--mask FILE",
     "--mask FILE: .npy or JSON, a number for each triangle or vertex, 0 for what stays; - for standard\n"
     "    input."},
    {"JOBS.jsonl", "JOBS.jsonl: a job a line, such as {\"id\": 1, \"file\": \"FILE.glb\", \"moving\": [\"NODE\"]}."},
    {"DIR", "DIR: a folder of folders of object.glb and joints.json, as dragmesh_generate writes them."},
    {"-o OUT", "-o OUT: takes its place when it is complete; a pipe or a device is written at once."},
};

static void print_types(void) {
    printf("TYPE:");
    for (int32_t type = DM_JOINT_REVOLUTE; type <= DM_JOINT_CONTINUOUS; type++)
        printf("%s %s", type > DM_JOINT_REVOLUTE ? "," : "", joint_type_name(type));
    printf(".\n");
}

void help_print(const cli_command* command) {
    printf("usage: dragmesh %s %s\n\n%s\n\n", command->name, command->usage, command->summary);
    if (strstr(command->usage, "TYPE") != NULL) print_types();
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strstr(command->usage, words[i].word) != NULL) printf("%s\n", words[i].meaning);
    printf("-h, --help: this text. --: what follows is no option. Exit status: 0 answered, 1 something failed, 2 bad\n"
           "    arguments.\n");
}
