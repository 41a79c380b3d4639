/* joint_maps.h: texts of Tiled maps with a few bodies and the joints of a test. */
#ifndef JOINT_MAPS_H
#define JOINT_MAPS_H

#include "level_support.h"

#define DYNAMIC "\"properties\":[{\"name\":\"body\",\"value\":\"dynamic\"}]"
/* Two dynamic boxes, the second one turned, and a static one; joints have the ids 9 and up. */
#define BODIES                                                                         \
    "{\"id\":1,\"x\":64,\"y\":64,\"width\":32,\"height\":32," DYNAMIC "},"             \
    "{\"id\":2,\"x\":200,\"y\":40,\"width\":64,\"height\":16,\"rotation\":30," DYNAMIC \
    "},{\"id\":3,\"x\":0,\"y\":300,\"width\":640,\"height\":20},"
#define REFERS(a, b)                                         \
    "{\"name\":\"a\",\"type\":\"object\",\"value\":" #a "}," \
    "{\"name\":\"b\",\"type\":\"object\",\"value\":" #b "}"
#define WITH(kind, properties) \
    "\"type\":\"" kind "\",\"x\":96,\"y\":48,\"properties\":[" properties "]"
#define POINT(kind, properties) "{\"id\":9,\"point\":true," WITH(kind, properties) "}"
#define LINE(kind, properties) \
    "{\"id\":9,\"polyline\":[{\"x\":0,\"y\":0},{\"x\":96,\"y\":-128}]," WITH(kind, properties) "}"
#define HAS(name, value) ",{\"name\":\"" name "\",\"value\":" #value "}"

/* Reads a map of 20 by 10 tiles of 32 pixels with BODIES and these objects. */
static inline bool read_map(const char *objects, bool skip, scene *s, level_report *report) {
    static char text[16384];
    int length = snprintf(text, sizeof text,
                          "{\"type\":\"map\",\"width\":20,\"height\":10,\"tilewidth\":32,"
                          "\"tileheight\":32,\"layers\":[{\"type\":\"objectgroup\",\"name\":\"o\","
                          "\"objects\":[%s%s]}]}",
                          BODIES, objects);
    assert_true(length > 0 && (size_t)length < sizeof text);
    return level_read("test", text, (size_t)length, skip, s, report);
}

#define AXLE(id, body)                                                                    \
    "{\"id\":" #id ",\"point\":true,\"type\":\"hinge\",\"x\":80,\"y\":80,\"properties\":" \
    "[{\"name\":\"b\",\"value\":" #body "}]}"

#endif
