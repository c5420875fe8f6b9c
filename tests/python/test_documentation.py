"""The examples in Python run, and are those of docs/python.md."""

import re
import runpy

import pytest

from conftest import SOURCE

EXAMPLES = sorted((SOURCE / "docs" / "examples").glob("*.py"))
PAGE = (SOURCE / "docs" / "python.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda file: file.stem)
def test_an_example_runs(example, tmp_path, monkeypatch):
    if "matplotlib" in example.read_text(encoding="utf-8"):
        pytest.importorskip("matplotlib").use("Agg")
    for folder in ("problems", "robots"):
        (tmp_path / folder).symlink_to(SOURCE / folder)
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(example), run_name="__main__")


def test_the_page_shows_the_examples():
    blocks = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    assert sorted(blocks) == sorted(file.read_text(encoding="utf-8") for file in EXAMPLES)
