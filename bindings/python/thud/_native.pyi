"""What cffi compiles from the declarations in bindings/api.json."""

from typing import Any

ffi: Any
lib: Any
