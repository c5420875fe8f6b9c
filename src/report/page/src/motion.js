// A motion over time as trajectory.csv gives it: a piecewise quintic through positions, velocities
// and accelerations, or points joined by straight joint-space moves.

const kLeastSamples = 800;

/** Index of the last of the ascending values that is not above x, at least 0. */
export function indexAt(values, x) {
  let low = 0;
  let high = values.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (values[middle] <= x) low = middle;
    else high = middle - 1;
  }
  return low;
}

export class Motion {
  constructor(data) {
    Object.assign(this, data);
    this.times = data.knots.time;
    this.start = this.times[0];
    this.end = this.times.at(-1);
  }

  get jointCount() {
    return this.knots.position.length;
  }

  /** All joints at time t, rad or m; held at the ends outside. */
  posture(t) {
    return this.knots.position.map((_, joint) => this.value(joint, t));
  }

  /** Of one joint, derivative 0 to 3; null where points leave it open. */
  value(joint, t, derivative = 0) {
    if (this.times.length < 2) return derivative === 0 ? this.knots.position[joint][0] : null;
    const held = Math.min(Math.max(t, this.start), this.end);
    if (this.curve) return this.#quintic(joint, this.#piece(held), held, derivative);
    if (derivative === 0) return this.#straight(joint, this.#piece(held), held);
    return nearestValue(this.#differences(joint, derivative), held);
  }

  /** What a plot of it draws: ascending times and their values. */
  series(joint, derivative) {
    if (!this.curve) {
      if (derivative === 0) return [this.times, this.knots.position[joint]];
      return this.#differences(joint, derivative);
    }
    const x = [];
    const y = [];
    const parts = Math.ceil(kLeastSamples / (this.times.length - 1));
    for (let i = 0; i + 1 < this.times.length; ++i) {
      const from = this.times[i];
      const length = this.times[i + 1] - from;
      // The jerk may jump at a knot: both values are drawn.
      const first = derivative === 3 && i > 0 ? 1e-9 : 0;
      const last = derivative === 3 || i + 2 === this.times.length ? parts : parts - 1;
      for (let k = 0; k <= last; ++k) {
        const t = k === 0 ? from + first * length : from + (length * k) / parts;
        x.push(t);
        y.push(this.#quintic(joint, i, t, derivative));
      }
    }
    return [x, y];
  }

  #piece(t) {
    return Math.min(indexAt(this.times, t), this.times.length - 2);
  }

  #straight(joint, i, t) {
    const q = this.knots.position[joint];
    return q[i] + ((q[i + 1] - q[i]) * (t - this.times[i])) / (this.times[i + 1] - this.times[i]);
  }

  #quintic(joint, i, t, derivative) {
    const { position, velocity, acceleration } = this.knots;
    const h = this.times[i + 1] - this.times[i];
    const u = (t - this.times[i]) / h;
    const c = [position[joint][i], velocity[joint][i] * h, (acceleration[joint][i] * h * h) / 2];
    const rest = position[joint][i + 1] - c[0] - c[1] - c[2];
    const slope = velocity[joint][i + 1] * h - c[1] - 2 * c[2];
    const bend = acceleration[joint][i + 1] * h * h - 2 * c[2];
    c.push(10 * rest - 4 * slope + bend / 2, -15 * rest + 7 * slope - bend, 6 * rest - 3 * slope + bend / 2);
    let value = 0;
    for (let k = 5; k >= derivative; --k) {
      let factor = c[k];
      for (let d = 0; d < derivative; ++d) factor *= k - d;
      value = value * u + factor;
    }
    return value / h ** derivative;
  }

  /** Divided differences over uneven times (F12), each at the middle of its points. */
  #differences(joint, order) {
    const key = joint * 4 + order;
    this.cache ??= new Map();
    if (!this.cache.has(key)) {
      let values = this.knots.position[joint];
      for (let k = 1; k <= order; ++k)
        values = values.slice(1).map((v, i) => (k * (v - values[i])) / (this.times[i + k] - this.times[i]));
      const middles = values.map((_, i) => (this.times[i] + this.times[i + order]) / 2);
      this.cache.set(key, [middles, values]);
    }
    return this.cache.get(key);
  }
}

function nearestValue([x, y], t) {
  if (x.length === 0) return null;
  const i = indexAt(x, t);
  return i + 1 < x.length && x[i + 1] - t < t - x[i] ? y[i + 1] : y[i];
}
