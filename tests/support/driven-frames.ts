import type { Page } from "playwright/test";
import type { RoomDriver } from "./room-driver.ts";

export interface Drive {
  isOn: boolean;
  tiles: number;
  /** Programs that the last frame was the first to draw with, and points that it drew. */
  programs: number;
  points: number;
  tick(milliseconds: number): void;
}

/** Frames come when the test says so, and are told the time that it says. */
export async function driveFrames(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const request = window.requestAnimationFrame.bind(window);
    const cancel = window.cancelAnimationFrame.bind(window);
    const waiting = new Map<number, FrameRequestCallback>();
    let next = 1e6;
    let now = 0;
    const drive = { isOn: false, tiles: 0, programs: 0, points: 0, tick: (_: number) => {} };
    drive.tick = (milliseconds) => {
      now += milliseconds;
      drive.programs = 0;
      drive.points = 0;
      const frames = [...waiting.values()];
      waiting.clear();
      for (const frame of frames) frame(now);
    };
    window.requestAnimationFrame = (callback) => {
      if (!drive.isOn) return request(callback);
      waiting.set(++next, callback);
      return next;
    };
    window.cancelAnimationFrame = (id) => {
      if (!waiting.delete(id)) cancel(id);
    };
    // Each tile is cleared before it is drawn, and nothing else is of its size.
    const { clear, viewport } = WebGL2RenderingContext.prototype;
    let isTile = false;
    WebGL2RenderingContext.prototype.viewport = function (x, y, width, height) {
      isTile = x === 0 && y === 0 && width === 64 && height === 64;
      viewport.call(this, x, y, width, height);
    };
    WebGL2RenderingContext.prototype.clear = function (mask) {
      if (isTile) drive.tiles++;
      clear.call(this, mask);
    };
    const used = new Set<WebGLProgram | null>();
    const { drawArrays, useProgram } = WebGL2RenderingContext.prototype;
    let program: WebGLProgram | null = null;
    WebGL2RenderingContext.prototype.useProgram = function (next) {
      program = next;
      useProgram.call(this, next);
    };
    WebGL2RenderingContext.prototype.drawArrays = function (mode, first, count) {
      if (!used.has(program)) drive.programs++;
      used.add(program);
      if (mode === this.POINTS) drive.points += count;
      drawArrays.call(this, mode, first, count);
    };
    Object.assign(window, { drive });
  });
}

/** Draws frames, each in a task of its own, and tells how many tiles each has drawn. */
export function drawFrames(
  room: RoomDriver,
  count: number,
  milliseconds: number,
): Promise<number[]> {
  return room.evaluate(
    async (_, { count, milliseconds }) => {
      const drive = Reflect.get(window, "drive") as Drive;
      const tiles: number[] = [];
      for (let frame = 0; frame < count; frame++) {
        const before = drive.tiles;
        drive.tick(milliseconds);
        tiles.push(drive.tiles - before);
        await new Promise((resolve) => setTimeout(resolve));
      }
      return tiles;
    },
    { count, milliseconds },
  );
}

/** The candle on the cabin's table, and where one sees it from. */
export const TABLE = { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 } as const;
export const CAMERA = { position: [-0.85, 1.3, 1.1], yaw: -0.805, pitch: -0.244 } as const;

/** Puts the candle on the table, and plays in driven frames from then on. */
export function playAtTable(room: RoomDriver): Promise<void> {
  return room.evaluate(
    (element, { table, camera }) => {
      element.camera = table;
      element.place();
      element.camera = camera;
      (Reflect.get(window, "drive") as Drive).isOn = true;
      element.play();
    },
    { table: TABLE, camera: CAMERA },
  );
}
