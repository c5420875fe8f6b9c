"""The progress bar: on a terminal only, on stderr only, never wider than it, gone in the end."""

import re
import signal
import unittest

from program import CLEAR_LINE, ProgramTest, run, run_on_terminal, screen

FRAME = re.compile(r"^(?P<stage>.*?) *(?:\[(?P<bar>[#-]+)\])?(?: +(?P<percent>\d+) %)?"
                   r"(?:  (?P<time>\d+:\d\d))?(?:, about (?P<left>[\d:]+) left)?$")


def frames(written):
    """What the bar showed, one after another; after the last time it was cleared come the results."""
    parts = written.decode().split(CLEAR_LINE.decode())[1:-1]
    return [FRAME.match(part) for part in parts if part]


class ProgressBar(ProgramTest):
    def setUp(self):
        super().setUp()
        # A seam that takes seconds in both stages.
        text = (self.folder / "problems/seven_axis_t_joint.yaml").read_text()
        text += "refine: {smoothing_time: 0.4}\n"
        (self.folder / "problems/slow.yaml").write_text(text)
        self.slow = ["plan", "problems/slow.yaml", "--threads", "1", "--no-report"]

    def test_shows_stage_share_and_time_and_is_gone_in_the_end(self):
        status, written = run_on_terminal(self.slow, self.folder)
        self.assertEqual(status, 0, written)
        shown = frames(written)
        self.assertGreater(len(shown), 10)
        stages = [frame["stage"] for frame in shown]
        for stage in ("sampling", "search", "refine round"):
            self.assertTrue(any(name.startswith(stage) for name in stages), stages)
        self.assertTrue(any(frame["bar"] for frame in shown))
        for line in screen(written):
            self.assertNotRegex(line, r"^(read|sampling|search|refine|verify) .*\d:\d\d$")
            self.assertNotIn("[#", line)

    def test_never_goes_back_within_a_stage(self):
        _, written = run_on_terminal(self.slow, self.folder)
        stage, percent, seconds = "", 0, 0
        for frame in frames(written):
            name = frame["stage"].split(" ")[0]
            if name != stage:
                stage, percent = name, 0
            self.assertGreaterEqual(int(frame["percent"] or 0), percent)
            percent = int(frame["percent"] or 0)
            if frame["time"]:
                minutes, rest = map(int, frame["time"].split(":"))
                self.assertGreaterEqual(60 * minutes + rest, seconds)
                seconds = 60 * minutes + rest

    def test_fits_the_terminal(self):
        for columns in (20, 40, 200):
            _, written = run_on_terminal(self.slow, self.folder, columns=columns)
            self.assertTrue(frames(written))
            for frame in frames(written):
                self.assertLess(len(frame[0]), columns)

    def test_follows_a_terminal_that_is_resized(self):
        _, written = run_on_terminal(self.slow, self.folder, columns=100, resize=(1.0, 30))
        widths = [len(frame[0]) for frame in frames(written)]
        self.assertGreater(max(widths), 30)
        self.assertLess(widths[-1], 30)

    def test_on_stderr_only(self):
        _, written = run_on_terminal(self.slow, self.folder, stderr=False)
        self.assertNotIn(CLEAR_LINE, written)
        _, written = run_on_terminal(self.slow, self.folder, stdout=False)
        self.assertIn(CLEAR_LINE, written)
        self.assertEqual(screen(written), [""])

    def test_not_where_nobody_sees_it(self):
        _, out, err = run(self.slow, self.folder)
        self.assertNotIn(b"\r", out + err)
        _, written = run_on_terminal([*self.slow, "--quiet"], self.folder)
        self.assertNotIn(CLEAR_LINE, written)
        _, written = run_on_terminal(self.slow, self.folder, TERM="dumb")
        self.assertNotIn(CLEAR_LINE, written)

    def test_leaves_nothing_behind_on_ctrl_c(self):
        status, written = run_on_terminal(self.slow, self.folder, stdout=False,
                                          signals=[(0.7, signal.SIGINT)])
        self.assertEqual(status, 130)
        self.assertIn(CLEAR_LINE, written)
        self.assertEqual(screen(written), [""])

    def test_leaves_nothing_behind_when_ended_at_once(self):
        status, written = run_on_terminal(self.slow, self.folder, stdout=False,
                                          signals=[(0.7, signal.SIGINT), (0.701, signal.SIGINT)])
        self.assertIn(status, (-signal.SIGINT, 130))
        self.assertEqual(screen(written), [""])

    def test_leaves_nothing_behind_on_an_error(self):
        text = (self.folder / "problems/slow.yaml").read_text()
        (self.folder / "problems/bad.yaml").write_text(text.replace("speed:", "sped:", 1))
        status, written = run_on_terminal(["plan", "problems/bad.yaml"], self.folder, stdout=False)
        self.assertEqual(status, 2)
        lines = screen(written)
        self.assertEqual(len(lines), 2, lines)
        self.assertTrue(lines[0].startswith("wristwise: "), lines)


if __name__ == "__main__":
    unittest.main()
