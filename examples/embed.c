#include <stdio.h>
#include <thud/thud_all.h>

int main(void) {
    thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default);
    thud_body_options moving = {.kind = THUD_BODY_DYNAMIC};
    thud_pos place = {0, 0};
    thud_body_make(world, thud_aabb_at(0, -1, 20, 1), NULL);
    thud_body_id ball = thud_body_make(world, thud_circle_at(0, 4, 0.5), &moving);
    for (int i = 0; i < 120; i++)
        thud_world_step(world);
    thud_body_get_position(world, ball, &place);
    printf("the ball rests at y = %.2f\n", place.y);
    thud_world_destroy(world);
}
