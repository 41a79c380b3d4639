/* trial_box2d.c: Box2D v3.2 with the 4 substeps that its manual recommends. */
#include "build_box2d.h"
#include "misuse_box2d.h"
#include "read_box2d.h"
#include "trial_engine.h"

#include <stdlib.h>

enum { SUBSTEPS = 4 };

typedef struct box2d_trial {
    b2WorldId id;
    float time_step;
    int body_count;
    b2BodyId bodies[];
} box2d_trial;

static void be_bullets(box2d_trial *own, bool (*is_bullet)(int body)) {
    b2World_SetMaximumLinearSpeed(own->id, 1e9f);
    for (int i = 0; i < own->body_count; i++)
        b2Body_SetBullet(own->bodies[i], is_bullet(i));
}

static void *create(const ledger *l, entrant e, const scene *s, const trial_settings *settings) {
    (void)l;
    (void)e;
    if (!box2d_can_run())
        return NULL;
    box2d_trial *own = calloc(1, sizeof *own + (size_t)s->body_count * sizeof own->bodies[0]);
    box2d_settings awake = {.sleeping = false, .events = false};
    if (!own || !scene_build_box2d(s, awake, &own->id, own->bodies)) {
        free(own);
        return NULL;
    }
    own->time_step = (float)settings->time_step;
    own->body_count = s->body_count;
    if (settings->is_bullet)
        be_bullets(own, settings->is_bullet);
    if (settings->every_bounce)
        b2World_SetRestitutionThreshold(own->id, 0);
    return own;
}

static void destroy(void *state) {
    box2d_trial *own = state;
    b2DestroyWorld(own->id);
    free(own);
}

static bool step(void *state) {
    box2d_trial *own = state;
    b2World_Step(own->id, own->time_step, SUBSTEPS);
    return true;
}

static bool set_time_step(void *state, double seconds) {
    box2d_trial *own = state;
    own->time_step = (float)seconds;
    return true;
}

static void read_bodies(void *state, contender_body *bodies) {
    box2d_trial *own = state;
    read_box2d(own->bodies, own->body_count, bodies);
}

static void read_pose(void *state, int body, thud_pos origin, thud_pose *out) {
    box2d_trial *own = state;
    b2WorldTransform pose = b2Body_GetTransform(own->bodies[body]);
    *out =
        (thud_pose){(float)(pose.p.x - origin.x), (float)(pose.p.y - origin.y), pose.q.c, pose.q.s};
}

static bool renew(void *state, const scene *s, int body) {
    box2d_trial *own = state;
    const scene_body *from = &s->bodies[body];
    b2BodyDef def = b2DefaultBodyDef();
    b2ShapeDef shape = b2DefaultShapeDef();
    b2Circle circle = {{0, 0}, (float)s->shapes[from->first_shape].hx};
    def.type = b2_dynamicBody;
    def.position = (b2Vec2){(float)from->x, (float)from->y};
    b2DestroyBody(own->bodies[body]);
    own->bodies[body] = b2CreateBody(own->id, &def);
    return B2_IS_NON_NULL(b2CreateCircleShape(own->bodies[body], &shape, &circle));
}

static bool misuse_body(void *state, int body, misuse call, double value) {
    box2d_trial *own = state;
    misuse_box2d(own->id, own->bodies[body], call, value);
    return false;
}

static uint64_t bytes(void *state) {
    box2d_trial *own = state;
    return (uint64_t)b2World_GetCounters(own->id).byteCount;
}

static uint64_t allocations(void *state) {
    (void)state;
    return 0;
}

const trial_engine TRIAL_BOX2D = {
    .create = create,
    .destroy = destroy,
    .step = step,
    .set_time_step = set_time_step,
    .read = read_bodies,
    .pose = read_pose,
    .renew = renew,
    .misuse = misuse_body,
    .bytes = bytes,
    .allocations = allocations,
};
