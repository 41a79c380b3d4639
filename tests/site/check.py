"""Compiles the code in C on the pages of web/site: check.py PROJECT CC LIBRARY

A block with a main is a program: it is run, and a block of text right behind it is what it prints. All
other blocks are parts of functions, which are compiled together with the names of PARAMETERS, and the
macro of the block "c try" of begin-c.md. Results that may not be ignored are looked at in all of them."""

import pathlib
import re
import subprocess
import sys
import tempfile

PARAMETERS = ("thud_world *world, thud_body_id ground, thud_body_id body, thud_body_id ball, "
              "thud_shape_id shape, thud_joint_id joint, thud_pos place, thud_result result")
HEADERS = "#include <stdio.h>\n#include <stdlib.h>\n#include <thud/thud_all.h>\n#include <thud/thud_threads.h>\n"
BLOCK = re.compile(r"^```c\n(.*?)^```\n(?:\n```text\n(.*?)^```\n)?", re.MULTILINE | re.DOTALL)

project, compiler, library = sys.argv[1:]
project = pathlib.Path(project)
flags = [compiler, "-std=c17", "-Wall", "-Wextra", "-Werror", f"-I{project / 'engine/include'}"]


def compile_to(folder, name, text, *more):
    source = pathlib.Path(folder) / f"{name}.c"
    source.write_text(text, encoding="utf-8")
    subprocess.run([*flags, str(source), *more], check=True)


MACRO = re.search(r"^```c try\n(.*?)^```\n", (project / "web/site/begin-c.md").read_text(encoding="utf-8"),
                  re.MULTILINE | re.DOTALL)[1]
parts, programs = [], []
for page in sorted((project / "web/site").glob("*.md")):
    for text, said in BLOCK.findall(page.read_text(encoding="utf-8")):
        (programs if "int main(" in text else parts).append((page.stem, text, said))
if not programs or not parts:
    sys.exit("the pages have no code in C")

with tempfile.TemporaryDirectory() as held:
    functions = [f"/* {page} */\nvoid part_{number}({PARAMETERS});\nvoid part_{number}({PARAMETERS}) {{{{\n{text}}}}}\n"
                 for number, (page, text, _) in enumerate(parts)]
    compile_to(held, "parts", HEADERS + MACRO + "\n".join(functions), "-c", "-O1", "-o", f"{held}/parts.o", "-Wno-unused-parameter",
               "-Wno-unused-variable", "-Wno-unused-but-set-variable")
    for number, (page, text, said) in enumerate(programs):
        program = f"{held}/program_{number}"
        compile_to(held, f"program_{number}", text, "-o", program, library, "-lm")
        done = subprocess.run([program], capture_output=True, text=True, check=True)
        if done.stdout != said:
            sys.exit(f"{page}: the program says {done.stdout!r}, not {said!r}")
print(f"{len(programs)} programs, {len(parts)} parts")
