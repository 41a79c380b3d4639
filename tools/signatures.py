"""What the bindings read from the signatures of bindings/api.json: whose member a function is, and what
each of its parameters is for.

A parameter, or several together, has one of these roles:

  value      a number, an enumerator or a struct by value
  string     const char *
  input      const T *, one object, which may be null where the function says so
  changed    T *, one object that the function reads and writes
  span       T * and its count, const or not
  list       T *out, capacity and out_count: what there is room for; the count is of all
  parallel   T *out, as long as the span that the function reads
  view       const T **out and out_count: memory of the world
  read       const void * and its size, or thud_bytes
  written    void * and its size
  callback   T_fn * and its context
  raw        a pointer that stays one
  found      bool *out_hit, before the outputs that are written if it is true
  out        T *out...

A signature that fits none of these ends the script with its name."""

import json
import re
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
API = json.loads((ROOT / "bindings/api.json").read_text(encoding="utf-8"))

# A world and a handle of the noun that the name begins with make a member of that handle.
OWNERS = {"thud_world": "world", "thud_rollback": "rollback", "thud_threads": "threads"}
HANDLES = {"thud_body_id": "body", "thud_shape_id": "shape", "thud_joint_id": "joint"}
# What creates and destroys an owner: bindings write it by hand.
OWN = {"thud_world_create", "thud_world_destroy", "thud_rollback_create", "thud_rollback_destroy",
       "thud_threads_create", "thud_threads_destroy"}
PARALLEL = {("thud_world_cast_rays", "out_hits"), ("thud_world_cast_shapes", "out_hits"),
            ("thud_world_extrapolate", "out"), ("thud_world_predict", "out"),
            ("thud_body_create_with_shapes", "out_shape_ids")}
# Arrays whose length is a field of the options, memory whose size the caller knows, and contexts of
# functions that are callbacks themselves.
RAW = {("thud_approximate", "out_shapes"), ("thud_rollback_get_state", "out_state"),
       ("thud_log_to_stderr", "context"), ("thud_mover_passes_one_way", "context")}
FOUND = {"out_hit", "out_found", "out_collided"}
FUNCTIONS = {entry["name"]: entry for entry in API["functions"]}
# The calls of bindings are not redirected to those of thud_recorded.h, and so are not recorded. A program in
# C++ may include both headers of recordings itself.
RECORDING = "thud_recording.h"
RECORDINGS = {name for name, entry in FUNCTIONS.items() if entry["header"] == RECORDING}
CALLBACKS = {entry["name"]: entry for entry in API["callbacks"]}
STRUCTS = {entry["name"]: entry for entry in API["structs"]}
ENUMS = {entry["name"]: entry for entry in API["enums"]}


def bare(kind):
    """The type that a pointer points to, without const."""
    return kind.removeprefix("const ").removesuffix("*").strip()


class Part(NamedTuple):
    """A parameter of a binding: its role, its type in C, or of what it points to, and its name."""

    role: str
    type: str
    name: str


class Signature:
    """A function of C, as a member or a function of a binding.

    owner: "world", "body", "shape", "joint", "rollback", "threads" or None; const: whether it leaves
    its owner as it is; name: without that of its owner; parts: behind the owner."""

    def __init__(self, function):
        self.c = function["name"]
        self.returns = function["returns"]
        self.inline = function["inline"]
        parameters = function["parameters"]
        taken = self.place(parameters)
        self.parts = list(self.read(parameters[taken:]))
        self.name = self.member_name()

    def place(self, parameters):
        """Sets whose member it is; returns how many parameters that takes."""
        self.owner, self.const = None, False
        if not parameters or not parameters[0]["type"].endswith("*") \
                or bare(parameters[0]["type"]) not in OWNERS:
            return 0
        self.owner = OWNERS[bare(parameters[0]["type"])]
        self.const = parameters[0]["type"].startswith("const ")
        if self.owner == "world" and len(parameters) > 1 and parameters[1]["type"] in HANDLES:
            noun = HANDLES[parameters[1]["type"]]
            if self.c.startswith((f"thud_{noun}_", "thud_shape_create_")) or self.c.endswith("_of"):
                self.owner, self.const = noun, True
                return 2
        return 1

    def member_name(self):
        name = self.c.removeprefix("thud_")
        if self.owner is None:
            return name
        name = name.removeprefix(f"{self.owner}_")
        name = name.removeprefix("shape_") if name.startswith("shape_create_") else name
        name = re.sub(r"^(body|joint|contact)_(create|make|decide)", r"\2_\1", name)
        return name.removesuffix("_of") if self.inline else name

    def read(self, parameters):
        """The parts that these parameters are."""
        nothing = {"type": "", "name": ""}
        while parameters:
            first, following, after = (parameters + [nothing, nothing])[:3]
            kind, name = first["type"], first["name"]
            pointer, out = kind.endswith("*"), re.match(r"out(_|$)", name)
            taken = 1
            if bare(kind) in CALLBACKS:
                role, taken = "callback", 2
            elif bare(kind) == "void" and following["type"] == "size_t":
                role, taken = "read" if kind.startswith("const") else "written", 2
            elif kind == "thud_bytes":
                role = "read"
            elif (self.c, name) in RAW:
                role = "raw"
            elif pointer and following["name"] == "capacity" and after["name"] == "out_count":
                role, taken = "list", 3
            elif pointer and following["name"] in ("count", "slots") and not out:
                role, taken = "span", 2
            elif kind.endswith("**") and following["name"] == "out_count":
                role, taken = "view", 2
            elif (self.c, name) in PARALLEL:
                role = "parallel"
            elif kind == "_Bool *" and name in FOUND and following["name"]:
                role = "found"
            elif pointer and out:
                role = "out"
            elif kind == "const char *":
                role = "string"
            elif pointer and kind.startswith("const ") and not kind.endswith("**"):
                role = "input"
            elif pointer and bare(kind) in STRUCTS:
                role = "changed"
            else:
                assert not pointer, (self.c, name)
                role = "value"
            yield Part(role, kind if role in ("value", "raw") else self.pointed(kind, role), name)
            parameters = parameters[taken:]

    @staticmethod
    def pointed(kind, role):
        """Of what a pointer points to, the type; of a span with its const."""
        if role == "view":
            return kind.removeprefix("const ").removesuffix("**").strip()
        if role in ("span", "out"):
            return kind[:-1].strip()
        return bare(kind)

    def outs(self):
        """(type, name) of what it writes, the name without out_ or, of a plain `out`, "value"."""
        return [(part.type, "value" if part.name == "out" else part.name.removeprefix("out_"))
                for part in self.parts if part.role == "out"]

    def has(self, role):
        return any(part.role == role for part in self.parts)
