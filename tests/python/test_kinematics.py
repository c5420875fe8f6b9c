import numpy
import pytest

import wristwise
from urdf_pose import tip_pose


def postures(robot, random, count):
    return random.uniform(robot.lower_limits, robot.upper_limits, (count, robot.joint_count))


def test_the_tcp_is_where_the_urdf_has_it(robot, source, random):
    urdf = source / "robots" / "kuka_kr5_arc" / "kuka_kr5_arc.urdf"
    names = [joint.name for joint in robot.joints]
    for q in postures(robot, random, 50):
        expected = tip_pose(urdf, "base_link", "torch_tip", dict(zip(names, q)))
        assert numpy.allclose(wristwise.tcp_pose(robot, q), expected, atol=1e-12)
        chain = wristwise.forward_kinematics(robot, q)
        assert numpy.allclose(chain.tcp, expected, atol=1e-12)
        assert chain.frames.shape == (6, 4, 4) and chain.axes.shape == (6, 3)
        assert numpy.allclose(chain.frames[-1] @ robot.tcp, expected, atol=1e-12)


def test_the_jacobian_is_that_of_numeric_differences(robot, random):
    step = 1e-6
    for q in postures(robot, random, 10):
        jacobian = wristwise.geometric_jacobian(robot, wristwise.forward_kinematics(robot, q))
        assert jacobian.shape == (6, 6)
        for j in range(6):
            ahead, behind = (wristwise.tcp_pose(robot, q + sign * step * numpy.eye(6)[j])
                             for sign in (1, -1))
            rate = (ahead - behind) / (2 * step)
            spin = rate[:3, :3] @ ahead[:3, :3].T
            assert numpy.allclose(jacobian[:3, j], rate[:3, 3], atol=1e-7)
            assert numpy.allclose(jacobian[3:, j], [spin[2, 1], spin[0, 2], spin[1, 0]], atol=1e-5)


def test_every_solution_reaches_the_pose(robot, random):
    found = wristwise.find_closed_form(robot)
    assert "wrist" in found.description
    for q in postures(robot, random, 20):
        pose = wristwise.tcp_pose(robot, q)
        branches = found.solver.solve(pose)
        assert branches.ndim == 2 and branches.shape[1] == 6
        for branch in branches:
            assert numpy.allclose(wristwise.tcp_pose(robot, branch), pose, atol=1e-9)
        turns = (branches - q) / (2 * numpy.pi)
        assert numpy.abs(turns - numpy.round(turns)).max(axis=1).min() < 1e-7


def test_out_of_reach_has_no_solutions(robot):
    far = wristwise.pose_from_xyz_rpy([9, 0, 0], [0, 0, 0])
    assert wristwise.find_closed_form(robot).solver.solve(far).shape[0] == 0


def test_a_posture_of_another_robot_is_refused(robot):
    with pytest.raises(wristwise.InvalidInput, match="joint values: 5; expected 6"):
        wristwise.tcp_pose(robot, numpy.zeros(5))


def test_a_pose_from_xyz_and_rpy():
    roll, pitch, yaw = 0.3, -0.4, 2.0
    c, s = numpy.cos, numpy.sin
    x = numpy.array([[1, 0, 0], [0, c(roll), -s(roll)], [0, s(roll), c(roll)]])
    y = numpy.array([[c(pitch), 0, s(pitch)], [0, 1, 0], [-s(pitch), 0, c(pitch)]])
    z = numpy.array([[c(yaw), -s(yaw), 0], [s(yaw), c(yaw), 0], [0, 0, 1]])
    pose = wristwise.pose_from_xyz_rpy([1, 2, 3], [roll, pitch, yaw])
    assert numpy.allclose(pose[:3, :3], z @ y @ x) and list(pose[:, 3]) == [1, 2, 3, 1]
    moving = wristwise.rotation_from_euler([0.3, -0.4, 2.0])
    assert numpy.allclose(moving, x @ y @ z)
    assert numpy.allclose(wristwise.euler_angles(moving), [0.3, -0.4, 2.0])


def test_a_deviation_and_back(random):
    box = wristwise.ToleranceBox(lower=[-1] * 3 + [-1.5] * 3, upper=[1] * 3 + [1.5] * 3)
    frame = wristwise.pose_from_xyz_rpy([0.1, 0.2, 0.3], [0.4, 0.5, 0.6])
    for e in random.uniform(-1, 1, (20, 6)):
        pose = wristwise.pose_at_deviation(box, frame, e)
        assert numpy.allclose(numpy.linalg.inv(frame) @ pose @ [0, 0, 0, 1], [*e[:3], 1])
        assert numpy.allclose(wristwise.deviation(box, frame, pose), e)
    assert list(wristwise.box_excess(box, [2, 0, 0, 0, -1.75, 0])) == [1, 0, 0, 0, 0.25, 0]


def test_a_clearance_is_that_of_two_spheres():
    ball = wristwise.Shape(geometry=wristwise.Sphere(radius=0.1))
    slider = wristwise.Robot(wristwise.Robot.Parts(
        name="slider", base_link="base", tip_link="tip",
        joints=[wristwise.Joint(name="x", type=wristwise.JointType.prismatic, axis=[1, 0, 0],
                                lower=-1, upper=1, max_velocity=1, max_acceleration=1,
                                max_jerk=1)],
        links=[wristwise.Link(name="ball", joint=0, collision=[ball])]))
    scene = wristwise.Scene(objects=[wristwise.SceneObject(
        name="post", shapes=[ball.replace(pose=wristwise.pose_from_xyz_rpy([0, 0.5, 0], [0] * 3))])])
    model = wristwise.ClearanceModel(slider, scene)
    assert model.pair_names == (("ball", "post"),)
    checker = wristwise.ClearanceChecker(model)
    with pytest.raises(wristwise.InvalidInput, match="no posture"):
        checker.nearest()
    for x in (-0.7, 0.0, 0.4):
        checker.set_posture([x])
        assert checker.nearest().distance == pytest.approx(numpy.hypot(x, 0.5) - 0.2, abs=1e-6)
    with pytest.raises(wristwise.InvalidInput, match="pair: 1; expected 0 to less than 1"):
        checker.distance(1)
