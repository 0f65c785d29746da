/* What keys do: what is shown, which part moves, how it moves. */
#include "keys.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "parts.h"

void keys_frame(app* app) {
    dm_vec3 low = vec(INFINITY, INFINITY, INFINITY), high = scale(low, -1);
    for (uint64_t v = 0; v < app->world->mesh.vertex_count; v++) {
        const dm_vec3 p = vec_from((const float*)app->world->mesh.positions + 3 * v);
        low = vec_min(low, p), high = vec_max(high, p);
    }
    camera_frame(&app->camera, low, high);
}

static void show_axis(app* app) {
    app->show ^= SHOW_AXIS;
}

static void show_hypotheses(app* app) {
    app->show ^= SHOW_HYPOTHESES;
}

static void show_ghosts(app* app) {
    app->show ^= SHOW_GHOSTS;
}

static void show_panel(app* app) {
    app->show ^= SHOW_PANEL;
}

static void show_clay(app* app) {
    app->show ^= SHOW_CLAY;
}

static void show_label(app* app) {
    app->show ^= SHOW_LABEL;
}

static void show_help(app* app) {
    app->show ^= SHOW_HELP;
}

static void turn_up(app* app) {
    app->camera.z_up = !app->camera.z_up;
}

static void next_part(app* app) {
    if (app->world->part_count) app->selected = app->selected % app->world->part_count + 1;
}

static void to_rest(app* app) {
    app->playing = 0;
    for (uint32_t id = 1; id <= app->world->part_count; id++) {
        if (app->world->parts[id].state.value != 0) world_remember(app->world, id);
        world_set_value(app->world, id, 0);
    }
}

static void undo(app* app) {
    app->playing = 0;
    if (world_undo(app->world) != 0) snprintf(app->world->message, sizeof app->world->message, "nothing to undo");
}

static void as_before(app* app) {
    app->playing = 0;
    if (world_as_before(app->world, app->selected) != 0)
        snprintf(app->world->message, sizeof app->world->message, "no pull has changed this part's joint");
}

static void play(app* app) {
    app->playing = app->playing > 0 ? 0 : frame_seconds;
}

/* What a part does when it is let go. */
static void next_intent(app* app) {
    static const char* const words[] = {"as the pull meant it", "stays", "goes on to the end", "falls back to rest"};
    app->world->intent = (app->world->intent + 1) % 4;
    snprintf(app->world->message, sizeof app->world->message, "a part let go: %s", words[app->world->intent]);
}

static void save(app* app) {
    world_save(app->world, app->save_path);
}

static void act(app* app) {
    world_scene_act(app->world);
}

static void quit(app* app) {
    app->quit = 1;
}

/* ---- which part moves ---- */

static void prepare_again(app* app) {
    world_prepare(app->world);
    app->repaint = 1;
    if (app->selected > app->world->part_count) app->selected = app->world->part_count;
}

static void toggle_node(app* app) {
    if (app->under.distance <= 0) return;
    parts_toggle_node(app->world, app->under.triangle);
    prepare_again(app);
}

static void paint(app* app) {
    app->painting = !app->painting;
    if (app->painting) {
        to_rest(app);
        if (!app->selected) app->selected = parts_add(app->world, "painted");
    } else {
        parts_tidy(app->world);
        prepare_again(app);
    }
}

static void fill(app* app) {
    if (app->painting && app->under.distance > 0 && parts_fill(app->world, app->under.triangle, app->selected))
        app->repaint = 1;
}

static void smaller_brush(app* app) {
    app->brush = fmaxf(app->brush / 1.25f, 0.004f);
}

static void larger_brush(app* app) {
    app->brush = fminf(app->brush * 1.25f, 0.3f);
}

/* ---- how it moves ---- */

static void override(app* app, const dm_joint* joint) {
    app->playing = 0;
    world_set_joint(app->world, app->selected, joint);
}

static void next_type(app* app) {
    dm_joint joint = app->world->parts[app->selected].state.joint;
    const bool was_slide = joint.type == DM_JOINT_PRISMATIC;
    joint.type = joint.type % DM_JOINT_FIXED + 1;
    const bool is_slide = joint.type == DM_JOINT_PRISMATIC;
    if (is_slide != was_slide) {
        joint.lower = 0;
        joint.upper = is_slide ? 0.4f * app->world->info.size : GLM_PIf / 2;
    }
    joint.pitch = joint.type == DM_JOINT_SCREW ? 0.01f * app->world->info.size : 0;
    override(app, &joint);
}

static void axis_along(app* app, dm_vec3 axis) {
    dm_joint joint = app->world->parts[app->selected].state.joint;
    joint.axis = axis;
    override(app, &joint);
}

static void axis_x(app* app) {
    axis_along(app, vec(1, 0, 0));
}

static void axis_y(app* app) {
    axis_along(app, vec(0, 1, 0));
}

static void axis_z(app* app) {
    axis_along(app, vec(0, 0, 1));
}

/* The same motion, counted the other way. */
static void invert(app* app) {
    dm_joint joint = app->world->parts[app->selected].state.joint;
    const float lower = joint.lower;
    joint.axis = scale(joint.axis, -1);
    joint.lower = -joint.upper;
    joint.upper = -lower;
    override(app, &joint);
}

/* The axis goes through the point under the pointer. */
static void origin_here(app* app) {
    dm_joint joint = app->world->parts[app->selected].state.joint;
    if (app->under.distance <= 0) return;
    joint.origin = app->under.object_point;
    override(app, &joint);
}

static void move_limit(app* app, float lower_steps, float upper_steps) {
    dm_joint joint = app->world->parts[app->selected].state.joint;
    const float step = joint.type == DM_JOINT_PRISMATIC ? 0.02f * app->world->info.size : GLM_PIf / 36;
    joint.lower = fminf(joint.lower + lower_steps * step, 0);
    joint.upper = fmaxf(joint.upper + upper_steps * step, 0);
    override(app, &joint);
}

static void limit_down(app* app) {
    move_limit(app, app->shift ? -1.0f : 0, app->shift ? 0 : -1.0f);
}

static void limit_up(app* app) {
    move_limit(app, app->shift ? 1.0f : 0, app->shift ? 0 : 1.0f);
}

/* What the pull found becomes the object's own, for other instances and for S. */
static void adopt_pulled(app* app) {
    const dm_joint joint = app->world->parts[app->selected].state.joint;
    override(app, &joint);
}

static void forget_overrides(app* app) {
    prepare_again(app);
}

const key_binding key_bindings[] = {
    {"F1", "F1", "this help", show_help},
    {"Tab", "Tab", "next part", next_part},
    {"A", "A", "axis and limits", show_axis},
    {"H", "H", "other hypotheses", show_hypotheses},
    {"G", "G", "16 key poses", show_ghosts},
    {"F2", "F2", "panel", show_panel},
    {"L", "L", "label at the part", show_label},
    {"K", "K", "clay in place of the file's colours", show_clay},
    {"F", "F", "look at everything", keys_frame},
    {"U", "U", "y or z is up", turn_up},
    {"Space", "Space", "play the part's travel", play},
    {"R", "R", "everything to rest", to_rest},
    {"B", "B", "undo: back to before the last grab", undo},
    {"W", "W", "as it was before: the joint from before the pull changed it", as_before},
    {"V", "V", "a part let go: as meant, stays, goes on, goes back", next_intent},
    {"E", "E", "a scene: its own hands play it", act},
    {"M", "M", "piece under pointer: part or body", toggle_node},
    {"P", "P", "paint the part (shift erases); again to finish", paint},
    {"C", "C", "painting: take all that hangs together", fill},
    {"-", "-", "smaller brush", smaller_brush},
    {"=", "=", "larger brush", larger_brush},
    {"T", "T", "next joint type", next_type},
    {"X", "X Y Z", "axis along x, y, z", axis_x},
    {"Y", "", "", axis_y},
    {"Z", "", "", axis_z},
    {"I", "I", "axis the other way", invert},
    {"O", "O", "axis through the point under the pointer", origin_here},
    {"[", "[ ]", "upper limit (shift: lower)", limit_down},
    {"]", "", "", limit_up},
    {"J", "J", "the joint as pulled becomes the object's own", adopt_pulled},
    {"Backspace", "Backsp", "forget what was overridden", forget_overrides},
    {"S", "S", "save the prepared object (.dmo)", save},
    {"Escape", "Esc", "quit", quit},
};
const int key_binding_count = (int)(sizeof key_bindings / sizeof *key_bindings);

/* Keys from T to J change the selected part's joint and need one. */
static bool needs_part(const key_binding* binding) {
    static const char* const names[] = {"T", "X", "Y", "Z", "I", "O", "[", "]", "J", "W", "Space"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(binding->key, names[i]) == 0) return true;
    return false;
}

/* 1 .. 8: the hypothesis of that rank is put in force. */
static void take_hypothesis(app* app, uint32_t rank) {
    const world_part* part = &app->world->parts[app->selected];
    if (rank >= 1 && rank <= part->hypothesis_count) override(app, &part->hypotheses[rank - 1]);
}

void keys_press(app* app, const char* key) {
    const bool has_part = app->selected && app->selected <= app->world->part_count && app->world->object;
    if (has_part && key[0] >= '1' && key[0] <= '8' && !key[1]) take_hypothesis(app, (uint32_t)(key[0] - '0'));
    for (int i = 0; i < key_binding_count; i++)
        if (strcmp(key_bindings[i].key, key) == 0 && (has_part || !needs_part(&key_bindings[i])))
            key_bindings[i].act(app);
}
