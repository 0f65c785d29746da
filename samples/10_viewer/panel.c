/* The words on the screen: the list of parts, a label at the part in question, help, messages. */
#include "panel.h"

#include <stdio.h>
#include <string.h>

#include "keys.h"

static const colour bright = {0.96f, 0.97f, 0.98f, 1}, dim = {0.70f, 0.73f, 0.77f, 1}, warm = {1, 0.74f, 0.35f, 1};
static const colour ground = {0.07f, 0.08f, 0.10f, 0.74f};

enum { MAX_LINES = 15, LINE = 160 }; /* lines of text, bytes of one */

static float text_size(const app* app) {
    return glm_clamp((float)app->camera.height / 46, 6.5f, 14);
}

static const char* type_name(int32_t type) {
    static const char* const names[] = {"?", "hinge", "slider", "screw", "wheel", "fixed"};
    return type >= 0 && type <= DM_JOINT_FIXED ? names[type] : "?";
}

static void write_value(const world_part* part, char* out, size_t room) {
    if (part->state.joint.type == DM_JOINT_PRISMATIC)
        snprintf(out, room, "%.3f", (double)roundf(part->state.value * 1e3f) * 1e-3 + 0.0);
    else
        snprintf(out, room, "%.0f deg", (double)roundf(part->state.value * 180 / GLM_PIf) + 0.0); /* no -0 */
}

/* How sure the joint in force is, and where it comes from. What the user says needs no number. */
static void write_trust(const world* world, const world_part* part, char* out, size_t room) {
    static const char* const words[] = {"as prepared", "by your pull", "as you say", "your choice"};
    const double sure = 100 * (double)part->state.joint.joint_confidence;
    if (part->is_stated && part->basis == DM_BASIS_HOST)
        snprintf(out, room, "as the file says");
    else if (part->basis == DM_BASIS_HOST || part->basis == DM_BASIS_CHOSEN)
        snprintf(out, room, "%s", words[part->basis]);
    else if (world->info.degraded & (DM_DEGRADED_NO_KINEMATICS | DM_DEGRADED_NO_RANKER))
        snprintf(out, room, "a guess: weights are missing");
    else
        snprintf(out, room, "%.0f%% %s", sure, words[part->basis]);
}

static void write_part(const world* world, const world_part* part, char* out, size_t room) {
    char value[32], trust[32];
    write_value(part, value, sizeof value);
    write_trust(world, part, trust, sizeof trust);
    const int lifts = part->is_free && part->state.joint.type == DM_JOINT_PRISMATIC;
    snprintf(out, room, "%.28s:  %s, %s,  %s", part->name,
             lifts ? "loose, lifts off" : type_name(part->state.joint.type), trust, value);
}

/* Lines of text on a dark ground, the first one bright. */
static void draw_block(draw* draw, float x, float y, float size, const char (*lines)[LINE], int count, int marked) {
    float width = 0;
    for (int i = 0; i < count; i++) width = fmaxf(width, draw_text_width(size, lines[i]));
    const float pitch = size * 1.75f, margin = size * 0.8f;
    draw_box(draw, x, y, width + 2 * margin, (float)count * pitch + margin, ground);
    for (int i = 0; i < count; i++)
        draw_text(draw, x + margin, y + pitch * (float)(i + 1) - 0.1f * size, size,
                  i == marked ? warm
                  : i == 0    ? bright
                              : dim,
                  lines[i]);
}

static void draw_parts(const app* app, draw* draw) {
    static char lines[MAX_LINES][LINE];
    const world* world = app->world;
    int count = 0, marked = -1;
    snprintf(lines[count++], LINE, "%u %s   prepared in %.0f ms", (unsigned)world->part_count,
             world->part_count == 1 ? "part" : "parts", 1e3 * world->prepare_seconds);
    if (app->hide_times)
        snprintf(lines[0], LINE, "%u %s", (unsigned)world->part_count, world->part_count == 1 ? "part" : "parts");
    const uint32_t first = app->selected > MAX_LINES - 4 ? app->selected - (MAX_LINES - 4) : 1;
    for (uint32_t id = first; id <= world->part_count && count < MAX_LINES - 2; id++) {
        if (id == app->selected) marked = count;
        write_part(world, &world->parts[id], lines[count++], LINE);
    }
    if (app->selected <= world->part_count && world->parts[app->selected].has_changed)
        snprintf(lines[count++], LINE, "your pull has changed it.  W: as it was before");
    if (!(app->show & SHOW_HELP)) snprintf(lines[count++], LINE, "F1 help");
    draw_block(draw, 8, 8, text_size(app), (const char(*)[LINE])lines, count, marked);
}

static void draw_help(const app* app, draw* draw) {
    static char lines[40][LINE];
    int count = 0;
    snprintf(lines[count++], LINE, "drag a part: it moves;  drag beside it, or right button: orbit");
    snprintf(lines[count++], LINE, "middle button, or shift and right: pan;  wheel: zoom;  1..8: other hypothesis");
    for (int i = 0; i < key_binding_count && count < 40; i++)
        if (key_bindings[i].label[0])
            snprintf(lines[count++], LINE, "%-8s %s", key_bindings[i].label, key_bindings[i].help);
    const float size = fminf(text_size(app), (float)app->camera.height / ((float)count * 1.75f + 4));
    const float width = (float)app->camera.width, height = (float)count * size * 1.75f;
    draw_block(draw, width * 0.5f - size * 14, ((float)app->camera.height - height) / 2, size,
               (const char(*)[LINE])lines, count, -1);
}

static void draw_message(const app* app, draw* draw) {
    static char line[1][LINE];
    const char* text = app->world->message;
    if (app->painting) text = "painting: drag over the part, shift erases, C takes a whole piece, P when done";
    if (!text[0]) return;
    snprintf(line[0], LINE, "%.150s", text);
    const float size = text_size(app);
    draw_block(draw, 8, (float)app->camera.height - size * 3 - 8, size, (const char(*)[LINE])line, 1, 0);
}

void panel_draw(const app* app, draw* draw, uint32_t id) {
    if (id && app->world->object && (app->show & SHOW_LABEL)) {
        const world_part* part = &app->world->parts[id];
        char text[LINE];
        write_part(app->world, part, text, sizeof text);
        const dm_vec3 top = vec(part->centre.x, app->camera.z_up ? part->centre.y : part->box_max.y,
                                app->camera.z_up ? part->box_max.z : part->centre.z);
        draw_label(draw, pose_point(&part->carried, top), text_size(app), bright, text);
    }
    if (app->show & SHOW_PANEL) draw_parts(app, draw);
    if (app->show & SHOW_PANEL) draw_message(app, draw);
    if (app->show & SHOW_HELP) draw_help(app, draw);
}
