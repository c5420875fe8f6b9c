import os
import pathlib

import numpy
import pytest

import wristwise


class OwnPath:
    def __init__(self, path):
        self.path = path

    def __fspath__(self):
        return str(self.path)


def test_any_path_is_taken(source):
    file = source / "problems" / "task_b_l_profile.yaml"
    for path in (file, str(file), os.fsencode(file), OwnPath(file)):
        problem = wristwise.load_problem(path, wristwise.LoadOptions(mesh_cache=False))
        assert problem.name == "task_b_l_profile"
        assert pathlib.Path(problem.files[0]).samefile(file)
    with pytest.raises(TypeError):
        wristwise.load_problem(3)


def test_a_path_is_given_back():
    given = wristwise.RobotSource(urdf="a/b.urdf", packages=["c", pathlib.Path("d")])
    assert given.urdf == pathlib.Path("a/b.urdf") and given.limits is None
    assert given.packages == (pathlib.Path("c"), pathlib.Path("d"))


@pytest.mark.parametrize("text, message", [
    ("robot: {urdf: nowhere.urdf}\npath: {segments: []}", "nowhere.urdf"),
    ("robt: {}", "robt"),
    ("[", "yaml"),
    ("", "robot|empty|path"),
])
def test_what_is_wrong_with_a_file_is_one_line(tmp_path, text, message):
    file = tmp_path / "problem.yaml"
    file.write_text(text)
    with pytest.raises(wristwise.InvalidInput, match=message) as caught:
        wristwise.load_problem(file)
    assert "problem.yaml" in str(caught.value) or "nowhere" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_missing_file_is_invalid_input(tmp_path):
    with pytest.raises(wristwise.InvalidInput, match="no_such.yaml"):
        wristwise.load_problem(tmp_path / "no_such.yaml")
    with pytest.raises(wristwise.InvalidInput, match="no_such.csv"):
        wristwise.read_trajectory(tmp_path / "no_such.csv", ["a"])


def test_a_trajectory_is_written_and_read_back(seam_problem, tmp_path):
    result = wristwise.plan(seam_problem)
    names = [joint.name for joint in seam_problem.robot.joints]
    wristwise.write_trajectory(tmp_path / "curve.csv", names, result.trajectory)
    read = wristwise.read_trajectory(tmp_path / "curve.csv", names)
    for kind in ("times", "positions", "velocities", "accelerations"):
        assert numpy.array_equal(getattr(read.trajectory, kind), getattr(result.trajectory, kind))
    assert wristwise.check(seam_problem, read).passed
    wristwise.write_path(tmp_path / "points.csv", names, result.path)
    points = wristwise.read_trajectory(tmp_path / "points.csv", names)
    assert points.trajectory is None
    assert numpy.array_equal(points.path.positions, result.path.positions)
    wristwise.write_dense(tmp_path / "dense.csv", names, result.trajectory, 0.1)
    dense = numpy.loadtxt(tmp_path / "dense.csv", delimiter=",", skiprows=1)
    assert numpy.allclose(dense[:, 1:7], result.trajectory.sample(dense[:, 0]), atol=1e-12)
    with pytest.raises(wristwise.InvalidInput, match="period"):
        wristwise.write_dense(tmp_path / "dense.csv", names, result.trajectory, 0)


def test_programs_are_written_and_read_back(seam_problem, tmp_path):
    result = wristwise.plan_graph_only(seam_problem)
    for format in (wristwise.ProgramFormat.krl, wristwise.ProgramFormat.rapid,
                   wristwise.ProgramFormat.ls, wristwise.ProgramFormat.trajectory_msgs):
        wristwise.check_export(format, seam_problem)
        file = wristwise.write_program(format, tmp_path, result, seam_problem)
        assert file.exists() and file.parent == tmp_path
        path = wristwise.read_joint_path(file, seam_problem.robot, seam_problem.exports)
        assert numpy.allclose(path.positions[-1], result.path.positions[-1], atol=1e-4)
    program = wristwise.robot_program(result, seam_problem)
    assert len(program.points) == 50 and program.points[1].welding
    assert wristwise.krl_text(program, seam_problem).startswith("&ACCESS")


def test_nothing_is_written_of_what_is_not_solved(unreachable_problem, tmp_path):
    result = wristwise.plan_graph_only(unreachable_problem)
    assert wristwise.write_program(wristwise.ProgramFormat.krl, tmp_path, result,
                                   unreachable_problem) is None
    assert not list(tmp_path.iterdir())
    with pytest.raises(wristwise.InvalidInput):
        wristwise.robot_program(result, unreachable_problem)
    with pytest.raises(wristwise.InvalidInput, match="problem.robot: None"):
        wristwise.robot_program(result, wristwise.Problem())
    with pytest.raises(wristwise.InvalidInput, match="joint_names: 1; expected 6"):
        wristwise.write_path(tmp_path / "a.csv", ["one"],
                             wristwise.JointPath(times=[0, 1], positions=numpy.zeros((2, 6))))


def test_a_placement_is_found(load, source):
    request = wristwise.load_placement(source / "problems" / "task_c_wrist_singularity.yaml",
                                       wristwise.LoadOptions(mesh_cache=False))
    request.options.map_points = 0
    request.options.evaluations = 6
    result = wristwise.place(request)
    assert result.status == wristwise.Status.solved
    assert result.found.measure.value <= result.given.measure.value
    assert result.after.two_stage.status == wristwise.Status.solved
    moved = wristwise.placed(request, result.found.offset)
    assert numpy.allclose(moved.part_frame, moved.motion @ request.part_frame)
    with pytest.raises(wristwise.InvalidInput, match=r"\(6,\)"):
        wristwise.placed(request, [0, 0, 0])
