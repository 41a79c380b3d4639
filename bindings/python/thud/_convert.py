"""Values between Python and the engine's structs."""

from __future__ import annotations

import difflib
from typing import Any, Mapping

from ._native import ffi, lib
from ._records import OBJECTS, OF_C

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

def name_of(kind: Any) -> str:
    """The name of a type of C, as the headers have it."""
    return kind.cname.removeprefix("enum ").removeprefix("struct ")


def plain(value: Any) -> Any:
    """A struct or array of C as Python's own tuples and numbers; anything else as it is."""
    if not isinstance(value, ffi.CData):
        return value
    kind = ffi.typeof(value)
    if kind.kind == "struct":
        fields = [plain_field(getattr(value, name), field.type) for name, field in kind.fields]
        return OF_C[name_of(kind)](*fields)
    if kind.kind == "array":
        return tuple(plain_field(element, kind.item) for element in value)
    return value


def plain_field(value: Any, kind: Any) -> Any:
    if kind.kind == "enum":
        return OF_C[name_of(kind)](value)
    return plain(value)


def constant(kind: str, word: str) -> int:
    """The enumerator that a word names."""
    found = OF_C[kind].__members__
    if word.upper() not in found or word.endswith("count"):
        known = sorted(name.lower() for name in found if not name.endswith("COUNT"))
        raise ValueError(f"{kind} has no {word!r}; it has {', '.join(known)}")
    return int(found[word.upper()])


def named_object(kind: str, word: str) -> Any:
    """The object of the engine that a word names, by its address."""
    if word not in OBJECTS.get(kind, {}):
        raise ValueError(f"{kind} has no {word!r}; it has {', '.join(sorted(OBJECTS.get(kind, {})))}")
    return ffi.addressof(lib, OBJECTS[kind][word])


def fill(struct: Any, options: Mapping[str, Any], where: str) -> None:
    """Sets fields of a struct. TypeError for a name that it has not, or a value of another type."""
    fields = dict(ffi.typeof(struct).item.fields if ffi.typeof(struct).kind == "pointer"
                  else ffi.typeof(struct).fields)
    for name, value in options.items():
        if name not in fields or name == "cookie":
            near = difflib.get_close_matches(name, fields, 1)
            raise TypeError(f"{where} has no option {name!r}" + (f"; is it {near[0]!r}?" if near else ""))
        kind = fields[name].type
        try:
            set_field(struct, name, kind, value)
        except (TypeError, OverflowError, ValueError) as error:
            raise type(error)(f"{name} of {where}: {error}") from None


def set_field(struct: Any, name: str, kind: Any, value: Any) -> None:
    handle = getattr(value, "handle", None)
    if handle is not None:
        setattr(struct, name, handle)
    elif isinstance(value, str) and kind.kind == "enum":
        setattr(struct, name, constant(name_of(kind), value))
    elif isinstance(value, str) and kind.kind == "pointer":
        setattr(struct, name, named_object(name_of(kind.item), value))
    elif kind.kind == "struct" and isinstance(value, Mapping):
        fill(getattr(struct, name), value, name)
    elif kind.kind == "array":
        elements = getattr(struct, name)
        if len(value) > len(elements):
            raise ValueError(f"{len(value)} elements, not {len(elements)}")
        for at, element in enumerate(value):
            if isinstance(element, Mapping):
                fill(elements[at], element, f"{name}[{at}]")
            else:
                elements[at] = getattr(element, "handle", element)
    elif kind.kind == "struct" and not isinstance(value, ffi.CData):
        if len(value) != len(kind.fields):
            raise ValueError(f"{len(value)} numbers, not {len(kind.fields)}")
        setattr(struct, name, tuple(value))
    else:
        setattr(struct, name, value)


def pair(kind: str, value: Any) -> Any:
    """A vector of C, from any two numbers."""
    x, y = value
    return ffi.new(f"{kind} *", (x, y))[0]


def dtype_of(kind: Any) -> Any:
    """NumPy's type of a type of C."""
    if kind.kind == "struct":
        names = [name for name, _ in kind.fields]
        return numpy.dtype({"names": names, "formats": [dtype_of(field.type) for _, field in kind.fields],
                            "offsets": [field.offset for _, field in kind.fields],
                            "itemsize": ffi.sizeof(kind)})
    if kind.kind == "array":
        return numpy.dtype((dtype_of(kind.item), kind.length))
    if kind.kind == "enum":
        return numpy.dtype(f"u{ffi.sizeof(kind)}")
    if kind.cname in ("float", "double"):
        return numpy.dtype(f"f{ffi.sizeof(kind)}")
    if kind.cname in ("_Bool", "bool"):
        return numpy.dtype(bool)
    return numpy.dtype(f"{'u' if kind.cname.startswith('u') else 'i'}{ffi.sizeof(kind)}")
