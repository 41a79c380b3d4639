"""Checks that each generated page is what its JSON and notes make, and names the commit of the
measurement."""

import filecmp
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

import history
import measured
import page_figures
import prose
import readme
import sources

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
# For each page: the program that writes it from its JSON, its notes, and the command that measures
# it.
WRITERS = {"performance": "bench/pages/performance.py", "catalogue": "bench/pages/catalogue.py",
           "network": "network/network.py", "stability": "stability/envelope.py", "tradeoff": "tradeoff/tradeoff.py"}
NOTES = {"performance": "bench/pages/performance-notes.md", "catalogue": "bench/pages/catalogue-notes.md",
         "network": "network/network-notes.md", "stability": "stability/notes.md", "tradeoff": "tradeoff/tradeoff-notes.md"}
COMMANDS = {"performance": "./run bench --report", "catalogue": "./run bench --catalogue",
            "network": "./run network", "stability": "./run envelope", "tradeoff": "./run tradeoff"}


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def written_anew(page, docs, folder):
    """The paths, relative to both folders, of all files that the page's writer makes from its JSON."""
    kept = page_figures.page_path(page, folder)
    os.makedirs(os.path.dirname(kept), exist_ok=True)
    shutil.copy(page_figures.page_path(page, docs), kept)
    done = subprocess.run([sys.executable, "-B", os.path.join(TESTS, WRITERS[page]), "no-program",
                           "--again", "--out", folder], capture_output=True, text=True, check=False)
    if done.returncode:
        raise ValueError(done.stderr.strip())
    return [os.path.relpath(os.path.join(base, name), folder)
            for base, _, names in os.walk(folder) for name in names]


def not_as_made(page, docs):
    with tempfile.TemporaryDirectory() as folder:
        try:
            paths = written_anew(page, docs, folder)
        except (OSError, ValueError) as error:
            return [f"docs/{page}.md cannot be made of its figures: {error}"]
        return [f"docs/{path} is not what {os.path.basename(page_figures.PAGES[page])} and the notes "
                f"make: {COMMANDS[page]} --again" for path in sorted(paths)
                if not os.path.exists(os.path.join(docs, path))
                or not filecmp.cmp(os.path.join(docs, path), os.path.join(folder, path), False)]


def wrong_commit(page, docs):
    results = page_figures.read_page(page, docs)
    lines = measured.LINE.findall(read(os.path.join(docs, page + ".md")))
    commit = results["about"]["commit"]
    if len(lines) != 1 or lines[0][0] != commit or not measured.COMMIT.fullmatch(commit):
        return [f"docs/{page}.md names no commit, or another than its figures' ({commit})"]
    wrong = [f"docs/{page}.md was measured at {commit}: {history.why_not(commit)}"] \
        if history.why_not(commit) else []
    if results.get("quick") or results.get("missing"):
        wrong.append(f"docs/{page}.md is of a run that was not whole")
    return wrong


def loose_prose(name, notes, strays):
    wrong = [f"{name}:{line}: '{number}' is neither a figure of the JSON, nor given, nor dated: {text}"
             for line, text, number in strays]
    wrong += [f"{name}: '{phrase}' is given and not written" for phrase in prose.stray_phrases(notes)]
    wrong += [f"{name}: of commit {commit}: {history.why_not(commit)}"
              for commit in prose.dates(notes) if history.why_not(commit)]
    return wrong


def loose_notes(page):
    notes = read(os.path.join(TESTS, NOTES[page]))
    return loose_prose("tests/" + NOTES[page], notes, prose.stray_numbers(notes))


def loose_document(name, docs):
    """The differences between README.md or docs/features.md and what its notes make."""
    text, notes = read(readme.path_of(name)), read(readme.DOCUMENTS[name])
    notes_name = os.path.relpath(readme.DOCUMENTS[name], measured.ROOT)
    own = readme.GIVEN_THERE.sub("", notes)
    wrong = loose_prose(notes_name, own, prose.stray_numbers(own))
    wrong += loose_prose(name, text, readme.stray_numbers(text, notes))
    wrong += [f"{name}: '{phrase}' is given and not written" for found in
              readme.GIVEN_THERE.findall(notes) for phrase in map(str.strip, found.split(";"))
              if " ".join(phrase.split()) not in " ".join(text.split())]
    try:
        if readme.filled(text, notes, docs) != text:
            wrong.append(f"{name} has other figures than docs/: python3 tests/pages/readme.py")
    except ValueError as error:
        wrong.append(f"{notes_name}: {error}")
    return wrong


def loose_documents(docs):
    return [line for name in readme.DOCUMENTS for line in loose_document(name, docs)]


def uncovered(docs):
    """Pages that say that they were measured, and are not in WRITERS."""
    return [f"docs/{name} was measured, and tests/pages knows nothing of it"
            for name in sorted(os.listdir(docs)) if name.endswith(".md")
            and re.search(r"^Measured at commit", read(os.path.join(docs, name)), re.MULTILINE)
            and name[:-3] not in WRITERS]


def pictures_without_commit(docs):
    """Checks the pictures that web/tools/screenshots.mjs takes of the page, with their commits."""
    folder = os.path.join(docs, "pictures")
    listed = json.loads(read(os.path.join(folder, "pictures.json")))
    taken = {name[:-4] for name in os.listdir(folder) if name.endswith(".png")}
    wrong = [f"docs/pictures/{name}.png and pictures.json do not belong together"
             for name in sorted(taken ^ set(listed))]
    return wrong + [f"docs/pictures/{name}.png was taken at {one['commit']}: "
                    f"{history.why_not(one['commit']) or 'that is no commit'}"
                    for name, one in listed.items() if history.why_not(one["commit"])
                    or not measured.COMMIT.fullmatch(one["commit"])]


def wrong(docs=measured.DOCS):
    found = pictures_without_commit(docs)
    for page in WRITERS:
        found += not_as_made(page, docs) + wrong_commit(page, docs) + loose_notes(page)
    return found + loose_documents(docs) + sources.wrong(docs) + uncovered(docs)
