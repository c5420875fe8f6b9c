import math

import numpy
import wristwise

robot = wristwise.load_robot(wristwise.RobotSource(
    urdf="robots/kuka_kr5_arc/kuka_kr5_arc.urdf", base_link="base_link", tip_link="torch_tip",
    limits="robots/kuka_kr5_arc/joint_limits.yaml"))

frames = numpy.tile(wristwise.pose_from_xyz_rpy([0.9, 0, 0.3], [0, math.pi, 0]), (40, 1, 1))
frames[:, 1, 3] = numpy.linspace(-0.2, 0.2, 40)        # (N, 4, 4), z towards the part, y along the weld
tilt = math.radians(10)
box = wristwise.ToleranceBox(lower=[0, 0, 0, -tilt, -tilt, -math.inf],
                             upper=[0, 0, 0, tilt, tilt, math.inf])
plate = wristwise.SceneObject(name="plate", shapes=[wristwise.Shape(
    geometry=wristwise.Box(size=[0.4, 0.6, 0.01]),
    pose=wristwise.pose_from_xyz_rpy([0.9, 0, 0.28], [0, 0, 0]))])

problem = wristwise.Problem(
    robot=robot,
    task=wristwise.Task.through(frames, times=numpy.arange(40.0), tolerance=box),
    scene=wristwise.Scene(objects=[plate], clearance=0.005),
    graph=wristwise.GraphOptions(step=numpy.radians([0, 0, 0, 5, 5, 20])))
assert wristwise.plan(problem).status == wristwise.Status.solved

# As a problem file says it: lines, arcs, joint waypoints, corners, run-in and run-out.
line = wristwise.LineSegment(from_=frames[0], to=frames[-1])
description = wristwise.SeamDescription(
    segments=[wristwise.Segment(shape=line, tolerance=box)], speed=0.01, spacing=0.01,
    run_in=wristwise.RunDescription(length=0.01), run_out=wristwise.RunDescription(length=0.01))
problem.task = wristwise.build_task(robot, description)
assert wristwise.plan(problem).status == wristwise.Status.solved
