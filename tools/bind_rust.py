#!/usr/bin/env python3
"""Makes the declarations and calls of the Rust crates in bindings/rust from bindings/api.json.

    bind_rust.py [--check]

thud-sys/src/lib.rs is all of C: types, constants, functions but those that are inline. thud/src/calls.rs
has the safe calls: those whose structs have no pointers, or are wrapped by hand in thud/src/lib.rs. The
crates have the version of the headers. With --check nothing is written: the exit status is 1 if a file is not as it would be made. Signatures are
read by signatures.py."""

import re
import sys

import made
from signatures import API, CALLBACKS, ENUMS, FUNCTIONS, HANDLES, OWN, ROOT, STRUCTS, Signature, bare

SYS = ROOT / "bindings/rust/thud-sys/src/lib.rs"
WORKSPACE, CRATE = ROOT / "bindings/rust/Cargo.toml", ROOT / "bindings/rust/thud/Cargo.toml"
CALLS = ROOT / "bindings/rust/thud/src/calls.rs"
SCALARS = {"_Bool": "bool", "float": "f32", "double": "f64", "int": "c_int", "unsigned int": "c_uint",
           "size_t": "usize", "char": "c_char", "void": "c_void",
           **{f"{sign}int{bits}_t": f"{sign or 'i'}{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)}}
# Objects of the engine that live as long as the program: a pointer to one may be null, but not wrong.
STATIC = {entry["type"].removeprefix("const ") for entry in API["variables"]
          if STRUCTS[entry["type"].removeprefix("const ")]["opaque"]}
KEYWORDS = {"type", "where", "move", "ref", "fn", "in", "match", "loop", "box", "use", "mod"}
# Wrapped by hand: the type of the parameter, and what C gets of it.
WRAPPED = {"thud_terrain": ("&Terrain<'_>", "&{}.raw"), "thud_quality": ("&Quality", "&{}.0")}
# Inputs that may be null.
OPTIONAL = {"filter", "options", "mass", "rule"}
INTO = {"thud_vec2": "Vec2", "thud_pos": "Pos"}
# What lib.rs has by hand, and what belongs inside a callback, where no world is to be had.
LEFT_OUT = OWN | {"thud_world_make", "thud_contact_decide", "thud_world_get_events",
                  "thud_world_get_poses"}


def rust(kind):
    """A type of C as Rust has it."""
    array = re.fullmatch(r"(.*?)\[(\d+)\]", kind)
    if array:
        return f"[{rust(array[1])}; {array[2]}]"
    pointer = re.fullmatch(r"(.*?)\s*\(\*\)\((.*)\)", kind)
    if pointer:
        return "Option<" + function_type(pointer[1], pointer[2].split(", ")) + ">"
    if kind.endswith("*"):
        inner = kind[:-1].strip()
        if inner in CALLBACKS:
            return f"Option<{inner}>"
        if inner.startswith("const ") and not inner.endswith("*"):
            inner = inner.removeprefix("const ")
            return f"Option<&'static {inner}>" if inner in STATIC else f"*const {rust(inner)}"
        return f"*mut {rust(inner)}"
    return SCALARS.get(kind, kind)


def function_type(returns, kinds):
    result = "" if returns == "void" else f" -> {rust(returns)}"
    return f"unsafe extern \"C\" fn({', '.join(rust(kind) for kind in kinds)}){result}"


def word(name):
    return f"r#{name}" if name in KEYWORDS else name


def camel(name):
    if name == "thud_result":
        return "Code"
    return "".join(part.capitalize() for part in name.removeprefix("thud_").split("_"))


def plain(kind):
    """Whether any bits of such a value that safe code can make are harmless."""
    array = re.fullmatch(r"(.*?)\[\d+\]", kind)
    if array:
        return plain(array[1])
    if kind.endswith("*"):
        return kind.startswith("const ") and bare(kind) in STATIC
    if kind in STRUCTS:
        return not STRUCTS[kind]["opaque"] and all(plain(field["type"]) for field in STRUCTS[kind]["fields"])
    aliases = {entry["name"]: entry["type"] for entry in API["aliases"]}
    return plain(aliases[kind]) if kind in aliases else kind in SCALARS and kind != "void" or kind in ENUMS


def declarations():
    lines = ["//! The C interface of thud, made from its headers by tools/bind_rust.py. What each item is for,",
             "//! units, ranges and errors stand there. `thud` has it for safe code.",
             "#![allow(non_camel_case_types, clippy::approx_constant)]", "#![no_std]", "",
             "use core::ffi::{c_char, c_int, c_uint, c_void};", ""]
    for entry in API["constants"]:
        kind = "i64" if isinstance(entry["value"], int) else "f64"
        lines.append(f"pub const {entry['name']}: {kind} = {entry['value']!r};")
    for name, entry in ENUMS.items():
        lines.append(f"pub type {name} = c_uint;")
        lines += [f"pub const {value['name']}: {name} = {value['value']};" for value in entry["values"]]
    for name, entry in CALLBACKS.items():
        lines.append(f"pub type {name} = {function_type(entry['returns'], [p['type'] for p in entry['parameters']])};")
    lines += [f"pub type {entry['name']} = {entry['type']};" for entry in API["aliases"]]
    for name, entry in STRUCTS.items():
        lines += ["", "#[repr(C)]"]
        if entry["opaque"]:
            lines += ["#[derive(Debug)]", f"pub struct {name} {{", "    _private: [u8; 0],", "}"]
            continue
        compared = ", PartialEq" * name.endswith(("_id", "vec2", "thud_pos")) + ", Eq, Hash" * name.endswith("_id")
        lines += [f"#[derive(Clone, Copy{', Debug' * plain(name)}{compared})]", f"pub struct {name} {{"]
        lines += [f"    pub {word(field['name'])}: {rust(field['type'])}," for field in entry["fields"]]
        lines.append("}")
    lines += ["", "// Objects that never change.", "unsafe impl Sync for thud_quality {}", ""]
    for kind, scalar in (("thud_vec2", "f32"), ("thud_pos", "f64")):
        lines += [f"impl From<({scalar}, {scalar})> for {kind} {{",
                  f"    fn from((x, y): ({scalar}, {scalar})) -> Self {{", "        Self { x, y }", "    }", "}", ""]
    for name, entry in FUNCTIONS.items():
        if name.startswith("thud_default_") and not entry["parameters"]:
            lines += [f"impl Default for {entry['returns']} {{", "    fn default() -> Self {",
                      f"        unsafe {{ {name}() }}", "    }", "}", ""]
    lines.append('extern "C" {')
    for entry in API["variables"]:
        lines.append(f"    pub static {entry['name']}: {entry['type'].removeprefix('const ')};")
    for entry in API["functions"]:
        if not entry["inline"]:
            parameters = ", ".join(f"{word(part['name'])}: {rust(part['type'])}" for part in entry["parameters"])
            result = "" if entry["returns"] == "void" else f" -> {rust(entry['returns'])}"
            lines.append(f"    pub fn {entry['name']}({parameters}){result};")
    return "\n".join([*lines, "}", ""])


def safe(kind):
    """The name of a type of C in the safe crate."""
    if kind in STRUCTS or kind in ENUMS or any(kind == entry["name"] for entry in API["aliases"]):
        return camel(kind)
    return SCALARS[kind]


class Call(Signature):
    """A function as safe Rust has it."""

    def __init__(self, function):
        super().__init__(function)
        self.changes = bool(self.owner) and not function["parameters"][0]["type"].startswith("const ")
        self.parameters, self.arguments, self.lines, self.generics = [], [], [], []
        if self.offered():
            self.name = re.sub(r"(^|_)get_", r"\1", self.c.removeprefix("thud_").removeprefix("world_"), count=1)
            self.handles()
            for part in self.parts:
                self.add(part)

    def offered(self):
        roles = {part.role for part in self.parts}
        if self.c in LEFT_OUT or self.inline or self.owner in ("rollback", "threads") \
                or roles & {"raw", "string", "read", "written"}:
            return False
        if self.returns not in ("thud_result", "_Bool", "void") and not plain(self.returns):
            return False
        if self.c.startswith("thud_default_") and not self.parts:
            return False
        for part in self.parts:
            if part.role == "callback":
                if "_set_" in self.c or not all(
                        plain(one["type"]) or plain(bare(one["type"])) or one["name"] == "context"
                        for one in CALLBACKS[part.type]["parameters"]):
                    return False
            elif part.role == "found":
                continue
            elif not (plain(part.type.removeprefix("const ")) or part.role == "input" and
                      (part.type in WRAPPED or part.type in STATIC)):
                return False
        return True

    def handles(self):
        self.self_arguments = ["self.raw()"] if self.owner else []
        if self.owner in HANDLES.values():
            kind = next(kind for kind, noun in HANDLES.items() if noun == self.owner)
            kind = "thud_body_id" if self.c.startswith("thud_shape_create_") else kind
            self.parameters.append(f"id: {safe(kind)}")
            self.self_arguments.append("id")

    def add(self, part):
        role, kind, name = part
        name = word(name)
        element = kind.removeprefix("const ")
        if role == "value" and kind in INTO:
            self.parameters.append(f"{name}: impl Into<{INTO[kind]}>")
            self.arguments.append(f"{name}.into()")
        elif role == "value":
            self.parameters.append(f"{name}: {safe(kind)}")
            self.arguments.append(name)
        elif role == "input" and kind in WRAPPED:
            self.parameters.append(f"{name}: {WRAPPED[kind][0]}")
            self.arguments.append(WRAPPED[kind][1].format(name))
        elif role == "input" and kind in STATIC:
            self.parameters.append(f"{name}: Option<&'static {camel(kind)}>")
            self.arguments.append(name)
        elif role == "input" and name in OPTIONAL:
            self.parameters.append(f"{name}: Option<&{safe(kind)}>")
            self.arguments.append(f"{name}.map_or(std::ptr::null(), |one| one)")
        elif role in ("input", "changed"):
            self.parameters.append(f"{name}: &{'mut ' * (role == 'changed')}{safe(kind)}")
            self.arguments.append(name)
        elif role == "span":
            const = kind.startswith("const ")
            self.parameters.append(f"{name}: &{'mut ' * (not const)}[{safe(element)}]")
            self.arguments += [f"{name}.as_{'mut_' * (not const)}ptr()", f"count({name}.len())"]
            self.span = name
        elif role == "parallel":
            self.lines.append(f"let mut {name} = vec![zeroed::<{safe(kind)}>(); {self.span}.len()];")
            self.arguments.append(f"{name}.as_mut_ptr()")
        elif role == "list":
            self.arguments += ["out", "room", "number"]
        elif role == "view":
            self.lines += ["let (mut data, mut data_count) = (std::ptr::null(), 0);"]
            self.arguments += ["&mut data", "&mut data_count"]
        elif role == "callback":
            entry = CALLBACKS[kind]
            types = [f"&{safe(bare(one['type']))}" if one["type"].endswith("*") else safe(one["type"])
                     for one in entry["parameters"][:-1]]
            self.generics.append(f"F: FnMut({', '.join(types)}) -> {SCALARS[entry['returns']]}")
            self.parameters.append(f"mut {name}: F")
            self.arguments += [f"Some({kind.removeprefix('thud_')}::<F>)", f"context(&mut {name})"]
        elif role == "found":
            self.lines.append("let mut found = false;")
            self.arguments.append("&mut found")
        elif role == "out":
            name = "out" if name == "out" else name
            self.lines.append(f"let mut {name} = zeroed::<{safe(kind)}>();")
            self.arguments.append(f"&mut {name}")

    def results(self):
        """(expression, type) of what is returned."""
        found = []
        for part in self.parts:
            if part.role == "out":
                found.append((word(part.name), safe(part.type)))
            elif part.role == "parallel":
                found.append((part.name, f"Vec<{safe(part.type)}>"))
            elif part.role == "view":
                found.append(("slice(data, data_count)", f"&[{safe(part.type)}]"))
            elif part.role == "list":
                found.append(("list", f"Vec<{safe(part.type)}>"))
        return found

    def text(self):
        results = self.results()
        made = results[0][0] if len(results) == 1 else f"({', '.join(name for name, _ in results)})"
        kind = results[0][1] if len(results) == 1 else f"({', '.join(kind for _, kind in results)})"
        call = f"sys::{self.c}({', '.join(self.self_arguments + self.arguments)})"
        lines = list(self.lines)
        check = "self.check" if self.owner else "check"
        if self.has("list"):
            room = f"{self.span}.len()" if self.has("span") else "16"
            lines.append(f"let (code, list) = list({room}, |out, room, number| unsafe {{ {call} }});")
            lines.append(f"{check}(code)?;")
        elif self.returns == "thud_result":
            lines.append(f"{check}(unsafe {{ {call} }})?;")
        if self.returns == "thud_result":
            if self.has("found"):
                made, kind = f"found.then_some({made})", f"Option<{kind}>"
            made = f"unsafe {{ {made} }}" if self.has("view") else made
            lines.append(f"Ok({made})")
            kind = f" -> Result<{kind}>"
        elif results:
            if self.returns == "_Bool":
                lines += [f"if unsafe {{ {call} }} {{", f"    Some({made})", "} else {", "    None", "}"]
                kind = f" -> Option<{kind}>"
            else:
                lines += [f"unsafe {{ {call} }};", made]
                kind = f" -> {kind}"
        else:
            lines.append(f"unsafe {{ {call} }}")
            kind = "" if self.returns == "void" else f" -> {safe(self.returns)}"
        own = [f"&{'mut ' * self.changes}self"] * bool(self.owner)
        generics = f"<{', '.join(self.generics)}>" if self.generics else ""
        indent = "    " * bool(self.owner)
        must = f"{indent}#[must_use]\n" * (not kind.startswith(" -> Result") and bool(kind))
        body = "".join(f"{indent}    {line}\n" for line in lines)
        return f"{must}{indent}pub fn {self.name}{generics}({', '.join(own + self.parameters)}){kind} {{\n" \
               f"{body}{indent}}}\n\n"


def trampolines(calls):
    """A function for each type of callback: it calls the closure that is its context."""
    text = ""
    for name in sorted({part.type for call in calls for part in call.parts if part.role == "callback"}):
        entry = CALLBACKS[name]
        parameters = ", ".join(f"{part['name']}: {rust(part['type'])}".replace("thud_", "sys::thud_")
                               for part in entry["parameters"]).replace("c_void", "std::ffi::c_void")
        types = [f"&{safe(bare(part['type']))}" if part["type"].endswith("*") else safe(part["type"])
                 for part in entry["parameters"][:-1]]
        passed = ", ".join("&*" * part["type"].endswith("*") + part["name"] for part in entry["parameters"][:-1])
        returned = SCALARS[entry["returns"]]
        text += f"unsafe extern \"C\" fn {name.removeprefix('thud_')}<F: FnMut({', '.join(types)}) -> {returned}>" \
                f"({parameters}) -> {returned} {{\n    (*context.cast::<F>())({passed})\n}}\n\n"
    return text


def events():
    """thud_events as slices."""
    fields = STRUCTS["thud_events"]["fields"]
    names = {field["name"] for field in fields}
    shown, made = [], []
    for field in fields:
        name = field["name"]
        if field["type"] == "int":
            continue
        count = f"{name}_count" if f"{name}_count" in names else f"{name.rsplit('_', 1)[0]}_count"
        assert count in names, name
        shown.append(f"    pub {name}: &'w [{safe(bare(field['type']))}],\n")
        made.append(f"            {name}: slice(of.{name}, of.{count}),\n")
    return "/// The events of the last step, or of all steps of the last advance; see thud_events.h.\n" \
           "#[derive(Clone, Copy, Debug)]\npub struct Events<'w> {\n" + "".join(shown) + \
           "}\n\nimpl Events<'_> {\n    pub(crate) unsafe fn of(of: &sys::thud_events) -> Self {\n        Self {\n" + \
           "".join(made) + "        }\n    }\n}\n\n"


def setters():
    """Of a world's def."""
    text = "impl WorldDef {\n"
    for field in STRUCTS["thud_world_def"]["fields"]:
        name, kind = field["name"], field["type"]
        if not plain(kind) or name == "cookie":
            continue
        given = f"impl Into<{INTO[kind]}>" if kind in INTO else f"&'static {camel(bare(kind))}" \
            if kind.endswith("*") else safe(kind)
        made = f"{name}.into()" if kind in INTO else f"Some({name})" if kind.endswith("*") else name
        text += f"    #[must_use]\n    pub fn {name}(mut self, {name}: {given}) -> Self {{\n" \
                f"        self.0.{name} = {made};\n        self\n    }}\n\n"
    return text.rstrip() + "\n}\n\n"


def calls_text():
    calls = [call for call in (Call(function) for function in API["functions"]) if call.offered()]
    names = [call.name for call in calls]
    assert len(names) == len(set(names)), {name for name in names if names.count(name) > 1}
    shown = [entry["name"] for entry in [*API["structs"], *API["enums"], *API["aliases"]]
             if plain(entry["name"]) and entry["name"] not in ("thud_world",)]
    shown += [name for name in STATIC]
    text = "// Made from the headers of thud by tools/bind_rust.py.\n\n" \
           "use std::ffi::c_int;\n\nuse thud_sys as sys;\n\n" \
           "use crate::{check, context, count, list, slice, zeroed, Quality, Result, Terrain, World, WorldDef};\n\n"
    text += "".join(f"pub use sys::{name} as {camel(name)};\n" for name in sorted(shown)) + "\n"
    for entry in API["enums"]:
        text += "".join(f"pub const {value['name'].removeprefix('THUD_')}: {camel(entry['name'])} = "
                        f"sys::{value['name']};\n" for value in entry["values"]
                        if not value["name"].endswith("_COUNT"))
    text += "\n"
    modules = {}
    for entry in API["variables"]:
        modules.setdefault(entry["type"].removeprefix("const "), []).append(entry["name"])
    for kind, names in modules.items():
        made = f"super::{camel(kind)}"
        text += f"/// Objects of the engine for `{camel(kind)}`.\npub mod {kind.removeprefix('thud_')} {{\n" \
                "    use thud_sys as sys;\n\n"
        for name in names:
            found = f"sys::{name}" if kind in STATIC else f"*std::ptr::addr_of!(sys::{name}).cast::<{made}>()"
            text += f"    pub fn {word(name.split('_', 2)[2])}() -> &'static {made} {{\n" \
                    f"        unsafe {{ &{found} }}\n    }}\n\n"
        text = text.rstrip() + "\n}\n\n"
    text += events() + setters() + trampolines(calls)
    text += "".join(call.text() for call in calls if not call.owner)
    return text + "impl World {\n" + "".join(call.text() for call in calls if call.owner).rstrip() + "\n}\n"


def versioned(path):
    """A Cargo.toml with the version of the headers."""
    numbers = {entry["name"]: entry["value"] for entry in API["constants"]}
    version = ".".join(str(numbers[f"THUD_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH"))
    return re.sub(r'((?<![-\w])version = ")[\d.]+"', rf'\g<1>{version}"', path.read_text(encoding="utf-8"))


def main():
    options = made.parser_of(__doc__).parse_args()
    files = {SYS: declarations(), CALLS: calls_text(), WORKSPACE: versioned(WORKSPACE), CRATE: versioned(CRATE)}
    return made.write(files, options.check, "bind_rust.py")


if __name__ == "__main__":
    sys.exit(main())
