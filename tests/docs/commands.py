"""Checks words of commands without running them: programs, options, filters and files must exist."""

import functools
import json
import os
import pathlib
import re
import shlex
import subprocess

SUBCOMMANDS = re.compile(r"^  (\w+)  ", re.MULTILINE)
OPTION = re.compile(r"--[a-zA-Z][\w-]*")
OF_OTHERS = {"--benchmark_filter", "--help", "--version"}


def words_of(command: str) -> list[str]:
    """The program and its arguments."""
    try:
        words = shlex.split(command, comments=True)
    except ValueError:
        return []  # a piece of prose between backticks
    while words and (words[0] in ("time", "sudo") or re.match(r"\w+=", words[0])):
        words.pop(0)
    return words


def program_of(word: str) -> str:
    return re.sub(r"^(build/|tests/)*", "", word)


class Checker:
    """Knows the programs of a build and the files of a source tree."""

    def __init__(self, root: pathlib.Path, build: pathlib.Path):
        self.root, self.build = root, build

    def faults(self, command: str) -> list[str]:
        """What is wrong with a command line; nothing where it is none of ours."""
        words = words_of(command)
        check = self._check_of(words[0]) if words else None
        return [f"{fault}: {command.strip()}" for fault in check(words)] if check else []

    def knows(self, command: str) -> bool:
        """Whether it is a command line of ours."""
        words = words_of(command)
        return bool(words) and self._check_of(words[0]) is not None

    def _check_of(self, word: str):
        program = program_of(word)
        if program == "wristwise":
            return self._wristwise
        if program.endswith("_benchmark") or program == "random_seams_report":
            return self._measurement
        if program.endswith("_test"):
            return self._test
        if program == "ctest":
            return self._ctest
        if program == "./bootstrap.sh":
            return self._bootstrap
        if program.startswith("--"):
            return self._option_of_any
        if program.endswith(".py"):
            return self._script
        return None

    def without_installation(self, script: str) -> tuple[str, list[str]]:
        """The script without its calls of bootstrap.sh, which CI has run, and what is wrong with
        them. What runs all tests is left out where it is what CI runs."""
        ci = (self.root / ".ci/run").read_text().strip().splitlines()
        if script.strip() == ci[-1]:
            return "", []
        calls = re.findall(r"^\./bootstrap\.sh[^&\n]*", script, re.MULTILINE)
        faults = [fault for call in calls for fault in self.faults(call)]
        return re.sub(r"^\./bootstrap\.sh[^&\n]*(&& )?", "", script, flags=re.MULTILINE), faults

    @functools.lru_cache(maxsize=None)
    def _help(self, *command: str) -> str:
        program = self.build / command[0]
        if not program.exists():
            return ""
        return subprocess.run([program, *command[1:], "--help"], capture_output=True, text=True,
                              check=False).stdout

    @functools.cached_property
    def _subcommands(self) -> set[str]:
        listed = re.search(r"^(Subcommands:|Commands)\n(.*?)(\n\n|\Z)", self._help("wristwise"),
                           re.MULTILINE | re.DOTALL)
        return set(SUBCOMMANDS.findall(listed[2])) if listed else set()

    def _options(self, subcommand: str) -> set[str]:
        return set(OPTION.findall(self._help("wristwise", subcommand))) | OF_OTHERS

    def _wristwise(self, words: list[str]) -> list[str]:
        words = words[1:]
        if not self._subcommands:
            return ["wristwise is not built, or lists no subcommands"]
        subcommand = next((word for word in words if word in self._subcommands), None)
        if subcommand is None:
            own = set(OPTION.findall(self._help("wristwise")))
            unknown = [word for word in words if word[0] != "-" or word not in own | {"-h"}]
            return [f"no such command '{word}'" for word in unknown[:1]]
        faults = []
        for word in words:
            option = word.split("=")[0]
            if word.startswith("--") and option not in self._options(subcommand):
                faults.append(f"wristwise {subcommand} has no {option}")
            if re.match(r"(problems|robots)/", word) and not (self.root / word).exists():
                faults.append(f"no such file '{word}'")
        return faults

    def _measurement(self, words: list[str]) -> list[str]:
        program, words = program_of(words[0]), words[1:]
        binary = self.build / "tests" / program.split("/")[-1]
        if not binary.exists():
            return [f"{binary.name} is not built"]
        if not program.endswith("_benchmark"):
            known = OPTION.findall(self._help(f"tests/{binary.name}"))
            return [f"{program} has no {word}" for word in words
                    if word.startswith("--") and word not in known]
        if not any(word.startswith("--benchmark_filter=") for word in words):
            return []
        listed = subprocess.run([binary, "--benchmark_list_tests=true", *words],
                                capture_output=True, text=True, check=False)
        names = [line for line in listed.stdout.splitlines() if re.match(r"\w+", line)]
        return [] if listed.returncode == 0 and names else ["the filter finds no benchmark"]

    def _test(self, words: list[str]) -> list[str]:
        program = program_of(words[0])
        sources = [self.root / "tests" / f"{program}{suffix}" for suffix in (".cpp", ".py")]
        return [] if any(source.exists() for source in sources) else [f"no test '{program}'"]

    def _ctest(self, words: list[str]) -> list[str]:
        filters = [words[i + 1] for i, word in enumerate(words[:-1]) if word == "-R"]
        faults = []
        for pattern in filters:
            listed = subprocess.run(["ctest", "--show-only=json-v1", "-R", pattern], cwd=self.build,
                                    capture_output=True, text=True, check=False)
            if listed.returncode != 0 or not json.loads(listed.stdout)["tests"]:
                faults.append(f"no test is called '{pattern}'")
        return faults

    def _bootstrap(self, words: list[str]) -> list[str]:
        script = self.root / "bootstrap.sh"
        if not os.access(script, os.X_OK):
            return ["bootstrap.sh can't be run"]
        usage = re.findall(r"^#   \./bootstrap\.sh ?(\w*)", script.read_text(), re.MULTILINE)
        return [] if " ".join(words[1:]) in usage else ["bootstrap.sh does not take that"]

    def _script(self, words: list[str]) -> list[str]:
        exists = (self.root / words[0]).exists() or "/" not in words[0]
        return [] if exists else [f"no script '{words[0]}'"]

    def _option_of_any(self, words: list[str]) -> list[str]:
        option = OPTION.match(words[0])
        known = set().union(*(self._options(each) for each in self._subcommands))
        known |= set(OPTION.findall(self._help("wristwise")))
        known |= set(OPTION.findall(self._help("tests/random_seams_report")))
        return [] if option is None or option[0] in known else [f"nothing has {option[0]}"]
