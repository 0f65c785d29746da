/* A log of poses, for comparing two runs bit by bit. */
#include "poses.h"

#include <string.h>

void poses_open(poses* poses, FILE* file) {
    memset(poses, 0, sizeof *poses);
    poses->file = file;
    poses->hash = 14695981039346656037u; /* FNV-1a, 64 bits */
}

static void mix_in(poses* poses, const void* data, size_t size) {
    for (size_t i = 0; i < size; i++) poses->hash = (poses->hash ^ ((const uint8_t*)data)[i]) * 1099511628211u;
}

void poses_frame(poses* poses, const world* world, uint32_t frame) {
    for (uint32_t id = 1; id <= world->part_count; id++) {
        const world_part* part = &world->parts[id];
        const dm_pose* p = &part->carried;
        mix_in(poses, p, sizeof *p);
        if (memcmp(p, &poses->last[id], sizeof *p) == 0) continue;
        poses->last[id] = *p;
        if (poses->file)
            fprintf(poses->file, "%u %u %.6g %a %a %a %a %a %a %a %a\n", (unsigned)frame, (unsigned)id,
                    (double)part->value, (double)p->real[0], (double)p->real[1], (double)p->real[2], (double)p->real[3],
                    (double)p->dual[0], (double)p->dual[1], (double)p->dual[2], (double)p->dual[3]);
    }
}
