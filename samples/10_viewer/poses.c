/* A log of poses, for comparing two runs bit by bit. */
#include "poses.h"

#include <stdbool.h>
#include <string.h>

void poses_open(poses* poses, output_file* file) {
    memset(poses, 0, sizeof *poses);
    poses->file = file;
    poses->hash = 14695981039346656037u; /* FNV-1a, 64 bits */
}

/* Of floats, on purpose: -0 is not 0 here. */
static bool same_bits(const void* a, const void* b, size_t size) {
    return memcmp(a, b, size) == 0;
}

static void mix_in(poses* poses, const void* data, size_t size) {
    for (size_t i = 0; i < size; i++) poses->hash = (poses->hash ^ ((const uint8_t*)data)[i]) * 1099511628211u;
}

static bool same_line(const dm_joint* a, const dm_joint* b) {
    return a->type == b->type && same_bits(&a->axis, &b->axis, sizeof a->axis) &&
           same_bits(&a->origin, &b->origin, sizeof a->origin);
}

/* A joint that is new, or that the pull has changed, as a line that starts with #. */
static void write_joint(poses* poses, const world_part* part, uint32_t frame, uint32_t id) {
    const dm_joint* j = &part->state.joint;
    if (same_line(j, &poses->joints[id])) return;
    poses->joints[id] = *j;
    output_print(poses->file, "# %u %u type %d %.2f axis %.4f %.4f %.4f origin %.4f %.4f %.4f from %.4f to %.4f\n",
                 (unsigned)frame, (unsigned)id, (int)j->type, (double)j->joint_confidence, (double)j->axis.x,
                 (double)j->axis.y, (double)j->axis.z, (double)j->origin.x, (double)j->origin.y, (double)j->origin.z,
                 (double)j->lower, (double)j->upper);
}

void poses_frame(poses* poses, const world* world, uint32_t frame) {
    for (uint32_t id = 1; id <= world->part_count; id++) {
        const world_part* part = &world->parts[id];
        const dm_pose* p = &part->carried;
        mix_in(poses, p, sizeof *p);
        if (poses->file != NULL) write_joint(poses, part, frame, id);
        if (same_bits(p, &poses->last[id], sizeof *p)) continue;
        poses->last[id] = *p;
        if (poses->file != NULL)
            output_print(poses->file, "%u %u %.6g %a %a %a %a %a %a %a %a\n", (unsigned)frame, (unsigned)id,
                         (double)part->state.value, (double)p->real[0], (double)p->real[1], (double)p->real[2],
                         (double)p->real[3], (double)p->dual[0], (double)p->dual[1], (double)p->dual[2],
                         (double)p->dual[3]);
    }
}
