// What was found, in words and numbers.
import { element } from './dom.js';
import { degree, shown } from './units.js';

const kMostActive = 12;

const row = (name, cells) => element('tr', {}, element('th', { scope: 'row' }, name), cells);
const cell = (text, tone) => element('td', { class: tone }, text ?? '-');
const number = (text) => element('td', { class: 'number' }, text);
const heading = (names) => element('thead', {}, element('tr', {}, names.map((name) => element('th', { scope: 'col' }, name))));
const table = (names, rows) => element('div', { class: 'scroll' }, element('table', {}, heading(names), element('tbody', {}, rows)));
const millimetres = (metres) => (metres === null ? '-' : `${shown(metres * 1e3)} mm`);
const degrees = (radians) => (radians === null ? '-' : `${shown(radians / degree)} deg`);

function list(lines, tone) {
  return lines.length === 0 ? null : element('ul', { class: `lines ${tone}` }, lines.map((line) => element('li', {}, line)));
}

/** The largest of a position's and of an angle's coordinates. */
function excess(coordinates) {
  const { x, y, z, rx, ry, rz } = coordinates;
  return `${millimetres(Math.max(x, y, z))}, ${degrees(Math.max(rx, ry, rz))}`;
}

function toneOf(check, bad) {
  return check.run && bad ? 'bad' : undefined;
}

function ratioCell(check, name) {
  const ratio = check[`${name}_ratio`];
  const joint = check[`${name}_joint`];
  const text = ratio === null ? '-' : `${shown(ratio)}${joint ? ` (${joint})` : ''}`;
  return cell(text, toneOf(check, ratio > 1 + 1e-9 && (name === 'velocity' || check.curve)));
}

function clearanceCell(check, seek) {
  if (check.clearance_m === null) return cell(check.run ? 'no pair counts' : '-');
  const [a, b] = check.clearance_pair;
  return element(
    'td', {}, `${millimetres(check.clearance_m)} of ${millimetres(check.clearance_required_m)}, ${a} - ${b}, `,
    timeLink(check.clearance_time_s, seek));
}

export function timeLink(time, seek, text = `${shown(time)} s`) {
  return element('button', { type: 'button', class: 'link', onclick: () => seek(time) }, text);
}

function certificateCell(check) {
  if (!check.run) return cell('-');
  const { tolerance_shown: tolerance, shown: clearance, clearance_m: bound } = check.certificate;
  const parts = [tolerance ? 'tolerance shown' : 'tolerance not shown'];
  if (clearance !== null) parts.push(clearance ? `clearance at least ${millimetres(bound)}` : 'clearance not shown');
  return cell(parts.join(', '), check.curve && (!tolerance || clearance === false) ? 'bad' : undefined);
}

/** The verification of each motion, side by side. */
export function verificationTable(motions, seek) {
  const checks = motions.map((motion) => motion.verification);
  const line = (name, make) => row(name, checks.map(make));
  const outcome = (check) => (check.run ? (check.passed ? cell('passed', 'good') : cell('FAILED', 'bad')) : cell('not checked'));
  return element('div', {}, table(['verification', ...motions.map((motion) => motion.name)], [
    line('check', outcome),
    line('taken as', (check) => cell(check.run ? (check.curve ? 'a curve' : 'points, straight moves') : '-')),
    line('beyond the tolerance at waypoints', (check) => cell(check.run ? excess(check.tolerance_excess) : '-')),
    line('beyond it, widened, between', (check) => cell(check.run ? excess(check.tolerance_excess_between) : '-')),
    line('path error, for all t at most', (check) => cell(check.run ? `${millimetres(check.certificate.path_error_m)}, ${degrees(check.certificate.path_error_rad)}` : '-')),
    line('beyond joint limits', (check) => cell(shown(check.joint_limit_excess), toneOf(check, check.joint_limit_excess > 1e-9))),
    line('least clearance', (check) => clearanceCell(check, seek)),
    line('for all t', certificateCell),
    line('joint speed / limit', (check) => ratioCell(check, 'velocity')),
    line('acceleration / limit', (check) => ratioCell(check, 'acceleration')),
    line('jerk / limit', (check) => ratioCell(check, 'jerk')),
  ]), motions.map((motion) => remarks(motion, motions.length > 1)));
}

function remarks({ name, verification }, isNamed) {
  const { failures, warnings } = verification;
  if (failures.length + warnings.length === 0) return null;
  return [isNamed ? element('h3', {}, name) : null, list(failures, 'bad'), list(warnings, 'warn')];
}

export function diagnosisBlocks(diagnosis, waypoints, seek) {
  return diagnosis.map(({ waypoint, reason, detail, suggestion }) => {
    const time = waypoint === null ? undefined : waypoints?.time[waypoint];
    const where = time === undefined ? null : [' at ', timeLink(time, seek, `waypoint ${waypoint}, ${shown(time)} s`)];
    return element('div', { class: 'diagnosis' }, element('p', {}, element('strong', {}, reason), where),
      element('p', {}, detail), suggestion ? element('p', {}, `What would help: ${suggestion}`) : null);
  });
}

export function warningList(result) {
  return list(result.warnings, 'warn');
}

/** Peaks as in result.json: by divided differences at the waypoints. */
export function peakTable(robot, results) {
  const kinds = ['velocity', 'acceleration', 'jerk'];
  const names = kinds.flatMap((kind) => results.map(({ name }) => `${kind}${results.length > 1 ? `, ${name}` : ''}`));
  const rows = robot.joints.map((joint) => row(joint.name, kinds.flatMap((kind) =>
    results.map(({ peaks }) => number(shown(peaks[joint.name]?.[kind]))))));
  return element('div', {}, element('h3', {}, 'Peaks at the waypoints, per s, s\u00b2, s\u00b3 (divided differences)'), table(['joint', ...names], rows));
}

export function statisticsTable(result) {
  const { graph, refine, timing_s: timing } = result;
  const rows = [
    row('inverse kinematics', cell(result.inverse_kinematics || '-')),
    result.mode === 'smooth' ? null : row('graph', cell(`${shown(graph.vertices)} vertices, ${shown(graph.edges)} edges, cost ${shown(graph.cost)}`)),
    row('refinement', cell(`${refine.termination}, objective ${shown(refine.objective)}, ${refine.iterations} iterations`)),
    row('time', cell(Object.entries(timing).map(([stage, seconds]) => `${stage} ${shown(seconds, 3)} s`).join(', '))),
    row('contacts left out', cell(result.permanent_contacts.map((pair) => pair.join(' - ')).join('; ') || 'none')),
  ];
  const active = refine.active.slice(0, kMostActive).map(({ sentence }) => sentence);
  if (refine.active.length > kMostActive) active.push(`and ${refine.active.length - kMostActive} more, in result.json`);
  return element('div', {}, element('h3', {}, 'Run'), table([], rows),
    active.length > 0 ? [element('h3', {}, 'What the motion presses against'), list(active, '')] : null);
}

export function inputTable(inputs) {
  const rows = inputs.map(({ name, bytes, sha256 }) =>
    element('tr', {}, element('td', { class: 'path' }, name), number(String(bytes)), element('td', { class: 'hash' }, sha256)));
  return element('div', {}, element('h3', {}, 'Inputs'), table(['file', 'bytes', 'SHA-256'], rows));
}
