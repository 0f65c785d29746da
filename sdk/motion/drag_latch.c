/* The latch catches a part that has come to rest, and a handle opens it; both have hysteresis. */
#include "motion/drag_latch.h"

#include <math.h>

#include "math/elementary.h"

/* The values are set by hand. */
#define CATCH_SHARE 0.01f /* share of the range from where the part is closed; the latch catches the part within it */
#define LET_GO 0.8f       /* share of the turn that opens the latch; a handle below it has been let go */
#define TRIED 2.0f        /* multiple of what is given; a hand that asks for more tries the part … */
#define LET_UP 1.0f       /* … and a hand that asks for less has let up */

static bool is_shut(const dmi_rules* rules, const dm_joint* joint, float value) {
    return fabsf(value - dmi_joint_closed(joint)) <= CATCH_SHARE * dmi_rules_range(rules, joint);
}

dmi_latch dmi_latch_begin(const dmi_rules* rules, const dm_joint* joint, float value) {
    return (dmi_latch){.closed = rules->flags & DM_RULE_LATCH && is_shut(rules, joint, value)};
}

static void update_lock(dmi_latch* latch, float value, bool locked) {
    if (locked && !latch->locked) latch->at = value;
    latch->locked = locked;
}

uint32_t dmi_latch_update(dmi_latch* latch, const dmi_rules* rules, const dm_joint* joint, float value, bool locked,
                          const float handles[2]) {
    const float turn = dmi_fmaxf(fabsf(handles[0]), fabsf(handles[1])), shut = dmi_joint_closed(joint);
    uint32_t events = 0;
    latch->turned = turn >= (latch->turned ? LET_GO : 1) * rules->latch_turn;
    if (latch->closed && latch->turned) {
        latch->closed = false;
        events = DM_EVENT_UNLATCHED;
    } else if (rules->flags & DM_RULE_LATCH && !latch->closed && !latch->turned && is_shut(rules, joint, value)) {
        latch->closed = true;
        events = DM_EVENT_LATCHED;
    }
    update_lock(latch, latch->closed ? shut : value, locked || rules->flags & DM_RULE_LOCKED);
    if (latch->closed) latch->at = shut;
    return events;
}

/* Returns how far a held part gives at most, joint value. */
static float most_given(const dmi_rules* rules, const dm_joint* joint) {
    return rules->lock_give * dmi_rules_range(rules, joint);
}

float dmi_latch_give(const dmi_latch* latch, const dmi_rules* rules, const dm_joint* joint, float asked) {
    const float most = most_given(rules, joint), off = asked - latch->at;
    return most > 0 ? latch->at + most * off / (most + fabsf(off)) : latch->at;
}

uint32_t dmi_latch_try(dmi_latch* latch, const dmi_rules* rules, const dm_joint* joint, float asked) {
    const bool was = latch->tried;
    const float threshold = dmi_fmaxf(most_given(rules, joint), CATCH_SHARE * dmi_rules_range(rules, joint));
    const float off = fabsf(asked - latch->at);
    latch->tried = dmi_latch_holds(latch) && off > (was ? LET_UP : TRIED) * threshold;
    return latch->tried && !was ? DM_EVENT_LOCKED : 0;
}
