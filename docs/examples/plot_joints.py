import matplotlib.pyplot as pyplot
import numpy
import wristwise

problem = wristwise.load_problem("problems/task_b_l_profile.yaml")
trajectory = wristwise.plan(problem).trajectory
t = numpy.linspace(trajectory.times[0], trajectory.times[-1], 500)
for derivative, name in enumerate(["position", "velocity", "acceleration", "jerk"]):
    axes = pyplot.subplot(4, 1, derivative + 1)
    axes.plot(t, trajectory.sample(t, derivative))             # (500, 6)
    axes.set_ylabel(name)
pyplot.savefig("joints.png")
