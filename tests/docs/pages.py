"""Markdown pages as the checks see them: fenced blocks, code in the text, links, headings."""

import dataclasses
import functools
import pathlib
import re


@dataclasses.dataclass(frozen=True)
class Block:
    """A fenced block: its language, its text without indentation, the line of its fence."""

    language: str
    text: str
    line: int


@dataclasses.dataclass(frozen=True)
class Span:
    """A piece of text and the line on which it begins."""

    text: str
    line: int


class Page:
    """One page. `name` is its path from the top of the source tree."""

    def __init__(self, root: pathlib.Path, name: str):
        self.root = root
        self.name = name
        self.file = root / name
        self.blocks: list[Block] = []
        self._prose: list[str] = []  # line by line, those of blocks empty
        self._read(self.file.read_text(encoding="utf-8").splitlines())

    def _read(self, lines: list[str]) -> None:
        fence = None
        for number, line in enumerate(lines, 1):
            mark = re.match(r"( *)```(.*)$", line)
            if fence is None and mark:
                fence, text = (len(mark[1]), mark[2].strip(), number), []
            elif fence is not None and mark and not mark[2].strip():
                self.blocks.append(Block(fence[1], "".join(f"{t}\n" for t in text), fence[2]))
                fence = None
            elif fence is not None:
                text.append(line[min(fence[0], len(line) - len(line.lstrip())):])
            else:
                self._prose.append(line)
                continue
            self._prose.append("")
        if fence is not None:
            raise ValueError(f"{self.name}:{fence[2]}: a block that does not end")

    def where(self, line: int) -> str:
        return f"{self.name}:{line}"

    @functools.cached_property
    def prose(self) -> list[Span]:
        """Paragraphs, list items and table rows: what a pair of backticks stays inside of."""
        parts: list[Span] = []
        for number, line in enumerate(self._prose, 1):
            starts = re.match(r"\s*([-*|#]|\d+\.)\s?|\s*$", line)
            if starts or not parts or not parts[-1].text:
                parts.append(Span(line, number))
            else:
                parts[-1] = Span(f"{parts[-1].text}\n{line}", parts[-1].line)
        return parts

    @functools.cached_property
    def code(self) -> list[Span]:
        """What stands between backticks."""
        return [
            Span(" ".join(found[1].split()), part.line + part.text.count("\n", 0, found.start()))
            for part in self.prose
            for found in re.finditer(r"`([^`]+)`", part.text)
        ]

    @functools.cached_property
    def synopses(self) -> list[Span]:
        """Lines of blocks `text` that say how a command is called, without their brackets."""
        found = []
        for block in self.blocks:
            text = re.sub(r"\n +(?=\[?--)", " ", block.text) if block.language == "text" else ""
            found += [Span(re.sub(r"[\[\]]", "", line), block.line)
                      for line in text.splitlines() if line.startswith("wristwise ")]
        return found

    @functools.cached_property
    def links(self) -> list[Span]:
        """Targets of links and of pictures."""
        return [
            Span(found[1], part.line + part.text.count("\n", 0, found.start()))
            for part in self.prose
            for found in re.finditer(r"\]\(([^()\s]+)\)", re.sub(r"`[^`]*`", "``", part.text))
        ]

    @functools.cached_property
    def anchors(self) -> set[str]:
        """The headings' anchors, as GitHub makes them."""
        found: set[str] = set()
        for line in self._prose:
            heading = re.match(r"#+\s+(.*)$", line)
            if not heading:
                continue
            words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).strip().lower()
            anchor = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
            number = 0
            while (numbered := f"{anchor}-{number}" if number else anchor) in found:
                number += 1
            found.add(numbered)
        return found


def all_pages(root: pathlib.Path) -> list[Page]:
    """README.md and the pages of docs/."""
    names = ["README.md"]
    names += sorted(str(file.relative_to(root)) for file in (root / "docs").rglob("*.md"))
    return [Page(root, name) for name in names]
