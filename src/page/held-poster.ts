import type { CandleFlameElement } from "../candle-flame-element.js";
import { find } from "./find.js";

/** How long the poster covers the room at most, milliseconds. */
const LONGEST = 10_000;
/** Time between two looks at the room's tier, milliseconds. */
const INTERVAL = 200;
/** Of the flame in every poster: from the middle, in shorter sides. */
const FLAME = { x: 0.247, y: 0.13 } as const;
/** Around the flame the poster begins, and is complete, in shorter sides. */
const HOLE = { begin: 0.05, end: 0.14 } as const;

/**
 * Keeps the poster of the first view around the live flame while `auto` still draws the room at `low`, which is coarse
 * without a GPU: until a higher tier draws it, or the visitor does something.
 */
export function holdPoster(room: CandleFlameElement): void {
  const poster = room.querySelector(".poster");
  const isShown = poster && getComputedStyle(poster).display !== "none";
  if (!isShown || room.quality !== "auto" || room.paused) return;
  const image = find(poster, "img", HTMLImageElement);
  if (image.naturalWidth === 0) return; // not there, or not to be read
  const held = withHole(image);
  room.after(held);
  const done = new AbortController();
  const { signal } = done;
  const end = () => done.abort();
  for (const type of ["keydown", "pointerdown", "hashchange", "resize"]) {
    addEventListener(type, end, { signal });
  }
  for (const type of ["enter", "error", "contextlost"]) {
    room.addEventListener(type, end, { signal });
  }
  const begin = performance.now();
  const timer = setInterval(() => {
    if (room.stats.quality !== "low" || performance.now() - begin > LONGEST) end();
  }, INTERVAL);
  signal.addEventListener("abort", async () => {
    clearInterval(timer);
    held.classList.add("fading");
    await Promise.allSettled(held.getAnimations().map(({ finished }) => finished));
    held.remove();
  });
}

/** A copy that is transparent at the flame: a mask would cost each frame. */
function withHole(image: HTMLImageElement): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.className = "held-poster";
  canvas.width = image.naturalWidth;
  canvas.height = image.naturalHeight;
  const context = canvas.getContext("2d");
  if (!context) return canvas;
  context.drawImage(image, 0, 0);
  const side = Math.min(canvas.width, canvas.height);
  const x = canvas.width / 2 + FLAME.x * side;
  const y = canvas.height / 2 + FLAME.y * side;
  const hole = context.createRadialGradient(x, y, HOLE.begin * side, x, y, HOLE.end * side);
  hole.addColorStop(0, "#000");
  hole.addColorStop(1, "#0000");
  context.globalCompositeOperation = "destination-out";
  context.fillStyle = hole;
  context.fillRect(0, 0, canvas.width, canvas.height);
  return canvas;
}
