"""Colours where a person reads on a terminal that has them, and there only."""

import pathlib
import unittest

from program import COLOUR, ESCAPE, ProgramTest, run, run_on_terminal

TASK = "problems/corner_stop.yaml"
COMMANDS = {
    "plan": ["plan", TASK],
    "compare": ["compare", TASK],
    "check": ["check", TASK, "t.csv"],
    "smooth": ["smooth", TASK, "--joints", "t.csv"],
    "info": ["info", "robots/planar_3r/planar_3r.urdf"],
    "new": ["new", "n.yaml", "--force"],
    "help": ["plan", "--help"],
    "help of all": ["--help"],
}


class Colours(ProgramTest):
    def setUp(self):
        super().setUp()
        status, _, _ = run(["plan", TASK, "--mode", "graph-only", "--out", "g"], self.folder)
        self.assertEqual(status, 0)
        (self.folder / "g/trajectory.csv").rename(self.folder / "t.csv")

    def test_on_a_terminal_every_command_has_them(self):
        for name, arguments in COMMANDS.items():
            _, written = run_on_terminal(arguments, self.folder)
            self.assertRegex(written, COLOUR, name)

    def test_in_a_pipe_there_are_none(self):
        for name, arguments in COMMANDS.items():
            _, out, err = run(arguments, self.folder)
            self.assertNotIn(b"\x1b", out + err, name)

    def test_none_with_no_color_a_dumb_terminal_or_no_type(self):
        for changes in ({"NO_COLOR": "1"}, {"TERM": "dumb"}, {"TERM": None}):
            _, written = run_on_terminal(["plan", TASK], self.folder, **changes)
            self.assertNotRegex(written, COLOUR, changes)
        _, written = run_on_terminal(["plan", TASK], self.folder, NO_COLOR="")  # empty: not set
        self.assertRegex(written, COLOUR)

    def test_the_option_has_the_last_word(self):
        _, out, _ = run(["plan", TASK, "--color", "always"], self.folder, NO_COLOR="1")
        self.assertRegex(out, COLOUR)
        _, written = run_on_terminal(["plan", TASK, "--color", "never"], self.folder)
        self.assertNotRegex(written, COLOUR)
        _, out, _ = run(["--color", "always", "plan", "--help"], self.folder)
        self.assertRegex(out, COLOUR)

    def test_each_stream_for_itself(self):
        _, written = run_on_terminal(["plan", "none.yaml"], self.folder, stdout=False)
        self.assertRegex(written, COLOUR)
        _, written = run_on_terminal(["plan", "none.yaml"], self.folder, stderr=False)
        self.assertEqual(written, b"")

    def test_verdicts_in_green_and_red(self):
        _, written = run_on_terminal(["plan", TASK], self.folder)
        self.assertIn(b"\x1b[1;32msolved\x1b[0m", written)
        self.assertIn(b"\x1b[1;32mpassed\x1b[0m", written)
        problem = (self.folder / "problems/task_c_wrist_singularity.yaml").read_text()
        problem = problem.replace("xyz: [1.1, 0, 0.845]", "xyz: [3.1, 0, 0.845]", 1)
        (self.folder / "problems/far.yaml").write_text(problem)
        status, written = run_on_terminal(["plan", "problems/far.yaml"], self.folder)
        self.assertEqual(status, 1, written)
        self.assertRegex(written, rb"\x1b\[1;31minfeasible\x1b\[0m")

    def test_files_have_no_escape_codes(self):
        for name, arguments in COMMANDS.items():
            run_on_terminal([*arguments, "--color", "always"], self.folder)
        written = [file for file in pathlib.Path(self.folder).rglob("*")
                   if file.is_file() and file.suffix in (".csv", ".json", ".html", ".yaml")]
        self.assertGreater(len(written), 20)
        for file in written:
            self.assertNotRegex(file.read_bytes(), ESCAPE, file)

    def test_colours_change_nothing_else(self):
        for name in ("check", "info", "help"):
            _, plain, _ = run(COMMANDS[name], self.folder)
            _, coloured, _ = run([*COMMANDS[name], "--color", "always"], self.folder)
            self.assertEqual(COLOUR.sub(b"", coloured), plain, name)


if __name__ == "__main__":
    unittest.main()
