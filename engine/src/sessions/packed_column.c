/* packed_column.c: packs and reads a column; the format is in packed_column.h. Packing and reading
 * predict by the same functions, in integers alone, so that the bytes are the same everywhere. */
#include "sessions/packed_column.h"

#include "base/base.h"

#include <string.h>

/* First bytes of groups. */
enum { MASKED = 64, ZEROS = 128, ZEROS_MAX = 128 };

/* Groups that a guess is chosen by, spread over the column. Chosen: of gas, pit and pyramid all
 * groups give no shorter bytes that tell. */
enum { SAMPLE = 24 };

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

/* Where a column is being read or written: what the words after it are predicted by. */
typedef struct place {
    uint32_t last, before; /* the word before the present one, and the one before that */
    uint32_t base_last;    /* the base's word at the place of `last` */
} place;

static uint32_t load(const uint8_t *from, int width) {
    uint32_t word = 0;
    if (width == (int)sizeof word) {
        memcpy(&word, from, sizeof word);
    } else {
        word = *from;
    }
    return word;
}

static void store(uint8_t *to, int width, uint32_t word) {
    if (width == (int)sizeof word) {
        memcpy(to, &word, sizeof word);
    } else {
        *to = (uint8_t)word;
    }
}

/* The number of words. */
static size_t words_of(const td_packed_column *c) {
    return c->records * (size_t)c->lanes;
}

/* The offset of a word from the first one. */
static size_t offset_of(const td_packed_column *c, size_t word) {
    return c->lanes == 1
               ? word * c->stride
               : word / TD_PACKED_GROUP * c->stride + word % TD_PACKED_GROUP * sizeof(uint32_t);
}

/* Whether the base has the word. */
static bool is_in_base(const td_packed_column *c, size_t word) {
    return c->base && (c->lanes == 1 ? word : word / TD_PACKED_GROUP) < c->base_records;
}

/* The prediction of a word. *base gets the base's word, or the word before where there is none. */
static uint32_t guess_of(const td_packed_column *c, td_guess guess, size_t word, const place *p,
                         uint32_t *base) {
    bool known = is_in_base(c, word);
    *base = known ? load(c->base + offset_of(c, word), c->width) : p->last;
    switch (guess) {
    case TD_GUESS_LINE:
        return 2 * p->last - p->before;
    case TD_GUESS_STEP:
        return known ? *base + p->last - p->base_last : p->last;
    case TD_GUESS_KNOWN:
        return c->known(c->context, word);
    case TD_GUESS_PREVIOUS:
        return p->last;
    case TD_GUESS_SAME:
    case TD_GUESS_BASE:
    case TD_GUESS_COUNT:
        break;
    }
    return *base;
}

static void pass_word(place *p, uint32_t word, uint32_t base) {
    *p = (place){.last = word, .before = p->last, .base_last = base};
}

/* The difference of words of a width, as a number that is small where they are close. */
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
    int bits;     /* of the greatest */
    int nonzero;  /* how many are not 0 */
    unsigned set; /* a bit for each of these */
} group;

/* Bytes of numbers of so many bits. */
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

/* The numbers of the words from `first` on; *p passes over these words. */
static group take_group(const td_packed_column *c, td_guess guess, size_t first, place *p) {
    group g = {.bits = 0};
    size_t end = first + TD_PACKED_GROUP, count = words_of(c);
    uint32_t all = 0;
    for (size_t i = first; i < end && i < count; i++) {
        uint32_t base, predicted = guess_of(c, guess, i, p, &base);
        uint32_t word = load(c->words + offset_of(c, i), c->width);
        uint32_t number = to_zigzag(word - predicted, c->width);
        g.number[i - first] = number;
        g.nonzero += number != 0;
        g.set |= (number != 0 ? 1u : 0u) << (i - first);
        all |= number;
        pass_word(p, word, base);
    }
    while (all >> g.bits && g.bits < 32) {
        g.bits++;
    }
    return g;
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

/* Reads the numbers of a group that begins with the byte `head`, which is no run of zeros. */
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

/* Whether all words are those of the base. */
static bool is_same(const td_packed_column *c) {
    if (!c->base || c->base_records < c->records) {
        return false;
    }
    size_t bytes = (size_t)c->width * (size_t)c->lanes;
    for (size_t r = 0; r < c->records; r++) {
        if (memcmp(c->words + r * c->stride, c->base + r * c->stride, bytes) != 0) {
            return false;
        }
    }
    return true;
}

/* Bytes that a sample of the groups takes by a guess. */
static size_t sample_cost(const td_packed_column *c, td_guess guess) {
    size_t groups = (words_of(c) + TD_PACKED_GROUP - 1) / TD_PACKED_GROUP, cost = 0;
    size_t every = groups / SAMPLE + 1;
    for (size_t k = 0; k < groups; k += every) {
        size_t first = k * TD_PACKED_GROUP;
        place p = {0, 0, 0};
        for (size_t i = first < 2 ? 0 : first - 2; i < first; i++) { /* the two words before */
            uint32_t base;
            guess_of(c, TD_GUESS_BASE, i, &p, &base);
            pass_word(&p, load(c->words + offset_of(c, i), c->width), base);
        }
        group g = take_group(c, guess, first, &p);
        cost += g.bits ? cost_of(&g) : 0;
    }
    return cost;
}

static td_guess choose(const td_packed_column *c) {
    td_guess best = TD_GUESS_PREVIOUS;
    size_t least = SIZE_MAX;
    for (int guess = TD_GUESS_BASE; guess < TD_GUESS_COUNT; guess++) {
        bool possible = guess == TD_GUESS_KNOWN
                            ? c->known != NULL
                            : c->base || (guess != TD_GUESS_BASE && guess != TD_GUESS_STEP);
        size_t cost = possible ? sample_cost(c, (td_guess)guess) : SIZE_MAX;
        if (cost < least) {
            least = cost;
            best = (td_guess)guess;
        }
    }
    return best;
}

void td_packed_write(td_packed_stream *t, const td_packed_column *c) {
    td_guess guess = is_same(c) ? TD_GUESS_SAME : choose(c);
    td_packed_put(t, (uint8_t)guess);
    if (guess == TD_GUESS_SAME) {
        return;
    }
    place p = {0, 0, 0};
    size_t zeros = 0;
    for (size_t i = 0; i < words_of(c); i += TD_PACKED_GROUP) {
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

void td_packed_read(td_packed_stream *t, const td_packed_column *c) {
    td_guess guess = (td_guess)td_packed_take(t);
    bool based = guess == TD_GUESS_SAME || guess == TD_GUESS_BASE || guess == TD_GUESS_STEP;
    if (guess >= TD_GUESS_COUNT || (based && !c->base) || (guess == TD_GUESS_KNOWN && !c->known)) {
        t->broken = true;
        return;
    }
    place p = {0, 0, 0};
    size_t zeros = guess == TD_GUESS_SAME ? SIZE_MAX : 0;
    for (size_t i = 0; i < words_of(c) && !t->broken; i += TD_PACKED_GROUP) {
        uint32_t number[TD_PACKED_GROUP] = {0};
        if (zeros == 0) {
            int head = td_packed_take(t);
            zeros = head >= ZEROS ? (size_t)(head - ZEROS + 1) : 0;
            if (zeros == 0) {
                read_numbers(t, head, number);
            }
        }
        zeros -= zeros > 0;
        for (size_t k = i; k < i + TD_PACKED_GROUP && k < words_of(c); k++) {
            uint32_t base, word = guess_of(c, guess, k, &p, &base) + from_zigzag(number[k - i]);
            store(c->words + offset_of(c, k), c->width, word);
            pass_word(&p, c->width == 1 ? (uint8_t)word : word, base);
        }
    }
}
