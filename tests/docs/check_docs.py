"""check_docs.py SOURCE BUILD WHAT [PAGE...]: checks README.md and docs/*.md.

WHAT is `commands` (run the blocks of PAGE), `inline` (words of commands in the text), `references`
(links, files, formulas, names), `snippets` (YAML, JSON, C++ ...), `defaults` (of the problem file) or
`result_keys` (of result.json). One line a fault; exit status 1 where there is one, 77 (skipped) without
jsonschema and yaml."""

import importlib
import pathlib
import sys
import tempfile

import architecture
import commands
import formulas
import references
import result_keys
import shell_blocks
from pages import Page, all_pages


def command_faults(root: pathlib.Path, build: pathlib.Path, names: list[str]) -> list[str]:
    checker = commands.Checker(root, build)
    faults = []
    for name in names:
        with tempfile.TemporaryDirectory(prefix="wristwise_docs_") as folder:
            clone = shell_blocks.Clone(root, build, pathlib.Path(folder))
            run = shell_blocks.PageRun(Page(root, name), clone, checker)
            faults += run.run()
            print(f"{name}: {run.run_blocks} blocks run")
    return faults


def inline_faults(root: pathlib.Path, build: pathlib.Path) -> list[str]:
    checker = commands.Checker(root, build)
    pages = all_pages(root)
    faults = [f"{page.where(span.line)}: {fault}" for page in pages
              for span in page.code + page.synopses for fault in checker.faults(span.text)]
    return faults + [fault for page in pages if page.name == "docs/benchmarks.md"
                     for fault in without_command(page, checker)]


def without_command(page: Page, checker: commands.Checker) -> list[str]:
    """Sections in which no command says where the numbers come from."""
    starts = [number for number, line in enumerate(page.file.read_text().splitlines(), 1)
              if line.startswith("## ")]
    ends = [*starts[1:], 10**9]
    return [f"{page.where(start)}: a section without a command" for start, end in zip(starts, ends)
            if not any(start < code.line < end and checker.knows(code.text) for code in page.code)]


def reference_faults(root: pathlib.Path) -> list[str]:
    pages = {page.name: page for page in all_pages(root)}
    tree = references.Tree(root)
    faults = [fault for page in pages.values()
              for fault in references.References(page, pages, tree).check()]
    if architecture.PAGE in pages:
        faults += architecture.Architecture(pages[architecture.PAGE], tree).check()
    return faults + formulas.faults(pages[formulas.PAGE], tree)


def snippet_faults(root: pathlib.Path) -> list[str]:
    snippets = with_packages("snippets")
    reference = snippets.Reference(root)
    return [fault for page in all_pages(root)
            for fault in snippets.Snippets(page, reference).check()]


def default_faults(root: pathlib.Path, build: pathlib.Path) -> list[str]:
    defaults = with_packages("defaults")
    with tempfile.TemporaryDirectory(prefix="wristwise_docs_") as folder:
        return defaults.faults(root, build, pathlib.Path(folder))


def result_key_faults(root: pathlib.Path, build: pathlib.Path) -> list[str]:
    with tempfile.TemporaryDirectory(prefix="wristwise_docs_") as folder:
        keys = result_keys.keys_of_runs(root, build, pathlib.Path(folder))
    return result_keys.faults(Page(root, result_keys.PAGE), keys)


def with_packages(module: str):
    """A module that needs packages beside Python's own."""
    try:
        return importlib.import_module(module)
    except ImportError as missing:
        print(f"skipped: {missing}")
        sys.exit(77)


def main(root: pathlib.Path, build: pathlib.Path, what: str, names: list[str]) -> int:
    faults = {
        "commands": lambda: command_faults(root, build, names),
        "inline": lambda: inline_faults(root, build),
        "references": lambda: reference_faults(root),
        "snippets": lambda: snippet_faults(root),
        "defaults": lambda: default_faults(root, build),
        "result_keys": lambda: result_key_faults(root, build),
    }[what]()
    print("\n".join(faults) or f"{what}: no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    source, built = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    sys.exit(main(source, built, sys.argv[3], sys.argv[4:]))
