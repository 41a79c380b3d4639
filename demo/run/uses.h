/* uses.h: what a scene has, and what of it a run used: which bodies turned, bounced, slid, slept,
 * which contacts the direct solver held, how high bodies stood on each other.
 *
 * Everything is read between steps, so that the run keeps its bits. Tolerances are those at which
 * the engine itself takes something as nothing: the speed below which a body falls asleep. */
#ifndef THUD_RUN_USES_H
#define THUD_RUN_USES_H

#include "run.h"

enum { USES_SHAPE_KINDS = 4, USES_JOINT_KINDS = SCENE_GEAR + 1 };

typedef struct uses {
    /* What the scene has. */
    int dynamic_bodies, kinematic_bodies, static_bodies;
    int shapes[USES_SHAPE_KINDS]; /* by thud_shape_kind; sensors are among them */
    int sensors;
    int joints[USES_JOINT_KINDS]; /* by scene_joint_kind */
    int joint_count;
    int blasts, rules;
    bool water, wind, breaking;
    /* What the run used: numbers of dynamic bodies that ever did so. */
    int turned;       /* by more than 0.001 rad from the start */
    int turned_boxes; /* those of them with an oriented box: turning circles change no contact */
    int bounced; /* had a hit event (met something at more than the world's hit_speed) in a pair
                    with restitution */
    int slid;    /* had a contact that bore a force while the two surfaces slid along each other at
                    0.05 length scales a second or more */
    int rubbed;  /* had a contact whose impulse of friction was more than a thousandth of its normal
                    impulse */
    int slept;
    /* Sums over all steps. */
    long held, held_steps; /* bodies that continuous detection held back, and steps with any */
    long impacts;          /* collisions that bisect or swept resolved within a step */
    long contacts, direct_contacts; /* touching pairs of awake bodies; solved directly */
    long direct_steps;              /* steps that solved any island directly */
    /* Largest values of any step. */
    int stack; /* the number of bodies in the highest pile, counted upwards from a body that is not
                  dynamic */
    double mass_ratio; /* the heavier over the lighter of two dynamic bodies that pressed on each
                          other or are joined; 1: there were none */
    double speed;      /* of a body's centre over thud_world_get_bisection_limit; from 1 on a body
                          may pass through the thinnest shape within a step */
} uses;

/* Runs the scene and counts. False after a message. */
bool uses_count(const run_options *options, const scene *s, run_outcome *outcome, uses *out);

void uses_print_text(const uses *u);
struct cJSON;
/* `hash` is that of the run. */
struct cJSON *uses_json(const uses *u, uint64_t hash);

#endif
