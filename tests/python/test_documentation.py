"""The Python of docs/python.md, run as it stands there."""

import re
import runpy

import pytest

from conftest import SOURCE

PAGE = SOURCE / "docs" / "python.md"
BLOCKS = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("block", BLOCKS, ids=lambda block: block.splitlines()[0][:40])
def test_an_example_runs(block, tmp_path, monkeypatch):
    if "matplotlib" in block:
        matplotlib = pytest.importorskip("matplotlib")
        matplotlib.use("Agg")
    for folder in ("problems", "robots"):
        (tmp_path / folder).symlink_to(SOURCE / folder)
    monkeypatch.chdir(tmp_path)
    script = tmp_path / "example.py"
    script.write_text(block, encoding="utf-8")
    runpy.run_path(str(script), run_name="__main__")


def test_there_are_examples():
    assert len(BLOCKS) >= 5
