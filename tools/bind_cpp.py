#!/usr/bin/env python3
"""Makes the members and functions of engine/include/thud/thud.hpp from bindings/api.json.

    bind_cpp.py [--clang-format CLANG_FORMAT] [--check]

Between the lines `made from bindings/api.json` and `end` the file is made, the rest is written by
hand. With --check nothing is written: the exit status is 1 if the file is not as it would be made.

Signatures are read by signatures.py. Of its roles, `input` is in<T>, `span`, `list` and `parallel` are
span<T>, `view` a span that is returned, `read` and `written` const_bytes and bytes, and `callback` is
a callable by reference, without temporaries where a setter keeps it. Outputs are returned: one value,
or a struct of several, in a std::optional where they may be missing."""

import re
import subprocess
import sys

import made
from signatures import (API, CALLBACKS, FUNCTIONS, HANDLES, OWN, RECORDING, RECORDINGS, ROOT, STRUCTS, Signature,
                        bare)

HEADER = ROOT / "engine/include/thud/thud.hpp"
MADE = "// ---- made from bindings/api.json by tools/bind_cpp.py: {} ----\n"
END = "// ---- end ----\n"
# Inputs that may be left out.
OPTIONAL = {"filter", "options", "calls", "allocator"}
DEFAULTS = {("thud_poses_of", "origin"): "{}", ("thud_poses_of", "alpha"): "1.0",
            ("thud_world_get_poses", "origin"): "{}", ("thud_world_get_poses", "alpha"): "1.0",
            ("thud_world_advance", "max_steps"): "4"}


def cpp(kind):
    return kind.replace("_Bool", "bool")


class Call(Signature):
    """A function as C++ has it."""

    def __init__(self, function):
        super().__init__(function)
        if self.owner == "world":
            self.owner = "world_ref"
        if self.owner is None:
            self.name = {"world_make": "make_world"}.get(self.name, self.name)
        self.parameters = []  # (declaration, default or None)
        self.arguments = []
        for part in self.parts:
            self.add(part)
        # What has a default stands last.
        defs = [one for one in self.parameters if one[1] and one[1].startswith("thud_default_")]
        self.parameters = [one for one in self.parameters if one not in defs] + defs
        for place in range(len(self.parameters) - 1):
            if any(default is None for _, default in self.parameters[place + 1:]):
                self.parameters[place] = (self.parameters[place][0], None)
        self.templates = ["class F"] * self.has("callback")
        self.kept = self.has("callback") and "_set_" in self.c

    def add(self, part):
        """Adds the parameter and the arguments that a part is."""
        role, kind, name = part
        said, default, arguments = None, None, [name]
        if role == "callback":
            kept = "_set_" in self.c
            said = f"F {'&' if kept else '&&'}{name}"
            arguments = [f"detail::call_{kind.removeprefix('thud_')}<"
                         f"{'F' if kept else 'std::remove_reference_t<F>'}>", f"detail::context({name})"]
        elif role in ("read", "written"):
            name = name.removeprefix("out_")
            said = f"{'const_' * (role == 'read')}bytes {name}"
            arguments = [name] if kind == "thud_bytes" else [f"{name}.data()", f"{name}.size()"]
        elif role in ("list", "span"):
            said, arguments = f"span<{cpp(kind)}> {name}", [f"{name}.data()", f"detail::count({name}.size())"]
            arguments += ["&made.value"] * (role == "list")
        elif role == "parallel":
            said, arguments = f"span<{kind}> {name}", [f"{name}.data()"]
        elif role == "view":
            arguments = ["&data", "&count"]
        elif role == "found":
            arguments = ["&found"]
        elif role == "out":
            arguments = [f"OUT:{name}"]
        elif role == "input":
            default = "nullptr" if name in OPTIONAL else None
            made = f"thud_default_{kind.removeprefix('thud_')}"
            if made in FUNCTIONS and not FUNCTIONS[made]["parameters"] and kind.endswith("_def"):
                default = f"{made}()"
            said, arguments = f"in<{kind}> {name}", [f"{name}.get()"]
        elif role == "changed":
            said, arguments = f"{kind} &{name}", [f"&{name}"]
        elif role == "string":
            said = f"const char *{name}"
        else:
            said = f"{cpp(kind)}{' ' * (not kind.endswith('*'))}{name}"
            default = DEFAULTS.get((self.c, name))
        if said:
            self.parameters.append((said, default))
        self.arguments += arguments

    # ---- what it returns ----

    def values(self):
        if self.has("list"):
            return [("int", "count")]
        return [(cpp(kind), name) for kind, name in self.outs()]

    def value_struct(self):
        """The fields of the struct that the function returns, or None."""
        outs = self.values()
        return outs if len(outs) > 1 else None

    def value_type(self):
        outs = self.values()
        if len(outs) > 1:
            return f"{self.c.removeprefix('thud_').replace('get_', '')}_values"
        return outs[0][0] if outs else "void"

    def handle(self):
        """The class of the handle that is its only output, or None."""
        kind = self.value_type() if self.returns == "thud_result" else self.returns
        return HANDLES.get(kind) if self.owner else None

    def view(self):
        return next((part.type for part in self.parts if part.role == "view"), None)

    def type(self):
        if self.returns == "thud_result":
            if self.has("view"):
                return f"result<span<const {self.view()}>>"
            kind = self.handle() or self.value_type()
            kind = "" if kind == "void" else kind
            return f"result<std::optional<{kind}>>" if self.has("found") else f"result<{kind}>"
        if self.returns == "_Bool" and self.outs():
            return f"std::optional<{self.value_type()}>"
        if self.returns == "void" and self.outs():
            return self.value_type()
        if self.c == "thud_world_make":
            return "world"
        if self.returns == "thud_events":
            return "event_lists"
        if self.inline and self.outs():
            return f"span<const {bare(self.returns)}>"
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
        outs, places = self.outs(), {}
        plain = self.returns == "thud_result" and not self.has("found") and not self.handle()
        target = "made.value" if plain else "made"
        for part in self.parts:
            if part.role == "out":
                field = part.name.removeprefix("out_")
                field = "value" if part.name == "out" else field
                places[part.name] = f"&{target}.{field}" if len(outs) > 1 else f"&{target}"
        world = "world" if self.owner in HANDLES.values() else "world_"
        call = self.call(places)
        lines = []
        for part in self.parts:
            if part.role == "parallel":
                span = next(one.name for one in self.parts if one.role == "span")
                refused = "return {detail::check(THUD_ERROR_INVALID)" + ", {}" * bool(outs) + "};"
                lines.append(f"if (!{part.name}.empty() && {part.name}.size() < {span}.size()) {{ {refused} }}")
        if self.returns == "thud_result":
            if self.has("view"):
                lines += [f"const {self.view()} *data = nullptr; int count = 0;",
                          f"thud_result code = detail::check({call});",
                          "return {code, {data, static_cast<std::size_t>(count)}};"]
            elif self.has("found"):
                lines += [f"{self.value_type()} made; bool found = false;",
                          f"thud_result code = detail::check({call});",
                          "if (!found) { return {code, std::nullopt}; }", "return {code, made};"]
            elif self.handle():
                lines += [f"{self.values()[0][0]} made{{}};", f"thud_result code = detail::check({call});",
                          f"return {{code, {{{world}, made}}}};"]
            elif not self.values():
                lines.append(f"return {{detail::check({call})}};")
            else:
                lines += [f"{self.type()} made{{detail::unwritten()}};",
                          f"made.settle(detail::check({call}));", "return made;"]
        elif self.returns == "_Bool" and outs:
            lines += [f"{self.value_type()} made;", f"if (!{call}) {{ return std::nullopt; }}", "return made;"]
        elif self.returns == "void" and outs:
            lines += [f"{self.value_type()} made{{}};", f"{call};", "return made;"]
        elif self.type() in ("world", "event_lists"):
            lines.append(f"return {self.type()}({call});")
        elif self.inline and outs:
            lines += [f"int count = 0; {self.returns} data = {self.call({'out_count': '&count'})};",
                      "return {data, static_cast<std::size_t>(count)};"]
        elif self.handle():
            lines.append(f"return {{{world}, {call}}};")
        else:
            lines.append(f"{'return ' * (self.returns != 'void')}{call};")
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
        if entry["header"] == RECORDING or not any(field["name"] == "context" for field in entry["fields"]):
            continue
        fields = [(field["name"], field_callback(field)) for field in entry["fields"]]
        fields = [(name, found) for name, found in fields if found]
        body = []
        for name, (returned, parameters) in fields:
            names[name] = True
            declared, passed = trampoline_parameters(parameters)
            passes = f"return static_cast<C *>(context)->{name}({passed});"
            body.append(f"if constexpr (detail::has_{name}<C>()) {{ callbacks.{name} = []({declared}) "
                        f"noexcept -> {cpp(returned)} {{ {passes} }}; }}")
        any_of = " || ".join(f"detail::has_{name}<C>()" for name, _ in fields)
        lines.append(
            f"template <class C> void connect({entry['name']} &callbacks, C &object) noexcept {{\n"
            f"static_assert({any_of}, \"no member has the name of a callback\");\n" + "\n".join(body) +
            "\ncallbacks.context = detail::context(object); }\n"
            f"template <class C> void connect({entry['name']} &, const C &&) = delete;\n\n")
    has = HAS + "".join(f"THUD_HAS({name})\n" for name in names) + "#undef THUD_HAS\n"
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

HAS = """// has_NAME(): whether a class has a member of this name. A class that derives from it and from one
// that has the name as well finds it in both, also where it is overloaded, a template or private. None
// derives from a union or a final class: there a public member that is not overloaded is found.
template <class C>
constexpr bool may_be_base = !std::is_final<C>::value && !std::is_union<C>::value;
#define THUD_HAS(NAME) \\
    struct named_##NAME { int NAME; }; \\
    template <class C> struct both_##NAME : C, named_##NAME {}; \\
    template <class C, class = void> struct lacks_##NAME : std::false_type {}; \\
    template <class C> \\
    struct lacks_##NAME<C, std::void_t<decltype(&both_##NAME<C>::NAME)>> : std::true_type {}; \\
    template <class C, class = void> struct shows_##NAME : std::false_type {}; \\
    template <class C> \\
    struct shows_##NAME<C, std::void_t<decltype(&C::NAME)>> : std::true_type {}; \\
    template <class C> constexpr bool has_##NAME() { \\
        using plain = std::remove_cv_t<C>; \\
        if constexpr (may_be_base<plain>) return !lacks_##NAME<plain>::value; \\
        else return shows_##NAME<plain>::value; \\
    }
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
    calls = [Call(function) for function in API["functions"] if function["name"] not in OWN | RECORDINGS]
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
    parser = made.parser_of(__doc__)
    parser.add_argument("--clang-format", default="clang-format-16")
    options = parser.parse_args()
    text = made_text(HEADER.read_text(encoding="utf-8"), options.clang_format)
    return made.write({HEADER: text}, options.check, "bind_cpp.py")


if __name__ == "__main__":
    sys.exit(main())
