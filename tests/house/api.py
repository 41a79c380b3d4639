"""Checks the declarations of the public headers against the rules at the head of thud.h:
api.py PROJECT [CLANG].

  names     an enumerator begins with the name of its type, without "kind": THUD_BODY_STATIC of
            thud_body_kind; results are THUD_OK and THUD_ERROR_...
  order     a function's object comes first (the world, where it has one), outputs last
  outputs   pointers that a call writes to are named `out` or out_...
  reads     thud_X_get_Y returns a thud_result and has an output; no other exported function returns
            a struct but the defaults, thud_X_at and thud_X_make
  lists     end with (out, capacity, out_count)
  enabled   no name contains "disabled"
  seven     no function has more arguments
  shapes    thud_shape_... acts on a shape of a world; geometry is thud_geometry_...
  exported  every function that is not inline has THUD_API

The headers are parsed by clang (its AST as JSON). Prints one line per breach and exits with 1 if
there is any.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ARGUMENTS_MAX = 7
# Pointers that a call reads as well as writes, by the name of the argument.
READ_AND_WRITTEN = {"world", "rollback", "mover", "threads", "recorder", "player", "context", "seen", "pair", "def", "buffer"}
OBJECTS = ("thud_world", "thud_rollback", "thud_mover", "thud_threads", "thud_recorder",
           "thud_player")
PLAIN = {"thud_result", "_Bool", "void", "int", "const char *"}
MAKES = re.compile(r"thud_default_\w+|thud_\w+_(?:at|make)")


def parse(text, include, clang):
    """The top-level declarations of a C text."""
    with tempfile.NamedTemporaryFile("w", suffix=".c", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        command = [clang, "-std=c17", f"-I{include}", "-fsyntax-only", "-Xclang", "-ast-dump=json",
                   file.name]
        done = subprocess.run(command, check=True, capture_output=True, text=True)
    return json.loads(done.stdout)["inner"]


def of_kind(node, kind):
    return [inner for inner in node.get("inner", []) if inner["kind"] == kind]


def functions(tree):
    """(name, type that it returns, [(argument, type)], is exported) of each that is not inline."""
    for node in tree:
        name = node.get("name", "")
        if node["kind"] == "FunctionDecl" and name.startswith("thud_") and not node.get("inline"):
            arguments = [(argument.get("name", ""), argument["type"]["qualType"])
                         for argument in of_kind(node, "ParmVarDecl")]
            returned = node["type"]["qualType"].split("(")[0].strip()
            yield name, returned, arguments, bool(of_kind(node, "VisibilityAttr"))


def is_written(name, type_name):
    if not type_name.endswith("*") or name in READ_AND_WRITTEN:
        return False
    pointed = type_name[:-1].strip()
    return pointed.endswith("*") or not (pointed.startswith("const ") or pointed.endswith("_fn"))


def is_output(name):
    return name == "out" or name.startswith("out_")


def check_enumerators(tree):
    for node in tree:
        type_name = node.get("name", "")
        if node["kind"] != "EnumDecl" or not type_name.startswith("thud_"):
            continue
        start = "THUD_" + re.sub("_(?:kind|part)$", "", type_name[len("thud_"):]).upper() + "_"
        for enumerator in of_kind(node, "EnumConstantDecl"):
            name = enumerator["name"]
            starts = ("THUD_OK", "THUD_ERROR_") if type_name == "thud_result" else start
            if not name.startswith(starts):
                yield f"names: {name} of {type_name} does not begin with {start}"


def check_arguments(name, arguments):
    if len(arguments) > ARGUMENTS_MAX:
        yield f"seven: {name} has {len(arguments)} arguments"
    for argument, type_name in arguments:
        if is_written(argument, type_name) and not is_output(argument):
            yield f"outputs: {name} writes to `{argument}`, which is not named out_..."
    objects = [i for i, (_, type_name) in enumerate(arguments)
               if re.fullmatch(rf"(?:const )?(?:{'|'.join(OBJECTS)}) \*", type_name)]
    if objects and objects[0] != 0 and not name.endswith("_fn"):
        yield f"order: the object of {name} is not its first argument"
    # The size of a buffer stands behind it.
    outputs = [is_output(argument) or argument in ("capacity", "bytes") for argument, _ in arguments]
    first = next((i for i, (argument, _) in enumerate(arguments) if is_output(argument)), None)
    if first is not None and not all(outputs[first:]):
        yield f"order: an argument of {name} stands behind its outputs"
    names = [argument for argument, _ in arguments]
    if "capacity" in names and names[-3:] not in (["out", "capacity", "out_count"],
                                                  ["buffer", "capacity", "out_bytes"]):
        yield f"lists: {name} does not end with (out, capacity, out_count)"


def check_function(name, returned, arguments, exported):
    yield from check_arguments(name, arguments)
    if not exported:
        yield f"exported: {name} lacks THUD_API"
    if "_get_" in name and (returned != "thud_result" or
                            not any(is_output(argument) for argument, _ in arguments)):
        yield f"reads: {name} does not return a thud_result, or has no output"
    if returned not in PLAIN and not MAKES.fullmatch(name):
        yield f"reads: {name} returns a {returned}"
    types = [type_name for _, type_name in arguments]
    if name.startswith("thud_shape_") and not any("thud_world *" in t for t in types):
        yield f"shapes: {name} has no world: geometry is thud_geometry_..."
    if types and types[0] == "const thud_geometry *" and \
            not name.startswith(("thud_geometry_", "thud_minkowski_", "thud_volume_",
                                 "thud_capsule_")):
        yield f"shapes: {name} is geometry, and is not named thud_geometry_..."


def check_names(tree):
    text = json.dumps([(node.get("name"), [inner.get("name") for inner in node.get("inner", [])])
                       for node in tree if str(node.get("name", "")).startswith("thud_")])
    for name in sorted(set(re.findall(r'"(\w*disabled\w*)"', text))):
        yield f"enabled: {name} says what is not"


def breaches(tree):
    found = [*check_enumerators(tree), *check_names(tree)]
    for function in functions(tree):
        found += check_function(*function)
    return found


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[0] in ("-h", "--help"):
        print(__doc__)
        return 0 if arguments and arguments[0] in ("-h", "--help") else 2
    include = Path(arguments[0]) / "engine" / "include"
    tree = parse("#include <thud/thud_all.h>\n", include,
                 arguments[1] if len(arguments) == 2 else "clang-16")
    found = breaches(tree)
    for line in found:
        print(line)
    print(f"{len(found)} breaches by the declarations of "
          f"{sum(1 for _ in functions(tree))} public functions")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
