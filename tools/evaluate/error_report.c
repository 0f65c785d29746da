/* Pictures of wrong answers: strips, sheets of strips, and an index. */
#include "error_report.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "platform.h"
#include "render.h"

/* Pixels and counts of the layout; by hand. */
enum { PANEL = 180, PANELS = 3, GAP = 4, STRIP = PANELS * PANEL + (PANELS - 1) * GAP, COLUMNS = 2, ROWS = 5 };
static const double DRAG_LENGTH = 0.15; /* of the drawn drag, share of the object's size; by hand */
enum { PER_SHEET = COLUMNS * ROWS };

static const uint8_t blue[3] = {70, 150, 255}, red[3] = {255, 70, 60}, green[3] = {40, 220, 70};

static void fail_to_write(const char* path) {
    fprintf(stderr, "dragmesh eval: can't write '%s': %s\n", path, strerror(errno));
}

static int write_named(const error_report* report, const picture* picture, const char* format, int number) {
    char name[32];
    snprintf(name, sizeof name, format, number);
    char* path = path_join(report->folder, name);
    const int status = picture_write(picture, path);
    if (status != 0) fail_to_write(path);
    free(path);
    return status;
}

int error_report_open(error_report* report, const char* folder) {
    *report = (error_report){.folder = folder};
    char* path = path_join(folder, "index.txt");
    const bool made = platform_make_folder(folder) == 0 || errno == EEXIST;
    const int status = made ? output_open(&report->index, path) : -1;
    if (status != 0) fail_to_write(path);
    free(path);
    if (status != 0) return -1;
    output_print(&report->index,
                 "Strips: at rest, open as it should, open as answered. True axis blue, answered red, drag green.\n"
                 "A sheet holds %d: %d rows of %d.\n"
                 "%5s %5s  %-22s %9s %9s %8s %5s  %-16s %s\n",
                 PER_SHEET, ROWS, COLUMNS, "strip", "sheet", "true -> found", "axis mrad", "line e3", "pose e3", "conf",
                 "category", "id");
    return 0;
}

static void paste(const picture* from, picture* to, int left, int top) {
    for (int y = 0; y < from->height; y++)
        memcpy(to->rgb + 3 * ((size_t)(top + y) * (size_t)to->width + (size_t)left),
               from->rgb + 3 * (size_t)y * (size_t)from->width, 3 * (size_t)from->width);
}

static int flush_sheet(error_report* report) {
    if (report->sheet.rgb == NULL) return 0;
    const int status = write_named(report, &report->sheet, "sheet_%02d.png", (report->count - 1) / PER_SHEET + 1);
    picture_free(&report->sheet);
    return status;
}

static int add_strip(error_report* report, const picture* strip) {
    const int slot = report->count++ % PER_SHEET;
    if (slot == 0) report->sheet = picture_new(COLUMNS * (STRIP + 4 * GAP), ROWS * (PANEL + 2 * GAP));
    paste(strip, &report->sheet, slot % COLUMNS * (STRIP + 4 * GAP), slot / COLUMNS * (PANEL + 2 * GAP));
    const int status = write_named(report, strip, "%03d.png", report->count);
    return slot == PER_SHEET - 1 ? flush_sheet(report) | status : status;
}

static dm_joint true_joint(const metric_case* known) {
    return (dm_joint){.struct_size = sizeof(dm_joint),
                      .type = known->truth->slides ? DM_JOINT_PRISMATIC : DM_JOINT_REVOLUTE,
                      .axis = vec_out(known->truth->axis),
                      .origin = vec_out(known->truth->origin)};
}

static dm_result draw_strip(renderer* r, const metric_case* known, const joint_answer* answer, picture* strip) {
    const dm_joint truth = true_joint(known);
    const float travels[PANELS] = {0, (float)metrics_travel(known),
                                   (float)metrics_answered_travel(known, &answer->joint)};
    dm_pose poses[PANELS];
    dm_result result = DM_OK;
    for (int i = 0; i < PANELS && result == DM_OK; i++)
        result = dm_joint_pose(i == 1 ? &truth : &answer->joint, travels[i], &poses[i]);
    if (result != DM_OK) return result;
    render_aim(r, known->drag->vector, poses, PANELS, PANEL, PANEL);
    for (int i = 0; i < PANELS && result == DM_OK; i++) {
        const int left = i * (PANEL + GAP);
        result = render_draw(r, &poses[i], strip, left);
        render_segment(r, known->drag->point,
                       add(known->drag->point, scale(unit(known->drag->vector), DRAG_LENGTH * r->size)), green, strip,
                       left);
        if (i != 2) render_axis(r, &truth, blue, strip, left);
        if (i != 1) render_axis(r, &answer->joint, red, strip, left);
    }
    return result;
}

static void write_index_line(error_report* report, const metric_case* known, const metric_row* row) {
    char types[48];
    snprintf(types, sizeof types, "%s -> %s", known->truth->slides ? "slides" : "turns", row->found_type);
    output_print(&report->index, "%5d %5d  %-22s %9.1f %9.1f %8.1f %5.2f  %-16s %s\n", report->count,
                 (report->count - 1) / PER_SHEET + 1, types, row->value[METRIC_AXIS],
                 isnan(row->value[METRIC_LINE]) ? 0 : row->value[METRIC_LINE], row->value[METRIC_POSE] * 1e3,
                 row->value[METRIC_CONFIDENCE], row->category, row->id);
}

dm_result error_report_add(error_report* report, session* session, const metric_case* known, const joint_answer* answer,
                           const metric_row* row, char up) {
    renderer renderer;
    picture strip = picture_new(STRIP, PANEL);
    dm_result result = render_open(&renderer, session, up);
    renderer.grid = 1; /* quick: a fourth of the rays */
    renderer.sky_rays = 3;
    if (result == DM_OK) result = draw_strip(&renderer, known, answer, &strip);
    render_close(&renderer);
    if (result == DM_OK && add_strip(report, &strip) != 0) report->failed = true;
    if (result == DM_OK) write_index_line(report, known, row);
    picture_free(&strip);
    return result;
}

int error_report_close(error_report* report) {
    const int status = flush_sheet(report);
    char* path = path_join(report->folder, "index.txt");
    const bool wrote = output_close(&report->index) == 0;
    if (!wrote) fail_to_write(path);
    free(path);
    return wrote && status == 0 && !report->failed ? 0 : -1;
}
