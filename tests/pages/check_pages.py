"""Checks the generated pages against their JSON and notes, and against the engine.

usage: check_pages.py made
  check_pages.py fresh [--long] [--docs FOLDER] PAGE=PROGRAM... [times=THUD_BENCH]

  made   each page in docs/ and the README are what their JSON and notes make, name the commit
         that was measured, and contain no number that is not in the JSON, given, or dated
  fresh  lists the engine's commits since then, and measures again what takes seconds, or with
         --long minutes: figures that do not depend on the machine; with `times` ratios of times
         to Box2D's, by a thud-bench with Box2D
"""

import sys

import fresh
import history
import made
import measured
import page_figures

SHOWN = 12


def tell(wrong):
    for line in wrong:
        print(line)
    return 1 if wrong else 0


def tell_commits(page, docs):
    commit = page_figures.read_page(page, docs)["about"]["commit"]
    commits = history.since(commit)
    if commits is None:
        print(f"docs/{page}.md: measured at {commit}; without this history nobody can tell what came "
              "since")
    else:
        print(f"docs/{page}.md: measured at {commit}; commits of the engine since: {len(commits)}")
        for line in commits[:SHOWN]:
            print("  " + line)
        if len(commits) > SHOWN:
            print(f"  and {len(commits) - SHOWN} before these")


def short_list(wrong):
    return wrong[:SHOWN] + ([f"and {len(wrong) - SHOWN} more"] if len(wrong) > SHOWN else [])


def check_fresh(programs, is_long, docs):
    found = []
    for page, program in programs.items():
        name = "performance" if page == "times" else page
        if page == "times":
            wrong, factor = fresh.wrong_times(program, docs), fresh.TIMES
        else:
            tell_commits(page, docs)
            wrong, factor = fresh.wrong(page, program, is_long, docs), fresh.FACTOR
        if wrong:
            found.append(f"docs/{name}.md is out of date (figures more than {factor} times apart); "
                         f"{made.COMMANDS[name]} makes it anew:")
            found += ["  " + line for line in short_list(wrong)]
    return found


def main(words):
    if words == ["made"]:
        return tell(made.wrong())
    is_long, docs, programs = "--long" in words, measured.DOCS, {}
    rest = [word for word in words[1:] if word != "--long"]
    while rest:
        word = rest.pop(0)
        if word == "--docs" and rest:
            docs = rest.pop(0)
            continue
        page, _, program = word.partition("=")
        if page not in (*page_figures.PAGES, "times") or not program:
            break
        programs[page] = program
    else:
        if words[:1] == ["fresh"] and programs:
            return tell(check_fresh(programs, is_long, docs))
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
