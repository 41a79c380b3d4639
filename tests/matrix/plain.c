/* plain.c: see plain.h. Each serialize_ function reads or writes a value, depending on the stream,
 * so that there is one order for both. */
#include "plain.h"
#include "texture.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

typedef struct stream {
    FILE *file;
    bool writes, failed;
} stream;

/* Reads or writes a word as 16 hexadecimal digits. */
static void serialize_word(stream *t, uint64_t *word) {
    if (t->writes) {
        t->failed = t->failed || fprintf(t->file, "%016" PRIx64 "\n", *word) < 0;
        return;
    }
    char text[32] = "";
    t->failed = t->failed || fscanf(t->file, "%31s", text) != 1 || strlen(text) != 16 ||
                strspn(text, "0123456789abcdef") != 16;
    *word = t->failed ? 0 : strtoull(text, NULL, 16);
}

/* Each serialize_ function writes its value to the stream, or reads it, by t->writes. */
static void serialize_double(stream *t, double *value) {
    uint64_t word;
    memcpy(&word, value, sizeof word);
    serialize_word(t, &word);
    memcpy(value, &word, sizeof word);
}

static void serialize_doubles(stream *t, double *const *values, int count) {
    for (int i = 0; i < count; i++)
        serialize_double(t, values[i]);
}

static void serialize_u32(stream *t, uint32_t *value) {
    uint64_t word = *value;
    serialize_word(t, &word);
    *value = (uint32_t)word;
}

static void serialize_int(stream *t, int *value) {
    uint32_t word = (uint32_t)*value;
    serialize_u32(t, &word);
    *value = (int)word;
}

static void serialize_bool(stream *t, bool *value) {
    uint32_t word = *value;
    serialize_u32(t, &word);
    *value = word != 0;
}

static void serialize_body(stream *t, scene_body *b) {
    double *const values[] = {&b->x,
                              &b->y,
                              &b->angle,
                              &b->vx,
                              &b->vy,
                              &b->angular_velocity,
                              &b->gravity_scale,
                              &b->linear_damping,
                              &b->angular_damping};
    int kind = (int)b->kind, detection = (int)b->detection;
    serialize_int(t, &kind);
    serialize_doubles(t, values, sizeof values / sizeof *values);
    serialize_bool(t, &b->fixed_rotation);
    serialize_bool(t, &b->may_sleep);
    serialize_int(t, &detection);
    serialize_u32(t, &b->id);
    serialize_int(t, &b->first_shape);
    serialize_int(t, &b->shape_count);
    b->kind = (scene_body_kind)kind;
    b->detection = (scene_detection)detection;
}

static void serialize_shape(stream *t, scene_shape *s) {
    double *const values[] = {&s->x,
                              &s->y,
                              &s->hx,
                              &s->hy,
                              &s->angle,
                              &s->slope,
                              &s->spacing,
                              &s->material.density,
                              &s->material.friction,
                              &s->material.restitution};
    int kind = (int)s->kind, group = s->group;
    serialize_int(t, &kind);
    serialize_doubles(t, values, sizeof values / sizeof *values);
    serialize_int(t, &s->first_point);
    serialize_int(t, &s->point_count);
    serialize_int(t, &s->texture_row);
    t->failed = t->failed || s->texture_row < 0 || s->texture_row > TEXTURE_ROWS;
    serialize_bool(t, &s->sensor);
    serialize_u32(t, &s->category);
    serialize_u32(t, &s->mask);
    serialize_int(t, &group);
    s->kind = (scene_shape_kind)kind;
    s->group = group;
}

static void serialize_drive(stream *t, scene_drive *d) {
    double *const values[] = {&d->lower,  &d->upper,        &d->frequency,   &d->damping,
                              &d->target, &d->spring_force, &d->motor_speed, &d->motor_force};
    serialize_bool(t, &d->limited);
    serialize_doubles(t, values, sizeof values / sizeof *values);
}

static void serialize_joint(stream *t, scene_joint *j) {
    double *const values[] = {&j->x[0],        &j->y[0],        &j->angle[0], &j->x[1],
                              &j->y[1],        &j->angle[1],    &j->length,   &j->ratio,
                              &j->break_force, &j->break_torque};
    int kind = (int)j->kind;
    serialize_int(t, &kind);
    serialize_int(t, &j->body[0]);
    serialize_int(t, &j->body[1]);
    serialize_doubles(t, values, sizeof values / sizeof *values);
    for (int i = 0; i < SCENE_DIRECTIONS; i++)
        serialize_drive(t, &j->drive[i]);
    serialize_bool(t, &j->collide_connected);
    j->kind = (scene_joint_kind)kind;
}

static void serialize_rule(stream *t, scene_rule *r) {
    double *const values[] = {&r->friction, &r->restitution, &r->surface_speed, &r->event_impulse};
    int meeting = (int)r->kind;
    serialize_int(t, &r->step);
    serialize_u32(t, &r->first);
    serialize_u32(t, &r->second);
    serialize_int(t, &meeting);
    serialize_doubles(t, values, sizeof values / sizeof *values);
    r->kind = (scene_rule_kind)meeting;
}

static void serialize_fields(stream *t, scene_fields *f) {
    double *const values[] = {&f->water_density, &f->water_level, &f->water_drag, &f->air_density,
                              &f->wind,          &f->wind_origin, &f->air_drag,   &f->air_lift};
    serialize_doubles(t, values, sizeof values / sizeof *values);
    serialize_int(t, &f->blast_count);
    t->failed = t->failed || f->blast_count < 0 || f->blast_count > SCENE_BLASTS_MAX;
    for (int i = 0; i < f->blast_count && !t->failed; i++) {
        scene_blast *b = &f->blasts[i];
        double *const of_blast[] = {&b->x, &b->y, &b->radius, &b->falloff, &b->impulse};
        serialize_int(t, &b->step);
        serialize_doubles(t, of_blast, sizeof of_blast / sizeof *of_blast);
    }
    serialize_int(t, &f->rule_count);
    t->failed = t->failed || f->rule_count < 0 || f->rule_count > SCENE_RULES_MAX;
    for (int i = 0; i < f->rule_count && !t->failed; i++)
        serialize_rule(t, &f->rules[i]);
    serialize_u32(t, &f->breaks);
    serialize_u32(t, &f->pieces);
}

/* Allocates room for the counts that were read. Wrong counts are found later, because the file then
 * has too few words. */
static void make_room(stream *t, scene *s) {
    const int most = 1 << 20;
    bool fits = s->body_count >= 0 && s->body_count <= most && s->shape_count >= 0 &&
                s->shape_count <= most && s->point_count >= 0 && s->point_count <= most &&
                s->joint_count >= 0 && s->joint_count <= most;
    t->failed = t->failed || !fits;
    if (t->failed) {
        s->body_count = s->shape_count = s->point_count = s->joint_count = 0;
        return;
    }
    s->bodies = calloc((size_t)s->body_count + 1, sizeof *s->bodies);
    s->shapes = calloc((size_t)s->shape_count + 1, sizeof *s->shapes);
    s->points = calloc((size_t)s->point_count + 1, sizeof *s->points);
    s->joints = calloc((size_t)s->joint_count + 1, sizeof *s->joints);
    s->body_capacity = s->body_count;
    s->shape_capacity = s->shape_count;
    s->point_capacity = s->point_count;
    s->joint_capacity = s->joint_count;
    t->failed = !s->bodies || !s->shapes || !s->points || !s->joints;
}

static void serialize_scene(stream *t, scene *s) {
    double *const values[] = {&s->gravity_x, &s->gravity_y, &s->length_scale};
    serialize_doubles(t, values, sizeof values / sizeof *values);
    serialize_int(t, &s->body_count);
    serialize_int(t, &s->shape_count);
    serialize_int(t, &s->point_count);
    serialize_int(t, &s->joint_count);
    if (!t->writes)
        make_room(t, s);
    for (int i = 0; i < s->body_count && !t->failed; i++)
        serialize_body(t, &s->bodies[i]);
    for (int i = 0; i < s->shape_count && !t->failed; i++)
        serialize_shape(t, &s->shapes[i]);
    for (int i = 0; i < s->point_count && !t->failed; i++) {
        serialize_double(t, &s->points[i].x);
        serialize_double(t, &s->points[i].y);
    }
    for (int i = 0; i < s->joint_count && !t->failed; i++)
        serialize_joint(t, &s->joints[i]);
    serialize_fields(t, &s->fields);
}

bool plain_write(FILE *file, const plain_title *title, scene *s) {
    stream t = {.file = file, .writes = true};
    t.failed = fprintf(file, "%s %s\n", title->kind, title->name) < 0;
    serialize_scene(&t, s);
    return !t.failed;
}

/* Whether all indices of bodies, shapes and joints are within their lists. */
static bool consistent(const scene *s) {
    bool fits = true;
    for (int i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        fits = fits && b->first_shape >= 0 && b->shape_count >= 0 &&
               b->shape_count <= s->shape_count - b->first_shape;
    }
    for (int i = 0; i < s->shape_count; i++) {
        const scene_shape *shape = &s->shapes[i];
        fits = fits && shape->first_point >= 0 && shape->point_count >= 0 &&
               shape->point_count <= s->point_count - shape->first_point;
    }
    for (int i = 0; i < s->joint_count; i++) {
        const scene_joint *joint = &s->joints[i];
        int most = joint->kind == SCENE_GEAR ? i : s->body_count;
        fits = fits && joint->body[0] >= 0 && joint->body[0] < most && joint->body[1] >= 0 &&
               joint->body[1] < most;
    }
    return fits;
}

bool plain_read(FILE *file, plain_title *title, scene *s, bool *damaged) {
    scene_init(s);
    *damaged = false;
    if (fscanf(file, "%15s", title->kind) != 1)
        return false;
    stream t = {.file = file};
    t.failed = fscanf(file, "%63s", title->name) != 1;
    serialize_scene(&t, s);
    if (t.failed || !consistent(s)) {
        *damaged = true;
        scene_free(s);
    }
    return !*damaged;
}
