"""Checks that the defaults that are stated are those that are used: a problem with every default of
the schema written into it gives the same bytes as without, and problem-file.md has the same ones."""

import copy
import json
import pathlib
import re

import yaml

from pages import Page
from shell_blocks import Clone
from snippets import Loader

PAGE = "docs/problem-file.md"
PROBLEM = "problems/task_c_wrist_singularity.yaml"
FORMATS = "krl,rapid,ls,trajectory_msgs,moveit"
OUTPUT = ["trajectory.csv", "trajectory_dense.csv", "*.src", "*.mod", "*.ls", "*.yaml"]
NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"


def stated(schema: dict) -> dict:
    """The defaults of each section, as nested as the keys are."""
    return {section: defaults_in(value) for section, value in schema["properties"].items()}


def defaults_in(place: dict) -> dict:
    """Without those of maps that say nothing unless some key is given."""
    found = {}
    for key, value in place.get("properties", {}).items():
        if "default" in value:
            found[key] = value["default"]
        elif "required" not in value and (below := defaults_in(value)):
            found[key] = below
    return found


def completed(problem: dict, defaults: dict) -> dict:
    """The problem with the defaults of the keys that it does not have."""
    result = copy.deepcopy(problem)
    for key, value in defaults.items():
        if isinstance(value, dict) and isinstance(result.get(key, {}), dict):
            result[key] = completed(result.get(key, {}), value)
        elif key not in result:
            result[key] = copy.deepcopy(value)
    return result


def output_of(clone: Clone, problem: dict, name: str) -> dict[str, bytes]:
    """What is planned and exported, by file name."""
    (clone.folder / "problems/defaults.yaml").write_text(yaml.safe_dump(problem))
    status, printed = clone.run(
        f"wristwise --quiet plan problems/defaults.yaml --no-report --out {name} --export {FORMATS}")
    if status != 0:
        raise ValueError(printed)
    folder = clone.folder / name
    return {file.name: file.read_bytes() for pattern in OUTPUT for file in folder.glob(pattern)}


def value_of_cell(cell: str):
    """A default as the page writes it; words where it is said in words."""
    text = cell.strip("` ").replace("zero", "0")
    if re.fullmatch(NUMBER, text):
        return float(text)
    value = yaml.load(text, Loader)
    return [str(item) for item in value] if isinstance(value, list) else value


def faults_of_page(page: Page, schema: dict) -> list[str]:
    faults, section, columns = [], "", []
    for part in page.prose:
        heading = re.match(r"##+ ([\w.]+)", part.text)
        if heading:
            section, columns = heading[1], []
        if not part.text.startswith("| "):
            continue
        cells = [cell.strip() for cell in part.text.strip()[1:-1].split("|")]
        if cells[0] == "key":
            columns = cells
            continue
        row = dict(zip(columns, cells))
        faults += [f"{page.where(part.line)}: {fault}" for key, cell in keys_and_defaults(row)
                   for fault in faults_of_key(f"{section}.{key}", cell, schema)]
    return faults


def keys_and_defaults(row: dict[str, str]) -> list[tuple[str, str]]:
    """Of a row with several keys each has the default at its place, or all have the same."""
    if "default" not in row:
        return []
    keys = re.findall(r"`([\w.]+)[`:]", row["key"])
    defaults = row["default"].split(", ")
    if len(defaults) != len(keys) or len(keys) == 1:
        defaults = [row["default"]] * len(keys)
    return list(zip(keys, defaults))


def faults_of_key(dotted: str, cell: str, schema: dict) -> list[str]:
    place = schema
    for key in dotted.split("."):
        place = place.get("properties", {}).get(key, {})
    if "default" not in place:
        return []
    of_schema = place["default"]
    if isinstance(of_schema, list):
        of_schema = [str(item) for item in of_schema]
    if value_of_cell(cell) == of_schema:
        return []
    return [f"{dotted} is {cell} by default, {of_schema} in the schema"]


def faults(root: pathlib.Path, build: pathlib.Path, folder: pathlib.Path) -> list[str]:
    schema = json.loads((root / "docs/problem-file.schema.json").read_text())
    found = faults_of_page(Page(root, PAGE), schema)
    clone = Clone(root, build, folder)
    problem = yaml.load((root / PROBLEM).read_text(), Loader)
    without = output_of(clone, problem, "without")
    with_all = output_of(clone, completed(problem, stated(schema)), "with")
    if len(without) < len(OUTPUT):
        found.append(f"only {sorted(without)} is written")
    return found + [f"{name} is another one with the schema's defaults in the problem"
                    for name in without if without[name] != with_all.get(name)]
