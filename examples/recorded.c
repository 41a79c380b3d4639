#include <stdio.h>
#include <thud/thud_make.h>
#include <thud/thud_recording.h>
#include <thud/thud_recorded.h>

int main(void) {
    thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default), *played;
    thud_recorder *recorder;
    thud_player *player;
    thud_bytes bytes;
    if (thud_recorder_begin(world, NULL, &recorder) != THUD_OK) {
        return 1;
    }
    thud_body_options dynamic = {.kind = THUD_BODY_DYNAMIC};
    thud_body_id ball = thud_body_make(world, thud_circle_at(0, 5, 0.5), &dynamic);
    for (int i = 0; i < 60; i++) {
        thud_body_apply_center_impulse(world, ball, (thud_vec2){0.125f, 0});
        thud_world_step(world);
    }
    if (thud_recorder_get_bytes(recorder, &bytes) != THUD_OK ||
        thud_player_create(bytes, NULL, &player) != THUD_OK) {
        return 1;
    }
    thud_player_seek(player, 60);
    thud_player_get_world(player, &played);
    printf("the hash is the same: %s\n",
           thud_hash_of(played) == thud_hash_of(world) ? "yes" : "no");
    thud_player_destroy(player);
    thud_recorder_end(recorder);
    thud_world_destroy(world);
    return 0;
}
