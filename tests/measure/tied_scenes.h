/* tied_scenes.h: scenes of bodies connected by joints, for the envelope, the trade-off and the
 * benchmark. Each function fills a scene that scene_init has initialised. The parts of a structure
 * do not collide with each other, so that only its joints matter. */
#ifndef THUD_MEASURE_TIED_SCENES_H
#define THUD_MEASURE_TIED_SCENES_H

#include "scene.h"

/* Body 0 is the static anchor at (0, 0); then follow the links, of 0.5 m and 1 kg, and a ball whose
 * rim is hinged to the last one. Joint i connects bodies i and i + 1. */
typedef struct chain_scene {
    int links;
    double weight; /* mass of the ball, in masses of a link */
    bool level;    /* starts horizontally, to the right; otherwise hanging */
} chain_scene;
void fill_chain(scene *s, const chain_scene *c);
double chain_length(const chain_scene *c); /* m, to the ball's rim */

/* Boxes of 0.5 m and 0.25 kg welded in a row to a wall, bodies 1 to `boxes`; if `tip` is above 0,
 * one more box of `tip` kg at the end. */
void fill_cantilever(scene *s, int boxes, double tip);

/* Planks of 1 m and 5 kg, hinged in a row between (0, 0) and (span, 0), where two posts, bodies 0
 * and 1, hold them; `weights` masses hang below planks at equal distances. Joints 0 to `planks` are
 * those of the planks, from left to right. The bridge begins in equilibrium, and all bodies have
 * damping. */
typedef struct bridge_scene {
    int planks;
    double span;
    int weights;
    double kg; /* mass of each weight */
} bridge_scene;
void fill_bridge(scene *s, const bridge_scene *b);
/* How far the lowest hinge is below the posts in equilibrium with rigid joints, m. Each plank
 * points along the force at its middle; Newton's method finds the forces with which the planks
 * reach from post to post. */
double bridge_sag(const bridge_scene *b);

/* A scissor lift: crossed bars of 1.8 m and 1 kg in stages of 1 m, and a platform of `kg` on top,
 * the last body. Both feet are hinged to the ground, so that nothing can move. */
void fill_scissor(scene *s, int stages, double kg);

/* A horizontal bar of 1 m, hinged at its end. Several `bars` in a row make a double pendulum or
 * longer one. */
void fill_pendulum(scene *s, int bars);

/* A door of 2 m and 10 kg with a knob of 100 kg, one body, which swings at 10 rad/s towards its
 * limit of 0.5 rad. */
void fill_door(scene *s);
/* A box of 1 kg on a horizontal slider. If `hung`, 100 kg hang at its corner; otherwise 100 kg hit
 * it from above at 10 m/s. */
void fill_slider(scene *s, bool hung);
/* A four-bar linkage: a motor turns a crank once per second, whose coupler moves a rocker of 100
 * times its mass. */
void fill_four_bar(scene *s);
/* A body of 1 kg on a spring that is stretched by 0.25 m or rad, without gravity. */
void fill_spring(scene *s, scene_joint_kind kind, double frequency, double damping);

/* `count` figures of 11 bodies and 10 hinges with limits, which fall on stairs. */
void fill_ragdolls(scene *s, int count);
/* The same figures fall into a pit, in twice as many rows as columns, and form a heap. */
void fill_ragdoll_heap(scene *s, int count);
/* A square grid of circles, each hinged to the one above it and the one to its left, held in the
 * middle of the upper row. */
void fill_joint_grid(scene *s, int side);
/* `count` chains of 50 links with a ball of 10 times a link's mass, which start horizontally. */
void fill_chains(scene *s, int count);
/* `count` bridges of 50 planks, with ten boxes that fall on each. */
void fill_bridges(scene *s, int count);
/* A bridge of this many planks, with a box placed on every fifth one. */
void fill_boxed_bridge(scene *s, int planks);
/* Cars with a chassis and two wheels on suspensions, driving over bumps. */
void fill_cars(scene *s, int count);

#endif
