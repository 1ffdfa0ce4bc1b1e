import { beforeEach, describe, expect, test, vi } from "vitest";
import { createCanvasTarget } from "../../../src/scenes/canvas-target.ts";

let isLost = false;

/** As much of a WebGL context as is asked for before anything is drawn. */
const gl = new Proxy(
  {},
  {
    get: (_, name) => () => {
      if (name === "isContextLost") return isLost;
      return name === "getParameter" && !isLost ? [16] : null;
    },
  },
);

class Canvas extends EventTarget {
  static readonly made: Canvas[] = [];
  /** How often its frame was lost to another size. */
  sizes = 0;
  #width = 1;
  #height = 1;

  getContext(type: string): object {
    return type === "2d" ? { clearRect() {}, drawImage() {} } : gl;
  }
  get width(): number {
    return this.#width;
  }
  set width(value: number) {
    this.sizes++;
    this.#width = value;
  }
  get height(): number {
    return this.#height;
  }
  set height(value: number) {
    this.sizes++;
    this.#height = value;
  }
}

beforeEach(() => {
  isLost = false;
  Canvas.made.length = 0;
  vi.stubGlobal("matchMedia", () => ({ matches: false }));
  vi.stubGlobal("document", {
    createElement: () => {
      const canvas = new Canvas();
      Canvas.made.push(canvas);
      return canvas;
    },
  });
  return () => vi.unstubAllGlobals();
});

function candleOf(width: number, height: number) {
  const canvas = Object.assign(new Canvas(), { width, height });
  return createCanvasTarget("candle", canvas as unknown as HTMLCanvasElement);
}

test("a context that is lost already is reported as lost, and another try has another one", () => {
  isLost = true;
  const room = new Canvas() as unknown as HTMLCanvasElement;
  const lost = expect.objectContaining({ name: "ContextLostError" });
  expect(() => createCanvasTarget("room", room)).toThrow(lost);
  expect(() => candleOf(8, 8)).toThrow(lost);
  isLost = false;
  candleOf(8, 8).dispose();
  expect(Canvas.made.length).toBe(2);
});

describe("the canvas that lone candles share", () => {
  const draw = (frames: number, ...targets: ReturnType<typeof candleOf>[]) => {
    for (let i = 0; i < frames; i++) for (const target of targets) target.prepare();
    const [{ width, height, sizes } = new Canvas()] = Canvas.made;
    return { width, height, sizes };
  };

  test("is as large as the largest that draws, and shrinks when that has gone", () => {
    const [small, wide, high] = [candleOf(10, 20), candleOf(300, 40), candleOf(30, 200)];
    expect(draw(1, small)).toMatchObject({ width: 10, height: 20 });
    expect(draw(1, small, wide, high)).toMatchObject({ width: 300, height: 200 });
    wide.dispose();
    expect(draw(200, small, high)).toMatchObject({ width: 30, height: 200 });
    high.dispose();
    expect(draw(200, small)).toMatchObject({ width: 10, height: 20 });
    small.dispose();
  });

  test("keeps its size while sizes alternate", () => {
    const [small, large] = [candleOf(10, 20), candleOf(300, 400)];
    const { sizes } = draw(1, small, large);
    expect(draw(500, small, large)).toEqual({ width: 300, height: 400, sizes });
    small.dispose();
    large.dispose();
  });
});
