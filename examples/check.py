"""Runs an example and compares its output with SAYS: check.py NAME PROGRAM. Also checks that
documents show the examples of SHOWN without changes."""
import pathlib
import subprocess
import sys

SAYS = {
    "embed": "the ball rests at y = 0.50\n",
    "callbacks": "the skater glides at 3.00\n"
    "the jumper fell from 2.5 and rose to 4.6\n"
    "the climber stands at 0.50\n"
    "the parcel rides at 2.00 and collected 1 coin\n"
    "the loudest thud: 17\n",
    "brick_breaker": "0 bricks and 5 lives left after 97.5 s, score 400\n"
    "hash 90dcbe4902922b84\n",
    "car": "place 1: car 3 after 31.88 s\n"
    "place 2: car 2 after 32.55 s\n"
    "place 3: car 1 after 33.32 s\n"
    "hash 27276733f07fb3ad\n",
    "jobs_jthread": "2 to 4 workers of std::jthread: the same bits as one\n",
    "jobs_openmp": "2 to 4 workers of OpenMP: the same bits as one\n",
    "on_threads": "hash e8e04256a532296e\n",
    "platformer": "8 of 8 coins in 14.25 s; the crate is at 4.60\n"
    "hash aacf65774d76a258\n",
    "pool": "10 to 5 balls in 42 shots, 0 and 1 fouls\n"
    "hash 4863f475cf0f7f35\n",
    "recorded": "the hash is the same: yes\n",
    "rollback": "1 to 3 rounds in 847 steps\n"
    "363 steps played again\n"
    "388 steps played again\n"
    "0 unlike, hash ee89e7b947148309\n",
    "save_load": "0 crates left after 1037 steps, hash 17eb95ae567ff213\n"
    "0 crates left after 1037 steps, hash 17eb95ae567ff213\n",
}

name, program = sys.argv[1:]
here = pathlib.Path(__file__).resolve().parent
SHOWN = {"embed": "README.md", "on_threads": "docs/embedding.md", "recorded": "docs/embedding.md"}
if name in SHOWN:
    block = f"```c\n{(here / f'{name}.c').read_text()}```"
    if block not in (here.parent / SHOWN[name]).read_text():
        sys.exit(f"{SHOWN[name]} does not show examples/{name}.c as it is")
said = subprocess.run([program], capture_output=True, text=True, check=True).stdout
if said != SAYS[name]:
    sys.exit(f"the example said {said!r}")
