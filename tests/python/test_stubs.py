"""The type stubs against the module, and against programs that are right and wrong."""

import ast
import inspect
import pathlib
import re
import shutil
import subprocess
import sys
import textwrap

import pytest

import wristwise

PACKAGE = pathlib.Path(wristwise.__file__).parent
pytest.importorskip("mypy")


def run(*command, folder, package=PACKAGE.parent):
    return subprocess.run([sys.executable, "-m", *command], capture_output=True, text=True, cwd=folder,
                          env={"PYTHONPATH": str(package), "MYPYPATH": str(package),
                               "PATH": "/usr/bin:/bin"})


def test_the_stubs_are_those_of_the_module(tmp_path):
    done = run("mypy.stubtest", "wristwise", folder=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("fault", [
    ("def tcp_pose(", "def tcp_place("), ("    def widened(", "    def winded("),
])
def test_planted_faults_are_found(tmp_path, fault):
    """A copy of the package whose stubs lack a name."""
    copy = tmp_path / "wristwise"
    shutil.copytree(PACKAGE, copy)
    stubs = (copy / "__init__.pyi").read_text()
    assert fault[0] in stubs
    (copy / "__init__.pyi").write_text(stubs.replace(*fault))
    done = run("mypy.stubtest", "wristwise", folder=tmp_path, package=tmp_path)
    assert done.returncode == 1 and "is not present" in done.stdout, done.stdout + done.stderr


def test_the_stubs_have_the_parameters_of_the_module():
    """What stubtest cannot see of compiled functions: names, order and defaults."""
    tree = ast.parse((PACKAGE / "__init__.pyi").read_text())
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    checked = 0
    for node in functions:
        own = [f"{argument.arg}" for argument in node.args.args]
        signatures = re.findall(rf"^(?:\d+\. )?{node.name}\((.*)\) -> ", getattr(wristwise, node.name).__doc__,
                                re.MULTILINE)
        of_module = [re.findall(r"(\w+): ", re.sub(r"\[[^\]]*\]|<[^>]*>", "", text)) for text in signatures]
        assert own in of_module, node.name
        checked += 1
    assert checked > 40
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    for name, node in classes.items():
        for method in node.body:
            signature = getattr(getattr(wristwise, name, None), "__signature__", None)
            if signature and isinstance(method, ast.FunctionDef) and method.name == "__init__":
                assert [one.arg for one in method.args.kwonlyargs] == list(signature.parameters), name


def type_errors(tmp_path, program):
    file = tmp_path / "program.py"
    file.write_text(textwrap.dedent(program))
    done = run("mypy", "--strict", "--no-error-summary", str(file), folder=tmp_path)
    return done.stdout.splitlines()


def test_a_right_program_passes(tmp_path):
    assert type_errors(tmp_path, """
        import pathlib
        import numpy
        import wristwise

        def progress(stage: str, fraction: float) -> None:
            print(stage, fraction)

        class Own(wristwise.InverseKinematics):
            pass

        problem = wristwise.load_problem(pathlib.Path("a.yaml"))
        problem.cost.jerk = 2
        problem.cost = wristwise.CostOptions(joint_weights=[1, 2, 3], vertex_cost=lambda i, q: float(q[0]))
        problem.graph.step = numpy.zeros(6)
        problem.scene.objects = (wristwise.SceneObject(name="a", shapes=[
            wristwise.Shape(geometry=wristwise.Sphere(radius=1))]),)
        options = wristwise.PlanOptions(threads=2, monitor=wristwise.Monitor(progress=progress))
        result = wristwise.plan(problem, options)
        first: float = result.path.positions[0, 0]
        worst: str = result.diagnosis[0].detail
        clearance = result.verification.clearance
        if clearance is not None:
            print(clearance + 1, first, worst)
        assert wristwise.check(problem, result.trajectory).passed
        assert wristwise.smooth(problem.robot, result.path, wristwise.SmoothingOptions())
        frame = result.path.times.shape
        """) == []


WRONG = {
    "wristwise.load_problem(3)": "incompatible type",
    "wristwise.CostOptions(jrk=1)": "Unexpected keyword",
    "wristwise.CostOptions(jerk='much')": "incompatible type",
    "wristwise.Box()": "Missing named argument",
    "wristwise.plan()": "Missing positional argument",
    "wristwise.Problem().task.waypoints[0].time = 3": "read-only",
    "wristwise.Problem().cost.jrk": "has no attribute",
    "1 + (wristwise.Task().waypoints[0].joints)": "Unsupported operand",
    "wristwise.Status.sovled": "has no attribute",
    "wristwise.Monitor(progress=lambda stage: None)": "incompatible type|Cannot infer",
    "wristwise.check(wristwise.Problem(), 3)": "No overload variant",
}


def test_wrong_lines_are_found_out(tmp_path):
    errors = type_errors(tmp_path, "\n".join(["import wristwise", *WRONG]))
    for number, (line, message) in enumerate(WRONG.items(), 2):
        of_line = [error for error in errors if f":{number}: error:" in error]
        assert of_line and re.search(message, of_line[0]), (line, errors)


def public_members():
    for name in wristwise.__all__:
        yield name, getattr(wristwise, name)
        if inspect.isclass(getattr(wristwise, name)):
            yield from members_of(name, getattr(wristwise, name))


def members_of(prefix, cls):
    for name, member in vars(cls).items():
        if name.startswith("_") or hasattr(cls, "__members__"):
            continue
        yield f"{prefix}.{name}", member
        if inspect.isclass(member):
            yield from members_of(f"{prefix}.{name}", member)


def test_everything_has_a_docstring():
    members = dict(public_members())
    assert len(members) > 400
    for name, member in members.items():
        text = inspect.getdoc(member) or ""
        if inspect.isroutine(member) or isinstance(member, staticmethod):
            text = text.partition("\n")[2]  # behind the signature
        assert len(text.strip()) > 0, name


def test_no_docstring_leaks_a_name_of_cpp():
    for name, member in public_members():
        function = member.fget if isinstance(member, property) else member
        text = getattr(function, "__doc__", None) or ""
        assert "::" not in text, (name, text)


def test_modules_are_those_that_are_imported():
    for name in wristwise.__all__:
        assert getattr(wristwise, name).__module__ == "wristwise", name
    assert not [name for name in dir(wristwise) if name in ("_wristwise",) and name in wristwise.__all__]
