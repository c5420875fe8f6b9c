import threading

import wristwise

problem = wristwise.load_problem("problems/planar_3r.yaml")
problem.cost.vertex_cost = lambda waypoint, q: 0.1 * abs(q[0])     # rad of joint motion, stage 1

stop = threading.Event()                                           # stop.set() from anywhere
monitor = wristwise.Monitor(progress=lambda stage, share: print(stage, round(share, 2)),
                            log=lambda level, line: print(line), cancel=stop)
result = wristwise.plan(problem, wristwise.PlanOptions(threads=2, monitor=monitor))


class MyKinematics(wristwise.InverseKinematics):
    def solve(self, tcp):                                          # (4, 4) -> (solutions, joints)
        return known.solve(tcp)


known = wristwise.find_inverse_kinematics(problem.robot).solver
problem.inverse_kinematics = MyKinematics()
print(wristwise.plan(problem).inverse_kinematics)
