import matplotlib.pyplot as pyplot
import numpy
import wristwise

problem = wristwise.load_problem("problems/task_b_l_profile.yaml")
trajectory = wristwise.plan(problem).trajectory
t = numpy.linspace(trajectory.times[0], trajectory.times[-1], 500)
names = ["position", "velocity", "acceleration", "jerk"]
figure, rows = pyplot.subplots(len(names), sharex=True, layout="constrained")
for derivative, (axes, name) in enumerate(zip(rows, names)):
    axes.plot(t, trajectory.sample(t, derivative))             # (500, 6)
    axes.set_ylabel(name)
pyplot.savefig("joints.png")
