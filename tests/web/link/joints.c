/* joints.c: a program that uses every kind of joint, to measure its size when linked, and to
 * compare it with the same linkage built with the package (tests/web/support/linkage.mjs). */
#define QUALITY thud_quality_default
#include "circles.c"

#include <thud/thud_joint.h>

enum { LINKS = 6 };

typedef struct link {
    thud_body_id body;
    thud_vec2 place;
} link;

static link add_link(thud_world *world, thud_body_kind kind, float x, float y) {
    thud_body_def def = thud_default_body_def();
    def.kind = kind;
    def.position = (thud_pos){x, y};
    link made = {.place = {x, y}};
    thud_shape_def shape = thud_default_shape_def();
    thud_body_create(world, &def, &made.body);
    thud_shape_create_circle(world, made.body, &shape, (thud_vec2){0.25f, 0}, 0.375f, NULL);
    return made;
}

/* A def whose frames are both at a place in the world, turned by `angle`. */
static thud_joint_def tie(thud_joint_kind kind, link a, link b, float x, float y, double angle) {
    thud_joint_def def = thud_default_joint_def(kind);
    def.body_a = a.body;
    def.body_b = b.body;
    def.frame_a = (thud_joint_frame){{x - a.place.x, y - a.place.y}, angle};
    def.frame_b = (thud_joint_frame){{x - b.place.x, y - b.place.y}, angle};
    return def;
}

static thud_joint_id make(thud_world *world, thud_joint_def def) {
    thud_joint_id joint = {0};
    thud_joint_create(world, &def, &joint);
    return joint;
}

/* Two wheels on a wall that a gear connects. */
static void add_train(thud_world *world, link wall) {
    thud_joint_def gear = thud_default_joint_def(THUD_JOINT_GEAR);
    for (int i = 0; i < 2; i++) {
        link wheel = add_link(world, THUD_BODY_DYNAMIC, -4.0f - 2 * (float)i, 5);
        thud_joint_def axle = tie(THUD_JOINT_HINGE, wall, wheel, wheel.place.x, 5, 0);
        axle.drive[THUD_DIRECTION_TURN].motor_speed = 3;
        axle.drive[THUD_DIRECTION_TURN].motor_force = i == 0 ? 5 : 0;
        gear.gear[i] = make(world, axle);
    }
    gear.ratio = -2;
    make(world, gear);
}

static thud_world *make_linkage(void) {
    thud_world *world = open_world();
    link wall = add_link(world, THUD_BODY_STATIC, 0, 8), links[LINKS];
    for (int i = 0; i < LINKS; i++)
        links[i] = add_link(world, THUD_BODY_DYNAMIC, 1.5f + 1.5f * (float)i, 8);
    thud_joint_def hinge = tie(THUD_JOINT_HINGE, wall, links[0], 0.75f, 8, 0);
    hinge.drive[THUD_DIRECTION_TURN] = (thud_drive){.limited = true, .lower = -1, .upper = 0.5f};
    make(world, hinge);
    thud_joint_def weld = tie(THUD_JOINT_WELD, links[0], links[1], 2.25f, 8, 0);
    weld.drive[THUD_DIRECTION_TURN].frequency = 4;
    weld.break_force = 200;
    make(world, weld);
    thud_joint_def rope = thud_default_joint_def(THUD_JOINT_DISTANCE);
    rope.body_a = links[1].body;
    rope.body_b = links[2].body;
    rope.drive[THUD_DIRECTION_ALONG].limited = true;
    rope.drive[THUD_DIRECTION_ALONG].upper = 2;
    make(world, rope);
    thud_joint_def slider = tie(THUD_JOINT_SLIDER, links[2], links[3], 5.25f, 8, 0.5);
    slider.drive[THUD_DIRECTION_ALONG] =
        (thud_drive){.limited = true, .lower = -0.5f, .upper = 0.25f};
    make(world, slider);
    thud_joint_def wheel = tie(THUD_JOINT_WHEEL, links[3], links[4], 7.5f, 8, 1.5);
    wheel.drive[THUD_DIRECTION_ALONG].frequency = 3;
    make(world, wheel);
    thud_joint_def target = tie(THUD_JOINT_TARGET, wall, links[5], 9, 8, 0);
    target.drive[THUD_DIRECTION_ALONG].frequency = target.drive[THUD_DIRECTION_ACROSS].frequency =
        2;
    make(world, target);
    make(world, tie(THUD_JOINT_FILTER, links[4], links[5], 0, 0, 0));
    add_train(world, wall);
    return world;
}

/* The upper or lower 32 bits of the hash after this many steps. */
EXPORT("linkage_hash") double linkage_hash(int steps, int upper) {
    thud_world *world = make_linkage();
    for (int i = 0; i < steps; i++)
        thud_world_step(world);
    uint64_t hash = thud_hash_of(world);
    thud_world_destroy(world);
    return (double)(uint32_t)(upper ? hash >> 32 : hash);
}
