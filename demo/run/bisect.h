/* bisect.h: where two builds of thud differ when they play a recording: --bisect, and the options
 * --hashes and --hash-at by which one build asks the other.
 *
 *     OTHER --replay FILE --hashes FROM,TO,EVERY
 *
 * plays from the last keyframe at or before step FROM, and prints a line "STEP HASH" for step FROM,
 * each EVERY-th after it, and TO. Where the recording cannot be played on, since it differs,
 * the line of the step where it stands is the last.
 *
 *     OTHER --replay FILE --hash-at STEP
 *
 * prints this line for one step, to which it plays from the last keyframe before it, and then
 * "SLOT HASH" for each body: the hash of its pose and velocity. */
#ifndef THUD_RUN_BISECT_H
#define THUD_RUN_BISECT_H

#include "options.h"

#include <thud/thud_recording.h>

/* Prints what --hashes and --hash-at ask for. Both return false, after a message, if the recording
 * has no such step, or memory runs out. */
bool bisect_print_hashes(const run_options *options, thud_player *player);
bool bisect_print_bodies(const run_options *options, thud_player *player);

/* Finds the first step at which the build options->bisect has another hash than this one, and the
 * first body that differs there, and prints them. False if there is one, or, after a message, if
 * the other build does not answer.
 *
 * Both play the recording once, and one hash of many steps is compared. Up to the last one that is
 * the same both agree, so that the steps after it are then played again from the keyframe before
 * it, and compared one by one. Keyframes are not gone to in the first pass: they are the state of
 * the build that recorded, and would bring back together what has parted. */
bool bisect_builds(const run_options *options, thud_player *player);

#endif
