import numpy
import wristwise

problem = wristwise.load_problem("problems/task_b_l_profile.yaml")
waypoints = problem.task.waypoints
frames = numpy.array([waypoint.frame for waypoint in waypoints])
frames[:, 0, 3] += 1                                   # 1 m away
problem.task = wristwise.Task.through(frames, [waypoint.time for waypoint in waypoints],
                                      waypoints[0].tolerance)
result = wristwise.plan(problem)
assert result.status == wristwise.Status.infeasible
for diagnosis in result.diagnosis:
    print(diagnosis.waypoint, diagnosis.reason, diagnosis.detail, diagnosis.suggestion)
