/* ruling.h: what a world's rules decide, as its stages ask. A world has them from its first rule
 * or filter on, so that a program without does not link them. */
#ifndef TD_RULING_H
#define TD_RULING_H

#include "state/world.h"

typedef struct td_ruling_ops {
    /* Whether two shapes, whose filters let them, may make a pair. */
    bool (*allows)(const thud_world *w, int shape_a, int shape_b);
    /* What the rule of two shapes makes of their settings. Returns what a lane of theirs keeps as
     * td_lane_marks.rule. */
    uint16_t (*settle)(const thud_world *w, int shape_a, int shape_b,
                       thud_contact_settings *settings);
    /* Whether a static shape, or one of the other's neighbours, hides what is behind it from
     * another that it may only hold from one side. */
    bool (*hides)(const thud_world *w, int shape, int other);
    /* Whether two that meet on the way pass through each other. */
    bool (*lets_through)(const thud_world *w, const thud_contact *seen);
    /* Which one-way pairs hold in this step; the others do nothing. */
    void (*decide)(thud_world *w);
    /* Room for events. False when memory is short. */
    bool (*reserve)(thud_world *w);
    /* Events of what has borne too much. */
    void (*tell)(thud_world *w);
    void (*end)(thud_world *w); /* with the world */
} td_ruling_ops;

#endif
