// SPDX-License-Identifier: GPL-3.0-or-later
// A film of the replay: its pictures one after another, with the time written on them. A slow machine takes longer and
// makes the same film.
import { ArrayBufferTarget, Muxer } from "webm-muxer";
import { css, el } from "./dom";
import { seconds } from "./format";
import type { Player } from "./player";
import { save } from "./save";

const kFramesPerSecond = 30;
const kSecond = 1e6;  // of the encoder's clock
const kBitrate = 8e6;

/** Whether this browser encodes films. */
export const canFilm = (): boolean => typeof VideoEncoder !== "undefined";

export class Film {
  private readonly picture: HTMLCanvasElement;
  private readonly target = new ArrayBufferTarget();
  private readonly muxer: Muxer<ArrayBufferTarget>;
  private readonly encoder: VideoEncoder;
  private stopped = false;

  /** @param draw brings the canvases up to the player's time. */
  constructor(
    private readonly player: Player,
    private readonly canvases: HTMLCanvasElement[],
    private readonly draw: () => void,
  ) {
    const even = (n: number) => n - (n % 2);  // as codecs want it
    const width = even(canvases.reduce((sum, canvas) => sum + canvas.width, 0));
    const height = even(Math.max(...canvases.map((canvas) => canvas.height)));
    this.picture = el("canvas", { width, height });
    this.muxer = new Muxer({ target: this.target, video: { codec: "V_VP8", width, height, frameRate: kFramesPerSecond } });
    this.encoder = new VideoEncoder({
      output: (chunk, meta) => this.muxer.addVideoChunk(chunk, meta),
      error: () => this.stop(),
    });
    this.encoder.configure({ codec: "vp8", width, height, bitrate: kBitrate, framerate: kFramesPerSecond, latencyMode: "realtime" });
  }

  /** The run from its start, at the player's speed. */
  async record(): Promise<Blob> {
    this.player.pause();
    const step = this.player.speed / kFramesPerSecond;
    const n = Math.ceil(this.player.duration / step);
    for (let i = 0; i <= n && !this.stopped; ++i) {
      this.player.seek(i * step);
      this.take();
      const frame = new VideoFrame(this.picture, { timestamp: (i * kSecond) / kFramesPerSecond, duration: kSecond / kFramesPerSecond });
      this.encoder.encode(frame, { keyFrame: i % kFramesPerSecond === 0 });
      frame.close();
      // Buttons stay alive, and the encoder's queue short.
      do await new Promise((done) => setTimeout(done)); while (this.encoder.encodeQueueSize > 4);
    }
    await this.encoder.flush();
    this.muxer.finalize();
    return new Blob([this.target.buffer], { type: "video/webm" });
  }

  /** Ends the film where it is. */
  stop(): void {
    this.stopped = true;
  }

  private take(): void {
    this.draw();
    // In memory: an encoder reads every picture back.
    const context = this.picture.getContext("2d", { willReadFrequently: true })!;
    let x = 0;
    for (const canvas of this.canvases) {
      context.drawImage(canvas, x, 0);
      x += canvas.width;
    }
    const size = Math.max(14, this.picture.height / 26);
    context.font = `${size}px sans-serif`;
    context.textAlign = "right";
    context.fillStyle = css("--ink");
    context.fillText(`${seconds(this.player.time)} s`, this.picture.width - size, 1.5 * size);
  }
}

export const saveFilm = (name: string) => (film: Blob): void => save(`${name}.webm`, film);
