// Position, velocity, acceleration and jerk of each joint, with limits.
import { Plot } from './plot.js';
import { shown, unitOf } from './units.js';

const names = ['position', 'velocity', 'acceleration', 'jerk'];

export function jointPlots({ motions, data, clock }) {
  const [motion, behind] = motions;
  return data.robot.joints.flatMap((joint, j) => names.map((name, derivative) => {
    const limits = derivative === 0 ? [joint.lower, joint.upper] : symmetric(joint.limits[derivative - 1]);
    const line = (of, colour) => {
      const [x, y] = of.series(j, derivative);
      return { label: of.name, x, y, style: colour, points: !of.curve && x.length < 200 };
    };
    const main = line(motion, '--accent');
    const options = {
      title: `${joint.name} ${name}, ${unitOf(joint, derivative)}`, limits, weld: motion.weld, joint: j, derivative,
      nearLimit: derivative === 0 ? 0.9 : undefined, wide: true,
      limitText: limitText(limits, derivative, main.y),
      lines: [...(behind ? [line(behind, '--behind')] : []), main],
      value: (t) => {
        const own = shown(motion.value(j, t, derivative));
        return behind ? `${own}   |   ${behind.name} ${shown(behind.value(j, t, derivative))}` : own;
      },
    };
    return new Plot(options, clock);
  }));
}

const symmetric = (limit) => (limit === null ? [] : [-limit, limit]);

function limitText(limits, derivative, values) {
  if (limits.length === 0 || limits.some((limit) => limit === null)) return 'no limit';
  if (derivative === 0) return `limits ${shown(limits[0])} to ${shown(limits[1])}`;
  const peak = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return `limit ${shown(limits[1])}, ${share(peak / limits[1])} used`;
}

const share = (ratio) => (ratio < 1e-4 ? 'below 0.01%' : `${shown(100 * ratio, 2)}%`);
