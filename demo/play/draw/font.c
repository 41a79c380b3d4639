/* font.c: the font, drawn for this project. A glyph is a list of strokes separated by spaces. A
 * stroke is a polyline; each point is a digit for x and a hexadecimal digit for y. y = 3 is the
 * baseline, 9 the height of small letters, b that of capitals. A point that is given twice is a
 * dot. */
#include "draw/font.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const GLYPHS[FONT_GLYPHS] = {
    /* space */ "",
    /* ! */ "0b06 0303",
    /* " */ "0b09 2b29",
    /* # */ "131b 434b 0555 0959",
    /* $ */ "4a3b1b0a0817374644331304 2c22",
    /* % */ "035b 0a1b2a190a 3445544334",
    /* & */ "53090a1b2b3a390604133356",
    /* ' */ "0b09",
    /* ( */ "2c1a08051322",
    /* ) */ "0c1a28251302",
    /* * */ "2a26 0947 0749",
    /* + */ "2945 0747 2925",
    /* , */ "1301",
    /* - */ "0737",
    /* . */ "0303",
    /* / */ "024c",
    /* 0 */ "1b3b4a443313040a1b",
    /* 1 */ "092b23 0343",
    /* 2 */ "0a1b3b4a480343",
    /* 3 */ "0a1b3b4a483717 374644331304",
    /* 4 */ "333b060545",
    /* 5 */ "4b0b08384744331304",
    /* 6 */ "4a3b1b0a04133344463707",
    /* 7 */ "0b4b4a13",
    /* 8 */ "17080a1b3b4a48371706041333444637",
    /* 9 */ "041333444a3b1b0a081747",
    /* : */ "0404 0808",
    /* ; */ "1301 1818",
    /* < */ "3a0734",
    /* = */ "0949 0545",
    /* > */ "0a3704",
    /* ? */ "0a1b3b4a492726 2323",
    /* @ */ "463526283948465566694b2b09052353",
    /* A */ "033b63 1656",
    /* B */ "030b3b4a483707 3746443303",
    /* C */ "5a4b1b0a04134354",
    /* D */ "030b3b59553303",
    /* E */ "4b0b0343 0737",
    /* F */ "4b0b03 0737",
    /* G */ "5a4b1b0a041343545737",
    /* H */ "030b 535b 0757",
    /* I */ "0b03",
    /* J */ "3b34231304",
    /* K */ "0b03 5b06 2853",
    /* L */ "0b0343",
    /* M */ "030b376b63",
    /* N */ "030b535b",
    /* O */ "1b4b5a544313040a1b",
    /* P */ "030b4b5a584707",
    /* Q */ "1b4b5a544313040a1b 3552",
    /* R */ "030b4b5a584707 2753",
    /* S */ "5a4b1b0a0817475654431304",
    /* T */ "0b6b 3b33",
    /* U */ "0b041343545b",
    /* V */ "0b336b",
    /* W */ "0b2349638b",
    /* X */ "0b53 5b03",
    /* Y */ "0b376b 3733",
    /* Z */ "0b5b0353",
    /* [ */ "2c0c0222",
    /* \ */ "0c42",
    /* ] */ "0c2c2202",
    /* ^ */ "092b49",
    /* _ */ "0252",
    /* ` */ "0b19",
    /* a */ "0819394843 46160504133344",
    /* b */ "0b03 0819394844331304",
    /* c */ "4839190804133344",
    /* d */ "4b43 4839190804133344",
    /* e */ "06464839190804133344",
    /* f */ "3b2b1a13 0939",
    /* g */ "4941301001 4839190804133344",
    /* h */ "0b03 0819394843",
    /* i */ "0903 0b0b",
    /* j */ "191100 1b1b",
    /* k */ "0b03 4905 1643",
    /* l */ "0b0413",
    /* m */ "0903 0819293833 3849596863",
    /* n */ "0903 0819394843",
    /* o */ "193948443313040819",
    /* p */ "0900 0819394844331304",
    /* q */ "4940 4839190804133344",
    /* r */ "0903 071929",
    /* s */ "483919080716364544331304",
    /* t */ "1b142333 0939",
    /* u */ "0904133344 4943",
    /* v */ "092349",
    /* w */ "0923374369",
    /* x */ "0943 4903",
    /* y */ "0923 491000",
    /* z */ "09490343",
    /* { */ "2c1b1807161322",
    /* | */ "0c02",
    /* } */ "0c1b1827161302",
    /* ~ */ "061727364657",
};

enum {
    GRID_WIDTH = 9,
    GRID_HEIGHT = 13,
    BASE_LINE = 3,
    SPACE_WIDTH = 3,
    MARGIN = 1 /* at each side of a cell, grid units: room for the width of the strokes */
};

static const float STROKE = 1.15f; /* width of a stroke, grid units */

static int glyph_index(char letter) {
    int index = (unsigned char)letter - 32;
    return index >= 0 && index < FONT_GLYPHS ? index : '?' - 32;
}

static int grid_digit(char digit) {
    return digit <= '9' ? digit - '0' : digit - 'a' + 10;
}

/* The width of a glyph with the space after it, in grid units. */
static int glyph_advance(char letter) {
    const char *p = GLYPHS[glyph_index(letter)];
    if (!*p)
        return SPACE_WIDTH;
    int widest = 0;
    while (*p) {
        if (*p == ' ') {
            p++;
            continue;
        }
        int x = grid_digit(p[0]);
        widest = x > widest ? x : widest;
        p += 2;
    }
    return widest + 2;
}

static float distance_to_segment(float x, float y, float ax, float ay, float bx, float by) {
    float dx = bx - ax, dy = by - ay;
    float square = dx * dx + dy * dy;
    float t = square > 0 ? ((x - ax) * dx + (y - ay) * dy) / square : 0;
    t = fminf(fmaxf(t, 0), 1);
    return hypotf(x - ax - t * dx, y - ay - t * dy);
}

/* The distance from a point to the glyph's nearest stroke, in grid units. */
static float distance_to_glyph(const char *strokes, float x, float y) {
    float nearest = 1e9f;
    for (const char *p = strokes; *p;) {
        if (*p == ' ') {
            p++;
            continue;
        }
        const char *q = p[2] && p[2] != ' ' ? p + 2 : p;
        float d = distance_to_segment(x, y, (float)grid_digit(p[0]), (float)grid_digit(p[1]),
                                      (float)grid_digit(q[0]), (float)grid_digit(q[1]));
        nearest = fminf(nearest, d);
        p += 2;
    }
    return nearest;
}

/* Rasterises a glyph into its cell. Grid points are at the centres of their units, so that vertical
 * strokes fill whole pixels. */
static void rasterise(const font *f, Uint32 *pixels, int pitch, int glyph) {
    for (int row = 0; row < f->cell_height; row++)
        for (int column = 0; column < f->cell_width; column++) {
            float x = ((float)column + 0.5f) / f->unit - 0.5f - MARGIN;
            float y = GRID_HEIGHT - 0.5f + MARGIN - ((float)row + 0.5f) / f->unit;
            float distance = distance_to_glyph(GLYPHS[glyph], x, y) - 0.5f * STROKE;
            float cover = fminf(fmaxf(0.5f - distance * f->unit, 0), 1);
            pixels[row * pitch + glyph * f->cell_width + column] =
                (Uint32)(cover * 255 + 0.5f) << 24 | 0xFFFFFF;
        }
}

bool font_init(font *f, SDL_Renderer *renderer, float unit) {
    *f = (font){.unit = unit};
    f->cell_width = (int)ceilf((GRID_WIDTH + 2 * MARGIN) * unit);
    f->cell_height = (int)ceilf((GRID_HEIGHT + 2 * MARGIN) * unit);
    int width = FONT_GLYPHS * f->cell_width;
    Uint32 *pixels = malloc((size_t)width * (size_t)f->cell_height * sizeof *pixels);
    if (!pixels) {
        SDL_SetError("out of memory");
        return false;
    }
    for (int i = 0; i < FONT_GLYPHS; i++)
        rasterise(f, pixels, width, i);
    f->atlas = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STATIC,
                                 width, f->cell_height);
    bool made = f->atlas && SDL_UpdateTexture(f->atlas, NULL, pixels, 4 * width) == 0 &&
                SDL_SetTextureBlendMode(f->atlas, SDL_BLENDMODE_BLEND) == 0;
    free(pixels);
    if (!made)
        font_free(f);
    return made;
}

void font_free(font *f) {
    if (f->atlas)
        SDL_DestroyTexture(f->atlas);
    f->atlas = NULL;
}

float font_width(const font *f, const char *text, size_t length) {
    int units = 0;
    for (size_t i = 0; i < length; i++)
        units += glyph_advance(text[i]);
    return (float)units * f->unit;
}

float font_draw(const font *f, SDL_Renderer *renderer, float x, float y, SDL_Color color,
                const char *text, size_t length) {
    SDL_SetTextureColorMod(f->atlas, color.r, color.g, color.b);
    SDL_SetTextureAlphaMod(f->atlas, color.a);
    float pen = x;
    for (size_t i = 0; i < length; i++) {
        SDL_Rect from = {glyph_index(text[i]) * f->cell_width, 0, f->cell_width, f->cell_height};
        SDL_Rect to = {(int)lroundf(pen - MARGIN * f->unit),
                       (int)lroundf(y - (float)(GRID_HEIGHT - BASE_LINE + MARGIN) * f->unit),
                       f->cell_width, f->cell_height};
        SDL_RenderCopy(renderer, f->atlas, &from, &to);
        pen += (float)glyph_advance(text[i]) * f->unit;
    }
    return pen - x;
}
