// Fault injection: whatever fails, wherever, ends in an event, a rejected promise, a sentence and the poster.
import type { Page } from "playwright/test";
import { QUICK_ROOM } from "../support/plain-room.ts";
import { LIBRARY } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

const PIXEL = "data:image/gif;base64,R0lGODlhAQABAIAAAP///wAAACH5BAEAAAAALAAAAAABAAEAAAICRAEAOw==";

/** A call of WebGL that fails from some moment on. */
type Fault =
  | "compile"
  | "link"
  | "texture"
  | "memory"
  | "framebuffer"
  | "draw"
  | "buffer"
  | "program";

/** When the fault begins: before the element is there, or once its first frame is shown. */
type Moment = "first" | "later";

interface Outcome {
  readonly type: string;
  readonly isSentence: boolean;
  readonly ready: "resolved" | "rejected";
  readonly isPosterShown: boolean;
  readonly states: readonly string[];
  readonly hasCanvas: boolean;
}

/** Replaces methods of WebGL by ones that fail while `globalThis.fault` names them. */
async function installFaults(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const faulty = (name: Fault) => Reflect.get(globalThis, "fault") === name;
    const gl = WebGL2RenderingContext.prototype;
    const {
      shaderSource,
      getProgramParameter,
      createTexture,
      getError,
      checkFramebufferStatus,
      createBuffer,
      createProgram,
    } = gl;
    gl.shaderSource = function (shader, source) {
      shaderSource.call(this, shader, faulty("compile") ? `${source}surplus;` : source);
    };
    gl.getProgramParameter = function (program, name) {
      const isAsked = name === this.LINK_STATUS && faulty("link");
      return isAsked ? false : getProgramParameter.call(this, program, name);
    };
    gl.createTexture = function () {
      return faulty("texture") ? (null as unknown as WebGLTexture) : createTexture.call(this);
    };
    gl.createBuffer = function () {
      return faulty("buffer") ? (null as unknown as WebGLBuffer) : createBuffer.call(this);
    };
    gl.createProgram = function () {
      return faulty("program") ? (null as unknown as WebGLProgram) : createProgram.call(this);
    };
    gl.getError = function () {
      return faulty("memory") ? this.OUT_OF_MEMORY : getError.call(this);
    };
    gl.checkFramebufferStatus = function (target) {
      if (faulty("framebuffer")) return this.FRAMEBUFFER_UNSUPPORTED;
      return checkFramebufferStatus.call(this, target);
    };
    // No pixel is looked at.
    gl.drawArrays = gl.drawElements = () => {
      if (faulty("draw")) throw new TypeError("injected");
    };
  });
}

/** Complaints that nobody caught; what the element itself says on the console is none. */
function uncaughtOf(page: Page): readonly string[] {
  const uncaught: string[] = [];
  page.on("pageerror", (error) => uncaught.push(String(error)));
  return uncaught;
}

/** Attributes of the element, and how it is made to meet the fault once it is shown. */
interface Case {
  readonly fault: Fault | null;
  readonly moment: Moment;
  readonly type: string;
  readonly attributes?: Readonly<Record<string, string>>;
  readonly trigger?: "step" | "play" | "resize" | "quality" | "look" | "restore" | "radiance";
}

async function outcomeOf(page: Page, given: Case): Promise<Outcome> {
  return page.evaluate(
    async ({ fault, moment, attributes = {}, trigger = "step", poster }) => {
      const element = document.createElement("candle-flame");
      const all = { look: "paper", quality: "low", paused: "", poster, ...attributes };
      for (const [name, value] of Object.entries(all)) element.setAttribute(name, value);
      element.style.cssText = "width: 64px; height: 36px; aspect-ratio: auto";
      const failed = new Promise<{ type: string; message: string }>((resolve) =>
        element.addEventListener("error", ({ detail }) => resolve(detail), { once: true }),
      );
      if (moment === "first") Object.assign(globalThis, { fault });
      document.body.append(element);
      const { ready } = element;
      if (moment === "later") {
        await ready;
        Object.assign(globalThis, { fault });
        const canvas = element.shadowRoot?.querySelector("canvas");
        const actions = {
          step: () => element.step(0.1),
          play: () => element.play(),
          resize: () => {
            element.style.width = "96px";
          },
          quality: () => {
            element.quality = "medium";
          },
          look: () => {
            element.look = "original";
          },
          radiance: () => element.readRadiance(0, 0, 1, 1),
          restore: () => {
            const loss = canvas?.getContext("webgl2")?.getExtension("WEBGL_lose_context");
            element.addEventListener("contextlost", () => setTimeout(() => loss?.restoreContext()));
            loss?.loseContext();
          },
        };
        actions[trigger]();
      }
      const { type, message } = await failed;
      Object.assign(globalThis, { fault: null });
      const settled = await ready.then(
        () => "resolved" as const,
        () => "rejected" as const,
      );
      const part = (name: string) => element.shadowRoot?.querySelector(`[part~=${name}]`);
      const failure = part("error");
      // Beside it there may be a button.
      const shown = failure?.checkVisibility() ? failure.querySelector("p")?.textContent : "";
      const outcome = {
        type,
        isSentence: shown === message && message.length > 10,
        ready: settled,
        isPosterShown: part("poster")?.checkVisibility() ?? false,
        states: ["loading", "playing", "walking", "lit"].filter((state) =>
          element.matches(`:state(${state})`),
        ),
        hasCanvas: part("canvas") !== null,
      };
      element.remove();
      return outcome;
    },
    { ...given, poster: PIXEL },
  );
}

const outcome = (type: string, ready: Outcome["ready"]): Outcome => ({
  type,
  isSentence: true,
  ready,
  isPosterShown: true,
  states: [],
  hasCanvas: false,
});

const candle = { scene: "candle" };
const physical = { look: "physical", src: "quick-room.glb" };
const FIRST: readonly Case[] = [
  { fault: null, moment: "first", type: "asset", attributes: { src: "missing.glb" } },
  { fault: null, moment: "first", type: "asset", attributes: { src: "define.js" } },
  { fault: "compile", moment: "first", type: "shader" },
  { fault: "link", moment: "first", type: "shader" },
  { fault: "program", moment: "first", type: "graphics" },
  { fault: "texture", moment: "first", type: "graphics" },
  { fault: "buffer", moment: "first", type: "graphics" },
  { fault: "memory", moment: "first", type: "graphics" },
  { fault: "framebuffer", moment: "first", type: "graphics" },
  { fault: "draw", moment: "first", type: "graphics" },
  { fault: "compile", moment: "first", type: "shader", attributes: candle },
  { fault: "framebuffer", moment: "first", type: "graphics", attributes: candle },
  { fault: "draw", moment: "first", type: "graphics", attributes: candle },
  { fault: "framebuffer", moment: "first", type: "graphics", attributes: physical },
  { fault: "draw", moment: "first", type: "graphics", attributes: physical },
];
const LATER: readonly Case[] = [
  { fault: "draw", moment: "later", type: "graphics", trigger: "step" },
  { fault: "draw", moment: "later", type: "graphics", trigger: "play" },
  { fault: "framebuffer", moment: "later", type: "graphics", trigger: "resize" },
  { fault: "memory", moment: "later", type: "graphics", trigger: "resize" },
  { fault: "compile", moment: "later", type: "shader", trigger: "quality" },
  { fault: "texture", moment: "later", type: "graphics", trigger: "quality" },
  { fault: "draw", moment: "later", type: "graphics", trigger: "look" },
  { fault: "draw", moment: "later", type: "graphics", trigger: "restore" },
  { fault: "texture", moment: "later", type: "graphics", trigger: "restore" },
  { fault: "draw", moment: "later", type: "graphics", trigger: "play", attributes: candle },
];

const titleOf = ({ fault, type, attributes, trigger }: Case) =>
  [fault ?? "file", JSON.stringify(attributes ?? {}), trigger, `is reported as ${type}`]
    .filter(Boolean)
    .join(" ");

test.describe("Whatever fails is reported", () => {
  let page: Page;
  let uncaught: readonly string[];
  test.beforeAll(async ({ browser }) => {
    page = await browser.newPage();
    await installFaults(page);
    await serveSmallTextures(page);
    uncaught = uncaughtOf(page);
    await page.route(`${LIBRARY}faults.html`, (route) =>
      route.fulfill({
        contentType: "text/html",
        body: '<!doctype html><title>faults</title><script type="module" src="/define.js"></script>',
      }),
    );
    await page.route(`${LIBRARY}quick-room.glb`, (route) =>
      route.fulfill({ contentType: "model/gltf-binary", body: QUICK_ROOM }),
    );
    await page.goto(`${LIBRARY}faults.html`);
    await page.evaluate(() => customElements.whenDefined("candle-flame"));
  });
  test.afterAll(() => page.close());

  for (const given of FIRST) {
    test(`before the first frame: ${titleOf(given)}`, async () => {
      expect(await outcomeOf(page, given)).toEqual(outcome(given.type, "rejected"));
      expect(uncaught).toEqual([]);
    });
  }
  for (const given of LATER) {
    test(`after it: ${titleOf(given)}`, async () => {
      expect(await outcomeOf(page, given)).toEqual(outcome(given.type, "resolved"));
      expect(uncaught).toEqual([]);
    });
  }

  test("after what the driver refuses, another quality begins anew, and the same does not", async () => {
    const shown = await page.evaluate(async () => {
      const element = document.createElement("candle-flame");
      Object.assign(element, { look: "paper", quality: "medium", paused: true });
      element.style.cssText = "width: 64px; height: 36px; aspect-ratio: auto";
      Object.assign(globalThis, { fault: "framebuffer" });
      document.body.append(element);
      await element.ready.catch(() => Object.assign(globalThis, { fault: null }));
      const hasCanvas = () => element.shadowRoot?.querySelector("canvas") !== null;
      const shown = [hasCanvas()];
      for (const quality of ["medium", "low"] as const) {
        element.quality = quality;
        shown.push(hasCanvas());
      }
      await element.ready;
      element.remove();
      return shown;
    });
    expect(shown).toEqual([false, false, true]);
  });
});
