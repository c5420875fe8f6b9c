#!/usr/bin/env python3
"""Draws the pictures of concepts.md that are made of real runs:

    docs/pictures/draw_runs.py build/wristwise docs/pictures
"""

import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

from drawing import BLUE, DARK, GREEN, GREY, ORANGE, Drawing, Plot

PROBLEMS = pathlib.Path(__file__).resolve().parents[2] / "problems"


class Run:
    """What `wristwise compare` writes of a problem."""

    def __init__(self, program, problem, folder):
        self.folder = folder / problem
        subprocess.run([program, "--quiet", "--no-cache", "compare", PROBLEMS / f"{problem}.yaml",
                        "--out", self.folder], check=True, stdout=subprocess.DEVNULL)
        page = (self.folder / "report.html").read_text()
        self.report = json.loads(re.search(r'id="data">(.*?)</script>', page, re.DOTALL)[1])

    def columns(self, file):
        with open(self.folder / file, newline="") as rows:
            table = list(csv.DictReader(rows))
        return {name: [float(row[name]) for row in table] for name in table[0]}


def degrees(values):
    return [math.degrees(value) for value in values]


def divided(times, values):
    """Slopes from point to point, and the times half-way."""
    pairs = list(zip(times, values))
    return ([(a[0] + b[0]) / 2 for a, b in zip(pairs, pairs[1:])],
            [(b[1] - a[1]) / (b[0] - a[0]) for a, b in zip(pairs, pairs[1:])])


def round_range(low, high):
    """Round numbers about a range, and the step between at most five of them."""
    step = next(s * 10 ** k for k in range(-3, 6) for s in (1, 2, 5) if high - low < 4 * s * 10 ** k)
    return step * math.floor(low / step), step * math.ceil(high / step), step


def ticks(low, high, step):
    return [low + i * step for i in range(round((high - low) / step) + 1)]


def turned(quaternion, v):
    """A vector turned by a quaternion (x, y, z, w)."""
    x, y, z, w = quaternion
    t = (2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0]))
    return (v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0])


def times(a, b):
    """The product of two quaternions (x, y, z, w)."""
    return (a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
            a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
            a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
            a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2])


def tcp(robot, posture):
    """Place of the TCP: forward kinematics of the report's robot, all of whose joints turn."""
    point, turn = (0, 0, 0), (0, 0, 0, 1)
    steps = [(joint["origin"], joint["axis"], q) for joint, q in zip(robot["joints"], posture)]
    for pose, axis, q in [*steps, (robot["tcp"], (0, 0, 1), 0)]:
        point = tuple(p + d for p, d in zip(point, turned(turn, pose[:3])))
        about = (*(math.sin(q / 2) * a for a in axis), math.cos(q / 2))
        turn = times(times(turn, pose[3:]), about)
    return point


def key(draw, x, y, entries):
    for colour, words in entries:
        draw.line((x, y - 4), (x + 24, y - 4), stroke=colour, stroke_width=3)
        draw.text(x + 30, y, words, fill=DARK)
        x += 50 + 7 * len(words)


def draw_joints(run, file):
    """Joints 4 and 6 of task C, where the wrist is singular half-way."""
    graph, curve = run.columns("graph-only/trajectory.csv"), run.columns("two-stage/trajectory_dense.csv")
    draw = Drawing(940, 430, "Joints 4 and 6 of task C: graph-only jumps, two-stage does not")
    end = graph["time"][-1]
    for row, joint in enumerate(["joint_a4", "joint_a6"]):
        for column in range(2):
            left, top = 60 + 470 * column, 60 + 185 * row
            if column == 0:
                ys = [degrees(graph[joint]), degrees(curve[joint])]
                xs = [graph["time"], curve["time"]]
                name = f"joint {joint[-1]}, deg"
            else:
                of_points = divided(graph["time"], degrees(graph[joint]))
                xs, ys = [of_points[0], curve["time"]], [of_points[1], degrees(curve[f"{joint}_velocity"])]
                name = f"joint {joint[-1]}, deg/s"
            low, high, step = round_range(min(map(min, ys)), max(map(max, ys)))
            plot = Plot(draw, (left, top, left + 390, top + 120), (0, end), (low, high))
            plot.frame(name, range(0, int(end) + 1, 6), ticks(low, high, step),
                       "time, s" if row else "")
            plot.curve(xs[0], ys[0], stroke=GREY, stroke_width=1.5)
            plot.dots(xs[0], ys[0], 2, fill=GREY)
            plot.curve(xs[1][::40], ys[1][::40], stroke=BLUE, stroke_width=2.5)
    key(draw, 60, 24, [(GREY, "the best path of the ladder graph"), (BLUE, "after refinement")])
    draw.write(file)


def draw_clearance(run, file):
    """Clearance of task B over time."""
    curve, graph = run.report["motions"]
    verification = run.report["result"]["verification"]
    required = 1000 * run.report["clearance"]
    draw = Drawing(940, 280, "Clearance over time in task B, held at every moment")
    window = (12, 22)
    plot = Plot(draw, (60, 60, 900, 220), window, (0, 8))
    plot.frame("least distance of all pairs of bodies, mm", range(12, 23), range(0, 9, 2), "time, s")
    for motion, colour, width in [(graph, GREY, 1.5), (curve, BLUE, 2.5)]:
        distance = [1000 * d for d in motion["samples"]["clearance"]["distance"]]
        plot.curve(motion["samples"]["time"], [min(d, 8) for d in distance], stroke=colour,
                   stroke_width=width)
    at_waypoints = run.report["seam"]["time"]
    samples = graph["samples"]
    near = [min(range(len(samples["time"])), key=lambda i, t=t: abs(samples["time"][i] - t))
            for t in at_waypoints]
    plot.dots(at_waypoints, [min(8, 1000 * samples["clearance"]["distance"][i]) for i in near], 2.5,
              fill=GREY)
    plot.curve(window, [required] * 2, stroke=ORANGE, stroke_width=2, stroke_dasharray="7 5")
    place = plot.at(window[1], required)
    draw.text(place[0] - 4, place[1] + 17, f"required: {required:g} mm", fill=ORANGE, text_anchor="end")
    shown = 1000 * verification["clearance_bound_m"]
    key(draw, 60, 24, [(GREY, "graph-only (dots: waypoints)"),
                       (BLUE, f"two-stage: {shown:.3f} mm or more, shown for all t")])
    draw.write(file)


def draw_speed(run, file):
    """Speed of the TCP on a seam with run-in, a stop at its corner, and run-out."""
    motion = run.columns("two-stage/trajectory_dense.csv")
    robot = run.report["robot"]
    names = [joint["name"] for joint in robot["joints"]]
    every = range(0, len(motion["time"]), 10)
    at = [motion["time"][i] for i in every]
    points = [tcp(robot, [motion[name][i] for name in names]) for i in every]
    speeds = [1000 * math.dist(a, b) / (t1 - t0)
              for a, b, t0, t1 in zip(points, points[1:], at, at[1:])]
    middles = [(a + b) / 2 for a, b in zip(at, at[1:])]
    weld = [t for t, welding in zip(motion["time"], motion["welding"]) if welding > 0.5]
    draw = Drawing(940, 260, "Speed of the TCP: run-in, weld with a stop at the corner, run-out")
    plot = Plot(draw, (60, 50, 900, 200), (at[0], at[-1]), (0, 12))
    plot.shade(weld[0], weld[-1], "#e8f4ea")
    plot.frame("speed of the TCP, mm/s", range(0, int(at[-1]) + 1, 5), range(0, 13, 2), "time, s")
    plot.curve(middles, speeds, stroke=BLUE, stroke_width=2.5)
    still = [t for t, speed in zip(middles, speeds) if speed < 1 and weld[0] < t < weld[-1]]
    stop = (still[0] + still[-1]) / 2
    for x, y, words, colour in [(weld[0] - 1, 11, "run-in", DARK), (weld[-1] + 1, 11, "run-out", DARK),
                                (stop, 6, "stop at the corner:", DARK), (stop, 4.5, "the torch turns", DARK),
                                ((weld[0] + still[0]) / 2, 11, "weld", GREEN)]:
        draw.text(*plot.at(x, y), words, text_anchor="middle", fill=colour)
    draw.write(file)


def main(program, folder):
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        draw_joints(Run(program, "task_c_wrist_singularity", scratch), folder / "two_stage_joints.svg")
        draw_clearance(Run(program, "task_b_l_profile", scratch), folder / "clearance.svg")
        draw_speed(Run(program, "corner_stop", scratch), folder / "speed.svg")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]))
