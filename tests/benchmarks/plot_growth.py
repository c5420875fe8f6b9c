#!/usr/bin/env python3
"""Draws docs/pictures/growth.svg and refinement_growth.svg from the benchmarks' output.

    build/tests/graph_benchmark --benchmark_filter=Growth --benchmark_format=json > growth.json
    tests/benchmarks/plot_growth.py growth.json docs/pictures/growth.svg
    build/tests/refinement_benchmark --benchmark_filter=Growth --benchmark_format=json > growth.json
    tests/benchmarks/plot_growth.py growth.json docs/pictures/refinement_growth.svg
"""

import json
import math
import sys

WIDTH, HEIGHT, LEFT, BOTTOM, TOP = 330, 240, 56, 40, 28
COLOURS = {"ms": "#1f6f8b", "MB": "#c65d21"}
# Program -> benchmark, title and unit of its two panels.
PANELS = {
    "graph_benchmark": [("GrowthWithWaypoints", "36 samples a waypoint", "waypoints"),
                        ("GrowthWithSamples", "30 waypoints", "samples a waypoint")],
    "refinement_benchmark": [("GrowthWithWaypoints", "the same seam cut finer", "waypoints"),
                             ("GrowthWithLength", "2.5 mm a waypoint", "waypoints")],
}


def series(benchmarks, name):
    rows = []
    for entry in benchmarks:
        parts = entry["name"].split("/")
        if parts[0] == name and not entry.get("error_occurred"):
            rows.append((int(parts[1]), {"ms": entry["real_time"], "MB": entry["MB"]}))
    return sorted(rows)


def decades(values):
    return math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))


def panel(rows, title, unit, left):
    xs = [x for x, _ in rows]
    ys = [value for _, y in rows for value in y.values()]
    (x0, x1), (y0, y1) = decades(xs), decades(ys)
    width, height = WIDTH - LEFT - 14, HEIGHT - BOTTOM - TOP

    def place(x, y):
        return (left + LEFT + width * (math.log10(x) - x0) / (x1 - x0),
                TOP + height * (1 - (math.log10(y) - y0) / (y1 - y0)))

    parts = [f'<text x="{left + LEFT + width / 2}" y="16" text-anchor="middle" '
             f'font-weight="bold">{title}</text>']
    for decade in range(x0, x1 + 1):
        x, _ = place(10**decade, 10**y0)
        parts.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{TOP}" y2="{TOP + height}" '
                     'stroke="#ddd"/>')
        parts.append(f'<text x="{x:.1f}" y="{TOP + height + 15}" '
                     f'text-anchor="middle">1e{decade}</text>')
    for decade in range(y0, y1 + 1):
        _, y = place(10**x0, 10**decade)
        parts.append(f'<line x1="{left + LEFT}" x2="{left + LEFT + width}" y1="{y:.1f}" '
                     f'y2="{y:.1f}" stroke="#ddd"/>')
        parts.append(f'<text x="{left + LEFT - 6}" y="{y + 4:.1f}" '
                     f'text-anchor="end">1e{decade}</text>')
    parts.append(f'<text x="{left + LEFT + width / 2}" y="{TOP + height + 32}" '
                 f'text-anchor="middle">{unit}</text>')
    for what, colour in COLOURS.items():
        points = [place(x, y[what]) for x, y in rows]
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>')
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in points]
        x, y = points[-1]
        parts.append(f'<text x="{x - 6:.1f}" y="{y - 7:.1f}" text-anchor="end" '
                     f'fill="{colour}">{what}</text>')
    return parts


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        output = json.load(file)
    program = output["context"]["executable"].split("/")[-1]
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{2 * WIDTH}" height="{HEIGHT}" '
             'font-family="sans-serif" font-size="11">',
             f'<rect width="{2 * WIDTH}" height="{HEIGHT}" fill="white"/>']
    for place, (name, title, unit) in enumerate(PANELS[program]):
        parts += panel(series(output["benchmarks"], name), title, unit, place * WIDTH)
    parts.append("</svg>")
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "\n")


if __name__ == "__main__":
    main()
