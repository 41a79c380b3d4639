/* tied_scenes.h: scenes of bodies that joints hold together, as the envelope, the trade-off and the
 * benchmark have them. Each fills a scene that scene_init has made; nothing of one thing meets
 * another part of it, so that only its joints count. */
#ifndef THUD_MEASURE_TIED_SCENES_H
#define THUD_MEASURE_TIED_SCENES_H

#include "scene.h"

/* Body 0 is the anchor, at (0, 0); then the links, of 0.5 m and 1 kg, and a ball whose rim hangs at
 * the last one. Joint i ties bodies i and i + 1. */
typedef struct chain_scene {
    int links;
    double weight; /* of the ball, in links */
    bool level;    /* starts level, to the right; else hangs */
} chain_scene;
void fill_chain(scene *s, const chain_scene *c);
double chain_length(const chain_scene *c); /* to the ball's rim */

/* Boxes of 0.5 m and 0.25 kg, welded in a row to a wall, bodies 1 to `boxes`; and where tip is
 * above 0, one more of so many kg. */
void fill_cantilever(scene *s, int boxes, double tip);

/* Planks of 1 m and 5 kg, hinged in a row between (0, 0) and (span, 0), which two posts, bodies 0
 * and 1, hold; and so many weights below planks, evenly. Joints 0 to `planks` are those of the
 * planks, from left to right. It starts in equilibrium; all is damped. */
typedef struct bridge_scene {
    int planks;
    double span;
    int weights;
    double kg; /* each */
} bridge_scene;
void fill_bridge(scene *s, const bridge_scene *b);
/* How far the lowest hinge is below the posts in equilibrium, where no joint gives way: each plank
 * lies along the force at its middle, and a Newton iteration finds the forces with which the planks
 * reach from post to post. */
double bridge_sag(const bridge_scene *b);

/* Crossed bars of 1.8 m and 1 kg, stage upon stage of 1 m, and a platform on top, the last body, of
 * so many kg. Feet are hinged to the ground: nothing can move. */
void fill_scissor(scene *s, int stages, double kg);

/* A bar of 1 m, hinged at its end and level; `bars` of them in a row make a double pendulum and
 * more.
 */
void fill_pendulum(scene *s, int bars);

/* A door of 2 m and 10 kg with a knob of 100 kg, swinging at 10 rad/s towards its limit of 0.5. */
void fill_door(scene *s);
/* A box of 1 kg on a level slider; `hung`: 100 kg hang on its corner; else 100 kg hit it from above
 * at 10 m/s. */
void fill_slider(scene *s, bool hung);
/* A motor turns a crank once a second, whose coupler moves a rocker of 100 times its mass. */
void fill_four_bar(scene *s);
/* A body of 1 kg on a spring, stretched by 0.25 m or rad, without gravity. */
void fill_spring(scene *s, scene_joint_kind kind, double frequency, double damping);

/* So many figures of 11 bodies and 10 hinges with limits fall on stairs. */
void fill_ragdolls(scene *s, int count);
/* The same figures fall into a pit, two as high as wide, where they lie in a heap. */
void fill_ragdoll_heap(scene *s, int count);
/* Circles hinged to those above and to the left, hung in the middle of the upper row. */
void fill_joint_grid(scene *s, int side);
/* Chains of 50 links with a ball of 10 times a link's mass, starting level. */
void fill_chains(scene *s, int count);
/* Bridges of 50 planks, and ten boxes that fall on each. */
void fill_bridges(scene *s, int count);
/* One bridge of so many planks, and a box on every fifth one, set down gently. */
void fill_boxed_bridge(scene *s, int planks);
/* Cars of a chassis and two wheels on suspensions, on bumps. */
void fill_cars(scene *s, int count);

#endif
