#!/usr/bin/env python3
"""Makes the declarations and calls of bindings/lua/thud.lua from bindings/api.json.

    bind_lua.py [--check]

Between the lines `made from bindings/api.json` and `end` the file is made, the rest is written by
hand. With --check nothing is written: the exit status is 1 if the file is not as it would be made.
Signatures are read by signatures.py. Outputs are returned one by one, in the order of C."""

import sys
import textwrap

import made
from signatures import API, CALLBACKS, ENUMS, FUNCTIONS, HANDLES, OWN, RECORDINGS, ROOT, STRUCTS, Signature

sys.path.append(str(ROOT / "bindings/python"))
import declare  # noqa: E402; its C declarations

FILE = ROOT / "bindings/lua/thud.lua"
MADE = "---- made from bindings/api.json by tools/bind_lua.py: {} ----\n"
END = "---- end ----\n"
CLASSES = {None: "thud", "world": "World", "body": "Body", "shape": "Shape", "joint": "Joint",
           "rollback": "Rollback", "threads": "Threads"}
KEYWORDS = {"end", "and", "or", "not", "repeat", "until", "then", "function", "local", "nil", "in"}
# Names that calls use.
RESERVED = {"value", "list", "input", "array", "body", "shape", "joint", "pointer", "handles", "refused", "fill",
            "pending", "hold", "callback", "count", "code", "out", "found", "view", "ffi", "called", "blank"}
SCALARS = {"_Bool", "float", "double", "int", "unsigned int", "size_t",
           *(f"{sign}int{bits}_t" for sign in ("", "u") for bits in (8, 16, 32, 64))}
# The world's log is the module's own.
LEFT_OUT = OWN | RECORDINGS | {"thud_world_make", "thud_world_set_log", "thud_log_to_stderr"}


def by_value(callback):
    """Whether a callback has a struct by value, which LuaJIT's ffi does not pass."""
    return any(part["type"] in STRUCTS for part in callback["parameters"])


def number(value):
    return repr(value) if isinstance(value, int) else repr(float(value))


def table(name, entries):
    lines = ", ".join(entries)
    return f"local {name} = {{\n" + textwrap.fill(lines, 106, initial_indent="    ", break_long_words=False,
                                                    subsequent_indent="    ", break_on_hyphens=False) + "\n}\n"


def word(name):
    return f'["{name}"]' if name in KEYWORDS else name


def enum_words(entry):
    """The values of an enum by the words of their own."""
    values = [value for value in entry["values"] if not value["name"].endswith("_COUNT")]
    names = [value["name"] for value in values]
    shared = names[0].rsplit("_", 1)[0] + "_"
    while not all(name.startswith(shared) for name in names):
        shared = shared[:-1].rsplit("_", 1)[0] + "_"
    return ", ".join(f"{word(value['name'].removeprefix(shared).lower())} = {value['value']}"
                     for value in values)


def declarations():
    """What LuaJIT parses, and what this file knows of types."""
    lines = []
    for line in declare.cdef(API).splitlines():
        name = line.rsplit(" ", 1)[-1].rstrip(";")
        inline = any(line.split("(")[0].endswith(f" {one['name']}") for one in API["functions"] if one["inline"])
        if not inline and not (line.startswith("static const")):
            lines.append(line.replace("extern ", "extern const ") if name.startswith("thud_") else line)
    text = "ffi.cdef [[\n" + "\n".join(lines) + "\n]]\n"
    text += "thud.constants = {\n" + "".join(f"    {entry['name'].removeprefix('THUD_')} = {number(entry['value'])},\n"
                                          for entry in API["constants"]) + "}\n"
    text += "local ENUMS = {\n" + "".join(f"    {name} = {{ {enum_words(entry)} }},\n"
                                          for name, entry in ENUMS.items()) + "}\n"
    text += "thud.enums = ENUMS\n"
    text += table("HANDLES", [f"{name} = true" for name in HANDLES])
    made = {entry["returns"]: name for name, entry in FUNCTIONS.items()
            if name.startswith("thud_default_") and not entry["parameters"]}
    text += table("DEFAULTS", [f'{kind} = "{name}"' for kind, name in made.items()])
    objects = {}
    for entry in API["variables"]:
        kind = entry["type"].removeprefix("const ")
        objects.setdefault(kind, []).append(
            f'{word(entry["name"].split("_", 2)[2])} = "{entry["name"]}"')
    text += "local OBJECTS = {\n" + "".join(f"    {kind} = {{ {', '.join(names)} }},\n"
                                            for kind, names in objects.items()) + "}\n"
    text += table("CALLBACKS", [f'{name} = "{entry["returns"]}"' for name, entry in CALLBACKS.items()])
    text += "local FIELDS = {\n"
    for name, entry in STRUCTS.items():
        if not entry["opaque"]:
            fields = ", ".join(f'{word(field["name"])} = "{field["type"]}"' for field in entry["fields"])
            text += f"    {name} = {{ {fields} }},\n"
    aliases = "".join(f"FIELDS.{entry['name']} = FIELDS.{entry['type']}\n" for entry in API["aliases"])
    return text + "}\n" + aliases


class Call(Signature):
    """A function as Lua has it."""

    def __init__(self, function):
        super().__init__(function)
        self.name = self.name.removeprefix("get_") if self.owner else self.name
        self.parameters, self.defs = [], []
        self.lines, self.arguments = [], []
        self.results = []  # expressions that are returned
        self.read_parts()

    def offered(self):
        return self.c not in LEFT_OUT and not self.inline and \
            not any(part.role == "callback" and by_value(CALLBACKS[part.type]) for part in self.parts)

    def result_of(self, kind, place):
        """What is returned of an output."""
        if kind in HANDLES and self.owner:
            world = "self" if self.owner == "world" else "self.world"
            return f"{HANDLES[kind]}({world}, {place})"
        if kind == "size_t":
            return f"tonumber({place}[0])"
        if kind == "const char *":
            return f"{place}[0] ~= nil and ffi.string({place}[0]) or nil"
        return f"{place}[0]" if kind in SCALARS or kind in ENUMS else place

    def read_parts(self):
        for part in self.parts:
            role, kind, name = part
            name = f"{name}_" if name in KEYWORDS | RESERVED - {"out"} else name
            short = name.removeprefix("out_")
            short = f"{short}_" if short in RESERVED else short
            if role == "value" and kind in SCALARS or role in ("string", "raw", "changed"):
                self.parameters.append(name)
                self.arguments.append(name)
            elif role == "value":
                self.parameters.append(name)
                self.arguments.append(f'value("{kind}", {name}, hold)')
            elif role == "input":
                given = name
                if kind.endswith("_def") and f"thud_default_{kind.removeprefix('thud_')}" in FUNCTIONS and \
                        not FUNCTIONS[f"thud_default_{kind.removeprefix('thud_')}"]["parameters"]:
                    self.defs.append(name)
                    given = f"{name} or {{}}"
                else:
                    self.parameters.append(name)
                self.arguments.append(f'input("{kind}", {given}, hold)')
            elif role == "span":
                self.parameters.append(name)
                element = kind.removeprefix("const ")
                self.lines.append(f'local {name}_array, count = array("{element}", {name}, hold)')
                self.arguments += [f"{name}_array", "count"]
            elif role == "parallel":
                self.lines.append(f'local {short} = ffi.new("{kind}[?]", count)')
                self.arguments.append(short)
                self.results.append(short)
            elif role in ("read", "written"):
                self.parameters.append(short)
                if kind == "thud_bytes":
                    self.arguments.append(f"thud_bytes({short}, hold)")
                else:
                    self.lines.append(f"local {short}_data, {short}_size = to_{role.replace('written', 'write')}({short})")
                    self.arguments += [f"{short}_data", f"{short}_size"]
            elif role == "list":
                self.listed = kind
                self.arguments.append("...")
            elif role == "view":
                self.lines += [f'local view, view_count = ffi.new("const {kind} *[1]"), ffi.new("int[1]")']
                self.arguments += ["view", "view_count"]
                self.results += ["view[0]", "view_count[0]"]
            elif role == "callback":
                self.parameters.append(name)
                failed = f'FAILED["{CALLBACKS[kind]["returns"]}"]'
                self.lines.append(f'local called = {name} and callback("{kind}", {name}, {failed})')
                self.arguments += ["called", "nil"]
            elif role in ("found", "out"):
                single = kind in SCALARS or kind in ENUMS or kind.endswith("*")
                kind = "_Bool" if role == "found" else kind
                single = single or role == "found"
                place = short if role == "out" and name != "out" else "found" if role == "found" else "out"
                self.lines.append(f'local {place} = ffi.new("{kind}{"[1]" * single}")')
                self.arguments.append(place)
                if role == "out":
                    self.results.append(self.result_of(kind, place))

    def self_arguments(self):
        if self.owner is None:
            return []
        if self.owner in HANDLES.values():
            return ["pointer(self.world)", "self.id"]
        return ["pointer(self)"]

    def text(self):
        parameters = self.parameters + self.defs
        arguments = ", ".join(self.self_arguments() + self.arguments)
        lines = ["local hold = {}"] * any("hold" in one for one in self.arguments + self.lines) + self.lines
        if self.has("callback"):   # made last: what raises before would leave it behind
            made = next(line for line in lines if line.startswith("local called = "))
            given = [one.strip() for one in self.self_arguments() + self.arguments]
            names = [f"given_{i}" if "(" in one else one for i, one in enumerate(given)]
            lines = [line for line in lines if line != made]
            lines += [f"local {name} = {one}" for name, one in zip(names, given) if name != one] + [made]
            arguments = ", ".join(names)
        call = f"C.{self.c}({arguments})"
        if self.has("list"):
            arguments = ", ".join(self.self_arguments() + [one for one in self.arguments if one != "..."])
            room = "count" if self.has("span") else "16"
            lines.append(f'local code, out, found_count = list("{self.listed}", {room}, function(out, room, number)\n'
                         f"    return C.{self.c}({arguments}, out, room, number)\nend)")
            made = HANDLES.get(self.listed)
            world = "self" if self.owner == "world" else "self.world"
            self.results = [f"handles({made}, {world}, out, found_count)"] if made else ["out", "found_count"]
        elif self.returns == "thud_result":
            lines.append(f"local code = {call}")
        if self.returns == "thud_result":
            if self.has("callback"):
                kept = "_set_" in self.c
                lines += [f'keep_callback(self, "{self.c}", called, code)' if kept else "if called then\n    called:free()\nend"]
            lines.append("if code ~= 0 or pending then\n    return refused(code)\nend")
            if self.has("found"):
                lines.append("if not found[0] then\n    return false\nend")
            lines.append(f"return {', '.join(self.results) or 'true'}")
        elif self.returns == "_Bool" and self.results:
            lines += [f"if not {call} then\n    return false\nend", f"return {', '.join(self.results)}"]
        elif self.returns == "void":
            lines += [call, f"return {', '.join(self.results)}"] if self.results else [call]
        elif self.returns == "const char *":
            lines.append(f"return ffi.string({call})")
        elif self.returns in HANDLES and self.owner:
            lines.append(f"return {self.result_of(self.returns, call)}")
        else:
            lines.append(f"return {call}")
        body = textwrap.indent("\n".join(lines), "    ")
        separator = ":" if self.owner else "."
        return f"function {CLASSES[self.owner]}{separator}{self.name}({', '.join(parameters)})\n{body}\nend\n\n"


def made_text(text):
    calls = [Call(function) for function in API["functions"]]
    calls = [call for call in calls if call.offered()]
    names = [(call.owner, call.name) for call in calls]
    double = {name for name in names if names.count(name) > 1}
    assert not double, f"two functions of one name: {double}"
    for part, lines in (("declarations", declarations()), ("calls", "".join(call.text() for call in calls))):
        begin = text.index(MADE.format(part)) + len(MADE.format(part))
        text = text[:begin] + "\n" + lines + text[text.index(END, begin):]
    return text


def main():
    options = made.parser_of(__doc__).parse_args()
    return made.write({FILE: made_text(FILE.read_text(encoding="utf-8"))}, options.check, "bind_lua.py")


if __name__ == "__main__":
    sys.exit(main())
