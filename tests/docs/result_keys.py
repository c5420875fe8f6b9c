"""Checks docs/results.md: it names every key of the result.json of some runs, and no others."""

import json
import pathlib
import re

from pages import Page
from shell_blocks import Clone

PAGE = "docs/results.md"
COORDINATES = {"x", "y", "z", "rx", "ry", "rz"}
DESCRIBED_ELSEWHERE = {"before", "after"}
# A seam with runs and a stop; one with no way through; one that must be slowed down; a joint path.
RUNS = r"""
mkdir my
sed 's/ry: 10 deg/ry: 3 deg/; s/^graph:/graph:\n  try_relaxations: false/' problems/task_b_l_profile.yaml > problems/narrow.yaml
sed 's/speed: 0.01/speed: 6\n  speed_policy: slow/' problems/task_b_l_profile.yaml > problems/fast.yaml
wristwise --quiet plan problems/corner_stop.yaml --no-report --out my/corner
wristwise --quiet plan problems/narrow.yaml --mode graph-only --no-report --out my/narrow || [ $? = 1 ]
wristwise --quiet plan problems/fast.yaml --no-report --out my/fast
wristwise --quiet smooth --urdf robots/kuka_kr5_arc/kuka_kr5_arc_round_torch.urdf --tip torch_tip \
  --limits robots/kuka_kr5_arc/joint_limits.yaml --joints problems/recorded_path.csv \
  --keep 0.5mm,0.5deg --no-report --out my/smooth
"""


def keys_of(value, prefix: str, joints: set[str]) -> set[str]:
    """The paths to everything that is no map; items of a list count as one."""
    if isinstance(value, list):
        below = set().union(*(keys_of(item, prefix, joints) for item in value)) if value else set()
        return below or {prefix}
    if not isinstance(value, dict):
        return {prefix}
    found = set()
    for key, item in value.items():
        name = "JOINT" if key in joints else "COORDINATE" if key in COORDINATES else key
        path = f"{prefix}.{name}" if prefix else name
        found |= {path} if path in DESCRIBED_ELSEWHERE else keys_of(item, path, joints)
    return found


def written(folder: pathlib.Path) -> set[str]:
    found = set()
    for file in folder.rglob("result.json"):
        result = json.loads(file.read_text())
        found |= keys_of(result, "", set(result["joints"]))
    # A list or a map that is empty here and has keys there.
    return {key for key in found if not any(other.startswith(f"{key}.") for other in found)}


def described(page: Page) -> set[str]:
    text = page.file.read_text().split("## result.json")[1]
    return {key for row in re.findall(r"^\| (`[^|]*`) \|", text, re.MULTILINE)
            for key in re.findall(r"`([^`]+)`", row)}


def keys_of_runs(root: pathlib.Path, build: pathlib.Path, folder: pathlib.Path) -> set[str]:
    clone = Clone(root, build, folder)
    status, printed = clone.run(RUNS)
    if status != 0:
        raise ValueError(f"exit status {status} of the runs\n{printed}")
    return written(folder / "my")


def faults(page: Page, keys: set[str]) -> list[str]:
    on_page = described(page)
    return [f"{PAGE}: '{key}' is written, and not described" for key in sorted(keys - on_page)] + [
        f"{PAGE}: '{key}' is described, and not written" for key in sorted(on_page - keys)]
