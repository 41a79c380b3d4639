/* operations.c: the table of what a fuzzer plays. */
#include "operations.h"
#include "oracles.h"

uint64_t operations_played[OPERATION_BYTES];

#define PLAYS(name) \
    { #name, play_##name }

const named_operation operations[OPERATION_BYTES] = {
    PLAYS(step),
    PLAYS(thing),
    PLAYS(body),
    PLAYS(circle),
    PLAYS(aabb),
    PLAYS(obb),
    PLAYS(ground),
    PLAYS(body_destroy),
    PLAYS(shape_destroy),
    PLAYS(transform),
    PLAYS(velocity),
    PLAYS(impulse),
    PLAYS(force),
    PLAYS(awake),
    PLAYS(enabled),
    PLAYS(user_data),
    PLAYS(body_get),
    PLAYS(body_shapes),
    PLAYS(body_contacts),
    PLAYS(body_volume),
    PLAYS(shape_get),
    PLAYS(line_of),
    PLAYS(set_heights),
    PLAYS(dig),
    PLAYS(raise),
    PLAYS(replace),
    PLAYS(ray),
    PLAYS(ray_all),
    PLAYS(cast_shape),
    PLAYS(cast_shape_all),
    PLAYS(cast_circle),
    PLAYS(cast_circle_all),
    PLAYS(cast_box),
    PLAYS(cast_box_all),
    PLAYS(overlap_shape),
    PLAYS(overlap_circle),
    PLAYS(overlap_aabb),
    PLAYS(overlap_obb),
    PLAYS(closest),
    PLAYS(mover),
    PLAYS(mover_settings),
    PLAYS(mover_place),
    PLAYS(snapshot),
    PLAYS(restore),
    PLAYS(restore_damaged),
    PLAYS(advance),
    PLAYS(settings),
    PLAYS(qualities),
    PLAYS(reading),
    PLAYS(names),
    PLAYS(poses),
    PLAYS(drawing),
    PLAYS(refused_worlds),
    PLAYS(nulls),
    PLAYS(limit),
    PLAYS(wild_body),
    PLAYS(check),
    PLAYS(pair),
    PLAYS(pair_impact),
    PLAYS(pair_collision),
    PLAYS(approach),
    PLAYS(shape_ray),
    PLAYS(minkowski),
    PLAYS(bisectable),
    PLAYS(sincos),
    PLAYS(volume_fit),
    PLAYS(volume_points),
    PLAYS(volume_merge),
    PLAYS(volume_tests),
    PLAYS(line_sample),
    PLAYS(line_shape),
    PLAYS(line_impact),
    PLAYS(line_ray),
    PLAYS(foot),
    PLAYS(joint),
    PLAYS(joint_destroy),
    PLAYS(joint_edit),
    PLAYS(joint_get),
    PLAYS(joint_frame),
    PLAYS(joint_breaking),
    PLAYS(joint_lists),
    PLAYS(shape_edit),
    PLAYS(body_edit),
    PLAYS(push),
    PLAYS(points),
    PLAYS(reads),
};

void session_play(fuzz_session *s) {
    unsigned byte = next_byte(&s->bytes) % OPERATION_BYTES;
    byte = operations[byte].play ? byte : 0;
    const char *outer = s->operation;
    s->operation = operations[byte].name;
    operations_played[byte]++;
    operations[byte].play(s);
    s->operation = s->depth ? outer : s->operation;
}
