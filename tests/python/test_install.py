"""The package as `cmake --install` puts it."""

import os
import subprocess
import sys

import pytest


@pytest.mark.parametrize("prefix, folder", [
    ("usr", "lib/python3/dist-packages"),
    ("opt", f"lib/python{sys.version_info.major}.{sys.version_info.minor}/dist-packages"),
])
@pytest.mark.skipif(not os.path.exists("/etc/debian_version"), reason="Debian's folders")
def test_an_installed_package_can_be_imported(tmp_path, prefix, folder):
    if "WRISTWISE_BUILD_DIR" not in os.environ:
        pytest.skip("no build to install")
    subprocess.run(["cmake", "--install", os.environ["WRISTWISE_BUILD_DIR"], "--component", "python",
                    "--prefix", tmp_path / prefix], check=True, capture_output=True)
    installed = tmp_path / prefix / folder
    assert {"__init__.py", "__init__.pyi", "py.typed"} < {
        file.name for file in (installed / "wristwise").iterdir()}
    found = subprocess.run([sys.executable, "-c", "import wristwise; print(wristwise.__file__)"],
                           env={"PYTHONPATH": str(installed)}, cwd=tmp_path,
                           capture_output=True, text=True, check=True)
    assert found.stdout.strip() == str(installed / "wristwise" / "__init__.py")
