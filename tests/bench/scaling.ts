import { stateless } from "./controls/stateless.js";
import { transformFeedback } from "./controls/transform-feedback.js";
import { type Cell, HEIGHT, WIDTH } from "./law.js";
import { ours } from "./ours.js";
import type { Peer } from "./peer.js";
import { median } from "./statistics.js";

/** The first is ours, the second what it is held against. */
const PEERS = [ours, transformFeedback, stateless] as const;

export interface PeerResult {
  readonly name: string;
  /** Update, draw and wait. */
  readonly frameMs: number;
  /** Median over the rounds of this peer's time to the transform feedback control's. */
  readonly ratio: number;
  /** Update and draw, not waited for: time of the main thread. */
  readonly scriptMs: number;
  /** The same in the best round: a busy machine can only add to it. */
  readonly bestScriptMs: number;
  /** Share of the picture's pixels that any particle touches. */
  readonly covered: number;
  /** Mean light of the picture, to that of the transform feedback control. */
  readonly brightness: number;
}

export interface Scaling extends Cell {
  readonly rounds: number;
  readonly peers: readonly PeerResult[];
}

/** How often a cell is measured: each peer in turn draws `frames`, in each of the rounds. */
export interface Effort {
  readonly rounds: number;
  readonly frames: number;
}

/** Time of one frame, and of the main thread's part of it. */
interface Timing {
  readonly frameMs: number;
  readonly scriptMs: number;
}

declare global {
  interface WebGL2RenderingContext {
    // Of WebGL's specification, and not yet in TypeScript's.
    drawingBufferStorage(format: GLenum, width: number, height: number): void;
  }
}

/** Frames after which the browser has compiled our script for good. */
const WARM_UP = 300;

/** Frame times of ours and of both controls, interleaved: A B C, B C A, C A B, … */
export function measureScaling(cell: Cell, { rounds, frames }: Effort): Scaling {
  warmUp();
  const color = meanColor();
  const peers = PEERS.map((create) => create(canvas(), cell));
  const covered = peers.map((peer) => pictureOf(peer).covered);
  const brightness = brightnessOf(cell, color);
  for (const peer of peers) peer.glow = [0.2, 0.2, 0.2];
  const turns = peers.map((): Timing[] => []);
  for (let round = 0; round < rounds; round++) {
    for (let turn = 0; turn < peers.length; turn++) {
      const i = (round + turn) % peers.length;
      turns[i]!.push(takeTurn(peers[i]!, frames));
    }
  }
  for (const peer of peers) peer.dispose();
  const control = turns[1]!;
  return {
    ...cell,
    rounds,
    peers: peers.map(({ name }, i) => ({
      name,
      frameMs: median(turns[i]!.map(({ frameMs }) => frameMs)),
      ratio: median(turns[i]!.map(({ frameMs }, round) => frameMs / control[round]!.frameMs)),
      scriptMs: median(turns[i]!.map(({ scriptMs }) => scriptMs)),
      bestScriptMs: Math.min(...turns[i]!.map(({ scriptMs }) => scriptMs)),
      covered: covered[i]!,
      brightness: brightness[i]! / brightness[1]!,
    })),
  };
}

function canvas(): HTMLCanvasElement {
  return Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT });
}

// The first frame after another peer's finds the caches full of that peer's particles.
function takeTurn(peer: Peer, frames: number): Timing {
  timeFrame(peer);
  const timings = Array.from({ length: frames }, () => timeFrame(peer));
  return {
    frameMs: median(timings.map(({ frameMs }) => frameMs)),
    scriptMs: median(timings.map(({ scriptMs }) => scriptMs)),
  };
}

const pixel = new Uint8Array(4);

function timeFrame(peer: Peer): Timing {
  const { gl } = peer;
  const begin = performance.now();
  peer.frame();
  const submitted = performance.now();
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  return { scriptMs: submitted - begin, frameMs: performance.now() - begin };
}

function warmUp(): void {
  for (const create of PEERS) {
    const peer = create(canvas(), { count: 800, pixels: 2 });
    for (let i = 0; i < WARM_UP; i++) timeFrame(peer);
    peer.dispose();
  }
}

/** So little light that a million particles do not saturate. */
const FAINT = [1e-3, 1e-3, 1e-3] as const;

/**
 * One colour that is as bright as all of ours, for the controls.
 *
 * With it the light of a picture tells how many sprites of which size it has.
 */
function meanColor(): readonly [number, number, number] {
  const cell: Cell = { count: 10_000, pixels: 15 };
  const [mine, control] = [ours, stateless].map((create) => {
    const peer = create(canvas(), cell);
    peer.glow = FAINT;
    const { brightness } = pictureOf(peer);
    peer.dispose();
    return brightness;
  });
  const faint = (FAINT[0] * mine!) / control!;
  return [faint, faint, faint];
}

/** Beyond so many, sums in half floats are too large to feel one sprite more. */
const MOST_SUMMED = 100_000;

/** Light of each peer's picture of the same cell, or of a cell as large as half floats can sum. */
function brightnessOf({ count, pixels }: Cell, color: readonly [number, number, number]): number[] {
  return PEERS.map((create, i) => {
    const peer = create(canvas(), { count: Math.min(count, MOST_SUMMED), pixels });
    peer.glow = i === 0 ? FAINT : color;
    const { brightness } = pictureOf(peer);
    peer.dispose();
    return brightness;
  });
}

/** What a frame shows, in linear floats. */
function pictureOf(peer: Peer): { covered: number; brightness: number } {
  const { gl } = peer;
  gl.getExtension("EXT_color_buffer_half_float");
  gl.drawingBufferStorage(gl.RGBA16F, WIDTH, HEIGHT);
  peer.frame();
  const pixels = new Float32Array(WIDTH * HEIGHT * 4);
  gl.readPixels(0, 0, WIDTH, HEIGHT, gl.RGBA, gl.FLOAT, pixels);
  gl.drawingBufferStorage(gl.RGBA8, WIDTH, HEIGHT);
  let covered = 0;
  let brightness = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    const light = pixels[i]! + pixels[i + 1]! + pixels[i + 2]!;
    if (light > 0) covered++;
    brightness += light;
  }
  const count = WIDTH * HEIGHT;
  return { covered: covered / count, brightness: brightness / count };
}
