"""What the structs of native.py have in common."""
import ctypes as c
import operator
from typing import Any, Dict, Iterator, Tuple

_SIGNED = (c.c_int8, c.c_int16, c.c_int32, c.c_int64)
_UNSIGNED = (c.c_uint8, c.c_uint16, c.c_uint32, c.c_uint64)


def integer(kind: Any, value: Any, name: str) -> int:
    """The value as an integer that the ctypes type holds; ctypes itself would cut it off in silence."""
    number = operator.index(value)
    bits = 8 * c.sizeof(kind)
    low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if kind in _SIGNED else (0, (1 << bits) - 1)
    if not low <= number <= high:
        raise ValueError(f"{name} is {number}, it must be {low} to {high}")
    return number


def text_of(text: str, name: str) -> bytes:
    """UTF-8 for C, where a zero would end it."""
    if not isinstance(text, str):
        raise TypeError(f"{name} is a {type(text).__name__}, it must be a str")
    data = text.encode()
    if 0 in data:
        raise ValueError(f"{name} has a zero character")
    return data


def bytes_of(data: Any, name: str) -> bytes:
    """The bytes of anything that has a buffer."""
    if type(data) is bytes:  # pylint: disable=unidiomatic-typecheck
        return data
    try:
        return bytes(memoryview(data))
    except TypeError:
        raise TypeError(f"{name} is a {type(data).__name__}, it must be bytes") from None


class Unique:
    """The owner of something native, of which there is one."""

    def __reduce_ex__(self, _: Any) -> Any:
        raise TypeError(f"a {type(self).__name__} can't be copied or pickled")


class Struct(c.Structure):
    """A struct of C. Integers that its fields can't hold are errors."""

    _integers: Dict[str, Any] = {}

    def __init_subclass__(cls, **arguments: Any) -> None:
        super().__init_subclass__(**arguments)
        cls._integers = {name: kind for name, kind in cls.__dict__.get("_fields_", ())
                         if kind in _SIGNED or kind in _UNSIGNED}

    def __setattr__(self, name: str, value: Any) -> None:
        kind = self._integers.get(name)
        if kind is not None:
            value = integer(kind, value, f"{type(self).__name__}.{name}")
            if name == "struct_size" and value != c.sizeof(type(self)):
                raise ValueError(f"{type(self).__name__}.struct_size is {value}, it must be {c.sizeof(type(self))}")
        elif not hasattr(type(self), name):
            raise TypeError(f"{type(self).__name__} has no {name}")
        super().__setattr__(name, value)

    def __iter__(self) -> Iterator[Any]:
        return (getattr(self, name) for name, _ in self._fields_)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={_shown(getattr(self, name))}' for name, _ in self._fields_)})"


class Sized(Struct):
    """A struct that begins with its own size."""

    def __init__(self, **fields: Any) -> None:
        super().__init__(**{"struct_size": c.sizeof(type(self)), **fields})



def _shown(value: Any) -> str:
    return repr(list(value)) if isinstance(value, c.Array) else repr(value)
