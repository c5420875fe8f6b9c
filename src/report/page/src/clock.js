/** The time that everything on the page shows. */
export class Clock {
  #listeners = [];
  #last = 0;

  constructor(start, end) {
    Object.assign(this, { start, end, time: start, speed: 1, playing: false });
  }

  onChange(listener) {
    this.#listeners.push(listener);
  }

  seek(time) {
    this.time = Math.min(Math.max(time, this.start), this.end);
    for (const listener of this.#listeners) listener(this.time);
  }

  toggle() {
    this.playing = !this.playing && this.end > this.start;
    if (this.playing) {
      if (this.time >= this.end) this.time = this.start;
      this.#last = performance.now();
      requestAnimationFrame((now) => this.#tick(now));
    }
    this.seek(this.time);
  }

  #tick(now) {
    if (!this.playing) return;
    const passed = Math.max(0, now - this.#last) / 1000;
    this.#last = now;
    if (this.time + passed * this.speed >= this.end) this.playing = false;
    this.seek(this.time + passed * this.speed);
    if (this.playing) requestAnimationFrame((next) => this.#tick(next));
  }
}
