"""Writes `kinegon/types.py`: the types of all files, from their committed schemas. After a change of a schema:

    python python/make_types.py
"""

from __future__ import annotations

import json
import keyword
import re
from pathlib import Path
from typing import Any

TYPES = Path(__file__).parent / "package" / "kinegon" / "types.py"
TEMPLATES = Path(__file__).parents[1] / "templates"
#: Kinds of files: the name of the whole, what the names of its parts begin with, and whether people write it.
KINDS = {
    "scene": ("SceneFile", "", True),
    "marks": ("MarksFile", "Marks", True),
    "style": ("StyleFile", "Style", True),
    "study": ("StudyFile", "Study", True),
    "result": ("Result", "", False),
    "check": ("CheckResult", "", False),
    "key": ("Key", "", False),
}
HEAD = '''"""The types of Kinegon's files and answers, for type checkers and editors. Made by `python/make_types.py` from the schemas; not to be changed here.

Scenes, styles, marking schemes and studies are what people write: a dict of these types is taken wherever their text is.
Results, keys and checks are what :meth:`Solution.result`, :meth:`Exercise.key` and ``Check.result`` give.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Literal, TypedDict, Union

if TYPE_CHECKING:
    from typing_extensions import NotRequired

'''


def schema(kind: str) -> dict[str, Any]:
    """The schema of a kind of file."""
    return json.loads((TEMPLATES / f"{kind}.schema.json").read_text("utf-8"))


class Writer:
    """Writes types; each before what needs it."""

    def __init__(self) -> None:
        self.parts: list[str] = []
        self.written: dict[str, str] = {}

    def file(self, kind: str) -> None:
        self.whole, self.prefix, self.is_input = KINDS[kind]
        self.root = schema(kind)
        self.named(self.whole, self.root)

    def named(self, name: str, node: dict[str, Any]) -> str:
        """The name of a type, which is written if it is not there yet."""
        text = json.dumps(node, sort_keys=True)
        if name not in self.written:
            self.written[name] = text
            if "properties" in node and node.get("additionalProperties") in (None, False):
                self.parts.append(self.record(name, node))
            else:
                self.parts.append(f"{said(node)}{name} = {self.type(node, name)}\n")
        elif self.written[name] != text:
            raise SystemExit(f"two types are called {name}")
        return name

    def record(self, name: str, node: dict[str, Any]) -> str:
        """An object with known keys."""
        required = node.get("required", [])
        fields, odd = [], []
        for key, value in node["properties"].items():
            if not self.is_input and key in ("note", "$schema"):
                continue
            own = self.type(value, f"{name}{camel(key)}")
            own = own if key in required else f"NotRequired[{own}]"
            is_name = key.isidentifier() and not keyword.iskeyword(key)
            (fields if is_name else odd).append((key, own, value.get("description", "")))
        base = "TypedDict"
        before = ""
        if odd:
            base = f"_{name}Keys"
            before = f"{base} = TypedDict({base!r}, {{{', '.join(f'{key!r}: {own!r}' for key, own, _ in odd)}}})\n\n\n".replace("'", '"')
        lines = [f"{before}class {name}({base}):", f'    """{doc(node.get("description", name))}"""', ""]
        for key, own, description in fields:
            lines += [f"    {key}: {own}"] + ([f'    """{doc(description)}"""'] if description else [])
        return "\n".join(lines) + "\n"

    def type(self, node: dict[str, Any], name: str = "") -> str:
        """The type of a value. An object in it is named after the key under which it stands."""
        if "$ref" in node:
            reference = node["$ref"].rpartition("/")[2]
            own = camel(reference)
            own = own if own.startswith(self.prefix) else self.prefix + own
            # The same part of two kinds of files has one type.
            shared, definition = camel(reference), self.root["$defs"][reference]
            is_shared = self.written.get(shared) == json.dumps(definition, sort_keys=True)
            return shared if is_shared else self.named(own, definition)
        choices = node.get("oneOf") or node.get("anyOf")
        if choices:
            values = [choice["const"] for choice in choices if "const" in choice]
            own = [literal(values)] if len(values) == len(choices) else [self.type(choice, name + camel(next(iter(choice.get("properties", [""]))))) for choice in choices]
            own = list(dict.fromkeys(own))
            return own[0] if len(own) == 1 else f"Union[{', '.join(own)}]"
        if "const" in node or "enum" in node:
            return literal(node.get("enum", [node.get("const")]))
        kind = node.get("type")
        if isinstance(kind, list):
            own = [self.type({**node, "type": one}, name) for one in kind]
            return f"Union[{', '.join(own)}]"
        many, by_name = ("Sequence", "Mapping") if self.is_input else ("list", "dict")
        if kind == "array":
            # A tuple is a sequence of whatever its places take.
            return f"{many}[{self.type(node.get('items') or {'anyOf': node['prefixItems']}, name)}]"
        if kind == "object":
            if isinstance(node.get("additionalProperties"), dict):
                return f"{by_name}[str, {self.type(node['additionalProperties'], name)}]"
            if node.get("additionalProperties") is False:
                return self.named(name, node)
            # What a study says of its scene.
            return "SceneFile"
        return {"string": "str", "number": "float", "integer": "int", "boolean": "bool", "null": "None", None: "object"}[kind]

    def options(self) -> str:
        """The keys of a figure as keywords: None takes one out."""
        figure = schema("scene")["$defs"]["figure"]["properties"]
        self.whole, self.prefix, self.is_input = KINDS["scene"]
        self.root = schema("scene")
        lines = ["class FigureKeys(TypedDict, total=False):", '    """Keys of a figure as keywords, but its style; None takes one out."""', ""]
        for key, value in figure.items():
            if key not in ("note", "style"):
                lines += [f"    {key}: {self.type(value)} | None", f'    """{doc(value["description"])}"""']
        lines += ["", "", "class FigureOptions(FigureKeys, total=False):", '    """Keys of a figure as keywords; None takes one out."""', ""]
        lines += [f"    style: {self.type(figure['style'])} | None", f'    """{doc(figure["style"]["description"])}"""']
        return "\n".join(lines) + "\n"


def camel(name: str) -> str:
    return "".join(part[:1].upper() + part[1:] for part in re.split(r"\W|_", name))


def literal(values: list[Any]) -> str:
    return f"Literal[{', '.join(json.dumps(value) for value in values)}]"


def doc(text: str) -> str:
    """A description in a docstring, on lines that can be read."""
    text = " ".join(text.split()).replace("\\", "\\\\")
    return f"{text} " if text.endswith('"') else text


def said(node: dict[str, Any]) -> str:
    return f"#: {doc(node['description'])}\n" if node.get("description") else ""


def module() -> str:
    """The text of the module."""
    writer = Writer()
    for kind in KINDS:
        writer.file(kind)
    parts = [*writer.parts, writer.options()]
    return HEAD + "\n" + "\n\n".join(part.rstrip("\n") + "\n" for part in parts)


if __name__ == "__main__":
    TYPES.write_text(module(), "utf-8")
