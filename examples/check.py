"""Runs an example (its name, then its program): it says what it should. README.md shows embed.c to the
letter."""
import pathlib
import subprocess
import sys

SAYS = {
    "embed": "the ball rests at y = 0.50\n",
    "callbacks": "the skater glides at 3.00\n"
    "the jumper fell from 2.5 and rose to 4.7\n"
    "the climber stands at 0.50\n"
    "the parcel rides at 2.00 and collected 1 coin\n"
    "the loudest thud: 17\n",
}

name, program = sys.argv[1:]
here = pathlib.Path(__file__).resolve().parent
readme = (here.parent / "README.md").read_text()
if name == "embed" and f"```c\n{(here / 'embed.c').read_text()}```" not in readme:
    sys.exit("README.md does not show examples/embed.c as it is")
said = subprocess.run([program], capture_output=True, text=True, check=True).stdout
if said != SAYS[name]:
    sys.exit(f"the example said {said!r}")
