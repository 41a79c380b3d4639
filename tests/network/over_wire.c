/* over_wire.c: see over_wire.h. */
#include "over_wire.h"

wire_options worst_wire(double delay, uint64_t seed) {
    return (wire_options){.delay = delay,
                          .jitter = 60,
                          .loss = 0.1,
                          .duplicates = 0.05,
                          .held = 0.1,
                          .held_for = 50,
                          .seed = seed};
}

bool open_player(peer *p, int me, int players, int depth, const thud_world_def *def) {
    peer_options options = {
        .me = me, .players = players, .depth = depth, .is_mesh = true, .def = def};
    return peer_open(p, &options);
}

thud_result press_at_random(peer *p, uint64_t seed) {
    return peer_press(p, cars_input(seed, p->me, thud_progress_of(p->rollback).steps));
}

bool send_over(peer *p, wire *w, double now) {
    for (int other = 0; other < p->players; other++) {
        unsigned char message[PEER_BYTES_MAX];
        if (peer_tells(p, other) &&
            !wire_send(w, p->me, other, now, message, peer_write(p, other, message))) {
            return false;
        }
    }
    return true;
}

thud_result receive_over(peer *p, wire *w, double now) {
    unsigned char bytes[WIRE_BYTES_MAX];
    int count, from;
    thud_result result = THUD_OK;
    while (result == THUD_OK && (count = wire_receive(w, p->me, now, bytes, &from)) >= 0) {
        result = peer_read(p, from, bytes, count);
    }
    return result;
}
