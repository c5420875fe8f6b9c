import csv
import json
import math
import subprocess

import numpy
import pytest

import wristwise

MODES = {"two-stage": wristwise.plan, "graph-only": wristwise.plan_graph_only}
ONE_THREAD = wristwise.PlanOptions(threads=1)


def run_program(program, folder, *arguments):
    done = subprocess.run([program, *map(str, arguments), "--out", str(folder), "--quiet",
                           "--no-report"], capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return json.loads((folder / "result.json").read_text())


def read_csv(file):
    with open(file, newline="") as lines:
        rows = list(csv.reader(lines))
    return rows[0], numpy.array(rows[1:], dtype=float)


def expect_same_verification(verification, expected):
    assert verification.passed == expected["passed"]
    assert verification.position_error == pytest.approx(expected["position_error_m"], abs=1e-15)
    assert verification.velocity_ratio == expected["velocity_ratio"]
    if verification.clearance is not None:
        assert verification.clearance == expected["clearance_m"]
        assert list(verification.clearance_pair) == expected["clearance_pair"]


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("name", ["task_b_l_profile", "slide_along_plate", "planar_3r"])
def test_the_result_is_that_of_the_command_line(load, source, program, tmp_path, name, mode):
    expected = run_program(program, tmp_path, "plan", source / "problems" / f"{name}.yaml",
                           "--mode", mode)
    result = MODES[mode](load(name))
    assert result.status.name == expected["status"]
    assert result.mode.name.replace("_", "-") == expected["mode"]
    assert len(result.path) == expected["waypoints"]
    assert result.graph.cost == expected["graph"]["cost"]
    assert result.graph.vertices == expected["graph"]["vertices"]
    expect_same_verification(result.verification, expected["verification"])
    header, rows = read_csv(tmp_path / "trajectory.csv")
    joints = result.path.positions.shape[1]
    assert header[1:joints + 1] == expected["joints"]
    assert numpy.array_equal(rows[:, 0], result.path.times)
    assert numpy.array_equal(rows[:, 1:joints + 1], result.path.positions)
    if mode == "two-stage":
        assert result.refine.objective == expected["refine"]["objective"]
        assert numpy.array_equal(rows[:, joints + 1:2 * joints + 1], result.trajectory.velocities)
        assert numpy.array_equal(rows[:, 2 * joints + 1:], result.trajectory.accelerations)
    else:
        assert len(result.trajectory) == 0


def test_smoothing_is_that_of_the_command_line(seam_problem, source, program, tmp_path):
    path = wristwise.plan_graph_only(seam_problem).path
    names = [joint.name for joint in seam_problem.robot.joints]
    wristwise.write_path(tmp_path / "path.csv", names, path)
    expected = run_program(program, tmp_path / "out", "smooth",
                           source / "problems" / "task_b_l_profile.yaml",
                           "--joints", tmp_path / "path.csv")
    result = wristwise.smooth(seam_problem, path)
    assert result.status.name == expected["status"] == "solved"
    assert result.before is not None and not result.before.verification.curve
    _, rows = read_csv(tmp_path / "out" / "trajectory.csv")
    assert numpy.array_equal(rows[:, 1:7], result.trajectory.positions)


def test_smoothing_without_a_problem_keeps_the_path(robot, seam_problem):
    path = wristwise.plan_graph_only(seam_problem).path
    options = wristwise.SmoothingOptions(position_tolerance=1e-3, angle_tolerance=math.radians(1))
    result = wristwise.smooth(robot, path, options)
    assert result.status == wristwise.Status.solved
    for t, q in zip(path.times, path.positions):
        there, here = (wristwise.tcp_pose(robot, p) for p in (q, result.trajectory.evaluate(t)))
        assert numpy.linalg.norm(there[:3, 3] - here[:3, 3]) <= 1e-3 + 1e-6
        angle = math.acos(min(1, (numpy.trace(there[:3, :3].T @ here[:3, :3]) - 1) / 2))
        assert angle <= math.radians(1) + 1e-5


def test_the_check_passes_what_is_good_and_fails_what_is_not(seam_problem):
    result = wristwise.plan(seam_problem)
    assert wristwise.check(seam_problem, result.trajectory).passed
    model = wristwise.ClearanceModel(seam_problem.robot, seam_problem.scene)
    assert wristwise.verify(seam_problem.task, model, result.trajectory).passed
    shifted = result.path.positions.copy()
    shifted[:, 0] += 1e-3
    failed = wristwise.check(seam_problem, wristwise.JointPath(times=result.path.times,
                                                               positions=shifted))
    assert failed.run and not failed.passed and failed.failures
    radius = numpy.hypot(*seam_problem.task.waypoints[0].frame[:2, 3])
    assert failed.position_error == pytest.approx(1e-3 * radius, rel=0.2)


def test_no_solution_is_a_result(unreachable_problem):
    result = wristwise.plan(unreachable_problem)
    assert result.status == wristwise.Status.infeasible
    assert len(result.path) == 0 and not result.verification.run
    diagnosis = result.diagnosis[0]
    assert (diagnosis.waypoint, diagnosis.reason) == (0, "out_of_reach")
    assert diagnosis.counts.out_of_reach == diagnosis.counts.samples == 9 * 36


def seam_from_numpy(robot, plate=None):
    count = 40
    frames = numpy.tile(wristwise.pose_from_xyz_rpy([0.9, 0, 0.3], [0, math.pi, 0]), (count, 1, 1))
    frames[:, 1, 3] = numpy.linspace(-0.2, 0.2, count)
    tilt = math.radians(10)
    box = wristwise.ToleranceBox(lower=[0, 0, 0, -tilt, -tilt, -math.inf],
                                 upper=[0, 0, 0, tilt, tilt, math.inf])
    problem = wristwise.Problem(
        name="own", robot=robot, task=wristwise.Task.through(frames, 1.0 * numpy.arange(count), box),
        graph=wristwise.GraphOptions(step=numpy.radians([0, 0, 0, 5, 5, 20])))
    if plate is not None:
        problem.scene.objects = [plate]
        problem.scene.clearance = 0.005
    return problem, frames, tilt


def test_a_plan_from_numpy_alone(robot):
    plate = wristwise.SceneObject(name="plate", shapes=[
        wristwise.Shape(geometry=wristwise.Box(size=[0.4, 0.6, 0.01]),
                        pose=wristwise.pose_from_xyz_rpy([0.9, 0, 0.28], [0, 0, 0]))])
    problem, frames, tilt = seam_from_numpy(robot, plate)
    result = wristwise.plan(problem)
    assert result.status == wristwise.Status.solved
    assert result.verification.clearance >= 0.005 - 1e-6
    for frame, q in zip(frames, result.path.positions):
        tcp = wristwise.tcp_pose(robot, q)
        assert numpy.linalg.norm(tcp[:3, 3] - frame[:3, 3]) < 1e-6
        assert math.acos(min(1, frame[:3, 2] @ tcp[:3, 2])) < tilt * math.sqrt(2) + 1e-6


def test_a_scene_object_counts(robot):
    wall = wristwise.SceneObject(name="wall", shapes=[
        wristwise.Shape(geometry=wristwise.Box(size=[0.6, 0.02, 1.0]),
                        pose=wristwise.pose_from_xyz_rpy([0.9, 0, 0.3], [0, 0, 0]))])
    problem, _, _ = seam_from_numpy(robot, wall)
    problem.graph.try_relaxations = False
    result = wristwise.plan(problem)
    assert result.status == wristwise.Status.infeasible
    counts = result.diagnosis[0].counts
    assert any("wall" in pair for pair in counts.collision) or counts.blocked


def test_options_reach_the_planner(seam_problem):
    wide = wristwise.plan_graph_only(seam_problem).graph.vertices
    seam_problem.graph.turns = wristwise.Turns.principal
    assert wristwise.plan_graph_only(seam_problem).graph.vertices < wide
    seam_problem.cost.joint_weights = [2] * 6
    doubled = wristwise.plan_graph_only(seam_problem)
    seam_problem.cost.joint_weights = []
    assert doubled.graph.cost == pytest.approx(2 * wristwise.plan_graph_only(seam_problem).graph.cost)


def test_the_threads_do_not_matter(seam_problem):
    one = wristwise.plan(seam_problem, ONE_THREAD)
    three = wristwise.plan(seam_problem, wristwise.PlanOptions(threads=3))
    assert numpy.array_equal(one.trajectory.positions, three.trajectory.positions)


def test_a_trajectory_is_a_quintic_through_its_points(seam_problem):
    trajectory = wristwise.plan(seam_problem).trajectory
    times = trajectory.times
    assert trajectory.positions.shape == (len(times), 6) == trajectory.velocities.shape
    assert numpy.allclose(trajectory.sample(times), trajectory.positions, atol=1e-12)
    assert numpy.allclose(trajectory.sample(times, 2), trajectory.accelerations, atol=1e-9)
    middle, step = (times[3] + times[4]) / 2, 1e-5
    slope = (trajectory.evaluate(middle + step) - trajectory.evaluate(middle - step)) / (2 * step)
    assert numpy.allclose(trajectory.evaluate(middle, 1), slope, atol=1e-7)
    coefficients = trajectory.polynomials(3)
    assert coefficients.shape == (6, 6)
    assert numpy.allclose(coefficients.sum(axis=1), trajectory.positions[4], atol=1e-12)
    least, largest = trajectory.extremes(3, 0)
    inside = trajectory.sample(numpy.linspace(times[3], times[4], 50))
    assert (least <= inside.min(axis=0) + 1e-12).all() and (inside.max(axis=0) - 1e-12 <= largest).all()
