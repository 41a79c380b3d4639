/* fuzz_geometry.c: a fuzz target for the functions of shapes, volumes and terrain lines that need
 * no world. They are among the calls of fuzz_calls.c too; here they run much faster. */
#include "operations.h"
#include "progress.h"
#include "target.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static fuzz_operation *const plays[] = {
        play_check,        play_pair,        play_pair_impact,   play_pair_collision,
        play_approach,     play_shape_ray,   play_minkowski,     play_bisectable,
        play_sincos,       play_volume_fit,  play_volume_points, play_volume_merge,
        play_volume_tests, play_line_sample, play_line_shape,    play_line_impact,
        play_line_ray,     play_foot,        play_angle_of,      play_approximate,
        play_capsule,      play_line_capsule};
    static const double units[] = {1, 1, 0.015625, 1000};
    static fuzz_session session;
    fuzz_session *s = &session;
    s->bytes = (fuzz_bytes){data, data + size, false};
    s->operation = "geometry";
    unsigned manner = next_byte(&s->bytes);
    s->unit = units[manner / 2 % 4];
    s->bytes.hostile = manner & 1;
    while (s->bytes.at < s->bytes.end) {
        plays[next_choice(&s->bytes, (int)(sizeof plays / sizeof *plays))](s);
    }
    progress_tell();
    return 0;
}
