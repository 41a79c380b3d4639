/* character.h: a figure to play with, on levels that ask for one, and the lifts that carry it. */
#ifndef THUD_PLAY_CHARACTER_H
#define THUD_PLAY_CHARACTER_H

#include "session.h"

#include <thud/thud_mover.h>

/* What the player wants, as long as it lasts. */
typedef struct character_keys {
    bool left, right, jump, down;
} character_keys;

typedef struct character {
    bool present;
    thud_mover mover;
    thud_one_way one_way;
    thud_vec2 velocity, ground_velocity;
    thud_pos before; /* where it was a step ago */
    character_keys keys;
    bool jump_held;      /* by the jump under way */
    bool jump_was_down;  /* the key, a step ago */
    double since_ground; /* seconds */
    double since_jump_key;
    float gravity; /* length/s^2 */
    float facing;  /* -1 left, 1 right */
    double start_x, start_y;
} character;

/* At the scene's spawn place, if its level has a character; gone if not. */
void character_start(character *c, session *s);

/* Moves it on by a step of the world, after that was made. */
void character_step(character *c, session *s);

bool character_moves(const character *c);

/* Where its middle is seen, `alpha` between the last two steps. */
thud_pos character_place(const character *c, double alpha);

#endif
