/* listeners.h: the listeners of a world. listeners.c has those of the world itself. Epilogues of
 * single objects (epilogues.c) and decisions (decide.c) are reached by tables of functions, so that
 * only programs that use them link them. */
#ifndef TD_LISTENERS_H
#define TD_LISTENERS_H

#include "listeners/decisions.h"
#include "state/world.h"
#include "thud/thud_listeners.h"

/* The contacts that a prologue has been called for and has not answered yet: an array. `number`: of
 * its first contact among all contacts of the step. */
typedef struct td_question {
    const thud_contact *contacts;
    int count; /* 0: no prologue is being called */
    int number;
    bool impact; /* it is one impact within the step, which has no number */
} td_question;

/* The calls by which listeners.c runs the epilogues of objects. */
typedef struct td_object_hooks {
    /* Whether an object of the pair has an epilogue. */
    bool (*wants)(const thud_world *w, int shape_a, int shape_b);
    void (*tell)(thud_world *w, const thud_contact *seen);
    /* Removes the epilogues of bodies that no longer exist. Returns whether any epilogue of an
     * object is left. */
    bool (*prune)(thud_world *w);
    void (*end)(thud_world *w); /* frees them, as the world is destroyed */
} td_object_hooks;

typedef struct td_listeners {
    thud_listeners calls;
    td_array contacts; /* thud_contact: of prologue_all and epilogue_all */
    td_array answers;  /* thud_contact_answer: of prologue_all, in the same order */
    td_question asked;
    const td_object_hooks *object_hooks; /* null: no object ever had an epilogue */
    struct td_objects *objects;          /* null as object_hooks; epilogues.c */
    bool tells_objects;                  /* an object has an epilogue */
} td_listeners;

/* Gives the world listeners that do nothing, if it has none yet. False when memory is short. */
bool td_listeners_make(thud_world *w);
/* Sets thud_world.tells after the epilogues of the world or of objects have changed. */
void td_listeners_update(thud_world *w);

#endif
