#!/usr/bin/env python3
"""Makes the members and functions of engine/include/thud/thud.hpp from bindings/api.json.

    bind_cpp.py [--clang-format CLANG_FORMAT] [--check]

Between the lines `made from bindings/api.json` and `end` the file is made, the rest is written by
hand. With --check nothing is written: the exit status is 1 if the file is not as it would be made.

From a signature of C follows what its C++ looks like:

  the first parameters      a world and a handle of the noun that the name begins with make a member
                            of that handle; a world, rollback or pool of threads alone, a member of it
  const T *x                in<T>
  T *x, int count           span<T>, const or not; as count also `slots` or, for a list that is
                            written, `capacity`, whose out_count is then the result
  void *x, size_t           bytes or const_bytes, as thud_bytes
  X_fn *fn, void *context   a callable; by reference, without temporaries, where a setter keeps it
  T *out...                 what is returned: one value, or a struct of several
  bool *out_hit, T *out...  a std::optional; likewise where a function returns bool
  const T **, int *         a span of the world's memory

A signature that fits none of these ends the script with its name."""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
API = json.loads((ROOT / "bindings/api.json").read_text(encoding="utf-8"))
HEADER = ROOT / "engine/include/thud/thud.hpp"
MADE = "// ---- made from bindings/api.json by tools/bind_cpp.py: {} ----\n"
END = "// ---- end ----\n"

OWNERS = {"thud_world": "world_ref", "thud_rollback": "rollback", "thud_threads": "threads"}
HANDLES = {"thud_body_id": "body", "thud_shape_id": "shape", "thud_joint_id": "joint"}
# Written by hand in the templates below: what creates and destroys.
OWN = {"thud_world_create", "thud_world_destroy", "thud_rollback_create", "thud_rollback_destroy",
       "thud_threads_create", "thud_threads_destroy"}
# Outputs that are arrays, as long as the span that the function reads.
PARALLEL = {"thud_world_cast_rays": "out_hits", "thud_world_cast_shapes": "out_hits",
            "thud_world_extrapolate": "out", "thud_world_predict": "out",
            "thud_body_create_with_shapes": "out_shape_ids"}
# Pointers that stay pointers: arrays whose length is a field of the options, memory whose size the
# caller knows, and contexts of functions that are callbacks themselves.
RAW = {("thud_approximate", "out_shapes"), ("thud_rollback_get_state", "out_state"),
       ("thud_log_to_stderr", "context"), ("thud_mover_passes_one_way", "context")}
FOUND = {"out_hit", "out_found", "out_collided"}
# Inputs that may be left out.
OPTIONAL = {"filter", "options", "calls", "allocator"}
DEFAULTS = {("thud_poses_of", "origin"): "{}", ("thud_poses_of", "alpha"): "1.0",
            ("thud_world_get_poses", "origin"): "{}", ("thud_world_get_poses", "alpha"): "1.0",
            ("thud_world_advance", "max_steps"): "4"}
NAMES = {entry["name"]: entry for entry in API["functions"]}
CALLBACKS = {entry["name"]: entry for entry in API["callbacks"]}
STRUCTS = {entry["name"]: entry for entry in API["structs"]}


def bare(kind):
    """The type that a pointer points to, without const."""
    return kind.removeprefix("const ").removesuffix("*").strip()


def cpp(kind):
    return kind.replace("_Bool", "bool")


class Call:
    """A function as C++ has it."""

    def __init__(self, function):
        self.c = function["name"]
        parts = function["parameters"]
        self.returns = function["returns"]
        self.inline = function["inline"]
        self.owner, self.const = self.place(parts)
        self.parameters = []  # (declaration, default or None)
        self.templates = []
        self.kept = False  # a callable that is kept
        self.arguments = []
        self.before = []  # statements
        self.outs = []  # (type, name)
        self.list_out = None
        self.input_span = None
        self.rest(parts[self.taken:])
        self.name = self.member_name()

    def place(self, parts):
        """The class of which it is a member, or None."""
        self.taken = 0
        if not parts or bare(parts[0]["type"]) not in OWNERS or not parts[0]["type"].endswith("*"):
            return None, False
        self.taken = 1
        const = parts[0]["type"].startswith("const ")
        if bare(parts[0]["type"]) == "thud_world" and len(parts) > 1 and parts[1]["type"] in HANDLES:
            noun = HANDLES[parts[1]["type"]]
            if self.c.startswith((f"thud_{noun}_", "thud_shape_create_")) or self.c.endswith("_of"):
                self.taken = 2
                return noun, True
        return OWNERS[bare(parts[0]["type"])], const

    def member_name(self):
        name = self.c.removeprefix("thud_")
        if self.owner is None:
            return {"world_make": "make_world"}.get(name, name)
        noun = {"world_ref": "world"}.get(self.owner, self.owner)
        name = name.removeprefix("shape_") if name.startswith("shape_create_") else name
        name = name.removeprefix(f"{noun}_")
        name = re.sub(r"^(body|joint|contact)_(create|make|decide)", r"\2_\1", name)
        return name.removesuffix("_of") if self.inline else name

    def add(self, declaration, argument, default=None):
        self.parameters.append((declaration, default))
        self.arguments.append(argument)

    def rest(self, parts):
        at = 0
        while at < len(parts):
            kind, name = parts[at]["type"], parts[at]["name"]
            following = parts[at + 1] if at + 1 < len(parts) else {"type": "", "name": ""}
            after = parts[at + 2] if at + 2 < len(parts) else {"type": "", "name": ""}
            pointer = kind.endswith("*")
            counted = pointer and following["type"] == "int" and following["name"] in ("count", "slots")
            at += 1
            if bare(kind) in CALLBACKS:
                self.kept = "_set_" in self.c
                self.templates.append("class F")
                self.parameters.append((f"F {'&' if self.kept else '&&'}{name}", None))
                kept = "F" if self.kept else "std::remove_reference_t<F>"
                self.arguments += [f"detail::call_{bare(kind).removeprefix('thud_')}<{kept}>",
                                   f"detail::context({name})"]
                at += 1
            elif bare(kind) == "void" and following["type"] == "size_t":
                self.add(f"{'const_' * kind.startswith('const')}bytes {name.removeprefix('out_')}",
                         f"{name.removeprefix('out_')}.data()")
                self.arguments.append(f"{name.removeprefix('out_')}.size()")
                at += 1
            elif kind == "thud_bytes":
                self.add(f"const_bytes {name}", name)
            elif kind == "void *":
                assert (self.c, name) in RAW, (self.c, name)
                self.add(f"void *{name}", name)
            elif pointer and following["name"] == "capacity" and after["name"] == "out_count":
                self.add(f"span<{bare(kind)}> {name}", f"{name}.data()")
                self.arguments += [f"detail::count({name}.size())", "&made.value"]
                self.outs.append(("int", "out_count"))
                at += 2
            elif counted and not re.match(r"out(_|$)", name):
                self.input_span = name
                self.add(f"span<{cpp(kind).removesuffix('*').strip()}> {name}", f"{name}.data()")
                self.arguments.append(f"detail::count({name}.size())")
                at += 1
            elif kind.endswith("**") and following["name"] == "out_count":
                self.list_out = kind.removesuffix("**").strip()
                self.arguments += ["&data", "&count"]
                at += 1
            elif PARALLEL.get(self.c) == name:
                self.add(f"span<{bare(kind)}> {name}", f"{name}.data()")
                self.parallel = name
            elif (self.c, name) in RAW:
                self.add(f"{kind}{name}", name)
            elif pointer and re.match(r"out(_|$)", name):
                self.outs.append((kind[:-1].strip(), name))
                self.arguments.append(f"OUT:{name}")
            elif kind == "const char *":
                self.add(f"const char *{name}", name)
            elif kind.startswith("const ") and pointer:
                default = "nullptr" if name in OPTIONAL else None
                made = f"thud_default_{bare(kind).removeprefix('thud_')}"
                if made in NAMES and not NAMES[made]["parameters"] and kind.endswith("_def *"):
                    default = f"{made}()"
                self.add(f"in<{bare(kind)}> {name}", f"{name}.get()", default)
            elif pointer and bare(kind) in STRUCTS:
                self.add(f"{bare(kind)} &{name}", f"&{name}")
            else:
                assert not pointer, (self.c, name)
                self.add(f"{cpp(kind)} {name}", name, DEFAULTS.get((self.c, name)))
        # What has a default stands last.
        defs = [one for one in self.parameters if one[1] and one[1].startswith("thud_default_")]
        self.parameters = [one for one in self.parameters if one not in defs] + defs
        for place in range(len(self.parameters) - 1):
            if any(default is None for _, default in self.parameters[place + 1:]):
                self.parameters[place] = (self.parameters[place][0], None)

    # ---- what it returns ----

    def value_struct(self):
        """The fields of the struct that the function returns, or None."""
        outs = self.values()
        return outs if len(outs) > 1 else None

    def found(self):
        return self.outs and self.outs[0][1] in FOUND and len(self.outs) > 1

    def values(self):
        outs = self.outs[1:] if self.found() else self.outs
        return [(cpp(kind), "value" if name == "out" else name.removeprefix("out_")) for kind, name in outs]

    def value_type(self):
        outs = self.values()
        if len(outs) > 1:
            return f"{self.c.removeprefix('thud_').replace('get_', '')}_values"
        return outs[0][0] if outs else "void"

    def handle(self):
        """The class of the handle that is its only output, or None."""
        kind = self.value_type() if self.returns == "thud_result" else self.returns
        return HANDLES.get(kind) if self.owner else None

    def type(self):
        if self.returns == "thud_result":
            if self.list_out:
                return f"result<span<{self.list_out}>>"
            kind = self.handle() or self.value_type()
            kind = "" if kind == "void" else kind
            return f"result<{'std::optional<' * bool(self.found())}{kind}{'>' * bool(self.found())}>"
        if self.returns == "_Bool" and self.outs:
            return f"std::optional<{self.value_type()}>"
        if self.returns == "void" and self.outs:
            return self.value_type()
        if self.c == "thud_world_make":
            return "world"
        if self.returns == "thud_events":
            return "event_lists"
        if self.inline and self.outs:
            return f"span<{bare(self.returns).join(('const ', ''))}>"
        return self.handle() or cpp(self.returns)

    def declaration(self, defaults=True, scope=""):
        parameters = ", ".join(declared + (f" = {default}" if default and defaults else "")
                               for declared, default in self.parameters)
        template = f"template <{', '.join(self.templates)}> " if self.templates else ""
        keyword = "" if scope or self.owner else "inline "
        return f"{template}{keyword}{self.type()} {scope}{self.name}({parameters})" + \
            " const" * (bool(self.owner) and self.const)

    def self_arguments(self):
        if self.owner in HANDLES.values():
            return ["world", "id"]
        return {None: [], "world_ref": ["world_"]}.get(self.owner, ["get()"])

    def call(self, places):
        """The call of C, with the places of its outputs."""
        arguments = self.self_arguments() + [places.get(one.removeprefix("OUT:"), one) if
                                             one.startswith("OUT:") else one for one in self.arguments]
        return f"{self.c}({', '.join(arguments)})"

    def body(self):
        values, places = self.values(), {}
        target = "made" if self.returns != "thud_result" or self.found() or self.handle() else "made.value"
        outs = self.outs[1:] if self.found() else self.outs
        for (_, name), (_, field) in zip(outs, values):
            places[name] = f"&{target}.{field}" if len(values) > 1 else f"&{target}"
        if self.found():
            places[self.outs[0][1]] = "&found"
        world = "world" if self.owner in HANDLES.values() else "world_"
        lines = []
        if hasattr(self, "parallel"):
            refused = f"return {{detail::check(THUD_ERROR_INVALID), {{}}}};" if self.outs else \
                "return {detail::check(THUD_ERROR_INVALID)};"
            lines.append(f"if (!{self.parallel}.empty() && {self.parallel}.size() < {self.input_span}.size()) "
                         f"{{ {refused} }}")
        if self.returns == "thud_result":
            if self.list_out:
                lines += [f"{self.list_out} *data = nullptr; int count = 0;",
                          f"thud_result code = detail::check({self.call(places)});",
                          "return {code, {data, static_cast<std::size_t>(count)}};"]
            elif self.found():
                lines += [f"{self.value_type()} made; bool found = false;",
                          f"thud_result code = detail::check({self.call(places)});",
                          "if (!found) { return {code, std::nullopt}; }", "return {code, made};"]
            elif self.handle():
                lines += [f"{self.values()[0][0]} made{{}};",
                          f"thud_result code = detail::check({self.call(places)});",
                          f"return {{code, {{{world}, made}}}};"]
            elif not values:
                lines.append(f"return {{detail::check({self.call(places)})}};")
            else:
                lines += [f"{self.type()} made{{detail::unwritten()}};",
                          f"made.settle(detail::check({self.call(places)}));", "return made;"]
        elif self.returns == "_Bool" and self.outs:
            lines += [f"{self.value_type()} made;",
                      f"if (!{self.call(places)}) {{ return std::nullopt; }}", "return made;"]
        elif self.returns == "void" and self.outs:
            lines += [f"{self.value_type()} made{{}};", f"{self.call(places)};", "return made;"]
        elif self.c == "thud_world_make":
            lines.append(f"return world({self.call(places)});")
        elif self.returns == "thud_events":
            lines.append(f"return event_lists({self.call(places)});")
        elif self.inline and self.outs:
            lines += [f"int count = 0; {self.returns} data = {self.call({'out_count': '&count'})};",
                      "return {data, static_cast<std::size_t>(count)};"]
        elif self.handle():
            lines.append(f"return {{{world}, {self.call(places)}}};")
        else:
            lines.append(f"return {self.call(places)};" if self.returns != "void" else f"{self.call(places)};")
        return "\n".join(lines)

    def without_temporaries(self):
        """What stands beside a declaration whose callable is kept."""
        if not self.kept:
            return ""
        kept = next(declared for declared, _ in self.parameters if declared.startswith("F &"))
        others = ", ".join(declared for declared, _ in self.parameters if declared != kept)
        others += ", " * bool(others)
        const = " const" * self.const
        return f"template <class F> result<> {self.name}({others}const F &&){const} = delete;\n" \
               f"result<> {self.name}({others}std::nullptr_t){const};\n"

    def without_callable(self, scope):
        """The definition that passes null in its place."""
        if not self.kept:
            return ""
        others = ", ".join(declared for declared, _ in self.parameters if not declared.startswith("F &"))
        others += ", " * bool(others)
        arguments = ["nullptr" if one.startswith(("detail::call_", "detail::context")) else one
                     for one in self.arguments]
        call = f"{self.c}({', '.join(self.self_arguments() + arguments)})"
        return f"inline result<> {scope}{self.name}({others}std::nullptr_t){' const' * self.const} " \
               f"{{ return {{detail::check({call})}}; }}\n\n"


def aliases(calls):
    free = {call.name for call in calls if call.owner is None}
    taken = {*HANDLES.values(), "world", "rollback", "threads", "result"}
    lines = []
    for entry in [*API["structs"], *API["enums"], *API["aliases"]]:
        name = entry["name"].removeprefix("thud_")
        if entry["name"] == "thud_bytes" or name in taken:
            continue
        assert name not in free, f"{name} is a function, too"
        lines.append(f"using {name} = {entry['name']};\n")
    return "".join(lines)


def trampoline_parameters(parameters):
    """Of a C callback with these (type, name): its parameters, and what the callable gets."""
    declared, passed = [], []
    counted = ("int", "count") in parameters
    for kind, name in parameters:
        declared.append(f"{cpp(kind)}{' ' * (not kind.endswith('*'))}{name}")
        if name == "context" or (kind, name) == ("int", "count"):
            continue
        if kind == "thud_world *":
            passed.append(f"world_ref({name})")
        elif kind == "const thud_world *":
            passed.append(f"static_cast<const world_ref &>(world_ref(const_cast<thud_world *>({name})))")
        elif kind.endswith("*") and bare(kind) in STRUCTS and counted:
            passed.append(f"span<{kind.removesuffix('*').strip()}>({name}, static_cast<std::size_t>(count))")
        else:
            passed.append("*" * (kind.endswith("*") and bare(kind) in STRUCTS) + name)
    return ", ".join(declared), ", ".join(passed)


def trampolines():
    """A function for each type of callback that a parameter has: it calls the callable that is its
    context."""
    used = {bare(part["type"]) for function in API["functions"] for part in function["parameters"]}
    lines = []
    for entry in API["callbacks"]:
        parameters = [(part["type"], part["name"]) for part in entry["parameters"]]
        if entry["name"] not in used or parameters[-1] != ("void *", "context"):
            continue
        declared, passed = trampoline_parameters(parameters)
        lines.append(f"template <class F> {cpp(entry['returns'])} call_{entry['name'].removeprefix('thud_')}"
                     f"({declared}) noexcept {{ return (*static_cast<F *>(context))({passed}); }}\n\n")
    return "".join(lines)


def field_callback(field):
    """(what it returns, parameters) of a field that is a callback with a context; None for another."""
    kind = field["type"]
    if bare(kind) in CALLBACKS:
        entry = CALLBACKS[bare(kind)]
        parameters = [(part["type"], part["name"]) for part in entry["parameters"]]
        return (entry["returns"], parameters) if parameters[-1] == ("void *", "context") else None
    match = re.fullmatch(r"(.*?)\s*\(\*\)\((.*), void \*\)", kind)
    if not match:
        return None
    parameters = [(part, f"a{number}") for number, part in enumerate(match[2].split(", "))]
    return match[1], [*parameters, ("void *", "context")]


def connections():
    """connect() of each struct that has callbacks and their `context`."""
    names, lines = {}, []
    for entry in API["structs"]:
        if not any(field["name"] == "context" for field in entry["fields"]):
            continue
        fields = [(field["name"], field_callback(field)) for field in entry["fields"]]
        fields = [(name, found) for name, found in fields if found]
        body = []
        for name, (returned, parameters) in fields:
            names[name] = True
            declared, passed = trampoline_parameters(parameters)
            passes = f"return static_cast<C *>(context)->{name}({passed});"
            body.append(f"if constexpr (detail::has_{name}<C>::value) {{ callbacks.{name} = []({declared}) "
                        f"noexcept -> {cpp(returned)} {{ {passes} }}; }}")
        any_of = " || ".join(f"detail::has_{name}<C>::value" for name, _ in fields)
        lines.append(
            f"template <class C> void connect({entry['name']} &callbacks, C &object) noexcept {{\n"
            f"static_assert({any_of}, \"no member has the name of a callback\");\n" + "\n".join(body) +
            "\ncallbacks.context = detail::context(object); }\n"
            f"template <class C> void connect({entry['name']} &, const C &&) = delete;\n\n")
    has = "".join(f"template <class C, class = void> struct has_{name} : std::false_type {{}};\n"
                  f"template <class C> struct has_{name}<C, std::void_t<decltype(&C::{name})>> "
                  f": std::true_type {{}};\n" for name in names)
    return has, "".join(lines)


def event_lists():
    """thud_events with spans."""
    fields = STRUCTS["thud_events"]["fields"]
    counts = {field["name"] for field in fields if field["name"].endswith("_count")}
    shown, made = [], []
    for field in fields:
        if field["name"] in counts:
            continue
        name = field["name"]
        count = name + "_count"
        if count not in counts:
            count = name.rsplit("_", 1)[0] + "_count"
        assert count in counts, name
        shown.append(f"span<const {bare(field['type'])}> {name};\n")
        made.append(f"{name}(of.{name}, static_cast<std::size_t>(of.{count}))")
    return ("// thud_events as spans.\nstruct event_lists {\n" + "".join(shown) +
            "\nexplicit event_lists(const thud_events &of) noexcept : " +
            ", ".join(made) + " {}\n};\n\n")


HANDLE = """// A {noun} of a world, by its handle: small, copied freely, and no owner. One that was destroyed is
// refused as THUD_ERROR_STALE.
struct {noun} {{
    thud_world *world = nullptr;
    thud_{noun}_id id{{}};

    operator thud_{noun}_id() const noexcept {{ return id; }}
    // The index of its slot in arrays of the world, or -1 of the null handle.
    int slot() const noexcept {{ return static_cast<int>(id.index1) - 1; }}
    friend bool operator==(const {noun} &a, const {noun} &b) noexcept {{
        return a.world == b.world && a.id.index1 == b.id.index1 && a.id.generation == b.id.generation;
    }}
    friend bool operator!=(const {noun} &a, const {noun} &b) noexcept {{ return !(a == b); }}

{members}}};

"""

WORLD = """// A world that belongs to someone else, as callbacks get it.
class world_ref {{
protected:
    thud_world *world_ = nullptr;

public:
    world_ref() noexcept = default;
    world_ref(thud_world *world) noexcept : world_(world) {{}}
    thud_world *get() const noexcept {{ return world_; }}
    explicit operator bool() const noexcept {{ return world_ != nullptr; }}
    // The object of a handle.
    thud::body at(thud_body_id id) const noexcept {{ return {{world_, id}}; }}
    thud::shape at(thud_shape_id id) const noexcept {{ return {{world_, id}}; }}
    thud::joint at(thud_joint_id id) const noexcept {{ return {{world_, id}}; }}

{members}}};

// A world that is destroyed with this object. One that could not be created is false, and refuses
// every call as THUD_ERROR_NULL.
class world : public world_ref {{
public:
    world(std::nullptr_t = nullptr) noexcept {{}}
    explicit world(thud_world *owned) noexcept : world_ref(owned) {{}}
    explicit world(const thud_world_def &def) {{ detail::check(thud_world_create(&def, &world_)); }}
    THUD_CREATES static result<world> create(in<thud_world_def> def) {{
        thud_world *made = nullptr;
        thud_result code = detail::check(thud_world_create(def.get(), &made));
        return {{code, world(made)}};
    }}
    world(const world &) = delete;
    world(world &&other) noexcept : world_ref(std::exchange(other.world_, nullptr)) {{}}
    world &operator=(world other) noexcept {{
        std::swap(world_, other.world_);
        return *this;
    }}
    ~world() {{ thud_world_destroy(world_); }}
    // The world, which is from now on the caller's to destroy.
    thud_world *release() noexcept {{ return std::exchange(world_, nullptr); }}
}};

"""

OWNING = """// {what}
class {noun} {{
    thud_{noun} *{noun}_ = nullptr;

public:
    {noun}() noexcept = default;
    {create}
    {noun}(const {noun} &) = delete;
    {noun}({noun} &&other) noexcept : {noun}_(std::exchange(other.{noun}_, nullptr)) {{}}
    {noun} &operator=({noun} other) noexcept {{
        std::swap({noun}_, other.{noun}_);
        return *this;
    }}
    ~{noun}() {{ thud_{noun}_destroy({noun}_); }}
    thud_{noun} *get() const noexcept {{ return {noun}_; }}
    explicit operator bool() const noexcept {{ return {noun}_ != nullptr; }}

{members}}};

"""

LOG = """// A log for a world that is created, as world.set_log() sets it later.
template <class F> void connect(thud_world_def &def, F &log) noexcept {
    def.log = detail::call_log_fn<F>;
    def.log_context = detail::context(log);
}
template <class F> void connect(thud_world_def &, const F &&) = delete;

"""

ROLLBACK = """THUD_CREATES static result<rollback> create(world_ref world, in<thud_rollback_options> options) {
        result<rollback> made;
        made.code = detail::check(thud_rollback_create(world.get(), options.get(), &made->rollback_));
        return made;
    }"""
THREADS = """THUD_CREATES static result<threads> create(int workers, in<thud_allocator> allocator = nullptr) {
        result<threads> made;
        made.code = detail::check(thud_threads_create(workers, allocator.get(), &made->threads_));
        return made;
    }"""


def classes(calls):
    text = "class world;\nstruct body;\nstruct shape;\nstruct joint;\n\n"
    structs = [call for call in calls if call.value_struct()]
    for call in structs:
        fields = "".join(f"{kind}{' ' * (not kind.endswith('*'))}{name};\n"
                         for kind, name in call.value_struct())
        text += f"// Of {call.c}.\nstruct {call.value_type()} {{\n{fields}}};\n\n"
    text += event_lists()
    def members(owner):
        return "".join("THUD_CREATES " * call.name.startswith("create_") + call.declaration() + ";\n" + call.without_temporaries()
                       for call in calls if call.owner == owner)

    for noun in HANDLES.values():
        text += HANDLE.format(noun=noun, members=members(noun))
    text += WORLD.format(members=members("world_ref"))
    text += OWNING.format(noun="rollback", members=members("rollback"), create=ROLLBACK,
                          what="Networked play; destroyed with this object, which its world outlives.")
    text += OWNING.format(noun="threads", members=members("threads"), create=THREADS,
                          what="A pool of threads, which outlives the worlds that use it.")
    has, connects = connections()
    text += "namespace detail {\n\n" + trampolines() + has + "\n} // namespace detail\n\n"
    text += "// Callbacks that are the members of an object of the same names; the object outlives their use.\n"
    text += connects + LOG
    for call in calls:
        scope = f"{call.owner}::" if call.owner else ""
        head = call.declaration(defaults=not call.owner, scope=scope)
        if call.owner and not call.templates:
            head = "inline " + head
        text += f"{head} {{\n{call.body()}\n}}\n\n" + call.without_callable(scope)
    return text


def made_text(text, clang_format):
    calls = [Call(function) for function in API["functions"] if function["name"] not in OWN]
    names = [(call.owner, call.name) for call in calls]
    double = {name for name in names if names.count(name) > 1}
    assert not double, f"two functions of one name: {double}"
    for part, lines in (("aliases", aliases(calls)), ("classes", classes(calls))):
        begin = text.index(MADE.format(part)) + len(MADE.format(part))
        text = text[:begin] + "\n" + lines + text[text.index(END, begin):]
    done = subprocess.run([clang_format, "--assume-filename", str(HEADER)], input=text, text=True,
                          capture_output=True, check=True)
    return done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--clang-format", default="clang-format-16")
    parser.add_argument("--check", action="store_true", help="write nothing; compare")
    options = parser.parse_args()
    there = HEADER.read_text(encoding="utf-8")
    text = made_text(there, options.clang_format)
    if options.check:
        if there != text:
            print(f"{HEADER.relative_to(ROOT)} is not what api.json says: run tools/bind_cpp.py")
        return there != text
    HEADER.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
