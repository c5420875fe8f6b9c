import os
import pathlib
import sys

import numpy
import pytest

import wristwise

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tests"))


@pytest.fixture(scope="session")
def source():
    return SOURCE


@pytest.fixture(scope="session")
def program():
    """The command line program."""
    return os.environ.get("WRISTWISE_PROGRAM", str(SOURCE / "build" / "wristwise"))


@pytest.fixture
def load(source):
    def load_shipped(name):
        return wristwise.load_problem(source / "problems" / f"{name}.yaml",
                                      wristwise.LoadOptions(mesh_cache=False))
    return load_shipped


@pytest.fixture
def seam_problem(load):
    """Quick to plan: an L-profile past a plate."""
    return load("task_b_l_profile")


@pytest.fixture
def long_problem(load):
    """Takes seconds to plan."""
    return load("task_b_jump")


@pytest.fixture(scope="session")
def robot(source):
    folder = source / "robots" / "kuka_kr5_arc"
    return wristwise.load_robot(wristwise.RobotSource(
        urdf=folder / "kuka_kr5_arc.urdf", base_link="base_link", tip_link="torch_tip",
        limits=folder / "joint_limits.yaml"))


@pytest.fixture
def random():
    return numpy.random.default_rng(20170912)
