#!/usr/bin/env python3
"""Makes the calls of recordings from bindings/api.json:

    recorded.py [--check]

  engine/include/thud/thud_recorded.h     redirects the calls that change a world
  engine/src/recording/recorded_calls.h   their numbers
  engine/src/recording/recorded_calls.c   how their arguments, and what queries found, become bytes
  engine/src/recording/recorded.c         the functions to which calls are redirected
  engine/src/recording/play_call.c        calls a function by its number, with decoded arguments

Every function with a world that is not const is recorded, or stands in one of the tables below,
which say why not; a function in neither is an error. With --check nothing is written: the exit status
is 1 where a file differs from what it should be.

The number of a call is its place in the list of calls, which NUMBERS fixes: new functions come last,
so that earlier recordings keep their meaning.
"""

import json
import sys
from pathlib import Path

import made

ROOT = Path(__file__).resolve().parent.parent
API = ROOT / "bindings" / "api.json"
NUMBERS = ROOT / "tools" / "recorded_calls.txt"

# Functions with a world that is not const, and which do not change its state.
NO_CHANGE = {
    "queries and reads, which need room in the world": """
        thud_world_draw thud_body_get_volume thud_body_get_contacts thud_world_get_poses
        thud_poses_of thud_world_get_bisection_limit thud_shape_cast_ray thud_shape_contains_point
        thud_shape_closest_point thud_shape_get_bounds thud_world_predict""",
    "hooks, which are no state": "thud_world_set_log",
    "epilogues of objects, which the recorder finds before the next step":
        "thud_body_set_epilogue thud_world_set_category_epilogue",
    "a save reads the world": "thud_world_save",
    "rollback: its restores are noticed by the number of steps":
        "thud_rollback_create",
    "the recorder itself": "thud_recorder_begin",
}
# Queries of a world: recorded with what they found where the recorder is asked to, and not made again
# by a player. Their wrappers are in recorded_queries.c.
QUERIES = set("""thud_world_cast_ray thud_world_cast_ray_all thud_world_cast_ray_each
                 thud_world_cast_rays thud_world_cast_shape thud_world_cast_shape_all
                 thud_world_cast_shape_each thud_world_cast_shapes thud_world_overlap_shape
                 thud_world_overlap_aabb thud_world_closest""".split())
# Recorded functions whose wrapper is written by hand, in recorded_by_hand.c.
BY_HAND = set("""thud_world_advance_with thud_world_set_filter thud_mover_move""".split())
# Functions that are redirected to a wrapper by hand, and are no recorded call: after the first two
# the recording has the new state; the last one ends it.
REPLACED = ["thud_world_restore", "thud_world_load", "thud_world_destroy"]
# Recorded functions that play_by_hand.c calls.
PLAYED_BY_HAND = set("""thud_world_advance_with thud_world_set_filter thud_world_set_listeners
                        thud_mover_move""".split())

HANDLES = ("thud_body_id", "thud_shape_id", "thud_joint_id")
SCALARS = {"_Bool": "BOOL", "int": "INT32", "int32_t": "INT32", "uint32_t": "UINT32",
           "int64_t": "INT64", "uint64_t": "UINT64", "float": "FLOAT", "double": "DOUBLE"}
NOTE = "/* Made by tools/recorded.py of the public headers: do not edit. */\n"
UNFORMATTED = "/* clang-format off */\n"


def number_name(name):
    return "TD_CALL_" + name.removeprefix("thud_").upper()


class Api:
    def __init__(self, text):
        api = json.loads(text)
        self.functions = {function["name"]: function for function in api["functions"]}
        self.structs = {struct["name"]: struct for struct in api["structs"]}
        self.enums = {enum["name"] for enum in api["enums"]}
        self.used = []   # structs, those that others contain first

    def code(self, type_name):
        if type_name in SCALARS:
            return SCALARS[type_name]
        if type_name in self.enums:
            return "INT32"
        if type_name in HANDLES:
            return "HANDLE"
        if type_name in self.structs:
            self.use(type_name)
            return "STRUCT"
        raise SystemExit(f"recorded.py: how is a {type_name} recorded?")

    def element(self, type_name):
        """The codec of what is pointed to: of a struct, or of one number."""
        if type_name in self.structs:
            self.use(type_name)
        return f"&CODEC_{type_name}"

    def use(self, name):
        if name not in self.used:
            fields = self.fields(name)   # uses what it contains first
            if name not in self.used:
                self.used.append(name)
            return fields
        return None

    def fields(self, struct):
        """(code, repeat, field, field that counts, codec) of each."""
        rows = []
        fields = self.structs[struct]["fields"]
        names = [field["name"] for field in fields]
        for field in fields:
            name, kind = field["name"], field["type"]
            repeat = 1
            if kind.endswith("]") and "*" not in kind:
                kind, repeat = kind[:-1].split("[")
            if name == "cookie":
                rows.append(("COOKIE", 1, name, name, "NULL"))
            elif kind == "void *":
                rows.append(("NOTHING", 1, name, name, "NULL"))
            elif kind == "const char *":
                rows.append(("NAME", 1, name, name, "NULL"))
            elif kind == "const thud_detection *":
                rows.append(("DETECTION", 1, name, name, "NULL"))
            elif kind == "const thud_island_solver *":
                rows.append(("ISLANDS", 1, name, name, "NULL"))
            elif kind == "thud_mover_pass_fn *":
                rows.append(("PASS", 1, name, name, "NULL"))
            elif kind.startswith("const ") and kind.endswith(" *"):
                element = kind[6:-2]
                count = {"table": "table_count"}.get(name, "count")
                if (struct, name) == ("thud_terrain", "points"):
                    rows.append(("POINTS", 1, name, "count", self.element(element)))
                elif count in names:
                    rows.append(("ARRAY", 1, name, count, self.element(element)))
                else:
                    rows.append(("POINTER", 1, name, name, self.element(element)))
            else:
                code = self.code(kind)
                codec = f"&CODEC_{kind}" if code == "STRUCT" else "NULL"
                rows.append((code, int(repeat), name, name, codec))
        return rows

    def arguments(self, function):
        """(code, index, index of the argument that counts, codec) of each after the world."""
        rows = []
        parameters = self.functions[function]["parameters"][1:]
        names = [parameter["name"] for parameter in parameters]
        for index, parameter in enumerate(parameters):
            name, kind = parameter["name"], parameter["type"]
            count, codec = 0, "NULL"
            if name == "out" or name.startswith("out_"):
                handle = kind[:-2] in HANDLES
                if handle and name.endswith("_ids"):
                    code, count = "OUT_HANDLES", names.index("count")
                else:
                    code = "OUT_HANDLE" if handle else "OUT"
            elif kind == "thud_filter_fn *":
                code = "FILTER"
            elif kind == "const thud_listeners *":
                code = "LISTENERS"
            elif kind == "const thud_step_calls *":
                code = "STEP_CALLS"
            elif kind == "const thud_contact *":
                code = "CONTACT"
            elif kind in ("void *", "thud_cast_fn *", "thud_overlap_fn *"):
                code = "NOTHING"
            elif kind == "const thud_detection *":
                code = "DETECTION"
            elif kind.endswith(" *"):
                codec = self.element(kind.removeprefix("const ")[:-2])
                code = "ARRAY" if names[index + 1:index + 2] == ["count"] or name == "shapes" else "POINTER"
                count = names.index("count") if code == "ARRAY" else 0
            else:
                code = self.code(kind)
                codec = f"&CODEC_{kind}" if code == "STRUCT" else "NULL"
            rows.append((code, index, count, codec))
        if self.functions[function]["returns"] in HANDLES:   # as if the call wrote it
            rows.append(("OUT_HANDLE", len(rows), 0, "NULL"))
        return rows


def c_type(kind):
    return "bool" if kind == "_Bool" else kind


def declared(kind, name):
    return f"{c_type(kind)}{name}" if kind.endswith("*") else f"{c_type(kind)} {name}"


def signature(function, name):
    parameters = ", ".join(declared(p["type"], p["name"]) for p in function["parameters"])
    return f"{declared(function['returns'], name)}({parameters})"


def select(api):
    """The recorded functions, in the order of their numbers."""
    silent = {name for names in NO_CHANGE.values() for name in names.split()}
    changing = [name for name, function in api.functions.items()
                if function["parameters"] and function["parameters"][0]["type"] == "thud_world *"]
    for name in sorted((silent | QUERIES | BY_HAND | set(REPLACED) | PLAYED_BY_HAND) - set(changing)):
        raise SystemExit(f"recorded.py: {name} is listed, and changes no world")
    recorded = [name for name in changing if name not in silent and name not in REPLACED]
    numbered = NUMBERS.read_text(encoding="utf-8").split() if NUMBERS.is_file() else []
    for name in numbered:
        if name not in recorded:
            raise SystemExit(f"recorded.py: {name} has a number, and is not recorded any more")
    return numbered + [name for name in recorded if name not in numbered]


def write_header(api, calls):
    lines = ["""/* thud_recorded.h: records the calls of the source files that include it. Each function that
 * changes a world, and each query of one, is redirected to one that makes the same call, and adds
 * it to the recording of the world (thud_recording.h), if there is one; queries only where the
 * recorder is asked to. Include it last: it includes all headers of thud. Programs that do not
 * include it link nothing of it.
 *
 * Calls have the same arguments, results and errors as without it. thud_all.h does not include this
 * header. */""",
             NOTE + "#ifndef THUD_RECORDED_H", "#define THUD_RECORDED_H", "",
             '#include "thud_all.h"', "", "#ifdef __cplusplus", 'extern "C" {', "#endif", "",
             UNFORMATTED.rstrip()]
    for name in calls + REPLACED:
        redirected = name.replace("thud_", "thud_recorded_", 1)
        lines.append(f"THUD_API {signature(api.functions[name], redirected)};")
        lines.append(f"#define {name} {redirected}")
    lines += ["/* clang-format on */", "", "#ifdef __cplusplus", "}", "#endif", "", "#endif", ""]
    return "\n".join(lines)


def write_numbers(calls):
    names = ",\n    ".join(number_name(name) for name in calls)
    return f"""/* recorded_calls.h: the numbers of recorded calls. */
{NOTE}#ifndef TD_RECORDED_CALLS_H
#define TD_RECORDED_CALLS_H

#include "recording/codec.h"

{UNFORMATTED}enum td_call {{
    {names},
    TD_CALL_COUNT
}};
/* clang-format on */

extern const td_recorded_call td_recorded_calls[TD_CALL_COUNT];
/* What a query found, as if it were a call with the arguments int count, const thud_ray_hit *hits.
 */
extern const td_recorded_call td_recorded_hits;

#endif
"""


def write_tables(api, calls):
    arguments = {name: api.arguments(name) for name in calls}
    hit = api.element("thud_ray_hit")
    lines = ["/* recorded_calls.c: how the arguments of calls, and what queries found, become bytes: tables\n"
             " * of codec.h. */",
             NOTE + '#include "recording/recorded_calls.h"', "", '#include "thud/thud_all.h"', "",
             UNFORMATTED.rstrip(),
             "#define FIELD(type, code, repeat, field, count, codec) \\",
             "    {TD_CODE_##code, repeat, offsetof(type, field), offsetof(type, count), codec}",
             "#define CODEC(type, fields) {fields, sizeof fields / sizeof *fields, sizeof(type)}"]
    for scalar in ("float", "double"):
        lines += [f"static const td_codec_field FIELDS_{scalar}[] = {{{{TD_CODE_{SCALARS[scalar]}, 1, 0, 0, NULL}}}};",
                  f"static const td_codec CODEC_{scalar} = CODEC({scalar}, FIELDS_{scalar});"]
    for struct in api.used:
        rows = "\n".join(f"    FIELD({struct}, {code}, {repeat}, {field}, {count}, {codec}),"
                         for code, repeat, field, count, codec in api.fields(struct))
        lines += [f"static const td_codec_field FIELDS_{struct}[] = {{\n{rows}\n}};",
                  f"static const td_codec CODEC_{struct} = CODEC({struct}, FIELDS_{struct});"]
    for name, rows in arguments.items():
        if rows:
            text = ", ".join(f"{{TD_CODE_{code}, 1, {index}, {count}, {codec}}}"
                             for code, index, count, codec in rows)
            lines.append(f"static const td_codec_field ARGUMENTS_{name}[] = {{{text}}};")
    lines.append("const td_recorded_call td_recorded_calls[TD_CALL_COUNT] = {")
    for name, rows in arguments.items():
        table = f"ARGUMENTS_{name}" if rows else "NULL"
        query = "true" if name in QUERIES else "false"
        lines.append(f'    [{number_name(name)}] = {{"{name}", {table}, {len(rows)}, {query}}},')
    lines += ["};",
              "static const td_codec_field HITS[] = {",
              f"    {{TD_CODE_INT32, 1, 0, 0, NULL}}, {{TD_CODE_ARRAY, 1, 1, 0, {hit}}}}};",
              'const td_recorded_call td_recorded_hits = {"", HITS, 2, false};']
    return "\n".join(lines + ["/* clang-format on */", ""])


def write_wrappers(api, calls):
    lines = ["/* recorded.c: the functions of thud_recorded.h: each makes its call within a frame\n"
             " * (recorder.h). Those that need more are in recorded_by_hand.c, queries in recorded_queries.c. */",
             NOTE + '#include "recording/recorder.h"', "", '#include "thud/thud_all.h"', "",
             UNFORMATTED.rstrip()]
    for name in calls:
        if name in BY_HAND | QUERIES:
            continue
        function = api.functions[name]
        redirected = name.replace("thud_", "thud_recorded_", 1)
        parameters = function["parameters"][1:]
        passed = ", ".join(p["name"] for p in function["parameters"])
        returned = c_type(function["returns"])
        is_handle = returned in HANDLES
        args = [f"&{p['name']}" for p in parameters] + (["&out"] if is_handle else []) or ["NULL"]
        world = function["parameters"][0]["name"]
        lines += ["", f"THUD_API {signature(function, redirected)} {{"]
        if is_handle:
            lines.append(f"    {returned} made, *out = &made;")
        lines += [f"    const void *const args[] = {{{', '.join(args)}}};",
                  "    td_record_frame own;",
                  f"    td_record_open(&own, {world}, {number_name(name)}, args);"]
        if returned == "thud_result":
            lines.append(f"    return td_record_close(&own, {name}({passed}));")
        else:
            lines += [f"    made = {name}({passed});",
                      "    td_record_close(&own, made.index1 ? THUD_OK : THUD_ERROR_INVALID);",
                      "    return made;"]
        lines.append("}")
    return "\n".join(lines + ["/* clang-format on */", ""])


def write_player(api, calls):
    lines = ["/* play_call.c: makes a recorded call. */",
             NOTE + '#include "recording/play_call.h"', "", '#include "recording/recorded_calls.h"',
             '#include "thud/thud_all.h"', "",
             UNFORMATTED.rstrip(),
             "#define ARGUMENT(type, i) (*(type const *)d->args[i])",
             "thud_result td_play_call(td_play *p, thud_world *w, int call, td_decoded *d) {",
             "    switch (call) {"]
    for name in calls:
        if name in QUERIES:
            continue
        function = api.functions[name]
        lines.append(f"    case {number_name(name)}:")
        if name in PLAYED_BY_HAND:
            lines.append(f"        return td_play_{name.removeprefix('thud_')}(p, w, d);")
            continue
        passed = "".join(f", ARGUMENT({c_type(p['type'])}, {i})"
                         for i, p in enumerate(function["parameters"][1:]))
        made = f"{name}(w{passed})"
        if function["returns"] == "thud_result":
            lines.append(f"        return {made};")
        else:
            out = f"ARGUMENT({function['returns']} *, {len(function['parameters']) - 1})"
            lines += [f"        *{out} = {made};",
                      f"        return {out}->index1 ? THUD_OK : THUD_ERROR_INVALID;"]
    return "\n".join(lines + ["    }", "    return THUD_ERROR_INVALID;", "}", "/* clang-format on */", ""])


def made_files(api):
    calls = select(api)
    tables = write_tables(api, calls)
    source = ROOT / "engine" / "src" / "recording"
    return {ROOT / "engine" / "include" / "thud" / "thud_recorded.h": write_header(api, calls),
            NUMBERS: "\n".join(calls) + "\n",
            source / "recorded_calls.h": write_numbers(calls),
            source / "recorded_calls.c": tables,
            source / "recorded.c": write_wrappers(api, calls),
            source / "play_call.c": write_player(api, calls)}


def main():
    options = made.parser_of(__doc__).parse_args()
    return made.write(made_files(Api(API.read_text(encoding="utf-8"))), options.check, "recorded.py")


if __name__ == "__main__":
    sys.exit(main())
