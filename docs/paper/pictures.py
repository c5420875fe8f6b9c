#!/usr/bin/env python3
"""Makes the pictures of docs/paper.md and those of --plot in docs/report.md again:
python3 docs/paper/pictures.py [build/wristwise]

Most are what `wristwise compare --plot` writes, as it is; two put panels of several runs side by side.
"""

import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PICTURES = HERE.parent / "pictures"
SVG = "{http://www.w3.org/2000/svg}"

PANEL_LEFT, PANEL_RIGHT, PANEL_TOP, PANEL_BELOW = 58, 16, 18, 40  # px around a panel's frame
HEADING = 34  # px

# Copied: the problem that `compare --plot` draws, and which of its pictures.
COPIED = {
    "paper_08_a.svg": (HERE / "task_a_100_points.yaml", "joint_positions.svg"),
    "paper_08_b.svg": (HERE / "task_b_standard_cost.yaml", "joint_positions.svg"),
    "paper_13.svg": (HERE / "task_c_past_the_plate.yaml", "joint_positions.svg"),
    "paper_13_spin.svg": (HERE / "task_c_with_spin.yaml", "joint_positions.svg"),
    "paper_15.svg": (HERE / "task_b_improved_cost.yaml", "joint_positions.svg"),
}

# Side by side: heading, command, problem, picture of --plot and panel in it.
TASK_C = ROOT / "problems" / "task_c_wrist_singularity.yaml"
CORNER = ROOT / "problems" / "corner_stop.yaml"
SIDE_BY_SIDE = {
    "paper_10.svg": [
        ("Graph-only, moves not checked: jumps", ["plan", "--mode", "graph-only"],
         HERE / "task_b_unchecked_moves.yaml", "tolerance.svg", "rx deviation"),
        ("Two-stage: stops before the plate", ["plan"],
         ROOT / "problems" / "task_b_jump.yaml", "tolerance.svg", "rx deviation"),
    ],
    "paper_14.svg": [
        ("Standard cost (eq. 4)", ["compare"], HERE / "task_b_standard_cost.yaml", "tolerance.svg", "ry deviation"),
        ("Improved cost (eq. 9)", ["compare"], HERE / "task_b_improved_cost.yaml", "tolerance.svg", "ry deviation"),
    ],
    "plot_joints.svg": [
        (name, ["compare"], TASK_C, "joints.svg", f"joint_a6 {name}")
        for name in ("position", "velocity", "acceleration", "jerk")
    ],
    "plot_tolerance.svg": [
        ("deviation", ["compare"], CORNER, "tolerance.svg", "ry deviation"),
        ("share of the tolerance", ["compare"], CORNER, "tolerance.svg", "ry share"),
    ],
}

RESULT, BEHIND, EDGE = "#1f6fd0", "#9b9b9b", "#c62828"
MOTIONS = [("two-stage", RESULT, None), ("graph-only", BEHIND, None)]
EDGES = [("edge of the tolerance", EDGE, "5 3")]
LEGEND = {
    "paper_10.svg": [("what is found", RESULT, None), *EDGES],
    "paper_14.svg": MOTIONS + EDGES,
    "plot_joints.svg": MOTIONS,
    "plot_tolerance.svg": MOTIONS + EDGES,
}


def run(program, command, problem, folder):
    """Runs wristwise; 0 (solved) and 1 (no trajectory that passes) both leave pictures."""
    arguments = [program, command[0], str(problem), *command[1:], "--plot", "--no-report", "--quiet",
                 "--out", str(folder)]
    result = subprocess.run(arguments, stdout=subprocess.DEVNULL, check=False)
    if result.returncode not in (0, 1):
        sys.exit(f"{' '.join(arguments)}: exit status {result.returncode}")


def panel(file, name, index):
    """The group of that panel, and its frame (x, y, width, height)."""
    text = re.sub(r"clip(\d+)", rf"clip{index}_\1", file.read_text(encoding="utf-8"))
    for group in ET.fromstring(text).findall(f"{SVG}g"):
        if group.findtext(f"{SVG}title") == name:
            frame = group.findall(f"{SVG}rect")[-1]
            return group, [float(frame.get(key)) for key in ("x", "y", "width", "height")]
    sys.exit(f"{file}: no panel '{name}'")


def text(x, y, words, size=12, anchor="start"):
    element = ET.Element(f"{SVG}text", {"x": f"{x:g}", "y": f"{y:g}", "font-size": f"{size}", "text-anchor": anchor})
    element.text = words
    return element


def legend(entries, y):
    """From left to right."""
    x, elements = 12.0, []
    for words, colour, dash in entries:
        line = {"x1": f"{x:g}", "y1": f"{y - 4:g}", "x2": f"{x + 22:g}", "y2": f"{y - 4:g}", "stroke": colour,
                "stroke-width": "2"}
        if dash:
            line["stroke-dasharray"] = dash
        elements += [ET.Element(f"{SVG}line", line), text(x + 28, y, words)]
        x += 28 + 6.8 * len(words) + 18
    return elements


def side_by_side(parts, entries, file):
    width = sum(PANEL_LEFT + frame[2] + PANEL_RIGHT for _, _, frame in parts)
    height = 2 * HEADING + PANEL_TOP + max(frame[3] for _, _, frame in parts) + PANEL_BELOW
    root = ET.Element(f"{SVG}svg", {"width": f"{width:g}", "height": f"{height:g}",
                                    "viewBox": f"0 0 {width:g} {height:g}", "font-family": "sans-serif"})
    ET.SubElement(root, f"{SVG}rect", {"width": f"{width:g}", "height": f"{height:g}", "fill": "white"})
    root.extend(legend(entries, 22))
    left = PANEL_LEFT
    for heading, group, (x, y, frame_width, frame_height) in parts:
        top = 2 * HEADING + PANEL_TOP - 8
        root.append(text(left + frame_width / 2, top - 28, heading, 14, "middle"))
        moved = ET.SubElement(root, f"{SVG}g", {"transform": f"translate({left - x:g} {top - y:g})"})
        moved.append(group)
        root.append(text(left + frame_width / 2, top + frame_height + 34, "time, s", 12, "middle"))
        left += frame_width + PANEL_RIGHT + PANEL_LEFT
    file.write_text(ET.tostring(root, encoding="unicode") + "\n", encoding="utf-8")


def main():
    program = str(Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "wristwise").resolve())
    ET.register_namespace("", SVG[1:-1])
    with tempfile.TemporaryDirectory() as scratch:
        folders = {}

        def folder_of(command, problem):
            key = (tuple(command), problem)
            if key not in folders:
                folders[key] = Path(scratch) / str(len(folders))
                run(program, command, problem, folders[key])
            return folders[key]

        for name, (problem, picture) in COPIED.items():
            (PICTURES / name).write_bytes((folder_of(["compare"], problem) / picture).read_bytes())
        for name, runs in SIDE_BY_SIDE.items():
            parts = []
            for index, (heading, command, problem, picture, panel_name) in enumerate(runs):
                parts.append((heading, *panel(folder_of(command, problem) / picture, panel_name, index)))
            side_by_side(parts, LEGEND[name], PICTURES / name)


if __name__ == "__main__":
    main()
