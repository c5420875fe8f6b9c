"""Who keeps whom alive, and that nothing is kept for ever."""

import gc
import sys
import weakref

import numpy
import pytest

import wristwise


def plan_with_callbacks(problem):
    class Cost:
        def __call__(self, waypoint, q):
            return 0.0

    class Progress:
        def __call__(self, stage, fraction):
            pass

    cost, progress = Cost(), Progress()
    problem.cost.vertex_cost = cost
    wristwise.plan(problem, wristwise.PlanOptions(
        threads=2, monitor=wristwise.Monitor(progress=progress)))
    problem.cost.vertex_cost = None
    return weakref.ref(cost), weakref.ref(progress)


def test_callbacks_are_let_go(load):
    problem = load("planar_3r")
    for _ in range(3):
        references = plan_with_callbacks(problem)
        gc.collect()
        assert [reference() for reference in references] == [None, None]


def test_inverse_kinematics_is_kept_and_let_go(load):
    class Own(wristwise.InverseKinematics):
        def solve(self, tcp):
            return []

    problem = load("planar_3r")
    own = Own()
    reference = weakref.ref(own)
    problem.inverse_kinematics = own
    del own
    gc.collect()
    assert reference() is not None and problem.inverse_kinematics is reference()
    problem.inverse_kinematics = None
    gc.collect()
    assert reference() is None


def test_what_a_callback_raised_is_let_go(load):
    class Boom(Exception):
        pass

    problem = load("planar_3r")

    def raise_it():
        boom = Boom()
        reference = weakref.ref(boom)

        def progress(stage, fraction):
            raise boom

        try:
            wristwise.plan(problem, wristwise.PlanOptions(
                monitor=wristwise.Monitor(progress=progress)))
        except Boom as caught:
            assert caught is boom
        del boom, progress
        return reference

    reference = raise_it()
    gc.collect()
    assert reference() is None


def test_parts_keep_their_whole(load):
    path = wristwise.plan(load("planar_3r")).path
    cost = load("planar_3r").cost
    gc.collect()
    assert len(path) > 0 and numpy.isfinite(path.positions).all()
    assert cost.joint_motion == 1


def resident_bytes():
    with open("/proc/self/statm") as line:
        return int(line.read().split()[1]) * 4096


def test_a_loop_of_plans_leaks_nothing(load):
    problem = load("planar_3r")
    marker = object()

    def once():
        problem.cost.vertex_cost = lambda waypoint, q, keep=marker: 0.0
        result = wristwise.plan(problem)
        result.path.positions, result.graph, result.seeds
        wristwise.load_problem(problem.files[0])

    for _ in range(3):
        once()
    gc.collect()
    count, objects, before = sys.getrefcount(marker), len(gc.get_objects()), resident_bytes()
    for _ in range(12):
        once()
    gc.collect()
    assert sys.getrefcount(marker) == count
    assert len(gc.get_objects()) <= objects + 20
    assert resident_bytes() - before < 20e6


@pytest.mark.parametrize("make", [
    lambda: wristwise.JointPath(times=range(1000), positions=numpy.ones((1000, 6))),
    lambda: wristwise.Scene(objects=[wristwise.SceneObject(name="a", shapes=[])]).objects,
    lambda: wristwise.ToleranceBox(lower=[0] * 6, upper=[1] * 6).widened(1, 1),
])
def test_making_things_leaks_nothing(make):
    for _ in range(100):
        make()
    gc.collect()
    before = resident_bytes()
    for _ in range(2000):
        make()
    gc.collect()
    assert resident_bytes() - before < 10e6
