/* The commands: whose each one is, and what --help says of it. */
#include "commands.h"

#include <stdio.h>
#include <string.h>

#include "dragmesh/dragmesh.h"
#include "joint_type.h"

const cli_command cli_commands[COMMANDS] = {
    [COMMAND_RIG] =
        {"rig", PROGRAM_DRAGMESH,
         "FILE.glb|FOLDER -o OUT [--formats LIST] [--names on|off] [--no-clips] [--min-moves P] [--up x|y|z] [-j N]\n"
         "        [--json]",
         "Rigs whole assets: which nodes move, how, and what carries what. OUT.json gets the answer alone; a folder "
         "OUT gets\n"
         "    rig.json, rigged.glb, which opens and closes, with joints in `extras`, and film.png. Of a FOLDER, each "
         ".glb\n"
         "    and .gltf in it, and object.glb of each folder in it, gets a folder of its own in OUT; -j works on N at "
         "a time,\n"
         "    and what is done already is left as it is.\n"
         "    --formats: what a folder gets: a list of glb (rigged.glb; alone, if nothing is said), urdf, mjcf, sdf,\n"
         "    usda and tscn.\n"
         "    --names off, --no-clips: names, or clips, say nothing. --min-moves: probability from which on a part "
         "moves.\n"
         "    --up: which way is up in the files; glTF's is y."},
    [COMMAND_INFER] =
        {"infer", PROGRAM_DRAGMESH,
         "FILE.glb --moving NODE[,NODE…]|auto [--drag-point X,Y,Z --drag-vector X,Y,Z] [--type TYPE] [--mask FILE]\n"
         "    [--mask-out OUT.json] [--choose N] [--no-hints] [--json]\n"
         "dragmesh infer --jobs JOBS.jsonl [--no-hints]",
         "How the part moves: type, axis, origin, limits. --jobs ('-': standard input) answers one JSON line a line.\n"
         "    --moving auto finds the part that the drag point is on; --mask-out writes it, one 0 or 1 a triangle.\n"
         "    --choose N puts hypothesis N, from 0, in the place of the best one.\n"
         "    --no-hints: the file's names and pivots do not count."},
    [COMMAND_ANIMATE] =
        {"animate", PROGRAM_DRAGMESH,
         "FILE.glb --moving NODE[,NODE…] [--drag-point X,Y,Z --drag-vector X,Y,Z] [--type TYPE] [--mask FILE]\n"
         "    -o OUT.glb [--frames N]",
         "Writes the file with the part opening and closing in a loop, for any glTF viewer."},
    [COMMAND_FILM] =
        {"film", PROGRAM_DRAGMESH,
         "FILE.glb --moving NODE[,NODE…] [--drag-point X,Y,Z --drag-vector X,Y,Z] [--type TYPE] [--mask FILE]\n"
         "    -o OUT.png [--frames N] [--size W,H] [--up x|y|z] [--axis]",
         "Draws the part opening, one picture beside the other; --axis shows the joint found."},
    [COMMAND_NODES] =
        {"nodes", PROGRAM_DRAGMESH, "FILE.glb [--json]",
         "What a file has that may move: nodes with meshes, their triangles and sizes, and the names that count."},
    [COMMAND_PICK] = {"pick", PROGRAM_DRAGMESH, "FILE.glb --ray OX,OY,OZ,DX,DY,DZ [--json]",
                      "What a ray meets first: node, triangle, point."},
    [COMMAND_PREPARE] = {"prepare", PROGRAM_DRAGMESH,
                         "FILE.glb -o OUT.dmo [--moving NODE[,NODE…]] [--min-moves P] [--no-hints] [--json]",
                         "Finds the joints and writes them for a game to load. Without --moving the whole asset is "
                         "asked which nodes move,\n"
                         "    and which of them as one; --min-moves: probability from which on a part does. --json "
                         "says whose nodes are whose."},
    [COMMAND_SHOW] = {"show", PROGRAM_DRAGMESH, "FILE.dmo [--json]",
                      "What a prepared object holds: its parts, their joints, and what else they may be."},
    [COMMAND_DEMO] = {"demo", PROGRAM_DRAGMESH, "DIR -o PREFIX [--size PIXELS]",
                      "Picks a part of a generated object (DIR/object.glb, DIR/joints.json) through a pixel, drags it "
                      "across the screen,\n    and writes PREFIX.png and PREFIX.glb."},
    [COMMAND_EVAL] = {"eval", PROGRAM_EVALUATE,
                      "DIR [--json] [--no-drag] [--pull exact|chord|axis] [--drag-noise DEGREES] [--turn [SEED]]\n"
                      "    [--hints [names|pivots|both]] [--no-hints] [--lies FRACTION]\n"
                      "    [--mask-noise FRACTION | --alone] [--given-type] [--drags N] [--baseline "
                      "kpp|geometry|rules|full] [--moving auto [--merge]]\n"
                      "    [--worst N] [--mistakes OUT_DIR]",
                      "Scores a folder of object.glb + joints.json: every joint, weighted, by source and by category. "
                      "--pull: the stored\n"
                      "    drag; as people pull, at the far end straight to where it is half open; or along the room's "
                      "nearest axis. --hints:\n"
                      "    hands over the names and pivots that the folder has; --lies: that share of them is another "
                      "joint's. --baseline:\n"
                      "    the network alone, no network, or hand-set rules in the ranker's place. --alone: each part "
                      "without the rest of its\n"
                      "    object. --mistakes draws every wrong answer. --moving auto\n"
                      "    finds the part from the drag's point instead of the true mask, with --merge as if the file "
                      "were one mesh."},
    [COMMAND_DRAGBOT] =
        {"dragbot", PROGRAM_EVALUATE,
         "DIR [--straight | --axis] [--wander SHARE] [--tremor PIXELS] [--jostle PIXELS] [--offset PIXELS] [--pause] "
         "[--regrab N] [--hz 30|60|144] [--hitch] [--moving-camera | --moving-instance] [--point | --scalar] [--view "
         "end-on|above|behind] [--all] [--cameras N] [--given-joint] [--worst N] [--poses OUT.jsonl] [--json] [--naive "
         "[DEGREES] [--snap | --up]] [--only WORD,WORD...] [--hints [names|pivots|both]] [--rig [--no-clips]]",
         "A scripted player on a folder of object.glb + joints.json: picks and drags every part, and scores the feel.\n"
         "    --rig: the first touch of the naive hand on folders of object.glb + asset.json, whole assets with known "
         "parts,\n"
         "    by what 'dragmesh rig' answers: whether the right faces follow, the joint is right, and what is static "
         "stays."},
    [COMMAND_BENCH] = {"bench", PROGRAM_EVALUATE, "[DIR] [--json]",
                       "What the library's calls cost on this machine; with DIR, what preparing its objects does."},
};

const cli_command* command_find(const char* name) {
    for (int i = 0; i < COMMANDS; i++)
        if (strcmp(name, cli_commands[i].name) == 0) return &cli_commands[i];
    return NULL;
}

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

void command_print_help(const cli_command* command) {
    printf("usage: dragmesh %s %s\n\n%s\n\n", command->name, command->usage, command->summary);
    if (strstr(command->usage, "TYPE") != NULL) print_types();
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strstr(command->usage, words[i].word) != NULL) printf("%s\n", words[i].meaning);
    printf("-h, --help: this text. --: what follows is no option. Exit status: 0 answered, 1 something failed, 2 bad\n"
           "    arguments.\n");
}
