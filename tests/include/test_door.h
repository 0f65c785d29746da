/* A generated door for a group of the tool's tests to work on, and what the tool said last. */
#ifndef DM_TEST_DOOR_H
#define DM_TEST_DOOR_H

#include "test_tool.h"

static tool_output out;
static tool_object door;

static int set_up(void** state) {
    (void)state;
    tool_object_make(&door, "door", 3);
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    tool_object_remove(&door);
    return 0;
}

#endif
