import type { Camera, CandleFlameElement } from "../../src/candle-flame-element.ts";
import type { Case, ElementCase, PageCase } from "./cases.ts";
import type { Pair } from "./drivers/find.ts";
import type { Served } from "./drivers/serve.ts";
import { HungError, type Visitor } from "./drivers/visitor.ts";

/** Seconds to the first frame after which it is taken never to come: what a busy machine takes is no fault. */
export const READY = 120;

/** Seconds that all elements of a page may take, one after the other; each has `READY`. */
const ALL_READY = 6 * READY;

/** Seconds that the frames of a look may take: at ultra, without a GPU, on a busy machine. */
const SLOW = 150;

/** Blocks of the radiance that are compared, across and down. */
export const BLOCKS = { across: 16, down: 9 } as const;

/** A picture and the light that it shows. */
export interface Sight {
  readonly png: Buffer;
  /** Mean radiance of each block, linear RGB, rows from the top. */
  readonly blocks: readonly (readonly number[])[];
}

/** What a pair made of a case. */
export interface Finding {
  readonly name: string;
  /** Seconds from the address to the first frame with all assets. */
  readonly ready: number | null;
  readonly complaints: readonly string[];
  /** Why the case did not come to its end. */
  readonly failure: string | null;
  readonly sight: Sight | null;
}

export interface Survey {
  readonly pair: Pair;
  readonly version: string;
  readonly renderer: string;
  readonly findings: readonly Finding[];
}

/** What a call rejects with when the browser's process has ended: WebKit's driver may say no more than that. */
const ENDED = /closed|crash|disconnected|fetch failed|invalid session id|unknown error: *$/i;
/** So often something is tried in browsers that end by themselves: one that we make crash crashes each time. */
const ATTEMPTS = 3;

/** A pair's browser, launched anew where it hung or ended. */
export class Session {
  readonly pair: Pair;
  #visitor: Promise<Visitor> | null = null;

  constructor(pair: Pair) {
    this.pair = pair;
  }

  get visitor(): Promise<Visitor> {
    this.#visitor ??= this.pair.launch();
    return this.#visitor;
  }

  /**
   * Does something with the visitor. The browser of one that hung is no more used; where one ended by itself, as
   * WebKit's was seen to, within the software driver, it is done again in another.
   */
  async use<Result>(run: (visitor: Visitor) => Promise<Result>, attempt = 1): Promise<Result> {
    const visitor = await this.visitor;
    try {
      return await run(visitor);
    } catch (error) {
      const hasEnded = !(error instanceof HungError) && ENDED.test(`${error}`);
      if (hasEnded || error instanceof HungError) {
        this.#visitor = null;
        await visitor.close();
      }
      if (!hasEnded || attempt === ATTEMPTS) throw error;
      console.log(`${this.pair.name}: the browser ended by itself (${error}); again`);
      return this.use(run, attempt + 1);
    }
  }

  async close(): Promise<void> {
    const visitor = await this.#visitor?.catch(() => null); // it may not have come up
    await visitor?.close();
    this.#visitor = null;
  }
}

/** Looks at one case after the other. */
export async function survey(
  session: Session,
  cases: readonly Case[],
  served: Served,
  tell: (finding: Finding) => void,
): Promise<Finding[]> {
  const findings: Finding[] = [];
  for (const one of cases) {
    const finding = await look(session, one, served);
    tell(finding);
    findings.push(finding);
  }
  return findings;
}

async function look(session: Session, one: Case, served: Served): Promise<Finding> {
  const { name } = one;
  let ready: number | null = null;
  let complaints: readonly string[] = [];
  try {
    return await session.use(async (visitor) => {
      try {
        await visitor.open(addressOf(one, served));
        ready = await visitor.evaluate(becomeReady, [READY], ALL_READY);
        const sight = await (one.kind === "element" ? see(visitor, one) : seePage(visitor));
        complaints = await visitor.complaints();
        return { name, ready, complaints, failure: null, sight };
      } catch (error) {
        complaints = error instanceof HungError ? visitor.reported : await visitor.complaints();
        throw error;
      }
    });
  } catch (error) {
    const failure = error instanceof Error ? error.message : String(error);
    return { name, ready, complaints, failure, sight: null };
  }
}

/** Where the element's case is: `caseMarkup` knows what stands there. */
function addressOf(one: ElementCase | PageCase, { page, library }: Served): string {
  if (one.kind === "page") return page + one.path;
  const [width, height] = one.box;
  const style = `width: ${width}px; height: ${height}px; aspect-ratio: auto`;
  return `${library}case.html?${new URLSearchParams({ ...one.attributes, paused: "", style })}`;
}

/** In the page: its renderer's name is no software's, for which half of a moving frame's pixels are kept. */
function seemGpu(): void {
  const { getParameter } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.getParameter = function (name: number) {
    const value: unknown = getParameter.call(this, name);
    return typeof value === "string" && /swiftshader|llvmpipe/i.test(value) ? "A GPU" : value;
  };
}

/** The page of an element's case: its attributes are the address's. */
export function caseMarkup({ pathname, searchParams }: URL): string | null {
  if (pathname !== "/case.html") return null;
  const attributes = [...searchParams].map(([name, value]) => `${name}="${value}"`).join(" ");
  const isAlone = searchParams.get("scene") === "candle";
  const script = searchParams.has("data-gpu") ? `<script>(${seemGpu})()</script>` : "";
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>case</title>
    <link rel="icon" href="data:,">${script}
    <style>body { margin: 0; background: ${isAlone ? "#fff" : "#000"} }</style></head>
    <body><candle-flame ${attributes}></candle-flame>
    <script type="module" src="/define.js"></script></body></html>`;
}

/** In the page: waits for every candle's first frame, one after the other; seconds until the first one's. */
async function becomeReady(limit: number): Promise<number> {
  await customElements.whenDefined("candle-flame");
  let first = Number.NaN;
  const elements = [...document.querySelectorAll<CandleFlameElement>("candle-flame")];
  const places = elements.map(({ parentElement }) => parentElement);
  for (const [i, element] of elements.entries()) {
    // Some are fetched when they come near, and taken out of the page when they are far.
    places[i]?.scrollIntoView({ block: "nearest", behavior: "instant" });
    let timer: ReturnType<typeof setTimeout> | undefined;
    const late = new Promise<never>((_, reject) => {
      timer = setTimeout(() => reject(new Error(`not ready within ${limit} s`)), limit * 1000);
    });
    const isBack = async () => {
      while (!element.isConnected) await new Promise((resolve) => setTimeout(resolve, 20));
      return element.ready;
    };
    await Promise.race([isBack(), late]);
    clearTimeout(timer);
    if (Number.isNaN(first)) first = performance.now() / 1000;
  }
  return first;
}

async function see(visitor: Visitor, one: ElementCase): Promise<Sight> {
  const { camera, place, steps, stride } = one;
  const request = { camera, place, steps, stride, ...BLOCKS };
  const { png, blocks } = await visitor.evaluate(takeSight, [request], SLOW);
  return { png: Buffer.from(png, "base64"), blocks };
}

async function seePage(visitor: Visitor): Promise<Sight> {
  const { png } = await visitor.evaluate(takeSight, [{ steps: [], across: 0, down: 0 }]);
  return { png: Buffer.from(png, "base64"), blocks: [] };
}

interface SightRequest {
  readonly camera?: Camera | undefined;
  readonly place?: Camera | undefined;
  readonly steps: readonly number[];
  readonly stride?: ElementCase["stride"];
  readonly across: number;
  readonly down: number;
}

/** In the page: stands where the case says, steps, and reads the picture and its light. */
async function takeSight({ camera, place, steps, stride, across, down }: SightRequest) {
  const element = document.querySelector<CandleFlameElement>("candle-flame");
  if (!element) throw new Error("There is no candle.");
  if (place) {
    element.camera = place;
    element.place();
    if (element.held) throw new Error("The candle cannot be put down.");
  }
  if (camera) element.camera = camera;
  if (stride) element.play();
  for (const seconds of steps) {
    if (stride) {
      const position = element.camera.position.map((x, axis) => x + stride[axis]!);
      element.camera = { ...element.camera, position: position as [number, number, number] };
    }
    element.step(seconds);
  }
  // Before the loop draws a frame at rest.
  const moving = stride && element.shadowRoot?.querySelector("canvas")?.toDataURL();
  const { width, height } = element.stats;
  const [w, h] = [Math.floor(width / across), Math.floor(height / down)];
  const blocks: number[][] = [];
  const radiance = across > 0 ? element.readRadiance(0, 0, w * across, h * down) : [];
  for (let i = 0; i < across * down; i++) {
    const sum = [0, 0, 0];
    const [left, top] = [(i % across) * w, Math.floor(i / across) * h];
    for (let y = top; y < top + h; y++) {
      for (let x = left; x < left + w; x++) {
        for (let c = 0; c < 3; c++) {
          sum[c] = (sum[c] ?? 0) + (radiance[(y * w * across + x) * 3 + c] ?? 0) / (w * h);
        }
      }
    }
    blocks.push(sum);
  }
  if (moving) {
    element.pause();
    return { png: moving.slice(moving.indexOf(",") + 1), blocks };
  }
  const bytes = new Uint8Array(await (await element.toBlob()).arrayBuffer());
  const png = btoa(bytes.reduce((text, byte) => text + String.fromCharCode(byte), ""));
  return { png, blocks };
}
