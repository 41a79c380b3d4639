#!/usr/bin/env python3
"""Makes thud.h, all public headers in one, and thud.c, the whole engine in one file, from the sources.

A program is compiled with both beside it by one call of its compiler: cc -O2 game.c thud.c -lm.
The same sources give the same bytes. thud.hpp, for C++, is copied beside them.

thud.h is the public headers, each after those that it includes, but thud_recorded.h, which stands beside
it for programs whose calls are recorded. thud.c is four parts:

1. What has to be said once for the whole file: pragmas in the place of the build's flags, and headers
   of the compiler.
2. The engine's own headers, and the files that are compiled once, in the order of engine/CMakeLists.txt.
3. The kernels (wide_*.c), for every processor.
4. The kernels again, for AVX2, where TD_HAS_AVX2 of base.h is defined. With them stand those functions
   and macros of headers of which kernels are made: what a vector of eight floats compiles to depends on
   the instruction set of the function that adds it. World.c chooses at run time, as in the library.

Files of a part of parts.py stand between `#if` and `#endif`, so that a program leaves the part out by a define.

In one file, names that are private to a file meet: several files have a static function `run`. A name
of file scope that another file of the engine has at its file scope, too, gets the name of its file in front
(`run` of solve.c: `solve_run`); in part 4 all such names end in _avx2. A file's macros end with it. Renaming
works on tokens: strings, comments and names of members stay as they are. The parts of C that it
understands are those that the engine uses; what it does not, the compiler reports.
"""

import argparse
import functools
import pathlib
import re
import sys
import textwrap

from parts import PARTS, parts_of

TOKEN = re.compile(r"""
    (?P<comment>/\*.*?\*/|//[^\n]*)
  | (?P<directive>^[ \t]*\#(?:\\\n|/\*.*?\*/|[^\n])*)
  | (?P<string>"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')
  | (?P<name>[A-Za-z_]\w*)
  | (?P<number>\.?\d(?:[eEpP][+-]|[\w.])*)
  | (?P<space>\s+)
  | (?P<sign>->|\.\.\.|\#\#|.)
""", re.VERBOSE | re.DOTALL | re.MULTILINE)
DEFINE = re.compile(r"[ \t]*#[ \t]*define[ \t]+(\w+)(\([^)]*\))?")
OWN_INCLUDE = re.compile(r'[ \t]*#[ \t]*include[ \t]+(?:"([^"]+)"|<(thud/[^>]+)>)[^\n]*\n?')
DIRECTIVE = re.compile(r"[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else|endif)\b([^/\n]*)")
# Files that the one file leaves out on Windows: windows.h has names that the engine uses, too.
NOT_ON_WINDOWS = ("src/threads/threads.c",)
SYSTEM_INCLUDE = re.compile(r"[ \t]*#[ \t]*include[ \t]+<([^>]+)>")
CONDITION = re.compile(r"[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else|endif)\b")
# Words before a name in parentheses that are no function's name.
NO_FUNCTIONS = {"__attribute__", "_Static_assert", "sizeof", "_Alignas"}
KEYWORDS = {"static", "inline", "const", "extern", "void", "int", "float", "double", "unsigned", "char",
            "_Bool", "bool", "struct", "enum", "union", "typedef", "_Thread_local", *NO_FUNCTIONS}
AVX2 = "_avx2"
HERE = "/* ======== {} ======== */\n\n"


def tokens_of(text):
    """The tokens of a text, each as [kind, text]; together they are the text."""
    return [[match.lastgroup, match.group()] for match in TOKEN.finditer(text)]


def solid(tokens):
    """The tokens that the compiler sees, without directives."""
    return [token for token in tokens if token[0] not in ("comment", "space", "directive")]


def system_includes(text):
    """Pairs of the name of each system header that a text includes, and the condition, or ""."""
    conditions = []
    for line in text.split("\n"):
        include, directive = SYSTEM_INCLUDE.match(line), DIRECTIVE.match(line)
        if include:
            yield include[1], " && ".join(condition for condition in conditions if condition)
        elif directive:
            verb, rest = directive[1], directive[2].strip()
            if verb in ("if", "ifdef", "ifndef"):
                guard = verb == "ifndef" and rest.endswith("_H")
                conditions.append("" if guard else f"({rest})" if verb == "if"
                                  else f"{'!' * (verb == 'ifndef')}defined({rest})")
            elif verb == "else":
                conditions[-1] = f"!{conditions[-1]}"
            elif verb == "elif":
                conditions[-1] = f"({rest})"
            else:
                conditions.pop()


class Source:
    """A file of the engine, as chunks: a directive, or a declaration with the comments before it."""

    def __init__(self, path, text, macros):
        self.path = path
        self.stem = path.stem
        self.text = text
        self.includes = [match[1] or match[2] for match in OWN_INCLUDE.finditer(text)]
        self.text = OWN_INCLUDE.sub("", text)
        self.macros = [DEFINE.match(part)[1] for kind, part in tokens_of(self.text)
                       if kind == "directive" and DEFINE.match(part)]
        self.chunks = chunks_of(tokens_of(self.text), macros)
        self.bodies = {}  # of macros: each definition's name with parameters, and its text
        self.declared = {}  # name: whether it is of a function or variable
        for chunk in self.chunks:
            self.declared.update(declared_by(chunk, macros))
            define = DEFINE.match(directive_of(chunk))
            if define:
                self.bodies.setdefault(define[1], []).append(
                    (define[0], directive_of(chunk)[define.end():]))

    @property
    def is_wide(self):
        return self.stem.startswith("wide_") and self.path.suffix == ".c"

    @property
    def condition(self):
        """The condition under which the one file has this file, or ""."""
        names = parts_of(str(self.path)[len("src/"):]) if self.path.suffix == ".c" else []
        kept = " || ".join(f"!defined(THUD_NO_{name})" for name in names)
        windows = "!defined(_WIN32)" if str(self.path) in NOT_ON_WINDOWS else ""
        if kept and windows:
            kept = kept if len(names) == 1 else f"({kept})"
        return " && ".join(condition for condition in (windows, kept) if condition)

    def within_condition(self, text):
        return f"#if {self.condition}\n{text}#endif\n" if self.condition else text


def macro_call_end(tokens, start, macros):
    """The index after the call of a macro with which a declaration begins and is whole, or None."""
    if tokens[start][0] != "name" or tokens[start][1] not in macros:
        return None
    depth, at = 0, start + 1
    while at < len(tokens):
        text = tokens[at][1]
        if tokens[at][0] != "space":
            depth += (text == "(") - (text == ")")
            if depth == 0:
                break
        at += 1
    if at >= len(tokens) or tokens[at][1] != ")":
        return None
    after = [token for token in tokens[at + 1:at + 4] if token[0] not in ("space", "comment")]
    if after and after[0][1] == "{":
        return None
    return at + 1


def chunks_of(tokens, macros):
    """Cuts a file: each chunk is a list of tokens that ends with a directive or a declaration."""
    chunks, chunk, depth, body, fresh, at = [], [], 0, False, True, 0
    while at < len(tokens):
        kind, text = tokens[at]
        if fresh and kind == "name":
            end = macro_call_end(tokens, at, macros)
            if end:
                if end < len(tokens) and tokens[end][1] == ";":
                    end += 1
                chunks.append(chunk + tokens[at:end])
                chunk, at = [], end
                continue
        chunk.append(tokens[at])
        at += 1
        if kind == "directive":
            if depth == 0 and fresh:
                chunks.append(chunk)
                chunk = []
            continue
        if kind in ("comment", "space"):
            continue
        fresh = False
        ended = False
        if text in "({[":
            if text == "{" and depth == 0:
                before = solid(chunk)[:-1]
                body = bool(before) and before[-1][1] == ")"
                if before and before[-1] == ["string", '"C"']:
                    ended = True  # extern "C" {
                    depth -= 1
            depth += 1
        elif text in ")}]":
            depth -= 1
            ended = depth == 0 and text == "}" and body
            if depth < 0:  # the end of extern "C"
                depth, ended = 0, True
        elif text == ";" and depth == 0:
            ended = True
        if ended:
            chunks.append(chunk)
            chunk, fresh, body = [], True, False
    chunks.append(chunk)
    return chunks


def declared_by(chunk, macros):
    """Names of file scope that a chunk declares: True for private functions and variables, False for
    types, tags and enumerators. `macros`: those with parameters, and whether they make names
    that end in their first argument."""
    tokens = solid(chunk)
    if not tokens:
        return {}
    texts = [text for _, text in tokens]
    names = {}
    # tags and enumerators
    for at, text in enumerate(texts[:-1]):
        if text in ("struct", "union", "enum"):
            opening = at + 1
            if tokens[opening][0] == "name":
                opening += 1
            if opening < len(texts) and texts[opening] == "{":
                if opening == at + 2:
                    names[texts[at + 1]] = False
                if text == "enum":
                    depth, first = 0, True
                    for kind, word in tokens[opening:]:
                        depth += (word in "({[") - (word in ")}]")
                        if depth == 0:
                            break
                        if first and kind == "name":
                            names[word] = False
                        first = depth == 1 and word in "{,"
    if texts[0] in macros and len(texts) > 2 and texts[1] == "(":
        if not macros[texts[0]] and tokens[2][0] == "name" and texts[3] in (",", ")") and not texts[2].startswith(("td_", "TD_")):
            names[texts[2]] = True
        return names
    if texts[0] not in ("static", "typedef", "TD_INLINE", "TD_INLINE_SMALL", "_Thread_local"):
        return names
    private = texts[0] != "typedef"
    # names of functions, variables and types, outside of parentheses and braces
    depth, assigned, last = 0, False, None
    for at, (kind, text) in enumerate(tokens):
        if text in ("(", "[", "{"):
            if depth == 0 and last and not assigned:
                if text == "(" and tokens[at + 1][1] == "*" and not private:
                    names[texts[at + 2]] = private
                    return names
                if text != "{":
                    names[last] = private
                    if text == "(":
                        return names
            depth += 1
            last = None
        elif text in (")", "]", "}"):
            depth -= 1
        elif depth == 0:
            if kind == "name" and text not in KEYWORDS:
                last = text
            elif text in ("=", ",", ";"):
                if last and not assigned:
                    names[last] = private
                assigned = text == "="
                last = None
    return names


def member_places(tokens):
    """Indices of tokens that name members: after . and ->, in offsetof, and in a struct's body."""
    places = set()
    bodies = []  # for each open bracket whether it is a body of members
    names = [(at, token) for at, token in enumerate(tokens)
             if token[0] not in ("comment", "space")]
    for index, (at, (kind, text)) in enumerate(names):
        before = names[index - 1][1][1] if index else ""
        after = names[index + 1][1][1] if index + 1 < len(names) else ""
        if text in ("(", "[", "{"):
            word = names[index - 2][1][1] if index > 1 else ""
            bodies.append(text == "{" and (before in ("struct", "union") or word in ("struct", "union"))
                          or text == "(" and after == "*" and bool(bodies) and bodies[-1])
        elif text in (")", "]", "}") and bodies:
            bodies.pop()
        elif kind == "name":
            if before in (".", "->"):
                places.add(at)
            elif bodies and bodies[-1] and after in (";", ",", "[", ":", ")"):
                places.add(at)
            elif before == "," and after == ")" and any(
                    names[back][1][1] == "offsetof" for back in range(max(0, index - 6), index)):
                places.add(at)
    return places


def renamed(text, names, avx2=False):
    """A text whose tokens are renamed; for AVX2 also names that a macro makes of parts."""
    if not names and not avx2:
        return text
    tokens = tokens_of(text)
    members = member_places(tokens)
    for at, token in enumerate(tokens):
        kind, word = token
        if kind == "directive":
            head = re.match(r"[ \t]*#[ \t]*\w+", word)[0]
            token[1] = head + renamed(word[len(head):], names, avx2)
        elif kind == "name" and at not in members:
            token[1] = names.get(word, word)
            if avx2 and at + 1 < len(tokens) and tokens[at + 1][1] == "##" and word.endswith("_") \
                    and not word.startswith("td_"):
                token[1] = word[:-1] + AVX2 + "_"
    return "".join(part for _, part in tokens)


def directive_of(chunk):
    """The directive that a chunk is, or nothing."""
    return chunk[-1][1] if chunk and chunk[-1][0] == "directive" and not solid(chunk) else ""


@functools.lru_cache(maxsize=None)
def used_by(text):
    """All names in a text, directives included, without comments and strings."""
    used = set()
    for kind, part in tokens_of(text):
        if kind == "name":
            used.add(part)
        elif kind == "directive":
            used |= used_by(re.sub(r"^[ \t]*#", "", part))
    return frozenset(used)


def ends_of_macros(source, names, called):
    """What ends the macros of a file, as `names` has them, and its copies of macros of headers."""
    macros = sorted({names.get(macro, macro) for macro in source.macros} | set(called.values()))
    return "".join(f"#undef {macro}\n" for macro in macros)


def without_comments(text):
    """A text without comments, which stand in the first copy."""
    parts = []
    for kind, part in tokens_of(text):
        if kind == "directive":
            part = re.sub(r"[ \t]*/\*.*?\*/", "", part, flags=re.DOTALL)
        parts.append("" if kind == "comment" else part)
    text = re.sub(r"[ \t]+\n", "\n", "".join(parts))
    return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"


def without_guard(chunks):
    """The chunks of a header without the condition that guards it, and what is no declaration."""
    chunks = [chunk for chunk in chunks if any(kind != "space" for kind, _ in chunk)]
    if chunks and re.search(r"#[ \t]*ifndef \w+_H$", directive_of(chunks[0])):
        chunks = chunks[1:-1]
    return chunks


def without_empty_conditions(chunks):
    """The chunks without `#if` to `#endif` that hold nothing."""
    changed = True
    while changed:
        changed, kept = False, []
        for chunk in chunks:
            directive = directive_of(chunk)
            condition = CONDITION.match(directive)
            if condition and condition[1] == "endif" and kept:
                start = len(kept) - 1
                while start >= 0 and re.match(r"[ \t]*#[ \t]*(elif|else)\b", directive_of(kept[start])):
                    start -= 1
                if start >= 0 and re.match(r"[ \t]*#[ \t]*if", directive_of(kept[start])):
                    del kept[start:]
                    changed = True
                    continue
            kept.append(chunk)
        chunks = kept
    return chunks


def parts_head():
    """What thud.c says of its parts, and the errors where a part is left out that another one calls."""
    text, errors = PARTS_HEAD, ""
    for name, part in PARTS.items():
        what = part.what.replace("`", "")
        text += "\n".join(textwrap.wrap(f"THUD_NO_{name}: {what}.", 100, initial_indent=" *   ",
                                        subsequent_indent=" *       ", break_long_words=False)) + "\n"
        for other in part.goes_with:
            errors += (f"#if defined(THUD_NO_{name}) && !defined(THUD_NO_{other})\n"
                       f'#error "THUD_NO_{name} leaves out what another part calls: define THUD_NO_{other}, too"\n'
                       "#endif\n")
    return text + " */\n\n" + errors


class Engine:
    """The sources, and the names by which they know each other."""

    def __init__(self, root):
        self.root = root
        include = root / "engine" / "include" / "thud"
        self.public = {path.name: path.read_text(encoding="utf-8") for path in sorted(include.glob("*.h"))}
        listing = (root / "engine" / "CMakeLists.txt").read_text(encoding="utf-8")
        block = re.search(r"set\(THUD_SOURCES\n(.*?)\)", listing, re.DOTALL)[1]
        paths = re.findall(r"^\s*(src/\S+?\.[ch])\b", block, re.MULTILINE)
        texts = {path: (root / "engine" / path).read_text(encoding="utf-8") for path in paths}
        # Macros with parameters, and whether they make names that end in their first argument.
        macros = {match[1]: bool(re.search(r"##" + match[2].split(",")[0].split(")")[0].strip() + r"\b",
                                           match[2])) for text in texts.values() for match in
                  re.finditer(r"^[ \t]*#[ \t]*define[ \t]+([A-Z]\w*)\(((?:\\\n|[^\n])*)", text,
                              re.MULTILINE)}
        self.sources = [Source(pathlib.PurePath(path), text, macros) for path, text in texts.items()]
        self.headers = [source for source in self.sources if source.path.suffix == ".h"]
        self.files = [source for source in self.sources if source.path.suffix == ".c"]
        self.all_names = set().union(*(used_by(text) for text in texts.values()))
        self.check_macros()
        self.open_macros = {}  # macros of headers, by name: the parameters and the body
        for header in self.headers:
            self.open_macros.update(header.bodies)
        for source in self.files:
            self.add_declared_by_macros(source)
        self.own_names = {source: self.names_for(source) for source in self.files}

    def check_macros(self):
        """A file's macro that is a header's, too, would end the header's."""
        of_headers = {macro for header in self.headers for macro in header.macros}
        for source in self.files:
            for macro in source.macros:
                if macro in of_headers:
                    sys.exit(f"{source.path}: {macro} is also a macro of a header")

    def add_declared_by_macros(self, source):
        """What a file declares by calling a macro of a header that begins with `static`."""
        for chunk in source.chunks:
            tokens = solid(chunk)
            if tokens and tokens[0][1] in self.open_macros:
                body = self.open_macros[tokens[0][1]][0][1].replace("\\\n", " ").strip()
                if body.startswith("static") and "=" in body and "##" not in body:
                    source.declared.update(declared_by(tokens_of(body + ";"), {}))

    def own_macros(self, source, names, suffix, text):
        """Macros of headers in which names stand that a file renames: what the file's own copies of
        them are called, and the text of these."""
        macros, todo = set(), [text]
        while todo:
            for macro in (used_by(todo.pop()) & set(self.open_macros)) - macros:
                macros.add(macro)
                todo += [body for _, body in self.open_macros[macro]]
        called, previous = {}, None
        while previous != len(called):
            previous = len(called)
            for macro in macros - set(called):
                for head, body in self.open_macros[macro]:
                    inner = {name: new for name, new in {**names, **called}.items()
                             if name not in used_by(head[head.index(macro):])}
                    if renamed(body, inner) != body:
                        called[macro] = f"{source.stem}_{macro}{suffix}"
        copies = []
        for header in self.headers if called else []:
            chunks = []
            for chunk in header.chunks:
                define = DEFINE.match(directive_of(chunk))
                if define and define[1] in called:
                    head, body = define[0], directive_of(chunk)[define.end():]
                    inner = {name: new for name, new in {**names, **called}.items()
                             if name == define[1] or name not in used_by(head[head.index("define"):])}
                    chunks.append([["directive", renamed(head + body, inner)]])
                elif CONDITION.match(directive_of(chunk)):
                    chunks.append([["directive", directive_of(chunk)]])
            copies += [chunk[0][1] + "\n" for chunk in without_empty_conditions(without_guard(chunks))]
        return called, "".join(copies)

    def names_for(self, source):
        """New names for what would meet the same name of another file."""
        others = [other for other in self.sources if other is not source]
        taken = set().union(*(set(other.declared) for other in others))
        # A macro of a file ends with it, but those of headers stay.
        taken |= {macro for other in self.headers for macro in other.macros}
        names = {}
        for name in source.declared:
            if name in taken:
                new = f"{source.stem}_{name}"
                if new in self.all_names:
                    new = f"{source.stem}_c_{name}"
                if new in self.all_names:
                    sys.exit(f"{source.path}: {name} needs another name, {new} is taken")
                names[name] = new
                # Macros that stand for it in names that a macro makes of parts.
                for ending in ("_base", "_avx2"):
                    if name + ending in source.macros:
                        names[name + ending] = new + ending
        return names

    def header(self):
        """thud.h"""
        done, parts = set(), []

        def add(name):
            if name in done:
                return
            done.add(name)
            text = self.public[name]
            for other in OWN_INCLUDE.finditer(text):
                add(pathlib.PurePath(other[1] or other[2]).name)
            parts.append(HERE.format(f"thud/{name}") + OWN_INCLUDE.sub("", text).strip() + "\n")

        done.add(RECORDED)
        for name in self.public:
            add(name)
        return "\n".join([self.head("thud.h", HEADER_HEAD)] + parts)

    def recorded(self):
        """thud_recorded.h, which redirects calls of a file that includes it, and so stays a file of its
        own."""
        text = OWN_INCLUDE.sub('#include "thud.h"\n', self.public[RECORDED])
        return self.head(RECORDED, RECORDED_HEAD) + text

    def head(self, name, text):
        version = ".".join(re.findall(r"^#define THUD_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)",
                                      self.public["thud_version.h"], re.MULTILINE))
        licence = (self.root / "LICENSE").read_text(encoding="utf-8").strip()
        licence = "\n".join(f" * {line}".rstrip() for line in licence.split("\n"))
        return f"/* {name}: thud {version}{text}\n *\n{licence}\n */\n"

    def system_headers(self):
        """The includes of all files of the C library's and the system's headers, each under the
        conditions under which a file includes it."""
        includes = {}
        for source in self.files:
            for name, condition in system_includes(source.text):
                own = f"({source.condition})" if source.condition else ""
                includes.setdefault(name, set()).add(" && ".join(filter(None, (own, condition))))
        includes.pop("windows.h", None)
        text = ""
        for name, conditions in sorted(includes.items()):
            include = f"#include <{name}>\n"
            text += include if "" in conditions else f"#if {' || '.join(sorted(conditions))}\n{include}#endif\n"
        return text

    def section(self, source):
        """A file in the first copy, its macros ended behind it."""
        names = self.own_names.get(source, {})
        called, copies = self.own_macros(source, names, "", source.text)
        text = renamed(source.text, {**names, **called}).strip() + "\n"
        if copies:
            text = copies + "\n" + text
        if source.path.suffix == ".c":
            text += ends_of_macros(source, names, called)
        return HERE.format(f"engine/{source.path}") + source.within_condition(text)

    def wide_headers(self):
        """The headers that kernels include, in order, and the names of which AVX2 has its own."""
        by_path = {str(source.path)[len("src/"):]: source for source in self.headers}
        seen, todo = set(), [source for source in self.files if source.is_wide]
        while todo:
            for path in todo.pop().includes:
                if path in by_path and path not in seen:
                    seen.add(path)
                    todo.append(by_path[path])
        headers = [source for source in self.headers if str(source.path)[len("src/"):] in seen]
        own, previous = {"__AVX2__", "__SSSE3__", "TD_ISA"}, None
        while previous != len(own):
            previous = len(own)
            for header in headers:
                depth = []
                for chunk in header.chunks:
                    directive = directive_of(chunk)
                    condition = CONDITION.match(directive)
                    if condition:
                        if condition[1].startswith("if"):
                            depth.append(False)
                        elif condition[1] == "endif":
                            depth.pop()
                        if depth:
                            depth[-1] = depth[-1] or bool(used_by(directive[1:]) & own)
                        continue
                    if not self.names_of_code(chunk):
                        continue
                    text = "".join(part for _, part in chunk)
                    if any(depth) or used_by(text) & own or self.has_vectors(chunk):
                        own |= self.names_of_code(chunk)
        return headers, own - {"__AVX2__", "__SSSE3__", "TD_ISA", "TD_WIDE"}

    VECTORS = {"f8", "i8", "u8", "f4", "i4", "d4", "l4", "v4", "td_reals", "td_choice"}

    def has_vectors(self, chunk):
        return bool(used_by("".join(text for _, text in chunk)) & self.VECTORS)

    def names_of_code(self, chunk):
        """The functions, variables and macros that a chunk defines."""
        directive = directive_of(chunk)
        define = DEFINE.match(directive)
        if define:
            return {define[1]}
        return {name for name, private in declared_by(chunk, {}).items() if private}

    def again_for_avx2(self):
        """Part 4."""
        headers, own = self.wide_headers()
        macros = {macro for header in headers for macro in header.macros}
        names = {name: name + AVX2 for name in own - macros}
        parts = []
        for header in headers:
            chunks = []
            for chunk in header.chunks:
                directive = directive_of(chunk)
                define = DEFINE.match(directive)
                text = "".join(part for _, part in chunk)
                if CONDITION.match(directive):
                    chunks.append(chunk)
                elif define and define[1] in own:
                    chunks.append([["directive", f"#undef {define[1]}"], ["space", "\n"]])
                    chunks.append(chunk)
                elif re.match(r"[ \t]*#[ \t]*undef", directive):
                    chunks.append(chunk)
                elif self.names_of_code(chunk) & own or \
                        "TD_WIDE" in used_by(text) and not directive:
                    chunks.append(chunk)
            chunks = without_empty_conditions(without_guard(chunks))
            if not chunks:
                continue
            text = "\n".join("".join(part for _, part in chunk).strip() for chunk in chunks)
            text = re.sub(r"^([ \t]*#[ \t]*\w+ .*)defined\(__(?:AVX2|SSSE3)__\)", r"\g<1>1", text,
                          flags=re.MULTILINE)
            parts.append(HERE.format(f"engine/{header.path}, for AVX2")
                         + without_comments(renamed(text, names, avx2=True)))
        for source in self.files:
            if source.is_wide:
                mine = {name: self.own_names[source].get(name, name) + AVX2
                        for name in source.declared if not name.startswith("td_")}
                text = re.sub(r"[ \t]*#[ \t]*include[^\n]*\n", "", source.text)
                called, copies = self.own_macros(source, mine, AVX2, text)
                mine = {**names, **mine, **called}
                text = without_comments(copies + renamed(text, mine, avx2=True))
                parts.append(HERE.format(f"engine/{source.path}, for AVX2")
                             + source.within_condition(text + ends_of_macros(source, mine, called)))
        return "\n".join(parts)

    def code(self):
        """thud.c"""
        narrow = [source for source in self.sources if not source.is_wide]
        wide = [source for source in self.sources if source.is_wide]
        return "\n".join([self.head("thud.c", CODE_HEAD), parts_head(), BEFORE.replace("SYSTEM\n", self.system_headers())]
                         + [self.section(source) for source in narrow]
                         + [self.section(source) for source in wide]
                         + [AVX2_BEGINS, self.again_for_avx2(), AVX2_ENDS])


RECORDED = "thud_recorded.h"
RECORDED_HEAD = """, beside thud.h and thud.c, for files whose calls are recorded."""

HEADER_HEAD = """, all of its public headers in one file. thud.c beside it is the engine.
 * Made by tools/amalgamate.py from the headers of engine/include/thud; change those."""

CODE_HEAD = """, the whole engine in one file, for gcc and clang. Needs thud.h beside it and
 * the C library:
 *
 *     cc -O2 game.c thud.c -lm
 *
 * It computes the same bits as the library. On Windows it has no pool of threads (thud_threads.h).
 * Parts of it are left out by defines, which are listed below. Made by tools/amalgamate.py from engine/src:
 * change the files there, whose names stand before what they hold."""

PARTS_HEAD = """/* ======== parts that may be left out ========
 *
 * A program that has no use for a part compiles this file with the part's define (-DTHUD_NO_JOINTS), and
 * gets a smaller object. What is left computes the same bits. thud.h declares every part all the same, so
 * that other files need no define; a call to what was left out does not link, and the linker names it.
 *
"""

BEFORE = """#include "thud.h"

/* ======== what the build of the library says by flags ======== */

/* No two operations are fused into one rounding, so that every compiler gives the same bits. Gcc has a
 * pragma for that errno is not read, so that a square root is one instruction; for clang it is the flag
 * -fno-math-errno, without which it is only slower. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
/* Not every processor needs every function of a header. */
#pragma clang diagnostic ignored "-Wunused-function"
/* About the calling convention of vectors, which are passed to inlined functions alone. */
#pragma clang diagnostic ignored "-Wpsabi"
#elif defined(__GNUC__)
/* Of -Wpedantic: that a pointer to arrays becomes one to arrays of constants, which C allows since C23. */
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC optimize("fp-contract=off", "no-math-errno")
#endif

SYSTEM

/* A shared library shows what has THUD_API, and calls the rest directly. */
#if defined(__ELF__)
#pragma GCC visibility push(hidden)
#endif

#define TD_ISA base
"""

AVX2_BEGINS = """/* ======== the kernels again, for AVX2 ========
 *
 * Their comments stand above. Nothing may follow this part, which defines macros of headers anew. */

#if defined(TD_HAS_AVX2)
#include <immintrin.h>

#undef TD_ISA
#define TD_ISA avx2
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
"""

AVX2_ENDS = """#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

#if defined(__ELF__)
#pragma GCC visibility pop
#endif
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0],
                                     epilog="Compile them with: cc -O2 game.c thud.c -lm")
    parser.add_argument("folder", type=pathlib.Path, help="where the files are written")
    parser.add_argument("--source", type=pathlib.Path, metavar="ROOT",
                        default=pathlib.Path(__file__).resolve().parent.parent,
                        help="the project's root (the one that this script stands in)")
    options = parser.parse_args()
    engine = Engine(options.source)
    options.folder.mkdir(parents=True, exist_ok=True)
    cpp = options.source / "engine/include/thud/thud.hpp"
    for name, text in (("thud.h", engine.header()), ("thud.c", engine.code()),
                       (RECORDED, engine.recorded()), ("thud.hpp", cpp.read_text(encoding="utf-8"))):
        with open(options.folder / name, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)


if __name__ == "__main__":
    main()
