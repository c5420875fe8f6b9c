// One plot over time, with limits, the weld's time span and the time that is shown.
import uPlot from 'uplot';
import { element, style } from './dom.js';
import { shown } from './units.js';

const kHeight = 118;  // pixels
const kNearLimit = 0.4;  // share of a limit from which on it is in view
const sync = uPlot.sync('time');
const plots = [];
let isZooming = false;
let allLimitsInView = false;

/**
 * @param options {title, lines: [{label, x, y, colour, width, dash, points}], limits: [number],
 *   nearLimit: share of a limit from which on it is in view, least: [low, high] always in view, most: cap of the view, weld: [from, to], value: t => text, wide, limitText}
 */
export class Plot {
  constructor(options, clock) {
    this.options = options;
    this.clock = clock;
    this.readout = element('span', { class: options.wide ? 'value wide' : 'value' });
    this.place = element('div');
    this.box = element(
      'div', { class: 'plot', role: 'group', 'aria-label': options.title },
      element('div', { class: 'caption' }, element('span', { class: 'what' }, options.title),
        element('span', { class: 'limit' }, options.limitText ?? ''), this.readout),
      this.place);
    plots.push(this);
  }

  /** To be called when the box is on the page. */
  start() {
    this.width = this.box.clientWidth;
    this.plot = new uPlot(this.#uplotOptions(), this.#table(), this.place);
    this.line = element('div', { class: 'time' });
    this.plot.over.append(this.line);
    this.#listenToClicks();
    if (!this.observer) {
      this.observer = new ResizeObserver(() => this.#resize());
      this.observer.observe(this.box);
    }
    this.showTime(this.clock.time);
  }

  setLines(lines) {
    this.options.lines = lines;
    this.plot.destroy();
    this.start();
  }

  showTime(t) {
    if (!this.plot) return;
    const x = this.plot.valToPos(t, 'x');
    this.line.style.transform = `translateX(${x}px)`;
    this.line.hidden = !(x >= 0 && x <= this.plot.over.clientWidth);
    if (!this.isHovered()) this.readout.replaceChildren(...[this.options.value(t)].flat());
  }

  isHovered() {
    return (this.plot?.cursor.left ?? -1) >= 0;
  }

  #table() {
    return uPlot.join(this.options.lines.map(({ x, y }) => [x, y]));
  }

  #resize() {
    const width = this.box.clientWidth;
    if (width === this.width || width === 0) return;
    this.width = width;
    this.plot.setSize({ width, height: kHeight });
    this.showTime(this.clock.time);
  }

  #uplotOptions() {
    const axis = { stroke: () => style('--quiet'), grid: { stroke: () => style('--rule'), width: 0.5 },
      ticks: { stroke: () => style('--rule'), size: 3 }, font: '11px system-ui, sans-serif' };
    return {
      width: this.width, height: kHeight, legend: { show: false }, pxAlign: 0, padding: [6, 16, 0, 0],
      cursor: { sync: { key: sync.key, setSeries: false }, y: false, points: { show: false }, drag: { x: true, y: false, dist: 5 } },
      scales: {
        x: { time: false, range: (_, low, high) => (low === high ? [low - 1, high + 1] : [low, high]) },
        y: { range: (plot, low, high) => this.#range(low, high) },
      },
      axes: [
        { ...axis, size: 22, gap: 2, space: 50, values: (_, values) => values.map((v, i) => (i === values.length - 1 ? `${shown(v)} s` : shown(v))) },
        { ...axis, size: 52, gap: 3, space: 24, values: (_, values) => values.map((v) => shown(v, 3)) },
      ],
      series: [{}, ...this.options.lines.map((line) => ({
        label: line.label, stroke: () => line.colour ?? style(line.style), width: line.width ?? 1.25, dash: line.dash,
        spanGaps: !line.gaps, points: { show: line.points ?? false, size: 3, fill: () => line.colour ?? style(line.style) },
      }))],
      hooks: {
        drawClear: [(plot) => this.#shadeRuns(plot)],
        draw: [(plot) => this.#drawLimits(plot)],
        setCursor: [() => this.#hover()],
        setScale: [(plot, key) => key === 'x' && this.#zoomAll(plot)],
      },
    };
  }

  #range(low, high) {
    const { limits = [], least, most } = this.options;
    let [from, to] = [low ?? 0, high ?? 0];
    if (least) [from, to] = [Math.min(from, least[0]), Math.max(to, least[1])];
    const near = this.options.nearLimit ?? kNearLimit;
    for (const limit of limits.filter((each) => each !== null)) {
      if (allLimitsInView || (limit > 0 && to > near * limit)) to = Math.max(to, limit);
      if (allLimitsInView || (limit < 0 && from < near * limit)) from = Math.min(from, limit);
    }
    if (most !== undefined) to = Math.min(to, most);
    const room = 0.06 * (to - from) || Math.max(1e-6, 0.05 * Math.abs(to));
    return [from - room, to + room];
  }

  #drawLimits(plot) {
    const { ctx } = plot;
    const { left, top, width, height } = plot.bbox;
    ctx.save();
    ctx.strokeStyle = style('--limit');
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash([5 * devicePixelRatio, 3 * devicePixelRatio]);
    for (const limit of this.options.limits ?? []) {
      if (limit === null) continue;
      const y = plot.valToPos(limit, 'y', true);
      if (y < top || y > top + height) continue;
      ctx.beginPath();
      ctx.moveTo(left, y);
      ctx.lineTo(left + width, y);
      ctx.stroke();
    }
    ctx.restore();
  }

  /** Where it does not weld. */
  #shadeRuns(plot) {
    const [from, to] = this.options.weld;
    const { ctx } = plot;
    const { left, top, width, height } = plot.bbox;
    const at = (t) => Math.min(Math.max(plot.valToPos(t, 'x', true), left), left + width);
    ctx.save();
    ctx.fillStyle = style('--run');
    ctx.fillRect(left, top, at(from) - left, height);
    ctx.fillRect(at(to), top, left + width - at(to), height);
    ctx.restore();
  }

  #hover() {
    const t = this.isHovered() ? this.plot.posToVal(this.plot.cursor.left, 'x') : this.clock.time;
    this.readout.replaceChildren(...[this.options.value(t)].flat());
  }

  #zoomAll(origin) {
    if (isZooming) return;
    isZooming = true;
    const { min, max } = origin.scales.x;
    for (const { plot } of plots) if (plot && plot !== origin) plot.setScale('x', { min, max });
    isZooming = false;
    for (const plot of plots) plot.showTime(this.clock.time);
  }

  #listenToClicks() {
    let pressed = 0;
    this.plot.over.addEventListener('mousedown', (event) => (pressed = event.clientX));
    this.plot.over.addEventListener('click', (event) => {
      if (Math.abs(event.clientX - pressed) > 4) return;
      const { left } = this.plot.over.getBoundingClientRect();
      this.clock.seek(this.plot.posToVal(event.clientX - left, 'x'));
    });
  }
}

/** All limits, however far away; or those that the motion comes near. */
export function setLimitsInView(all) {
  allLimitsInView = all;
  for (const { plot } of plots) plot?.setScale('x', { min: plot.scales.x.min, max: plot.scales.x.max });
}

export function redrawPlots() {
  for (const { plot } of plots) plot?.redraw(false, false);
}
