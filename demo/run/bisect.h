/* bisect.h: where two builds of thud differ when they play a recording: --bisect, and the options
 * --hashes and --hash-at by which one build asks the other.
 *
 *     OTHER --replay FILE --hashes FROM,TO,EVERY
 *
 * plays from the last keyframe at or before step FROM, and prints a line "STEP HASH" for step FROM,
 * each EVERY-th after it, and TO. Where the played world differs from the recorded one, playing
 * ends, and the line of the step reached is the last.
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
 * In a first pass both builds play the whole recording, and hashes of few steps, far from each
 * other, are compared. The builds agree up to the last step whose hashes are equal; so the steps
 * after it are then played again, from the keyframe before it, and compared one by one. The first
 * pass does not jump to keyframes: these are states of the build that recorded, so that after one
 * both builds would have the same state again. */
bool bisect_builds(const run_options *options, thud_player *player);

#endif
