import { Clock } from './clock.js';
import { element } from './dom.js';
import { jointPlots } from './jointplots.js';
import { Chain } from './kinematics.js';
import { indexAt, Motion } from './motion.js';
import { nearestIndex, overviewPlots } from './overview.js';
import { redrawPlots, setLimitsInView } from './plot.js';
import { severityLegend, severityOf } from './severity.js';
import { diagnosisBlocks, inputTable, peakTable, statisticsTable, verificationTable, warningList } from './tables.js';
import { coordinates, fixed, shown } from './units.js';
import { View } from './view.js';

const kTimeTolerance = 1e-6;  // s
const kNear = 0.05;  // m, within which the nearest points are joined by a line
const kNearClearances = 10;  // or so many required clearances

const $ = (id) => document.getElementById(id);

const data = JSON.parse($('data').textContent);
const { result } = data;
const motions = (data.motions ?? []).map((each) => new Motion(each));
const severities = motions.map((motion) =>
  severityOf(motion, data.robot, data.clearance, motion.verification.clearance_epsilon_m ?? 0));
const clock = new Clock(
  Math.min(...motions.map((motion) => motion.start), data.seam?.time[0] ?? 0),
  Math.max(...motions.map((motion) => motion.end), motions.length > 0 ? 0 : (data.seam?.time.at(-1) ?? 0)));
let shownMotion = 0;

function fillHeader() {
  document.title = `${data.name || 'wristwise'}: ${result.status}`;
  $('name').textContent = data.name || 'wristwise report';
  $('status').textContent = result.status.toUpperCase();
  $('status').classList.add(result.status === 'solved' ? 'good' : 'bad');
  const facts = [result.mode, `${result.waypoints} waypoints`];
  if (data.robot) facts.push(`${data.robot.name}, ${data.robot.joints.length} joints`);
  if (clock.end > clock.start) facts.push(`${shown(clock.end - clock.start)} s`);
  $('facts').textContent = facts.join('  \u00b7  ');
}

function fillVerdict() {
  $('verdict').append(element('h2', {}, result.diagnosis.length > 0 ? 'Diagnosis' : 'Verification'));
  $('verdict').append(...diagnosisBlocks(result.diagnosis, data.seam, (t) => clock.seek(t)));
  const checked = motions.filter((motion) => motion.verification.run);
  $('verdict').append(checked.length > 0 ? verificationTable(checked, (t) => clock.seek(t))
    : element('p', {}, motions.length > 0 ? 'Not checked: the motion is a part of the way only.' : 'Not checked: there is no motion.'));
  const warnings = warningList(result);
  if (warnings) $('verdict').append(element('h3', {}, 'Warnings'), warnings);
}

function fillNumbers() {
  $('numbers').append(element('h2', {}, 'Numbers'));
  if (data.robot) {
    const results = [{ name: result.mode, peaks: result.peaks }];
    if (result.before) results.push({ name: 'as given', peaks: result.before.peaks });
    if (data.graph_only) results.push({ name: 'graph-only', peaks: data.graph_only.peaks });
    $('numbers').append(peakTable(data.robot, results));
  }
  $('numbers').append(statisticsTable(result), inputTable(data.inputs));
}

function captionOf(title) {
  const [motion, behind] = motions;
  const lines = [element('span', { class: 'swatch', style: 'border-color:var(--accent)' }), motion.name];
  if (behind) lines.push(element('span', { class: 'swatch', style: 'border-color:var(--behind)' }), behind.name);
  lines.push(element('span', { class: 'swatch', style: 'border-color:var(--limit);border-top-style:dashed' }), 'limit');
  if (motion.weld[0] - motion.start > kTimeTolerance || motion.end - motion.weld[1] > kTimeTolerance)
    lines.push(element('span', { class: 'swatch run' }), 'run-in, run-out');
  return element('div', { class: 'bar' }, element('h2', {}, title), element('span', {}, lines));
}

/** All plots; those of the joints can be drawn without what is behind. */
function fillPlots() {
  const page = { motions, data, clock, severities };
  const overview = overviewPlots(page);
  $('overview').append(element('h2', {}, 'Over time'), ...overview.map((plot) => plot.box));
  const joints = jointPlots(page);
  const bar = captionOf('Joints');
  $('joints').append(bar, element('div', { class: 'grid' }, joints.map((plot) => plot.box)));
  const all = [...overview, ...joints];
  for (const plot of all) plot.start();
  if (motions.length > 1) bar.append(behindSwitch(joints));
  bar.append(tick('all limits in view', false, setLimitsInView));
  clock.onChange((t) => all.forEach((plot) => plot.showTime(t)));
  return { overview, joints };
}

function tick(text, isOn, act) {
  const box = element('input', { type: 'checkbox' });
  box.checked = isOn;
  box.addEventListener('change', () => act(box.checked));
  return element('label', {}, box, ` ${text}`);
}

function behindSwitch(joints) {
  const lines = joints.map((plot) => plot.options.lines);
  return tick(`${motions[1].name} behind`, true, (isOn) =>
    joints.forEach((plot, i) => plot.setLines(isOn ? lines[i] : lines[i].slice(-1))));
}

function makeView() {
  try {
    return new View($('view'), data, chain);
  } catch (error) {
    $('view').replaceChildren(element('p', { class: 'message' }, `No 3D picture: ${error.message}`));
    return null;
  }
}

/** Inside the joint limits, where there is no motion. */
function restingPosture() {
  return data.robot.joints.map(({ lower, upper }) => Math.min(Math.max(0, lower ?? 0), upper ?? 0));
}

/** Of the two bodies, [] where they are far from each other. */
function nearestPoints(motion, t) {
  const { time, clearance } = motion.samples;
  if (!clearance) return [];
  const i = nearestIndex(time, t);
  if (clearance.distance[i] > Math.max(kNearClearances * data.clearance, kNear)) return [];
  return clearance.points.slice(6 * i, 6 * i + 6);
}

function place(t) {
  const motion = motions[shownMotion];
  if (view) view.place(motion ? motion.posture(t) : restingPosture(), motion ? nearestPoints(motion, t) : []);
}

/** The measures at one time, in a line under the robot. */
function describe(t) {
  const motion = motions[shownMotion];
  if (!motion) return 'No motion was found; the robot stands at zero.';
  const { samples } = motion;
  const i = nearestIndex(samples.time, t);
  const parts = [`worst ${shown(severities[shownMotion].worst[i], 3)} (${severities[shownMotion].cause[i]})`];
  if (samples.clearance)
    parts.push(`clearance ${shown(samples.clearance.distance[i] * 1e3)} mm ${samples.clearance.pairs[samples.clearance.pair[i]].join(' - ')}`);
  const off = coordinates.map((coordinate, k) => ({ ...coordinate, value: samples.deviation[k][i] }))
    .filter(({ value }) => value !== null)
    .map(({ name, unit, factor, value }) => `${name} ${fixed(value * factor)} ${unit}`);
  if (off.length > 0) parts.push(`off the path frame: ${off.join(', ')}`);
  return parts.join('  \u00b7  ');
}

function connectTransport() {
  const scrub = $('scrub');
  scrub.min = clock.start;
  scrub.max = clock.end;
  scrub.addEventListener('input', () => clock.seek(Number(scrub.value)));
  $('play').addEventListener('click', () => clock.toggle());
  $('speed').addEventListener('change', () => (clock.speed = Number($('speed').value)));
  clock.onChange((t) => {
    scrub.value = t;
    scrub.setAttribute('aria-valuetext', `${t.toFixed(2)} s`);
    $('clock').textContent = `${t.toFixed(3)} / ${clock.end.toFixed(3)} s`;
    $('play').textContent = clock.playing ? 'Pause' : 'Play';
    $('now').textContent = data.robot ? describe(t) : '';
    if (data.robot) place(t);
  });
}

/** To the sample before or after. */
function step(direction) {
  const times = motions[shownMotion]?.samples.time ?? data.seam?.time ?? [0];
  const i = indexAt(times, clock.time + 1e-9);
  const back = direction < 0 && times[i] < clock.time - 1e-9 ? 0 : direction;
  clock.seek(times[Math.min(Math.max(i + back, 0), times.length - 1)]);
}

function connectKeys() {
  const keys = {
    ' ': () => clock.toggle(),
    ArrowRight: (event) => (event.shiftKey ? clock.seek(clock.time + 1) : step(1)),
    ArrowLeft: (event) => (event.shiftKey ? clock.seek(clock.time - 1) : step(-1)),
    Home: () => clock.seek(clock.start),
    End: () => clock.seek(clock.end),
  };
  window.addEventListener('keydown', (event) => {
    const isTaken = event.target.matches?.('select, button, input[type=checkbox]') && event.key === ' ';
    if (!keys[event.key] || isTaken || event.ctrlKey || event.altKey || event.metaKey || event.target.matches?.('select')) return;
    event.preventDefault();
    keys[event.key](event);
  });
}

function connectView() {
  if (!view) return;
  view.onPick = (t) => clock.seek(t);
  for (const button of document.querySelectorAll('#views [data-fit]'))
    button.addEventListener('click', () => view.fit(button.dataset.fit));
  $('follow').addEventListener('change', () => (view.follow = $('follow').checked));
  view.markWaypoints(result.diagnosis.map(({ waypoint }) => waypoint).filter((i) => i !== null && i < data.seam.time.length));
}

function connectShown() {
  $('shown-label').hidden = motions.length < 2;
  motions.forEach((motion, i) => $('shown').append(element('option', { value: i }, motion.name)));
  $('shown').addEventListener('change', () => show(Number($('shown').value)));
}

function show(index) {
  shownMotion = index;
  view?.show(motions[index] ?? null, severities[index]);
  clock.seek(clock.time);
}

function connectScheme() {
  const dark = window.matchMedia('(prefers-color-scheme: dark)');
  const apply = (isDark) => {
    document.documentElement.classList.toggle('dark', isDark);
    view?.recolour();
    redrawPlots();
  };
  apply(dark.matches);
  dark.addEventListener('change', () => apply(dark.matches));
  $('scheme').addEventListener('click', () => apply(!document.documentElement.classList.contains('dark')));
}

const chain = data.robot ? new Chain(data.robot) : null;
document.documentElement.classList.toggle('dark', window.matchMedia('(prefers-color-scheme: dark)').matches);
const view = chain ? makeView() : null;
if (!chain) $('view').append(element('p', { class: 'message' }, 'No robot was read.'));
fillHeader();
fillVerdict();
fillNumbers();
severityLegend($('legend'));
connectTransport();
connectKeys();
connectView();
connectShown();
const plots = motions.length > 0 ? fillPlots() : {};
for (const id of ['overview', 'joints']) $(id).hidden = motions.length === 0;
show(0);
view?.fit('all');
connectScheme();

// For scripts and tests.
window.wristwise = { data, motions, severities, clock, view, plots, chain };
