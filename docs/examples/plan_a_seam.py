import wristwise

problem = wristwise.load_problem("problems/task_b_l_profile.yaml")
result = wristwise.plan(problem)
print(result.status, result.refine.objective, result.path.positions.shape)
