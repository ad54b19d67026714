"""Writes `docs/python-api.md`, the reference of the package for Python, from its signatures and docstrings. After a change of them:

    python python/make_api.py           # needs griffe
"""

from __future__ import annotations

import re
from pathlib import Path

import griffe

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "python-api.md"
HEAD = """# Reference of the Python library

[Kinegon from Python](python.md) shows how these belong together. This page is made by `python/make_api.py` from signatures and docstrings. Types of files and results, as `Result` and `SceneFile`, stand in `kinegon.types`, with a
line for each of their keys; editors show them.
"""
#: In which order they are read.
ORDER = ["Scene", "Builder", "Solution", "Table", "Exercise", "Check", "Study", "KinegonError"]
#: Of what Python calls by itself, these are said, too.
SPECIAL = ("__init__", "__len__", "__getitem__", "__eq__")


def code(text: str) -> str:
    """A block of code, which nobody is to run."""
    return re.sub(r"(?m)^(?=.)", "    ", text)


def prose(text: str) -> str:
    """A docstring's text as Markdown."""
    # What is called so in a command line is not to be tried.
    text = re.sub(r"``(kinegon [^`]+)``", r"*\1*", text)
    text = re.sub(r":(?:class|meth|attr):`~?(?:kinegon\\.)?([^`]+)`", r"`\1`", text)
    text = re.sub(r"``([^`]+)``", r"`\1`", text)
    return text.replace("::\n", ":\n")


def sections(docstring: griffe.Docstring | None) -> list[str]:
    """The parts of a docstring."""
    parts = []
    for section in docstring.parse("google", warnings=False) if docstring else []:
        kind, value = section.kind.value, section.value
        if kind == "text":
            parts.append(prose(value))
        elif kind == "examples":
            parts += [code(text) if of.value == "examples" else prose(text) for of, text in value]
        elif kind == "raises":
            parts.append("\n".join(f"- raises `{one.annotation}`: {prose(' '.join(one.description.split()))}" for one in value))
        else:
            parts.append("\n".join(f"- `{one.name}`: {prose(' '.join(one.description.split()))}" for one in value))
    return parts


def signature(function: griffe.Function, name: str) -> str:
    """How a function is called."""
    shown = []
    mark = ""
    for parameter in function.parameters:
        kind = parameter.kind
        if parameter.name in ("self", "cls"):
            continue
        if kind is griffe.ParameterKind.keyword_only and mark == "":
            shown.append("*")
        mark = mark or {griffe.ParameterKind.keyword_only: "*", griffe.ParameterKind.var_positional: "*"}.get(kind, "")
        stars = {griffe.ParameterKind.var_positional: "*", griffe.ParameterKind.var_keyword: "**"}.get(kind, "")
        default = f" = {parameter.default}" if parameter.default is not None and not stars else ""
        shown.append(f"{stars}{parameter.name}: {parameter.annotation}{default}")
    returns = f" -> {function.returns}" if function.returns is not None and name != function.parent.name else ""
    line = f"{name}({', '.join(shown)}){returns}"
    return line if len(line) <= 100 else f"{name}(\n    " + ",\n    ".join(shown) + f",\n){returns}"


def function(of: griffe.Function, name: str) -> str:
    calls = [signature(one, name) for one in of.overloads or [of]]
    return "\n\n".join([code("\n".join(calls)), *sections(of.docstring)])


def class_page(of: griffe.Class) -> str:
    """A class with its members, in the order of its file."""
    parts = [f"## {of.name}", *sections(of.docstring)]
    made = of.members.get("__init__")
    if made is not None and made.docstring is None and not of.name.endswith("Error") and public(made):
        parts.insert(1, code(signature(made, of.name)))
    for name, member in of.members.items():
        is_shown = not name.startswith("_") or (name in SPECIAL and name != "__init__" and member.docstring is not None)
        if member.is_alias or not is_shown:
            continue
        if member.is_function:
            parts += [f"### {of.name}.{name}", function(member, name)]
        elif member.is_attribute and member.docstring is not None:
            kind = f": {member.annotation}" if member.annotation is not None else ""
            said = " ".join(prose(member.docstring.value).split())
            parts.append(f"- `{name}{kind}`: {said}")
    # Lines of one list stand together.
    return re.sub(r"(?m)(^- .*)\n\n(?=- )", r"\1\n", "\n\n".join(parts))


def public(made: griffe.Function) -> bool:
    """Whether people call it: nothing that they make takes a part in Rust."""
    return "_kinegon" not in " ".join(str(parameter.annotation) for parameter in made.parameters)


def page() -> str:
    """The text of the page."""
    package = griffe.load("kinegon", search_paths=[str(ROOT / "python" / "package")], allow_inspection=False)
    names = sorted(set(package.exports) - {"__version__"}, key=lambda name: (ORDER.index(name) if name in ORDER else len(ORDER), name))
    objects = [package[name].final_target if package[name].is_alias else package[name] for name in map(str, names)]
    classes = [class_page(one) for one in objects if one.is_class]
    constants = [f"- `{one.name}: {one.annotation}`: {prose(one.docstring.value)}" for one in objects if one.is_attribute and one.docstring]
    return "\n\n".join([HEAD.strip(), "\n".join(constants), *classes]) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
