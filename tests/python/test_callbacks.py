import math
import threading
import time

import numpy
import pytest

import wristwise


class Boom(Exception):
    pass


def options(threads=2, **monitor):
    return wristwise.PlanOptions(threads=threads, monitor=wristwise.Monitor(**monitor))


def test_progress_is_reported_from_the_calling_thread(seam_problem):
    seen, threads = [], set()

    def progress(stage, fraction):
        seen.append((stage, fraction))
        threads.add(threading.get_ident())

    assert wristwise.plan(seam_problem, options(progress=progress)).status.name == "solved"
    assert threads == {threading.get_ident()}
    stages = list(dict.fromkeys(stage for stage, _ in seen))
    assert stages == ["sampling", "search", "refine", "verify"]
    assert all(0 <= fraction <= 1 for _, fraction in seen)


@pytest.mark.parametrize("threads", [1, 3])
@pytest.mark.parametrize("plan", [wristwise.plan, wristwise.plan_graph_only])
def test_what_progress_raises_comes_out(seam_problem, plan, threads):
    def progress(stage, fraction):
        raise Boom(stage)

    with pytest.raises(Boom, match="sampling") as caught:
        plan(seam_problem, options(threads, progress=progress))
    assert "progress" in [entry.name for entry in caught.traceback]


def test_the_first_exception_counts_and_nothing_is_called_after(seam_problem):
    calls = []

    def progress(stage, fraction):
        calls.append(stage)
        raise Boom(len(calls))

    with pytest.raises(Boom, match="1"):
        wristwise.plan(seam_problem, options(progress=progress))
    assert len(calls) == 1


@pytest.mark.parametrize("threads", [1, 3])
def test_what_a_cost_raises_comes_out(seam_problem, threads):
    def vertex_cost(waypoint, q):
        if waypoint == 20:
            raise Boom("at 20")
        return 0.0

    seam_problem.cost.vertex_cost = vertex_cost
    with pytest.raises(Boom, match="at 20"):
        wristwise.plan(seam_problem, options(threads))


@pytest.mark.parametrize("answer", [-1.0, math.nan, None, "much"])
def test_a_cost_that_is_none_is_refused(seam_problem, answer):
    seam_problem.cost.vertex_cost = lambda waypoint, q: answer
    with pytest.raises(wristwise.InvalidInput, match="vertex_cost: returned .* expected a number"):
        wristwise.plan(seam_problem)
    seam_problem.cost.vertex_cost = None
    seam_problem.cost.edge_cost = lambda interval, a, b: answer
    with pytest.raises(wristwise.InvalidInput, match="edge_cost: returned"):
        wristwise.plan(seam_problem)


def planned_cost(problem):
    result = wristwise.plan_graph_only(problem)
    assert result.status == wristwise.Status.solved
    return result.graph.cost, result.path.positions


def test_a_vertex_cost_is_added(load):
    problem = load("planar_3r")
    plain, _ = planned_cost(problem)
    problem.cost.vertex_cost = lambda waypoint, q: 0.25
    dearer, _ = planned_cost(problem)
    assert dearer == pytest.approx(plain + 0.25 * len(problem.task.waypoints))


def test_own_costs_are_those_of_the_path(load):
    problem = load("planar_3r")
    seen = set()

    def vertex_cost(waypoint, q):
        assert q.shape == (3,) and not q.flags.writeable
        seen.add(threading.get_ident())
        return float(abs(q[0]))

    problem.cost.vertex_cost = vertex_cost
    problem.cost.edge_cost = lambda interval, start, end: 0.5 * float(abs(end - start).sum())
    assert problem.cost.vertex_cost is vertex_cost
    cost, path = planned_cost(problem)
    steps = abs(numpy.diff(path, axis=0)).sum()
    assert cost == pytest.approx(abs(path[:, 0]).sum() + 1.5 * steps)
    assert seen


def test_a_residual_of_ones_own_draws_the_motion(seam_problem):
    """With a large weight joint 6 goes where it is asked to: the spin is free."""
    plain = wristwise.plan(seam_problem)
    wanted = plain.trajectory.positions[:, 5].mean() + 0.05
    gradient = numpy.array([0, 0, 0, 0, 0, 3.0])

    def residual(time, q):
        return 3.0 * (q[5] - wanted), gradient

    seam_problem.cost.posture_residuals = [residual]
    assert seam_problem.cost.posture_residuals == (residual,)
    drawn = wristwise.plan(seam_problem)
    assert drawn.status == wristwise.Status.solved
    before, after = (abs(result.trajectory.positions[:, 5] - wanted).mean() for result in (plain, drawn))
    assert after < 0.2 * before


@pytest.mark.parametrize("answer", [1.0, (1.0, [1, 2]), (math.nan, [0] * 6), (1.0, [math.inf] * 6), None])
def test_a_residual_that_is_none_is_refused(seam_problem, answer):
    seam_problem.cost.posture_residuals = [lambda time, q: answer]
    with pytest.raises(wristwise.InvalidInput, match="posture_residuals: returned .* expected a pair"):
        wristwise.plan(seam_problem)


def test_what_a_residual_raises_comes_out(seam_problem):
    def residual(time, q):
        raise Boom("at once")

    seam_problem.cost.posture_residuals = [residual]
    with pytest.raises(Boom, match="at once"):
        wristwise.plan(seam_problem)


class OwnKinematics(wristwise.InverseKinematics):
    """A closed form by way of Python."""

    def __init__(self, robot):
        super().__init__()
        self.solver = wristwise.find_closed_form(robot).solver
        self.calls = 0

    def solve(self, tcp):
        self.calls += 1
        return self.solver.solve(tcp)


def test_own_inverse_kinematics_plans_the_same(load):
    problem = load("task_b_l_profile")
    expected = wristwise.plan(problem, options(1))
    own = OwnKinematics(problem.robot)
    problem.inverse_kinematics = own
    assert problem.inverse_kinematics is own
    result = wristwise.plan(problem, options(3))
    assert own.calls > 0
    assert result.inverse_kinematics == "OwnKinematics"
    assert numpy.array_equal(result.path.positions, expected.path.positions)


def test_own_inverse_kinematics_outlives_its_name(load):
    problem = load("task_b_l_profile")
    problem.inverse_kinematics = OwnKinematics(problem.robot)
    assert wristwise.plan_graph_only(problem).status == wristwise.Status.solved


def test_the_base_class_asks_the_subclass(seam_problem):
    own = OwnKinematics(seam_problem.robot)
    frame = seam_problem.task.waypoints[0].frame
    beside = own.solve_beside(frame, numpy.zeros(6))
    assert own.calls == 1 and numpy.array_equal(beside, own.solve(frame))
    assert own.samples() == 1 and own.meets_every_pose() is True


@pytest.mark.parametrize("answer, message", [
    (numpy.zeros((2, 5)), "rows of 5 values; expected 6 finite"),
    (numpy.full((1, 6), numpy.inf), "not finite"),
    (numpy.full((1, 6), numpy.nan), "NaN"),
    (numpy.zeros(6), r"shape \(6,\)"),
    ("nothing", "dtype"),
])
def test_solutions_that_are_none_are_refused(seam_problem, answer, message):
    class Wrong(wristwise.InverseKinematics):
        def solve(self, tcp):
            return answer

    seam_problem.inverse_kinematics = Wrong()
    with pytest.raises(wristwise.InvalidInput, match=f"InverseKinematics.solve: .*{message}"):
        wristwise.plan(seam_problem)


def test_what_inverse_kinematics_raises_comes_out(seam_problem):
    class Raises(wristwise.InverseKinematics):
        def solve(self, tcp):
            raise Boom("no wrist")

    seam_problem.inverse_kinematics = Raises()
    with pytest.raises(Boom, match="no wrist"):
        wristwise.plan(seam_problem, options(3))
    seam_problem.inverse_kinematics = wristwise.InverseKinematics()
    with pytest.raises(NotImplementedError, match="solve"):
        wristwise.plan(seam_problem)


def test_a_set_event_interrupts(seam_problem):
    stop = threading.Event()
    stop.set()
    result = wristwise.plan(seam_problem, options(cancel=stop))
    assert result.status == wristwise.Status.interrupted


def test_another_thread_can_cancel(long_problem):
    stop = threading.Event()
    began = threading.Event()
    results = []
    planner = threading.Thread(target=lambda: results.append(wristwise.plan(
        long_problem, options(cancel=stop, progress=lambda *_: began.set()))))
    planner.start()
    began.wait()
    stop.set()
    planner.join()
    assert results[0].status == wristwise.Status.interrupted


def test_python_runs_while_planning(seam_problem, long_problem):
    """The interpreter lock is free: another thread counts, and several plan at once."""
    stop, began = threading.Event(), threading.Event()
    planner = threading.Thread(target=wristwise.plan, args=(
        long_problem, options(1, cancel=stop, progress=lambda *_: began.set())))
    planner.start()
    began.wait()
    assert wristwise.plan(seam_problem).status == wristwise.Status.solved
    still_planning = planner.is_alive()
    stop.set()
    planner.join()
    assert still_planning


def test_several_threads_plan_at_once(load):
    names = ["task_b_l_profile", "planar_3r", "slide_along_plate"] * 2
    expected = {name: wristwise.plan(load(name)).path.positions for name in set(names)}
    results = {}

    def work(index, name):
        costs = []
        problem = load(name)
        problem.cost.vertex_cost = lambda waypoint, q: costs.append(0) or 0.0
        results[index] = wristwise.plan(problem, options(2, progress=lambda *_: None))

    workers = [threading.Thread(target=work, args=item) for item in enumerate(names)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    for index, name in enumerate(names):
        assert numpy.array_equal(results[index].path.positions, expected[name])


def test_changing_a_problem_while_it_is_planned_changes_nothing(seam_problem):
    expected = wristwise.plan(seam_problem).path.positions

    def meddle(stage, fraction):
        seam_problem.scene.objects = []
        seam_problem.task.waypoints = []
        seam_problem.cost.jerk = 1e6

    result = wristwise.plan(seam_problem, options(progress=meddle))
    assert numpy.array_equal(result.path.positions, expected)


def test_a_callback_may_plan(seam_problem, load):
    inner = []
    other = load("planar_3r")

    def progress(stage, fraction):
        if not inner:
            inner.append(wristwise.plan(other))

    assert wristwise.plan(seam_problem, options(progress=progress)).status.name == "solved"
    assert inner[0].status == wristwise.Status.solved


def test_callbacks_are_callable():
    with pytest.raises(TypeError, match="Monitor.progress: 3; expected Optional.Callable"):
        wristwise.Monitor(progress=3)
    with pytest.raises(TypeError, match="Monitor.cancel"):
        wristwise.Monitor(cancel=True)
    with pytest.raises(TypeError, match="CostOptions.vertex_cost"):
        wristwise.CostOptions(vertex_cost=1.5)


def test_time_is_left_to_others(seam_problem):
    """Callbacks that sleep give the lock away, and do not block the planner's answer."""
    result = wristwise.plan(seam_problem, options(progress=lambda *_: time.sleep(1e-4)))
    assert result.status == wristwise.Status.solved
