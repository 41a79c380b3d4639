#include <stdio.h>
#include <thud/thud.h>

int main(void) {
    thud_world *world;
    thud_world_def world_def = thud_default_world_def();
    if (thud_world_create(&world_def, &world) != THUD_OK)
        return 1;
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_id ground, ball;
    thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
    if (thud_body_create(world, &body_def, &ground) != THUD_OK ||
        thud_shape_create_terrain(world, ground, &shape_def, &flat, NULL) != THUD_OK)
        return 1;
    body_def.kind = THUD_DYNAMIC;
    body_def.position = (thud_pos){0.0, 4.0};
    if (thud_body_create(world, &body_def, &ball) != THUD_OK ||
        thud_shape_create_circle(world, ball, &shape_def, (thud_vec2){0, 0}, 0.5f, NULL) != THUD_OK)
        return 1;
    for (int i = 0; i < 120; i++)
        thud_world_step(world);
    thud_body_state state;
    thud_body_get(world, ball, &state);
    printf("the ball rests at y = %.2f\n", state.position.y);
    thud_world_destroy(world);
}
