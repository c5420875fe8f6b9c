import wristwise

problem = wristwise.load_problem("problems/task_b_l_profile.yaml")
names = [joint.name for joint in problem.robot.joints]

points = wristwise.plan_graph_only(problem)            # stage 1 alone, a list of points
wristwise.write_path("points.csv", names, points.path)

file = wristwise.read_trajectory("points.csv", names)  # or a robot program: read_joint_path()
smooth = wristwise.smooth(problem, file.path)          # stage 2 alone, on a path from anywhere
wristwise.write_trajectory("smooth.csv", names, smooth.trajectory)

verdict = wristwise.check(problem, smooth.trajectory)  # the independent check
print(verdict.passed, verdict.clearance, verdict.clearance_pair, verdict.velocity_ratio)

# Without a problem: keep the TCP path that the joints draw.
keep = wristwise.SmoothingOptions(position_tolerance=0.0005, angle_tolerance=0.01)
print(wristwise.smooth(problem.robot, points.path, keep).status)
