"""Values by their base class: one whose fields are its annotations is made, compared and shown as `dataclasses` does it.

`dataclasses` writes and compiles source for each class, some 0.6 ms; a short command makes 220 classes. Here it collects the
fields alone, so that `fields` and `replace` serve, and all else are methods over them.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterable, Iterator
from dataclasses import MISSING, FrozenInstanceError
from dataclasses import field as field
from itertools import count
from operator import attrgetter
from typing import Any, NoReturn, TypeVar, dataclass_transform

T = TypeVar("T")
put = object.__setattr__
OFTEN = 300  # times that a class is made before its constructor is written out


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
class Frozen:
    """What never changes, and is equal to what has equal fields (with `eq=False`: to itself alone)."""

    _compared: Callable[[Any], Any]
    _hashed: Callable[[Any], Any]

    def __init_subclass__(cls, *, eq: bool = True, **more: Any) -> None:
        super().__init_subclass__(**more)
        fields = _with_fields(cls)
        cls._compared = _key(f.name for f in fields if f.compare)
        cls._hashed = _key(f.name for f in fields if (f.compare if f.hash is None else f.hash))
        if not eq:
            cls.__eq__, cls.__hash__ = object.__eq__, object.__hash__  # type: ignore[method-assign]
        elif cls.__hash__ is None:  # Python's beside an __eq__ of its own
            cls.__hash__ = Frozen.__hash__

    def __eq__(self, other: object) -> bool:
        return self._compared(self) == self._compared(other) if other.__class__ is self.__class__ else NotImplemented

    def __hash__(self) -> int:
        return hash(self._hashed(self))

    def __repr__(self) -> str:
        parts = ", ".join(f"{f.name}={getattr(self, f.name)!r}" for f in _fields(self) if f.repr)
        return f"{type(self).__qualname__}({parts})"

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise FrozenInstanceError(f"cannot change field {name!r}")

    def __delattr__(self, name: str) -> NoReturn:
        raise FrozenInstanceError(f"cannot change field {name!r}")


def replace(value: T, /, **changes: Any) -> T:
    """The value with other fields; what is found late stays so."""
    kept = {f.name: vars(value)[f.name] for f in _fields(value) if f.init and f.name not in changes}
    return type(value)(**kept, **changes)


class Late:
    """A field that may be given as what finds it, once, when somebody looks; the default, if it is not given."""

    def __init__(self, default: Any) -> None:
        self.default = default

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, instance: object, owner: type | None = None) -> Any:
        if instance is None:
            return self.default
        if callable(found := vars(instance)[self.name]):
            vars(instance)[self.name] = found = found()
        return found

    def __set__(self, instance: object, value: object) -> None:
        vars(instance)[self.name] = value


@dataclass_transform(field_specifiers=(field,))
class Walker:
    """What is no value, but goes over something and remembers where it is."""

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        _with_fields(cls)


def _fields(value: Any) -> tuple[dataclasses.Field[Any], ...]:
    return dataclasses.fields(value)


def _with_fields(cls: Any) -> tuple[dataclasses.Field[Any], ...]:
    """The fields of a class; what takes them is its constructor."""
    if cls.__doc__ is None:
        cls.__doc__ = cls.__name__  # else its signature would be looked up and written
    dataclasses.dataclass(init=False, eq=False, repr=False)(cls)
    fields = _fields(cls)
    if "__init__" not in vars(cls):
        cls.__init__ = _constructor(cls, fields)
    return fields


def _constructor(cls: Any, fields: tuple[dataclasses.Field[Any], ...]) -> Callable[..., None]:
    """What sets the fields that are given, and all others as they are declared; often used, it is written out."""
    own = (f for f in fields if f.init or f.default is not MISSING or f.default_factory is not MISSING)
    fields = tuple(sorted(own, key=lambda f: not f.init or f.kw_only is True))
    names = [f.name for f in fields]
    most = sum(f.init and not f.kw_only for f in fields)
    is_followed = hasattr(cls, "__post_init__")
    uses = count(1)

    def __init__(self: Any, *values: Any, **named: Any) -> None:
        if next(uses) == OFTEN and cls.__init__ is __init__:
            cls.__init__ = _written_out(cls, fields)
        for name, value in zip(names, completed(values, named), strict=True):
            put(self, name, value)
        if is_followed:
            self.__post_init__()

    def completed(values: tuple[Any, ...], named: dict[str, Any]) -> Iterator[Any]:
        yield from values
        for f in fields[len(values) :]:
            value = named.pop(f.name, f.default) if f.init else f.default
            if value is MISSING:
                make: Any = f.default_factory
                if make is MISSING:
                    raise TypeError(f"{cls.__name__} needs {f.name}")
                value = make()
            yield value
        if named or len(values) > most:
            raise TypeError(f"{cls.__name__} takes {', '.join(names)}; not {len(values)} values and {sorted(named)}")

    return __init__


def _written_out(cls: Any, fields: Iterable[dataclasses.Field[Any]]) -> Any:
    """The constructor that `dataclasses` writes for these fields: some three times as fast."""
    own = [
        (f.name, Any, field(default=f.default, default_factory=f.default_factory, init=f.init, kw_only=f.kw_only)) for f in fields
    ]
    after = {"__post_init__": cls.__post_init__} if hasattr(cls, "__post_init__") else {}
    return vars(dataclasses.make_dataclass(cls.__name__, own, namespace=after, frozen=True, eq=False, repr=False))["__init__"]


def _key(names: Iterable[str]) -> Callable[[Any], Any]:
    """The values of these fields; of one field its value."""
    names = tuple(names)
    return attrgetter(*names) if names else lambda *nothing: ()
