/* without.h: leaving out what a scene may not require: the same scene without rotation, friction,
 * joints and so on. */
#ifndef THUD_RUN_WITHOUT_H
#define THUD_RUN_WITHOUT_H

#include "scene.h"

#include <thud/thud.h>

/* What can be left out, as bits. */
typedef enum without_part {
    WITHOUT_OBBS = 1 << 0,    /* oriented boxes that stand upright become AABBs, which never turn */
    WITHOUT_TURNING = 1 << 1, /* no dynamic body rotates */
    WITHOUT_FRICTION = 1 << 2, /* of shapes and rules */
    WITHOUT_BOUNCE = 1 << 3,   /* restitution of shapes and rules */
    WITHOUT_SLEEP = 1 << 4,    /* resting bodies stay awake */
    WITHOUT_DIRECT = 1 << 5,   /* the island solver */
    WITHOUT_JOINTS = 1 << 6,
    WITHOUT_SENSORS = 1 << 7,
    WITHOUT_FIELDS = 1 << 8, /* water, wind and explosions */
    WITHOUT_RULES = 1 << 9,  /* and what breaks by them */
    WITHOUT_EVENTS = 1 << 10 /* of contacts */
} without_part;

enum { WITHOUT_PARTS = 11 };

/* The name of the part with the bit 1 << index, as on the command line. */
const char *without_name(int index);
/* The bits of a list of names, "friction,bounce"; 0 where one is unknown. */
unsigned without_find(const char *names);

/* Leaves the parts out of a scene that was loaded whole. */
void without_change_scene(scene *s, unsigned parts);
/* Leaves the parts out of a world def. *quality holds the changed quality, and must live until the
 * world is created. */
void without_change_world(thud_world_def *def, thud_quality *quality, unsigned parts);
/* The parts of which the scene has something; all others change nothing. */
unsigned without_possible(const scene *s);

#endif
