/* tmx.c: converts the XML form of Tiled's files (.tmx, .tsx, .tx) into the JSON that Tiled would
 * have written for the same content, so that the rest of the reader has one form to read. Parsed
 * with Expat. */
#include "reader.h"

#include <expat.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Max depth of nested elements, groups among them. Chosen. */
enum { DEEPEST = 64 };
/* Max length of a text, since Expat takes it as an int. */
enum { LONGEST_TEXT = 1 << 30 };

typedef struct frame {
    const char *element;
    cJSON *json; /* receives the element's children; null: they are ignored, as the element is */
    const char *text_as; /* the field that the element's text is stored in, or null */
} frame;

typedef struct tmx {
    XML_Parser parser;
    cJSON *root;
    frame stack[DEEPEST];
    int depth;
    bool infinite; /* the map is infinite: its layers have chunks, and none where they are empty */
    char *text;    /* text so far of the innermost element that stores its text */
    size_t used, capacity;
    const char *trouble;
} tmx;

/* How an element is stored in the JSON of its parent element. */
typedef enum rule_kind {
    IN_LIST,  /* an object, appended to a list */
    IN_FIELD, /* an object, in a field */
    IN_PLACE, /* attributes and children are stored in the parent's own object */
    A_FLAG,   /* true, in a field */
    A_CELL,   /* a number, appended to a list: cells in the oldest form of maps */
    POINTS    /* a list of points, in a field */
} rule_kind;

static const struct rule {
    const char *parents, *element; /* names between spaces */
    rule_kind kind;
    const char *name; /* of the list or field */
    const char *type; /* value of a layer's field "type", or null */
} RULES[] = {
    {" map ", "tileset", IN_LIST, "tilesets", NULL},
    {" template ", "tileset", IN_FIELD, "tileset", NULL},
    {" map group ", "layer", IN_LIST, "layers", "tilelayer"},
    {" map group ", "objectgroup", IN_LIST, "layers", "objectgroup"},
    {" map group ", "imagelayer", IN_LIST, "layers", "imagelayer"},
    {" map group ", "group", IN_LIST, "layers", "group"},
    {" tileset ", "tile", IN_LIST, "tiles", NULL},
    {" tileset ", "tileoffset", IN_FIELD, "tileoffset", NULL},
    {" tile ", "objectgroup", IN_FIELD, "objectgroup", NULL},
    {" tile ", "image", IN_FIELD, "image", NULL},
    {" layer ", "data", IN_PLACE, NULL, NULL},
    {" data ", "chunk", IN_LIST, "chunks", NULL},
    {" data chunk ", "tile", A_CELL, "data", NULL},
    {" objectgroup ", "object", IN_LIST, "objects", NULL},
    {" template ", "object", IN_FIELD, "object", NULL},
    {" object ", "ellipse", A_FLAG, "ellipse", NULL},
    {" object ", "point", A_FLAG, "point", NULL},
    {" object ", "capsule", A_FLAG, "capsule", NULL},
    {" object ", "text", A_FLAG, "text", NULL},
    {" object ", "polygon", POINTS, "polygon", NULL},
    {" object ", "polyline", POINTS, "polyline", NULL},
    {" map tileset tile layer objectgroup imagelayer group object ", "properties", IN_PLACE, NULL,
     NULL},
    {" properties ", "property", IN_LIST, "properties", NULL},
};

/* The attributes that are stored: those that are numbers in JSON, and those that are texts. */
static const char NUMBERS[] = " width height tilewidth tileheight firstgid id gid x y rotation "
                              "offsetx offsety ";
static const char TEXTS[] = " name type class value source template encoding compression "
                            "orientation objectalignment tilerendersize fillmode ";

/* Whether `word` is one of `words`, which stand between spaces. */
static bool in_words(const char *words, const char *word) {
    size_t length = strlen(word);
    for (const char *at = strstr(words, word); at && length > 0; at = strstr(at + 1, word))
        if (at > words && at[-1] == ' ' && at[length] == ' ')
            return true;
    return false;
}

/* Stops parsing. The first reason is kept. */
static void give_up(tmx *t, const char *trouble) {
    if (!t->trouble)
        t->trouble = trouble;
    XML_StopParser(t->parser, XML_FALSE);
}

/* Adds an item to an object and returns it. If `item` is null, memory ran out, and parsing stops.
 * If the object has a field of this name already, that is kept and null is returned. */
static cJSON *put(tmx *t, cJSON *json, const char *name, cJSON *item) {
    if (item && cJSON_GetObjectItemCaseSensitive(json, name)) {
        cJSON_Delete(item);
        return NULL;
    }
    if (item && cJSON_AddItemToObject(json, name, item))
        return item;
    cJSON_Delete(item);
    give_up(t, "out of memory");
    return NULL;
}

/* Appends an item to a list, which is created for its first item. */
static cJSON *put_in_list(tmx *t, cJSON *json, const char *name, cJSON *item) {
    cJSON *list = cJSON_GetObjectItemCaseSensitive(json, name);
    if (!list)
        list = put(t, json, name, cJSON_CreateArray());
    if (list && item && cJSON_AddItemToArray(list, item))
        return item;
    cJSON_Delete(item);
    give_up(t, "out of memory");
    return NULL;
}

/* Stores the attributes of an element that have a meaning. Numbers that are malformed stay texts.
 */
static void put_attributes(tmx *t, cJSON *json, const char **attributes) {
    for (const char **a = attributes; a[0] && !t->trouble; a += 2) {
        double number;
        bool is_number = in_words(NUMBERS, a[0]);
        if (!is_number && !in_words(TEXTS, a[0]))
            continue;
        is_number = is_number && level_number_of(a[1], &number);
        put(t, json, a[0], is_number ? cJSON_CreateNumber(number) : cJSON_CreateString(a[1]));
    }
}

/* Converts a property's value to the type that the property names. */
static void put_typed_value(tmx *t, cJSON *property) {
    const char *type = level_field_text(property, "type", "string");
    const char *value = level_field_text(property, "value", NULL);
    cJSON *typed = NULL;
    double number;
    if (!value)
        return;
    bool is_number = strcmp(type, "int") == 0 || strcmp(type, "float") == 0 ||
                     strcmp(type, "object") == 0; /* a reference to another object, by its id */
    if (is_number && level_number_of(value, &number))
        typed = cJSON_CreateNumber(number);
    else if (strcmp(type, "bool") == 0 &&
             (strcmp(value, "true") == 0 || strcmp(value, "false") == 0)) /* else it is reported */
        typed = cJSON_CreateBool(strcmp(value, "true") == 0);
    else
        return;
    if (!typed || !cJSON_ReplaceItemInObjectCaseSensitive(property, "value", typed))
        give_up(t, "out of memory");
}

/* Stores points from a text like "0,0 16,-8". A pair that is malformed becomes a point without x
 * and y, which is reported when the forms are read. */
static void put_points(tmx *t, cJSON *json, const char *name, const char *text) {
    cJSON *points = put(t, json, name, cJSON_CreateArray());
    while (points && *text && !t->trouble) {
        size_t length = strcspn(text, " \t\r\n");
        char pair[128] = "";
        if (length > 0 && length < sizeof pair)
            memcpy(pair, text, length);
        text += length + strspn(text + length, " \t\r\n");
        if (length == 0)
            continue;
        cJSON *point = cJSON_CreateObject();
        if (!point || !cJSON_AddItemToArray(points, point)) {
            cJSON_Delete(point);
            give_up(t, "out of memory");
            return;
        }
        char *comma = strchr(pair, ',');
        if (comma)
            *comma = 0;
        double x, y;
        if (comma && level_number_of(pair, &x) && level_number_of(comma + 1, &y)) {
            put(t, point, "x", cJSON_CreateNumber(x));
            put(t, point, "y", cJSON_CreateNumber(y));
        }
    }
}

/* The value of an element's attribute; null if it has none. */
static const char *attribute(const char **attributes, const char *name) {
    for (const char **a = attributes; a[0]; a += 2)
        if (strcmp(a[0], name) == 0)
            return a[1];
    return NULL;
}

/* Appends the number of a cell from an element `tile`, the oldest form of cells; 0 if it has none,
 * -1 if that is malformed. */
static void put_cell(tmx *t, cJSON *json, const char **attributes) {
    const char *gid = attribute(attributes, "gid");
    double number = 0;
    if (gid && !level_number_of(gid, &number))
        number = -1;
    put_in_list(t, json, "data", cJSON_CreateNumber(number));
}

/* Stores an element by its rule in `around`, the JSON of its parent, and returns its frame. */
static frame enter(tmx *t, const struct rule *rule, cJSON *around, const char **attributes) {
    frame next = {.element = rule->element};
    const char *points = attribute(attributes, "points");
    switch (rule->kind) {
    case A_FLAG:
        put(t, around, rule->name, cJSON_CreateTrue());
        return next;
    case A_CELL:
        put_cell(t, around, attributes);
        return next;
    case POINTS:
        put_points(t, around, rule->name, points ? points : "");
        return next;
    case IN_PLACE:
        next.json = around;
        break;
    case IN_FIELD:
        next.json = put(t, around, rule->name, cJSON_CreateObject());
        break;
    case IN_LIST:
        next.json = put_in_list(t, around, rule->name, cJSON_CreateObject());
        break;
    }
    if (!next.json)
        return next;
    if (rule->type) {
        bool objects = strcmp(rule->type, "objectgroup") == 0;
        put(t, next.json, "type", cJSON_CreateString(rule->type));
        /* Tiled writes these lists for empty layers, too. */
        if (objects || strcmp(rule->type, "group") == 0)
            put(t, next.json, objects ? "objects" : "layers", cJSON_CreateArray());
    }
    put_attributes(t, next.json, attributes);
    if (strcmp(rule->element, "property") == 0) {
        put_typed_value(t, next.json);
        next.text_as = "value";
    } else if (strcmp(rule->element, "data") == 0 || strcmp(rule->element, "chunk") == 0) {
        next.text_as = "data";
    }
    return next;
}

/* Begins the outermost element: map, tileset or template. */
static void begin_root(tmx *t, const char *element, const char **attributes) {
    static const char *const ROOTS[] = {"map", "tileset", "template"};
    frame *root = &t->stack[0];
    t->root = root->json = cJSON_CreateObject();
    if (!root->json) {
        give_up(t, "out of memory");
        return;
    }
    for (int i = 0; i < 3; i++)
        if (strcmp(element, ROOTS[i]) == 0)
            root->element = ROOTS[i];
    put(t, root->json, "type", cJSON_CreateString(element));
    const char *infinite = attribute(attributes, "infinite");
    t->infinite = infinite && strcmp(infinite, "1") == 0;
    if (strcmp(element, "map") == 0)
        put(t, root->json, "layers", cJSON_CreateArray());
    put_attributes(t, root->json, attributes);
}

/* Expat's handler for the start of an element. An element without a rule in its parent is ignored.
 */
static void XMLCALL begin(void *context, const char *element, const char **attributes) {
    tmx *t = context;
    if (t->trouble)
        return;
    if (t->depth == DEEPEST) {
        give_up(t, "its elements are nested too deeply");
        return;
    }
    frame *next = &t->stack[t->depth++];
    *next = (frame){.element = ""};
    t->used = 0;
    if (t->depth == 1) {
        begin_root(t, element, attributes);
        return;
    }
    for (size_t i = 0; next[-1].json && i < sizeof RULES / sizeof RULES[0]; i++) {
        if (strcmp(RULES[i].element, element) == 0 &&
            in_words(RULES[i].parents, next[-1].element)) {
            *next = enter(t, &RULES[i], next[-1].json, attributes);
            return;
        }
    }
}

/* Expat's handler for the end of an element: stores its text. */
static void XMLCALL end(void *context, const char *element) {
    (void)element;
    tmx *t = context;
    if (t->trouble)
        return;
    const frame *last = &t->stack[--t->depth];
    bool blank = true;
    for (size_t i = 0; i < t->used; i++)
        blank = blank && strchr(" \t\r\n", t->text[i]);
    if (last->json && last->text_as && !blank) {
        t->text[t->used] = 0;
        put(t, last->json, last->text_as, cJSON_CreateString(t->text));
    } else if (last->json && t->infinite && strcmp(last->element, "data") == 0 &&
               !cJSON_GetObjectItemCaseSensitive(last->json, "data")) {
        /* A layer without tiles has an empty list in JSON. */
        put(t, last->json, "chunks", cJSON_CreateArray());
    }
    t->used = 0;
}

/* Expat's handler for text, which may arrive in several pieces. */
static void XMLCALL add_text(void *context, const char *text, int length) {
    tmx *t = context;
    if (t->trouble || t->depth == 0 || !t->stack[t->depth - 1].text_as)
        return;
    size_t wanted = t->used + (size_t)length + 1;
    if (wanted > t->capacity) {
        char *grown = realloc(t->text, 2 * wanted);
        if (!grown) {
            give_up(t, "out of memory");
            return;
        }
        t->text = grown;
        t->capacity = 2 * wanted;
    }
    memcpy(t->text + t->used, text, (size_t)length);
    t->used += (size_t)length;
}

/* Tiled's files declare no entities; a small file with nested entities could expand to a very large
 * text. */
static void XMLCALL refuse_entity(void *context, const char *name, int is_parameter,
                                  const char *value, int length, const char *base,
                                  const char *system, const char *public, const char *notation) {
    (void)name, (void)is_parameter, (void)value, (void)length;
    (void)base, (void)system, (void)public, (void)notation;
    give_up(context, "it declares entities");
}

cJSON *level_tmx(const char *text, size_t length, char *trouble, size_t size) {
    tmx t = {.parser = XML_ParserCreate(NULL)};
    bool read = false;
    if (!t.parser) {
        snprintf(trouble, size, "out of memory");
        return NULL;
    }
    XML_SetUserData(t.parser, &t);
    XML_SetElementHandler(t.parser, begin, end);
    XML_SetCharacterDataHandler(t.parser, add_text);
    XML_SetEntityDeclHandler(t.parser, refuse_entity);
    if (length > LONGEST_TEXT)
        t.trouble = "it is too long";
    else
        read = XML_Parse(t.parser, text, (int)length, 1) == XML_STATUS_OK;
    if (!read || t.trouble) {
        snprintf(trouble, size, "this XML cannot be read: %s in line %lu",
                 t.trouble ? t.trouble : XML_ErrorString(XML_GetErrorCode(t.parser)),
                 (unsigned long)XML_GetCurrentLineNumber(t.parser));
        cJSON_Delete(t.root);
        t.root = NULL;
    }
    XML_ParserFree(t.parser);
    free(t.text);
    return t.root;
}
