"""Seams described in Python, against the same in problem files and against hand calculation."""

import math
import pickle

import numpy
import pytest

import wristwise


def down(x, y, turn=0.0):
    """Torch straight down on the plate of corner_stop, y along the weld."""
    return wristwise.pose_from_xyz_rpy([0.95 + x, y, 0.2], [0, math.pi, turn])


def box(rx, ry, rz):
    upper = numpy.radians([0, 0, 0, rx, ry, rz])
    return wristwise.ToleranceBox(lower=-upper, upper=upper)


def line(*points, tolerance=box(10, 10, 30)):
    return wristwise.Segment(shape=wristwise.LineSegment(from_=points[0], to=points[1]),
                             tolerance=tolerance)


def corner_stop():
    run = wristwise.RunDescription(length=0.01)
    return wristwise.SeamDescription(
        segments=[line(down(0, -0.1), down(0, 0.05)),
                  line(down(0, 0.05, math.pi / 2), down(-0.1, 0.05, math.pi / 2))],
        speed=0.01, spacing=0.005, run_in=run, run_out=run,
        corners=wristwise.CornerOptions(kind=wristwise.CornerOptions.Kind.stop, ramp_time=0.5,
                                        turn_rate=math.radians(30)))


def test_the_task_is_that_of_the_problem_file(load):
    problem = load("corner_stop")
    task = wristwise.build_task(problem.robot, corner_stop())
    expected = problem.task.waypoints
    assert len(task.waypoints) == len(expected)
    for ours, theirs in zip(task.waypoints, expected):
        assert ours.time == pytest.approx(theirs.time, abs=1e-9)
        assert ours.welding == theirs.welding
        numpy.testing.assert_allclose(ours.frame, theirs.frame, atol=1e-12)
        numpy.testing.assert_allclose(ours.tolerance.upper, theirs.tolerance.upper, atol=1e-12)
    assert task.rest_at_start and task.rest_at_end
    problem.task = task
    assert wristwise.plan_graph_only(problem).graph.cost == pytest.approx(
        wristwise.plan_graph_only(load("corner_stop")).graph.cost, rel=1e-9)


def test_an_arc_is_as_long_as_its_angle(robot):
    arc = wristwise.ArcSegment(from_=down(0, 0), center=[0.9, 0, 0.2], axis=[0, 0, 2],
                               angle=math.pi / 2)
    task = wristwise.build_task(robot, wristwise.SeamDescription(
        segments=[wristwise.Segment(shape=arc)], speed=0.01, waypoints=11))
    assert len(task.waypoints) == 11
    assert task.seam.length == pytest.approx(0.05 * math.pi / 2)
    assert task.seam.end_time == pytest.approx(5 * math.pi / 2)
    numpy.testing.assert_allclose(task.waypoints[-1].frame[:3, 3], [0.9, 0.05, 0.2], atol=1e-12)


def test_poses_with_times_and_joint_waypoints(robot):
    poses = wristwise.PoseListSegment(poses=[down(0, 0), down(0, 0.1)], times=[1, 4])
    task = wristwise.build_task(robot, wristwise.SeamDescription(
        segments=[wristwise.Segment(shape=poses)], waypoints=2))
    assert [waypoint.time for waypoint in task.waypoints] == [1, 4]
    posture = numpy.zeros(6)
    joints = wristwise.JointListSegment(postures=[
        wristwise.JointBox(lower=posture, upper=posture),
        wristwise.JointBox(lower=posture, upper=posture + 0.2)])
    task = wristwise.build_task(robot, wristwise.SeamDescription(
        segments=[wristwise.Segment(shape=joints)], speed=0.1, waypoints=2))
    numpy.testing.assert_allclose(task.waypoints[1].joints.nominal(), 0.1 * numpy.ones(6))


@pytest.mark.parametrize("change, message", [
    (dict(segments=[]), "no segments|one or more|at least one"),
    (dict(speed=None), "speed"),
    (dict(speed=math.inf), "speed"),
    (dict(segments=[line(down(0, 0), down(0, 0.1)), line(down(0, 0.2), down(0, 0.3))]), "[Ss]egment"),
    (dict(segments=[line(down(0, 0), down(0, 0))]), "[Ss]egment"),
])
def test_what_cannot_be_joined_is_named(robot, change, message):
    with pytest.raises(wristwise.InvalidInput, match=message):
        wristwise.build_task(robot, corner_stop().replace(**change))


def test_a_shape_of_another_type_is_refused():
    for shape in (None, 3, down(0, 0)):
        with pytest.raises(TypeError, match="Segment.shape"):
            wristwise.Segment(shape=shape)


def test_descriptions_are_pickled_and_shown():
    description = corner_stop()
    assert repr(pickle.loads(pickle.dumps(description))) == repr(description)
    assert "LineSegment(from_=" in repr(description)
