"""report.html in a headless Chromium, as a person uses it.

report_browser_test.py PROGRAM SOURCE_FOLDER; ends with 77 where there is no browser to test with.
"""

import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from urdf_kinematics import tip_position

SKIPPED = 77
PROGRAM, SOURCE = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
URDF = SOURCE / "robots/kuka_kr5_arc/kuka_kr5_arc.urdf"
EVIL = "</script><script>window.broken=1</script><b>plate"

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError:
    print("no selenium: skipped")
    sys.exit(SKIPPED)

BROWSER, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
if not BROWSER or not DRIVER:
    print("no chromium: skipped")
    sys.exit(SKIPPED)


def start_browser(profile):
    options = Options()
    options.binary_location = BROWSER
    for flag in ["headless", "no-sandbox", "disable-quic", "no-first-run", "disable-background-networking",
                 "disable-component-update", "disable-sync", "disable-dev-shm-usage", "use-gl=angle", "use-angle=swiftshader",
                 "enable-unsafe-swiftshader", "window-size=1400,1000", f"user-data-dir={profile}"]:
        options.add_argument("--" + flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(DRIVER), options=options)


def plan(problem, folder, *more):
    """Runs the program; its exit status."""
    return subprocess.run([PROGRAM, *more, problem, "--out", folder, "--quiet"], stdout=subprocess.DEVNULL,
                          timeout=300, check=False).returncode


CRANE = """<robot name="crane">
  <link name="floor"/><link name="bridge"/><link name="post"/><link name="arm"/><link name="hook"/>
  <joint name="drive" type="prismatic"><parent link="floor"/><child link="bridge"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.3 -0.2 0.5"/><axis xyz="0 1 0"/><limit lower="-3" upper="3" velocity="2" effort="1"/></joint>
  <joint name="swing" type="continuous"><parent link="bridge"/><child link="post"/>
    <origin xyz="0 0 1" rpy="0 0.4 0"/><axis xyz="0 0 -1"/><limit velocity="3" effort="1"/></joint>
  <joint name="reach" type="prismatic"><parent link="post"/><child link="arm"/>
    <origin xyz="0.2 0 0"/><axis xyz="1 0 0"/><limit lower="0" upper="2" velocity="2" effort="1"/></joint>
  <joint name="end" type="fixed"><parent link="arm"/><child link="hook"/><origin xyz="0.1 0 -0.2"/></joint>
</robot>"""


class Rows:
    """trajectory.csv"""

    def __init__(self, folder):
        with open(folder / "trajectory.csv", encoding="utf-8") as file:
            self.rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        self.joints = json.loads((folder / "result.json").read_text())["joints"]

    def tcp(self, row):
        return tip_position(URDF, "base_link", "torch_tip", row)


def joint_limits():
    """Velocity, acceleration and jerk by joint, of the file that task C names."""
    text = (SOURCE / "robots/kuka_kr5_arc/joint_limits.yaml").read_text()
    return {joint: [float(re.search(f"max_{kind}: *([0-9.e+-]+)", rest)[1]) for kind in ("velocity", "acceleration", "jerk")]
            for joint, rest in re.findall(r"^  (\w+):((?:\n    .*)*)", text, re.MULTILINE)}


class ReportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="wristwise_report_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.browser = start_browser(cls.folder / "profile")
        cls.addClassCleanup(cls.browser.quit)
        assert plan(SOURCE / "problems/task_c_wrist_singularity.yaml", cls.folder / "c", "plan") == 0
        cls.c = Rows(cls.folder / "c")
        cls.c_result = json.loads((cls.folder / "c/result.json").read_text())

    def js(self, script, *values):
        return self.browser.execute_script(script, *values)

    def write_problem(self, name, old_part, new_part):
        """Task C, changed."""
        problem = (SOURCE / "problems/task_c_wrist_singularity.yaml").read_text().split("placement:")[0]
        self.assertIn(old_part, problem)
        problem = problem.replace("../robots", str(SOURCE / "robots")).replace(old_part, new_part)
        (self.folder / name).write_text(problem)

    def open(self, name):
        """Loads a report afresh: without complaints, and without anything from elsewhere."""
        self.browser.get(f"file://{self.folder / name / 'report.html'}")
        errors = [entry["message"] for entry in self.browser.get_log("browser")
                  if entry["level"] in ("SEVERE", "WARNING")]
        # Without a graphics card reading pixels back is slow, of which Chromium warns.
        self.assertEqual([error for error in errors if "GPU stall" not in error], [])
        self.assertEqual(self.js("return performance.getEntriesByType('resource').length"), 0)

    def open_c(self):
        """The report of task C at its start; as it is where it is open already."""
        if not self.browser.current_url.endswith("/c/report.html"):
            self.open("c")
        self.js("window.scrollTo(0, 0); wristwise.clock.playing = false; wristwise.clock.seek(wristwise.clock.start)")

    def tcp(self):
        return self.js("return wristwise.view.tcpPoint")

    def assert_near(self, found, expected, tolerance):
        self.assertEqual(len(found), len(expected))
        for a, b in zip(found, expected):
            self.assertAlmostEqual(a, b, delta=tolerance)

    def test_is_small_and_shows_the_robot(self):
        self.assertLess((self.folder / "c/report.html").stat().st_size, 2e6)
        self.open("c")
        colours = self.js("""
            wristwise.view.draw();
            const gl = wristwise.view.renderer.getContext();
            const [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
            const pixels = new Uint8Array(w * h * 4);
            gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
            const count = new Map();
            for (let i = 0; i < pixels.length; i += 4) {
              const key = pixels.slice(i, i + 3).join();
              count.set(key, (count.get(key) ?? 0) + 1);
            }
            return {kinds: count.size, commonest: Math.max(...count.values()) / (w * h)};""")
        self.assertGreater(colours["kinds"], 50)
        self.assertLess(colours["commonest"], 0.95)

    def test_scrubbing_moves_the_robot_along_the_trajectory(self):
        self.open_c()
        for row in self.c.rows[::7]:
            self.js("""
                const scrub = document.getElementById('scrub');
                scrub.value = arguments[0];
                scrub.dispatchEvent(new Event('input'));""", row["time"])
            self.assert_near(self.tcp(), self.c.tcp(row), 1e-6)

    def test_plots_hold_the_rows_and_the_limits(self):
        self.open_c()
        plots = self.js("""return wristwise.plots.joints.map((plot) =>
            ({joint: plot.options.joint, derivative: plot.options.derivative, limits: plot.options.limits,
              x: plot.plot.data[0], y: plot.plot.data.at(-1)}))""")
        self.assertEqual(len(plots), 4 * len(self.c.joints))
        for plot in plots:
            if plot["derivative"] == 3:
                continue
            name = self.c.joints[plot["joint"]] + ["", "_velocity", "_acceleration"][plot["derivative"]]
            drawn = {round(x, 6): y for x, y in zip(plot["x"], plot["y"]) if y is not None}
            for row in self.c.rows:
                self.assertAlmostEqual(drawn[round(row["time"], 6)], row[name], delta=1e-8, msg=name)
        limits = joint_limits()
        for plot in plots:
            if plot["derivative"] > 0:
                largest = limits[self.c.joints[plot["joint"]]][plot["derivative"] - 1]
                self.assertEqual(plot["limits"], [-largest, largest])

    def test_the_worst_is_the_largest_of_the_three(self):
        self.open_c()
        times, worst, use, clearance, required, colours = self.js("""
            const {samples, verification} = wristwise.motions[0];
            return [samples.time, wristwise.severities[0].worst, samples.use, samples.clearance.distance,
                    wristwise.data.clearance - verification.clearance_epsilon_m,
                    [...wristwise.view.seam.geometry.attributes.instanceColorStart.array]];""")
        limits = joint_limits()
        for row in self.c.rows:
            i = min(range(len(times)), key=lambda k: abs(times[k] - row["time"]))
            speed = max(abs(row[joint + "_velocity"]) / limits[joint][0] for joint in self.c.joints)
            tolerance = max(values[i] for values in use if values[i] is not None)
            self.assertAlmostEqual(worst[i], max(speed, tolerance, required / clearance[i]), delta=1e-6)
        # From orange at the ends, where the spin is at its limit, to blue in the middle.
        red, blue = colours[0], colours[2]
        middle = 6 * (len(times) // 2)
        self.assertGreater(red, 2 * blue)
        self.assertGreater(colours[middle + 2], colours[middle])

    def test_jerk_is_the_slope_of_the_acceleration(self):
        self.open_c()
        x, y = self.js("return wristwise.motions[0].series(3, 3)")
        times, name = [row["time"] for row in self.c.rows], self.c.joints[3] + "_acceleration"
        for i in range(len(times) - 1):
            inside = [(t, j) for t, j in zip(x, y) if times[i] <= t <= times[i + 1] + 1e-12]
            gained = sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(inside, inside[1:]))
            self.assertAlmostEqual(gained, self.c.rows[i + 1][name] - self.c.rows[i][name],
                                   delta=1e-7 + 0.01 * max(abs(j) for _, j in inside))

    def test_clearance_and_tables_are_those_of_the_result(self):
        self.open_c()
        check = self.c_result["verification"]
        least = min(self.js("return wristwise.motions[0].samples.clearance.distance"))
        self.assertAlmostEqual(least, check["clearance_m"], delta=1e-4)
        text = self.browser.find_element(By.ID, "verdict").text
        self.assertIn("passed", text)
        self.assertIn(f"{check['clearance_m'] * 1e3:.4g} mm", text)
        numbers = self.browser.find_element(By.ID, "numbers").text
        for joint, peaks in self.c_result["peaks"].items():
            line = next(line for line in numbers.splitlines() if line.startswith(joint))
            shown = [float(word) for word in line.split()[1:]]
            expected = [peaks["velocity"], peaks["acceleration"], peaks["jerk"]]
            for a, b in zip(shown, expected):
                self.assertAlmostEqual(a, b, delta=0.006 * abs(b))
        sums = subprocess.run(["sha256sum", SOURCE / "problems/task_c_wrist_singularity.yaml", URDF,
                               SOURCE / "robots/kuka_kr5_arc/joint_limits.yaml"],
                              capture_output=True, text=True, check=True).stdout
        for line in sums.splitlines():
            self.assertIn(line.split()[0], numbers)

    def test_a_click_in_a_plot_takes_the_robot_there(self):
        self.open_c()
        over = self.browser.find_element(By.CSS_SELECTOR, "#joints .grid .plot:nth-child(2) .u-over")
        self.js("arguments[0].scrollIntoView({block: 'center'})", over)
        before = self.tcp()
        ActionChains(self.browser).move_to_element_with_offset(over, over.size["width"] // 4, 0).click().perform()
        start, end = self.c.rows[0]["time"], self.c.rows[-1]["time"]
        time = self.js("return wristwise.clock.time")
        self.assertAlmostEqual((time - start) / (end - start), 0.75, delta=0.01)
        after = self.tcp()
        later = next(i for i, row in enumerate(self.c.rows) if row["time"] >= time)
        a, b = self.c.rows[later - 1], self.c.rows[later]
        share = (time - a["time"]) / (b["time"] - a["time"])
        between = [(1 - share) * p + share * q for p, q in zip(self.c.tcp(a), self.c.tcp(b))]
        self.assert_near(after, between, 1e-4)
        self.assertGreater(max(abs(p - q) for p, q in zip(before, after)), 0.05)

    def test_keys_step_and_play(self):
        self.open_c()
        body = self.browser.find_element(By.TAG_NAME, "body")
        samples = self.js("return wristwise.motions[0].samples.time")
        body.send_keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_LEFT)
        self.assertAlmostEqual(self.js("return wristwise.clock.time"), samples[1], delta=1e-9)
        body.send_keys(Keys.END)
        self.assertAlmostEqual(self.js("return wristwise.clock.time"), samples[-1], delta=1e-9)
        body.send_keys(Keys.HOME, Keys.SPACE)
        self.assertTrue(self.js("return wristwise.clock.playing"))
        moved = self.browser.execute_async_script(
            "const done = arguments[0]; setTimeout(() => done(wristwise.clock.time), 700)")
        self.assertGreater(moved, samples[0])
        body.send_keys(Keys.SPACE)
        self.assertFalse(self.js("return wristwise.clock.playing"))

    def test_without_a_solution_says_why(self):
        self.write_problem("far.yaml", "to: {xyz: [0, 0.18, 0]", "to: {xyz: [0, 1.5, 0]")
        self.assertEqual(plan(self.folder / "far.yaml", self.folder / "far", "plan"), 1)
        self.open("far")
        diagnosis = json.loads((self.folder / "far/result.json").read_text())["diagnosis"][0]
        text = self.browser.find_element(By.ID, "verdict").text
        self.assertIn(diagnosis["detail"], text)
        self.browser.find_element(By.CSS_SELECTOR, ".diagnosis button").click()
        time = self.js("return wristwise.data.seam.time[arguments[0]]", diagnosis["waypoint"])
        self.assertAlmostEqual(self.js("return wristwise.clock.time"),
                               min(time, self.js("return wristwise.clock.end")), delta=1e-9)

    def test_names_are_texts(self):
        self.write_problem("evil.yaml", "name: foot", f'name: "{EVIL}"')
        self.assertEqual(plan(self.folder / "evil.yaml", self.folder / "evil", "plan", "--mode", "graph-only"), 0)
        self.open("evil")
        self.assertIsNone(self.js("return window.broken"))
        self.assertIn(EVIL, self.browser.find_element(By.ID, "verdict").text)

    def test_slides_and_robots_without_shapes(self):
        urdf, joints = self.folder / "crane.urdf", self.folder / "joints.csv"
        urdf.write_text(CRANE)
        joints.write_text("time,drive,swing,reach\n" + "".join(
            f"{t / 10},{math.sin(t / 20)},{t / 15},{1 + 0.5 * math.cos(t / 25) + 1e-4 * (t % 2)}\n" for t in range(60)))
        self.assertEqual(subprocess.run(
            [PROGRAM, "smooth", "--urdf", urdf, "--tip", "hook", "--joints", joints, "--keep", "1mm,1deg",
             "--out", self.folder / "crane", "--quiet"], stdout=subprocess.DEVNULL, timeout=300, check=False).returncode, 0)
        self.open("crane")
        rows = Rows(self.folder / "crane")
        for row in rows.rows[::9]:
            self.js("wristwise.clock.seek(arguments[0])", row["time"])
            self.assert_near(self.tcp(), tip_position(urdf, "floor", "hook", row), 1e-6)
        self.assertTrue(self.js("return wristwise.view.bones.visible"))
        # Where another link stands still, as beside a positioner, the picture does not move with the chain's first.
        placed = self.js("""
            const {chain, view, clock, motions} = wristwise;
            const pose = chain.standing.pose.clone().makeTranslation(1, 2, 3);
            chain.standing = {joint: 1, pose};
            clock.seek(3);
            const {frames} = chain.at(motions[0].posture(3));
            return view.world.matrix.clone().multiply(frames[1]).multiply(pose).elements;""")
        self.assert_near(placed, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], 1e-9)
        self.assertIn("no limit", self.browser.find_element(By.ID, "joints").text)
        self.assertIn("m/s\u00b2", self.browser.find_element(By.ID, "joints").text)

    def test_comparison_has_both(self):
        self.assertEqual(plan(SOURCE / "problems/task_c_wrist_singularity.yaml", self.folder / "both", "compare"), 0)
        self.open("both")
        self.assertEqual(self.js("return wristwise.motions.map((motion) => motion.name)"), ["two-stage", "graph-only"])
        graph_only = Rows(self.folder / "both/graph-only")
        self.js("const choice = document.getElementById('shown'); choice.value = 1;"
                "choice.dispatchEvent(new Event('change'));")
        for row in graph_only.rows[::16]:
            self.js("wristwise.clock.seek(arguments[0])", row["time"])
            self.assert_near(self.tcp(), graph_only.tcp(row), 1e-6)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
