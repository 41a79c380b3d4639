"""The README's example is examples/embed.c to the letter, and does what the README says."""
import pathlib
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
source = (here / "embed.c").read_text()
readme = (here.parent / "README.md").read_text()
if f"```c\n{source}```" not in readme:
    sys.exit("README.md does not show examples/embed.c as it is")
said = subprocess.run([sys.argv[1]], capture_output=True, text=True, check=True).stdout
if said != "the ball rests at y = 0.50\n":
    sys.exit(f"the example said {said!r}")
