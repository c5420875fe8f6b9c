"""Ctrl-C, in a process of its own."""

import os
import signal
import subprocess
import sys
import textwrap

import pytest

HEAD = """
import signal, sys, wristwise
problem = wristwise.load_problem(sys.argv[1], wristwise.LoadOptions(mesh_cache=False))
def progress(stage, fraction):
    print("planning", flush=True)
options = wristwise.PlanOptions(monitor=wristwise.Monitor(progress=progress))
"""


def run_until_signal(source, body, sent=signal.SIGINT):
    """Sends the signal when the plan has begun; returns exit code, output and errors."""
    child = subprocess.Popen(
        [sys.executable, "-c", HEAD + textwrap.dedent(body),
         str(source / "problems" / "task_b_jump.yaml")],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=os.environ)
    try:
        assert child.stdout.readline() == "planning\n"
        child.send_signal(sent)
        out, errors = child.communicate(timeout=60)
    finally:
        child.kill()
    return child.returncode, [line for line in out.splitlines() if line != "planning"], errors


def test_ctrl_c_is_a_keyboard_interrupt(source):
    code, out, errors = run_until_signal(source, """
        wristwise.plan(problem, options)
        print("planned to the end")
        """)
    assert out == []
    assert code == -signal.SIGINT or code == 130
    assert errors.strip().endswith("KeyboardInterrupt")


def test_python_goes_on_after_ctrl_c(source):
    code, out, errors = run_until_signal(source, """
        try:
            wristwise.plan(problem, options)
        except KeyboardInterrupt:
            print("stopped")
        problem.graph.try_relaxations = False
        problem.task.waypoints = problem.task.waypoints[:5]
        print(wristwise.plan_graph_only(problem).path.positions.shape[1])
        """)
    assert (code, out) == (0, ["stopped", "6"]), errors


def test_ctrl_c_within_own_costs(source):
    code, out, errors = run_until_signal(source, """
        problem.cost.vertex_cost = lambda waypoint, q: 0.0
        try:
            wristwise.plan(problem, options)
        except KeyboardInterrupt:
            print("stopped")
        """)
    assert (code, out) == (0, ["stopped"]), errors


def test_a_handler_of_ones_own_runs_during_the_plan(source):
    code, out, errors = run_until_signal(source, """
        class Enough(Exception):
            pass
        def handler(number, frame):
            raise Enough()
        signal.signal(signal.SIGUSR1, handler)
        try:
            wristwise.plan(problem, options)
        except Enough:
            print("enough")
        """, signal.SIGUSR1)
    assert (code, out) == (0, ["enough"]), errors


@pytest.mark.parametrize("body", ["signal.signal(signal.SIGINT, lambda *_: print('noted', flush=True))"])
def test_a_handler_that_raises_nothing_stops_nothing(source, body):
    code, out, errors = run_until_signal(source, body + """
problem.graph.try_relaxations = False
problem.task.waypoints = problem.task.waypoints[:3]
problem.task.seam = wristwise.Seam([problem.task.seam.piece_at(0.0)])
print(wristwise.plan_graph_only(problem, options).status.name)
""")
    assert code == 0 and "noted" in out and out[-1] != "interrupted", errors
