import math

import numpy
import pytest

import wristwise

POSE = numpy.eye(4)


def test_arrays_and_lists_are_the_same():
    as_list = wristwise.JointPath(times=[0, 1, 2], positions=[[0, 1], [2, 3], [4, 5]])
    as_array = wristwise.JointPath(times=numpy.arange(3), positions=numpy.arange(6.0).reshape(3, 2))
    strided = wristwise.JointPath(times=numpy.arange(6)[::2],
                                  positions=numpy.arange(12, dtype=numpy.float32).reshape(6, 2)[::2])
    assert numpy.array_equal(as_list.positions, as_array.positions)
    assert as_list.positions.dtype == numpy.float64 and as_list.times.shape == (3,)
    assert numpy.array_equal(strided.times, [0, 2, 4])
    assert numpy.array_equal(strided.positions, [[0, 1], [4, 5], [8, 9]])


def test_fortran_order_is_read_as_it_looks():
    rows = numpy.asfortranarray(numpy.arange(12.0).reshape(4, 3))
    path = wristwise.JointPath(times=range(4), positions=rows)
    assert numpy.array_equal(path.positions, rows)


def test_what_is_given_is_copied():
    rows = numpy.zeros((2, 3))
    path = wristwise.JointPath(times=[0, 1], positions=rows)
    rows[:] = 7
    assert not path.positions.any()
    first = path.positions
    assert first is not path.positions and not first.flags.writeable
    assert first.copy().flags.writeable


@pytest.mark.parametrize("value, message", [
    (numpy.zeros(3), r"JointPath.positions: an array of shape \(3,\); expected numbers of shape \(N, joints\)"),
    (numpy.zeros((2, 3, 1)), r"shape \(2, 3, 1\); expected"),
    (numpy.zeros((2, 17)), r"shape \(2, 17\); expected"),
    (numpy.zeros((2, 3), dtype=complex), "dtype complex128; expected numbers"),
    (numpy.zeros((2, 3), dtype=bool), "dtype bool; expected numbers"),
    ([["a", "b"], ["c", "d"]], "dtype <U1; expected numbers"),
    ([[0, 1], [2, math.nan]], "an array with NaN; expected numbers"),
    ([[0, 1], [2]], "JointPath.positions: .*expected numbers"),
    (None, "dtype object; expected numbers"),
    ("positions", "dtype"),
    ({}, "dtype object; expected numbers"),
])
def test_a_wrong_array_says_what_is_expected(value, message):
    with pytest.raises(wristwise.InvalidInput, match=message):
        wristwise.JointPath(times=[0, 1], positions=value)


@pytest.mark.parametrize("value, message", [
    (numpy.eye(3), r"Waypoint.frame: an array of shape \(3, 3\); expected numbers of shape \(4, 4\): a pose"),
    (2 * POSE, "no rigid transformation; expected a pose"),
    (numpy.diag([1.0, 1, -1, 1]), "no rigid transformation"),
    (numpy.diag([1, 1, 1, math.inf]), "no rigid transformation"),
    (POSE + numpy.array([[0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0], [1, 0, 0, 0]]), "no rigid"),
])
def test_a_pose_is_a_rigid_transformation(value, message):
    with pytest.raises(wristwise.InvalidInput, match=message):
        wristwise.Waypoint(frame=value)


def test_arguments_are_held_to_the_same(robot):
    with pytest.raises(wristwise.InvalidInput, match=r"array: an array of shape \(3,\); expected .*\(4, 4\)"):
        wristwise.find_closed_form(robot).solver.solve([1, 2, 3])
    with pytest.raises(wristwise.InvalidInput, match=r"\(joints,\)"):
        wristwise.tcp_pose(robot, numpy.zeros((1, 6)))
    with pytest.raises(wristwise.InvalidInput, match=r"NaN"):
        wristwise.tcp_pose(robot, [math.nan] * 6)


def test_invalid_input_is_a_value_error():
    assert issubclass(wristwise.InvalidInput, ValueError)
    assert wristwise.InvalidInput.__module__ == "wristwise"


def test_sizes_belong_together():
    with pytest.raises(wristwise.InvalidInput, match="3 times and 2 positions"):
        wristwise.JointPath(times=[0, 1, 2], positions=numpy.zeros((2, 6)))
    with pytest.raises(wristwise.InvalidInput):
        wristwise.Trajectory([0, 1], numpy.zeros((2, 6)), numpy.zeros((1, 6)), numpy.zeros((2, 6)))
    with pytest.raises(wristwise.InvalidInput):
        wristwise.Trajectory([0, 0], *[numpy.zeros((2, 6))] * 3)
    with pytest.raises(wristwise.InvalidInput, match="2 frames and 3 times"):
        wristwise.Task.through([POSE, POSE], [0, 1, 2], wristwise.ToleranceBox())
    with pytest.raises(wristwise.InvalidInput, match="corner|ConvexHull.triangles: 5"):
        wristwise.ConvexHull(vertices=numpy.eye(3), triangles=[[0, 1, 5]])


def test_a_tolerance_is_checked():
    backwards = wristwise.ToleranceBox(lower=[0, 0, 1, 0, 0, 0], upper=[0] * 6)
    with pytest.raises(wristwise.InvalidInput):
        backwards.validate("box")
    with pytest.raises(wristwise.InvalidInput):
        wristwise.Task.through([POSE, wristwise.pose_from_xyz_rpy([1, 0, 0], [0, 0, 0])], [0, 1], backwards)


def assign(problem, option, value):
    *path, name = option.split(".")
    for part in path:
        problem = getattr(problem, part)
    setattr(problem, name, value)


@pytest.mark.parametrize("option, value, message", [
    ("robot", None, "problem.robot"),
    ("task.waypoints", [], "task.waypoints: 0 given; expected at least two"),
    ("task.seam", wristwise.Seam(), "task.seam: no pieces"),
    ("task.between_position", -1, "task.between_position: -1"),
    ("task.between_angle", math.inf, "task.between_angle: inf"),
    ("scene.clearance", -1, "clearance"),
    ("scene.objects", [wristwise.SceneObject(name="a", shapes=[
        wristwise.Shape(geometry=wristwise.Sphere(radius=-1))])], "'a': radius"),
    ("refine.clearance_epsilon", 0, "refine.clearance_epsilon"),
])
@pytest.mark.parametrize("call", [wristwise.plan, wristwise.plan_graph_only, wristwise.check])
def test_a_problem_that_is_none_is_refused(seam_problem, call, option, value, message):
    assign(seam_problem, option, value)
    path = wristwise.JointPath(times=[0, 36], positions=numpy.zeros((2, 6)))
    with pytest.raises(wristwise.InvalidInput, match=message):
        call(*[seam_problem, path][:2 if call is wristwise.check else 1])


@pytest.mark.parametrize("option, value", [
    ("cost.joint_motion", -1), ("cost.jerk", -1), ("cost.jerk", math.inf), ("cost.euler_eta", math.inf),
    ("cost.posture", -1), ("cost.joint_weights", [1]), ("cost.joint_weights", [0] * 6),
    ("cost.preferred_posture", [1, 2]), ("graph.joint_step", [1, 2]),
    ("graph.step", [0, 0, 0, 0, -1, 0]), ("graph.step", [0, 0, 0, 0, math.inf, 0]),
    ("graph.seeds", 0), ("graph.spare_seeds", -1), ("graph.automatic_samples", -1),
    ("graph.max_stray", 0), ("graph.seed_separation", 0), ("graph.sparse_deviation", 0),
    ("refine.smoothing_time", 0), ("refine.smoothing_time", math.inf), ("refine.knot_spacing", -1),
    ("refine.max_rounds", 0), ("refine.max_iterations", -1), ("refine.constraint_tolerance", 0),
    ("refine.time_limit", -1),
])
def test_an_option_out_of_range_is_named(seam_problem, option, value):
    assign(seam_problem, option, value)
    path = wristwise.JointPath(times=[0, 36], positions=numpy.zeros((2, 6)))
    for call in (lambda: wristwise.plan(seam_problem), lambda: wristwise.plan_graph_only(seam_problem),
                 lambda: wristwise.smooth(seam_problem, path)):
        with pytest.raises(wristwise.InvalidInput, match=option):
            call()


@pytest.mark.parametrize("change, message", [
    (lambda i, w: w.replace(time=0), r"task.waypoints\[1\].time: 0 s; expected one that increases"),
    (lambda i, w: w.replace(time=36 - w.time), "increases"),
    (lambda i, w: w.replace(time=w.time + 100), "100 s is not on the seam; expected 0 to 36 s"),
    (lambda i, w: w.replace(time=math.inf), "finite"),
    (lambda i, w: w.replace(tolerance=wristwise.ToleranceBox(lower=[1] * 6)), r"\[0\].tolerance"),
    (lambda i, w: w.replace(joints=wristwise.JointBox(lower=[0] * 5, upper=[0] * 5)), "waypoint 0: 5"),
])
def test_waypoints_that_are_none_are_refused(seam_problem, change, message):
    seam_problem.task.waypoints = [change(i, w) for i, w in enumerate(seam_problem.task.waypoints)]
    for call in (wristwise.plan, wristwise.plan_graph_only):
        with pytest.raises(wristwise.InvalidInput, match=message):
            call(seam_problem)


def test_a_path_of_another_robot_is_refused(seam_problem):
    path = wristwise.JointPath(times=[0, 36], positions=numpy.zeros((2, 5)))
    for call in (wristwise.smooth, wristwise.check):
        with pytest.raises(wristwise.InvalidInput):
            call(seam_problem, path)
    curve = wristwise.Trajectory([0, 36], *[numpy.zeros((2, 5))] * 3)
    with pytest.raises(wristwise.InvalidInput):
        wristwise.check(seam_problem, curve)
    empty = wristwise.JointPath(times=[], positions=numpy.zeros((0, 6)))
    for call in (wristwise.smooth, wristwise.check):
        with pytest.raises(wristwise.InvalidInput):
            call(seam_problem, empty)
    with pytest.raises(wristwise.InvalidInput):
        wristwise.check(seam_problem, wristwise.Trajectory())
    with pytest.raises(wristwise.InvalidInput):
        wristwise.smooth(seam_problem.robot, path, wristwise.SmoothingOptions())


def test_a_verification_needs_a_task(seam_problem):
    model = wristwise.ClearanceModel(seam_problem.robot, seam_problem.scene)
    path = wristwise.JointPath(times=[0, 36], positions=numpy.zeros((2, 6)))
    with pytest.raises(wristwise.InvalidInput, match="task.waypoints: 0 given"):
        wristwise.verify(wristwise.Task(), model, path)
    with pytest.raises(wristwise.InvalidInput, match="task.seam: no pieces"):
        wristwise.verify(wristwise.Task(waypoints=seam_problem.task.waypoints), model, path)
    with pytest.raises(wristwise.InvalidInput):
        wristwise.verify(seam_problem.task, model, wristwise.Trajectory())
    with pytest.raises(wristwise.InvalidInput):
        wristwise.verify(seam_problem.task, model, path.replace(positions=numpy.zeros((2, 3))))


def test_empty_curves_and_seams_answer_nothing():
    for ask in (lambda: wristwise.Trajectory().evaluate(0), lambda: wristwise.Trajectory().sample([0]),
                lambda: wristwise.Seam().frame_at(0), lambda: wristwise.Seam().start_time,
                lambda: wristwise.Task().weld_start(), lambda: wristwise.Task().with_waypoints_at([0, 1])):
        with pytest.raises(wristwise.InvalidInput):
            ask()
    line = wristwise.Trajectory([0, 1], *[numpy.zeros((2, 1))] * 3)
    for ask in (lambda: line.evaluate(0, 6), lambda: line.extremes(1, 0), lambda: line.polynomials(1),
                lambda: line.extremes(0, 4)):
        with pytest.raises(wristwise.InvalidInput):
            ask()
