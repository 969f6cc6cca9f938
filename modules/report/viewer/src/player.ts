// SPDX-License-Identifier: GPL-3.0-or-later
// The one clock of the page: replay and load history follow it.

export class Player {
  time = 0;
  playing = false;
  speed = 1;
  private listeners: (() => void)[] = [];
  private last = 0;

  constructor(readonly duration: number) {}

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  seek(time: number): void {
    this.time = Math.min(this.duration, Math.max(0, time));
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
    this.time += (this.speed * (now - this.last)) / 1000;
    this.last = now;
    if (this.time >= this.duration) {
      this.time = this.duration;
      this.playing = false;
    } else {
      requestAnimationFrame(this.tick);
    }
    this.notify();
  };

  private notify(): void {
    for (const listener of this.listeners) listener();
  }
}
