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
def unreachable_problem(seam_problem):
    """The same, 1 m away."""
    waypoints = seam_problem.task.waypoints
    frames = numpy.array([waypoint.frame for waypoint in waypoints])
    frames[:, 0, 3] += 1
    seam_problem.task = wristwise.Task.through(frames, [waypoint.time for waypoint in waypoints],
                                               waypoints[0].tolerance)
    return seam_problem


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
