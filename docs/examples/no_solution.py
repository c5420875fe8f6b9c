import wristwise

problem = wristwise.load_problem("problems/task_b_l_profile.yaml")
problem.scene.clearance = 0.08
problem.graph.try_relaxations = False
result = wristwise.plan(problem)
assert result.status == wristwise.Status.infeasible
for diagnosis in result.diagnosis:
    print(diagnosis.waypoint, diagnosis.reason, diagnosis.detail, diagnosis.suggestion)
