/* wire.c: see wire.h. Datagrams on their way stand in a list without an order; what is delivered is
 * the earliest that has arrived, of those that arrived at once the one that was sent first. */
#include "wire.h"

#include "random.h"

#include <stdlib.h>
#include <string.h>

typedef struct datagram {
    double due;     /* ms, when it arrives */
    int64_t serial; /* number of datagrams sent before it */
    int from, to, count;
    unsigned char *bytes;
} datagram;

/* The highest serial number delivered from one player to another. */
typedef struct newest {
    int from, to;
    int64_t serial;
} newest;

struct wire {
    wire_options options;
    wire_counts counts;
    uint64_t random;
    datagram *under_way;
    int under_way_count, under_way_room;
    newest *newest;
    int newest_count, newest_room;
};

wire *wire_create(const wire_options *options) {
    wire *w = calloc(1, sizeof *w);
    if (w) {
        w->options = *options;
        w->random = options->seed;
    }
    return w;
}

void wire_destroy(wire *w) {
    for (int i = 0; w && i < w->under_way_count; i++) {
        free(w->under_way[i].bytes);
    }
    free(w ? w->under_way : NULL);
    free(w ? w->newest : NULL);
    free(w);
}

wire_counts wire_counts_of(const wire *w) {
    return w->counts;
}

/* Twice the room, for elements of `size` bytes, where `count` fill it. */
static void *grown(void *list, int count, int *room, size_t size) {
    if (count < *room) {
        return list;
    }
    int wanted = *room ? 2 * *room : 16;
    void *larger = realloc(list, (size_t)wanted * size);
    if (larger) {
        *room = wanted;
    }
    return larger;
}

static bool put(wire *w, int from, int to, double now, const void *bytes, int count) {
    const wire_options *o = &w->options;
    double due = now + o->delay + o->jitter * random_chance(&w->random);
    if (random_chance(&w->random) < o->held) {
        due += o->held_for;
        w->counts.held++;
    }
    datagram *list = grown(w->under_way, w->under_way_count, &w->under_way_room, sizeof *list);
    unsigned char *copy = malloc(count ? (size_t)count : 1);
    w->under_way = list ? list : w->under_way;
    if (!list || !copy) {
        free(copy);
        return false;
    }
    memcpy(copy, bytes, (size_t)count);
    list[w->under_way_count++] = (datagram){due, w->counts.sent, from, to, count, copy};
    return true;
}

bool wire_send(wire *w, int from, int to, double now, const void *bytes, int count) {
    bool is_done = true;
    if (random_chance(&w->random) < w->options.loss) {
        w->counts.lost++;
    } else {
        is_done = put(w, from, to, now, bytes, count);
        if (random_chance(&w->random) < w->options.duplicates) {
            is_done &= put(w, from, to, now, bytes, count);
            w->counts.duplicated++;
        }
    }
    w->counts.sent++;
    return is_done;
}

/* Notes whether a later datagram of the same players was delivered before this one. */
static void note_order(wire *w, const datagram *d) {
    w->counts.delivered++;
    for (int i = 0; i < w->newest_count; i++) {
        newest *n = &w->newest[i];
        if (n->from == d->from && n->to == d->to) {
            w->counts.overtaken += d->serial < n->serial;
            n->serial = d->serial > n->serial ? d->serial : n->serial;
            return;
        }
    }
    newest *list = grown(w->newest, w->newest_count, &w->newest_room, sizeof *list);
    if (list) {
        w->newest = list;
        list[w->newest_count++] = (newest){d->from, d->to, d->serial};
    }
}

int wire_receive(wire *w, int to, double now, void *out, int *out_from) {
    int found = -1;
    for (int i = 0; i < w->under_way_count; i++) {
        const datagram *d = &w->under_way[i], *best = found < 0 ? NULL : &w->under_way[found];
        if (d->to == to && d->due <= now &&
            (!best || d->due < best->due || (d->due == best->due && d->serial < best->serial))) {
            found = i;
        }
    }
    if (found < 0) {
        return -1;
    }
    datagram d = w->under_way[found];
    w->under_way[found] = w->under_way[--w->under_way_count];
    note_order(w, &d);
    memcpy(out, d.bytes, (size_t)d.count);
    free(d.bytes);
    if (out_from) {
        *out_from = d.from;
    }
    return d.count;
}

void wire_cut(wire *w, int player) {
    int kept = 0;
    for (int i = 0; i < w->under_way_count; i++) {
        datagram d = w->under_way[i];
        if (d.from == player || d.to == player) {
            free(d.bytes);
        } else {
            w->under_way[kept++] = d;
        }
    }
    w->under_way_count = kept;
}
