"""Checks what stands in fenced blocks and is no command: YAML, JSON, XML, C++, Python, CMake."""

import copy
import functools
import json
import pathlib
import re
import xml.etree.ElementTree

import jsonschema
import yaml

from pages import Block, Page, Span

NOT_CHECKED = {"text", "math", "mermaid"}
CHECKED_ELSEWHERE = {"sh", "console"}  # shell_blocks.py
# A fragment in one of these languages must be part of a file that is built or run.
SOURCES = {
    "cpp": ["docs/examples/*.cpp", "tests/**/*.cpp"],
    "python": ["docs/examples/*.py", "tests/**/*.py"],
    "cmake": ["docs/examples/CMakeLists.txt", "tests/**/CMakeLists.txt"],
}
OF_OTHER_FILES = {"joint_limits"}  # keys of YAML files that are no problem
SECTIONS = "robot|scene|path|cost|graph|refine|controller|export|placement"


class Loader(yaml.SafeLoader):
    """`off` is a word, as in YAML 1.2."""


Loader.yaml_implicit_resolvers = {
    first: [pair for pair in pairs if pair[0] != "tag:yaml.org,2002:bool"]
    for first, pairs in yaml.SafeLoader.yaml_implicit_resolvers.items()
}
Loader.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile("^(true|false)$"), list("tf"))


def says_what_is_required(key: str, value) -> bool:
    """Of a schema's entries those that ask for keys, or for some of several."""
    if key in ("oneOf", "anyOf"):
        return all(set(choice) <= {"required", "not"} for choice in value)
    return key == "not" or (key == "required" and isinstance(value, list))


def without_required(schema):
    """The schema for a fragment, in which nothing need be."""
    if isinstance(schema, list):
        return [without_required(item) for item in schema]
    if not isinstance(schema, dict):
        return schema
    return {key: without_required(value) for key, value in schema.items()
            if not says_what_is_required(key, value)}


class Reference:
    """What the fragments are held against."""

    def __init__(self, root: pathlib.Path):
        self.root = root
        self.schema = json.loads((root / "docs/problem-file.schema.json").read_text())
        self.fragment = jsonschema.Draft202012Validator(without_required(copy.deepcopy(self.schema)))

    @functools.lru_cache(maxsize=None)
    def sources(self, language: str) -> tuple[str, ...]:
        files = [file for pattern in SOURCES[language] for file in self.root.glob(pattern)]
        return tuple(bare(file.read_text()) for file in files)

    @functools.cached_property
    def keys_of_results(self) -> set[str]:
        """Words in quotes of the code that writes result.json and placement.json."""
        writers = [*self.root.glob("src/io/*.cpp"), *self.root.glob("src/app/*.cpp")]
        return set(re.findall(r'"(\w+)"', " ".join(writer.read_text() for writer in writers)))

    def has_key(self, dotted: str) -> bool:
        place = self.schema
        for key in dotted.split("."):
            place = place.get("properties", {}).get(key)
            if place is None:
                return dotted.split(".")[-1] in self.keys_of_results
        return True


def bare(text: str) -> str:
    """Without indentation and empty lines."""
    return "\n".join(line.strip() for line in text.splitlines() if line.strip())


class Snippets:
    """The faults of one page."""

    def __init__(self, page: Page, reference: Reference):
        self.page, self.reference = page, reference
        self.faults: list[str] = []

    def check(self) -> list[str]:
        for block in self.page.blocks:
            fault = self._block(block)
            if fault:
                self.faults.append(f"{self.page.where(block.line)}: {fault}")
        for code in self.page.code:
            self._key(code)
        return self.faults

    def _block(self, block: Block) -> str:
        if block.language in NOT_CHECKED | CHECKED_ELSEWHERE:
            return ""
        if block.language in SOURCES:
            is_part = any(bare(block.text) in text for text in self.reference.sources(block.language))
            return "" if is_part else f"in no {block.language} file that is built or run"
        readers = {"yaml": self._yaml, "json": self._json, "xml": self._xml}
        if block.language not in readers:
            return f"a block of language '{block.language}'; see docs/README.md"
        return readers[block.language](block.text)

    def _yaml(self, text: str) -> str:
        text = re.sub(r"^\s*\.\.\.$", "", text, flags=re.MULTILINE)
        try:
            fragment = yaml.load(text, Loader)
        except yaml.YAMLError as error:
            return str(error)
        if not isinstance(fragment, dict):
            return "no map of keys"
        if set(fragment) <= OF_OTHER_FILES:
            return ""
        return "; ".join(f"{error.json_path}: {error.message}"
                         for error in self.reference.fragment.iter_errors(fragment))

    def _json(self, text: str) -> str:
        try:
            json.loads(text)
        except json.JSONDecodeError as error:
            return str(error)
        return ""

    def _xml(self, text: str) -> str:
        try:
            xml.etree.ElementTree.fromstring(f"<fragment>{text}</fragment>")
        except xml.etree.ElementTree.ParseError as error:
            return str(error)
        return ""

    def _key(self, code: Span) -> None:
        dotted = re.match(rf"(?:{SECTIONS})(?:\.[a-z_0-9]+)+(?=$|:|\s)", code.text)
        if dotted and not re.search(r"\.(csv|svg|json|yaml|html|md)$", dotted[0]):
            if not self.reference.has_key(dotted[0]):
                self.faults.append(f"{self.page.where(code.line)}: no key '{dotted[0]}'")
