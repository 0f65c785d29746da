/* The feature table as data. */
#include "kinematics/features/feature_table.h"

_Static_assert(DMI_FEATURE_COUNT <= UINT8_MAX, "columns are stored as bytes, here and in the boosted trees");

const dmi_feature dmi_features[DMI_FEATURE_COUNT] = {
#define FEATURE(name, group, pass, source, unit, meaning)                                                              \
    {#name, #group, unit, meaning, DMI_GROUP_##group, DMI_PASS_##pass, DMI_SOURCE_##source},
#include "kinematics/features/feature_table.def"
};

#define LIST_CHEAP(name) DMI_FEATURE_##name,
#define LIST_FULL(name)
const uint8_t dmi_cheap_columns[DMI_CHEAP_COLUMNS] = {
#define FEATURE(name, group, pass, source, unit, meaning) LIST_##pass(name)
#include "kinematics/features/feature_table.def"
};

#define LIST_GEOMETRY(name)
#define LIST_DRAG(name)
#define LIST_NETWORK(name) DMI_FEATURE_##name,
const uint8_t dmi_network_columns[DMI_NETWORK_COLUMNS] = {
#define FEATURE(name, group, pass, source, unit, meaning) LIST_##source(name)
#include "kinematics/features/feature_table.def"
};
