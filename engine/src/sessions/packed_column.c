/* packed_column.c: packs and reads a column; the format is in packed_column.h. Packing and reading
 * predict by the same functions, so that reading gives back the packed words. The guesses of this
 * file use integers alone; td_packed_known also uses floats. */
#include "sessions/packed_column.h"

#include "base/base.h"

#include <string.h>

/* First bytes of groups: MASKED plus bits; ZEROS - 1 plus the number of groups of zeros, at most
 * ZEROS_MAX. */
enum { MASKED = 64, ZEROS = 128, ZEROS_MAX = 128 };

/* The guess of a column is the one with which this many of its groups, spread over the column, take
 * the fewest bytes. The number is chosen; not tuned. */
enum { SAMPLE = 6 };

void td_packed_put(td_packed_stream *t, uint8_t byte) {
    if (t->to) {
        t->to[t->at] = byte;
    }
    t->at++;
}

uint8_t td_packed_take(td_packed_stream *t) {
    if (t->at >= t->end) {
        t->broken = true;
        return 0;
    }
    return t->from[t->at++];
}

/* ---- words ---- */

/* A group's words, and those of the base. */
typedef struct words {
    int count; /* TD_PACKED_GROUP, or less in the last group */
    uint32_t word[TD_PACKED_GROUP];
    uint32_t base[TD_PACKED_GROUP];
    int in_base; /* words that the base has, the first ones */
} words;

/* The words before the present one, from which it is predicted. */
typedef struct place {
    uint32_t last, before; /* the word before the present one, and the one before that */
    uint32_t base_last;    /* the base's word at the place of `last` */
} place;

/* The numbers of the first word, and of the one after the last. */
static size_t first_word(const td_packed_column *c) {
    return c->first * (size_t)c->lanes;
}

static size_t end_word(const td_packed_column *c) {
    return c->end * (size_t)c->lanes;
}

/* Loads `count` words of the column at `from`, from word `first` on, which is the first of a group.
 */
static void load(const td_packed_column *c, const uint8_t *from, size_t first, int count,
                 uint32_t out[TD_PACKED_GROUP]) {
    size_t stride = c->stride;
    if (c->lanes == TD_PACKED_GROUP) {
        memcpy(out, from + first / TD_PACKED_GROUP * stride, TD_PACKED_GROUP * sizeof *out);
        return;
    }
    from += first * stride;
    if (c->width == 1) {
        for (int i = 0; i < count; i++, from += stride) {
            out[i] = *from;
        }
    } else {
        for (int i = 0; i < count; i++, from += stride) {
            memcpy(&out[i], from, sizeof *out);
        }
    }
}

static void store(const td_packed_column *c, size_t first, const words *w) {
    size_t stride = c->stride;
    if (c->lanes == TD_PACKED_GROUP) {
        memcpy(c->words + first / TD_PACKED_GROUP * stride, w->word, sizeof w->word);
        return;
    }
    uint8_t *to = c->words + first * stride;
    if (c->width == 1) {
        for (int i = 0; i < w->count; i++, to += stride) {
            *to = (uint8_t)w->word[i];
        }
    } else {
        for (int i = 0; i < w->count; i++, to += stride) {
            memcpy(to, &w->word[i], sizeof w->word[i]);
        }
    }
}

/* The group from word `first` on, with the base's words; `word` is not set. */
static words base_words(const td_packed_column *c, size_t first) {
    size_t left = end_word(c) - first;
    words w;
    w.count = left < TD_PACKED_GROUP ? (int)left : TD_PACKED_GROUP;
    w.in_base = 0;
    size_t in_base = c->base ? c->base_records * (size_t)c->lanes : 0;
    if (first < in_base) {
        w.in_base = in_base - first < (size_t)w.count ? (int)(in_base - first) : w.count;
        load(c, c->base, first, w.in_base, w.base);
    }
    return w;
}

/* The prediction of word i of a group, by words before it and the base. */
static uint32_t guess_of(td_guess guess, const words *w, int i, const place *p) {
    switch (guess) {
    case TD_GUESS_LINE:
        return 2 * p->last - p->before;
    case TD_GUESS_STEP:
        return i < w->in_base ? w->base[i] + p->last - p->base_last : p->last;
    case TD_GUESS_BASE:
    case TD_GUESS_SAME:
        return i < w->in_base ? w->base[i] : p->last;
    case TD_GUESS_PREVIOUS:
    case TD_GUESS_KNOWN:
    case TD_GUESS_COUNT:
        break;
    }
    return p->last;
}

/* Makes the word after word i of the group the present one. */
static void pass_word(place *p, const words *w, int i) {
    uint32_t base = i < w->in_base ? w->base[i] : p->last;
    *p = (place){.last = w->word[i], .before = p->last, .base_last = base};
}

/* The zigzag code of a difference of two words of `width` bytes: 0, -1, 1, -2 ... become 0, 1, 2, 3
 * ... */
static uint32_t to_zigzag(uint32_t difference, int width) {
    int shift = 32 - 8 * width;
    int32_t signed_difference = (int32_t)(difference << shift) >> shift;
    return (uint32_t)signed_difference << 1 ^ (uint32_t)(signed_difference >> 31);
}

static uint32_t from_zigzag(uint32_t number) {
    return number >> 1 ^ (0u - (number & 1));
}

/* ---- groups ---- */

/* A group's numbers, and how they are written. */
typedef struct group {
    uint32_t number[TD_PACKED_GROUP];
    int bits;     /* bits of the greatest number */
    int nonzero;  /* how many are not 0 */
    unsigned set; /* a bit for each number that is not 0 */
} group;

/* Bytes that `count` numbers of so many bits each take. */
static int bytes_of(int count, int bits) {
    return (count * bits + 7) / 8;
}

/* Whether the numbers that are 0 are left out. */
static bool is_masked(const group *g) {
    return 1 + bytes_of(g->nonzero, g->bits) < g->bits;
}

/* Bytes of the group in the stream, where it is not all zeros. */
static size_t cost_of(const group *g) {
    return 1 + (size_t)(is_masked(g) ? 1 + bytes_of(g->nonzero, g->bits) : g->bits);
}

/* Sets numbers from differences of words. */
static group group_of(const uint32_t difference[TD_PACKED_GROUP], int count, int width) {
    group g = {.bits = 0};
    uint32_t all = 0;
    for (int i = 0; i < count; i++) {
        all |= difference[i];
    }
    if (all == 0) {
        return g;
    }
    all = 0;
    for (int i = 0; i < count; i++) {
        uint32_t number = to_zigzag(difference[i], width);
        g.number[i] = number;
        g.nonzero += number != 0;
        g.set |= (number != 0 ? 1u : 0u) << i;
        all |= number;
    }
    g.bits = all ? 32 - __builtin_clz(all) : 0;
    return g;
}

/* The numbers by which the group from word `first` on is written; moves *p past its words. */
static group take_group(const td_packed_column *c, td_guess guess, size_t first, place *p) {
    words w = base_words(c, first);
    load(c, c->words, first, w.count, w.word);
    uint32_t difference[TD_PACKED_GROUP];
    if (guess == TD_GUESS_KNOWN) {
        c->known(c->context, first, w.count, difference);
        for (int i = 0; i < w.count; i++) {
            difference[i] = w.word[i] - difference[i];
        }
    } else if (guess == TD_GUESS_BASE && w.in_base == w.count) {
        for (int i = 0; i < w.count; i++) {
            difference[i] = w.word[i] - w.base[i];
        }
        p->last = w.word[w.count - 1];
    } else if (guess == TD_GUESS_PREVIOUS) {
        difference[0] = w.word[0] - p->last;
        for (int i = 1; i < w.count; i++) {
            difference[i] = w.word[i] - w.word[i - 1];
        }
        p->last = w.word[w.count - 1];
    } else {
        for (int i = 0; i < w.count; i++) {
            difference[i] = w.word[i] - guess_of(guess, &w, i, p);
            pass_word(p, &w, i);
        }
    }
    return group_of(difference, w.count, c->width);
}

static void put_numbers(td_packed_stream *t, const group *g, bool masked) {
    uint64_t pending = 0;
    int bits = 0;
    for (int i = 0; i < TD_PACKED_GROUP; i++) {
        if (masked && !(g->set >> i & 1)) {
            continue;
        }
        pending |= (uint64_t)g->number[i] << bits;
        for (bits += g->bits; bits >= 8; bits -= 8) {
            td_packed_put(t, (uint8_t)pending);
            pending >>= 8;
        }
    }
    if (bits > 0) {
        td_packed_put(t, (uint8_t)pending);
    }
}

static void put_group(td_packed_stream *t, const group *g) {
    bool masked = is_masked(g);
    td_packed_put(t, (uint8_t)(g->bits + (masked ? MASKED : 0)));
    if (masked) {
        td_packed_put(t, (uint8_t)g->set);
    }
    put_numbers(t, g, masked);
}

static void put_zeros(td_packed_stream *t, size_t groups) {
    for (; groups > 0; groups -= groups < ZEROS_MAX ? groups : ZEROS_MAX) {
        size_t some = groups < ZEROS_MAX ? groups : ZEROS_MAX;
        td_packed_put(t, (uint8_t)(ZEROS - 1 + some));
    }
}

/* Reads the numbers of a group whose first byte is `head`, and which is not a run of groups of
 * zeros. */
static void read_numbers(td_packed_stream *t, int head, uint32_t number[TD_PACKED_GROUP]) {
    bool masked = head >= MASKED;
    int width = head - (masked ? MASKED : 0), bits = 0;
    unsigned set = masked ? td_packed_take(t) : 255;
    uint64_t pending = 0;
    t->broken = t->broken || width < 1 || width > 32;
    for (int i = 0; i < TD_PACKED_GROUP && !t->broken; i++) {
        number[i] = 0;
        if (set >> i & 1) {
            for (; bits < width; bits += 8) {
                pending |= (uint64_t)td_packed_take(t) << bits;
            }
            number[i] = (uint32_t)(pending & ((UINT64_C(1) << width) - 1));
            pending >>= width;
            bits -= width;
        }
    }
}

/* ---- columns ---- */

/* The words before word `first`, which begins a group. */
static place before(const td_packed_column *c, size_t first) {
    place p = {0, 0, 0};
    if (first > 0) {
        words w = base_words(c, first - TD_PACKED_GROUP);
        load(c, c->words, first - TD_PACKED_GROUP, w.count, w.word);
        pass_word(&p, &w, TD_PACKED_GROUP - 2);
        pass_word(&p, &w, TD_PACKED_GROUP - 1);
    }
    return p;
}

/* Bytes that a sample of the groups takes by a guess. */
static size_t sample_cost(const td_packed_column *c, td_guess guess) {
    size_t groups = (end_word(c) - first_word(c) + TD_PACKED_GROUP - 1) / TD_PACKED_GROUP, cost = 0;
    size_t every = groups / SAMPLE + 1;
    for (size_t k = 0; k < groups; k += every) {
        size_t first = first_word(c) + k * TD_PACKED_GROUP;
        place p = before(c, first);
        group g = take_group(c, guess, first, &p);
        cost += g.bits ? cost_of(&g) : 0;
    }
    return cost;
}

/* The guess by which a sample takes the fewest bytes. */
static td_guess choose(const td_packed_column *c) {
    static const td_guess guesses[] = {TD_GUESS_KNOWN, TD_GUESS_BASE, TD_GUESS_PREVIOUS,
                                       TD_GUESS_STEP, TD_GUESS_LINE};
    td_guess best = TD_GUESS_PREVIOUS;
    size_t cost_min = SIZE_MAX;
    for (size_t i = 0; i < sizeof guesses / sizeof *guesses && cost_min > 0; i++) {
        td_guess guess = guesses[i];
        bool based = guess == TD_GUESS_BASE || guess == TD_GUESS_STEP;
        bool possible = guess == TD_GUESS_KNOWN ? c->known != NULL : c->base || !based;
        size_t cost = possible ? sample_cost(c, guess) : SIZE_MAX;
        if (cost < cost_min) {
            cost_min = cost;
            best = guess;
        }
    }
    return best;
}

void td_packed_write(td_packed_stream *t, const td_packed_column *c) {
    td_guess guess = c->same ? TD_GUESS_SAME : choose(c);
    td_packed_put(t, (uint8_t)guess);
    if (guess == TD_GUESS_SAME) {
        return;
    }
    place p = before(c, first_word(c));
    size_t zeros = 0;
    for (size_t i = first_word(c); i < end_word(c); i += TD_PACKED_GROUP) {
        group g = take_group(c, guess, i, &p);
        if (g.bits == 0) {
            zeros++;
        } else {
            put_zeros(t, zeros);
            zeros = 0;
            put_group(t, &g);
        }
    }
    put_zeros(t, zeros);
}

/* Computes the words of a group from the numbers that were read, and stores them. */
static void restore_group(const td_packed_column *c, td_guess guess, size_t first,
                          const uint32_t number[TD_PACKED_GROUP], place *p) {
    words w = base_words(c, first);
    uint32_t mask = c->width == 1 ? UINT8_MAX : UINT32_MAX;
    if (guess == TD_GUESS_KNOWN || (guess == TD_GUESS_BASE && w.in_base == w.count)) {
        if (guess == TD_GUESS_KNOWN) {
            c->known(c->context, first, w.count, w.base);
        }
        for (int i = 0; i < w.count; i++) {
            w.word[i] = (w.base[i] + from_zigzag(number[i])) & mask;
        }
        p->last = w.word[w.count - 1];
    } else {
        for (int i = 0; i < w.count; i++) {
            w.word[i] = (guess_of(guess, &w, i, p) + from_zigzag(number[i])) & mask;
            pass_word(p, &w, i);
        }
    }
    store(c, first, &w);
}

void td_packed_read(td_packed_stream *t, const td_packed_column *c) {
    td_guess guess = (td_guess)td_packed_take(t);
    if (guess == TD_GUESS_SAME) {
        t->broken = t->broken || !c->copied;
        return;
    }
    bool based = guess == TD_GUESS_BASE || guess == TD_GUESS_STEP;
    if (guess >= TD_GUESS_COUNT || (based && !c->base) || (guess == TD_GUESS_KNOWN && !c->known)) {
        t->broken = true;
        return;
    }
    place p = before(c, first_word(c));
    size_t zeros = 0;
    for (size_t i = first_word(c); i < end_word(c) && !t->broken; i += TD_PACKED_GROUP) {
        uint32_t number[TD_PACKED_GROUP] = {0};
        if (zeros == 0) {
            int head = td_packed_take(t);
            zeros = head >= ZEROS ? (size_t)(head - ZEROS + 1) : 0;
            if (zeros == 0) {
                read_numbers(t, head, number);
            }
        }
        bool stays = zeros > 0 && guess == TD_GUESS_BASE && c->copied;
        zeros -= zeros > 0;
        if (!stays) {
            restore_group(c, guess, i, number, &p);
        }
    }
}
