/* api_mover.c: movers, by address. Platforms of chosen categories are passed from below. */
#include "api.h"

#include <thud/thud_mover.h>

#include <stdlib.h>

typedef struct api_mover {
    thud_mover mover;
    thud_one_way one_way;
    thud_mover_report report;
} api_mover;

static api_buffer rows;

/* Slots: 0, 1 up  2 skin  3 greatest slope  4 height of a step  5 snap distance  6 push force
 * 7 category  8 mask  9 sensors  10 categories of one-way platforms. */
void api_mover_defaults(int kind, double hx, double hy, double angle) {
    thud_mover mover = thud_default_mover(api_placed(kind, hx, hy, angle));
    double *s = api_slots;
    s[0] = mover.up.x;
    s[1] = mover.up.y;
    s[2] = mover.skin;
    s[3] = mover.max_slope;
    s[4] = mover.step_height;
    s[5] = mover.snap_distance;
    s[6] = mover.push_force;
    s[7] = mover.filter.category;
    s[8] = mover.filter.mask;
    s[9] = mover.filter.sensors;
    s[10] = 0;
}

/* From the slots of api_mover_defaults; its address, 0 when memory is short. */
api_mover *api_mover_create(int kind, double x, double y, double hx, double hy, double angle,
                            uint32_t body_index1, uint32_t body_generation) {
    const double *s = api_slots;
    api_mover *made = calloc(1, sizeof *made);
    if (made == NULL)
        return NULL;
    thud_shape_instance shape = api_placed(kind, hx, hy, angle);
    shape.x = x;
    shape.y = y;
    made->mover = thud_default_mover(shape);
    made->mover.up = (thud_vec2){(float)s[0], (float)s[1]};
    made->mover.skin = s[2];
    made->mover.max_slope = s[3];
    made->mover.step_height = s[4];
    made->mover.snap_distance = s[5];
    made->mover.push_force = s[6];
    made->mover.filter = (thud_query_filter){api_to_u32(s[7]), api_to_u32(s[8]), s[9] != 0.0};
    made->mover.body = api_body(body_index1, body_generation);
    made->mover.pass = thud_mover_passes_one_way;
    made->mover.context = &made->one_way;
    made->one_way.categories = api_to_u32(s[10]);
    return made;
}

void api_mover_destroy(api_mover *mover) {
    free(mover);
}

/* Puts it elsewhere, in the air. */
void api_mover_place(api_mover *m, double x, double y) {
    m->mover.shape.x = x;
    m->mover.shape.y = y;
    m->mover.on_ground = false;
}

/* All that it keeps from one move to the next. Slots out: 0, 1 place  2 on the ground; 3, 4 that
 * ground's normal  5, 6 shape  7, 8 body  9, 10 point  11, 12 place  13, 14 cosine and sine. */
void api_mover_get_state(const api_mover *m) {
    const thud_mover *mover = &m->mover;
    double *s = api_slots;
    s[0] = mover->shape.x;
    s[1] = mover->shape.y;
    s[2] = mover->on_ground;
    s[3] = mover->ground_normal.x;
    s[4] = mover->ground_normal.y;
    s[5] = mover->ground_shape.index1;
    s[6] = mover->ground_shape.generation;
    s[7] = mover->ground_body.index1;
    s[8] = mover->ground_body.generation;
    s[9] = mover->ground_point.x;
    s[10] = mover->ground_point.y;
    s[11] = mover->ground_place.x;
    s[12] = mover->ground_place.y;
    s[13] = mover->ground_cosine;
    s[14] = mover->ground_sine;
}

/* From the same slots. */
void api_mover_set_state(api_mover *m) {
    thud_mover *mover = &m->mover;
    const double *s = api_slots;
    mover->shape.x = s[0];
    mover->shape.y = s[1];
    mover->on_ground = s[2] != 0.0;
    mover->ground_normal = (thud_vec2){(float)s[3], (float)s[4]};
    mover->ground_shape = (thud_shape_id){api_to_u32(s[5]), api_to_u32(s[6])};
    mover->ground_body = (thud_body_id){api_to_u32(s[7]), api_to_u32(s[8])};
    mover->ground_point = (thud_pos){s[9], s[10]};
    mover->ground_place = (thud_pos){s[11], s[12]};
    mover->ground_cosine = (float)s[13];
    mover->ground_sine = (float)s[14];
}

/* Slots out: 0, 1 place  2 on the ground  3, 4 ground's normal  5, 6 its shape  7, 8 its body
 * 9, 10 velocity left  11, 12 ground's velocity  13 depth  14 address and 15 count of what it met:
 * nine doubles each: shape, body, point, normal, depth; and after them 16 sensors: shapes. */
int api_mover_move(thud_world *world, api_mover *m, double vx, double vy, double dt, int drop) {
    m->one_way.drop = drop != 0;
    thud_result result =
        thud_mover_move(world, &m->mover, (thud_vec2){(float)vx, (float)vy}, dt, &m->report);
    if (result != THUD_OK)
        return result;
    const thud_mover *mover = &m->mover;
    const thud_mover_report *report = &m->report;
    api_buffer_clear(&rows);
    for (int i = 0; i < report->hit_count; i++) {
        const thud_mover_hit *hit = &report->hits[i];
        double row[9] = {hit->shape.index1,    hit->shape.generation, hit->body.index1,
                         hit->body.generation, hit->point.x,          hit->point.y,
                         hit->normal.x,        hit->normal.y,         hit->depth};
        api_buffer_push(&rows, row, sizeof row);
    }
    for (int i = 0; i < report->sensor_count; i++) {
        double id[2] = {report->sensors[i].index1, report->sensors[i].generation};
        api_buffer_push(&rows, id, sizeof id);
    }
    double *s = api_slots;
    s[0] = mover->shape.x;
    s[1] = mover->shape.y;
    s[2] = mover->on_ground;
    s[3] = mover->ground_normal.x;
    s[4] = mover->ground_normal.y;
    s[5] = mover->ground_shape.index1;
    s[6] = mover->ground_shape.generation;
    s[7] = mover->ground_body.index1;
    s[8] = mover->ground_body.generation;
    s[9] = report->velocity.x;
    s[10] = report->velocity.y;
    s[11] = report->ground_velocity.x;
    s[12] = report->ground_velocity.y;
    s[13] = report->depth;
    s[14] = (double)(uintptr_t)rows.data;
    s[15] = report->hit_count;
    s[16] = report->sensor_count;
    return api_buffer_result(&rows);
}
