// Over time: the worst of all, the tolerance coordinate by coordinate, the clearance.
import { element } from './dom.js';
import { indexAt } from './motion.js';
import { Plot } from './plot.js';
import { coordinates, fixed, shown } from './units.js';

const kCapOfUse = 2.5;
const kClearancesInView = 10;

const swatch = (colour, dash) => element('span', { class: 'swatch', style: `border-color:${colour};border-top-style:${dash ? 'dashed' : 'solid'}` });

export function overviewPlots({ motions, data, clock, severities }) {
  const [motion, behind] = motions;
  const { samples, weld } = motion;
  const at = (t) => nearestIndex(samples.time, t);
  const plots = [worstPlot(), ...tolerancePlots(), ...clearancePlots()];
  return plots.map((options) => new Plot({ weld, ...options }, clock));

  function ghost(y, gaps = false) {
    return behind ? [{ label: behind.name, x: behind.samples.time, y, style: '--behind', gaps }] : [];
  }

  function worstPlot() {
    const [{ worst, cause }, other] = severities;
    return {
      title: 'Worst of tolerance, joint speed and clearance; 1 is the limit', limits: [1], least: [0, 1], most: kCapOfUse, wide: true,
      lines: [...ghost(other?.worst), { label: motion.name, x: samples.time, y: worst, style: '--ink' }],
      value: (t) => `${shown(worst[at(t)], 3)}  ${cause[at(t)]}` + (other ? `   |   ${behind.name} ${behindValue(other.worst, t)}` : ''),
    };
  }

  function behindValue(values, t) {
    return shown(values[nearestIndex(behind.samples.time, t)], 3);
  }

  function tolerancePlots() {
    const used = coordinates.map((coordinate, k) => ({ ...coordinate, k })).filter(({ k }) => samples.use[k].some((v) => v !== null));
    if (used.length === 0) return [];
    const single = (of) => used.map(({ name, colour, k }) => ({ label: name, x: of.samples.time, y: of.samples.use[k], colour, gaps: true }));
    const plot = (of) => ({
      title: `Tolerance use, ${of.name}; 1 is the edge of the box`, limits: [1], least: [0, 1], most: kCapOfUse, wide: true, lines: single(of), weld: of.weld,
      value: (t) => {
        const i = nearestIndex(of.samples.time, t);
        return used.flatMap(({ name, unit, factor, colour, k }) => [
          swatch(colour), `${name} ${shown(of.samples.use[k][i], 3)} (${signed(of.samples.deviation[k][i], factor)} ${unit})`,
        ]);
      },
    });
    return motions.map(plot);
  }

  function clearancePlots() {
    const { clearance } = samples;
    if (!clearance) return [];
    const millimetres = (of) => of.samples.clearance.distance.map((d) => d * 1e3);
    const required = data.clearance * 1e3;
    const own = millimetres(motion);
    const most = Math.max(kClearancesInView * required, 4 * Math.min(...own), 20);
    return [{
      title: 'Clearance, mm', limits: [required], limitText: `required ${shown(required)} mm`, least: [Math.min(0, required), required], most, wide: true,
      lines: [...(behind?.samples.clearance ? ghost(millimetres(behind)) : []), { label: motion.name, x: samples.time, y: own, style: '--ink' }],
      value: (t) => {
        const i = at(t);
        const other = behind?.samples.clearance ? `   |   ${behind.name} ${behindValue(millimetres(behind), t)} mm` : '';
        return `${shown(own[i])} mm  ${clearance.pairs[clearance.pair[i]].join(' - ')}${other}`;
      },
    }];
  }
}

function signed(value, factor) {
  if (value === null) return '-';
  return fixed(value * factor, true);
}

export function nearestIndex(times, t) {
  const i = indexAt(times, t);
  return i + 1 < times.length && times[i + 1] - t < t - times[i] ? i + 1 : i;
}
