// SPDX-License-Identifier: GPL-3.0-or-later
// The one clock of the page: replay and load history follow it.

/** Time between two pictures for readers who wish for less motion [s]. */
const kStill = 0.5;

const stepped = (time: number): number =>
  matchMedia("(prefers-reduced-motion: reduce)").matches ? kStill * Math.floor(time / kStill) : time;

export class Player {
  time = 0;
  playing = false;
  speed = 1;
  /** Where playing has come to; `time` may follow in steps. */
  private reached = 0;
  private listeners: (() => void)[] = [];
  private last = 0;

  constructor(public duration: number) {}

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  seek(time: number): void {
    this.time = this.reached = Math.min(this.duration, Math.max(0, time));
    this.notify();
  }

  setSpeed(speed: number): void {
    this.speed = speed;
    this.notify();
  }

  toggle(): void {
    if (this.playing) return this.pause();
    if (this.time >= this.duration) this.time = 0;
    this.playing = true;
    this.reached = this.time;
    this.last = performance.now();
    requestAnimationFrame(this.tick);
    this.notify();
  }

  pause(): void {
    this.playing = false;
    this.notify();
  }

  private tick = (now: number): void => {
    if (!this.playing) return;
    const before = this.time;
    this.reached += (this.speed * (now - this.last)) / 1000;
    this.last = now;
    if (this.reached >= this.duration) {
      this.time = this.duration;
      this.playing = false;
    } else {
      this.time = stepped(this.reached);
      requestAnimationFrame(this.tick);
    }
    if (this.time !== before || !this.playing) this.notify();
  };

  private notify(): void {
    for (const listener of this.listeners) listener();
  }
}
