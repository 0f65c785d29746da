/* Pictures of wrong answers (dragmesh eval --mistakes). */
#ifndef CLI_ERROR_REPORT_H
#define CLI_ERROR_REPORT_H

#include "metrics.h"
#include "output_file.h"
#include "picture.h"

/* A folder that gets a strip of pictures for each wrong answer (at rest, open as the truth has it, open as answered;
 * the true axis blue, the answered one red, the drag green), sheets of many strips, and index.txt with a line a strip.
 */
typedef struct error_report {
    const char* folder;
    output_file index;
    int count;     /* strips so far */
    bool failed;   /* a picture could not be written */
    picture sheet; /* of the last strips; rgb NULL: none begun */
} error_report;

/* Makes the folder. Returns 0, or -1 with a line on standard error. */
int error_report_open(error_report* report, const char* folder);
/* Adds the object that the session holds; row: its metrics; up: 'x', 'y' or 'z'. */
dm_result error_report_add(error_report* report, session* session, const metric_case* known, const joint_answer* answer,
                           const metric_row* row, char up);
/* Writes index.txt, after all pictures. Returns 0, or -1 when something could not be written, with a line on standard
 * error. */
int error_report_close(error_report* report);

#endif
