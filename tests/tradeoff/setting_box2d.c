/* setting_box2d.c: Box2D v3.2 at 1 to 16 substeps, with its default contact stiffness and with one
 * that is scaled with the substeps.
 *
 * Its step lowers b2WorldDef.contactHertz to an eighth of the substep rate (b2World_Step), and
 * takes twice that against static bodies. The default is 30 Hz: at 60 steps a second it is lowered
 * to 7.5 and 15 Hz at one and two substeps, just allowed at four, and keeps contacts from getting
 * stiffer beyond. Scaled means the most that it allows, 7.5 Hz a substep: the same settings as the
 * default's up to four substeps, so that these three are run once and belong to both curves.
 *
 * Bodies for which a scene wants swept detection are flagged as bullets, which Box2D stops at
 * moving shapes too.
 *
 * The highest speed, 400 m/s by default, is lifted: what is cut to it errs in speed, and would be
 * compared at something else than the trial asks. All else is at its defaults. */
#include "build_box2d.h"
#include "read_box2d.h"
#include "setting.h"

#include <stdio.h>
#include <stdlib.h>

#define CONTACT_HERTZ 30.0            /* of b2DefaultWorldDef */
#define CONTACT_HERTZ_PER_SUBSTEP 7.5 /* 60 / 8 */
#define DAMPING_RATIO 10.0f           /* of b2DefaultWorldDef, */
#define PUSH_SPEED 3.0f               /* and so is this */
#define MAXIMUM_SPEED 1e6f

typedef struct own_world {
    b2WorldId id;
    int substeps, body_count;
    b2BodyId bodies[];
} own_world;

static void *create(const scene *s, const setting *how) {
    if (!box2d_can_run())
        return NULL;
    own_world *own = calloc(1, sizeof *own + (size_t)s->body_count * sizeof own->bodies[0]);
    box2d_settings defaults = {.sleeping = false};
    if (!own || !scene_build_box2d(s, defaults, &own->id, own->bodies)) {
        fprintf(stderr, "box2d: scene %s could not be built\n", s->name);
        free(own);
        return NULL;
    }
    own->body_count = s->body_count;
    own->substeps = how->substeps;
    b2World_SetContactTuning(own->id, (float)how->contact_hertz, DAMPING_RATIO, PUSH_SPEED);
    b2World_SetMaximumLinearSpeed(own->id, MAXIMUM_SPEED);
    for (int i = 0; i < s->body_count; i++)
        b2Body_SetBullet(own->bodies[i], s->bodies[i].detection == SCENE_SWEPT);
    return own;
}

static void destroy(void *state) {
    own_world *own = state;
    if (own)
        b2DestroyWorld(own->id);
    free(own);
}

static bool step(void *state) {
    own_world *own = state;
    b2World_Step(own->id, (float)CONTENDER_TIME_STEP, own->substeps);
    return true;
}

static void read_bodies(void *state, contender_body *bodies) {
    own_world *own = state;
    read_box2d(own->bodies, own->body_count, bodies);
}

static const setting_engine ENGINE = {"box2d", create, destroy, step, read_bodies};

#define AS_DEFAULT(n)                                                   \
    {                                                                   \
        .engine = &ENGINE, .name = #n, .curve = "box2d", .substeps = n, \
        .contact_hertz = CONTACT_HERTZ                                  \
    }
#define SCALED(n)                                                                      \
    {                                                                                  \
        .engine = &ENGINE, .name = #n " stiff", .curve = "box2d stiff", .substeps = n, \
        .contact_hertz = n * CONTACT_HERTZ_PER_SUBSTEP                                 \
    }

const setting SETTINGS_BOX2D[] = {AS_DEFAULT(1),  AS_DEFAULT(2), AS_DEFAULT(4), AS_DEFAULT(8),
                                  AS_DEFAULT(16), SCALED(8),     SCALED(16)};
const int SETTINGS_BOX2D_COUNT = sizeof SETTINGS_BOX2D / sizeof SETTINGS_BOX2D[0];
