"""Writes the type stubs of the package wristwise from the package itself.

What pybind11 says in its docstrings is nearly what a stub says. The differences: an argument may be any
array-like, path-like, sequence or mapping, and a struct's constructor takes its attributes as keywords.

    PYTHONPATH=build/python python3 make_stubs.py build/python/wristwise/__init__.pyi
"""

import inspect
import pathlib
import re
import sys

import wristwise

HEADER = '''# Made by make_stubs.py from the module.
import inspect
import os
import pathlib
import threading
from typing import Callable, ClassVar, Mapping, NoReturn, Optional, Sequence, Tuple, Union, overload

import numpy
from numpy.typing import ArrayLike, NDArray

_StrPath = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]

class _Class(type): ...

'''

# Plain type for an argument, and for what is given back.
ARGUMENT, RESULT = 0, 1
TYPES = [
    (r"IntArray\[[^\]]*\]", "ArrayLike", "NDArray[numpy.intc]"),
    (r"\bArray\[[^\]]*\]", "ArrayLike", "NDArray[numpy.float64]"),
    (r"\bPath\b", "Optional[_StrPath]", "Optional[pathlib.Path]"),
    (r"\bTuple\[(.*), \.\.\.\]", r"Sequence[\1]", r"Tuple[\1, ...]"),
    (r"wristwise\.", "", ""),
]


def python_type(text, use):
    text = text.strip()
    if "Callable[" in text:  # of a callback argument and result change places
        text = re.sub(r"^Tuple\[(.*), \.\.\.\]$", (r"Sequence[\1]", r"Tuple[\1, ...]")[use], text)
        return re.sub(r"\bArray\[[^\]]*\]", "NDArray[numpy.float64]", text)
    for pattern, argument, result in TYPES:
        text = re.sub(pattern, (argument, result)[use], text)
    if use == ARGUMENT:
        text = text.replace("Sequence[Optional[_StrPath]]", "Sequence[_StrPath]")
    return text.replace("Tuple[Optional[pathlib.Path], ...]", "Tuple[pathlib.Path, ...]")


def split_outside_brackets(text):
    parts, depth, start = [], 0, 0
    for i, c in enumerate(text):
        depth += (c in "[({<") - (c in "])}>" and text[i - 1:i + 1] != "->")
        if c == "," and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    return [part.strip() for part in parts + [text[start:]] if part.strip()]


def parameter(text):
    name, _, rest = text.partition(":")
    annotation, has_default, _ = rest.partition(" = ")
    if name == "self":
        return "self"
    return f"{name}: {python_type(annotation, ARGUMENT)}" + (" = ..." if has_default else "")


def docstring(text, indent):
    lines = [line for line in text.strip().splitlines()]
    if not lines:
        return ""
    body = "\n".join([lines[0]] + [(indent + line).rstrip() for line in lines[1:]])
    body = body.replace("\\", "\\\\")
    quote = ' ' if body.endswith('"') else ''
    return f'{indent}"""{body}{quote}"""\n'


def signatures(function):
    """Pairs of a pybind11 signature and its documentation; several where it is overloaded."""
    text = function.__doc__ or ""
    if "Overloaded function." in text.split("\n")[1:2] + text.split("\n")[:3]:
        blocks = re.split(r"\n\d+\. ", text)[1:]
    else:
        blocks = [text]
    for block in blocks:
        line, _, documentation = block.partition("\n")
        yield line, documentation


def function_stub(name, function, indent="", static=False):
    found = list(signatures(function))
    text = ""
    for line, documentation in found:
        arguments, result = re.fullmatch(r"\w+\((.*)\) -> (.*)", line).groups()
        parameters = ", ".join(parameter(part) for part in split_outside_brackets(arguments))
        text += f"{indent}@overload\n" if len(found) > 1 else ""
        text += f"{indent}@staticmethod\n" if static else ""
        text += f"{indent}def {name}({parameters}) -> {python_type(result, RESULT)}:\n"
        text += docstring(documentation, indent + "    ") + f"{indent}    ...\n"
    return text


def property_type(member):
    return re.search(r"-> (.*)", member.fget.__doc__).group(1)


def property_stub(name, member, indent):
    kind = property_type(member)
    text = f"{indent}@property\n{indent}def {name}(self) -> {python_type(kind, RESULT)}:\n"
    text += docstring(member.__doc__, indent + "    ") + f"{indent}    ...\n"
    if member.fset is not None:
        text += f"{indent}@{name}.setter\n"
        text += f"{indent}def {name}(self, value: {python_type(kind, ARGUMENT)}) -> None: ...\n"
    return text


def keywords(cls, optional):
    text = []
    for one in cls.__signature__.parameters.values():
        kind = python_type(property_type(vars(cls)[one.name]), ARGUMENT)
        has_default = optional or one.default is not inspect.Parameter.empty
        text.append(f"{one.name}: {kind}" + (" = ..." if has_default else ""))
    return ", ".join(["self", "*"] + text) if text else "self"


def constructor_stub(cls, indent):
    if not (cls.__init__.__doc__ or "").startswith("__init__("):
        return f"{indent}def __init__(self, *args: NoReturn, **kwargs: NoReturn) -> None: ...\n"
    if not hasattr(cls, "__signature__"):
        return function_stub("__init__", cls.__init__, indent)
    return (f"{indent}__signature__: ClassVar[inspect.Signature]\n"
            f"{indent}def __init__({keywords(cls, False)}) -> None: ...\n"
            f"{indent}def replace({keywords(cls, True)}) -> {cls.__qualname__}:\n"
            + docstring(cls.replace.__doc__.partition("\n")[2], indent + "    ")
            + f"{indent}    ...\n")


def enum_stub(cls, indent):
    text = f"{indent}__members__: ClassVar[Mapping[str, {cls.__qualname__}]]\n"
    for name in cls.__members__:
        text += f"{indent}{name}: ClassVar[{cls.__qualname__}]\n"
    return text + (f"{indent}def __init__(self, value: int) -> None: ...\n"
                   f"{indent}def __int__(self) -> int: ...\n"
                   f"{indent}def __index__(self) -> int: ...\n"
                   f"{indent}@property\n{indent}def name(self) -> str: ...\n"
                   f"{indent}@property\n{indent}def value(self) -> int: ...\n")


def is_stubbed_method(name, member):
    return callable(member) and (not name.startswith("_") or name == "__len__")


def bases(cls):
    base = cls.__mro__[1]
    if base.__module__ == "wristwise" or issubclass(cls, Exception):
        return base.__qualname__
    return "metaclass=_Class"


def class_stub(cls, indent=""):
    inner = indent + "    "
    text = f"{indent}class {cls.__name__}({bases(cls)}):\n" + docstring(class_doc(cls), inner)
    if hasattr(cls, "__members__"):
        return text + enum_stub(cls, inner) + "\n"
    members = vars(cls)
    for member in members.values():
        if inspect.isclass(member):
            text += class_stub(member, inner)
    if not issubclass(cls, Exception):
        text += constructor_stub(cls, inner)
    for name, member in members.items():
        if isinstance(member, property):
            text += property_stub(name, member, inner)
        elif isinstance(member, staticmethod):
            text += function_stub(name, getattr(cls, name), inner, static=True)
        elif name != "replace" and not inspect.isclass(member) and is_stubbed_method(name, member):
            text += function_stub(name, member, inner)
    return text + "\n"


def class_doc(cls):
    return (cls.__doc__ or "").partition("\n\nMembers:")[0]


def main():
    text = HEADER
    for name in wristwise.__all__:
        member = getattr(wristwise, name)
        text += (class_stub(member) if inspect.isclass(member) else function_stub(name, member) + "\n")
    pathlib.Path(sys.argv[1]).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
