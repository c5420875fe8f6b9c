#!/usr/bin/env python3
"""Draws the pictures of concepts.md that explain words: draw_schemes.py FOLDER."""

import pathlib
import random
import sys

from drawing import BLUE, DARK, GREEN, GREY, ORANGE, RED, Drawing

STEEL, STEEL_DARK, BEAD = "#dfe3e8", "#c3cad2", "#e0862f"


def seen(x, y, z):
    """A point of the cell (x to the viewer, y to the right, z up) on the page."""
    return (150 + 1.0 * y - 0.55 * x, 310 + 0.42 * x - z + 0.12 * y)


def torch(draw, tip, axis, side, opacity=1):
    """A torch whose wire ends at `tip` of the page; unit vectors along the torch and across it."""
    def at(along, across):
        return (tip[0] + along * axis[0] + across * side[0], tip[1] + along * axis[1] + across * side[1])
    look = {"stroke": DARK, "opacity": opacity}
    draw.line(tip, at(30, 0), stroke=DARK, stroke_width=2.5, opacity=opacity)
    draw.polygon([at(28, -8), at(28, 8), at(75, 12), at(75, -12)], fill="#b3bac2", **look)
    draw.polygon([at(75, -12), at(75, 12), at(140, 12), at(140, -12)], fill=GREY, **look)


def draw_seam(file):
    """Seam, waypoints, tolerance box, path frame."""
    draw = Drawing(940, 470, "A seam with its waypoints, the tolerance box and path frame of one of them")
    length = 330
    for corners, colour in [([(0, 0, 0), (0, length, 0), (-20, length, 0), (-20, 0, 0)], STEEL),
                            ([(0, 0, 0), (0, length, 0), (0, length, 150), (0, 0, 150)], STEEL),
                            ([(0, length, 0), (0, length, 150), (-14, length, 150), (-14, length, 0)], STEEL_DARK),
                            ([(0, 0, 150), (0, length, 150), (-14, length, 150), (-14, 0, 150)], "#eef1f4"),
                            ([(0, 0, 0), (0, length, 0), (170, length, 0), (170, 0, 0)], "#eef1f4"),
                            ([(170, 0, 0), (170, length, 0), (170, length, -14), (170, 0, -14)], STEEL_DARK)]:
        draw.polygon([seen(*corner) for corner in corners], fill=colour, stroke="#6b7480")
    runs = [seen(0, -45, 0), seen(0, 0, 0), seen(0, length, 0), seen(0, length + 45, 0)]
    draw.line(runs[1], runs[2], stroke=BEAD, stroke_width=9, stroke_linecap="round")
    for a, b in [(runs[0], runs[1]), (runs[2], runs[3])]:
        draw.line(a, b, stroke=GREEN, stroke_width=2.5, stroke_dasharray="6 4")
    waypoints = [seen(0, length * i / 10, 0) for i in range(11)]
    for place in waypoints:
        draw.dot(place, 4, fill="#ffffff", stroke=DARK, stroke_width=1.5)
    draw.text(runs[0][0] - 10, runs[0][1] - 10, "run-in", text_anchor="end", fill=GREEN)
    draw.text(runs[3][0] - 24, runs[3][1] - 14, "run-out", fill=GREEN)
    draw.text(waypoints[2][0] - 40, waypoints[2][1] - 40, "waypoints, on the seam", fill=DARK)
    draw.line((waypoints[2][0] + 6, waypoints[2][1] - 34), (waypoints[2][0] + 2, waypoints[2][1] - 8),
              stroke=DARK)
    draw.text(*seen(110, 40, -4), "part", fill=DARK)

    at = waypoints[7]
    axis, side = (-0.5, -0.866), (0.866, -0.5)
    torch(draw, (at[0] - 2, at[1] - 2), (-0.22, -0.975), (0.975, -0.22), opacity=0.25)
    torch(draw, (at[0] - 2, at[1] - 2), axis, side)
    _box(draw, at)
    draw.text(150, 74, "torch at its nominal pose, and leaning", fill=DARK)
    draw.text(150, 91, "as far as the tolerance lets it", fill=DARK)
    draw.line((300, 98), (at[0] - 66, at[1] - 148), stroke=DARK)
    _enlarged(draw, at)
    draw.write(file)


def _box(draw, at):
    draw.dot(at, 15, fill="none", stroke=RED, stroke_width=1.5)


def _enlarged(draw, at):
    """The box and the frame at one waypoint, larger."""
    left, top, right, bottom = 640, 60, 920, 400
    draw.line((at[0] + 14, at[1] - 5), (left, top), stroke=RED, stroke_dasharray="3 3")
    draw.line((at[0] + 10, at[1] + 11), (left, bottom), stroke=RED, stroke_dasharray="3 3")
    draw.add("rect", x=left, y=top, width=right - left, height=bottom - top, fill="#ffffff", stroke=RED)
    centre = (770, 225)

    def point(x, y, z):
        """In the path frame: x down to the left, y to the right, z down to the right."""
        return (centre[0] - 0.62 * x + 1.0 * y + 0.42 * z, centre[1] + 0.5 * x + 0.1 * y + 0.9 * z)
    wide, long, deep = 62, 44, 48
    hidden = (1, 1, -1)
    corners = {(i, j, k): point(i * wide, j * long, k * deep)
               for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)}
    for a in corners:
        for b in corners:
            if a < b and sum(p != q for p, q in zip(a, b)) == 1:
                dashes = {"stroke_dasharray": "4 4"} if hidden in (a, b) else {}
                draw.line(corners[a], corners[b], stroke=GREY, stroke_width=1.5, **dashes)
    draw.line(point(0, -110, 0), point(0, 130, 0), stroke=BEAD, stroke_width=5, opacity=0.6)
    for tip, colour, name in [(point(115, 0, 0), RED, "x"), (point(0, 112, 0), GREEN, "y: along the weld"),
                              (point(0, 0, 105), BLUE, "z: the torch's axis")]:
        draw.arrow(centre, tip, colour, 2.5)
        place = {"x": (tip[0] - 16, tip[1] + 4), "y: along the weld": (tip[0] - 82, tip[1] + 22),
                 "z: the torch's axis": (tip[0] - 110, tip[1] + 20)}[name]
        draw.text(*place, name, fill=colour, font_weight="bold")
    draw.text(left + 12, top + 22, "path frame and tolerance box", fill=DARK, font_weight="bold")
    draw.text(left + 12, top + 42, "the TCP may be anywhere in the box,", fill=DARK)
    draw.text(left + 12, top + 59, "turned by no more than its angles", fill=DARK)


def draw_ladder(file):
    """Rungs, edges, the best path, and the curve that refinement makes of it."""
    draw = Drawing(940, 400, "A ladder graph: rungs of postures, edges, the best path and the refined curve")
    chance = random.Random(4)
    columns = [90 + 76 * i for i in range(11)]
    nominal = [235 - 5 * i for i in range(5)] + [185, 172, 165, 160, 157, 155]
    rungs = []
    for i, _ in enumerate(columns):
        ys = [nominal[i] + step + chance.uniform(-4, 4) for step in (-90, -62, -36, -12, 12, 36, 62, 88)]
        blocked = {j for j, y in enumerate(ys) if 4 <= i <= 6 and y > 175}
        rungs.append([(y, j in blocked) for j, y in enumerate(ys)])
    for i in range(10):
        for y0, b0 in rungs[i]:
            for y1, b1 in rungs[i + 1]:
                if not b0 and not b1 and abs(y1 - y0) < 58:
                    draw.line((columns[i], y0), (columns[i + 1], y1), stroke="#d5dae0", stroke_width=0.8)
    path = _least_path(rungs)
    places = [(x, rungs[i][j][0]) for i, (x, j) in enumerate(zip(columns, path))]
    for i, x in enumerate(columns):
        draw.line((x, 60), (x, 340), stroke="#eef1f4", stroke_width=8)
    for i, x in enumerate(columns):
        for y, blocked in rungs[i]:
            if blocked:
                for a in (-1, 1):
                    draw.line((x - 4, y - 4 * a), (x + 4, y + 4 * a), stroke=RED, stroke_width=2)
            else:
                draw.dot((x, y), 3.5, fill="#ffffff", stroke=GREY, stroke_width=1.5)
    draw.polyline(places, stroke=GREY, stroke_width=2.5)
    for place in places:
        draw.dot(place, 4, fill=DARK)
    smooth = [y for _, y in places]
    for _ in range(8):
        smooth = [smooth[0]] + [0.25 * a + 0.5 * b + 0.25 * c
                                for a, b, c in zip(smooth, smooth[1:], smooth[2:])] + [smooth[-1]]
        smooth[0], smooth[-1] = 2 * smooth[1] - smooth[2], 2 * smooth[-2] - smooth[-3]
    draw.add("path", d=_through(list(zip(columns, smooth))), fill="none", stroke=BLUE, stroke_width=3)
    draw.arrow((40, 345), (40, 70))
    draw.text(28, 56, "a joint", fill=DARK)
    for i, x in enumerate(columns):
        draw.text(x, 362, str(i), text_anchor="middle", fill=DARK)
    draw.text(columns[-1] + 20, 386, "waypoint", text_anchor="end", fill=DARK)
    entries = [(BLUE, "refined trajectory: a curve"), (DARK, "seed: the best path"), ("#d5dae0", "edges"),
               (RED, "× posture that is too near to something")]
    x = 90
    for colour, words in entries:
        if words[0] != "×":
            draw.line((x, 26), (x + 24, 26), stroke=colour, stroke_width=3)
        draw.text(x + (0 if words[0] == "×" else 30), 30, words, fill=colour if colour == RED else DARK)
        x += 62 + 6.4 * len(words)
    draw.text(columns[0] - 8, 338, "rung", text_anchor="end", fill=DARK)
    draw.write(file)


def _least_path(rungs):
    """The cheapest way from the first rung to the last, by steps squared and a pull to sample rows."""
    cost = {j: (0, [j]) for j, (_, blocked) in enumerate(rungs[0]) if not blocked and j == 4}
    for before, rung in zip(rungs, rungs[1:]):
        cost = {j: min((c + abs(y - before[k][0]), way + [j]) for k, (c, way) in cost.items())
                for j, (y, blocked) in enumerate(rung) if not blocked}
    return min(cost.values())[1]


def _through(points):
    """A smooth curve through points, as cubic pieces (Catmull and Rom)."""
    ends = [points[0], *points, points[-1]]
    text = f"M{points[0][0]:.1f} {points[0][1]:.1f}"
    for a, b, c, d in zip(ends, ends[1:], ends[2:], ends[3:]):
        text += (f" C{b[0] + (c[0] - a[0]) / 6:.1f} {b[1] + (c[1] - a[1]) / 6:.1f}"
                 f" {c[0] - (d[0] - b[0]) / 6:.1f} {c[1] - (d[1] - b[1]) / 6:.1f} {c[0]:.1f} {c[1]:.1f}")
    return text


def draw_pipeline(file):
    """From the problem to the verdict."""
    draw = Drawing(940, 210, "From a problem to a verified trajectory: two stages and a check")
    boxes = [("problem", ["robot, scene,", "seam, tolerance"], "#eef1f4"),
             ("1  ladder graph", ["sample, inverse", "kinematics, best path"], "#e3eef2"),
             ("2  refinement", ["a smooth curve inside", "the same tolerances"], "#e3eef2"),
             ("check", ["independent,", "for all times"], "#e8f4ea"),
             ("result", ["trajectory, report,", "robot program"], "#eef1f4")]
    passed = ["", "seed", "curve", "verdict"]
    width, gap = 142, 52
    for i, (name, lines, colour) in enumerate(boxes):
        left = 11 + i * (width + gap)
        draw.add("rect", x=left, y=70, width=width, height=86, rx=8, fill=colour, stroke=DARK)
        draw.text(left + width / 2, 96, name, text_anchor="middle", font_weight="bold", fill=DARK)
        for k, line in enumerate(lines):
            draw.text(left + width / 2, 120 + 18 * k, line, text_anchor="middle", fill=DARK)
        if i:
            draw.arrow((left - gap + 2, 113), (left - 2, 113))
            draw.text(left - gap / 2, 105, passed[i - 1], text_anchor="middle", fill=DARK)
    second = 11 + 2 * (width + gap) + width / 2
    draw.arrow((second, 192), (second, 158), ORANGE)
    draw.text(second + 12, 190, "smooth: a joint path of your own", fill=ORANGE)
    first, check = 11 + width + gap + width / 2, 11 + 3 * (width + gap) + width / 2
    draw.polyline([(first, 70), (first, 36), (check, 36), (check, 62)], stroke=GREY, stroke_width=2)
    draw.arrow((check, 56), (check, 69), GREY)
    draw.text((first + check) / 2, 28, "graph-only: the path itself, as points", text_anchor="middle", fill=DARK)
    draw.write(file)


if __name__ == "__main__":
    into = pathlib.Path(sys.argv[1])
    draw_seam(into / "seam.svg")
    draw_ladder(into / "ladder_graph.svg")
    draw_pipeline(into / "pipeline.svg")
