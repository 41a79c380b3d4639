"""Calls every function of api.json that takes a world without one, and with handles that name nothing: the
results that the reference names for all of them must come. errors.py PROJECT CC LIBRARY"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

WORLD = re.compile(r"(?:const )?thud_world \*")
HANDLE = re.compile(r"thud_(?:body|shape|joint)_id")
HEAD = """#include <stdio.h>
#include <string.h>
#include <thud/thud_all.h>
static char zeros[65536];
static int wrong;
static void call(const char *name, thud_result result, thud_result expected) {
    if (result != expected) {
        printf("%s: %s, not %s\\n", name, thud_result_text(result), thud_result_text(expected));
        wrong = 1;
    }
    memset(zeros, 0, sizeof zeros);
}
int main(void) {
    thud_world_def def = thud_default_world_def();
    thud_world *world = NULL;
    if (thud_world_create(&def, &world) != THUD_OK)
        return 1;
"""
project, compiler, library = sys.argv[1:]
project = pathlib.Path(project)
api = json.loads((project / "bindings/api.json").read_text(encoding="utf-8"))
structs = {struct["name"] for struct in api["structs"]}


def argument(kind, world):
    if WORLD.fullmatch(kind):
        return world
    if kind.endswith("*") and "(" not in kind:
        return "(void *)zeros"
    return f"({kind}){{0}}" if kind in structs else "0"


calls = []
for function in api["functions"]:
    kinds = [parameter["type"] for parameter in function["parameters"]]
    for error, world in (("THUD_ERROR_NULL", "NULL"), ("THUD_ERROR_STALE", "world")):
        general = any((WORLD if world == "NULL" else HANDLE).fullmatch(kind) for kind in kinds)
        if error in function["errors"] and general and any(WORLD.fullmatch(kind) for kind in kinds):
            given = ", ".join(argument(kind, world) for kind in kinds)
            calls.append(f'    call("{function["name"]}", {function["name"]}({given}), {error});')
if len(calls) < 200:
    sys.exit(f"only {len(calls)} calls")

with tempfile.TemporaryDirectory() as held:
    source, program = pathlib.Path(held) / "errors.c", f"{held}/errors"
    source.write_text(HEAD + "\n".join(calls) + "\n    thud_world_destroy(world);\n    return wrong;\n}\n",
                      encoding="utf-8")
    subprocess.run([compiler, "-std=c17", f"-I{project / 'engine/include'}", str(source), "-o", program, library,
                    "-lm"], check=True)
    if subprocess.run([program], check=False).returncode:
        sys.exit("the reference names errors that do not come")
print(f"{len(calls)} calls")
