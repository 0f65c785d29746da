/* Largest numbers that the library computes with, once for all rooms; by hand. */
#ifndef DMI_BASE_NUMBER_BOUNDS_H
#define DMI_BASE_NUMBER_BOUNDS_H

/* Largest length (host units), angle (rad) and time of a track or a release (s) that is taken, and largest joint value:
 * cubes stay in a float's range, with room for what a drag makes of them, so that finite input gives finite output. */
#define DMI_LARGEST 1e9f
/* Largest number in the dual part of a pose: half of what a turn by 180 degrees about the farthest origin, 1.7e9 away,
 * moves by, and half of a screw's way, are 2.2e9; the rest is room for a pose on its way between two joints. */
#define DMI_LARGEST_DUAL 4e9f
/* Longest time, s: 30,000 years; longer is as long. */
#define DMI_LARGEST_TIME 1e12f
/* Largest velocity and acceleration, joint value a second or a second squared: no limit is felt any more. */
#define DMI_LARGEST_RATE 1e12f
/* Largest number that a saved drag holds: no less than any of the above, and its cube is in a float's range. */
#define DMI_LARGEST_SAVED 1e12f

#endif
