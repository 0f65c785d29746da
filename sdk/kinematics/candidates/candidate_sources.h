/* Directions, points and lines that a part's shape, its contacts, a drag or the network suggest for a joint axis. */
#ifndef DMI_CANDIDATES_CANDIDATE_SOURCES_H
#define DMI_CANDIDATES_CANDIDATE_SOURCES_H

#include "kinematics/candidates/candidates.h"

#define DMI_MAX_SOURCE_DIRECTIONS 64 /* most directions; by hand */
#define DMI_MAX_SOURCE_POINTS 128    /* most points, and most lines; by hand */
#define DMI_MIN_CONTACT_POINTS 5     /* least points of a contact region that suggests something; by hand */

typedef struct dmi_source_direction {
    float d[3];        /* unit; its sign is arbitrary */
    uint32_t families; /* DMI_DIRECTION_* */
} dmi_source_direction;

typedef struct dmi_source_point {
    float x[3];
    uint32_t families; /* DMI_ORIGIN_* */
} dmi_source_point;

/* A direction and a point that belong together, such as the axis of a cylinder. */
typedef struct dmi_source_line {
    float d[3], x[3];
    uint32_t direction_families, origin_families;
} dmi_source_line;

typedef struct dmi_candidate_sources {
    dmi_source_direction directions[DMI_MAX_SOURCE_DIRECTIONS];
    dmi_source_point points[DMI_MAX_SOURCE_POINTS];
    dmi_source_line lines[DMI_MAX_SOURCE_POINTS];
    uint32_t direction_count, point_count, line_count;
} dmi_candidate_sources;

/* Finds the sources. hint, prediction: NULL when there is none. drag: hint->vector, unit. */
void dmi_candidate_sources_find(const dmi_part_analysis* analysis, const dmi_drag_hint* hint, const float drag[3],
                                const dmi_prediction* prediction, dmi_candidate_sources* out);

#endif
