/* character.h: the character that a player controls, on levels that ask for one, and the lifts
 * (moving platforms) that carry it. */
#ifndef THUD_PLAY_CHARACTER_H
#define THUD_PLAY_CHARACTER_H

#include "session.h"

#include <thud/thud_mover.h>

/* The keys that are down. */
typedef struct character_keys {
    bool left, right, jump, down;
} character_keys;

typedef struct character {
    bool present;
    thud_mover mover;
    thud_one_way one_way;
    thud_vec2 velocity, ground_velocity;
    thud_pos before; /* its centre before the last step */
    character_keys keys;
    bool jump_held;      /* the jump key is down since the current jump began */
    bool jump_was_down;  /* whether the jump key was down in the last step */
    double since_ground; /* seconds since it stood on ground */
    double since_jump_key;
    float gravity; /* length/s^2, downwards */
    float facing;  /* -1 left, 1 right */
    double start_x, start_y;
} character;

/* Places the character at the scene's spawn point, if its level has one; else sets `present` to
 * false. */
void character_start(character *c, session *s);

/* Moves the character by one step, after the world's step. */
void character_step(character *c, session *s);

/* Whether the last step moved it. */
bool character_moves(const character *c);

/* Its centre on the screen, interpolated by `alpha` between the last two steps. */
thud_pos character_place(const character *c, double alpha);

#endif
