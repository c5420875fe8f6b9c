"""Checks docs/architecture.md against the sources: names in folders, who includes which library, and
that the check shares nothing with what it checks."""

import fnmatch
import functools
import pathlib
import re

from pages import Page, Span
from references import Tree, with_alternatives

PAGE = "docs/architecture.md"
# First words of a row of the table of libraries -> how its headers are included.
LIBRARIES = {
    "urdfdom": r"urdf_(model|parser)/|console_bridge/", "TinyXML": r"tinyxml\.h", "yaml-cpp": "yaml-cpp/",
    "assimp": "assimp/", "Qhull": "libqhull", "Ceres": "ceres/", "nlohmann/json": "nlohmann/",
    "CLI11": "CLI/", "FCL": "fcl/", "Google Benchmark": "benchmark/benchmark", "NLopt": r"nlopt\.",
    "{fmt}": "fmt/", "Eigen": "Eigen/", "GoogleTest": "gtest/",
}


class Architecture:
    """The faults of the page."""

    def __init__(self, page: Page, tree: Tree):
        self.page, self.tree = page, tree
        self.faults: list[str] = []

    def check(self) -> list[str]:
        rows = [part for part in self.page.prose if part.text.startswith("| ")]
        for row in rows:
            self._parts_of_folder(row)
            self._library(row)
        self._independent_check()
        return self.faults

    @functools.cached_property
    def includes(self) -> dict[str, list[str]]:
        """What each source file includes."""
        files = [file for folder in ("src", "include", "tests")
                 for file in (self.tree.root / folder).rglob("*.[ch]pp") if "node_modules" not in file.parts]
        return {str(file.relative_to(self.tree.root)):
                re.findall(r'^#include [<"]([^>"]+)', file.read_text(), re.MULTILINE) for file in files}

    def _fault(self, line: int, text: str) -> None:
        self.faults.append(f"{self.page.where(line)}: {text}")

    def _parts_of_folder(self, row: Span) -> None:
        """Of a row `src/<folder>/` the bare names are files in that folder."""
        folder = re.match(r"\| `(src/\w+/)` \|", row.text)
        for name in re.findall(r"`([a-z][a-z0-9_*]*)`", row.text) if folder else []:
            if not self.tree.has(f"{folder[1]}{name}*"):
                self._fault(row.line, f"nothing in {folder[1]} is called '{name}'")

    def _library(self, row: Span) -> None:
        """Its headers are included by the files that are named, and by no others."""
        cells = [cell.strip() for cell in row.text.strip("| ").split(" | ")]
        header = next((header for name, header in LIBRARIES.items() if cells[0].startswith(name)), None)
        if header is None or cells[1] == "everywhere, public headers too":
            return
        named = patterns(cells[1])
        users = [file for file, included in self.includes.items()
                 if any(re.match(header, name) for name in included)]
        for file in users:
            if not any(fnmatch.fnmatch(file, pattern) for pattern in named):
                self._fault(row.line, f"{file} includes {cells[0]} too")
        if not users:
            self._fault(row.line, f"nothing includes {cells[0]}")

    def _independent_check(self) -> None:
        for file, included in self.includes.items():
            for name in included if file.startswith("src/verify/") else []:
                if re.match(r"(graph|refine)/", name):
                    self._fault(1, f"{file} includes {name}, which it is to check")


def patterns(cell: str) -> list[str]:
    """File names in backticks as patterns; one without a folder is in that of the one before."""
    found, folder = [], ""
    for name in re.findall(r"`([^`]+)`", cell):
        path = name if "/" in name else f"{folder}/{name}"
        folder = str(pathlib.PurePath(path).parent)
        found += [f"{path}*" if path.endswith("/") else path]
    return [one for pattern in found for one in with_alternatives(pattern)]
