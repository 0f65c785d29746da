/* The columns of a candidate's features: their indices, and the table that names them (feature_table.def). */
#ifndef DMI_FEATURES_FEATURE_TABLE_H
#define DMI_FEATURES_FEATURE_TABLE_H

#include <stdbool.h>
#include <stdint.h>

enum {
#define FEATURE(name, group, pass, source, unit, meaning) DMI_FEATURE_##name,
#include "kinematics/features/feature_table.def"
    DMI_FEATURE_COUNT
};

/* Groups of features that are measured together. Training sets a whole group to 0 at random, because real objects may
 * spoil one (a body without an interior spoils SWEEP) and leave the others. */
typedef enum dmi_feature_group {
    DMI_GROUP_TYPE,
    DMI_GROUP_SLIP,
    DMI_GROUP_CONTACT_TOUCHING,
    DMI_GROUP_CONTACT_NEAR,
    DMI_GROUP_CONTACT_NEAREST,
    DMI_GROUP_SWEEP,
    DMI_GROUP_SHAPE,
    DMI_GROUP_ALIGNMENT,
    DMI_GROUP_PLACE,
    DMI_GROUP_SIDE,
    DMI_GROUP_ALONG,
    DMI_GROUP_ROTATION,
    DMI_GROUP_DRAG,
    DMI_GROUP_NETWORK,
    DMI_GROUP_DIRECTION,
    DMI_GROUP_ORIGIN,
    DMI_GROUP_RELATIVE,
    DMI_GROUP_WIDEST_GAP,
    DMI_GROUP_OUTLINE,
    DMI_GROUP_SECTION,
    DMI_GROUP_PROTRUSION,
    DMI_GROUP_NETWORK_SCORE,
    DMI_GROUP_MIRROR,
    DMI_GROUP_HARDWARE,
    DMI_GROUP_PULL,
    DMI_GROUP_COUNT
} dmi_feature_group;

typedef enum dmi_feature_pass { DMI_PASS_CHEAP, DMI_PASS_FULL, DMI_PASS_COUNT } dmi_feature_pass;
typedef enum dmi_feature_source {
    DMI_SOURCE_GEOMETRY,
    DMI_SOURCE_DRAG,
    DMI_SOURCE_NETWORK,
    DMI_SOURCE_COUNT
} dmi_feature_source;

/* A row of the table, for tests and training. */
typedef struct dmi_feature {
    const char *name, *group_name, *unit, *meaning;
    dmi_feature_group group;
    dmi_feature_pass pass;
    dmi_feature_source source;
} dmi_feature;

extern const dmi_feature dmi_features[DMI_FEATURE_COUNT];

/* How many features are cheap, and how many come from KPP-Net. */
enum {
    DMI_CHEAP_COLUMNS = 0
/* NOLINTNEXTLINE(bugprone-macro-parentheses): a term of the sum */
#define FEATURE(name, group, pass, source, unit, meaning) +(DMI_PASS_##pass == DMI_PASS_CHEAP)
#include "kinematics/features/feature_table.def"
    ,
    DMI_NETWORK_COLUMNS = 0
/* NOLINTNEXTLINE(bugprone-macro-parentheses): a term of the sum */
#define FEATURE(name, group, pass, source, unit, meaning) +(DMI_SOURCE_##source == DMI_SOURCE_NETWORK)
#include "kinematics/features/feature_table.def"
};

/* Their columns, in rising order. */
extern const uint8_t dmi_cheap_columns[DMI_CHEAP_COLUMNS];
extern const uint8_t dmi_network_columns[DMI_NETWORK_COLUMNS];

#endif
