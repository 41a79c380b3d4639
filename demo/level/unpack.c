/* unpack.c: decodes the cells of a layer from base64, and decompresses zlib, gzip and Zstandard. */
#include "reader.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>
#include <zstd.h>

/* The six bits that a base64 letter stands for; -1 if it is none. */
static int sextet(char c) {
    return c >= 'A' && c <= 'Z'   ? c - 'A'
           : c >= 'a' && c <= 'z' ? c - 'a' + 26
           : c >= '0' && c <= '9' ? c - '0' + 52
           : c == '+'             ? 62
           : c == '/'             ? 63
                                  : -1;
}

/* Decodes base64, which may contain white space anywhere and lack its padding, into memory from
 * malloc. Null if the text is no base64, or if memory runs out. */
static uint8_t *decode(const char *text, size_t *length) {
    uint8_t *bytes = malloc(strlen(text) / 4 * 3 + 4);
    uint32_t bits = 0;
    int letters = 0;
    size_t used = 0;
    const char *p = text;
    for (; bytes && *p && *p != '='; p++) {
        if (strchr(" \t\r\n", *p))
            continue;
        int value = sextet(*p);
        if (value < 0)
            break;
        bits = bits << 6 | (uint32_t)value;
        if (++letters % 4 == 0) {
            bytes[used++] = (uint8_t)(bits >> 16);
            bytes[used++] = (uint8_t)(bits >> 8);
            bytes[used++] = (uint8_t)bits;
        }
    }
    int padding = 0;
    for (; *p && strchr("= \t\r\n", *p); p++)
        padding += *p == '=';
    bool padded = padding == 0 || (padding <= 2 && (letters + padding) % 4 == 0);
    if (!bytes || *p || letters % 4 == 1 || !padded) {
        free(bytes);
        return NULL;
    }
    if (letters % 4 == 2) {
        bytes[used++] = (uint8_t)(bits >> 4);
    } else if (letters % 4 == 3) {
        bytes[used++] = (uint8_t)(bits >> 10);
        bytes[used++] = (uint8_t)(bits >> 2);
    }
    *length = used;
    return bytes;
}

/* False if the sizes differ. */
static bool copy(const uint8_t *bytes, size_t length, uint8_t *out, size_t size) {
    if (length != size)
        return false;
    memcpy(out, bytes, size);
    return true;
}

/* Decompresses zlib or gzip to exactly `size` bytes. `window` is inflateInit2's windowBits, which
 * chooses the format. False if the data is invalid or has another size. */
static bool inflate_all(const uint8_t *bytes, size_t length, int window, uint8_t *out,
                        size_t size) {
    if (length > UINT_MAX || size > UINT_MAX)
        return false;
    z_stream stream = {.next_in = (Bytef *)(uintptr_t)bytes,
                       .avail_in = (uInt)length,
                       .next_out = out,
                       .avail_out = (uInt)size};
    if (inflateInit2(&stream, window) != Z_OK)
        return false;
    int result = inflate(&stream, Z_FINISH);
    bool whole = result == Z_STREAM_END && stream.avail_in == 0 && stream.avail_out == 0;
    inflateEnd(&stream);
    return whole;
}

static bool unpack_zstd(const uint8_t *bytes, size_t length, uint8_t *out, size_t size) {
    size_t got = ZSTD_decompress(out, size, bytes, length);
    return !ZSTD_isError(got) && got == size;
}

const char *level_unpack(const char *text, const char *compression, uint8_t *out, size_t size) {
    size_t length = 0;
    uint8_t *bytes = decode(text, &length);
    if (!bytes)
        return "are not in base64";
    bool known = true, whole = false;
    if (strcmp(compression, "") == 0)
        whole = copy(bytes, length, out, size);
    else if (strcmp(compression, "zlib") == 0)
        whole = inflate_all(bytes, length, 15, out, size);
    else if (strcmp(compression, "gzip") == 0)
        whole = inflate_all(bytes, length, 15 + 16, out, size);
    else if (strcmp(compression, "zstd") == 0)
        whole = unpack_zstd(bytes, length, out, size);
    else
        known = false;
    free(bytes);
    return !known  ? "are packed in a way that is not known"
           : whole ? NULL
                   : "do not unpack to as many as it has columns and rows";
}
