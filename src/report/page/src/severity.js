// How near a motion is to what it must not exceed: 1 at the edge, more beyond.
import { coordinates } from './units.js';

const kMost = 2;

/** At each sample of the motion the worst of tolerance use, joint speed ratio and clearance. */
export function severityOf(motion, robot, required, epsilon) {
  const { time, use, clearance } = motion.samples;
  const worst = [];
  const cause = [];
  time.forEach((t, i) => {
    let most = { value: 0, cause: 'nothing' };
    const consider = (value, what) => {
      if (value !== null && value > most.value) most = { value, cause: what };
    };
    use.forEach((values, k) => consider(values[i], `tolerance ${coordinates[k].name}`));
    robot.joints.forEach((joint, j) => {
      const velocity = motion.value(j, t, 1);
      if (velocity !== null && joint.limits[0] !== null)
        consider(Math.abs(velocity) / joint.limits[0], `speed of ${joint.name}`);
    });
    if (clearance && required !== null)
      consider(
        clearanceUse(clearance.distance[i], required - epsilon),
        `clearance ${clearance.pairs[clearance.pair[i]].join(' - ')}`);
    worst.push(Math.min(most.value, kMost));
    cause.push(most.cause);
  });
  return { worst, cause };
}

function clearanceUse(distance, accepted) {
  if (distance <= 0) return distance < accepted || distance < 0 ? kMost : 1;
  return Math.max(0, accepted) / distance;
}

const stops = [
  [0, [70, 115, 165]],
  [0.5, [120, 160, 160]],
  [0.8, [222, 184, 60]],
  [1, [230, 120, 40]],
];
const beyond = [200, 30, 40];

export const kBeyond = 1.0005;  // uses are given with four decimals

/** Red, green, blue, 0 to 255. */
export function severityColour(value) {
  if (value > kBeyond) return beyond;
  for (let i = 1; i < stops.length; ++i) {
    const [to, colour] = stops[i];
    const [from, before] = stops[i - 1];
    if (value <= to) return colour.map((c, k) => before[k] + ((c - before[k]) * (value - from)) / (to - from));
  }
  return stops.at(-1)[1];
}

export const css = (colour) => `rgb(${colour.map(Math.round).join(' ')})`;

/** The scale, as a picture. */
export function severityLegend(box) {
  const scale = document.createElement('span');
  scale.className = 'scale';
  scale.style.background = `linear-gradient(90deg, ${stops.map(([at, c]) => `${css(c)} ${at * 100}%`).join(', ')})`;
  const over = document.createElement('span');
  over.className = 'over';
  over.style.background = css(beyond);
  box.append('seam: worst of tolerance, joint speed, clearance   0', scale, '1 (the limit)', over, 'beyond');
}
