#!/usr/bin/env python3
"""Makes bindings/api.json, the description of the public headers from which bindings are made.

    api.py [--clang CLANG] [--check]

clang 16 parses engine/include/thud (its syntax tree as JSON); comments are found in the text of the
headers, by the place of what they describe. With --check nothing is written: the exit status is 1
if the file differs from what the headers say now.

The file has these lists, each in the order of the headers:

  headers     name and head comment
  constants   macros with a value, and enumerators of enums without a name
  enums       with their values
  aliases     names of other types
  callbacks   types of functions that a program passes to the engine
  structs     with their fields; `opaque` ones have none
  variables   objects that the engine exports
  functions   with what they return, and their parameters; `inline` ones have no symbol

Each item has `name`, `header` and `comment`. `group` is the text that applies to several items
without an empty line between them: a comment that stands above another, or says so in the words of
OF_ALL. An item without a comment of its own has that of its group; one without either is refused. Fields and parameters have their type in C, `comment`,
and what their comment says in the form of the headers: `unit`, `range`, `default`. All fields of one
declaration share its comment. `errors` are the results that comment, group or, if these name none,
the head of the header names, with THUD_ERROR_NULL for a world and THUD_ERROR_STALE for a handle.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

import made

ROOT = Path(__file__).resolve().parent.parent
HEADERS = ROOT / "engine" / "include" / "thud"
WRITTEN = ROOT / "bindings" / "api.json"
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
SECTION = re.compile(r"/\* ---- (.*?)(?: ---- ?(?=\*/|\n)|\*/)", re.DOTALL)
DEFINE = re.compile(r"^#define (THUD_\w+)[ \t]+((?:\\\n|/\*.*?\*/|[^\n])*)", re.MULTILINE | re.DOTALL)
ERROR = re.compile(r"\bTHUD_ERROR_[A-Z]+\b")
NAME = re.compile(r"\bTHUD_\w+")
NUMBER = re.compile(r"(?<=[\d.])f\b")
ARITHMETIC = re.compile(r"[-+*/() \d.eE]+")
# Of a whole group, as the headers word it.
OF_ALL = re.compile(r"\b(?:All|all) (?:return|calls|are|take)\b|\b(?:Both|All three|All four) calls\b")
HANDLE = re.compile(r"thud_(?:body|shape|joint)_id")
# These take handles of objects that may be gone.
NEVER_STALE = ("thud_world_get_pair",)
FACTOR = r"(?:1|length scales|lengths?|mass|radians|rad|steps|bodies|Hz|s)(?:\^\d)?"
UNIT = re.compile(rf"(?:^|, |; |: )(?!1(?!/))({FACTOR}(?: ?[*/] ?{FACTOR})*|length scales a second)(?=$|[,.;:])")
RANGE = re.compile(r"[\[(][^\[\]()]*, [^\[\]()]*\]|\[[^\[\]()]*, [^\[\]()]*\)"
                   r"|\|\w+\|(?:, \|\w+\|)* <= [^;,.()]+|(?:^|(?<=, ))>= \d[\d.]*(?=[;.,]|$)")
DEFAULT = re.compile(r"\bdefault (?:\(0\) )?(-?\d+(?:\.\d+)?(?:/\d+)?|true|false|null|NaN|&?thud_\w+"
                     r"|THUD_\w+|\([-\d., ]+\))")


def plain(comment):
    """The words of a comment of a header's text, with its line breaks."""
    comment = comment.encode("latin-1").decode("utf-8")
    lines = comment[2:-2].split("\n")
    return "\n".join(re.sub(r"^[ \t]*(?:\*(?= |$))? ?|[ \\]+$", "", line) if at else line.strip(" \\")
                     for at, line in enumerate(lines)).strip()


class Header:
    """A header, and its comments by place."""

    def __init__(self, path):
        self.name = path.name
        # A character for each byte, since clang counts bytes; `plain` gives the words their letters back.
        self.text = path.read_bytes().decode("latin-1")
        self.comments = [match.span() for match in COMMENT.finditer(self.text)]
        self.sections = [match for match in SECTION.finditer(self.text)]
        first = self.comments[0]
        self.head = plain(self.text[slice(*first)])

    def leading(self, start):
        """The comment that ends where a declaration starts, above it, or None."""
        for begin, end in reversed(self.comments):
            if end <= start:
                between = self.text[end:start]
                line = self.text[self.text.rfind("\n", 0, begin) + 1:begin]
                if between.strip() == "" and between.count("\n") < 2 and line.strip() == "" \
                        and not self.text.startswith("/* ---- ", begin):
                    return begin, end
                return None
        return None

    def trailing(self, end):
        """The comment behind a declaration, in the line in which it ends, or None."""
        for begin, close in self.comments:
            if begin >= end:
                if re.fullmatch(r"[^\n;,}]*[;,]?[ \t]*", self.text[end:begin]):
                    return begin, close
                return None
        return None

    def words(self, span):
        return plain(self.text[slice(*span)]) if span else ""

    def paragraph(self, start):
        """Where the lines without an empty one between them begin."""
        at = self.text.rfind("\n\n", 0, start)
        return at + 2 if at >= 0 else 0

    def group(self, start, own):
        """What applies to several items with this one."""
        begin = self.paragraph(start)
        said = []
        for first, last in self.comments:
            if first < begin or last > start or (first, last) == own:
                continue
            stacked = re.match(r"\s*/\*", self.text[last:])
            above = self.text[self.text.rfind("\n", 0, first) + 1:first].strip() == ""
            if above and (stacked or OF_ALL.search(self.text[first:last])):
                said.append(self.words((first, last)))
        sections = [match for match in self.sections if match.end() <= start]
        if sections:
            whole = next(span for span in self.comments if span[0] == sections[-1].start())
            if "\n\n" in self.words(whole):
                said.insert(0, self.words(whole))
        return "\n".join(said)

    def section(self, start):
        names = [match[1] for match in self.sections if match.end() <= start]
        return re.sub(r"\s+\*? ?", " ", names[-1]).strip(" -:") if names else ""


def with_places(nodes):
    """Sets `file`, `begin` and `end` (offsets in that file) of every node: clang's JSON names a
    file only where it differs from that of the place before."""
    current = [""]

    def place(loc):
        for part in ("spellingLoc", "expansionLoc"):
            if part in loc:
                found = place(loc[part])
        if "spellingLoc" in loc:
            return found
        current[0] = loc.get("file", current[0])
        return current[0], loc.get("offset", -1), loc.get("tokLen", 0)

    def walk(node):
        loc = place(node["loc"]) if "loc" in node else None
        if "range" in node:
            begin, end = place(node["range"]["begin"]), place(node["range"]["end"])
            node["file"] = Path((loc or begin)[0]).name
            node["begin"], node["end"] = begin[1], end[1] + end[2]
        for inner in node.get("inner", []):
            walk(inner)

    for node in nodes:
        walk(node)


def inner(node, kind):
    return [child for child in node.get("inner", []) if child.get("kind") == kind]


def parse(clang):
    command = [clang, "-std=c17", f"-I{HEADERS.parent}", "-fsyntax-only", "-Xclang", "-ast-dump=json",
               "-x", "c", "-"]
    text = "#include <thud/thud_all.h>\n"
    done = subprocess.run(command, input=text, check=True, capture_output=True, text=True)
    nodes = json.loads(done.stdout)["inner"]
    with_places(nodes)
    return nodes


def facts(comment):
    """Unit, range, default of a value, in the words of its comment."""
    words = " ".join(comment.split())
    found = {"comment": comment}
    for key, pattern in (("unit", UNIT), ("range", RANGE), ("default", DEFAULT)):
        match = pattern.search(words)
        if match:
            found[key] = (match[1] if match.groups() else match[0]).strip()
    return found


class Api:
    """The lists of api.json."""

    def __init__(self, clang):
        # thud_recorded.h is made of what is written here.
        self.headers = {path.name: Header(path) for path in sorted(HEADERS.glob("*.h"))
                        if path.name != "thud_recorded.h"}
        self.lists = {name: [] for name in ("constants", "enums", "aliases", "callbacks", "structs",
                                            "variables", "functions")}
        self.structs = {}
        nodes = [node for node in parse(clang)
                 if node.get("file") in self.headers and not node.get("isImplicit")]
        for header in self.headers.values():
            self.macros(header)
        self.definitions = {}
        for node in nodes:
            self.definitions.setdefault(node["kind"], {}).setdefault(node.get("name"), []).append(node)
        for node in nodes:
            getattr(self, node["kind"], lambda node: None)(node)

    def item(self, node, **more):
        """An item of one of the lists, with its comments."""
        header = self.headers[node["file"]]
        start, end = node["begin"], node["end"]
        # The attributes before a declaration are macros on the lines that it starts with.
        line = header.text.rfind("\n", 0, start) + 1
        if header.text[line:start].strip() and not header.text[line:start].strip().endswith("*/"):
            start = line
        own = header.leading(start)
        behind = header.trailing(end)
        said = "\n".join(filter(None, (header.words(own), header.words(behind))))
        group = header.group(start, own)
        item = {"name": node["name"], "header": header.name, "section": header.section(start),
                **more, "comment": said or group}
        if said and group:
            item["group"] = group
        self.checked(item["comment"], item["name"], header)
        return item

    @staticmethod
    def checked(comment, name, header):
        """The comment of an item, which must have one."""
        if not comment:
            sys.exit(f"{header.name}: {name} has no comment")
        return comment

    def macros(self, header):
        for match in DEFINE.finditer(header.text):
            text = COMMENT.sub("", match[2]).replace("\\\n", " ").strip()
            values = {entry["name"]: entry["value"] for entry in self.lists["constants"]}
            number = NAME.sub(lambda name: str(values.get(name[0], "?")), NUMBER.sub("", text))
            if not ARITHMETIC.fullmatch(number):
                continue
            behind = COMMENT.search(match[2])
            said = plain(behind[0]) if behind else header.words(header.leading(match.start()))
            section = header.section(match.start())
            self.lists["constants"].append(
                {"name": match[1], "header": header.name, "section": section,
                 "value": eval(number),  # pylint: disable=eval-used; arithmetic alone
                 "text": text, "comment": self.checked(said or header.group(match.start(), None), match[1],
                                                                header)})

    def EnumDecl(self, node):  # pylint: disable=invalid-name
        values, value = [], -1
        header = self.headers[node["file"]]
        for constant in inner(node, "EnumConstantDecl"):
            given = inner(constant, "ConstantExpr")
            value = int(given[0]["value"]) if given else value + 1
            said = header.words(header.leading(constant["begin"])) or \
                header.words(header.trailing(constant["end"]))
            values.append({"name": constant["name"], "value": value, "comment": said})
        if "name" in node:
            self.lists["enums"].append({**self.item(node), "values": values})
            return
        for entry in values:
            item = self.item({**node, "name": entry["name"]})
            self.lists["constants"].append(
                {**item, "value": entry["value"], "text": str(entry["value"]),
                 "comment": entry["comment"] or item["comment"]})

    def RecordDecl(self, node):  # pylint: disable=invalid-name
        name = node.get("name")
        complete = "completeDefinition" in node
        if name in self.structs and not complete:
            return
        item = {**self.item(node), "opaque": not complete, "fields": self.fields(node)}
        if name in self.structs:
            self.lists["structs"].remove(self.structs[name])
        self.structs[name] = item
        self.lists["structs"].append(item)

    def fields(self, node):
        header = self.headers[node["file"]]
        found, of_declaration = [], (0, "")
        for field in inner(node, "FieldDecl"):
            # All declarators of one declaration share the comment behind it.
            close = header.text.index(";", field["end"] - 1) + 1 \
                if header.text[field["end"] - 1] != ";" else field["end"]
            above = header.words(header.leading(field["begin"]))
            if not above and of_declaration[0] == close:
                above = of_declaration[1]
            of_declaration = close, above
            said = "\n".join(filter(None, (above, header.words(header.trailing(close)))))
            found.append({"name": field["name"], "type": field["type"]["qualType"],
                          **facts(said)})
        return found

    def TypedefDecl(self, node):  # pylint: disable=invalid-name
        target = node["type"]["qualType"]
        if target in (f"struct {node['name']}", f"enum {node['name']}"):
            return
        if "(" not in target:
            self.lists["aliases"].append({**self.item(node), "type": target})
            return
        returned = target.split("(")[0].strip()
        prototype = node
        while inner(prototype, "ParenType") or inner(prototype, "FunctionProtoType"):
            prototype = (inner(prototype, "ParenType") + inner(prototype, "FunctionProtoType"))[0]
        header = self.headers[node["file"]]
        text = header.text[node["begin"]:node["end"] + 1]
        inside = COMMENT.sub("", text[text.index("(") + 1:text.rindex(")")])
        names = [re.search(r"(\w+)\s*$", part)[1] for part in inside.split(",")]
        types = [child["type"]["qualType"] for child in prototype.get("inner", [])[1:]]
        parameters = [{"name": name, "type": kind} for name, kind in zip(names, types, strict=True)]
        self.lists["callbacks"].append(
            {**self.item(node), "returns": returned, "parameters": parameters})

    def VarDecl(self, node):  # pylint: disable=invalid-name
        self.lists["variables"].append({**self.item(node), "type": node["type"]["qualType"]})

    def FunctionDecl(self, node):  # pylint: disable=invalid-name
        header = self.headers[node["file"]]
        parameters = []
        for parameter in inner(node, "ParmVarDecl"):
            said = header.words(header.trailing(parameter["end"]))
            parameters.append({"name": parameter["name"], "type": parameter["type"]["qualType"],
                               **facts(said)})
        item = self.item(node)
        returned = node["type"]["qualType"].split("(")[0].strip()
        errors = ERROR.findall(item["comment"] + item.get("group", "")) or ERROR.findall(header.head)
        types = [parameter["type"] for parameter in parameters]
        if any(re.fullmatch(r"(const )?thud_world \*", kind) for kind in types):
            errors.append("THUD_ERROR_NULL")
        if any(HANDLE.fullmatch(kind) for kind in types) and node["name"] not in NEVER_STALE:
            errors.append("THUD_ERROR_STALE")
        self.lists["functions"].append(
            {**item, "returns": returned, "inline": bool(node.get("inline")), "parameters": parameters,
             "errors": sorted(set(errors)) if returned == "thud_result" else []})

    def text(self):
        """api.json: one line for each item, field, value and parameter, so that a change of a
        header is a change of its lines."""
        heads = [{"name": header.name, "comment": header.head} for header in self.headers.values()]
        lists = {"headers": heads, **self.lists}
        parts = []
        for name, items in lists.items():
            parts.append(f'  {json.dumps(name)}: [\n' + ",\n".join(written(item) for item in items)
                         + "\n  ]")
        return "{\n" + ",\n".join(parts) + "\n}\n"


def written(item):
    """An item as JSON."""
    lists = {key: value for key, value in item.items() if isinstance(value, list) and value
             and isinstance(value[0], dict)}
    rest = {key: value for key, value in item.items() if key not in lists}
    text = "    " + json.dumps(rest, ensure_ascii=False)
    for key, value in lists.items():
        lines = ",\n".join("      " + json.dumps(entry, ensure_ascii=False) for entry in value)
        text = text[:-1] + f', {json.dumps(key)}: [\n{lines}]}}'
    return text


def main():
    parser = made.parser_of(__doc__)
    parser.add_argument("--clang", default="clang-16")
    options = parser.parse_args()
    return made.write({WRITTEN: Api(options.clang).text()}, options.check, "api.py", "the headers")


if __name__ == "__main__":
    sys.exit(main())
