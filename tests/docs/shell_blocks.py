"""Runs the commands of a page. What counts as a command, and what may follow it, is said for readers
in docs/README.md:

- a block `sh` is run, from top to bottom, and ends with status 0 or the one of its `# exit status N`;
- a line with `# by hand` is not run; of that its words are checked (commands.py);
- a block `yaml` whose first line is `# folder/file.yaml` is written there;
- a block `console` is what the commands above it print, words alike and numbers within 5%, times in s
  aside; `...` stands for what is left out. Lines in it that begin with `$ ` are commands themselves.
"""

import os
import pathlib
import re
import shutil
import subprocess

import commands
from pages import Block, Page

BY_HAND = "# by hand"
COPIED = ["problems", "robots", "docs", "bootstrap.sh", "README.md"]
LINKED = ["src", "include", "tests"]
NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"


class Clone:
    """A folder that looks like a clone of the repository with a build in it, and may be written to."""

    def __init__(self, root: pathlib.Path, build: pathlib.Path, folder: pathlib.Path):
        self.folder = folder
        for name in COPIED:
            copy = shutil.copytree if (root / name).is_dir() else shutil.copy
            if (root / name).exists():
                copy(root / name, folder / name)
        for name in LINKED:
            (folder / name).symlink_to(root / name)
        (folder / "build").symlink_to(build)
        self.environment = dict(os.environ, HOME=str(folder), PYTHONDONTWRITEBYTECODE="1")
        self.environment["PATH"] = f"{build}:{os.environ['PATH']}"

    def write_named(self, text: str) -> None:
        """Writes a file where its first line says which."""
        name = re.match(r"# (\w[\w./-]*/[\w.-]+)$", text.split("\n", 1)[0])
        if name:
            (self.folder / name[1]).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name[1]).write_text(text)

    def run(self, script: str) -> tuple[int, str]:
        """Exit status and all that is printed."""
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", script], cwd=self.folder, env=self.environment,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            errors="replace", timeout=300, check=False)
        return done.returncode, done.stdout


def logical_lines(script: str) -> list[str]:
    """Lines, those that end in a backslash joined with the next."""
    return re.sub(r"\\\n", "\\\0", script).splitlines()


def split_by_hand(script: str) -> tuple[str, list[str]]:
    """What is to be run, and the lines that are not."""
    lines = logical_lines(script)
    run = [line.replace("\0", "\n") for line in lines if BY_HAND not in line]
    left = [line.replace("\\\0", " ") for line in lines if BY_HAND in line]
    return "\n".join(run), left


def expected_status(script: str) -> int:
    stated = re.findall(r"# exit status (\d+)", script)
    return int(stated[-1]) if stated else 0


def difference(sample: str, output: str) -> str:
    """In what a sample differs from what was printed; empty where it does not."""
    printed = " ".join(output.split())
    start = 0
    for part in re.split(r"\.\.\.", sample):
        words = " ".join(part.split())
        if not words:
            continue
        pattern = f"({NUMBER})".join(re.escape(between) for between in re.split(NUMBER, words))
        nearest = ""
        for found in re.compile(pattern).finditer(printed, start):
            nearest = _numbers_off(words, found)
            if not nearest:
                start = found.end()
                break
        else:
            return nearest or f"not printed: {words}"
    return ""


def _numbers_off(words: str, found: re.Match) -> str:
    numbers = zip(re.finditer(NUMBER, words), found.groups())
    for stated, measured in numbers:
        is_time = re.match(r" s\b", words[stated.end():])
        off = abs(float(stated[0]) - float(measured))
        if not is_time and off > 0.05 * abs(float(measured)) + 1e-6:
            return f"printed is {measured}, not {stated[0]}: {words}"
    return ""


class PageRun:
    """The commands of a page, run one block after the other in a clone."""

    def __init__(self, page: Page, clone: Clone, checker: commands.Checker):
        self.page, self.clone, self.checker = page, clone, checker
        self.faults: list[str] = []
        self.printed = ""  # by the last commands
        self.run_blocks = 0

    def run(self) -> list[str]:
        for block in self.page.blocks:
            if block.language == "sh":
                self._run(block, block.text)
            elif block.language == "console":
                self._session(block)
            elif block.language == "yaml":
                self.clone.write_named(block.text)
        return self.faults

    def _fault(self, block: Block, text: str) -> None:
        self.faults.append(f"{self.page.where(block.line)}: {text}")

    def _run(self, block: Block, script: str) -> None:
        to_run, by_hand = split_by_hand(script)
        for line in by_hand:
            for fault in self.checker.faults(line.split(BY_HAND)[0]):
                self._fault(block, fault)
        to_run, faults = self.checker.without_installation(to_run)
        for fault in faults:
            self._fault(block, fault)
        if not to_run.strip():
            self.printed = ""
            return
        status, self.printed = self.clone.run(to_run)
        self.run_blocks += 1
        if status != expected_status(script):
            self._fault(block, f"exit status {status} of\n{to_run}\n{self.printed}")

    def _session(self, block: Block) -> None:
        steps = re.split(r"^\$ ", block.text, flags=re.MULTILINE)
        self._compare(block, steps[0])
        for step in steps[1:]:
            end = re.search(r"(?<!\\)\n", step).end()
            self._run(block, step[:end])
            self._compare(block, step[end:])

    def _compare(self, block: Block, sample: str) -> None:
        if sample.strip() and (fault := difference(sample, self.printed)):
            self._fault(block, f"{fault}\nof what is printed:\n{self.printed}")
