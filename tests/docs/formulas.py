"""Checks docs/formulation.md: every label that code or tests use is a section there, in its table, and
says where its code and its test are."""

import re

from pages import Page
from references import Tree

PAGE = "docs/formulation.md"


def faults(page: Page, tree: Tree) -> list[str]:
    text = page.file.read_text()
    sections = dict(re.findall(r"^### \((F\d+)\)[^\n]*\n(.*?)(?=^##|\Z)", text, re.MULTILINE | re.DOTALL))
    listed = set(re.findall(r"\| (F\d+) ", text))
    found = [f"{page.name}: ({label}) has no line '{word}'" for label, body in sections.items()
             for word in ("Code", "Test") if not re.search(rf"\b{word}s?:", body)]
    found += [f"{page.name}: {label} is not in the table" for label in set(sections) - listed]
    for folder in ("src", "include", "tests"):
        for file in (tree.root / folder).rglob("*.[ch]pp"):
            for label in set(re.findall(r"\((F\d+)\b", file.read_text())) - set(sections):
                found.append(f"{file.relative_to(tree.root)}: no formula {label}")
    return found
