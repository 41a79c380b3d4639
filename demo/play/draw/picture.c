/* picture.c: see picture.h. A PNG encoder (W3C specification, second edition) for true colour
 * without alpha. Each byte is stored as its difference to the same channel of the pixel at its left
 * (filter Sub), which turns uniform colours into zeros. These are compressed by deflate (RFC 1951)
 * with its fixed codes; the only matches are runs of one byte. */
#include "draw/picture.h"

#include <stdlib.h>
#include <string.h>

/* Length of a match in deflate (RFC 1951, 3.2.5). */
enum { MATCH_MIN = 3, MATCH_MAX = 258 };

typedef struct stream {
    Uint8 *bytes;
    size_t count, capacity;
    Uint32 bits; /* pending bits of an incomplete byte, the first in the lowest bit */
    int bit_count;
    bool failed;
} stream;

static void put_byte(stream *s, unsigned byte) {
    if (s->count == s->capacity) {
        size_t capacity = s->capacity ? 2 * s->capacity : 1 << 16;
        Uint8 *bytes = realloc(s->bytes, capacity);
        if (!bytes) {
            s->failed = true;
            return;
        }
        s->bytes = bytes;
        s->capacity = capacity;
    }
    s->bytes[s->count++] = (Uint8)byte;
}

static void put_u32(stream *s, Uint32 value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        put_byte(s, value >> shift & 0xFF);
}

/* Writes `count` bits, the lowest first. */
static void put_bits(stream *s, Uint32 bits, int count) {
    s->bits |= bits << s->bit_count;
    s->bit_count += count;
    while (s->bit_count >= 8) {
        put_byte(s, s->bits & 0xFF);
        s->bits >>= 8;
        s->bit_count -= 8;
    }
}

/* Writes a Huffman code, which begins with its highest bit. */
static void put_code(stream *s, Uint32 code, int length) {
    for (int i = length - 1; i >= 0; i--)
        put_bits(s, code >> i & 1, 1);
}

/* The fixed code of a literal or length symbol (RFC 1951, 3.2.6). */
static void put_symbol(stream *s, unsigned symbol) {
    if (symbol < 144)
        put_code(s, 0x30 + symbol, 8);
    else if (symbol < 256)
        put_code(s, 0x190 + symbol - 144, 9);
    else if (symbol < 280)
        put_code(s, symbol - 256, 7);
    else
        put_code(s, 0xC0 + symbol - 280, 8);
}

/* Symbol and extra bits of a match's length (RFC 1951, 3.2.5). */
static void put_length(stream *s, unsigned length) {
    if (length == MATCH_MAX) {
        put_symbol(s, 285);
        return;
    }
    unsigned rest = length - MATCH_MIN, extra = 0;
    while (rest >> extra >= 8)
        extra++;
    put_symbol(s, 257 + 4 * extra + (rest >> extra));
    put_bits(s, rest & ((1u << extra) - 1), (int)extra);
}

/* The number of bytes from `at` on that are equal to the byte before it, at most MATCH_MAX. */
static unsigned run_length(const Uint8 *data, size_t at, size_t count) {
    unsigned length = 0;
    while (at > 0 && length < MATCH_MAX && at + length < count && data[at + length] == data[at - 1])
        length++;
    return length;
}

/* A zlib stream (RFC 1950) of one block. */
static void put_deflated(stream *s, const Uint8 *data, size_t count) {
    Uint32 low = 1, high = 0; /* the two sums of the Adler-32 checksum */
    for (size_t i = 0; i < count; i++) {
        low = (low + data[i]) % 65521;
        high = (high + low) % 65521;
    }
    put_byte(s, 0x78);
    put_byte(s, 0x01);
    put_bits(s, 1, 1); /* this is the last block */
    put_bits(s, 1, 2); /* fixed codes */
    for (size_t i = 0; i < count;) {
        unsigned length = run_length(data, i, count);
        if (length >= MATCH_MIN) {
            put_length(s, length);
            put_code(s, 0, 5); /* code of the distance 1 */
            i += length;
        } else {
            put_symbol(s, data[i++]);
        }
    }
    put_symbol(s, 256);
    put_bits(s, 0, 7); /* completes the last byte */
    s->bits = 0;
    s->bit_count = 0;
    put_u32(s, high << 16 | low);
}

static Uint32 crc32_of(const Uint8 *bytes, size_t count) {
    Uint32 crc = 0xFFFFFFFF;
    for (size_t i = 0; i < count; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            crc = crc >> 1 ^ (0xEDB88320 & (0 - (crc & 1)));
    }
    return ~crc;
}

/* A chunk begins with its length and type and ends with the checksum of type and data. */
static size_t begin_chunk(stream *s, const char *type) {
    size_t start = s->count;
    put_u32(s, 0);
    for (int i = 0; i < 4; i++)
        put_byte(s, (Uint8)type[i]);
    return start;
}

static void end_chunk(stream *s, size_t start) {
    if (s->failed)
        return;
    Uint32 length = (Uint32)(s->count - start - 8);
    for (int i = 0; i < 4; i++)
        s->bytes[start + (size_t)i] = (Uint8)(length >> (24 - 8 * i));
    put_u32(s, crc32_of(s->bytes + start + 4, length + 4));
}

/* Writes the image. `lines` has for each row a filter byte and the filtered pixels, `line` bytes in
 * all. */
static void put_png(stream *s, const Uint8 *lines, int width, int height, size_t line) {
    static const Uint8 signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    /* Bit depth, colour type, and the only values of three methods. */
    static const Uint8 true_colour[] = {8, 2, 0, 0, 0};
    for (size_t i = 0; i < sizeof signature; i++)
        put_byte(s, signature[i]);
    size_t chunk = begin_chunk(s, "IHDR");
    put_u32(s, (Uint32)width);
    put_u32(s, (Uint32)height);
    for (size_t i = 0; i < sizeof true_colour; i++)
        put_byte(s, true_colour[i]);
    end_chunk(s, chunk);
    chunk = begin_chunk(s, "IDAT");
    put_deflated(s, lines, line * (size_t)height);
    end_chunk(s, chunk);
    end_chunk(s, begin_chunk(s, "IEND"));
}

/* `rgb` is a surface of the format RGB24. */
static bool save_png(const SDL_Surface *rgb, const char *path) {
    enum { PIXEL = 3, FILTER_SUB = 1 };
    size_t line = PIXEL * (size_t)rgb->w + 1;
    Uint8 *lines = malloc((size_t)rgb->h * line);
    stream s = {.failed = !lines};
    for (int row = 0; lines && row < rgb->h; row++) {
        const Uint8 *from = (const Uint8 *)rgb->pixels + (size_t)row * (size_t)rgb->pitch;
        Uint8 *to = lines + (size_t)row * line;
        *to++ = FILTER_SUB;
        for (size_t i = 0; i + 1 < line; i++)
            to[i] = (Uint8)(from[i] - (i >= PIXEL ? from[i - PIXEL] : 0));
    }
    if (lines)
        put_png(&s, lines, rgb->w, rgb->h, line);
    free(lines);
    if (s.failed)
        SDL_SetError("out of memory");
    SDL_RWops *file = s.failed ? NULL : SDL_RWFromFile(path, "wb");
    bool saved = file && SDL_RWwrite(file, s.bytes, 1, s.count) == s.count;
    if (file && SDL_RWclose(file) != 0)
        saved = false;
    free(s.bytes);
    return saved;
}

static bool has_suffix(const char *path, const char *suffix) {
    size_t length = strlen(path), tail = strlen(suffix);
    return length > tail && SDL_strcasecmp(path + length - tail, suffix) == 0;
}

bool picture_has_format(const char *path) {
    return has_suffix(path, ".png") || has_suffix(path, ".bmp");
}

bool picture_save(SDL_Surface *surface, const char *path) {
    SDL_Surface *rgb = SDL_ConvertSurfaceFormat(surface, SDL_PIXELFORMAT_RGB24, 0);
    if (!rgb)
        return false;
    bool saved = has_suffix(path, ".png") ? save_png(rgb, path) : SDL_SaveBMP(rgb, path) == 0;
    SDL_FreeSurface(rgb);
    return saved;
}
