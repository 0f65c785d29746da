/* Rollback netcode: every frame is saved; when a late input shows that a prediction was wrong, the game goes back and
 * plays the frames again. Same inputs, same bits. */
#include "recipe.h"

enum { WINDOW = 8, FRAMES = 40, LATE = 5 }; /* frames: kept, played, and by which the input comes too late */

typedef struct frame {
    uint8_t drag[DM_DRAG_SNAPSHOT_MAX]; /* before the frame */
    dm_pose pose;                       /* after it */
} frame;

static frame frames[WINDOW];

/* The remote player's hand; until its input is there, it is taken to stay. */
static dm_ray input(int at, int known) {
    return ray_through(eye, hand_at(0.03f * (float)(at < known ? at : known)));
}

static void play(dm_context* context, dm_drag drag, int at, int known) {
    const dm_ray ray = input(at, known);
    dm_drag_state now = dm_drag_state_default();
    frame* f = &frames[at % WINDOW];
    EXPECT(dm_drag_save(context, drag, f->drag, sizeof f->drag) == DM_OK);
    EXPECT(dm_drag_update(context, drag, &ray, 1.0f / FPS, &now) == DM_OK);
    f->pose = now.pose;
}

static void roll_back(dm_context* context, dm_drag drag, int to) {
    EXPECT(dm_drag_restore(context, drag, frames[to % WINDOW].drag, dm_drag_snapshot_size()) == DM_OK);
}

static dm_drag begin(dm_context* context, dm_object object) {
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = object, .part_id = CABINET_DOOR, .grab_point = handle_point};
    dm_drag drag = 0;
    EXPECT(dm_drag_begin(context, &desc, &drag) == DM_OK);
    return drag;
}

int main(void) {
    dm_context* context = NULL;
    const dm_object object = recipe_open(&context);
    dm_drag drag = begin(context, object);
    for (int at = 0; at < FRAMES; at++) play(context, drag, at, FRAMES); /* as it is: every input in time */
    const dm_pose truth = frames[(FRAMES - 1) % WINDOW].pose;

    drag = begin(context, object);
    for (int at = 0; at < FRAMES; at++) {
        play(context, drag, at, at - LATE);
        const int late = at - LATE + 1; /* the input of this frame has come now */
        if (late < 0) continue;
        roll_back(context, drag, late);
        for (int again = late; again <= at; again++) play(context, drag, again, late);
    }
    roll_back(context, drag, FRAMES - LATE);
    for (int again = FRAMES - LATE; again < FRAMES; again++) play(context, drag, again, FRAMES);
    const dm_pose* found = &frames[(FRAMES - 1) % WINDOW].pose;
    printf("%zu bytes a frame; the pose after %d rollbacks:", dm_drag_snapshot_size(), FRAMES - LATE + 2);
    for (int i = 0; i < 4; i++) printf(" %a", (double)found->real[i]);
    printf("\n");
    /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked */
    EXPECT(memcmp(&truth, found, sizeof truth) == 0);
    dm_context_destroy(context);
    return 0;
}
