"""Checks that what the pages name exists: links, anchors, pictures, files, formulas, C++ names."""

import functools
import glob
import pathlib
import re
import xml.etree.ElementTree

from pages import Page, Span

FOLDERS = "src|tests|include|docs|problems|robots"
LARGEST_DRAWING = 60_000  # bytes


def with_alternatives(pattern: str) -> list[str]:
    """`a.{hpp,cpp}` as the names it stands for."""
    braces = re.search(r"\{([^{}]*)\}", pattern)
    if not braces:
        return [pattern]
    return [name for choice in braces[1].split(",")
            for name in with_alternatives(pattern[:braces.start()] + choice + pattern[braces.end():])]


class Tree:
    """The files of a source tree."""

    def __init__(self, root: pathlib.Path):
        self.root = root

    @functools.cached_property
    def file_names(self) -> set[str]:
        return {file.name for folder in FOLDERS.split("|")
                for file in (self.root / folder).rglob("*") if "node_modules" not in file.parts}

    @functools.cached_property
    def formulas(self) -> set[str]:
        return set(re.findall(r"^### \((F\d+)\)", (self.root / "docs/formulation.md").read_text(),
                              re.MULTILINE))

    @functools.cached_property
    def public_words(self) -> set[str]:
        headers = (self.root / "include").rglob("*.hpp")
        return set(re.findall(r"\w+", " ".join(header.read_text() for header in headers)))

    def has(self, path: str) -> bool:
        return all(glob.glob(name, root_dir=self.root) for name in with_alternatives(path))

    def has_named(self, pattern: str) -> bool:
        return all(any(pathlib.PurePath(name).match(one) for name in self.file_names)
                   for one in with_alternatives(pattern))


class References:
    """The faults of one page."""

    def __init__(self, page: Page, pages: dict[str, Page], tree: Tree):
        self.page, self.pages, self.tree = page, pages, tree
        self.faults: list[str] = []

    def check(self) -> list[str]:
        for link in self.page.links:
            self._link(link)
        for code in self.page.code:
            self._files(code)
            self._public_name(code)
        for part in self.page.prose:
            self._formulas(part)
        return self.faults

    def _fault(self, span: Span, text: str) -> None:
        self.faults.append(f"{self.page.where(span.line)}: {text}")

    def _link(self, link: Span) -> None:
        if re.match(r"[a-z]+:", link.text):
            return  # of elsewhere
        path, _, anchor = link.text.partition("#")
        file = (self.page.file.parent / path).resolve() if path else self.page.file
        if not file.exists():
            return self._fault(link, f"a link to '{path}', which does not exist")
        if anchor:
            name = str(file.relative_to(self.tree.root))
            if name not in self.pages or anchor not in self.pages[name].anchors:
                self._fault(link, f"{name} has no heading '#{anchor}'")
        if file.suffix == ".svg":
            self._drawing(link, file)

    def _drawing(self, link: Span, file: pathlib.Path) -> None:
        if file.stat().st_size > LARGEST_DRAWING:
            self._fault(link, f"{file.name} has {file.stat().st_size} bytes, more than a drawing needs")
        try:
            xml.etree.ElementTree.parse(file)
        except xml.etree.ElementTree.ParseError as error:
            self._fault(link, f"{file.name}: {error}")

    def _files(self, code: Span) -> None:
        for path in re.findall(rf"(?:^|[\s(=])((?:{FOLDERS})/[\w.*{{}},/-]*[\w*}}/])", code.text):
            if not self.tree.has(path):
                self._fault(code, f"'{path}' does not exist")
        if re.fullmatch(r"[\w.*{},-]+\.(\{[\w,]+\}|cpp|hpp|py)", code.text):
            if not self.tree.has_named(code.text):
                self._fault(code, f"no file is called '{code.text}'")

    def _public_name(self, code: Span) -> None:
        for name in re.findall(r"\b[A-Z]\w*::[\w:]+", code.text):
            missing = set(re.split("::", name)) - self.tree.public_words
            if missing:
                self._fault(code, f"'{name}' is in no public header")

    def _formulas(self, part: Span) -> None:
        for label in re.findall(r"\((?:[^()]* )?(F\d+)\b", part.text):
            if label not in self.tree.formulas:
                self._fault(part, f"no formula {label}")
