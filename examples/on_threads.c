#include <stdio.h>
#include <thud/thud_make.h>
#include <thud/thud_threads.h>

int main(void) {
    thud_threads *threads;
    if (thud_threads_create(4, NULL, &threads) != THUD_OK)
        return 1;
    thud_world_def def = thud_default_world_def();
    def.job_system = thud_job_system_of(threads);
    thud_world *world;
    if (thud_world_create(&def, &world) != THUD_OK)
        return 1;
    thud_body_options moving = {.kind = THUD_BODY_DYNAMIC};
    thud_body_make(world, thud_aabb_at(0, -1, 60, 1), NULL);
    for (int i = 0; i < 2000; i++)
        thud_body_make(world, thud_circle_at(i % 50 - 25, 0.5 + i / 50, 0.4), &moving);
    for (int i = 0; i < 60; i++)
        thud_world_step(world);
    printf("hash %016llx\n", (unsigned long long)thud_hash_of(world));
    thud_world_destroy(world);
    thud_threads_destroy(threads);
}
