"""What the package declares, made from bindings/api.json: C declarations for cffi, and Python types."""

import keyword
import re

ROOTS = {"_Bool": "bool", "float": "float", "double": "float", "const char *": "str"}
INTEGERS = {"int", "unsigned int", "size_t", *(f"{sign}int{bits}_t" for sign in ("", "u")
                                              for bits in (8, 16, 32, 64))}
# Functions of Python's that the engine calls.
CALLED = 'extern "Python" double thud_py_clock(void *context);\n'


def declaration(kind, name):
    """`name` declared with a type of C."""
    if "(*)" in kind:
        return kind.replace("(*)", f"(*{name})")
    array = re.fullmatch(r"(.*?)((?:\[\d+\])+)", kind)
    return f"{array[1]} {name}{array[2]}" if array else f"{kind} {name}"


def prototype(function):
    arguments = ", ".join(declaration(part["type"], part["name"]) for part in function["parameters"])
    return f"{function['returns']} {function['name']}({arguments or 'void'});"


def cdef(api):
    """All declarations of the headers, as cffi parses them."""
    lines = []
    for entry in api["constants"]:
        lines.append(f"static const {'int' if isinstance(entry['value'], int) else 'double'} {entry['name']};")
    for entry in api["enums"]:
        values = ", ".join(f"{value['name']} = {value['value']}" for value in entry["values"])
        lines.append(f"typedef enum {entry['name']} {{ {values} }} {entry['name']};")
    lines += [f"typedef struct {entry['name']} {entry['name']};" for entry in api["structs"]]
    lines += [f"typedef {entry['type']} {entry['name']};" for entry in api["aliases"]]
    lines += [f"typedef {prototype(entry)}" for entry in api["callbacks"]]
    for entry in api["structs"]:
        if not entry["opaque"]:
            fields = " ".join(declaration(field["type"], field["name"]) + ";" for field in entry["fields"])
            lines.append(f"struct {entry['name']} {{ {fields} }};")
    # Without const, cffi takes the address of an object and not its value, which may be opaque.
    lines += [f"extern {declaration(entry['type'].removeprefix('const '), entry['name'])};"
              for entry in api["variables"]]
    lines += [prototype(entry) for entry in api["functions"]]
    return "\n".join(lines) + "\n"


def attribute(name):
    """The name of an attribute: a word of Python's gets an underscore behind it."""
    return name + "_" * keyword.iskeyword(name)


def camel(name):
    return "".join(part.capitalize() for part in name.removeprefix("thud_").split("_"))


def python_type(kind, api):
    """The Python type of what is read from a field."""
    array = re.fullmatch(r"(.*?)\[(\d+)\]", kind)
    if array:
        return f"Tuple[{python_type(array[1], api)}, ...]"
    if kind in ROOTS:
        return ROOTS[kind]
    if kind in INTEGERS:
        return "int"
    if any(kind == entry["name"] for entry in api["enums"]):
        return camel(kind)
    if any(kind == entry["name"] and not entry["opaque"] for entry in api["structs"]):
        return camel(kind)
    return "Any"


def option_type(field, api):
    """The Python type of what is written to a field of a def."""
    read = python_type(field["type"], api)
    if read in (camel("thud_pos"), camel("thud_vec2")):
        return "Tuple[float, float]"
    if any(field["type"] == entry["name"] for entry in api["enums"]):
        return f"Union[str, {read}]"
    return "Any" if read.startswith("Tuple") else read


def quoted(text, indent):
    """A docstring."""
    text = text.replace("\\", "\\\\").replace('"""', "'''")
    return f'{indent}"""{text}"""\n'


def described(fields):
    return "\n".join(f"{field['name']}: {' '.join(field['comment'].split())}"
                     for field in fields if field["comment"])


def records(api):
    """thud/_records.py: enums, structs that are read, and options that are written."""
    lines = ['"""Made from the headers of the engine: enums, structs as they are read, and options."""\n\n',
             "from __future__ import annotations\n\nimport enum\n",
             "from typing import Any, Dict, NamedTuple, Tuple, TypedDict, Union\n"]
    for entry in api["enums"]:
        shared = entry["values"][0]["name"].rsplit("_", 1)[0] + "_"
        while not all(value["name"].startswith(shared) for value in entry["values"]):
            shared = shared[:-1].rsplit("_", 1)[0] + "_"
        text = entry["comment"] + "\n\n" + described(entry["values"])
        lines.append(f"\n\nclass {camel(entry['name'])}(enum.IntEnum):\n" + quoted(text, "    "))
        lines += [f"    {value['name'].removeprefix(shared)} = {value['value']}\n" for value in entry["values"]]
    ready = []
    for entry in (one for one in api["structs"] if not one["opaque"]):
        ready.append(entry["name"])
        text = entry["comment"] + "\n\n" + described(entry["fields"])
        lines.append(f"\n\nclass {camel(entry['name'])}(NamedTuple):\n" + quoted(text, "    "))
        lines += [f"    {attribute(field['name'])}: {python_type(field['type'], api)}"
                  + "  # type: ignore[assignment]" * hasattr(tuple, field["name"]) + "\n"
                  for field in entry["fields"]]
    for entry in (one for one in api["structs"] if one["name"].endswith("_def")):
        name = camel(entry["name"]) + "Options"
        text = f"Fields of {entry['name']}.\n\n" + described(entry["fields"])
        lines.append(f"\n\nclass {name}(TypedDict, total=False):\n" + quoted(text, "    "))
        lines += [f"    {field['name']}: {option_type(field, api)}\n"
                  for field in entry["fields"] if field["name"] not in ("cookie", "kind", "body_a", "body_b")]
        if entry["name"] == "thud_joint_def":
            lines.append("    along: Dict[str, Any]\n    across: Dict[str, Any]\n    turn: Dict[str, Any]\n")
    names = ", ".join(f'"{name}": {camel(name)}' for name in
                      [*ready, *(entry["name"] for entry in api["enums"])])
    lines.append(f"\n\nOF_C: Dict[str, Any] = {{{names}}}\n")
    objects = {}
    for entry in api["variables"]:
        words = objects.setdefault(entry["type"].removeprefix("const "), {})
        words[entry["name"].split("_", 2)[2]] = entry["name"]
    lines.append(f"OBJECTS: Dict[str, Dict[str, str]] = {objects}\n")
    return "".join(lines)
