import { SETTINGS } from "../../src/settings.ts";
import { manifest } from "../../tools/elements-manifest.ts";
import { complaintsOf, LIBRARY } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

/** The public face as the custom elements manifest describes it. */
const [face] = (await manifest()).modules.flatMap(({ declarations }) => declarations ?? []);
if (!face) throw new Error("The manifest declares nothing.");
const namesOf = (list: readonly { name: string }[]) => list.map(({ name }) => name).sort();

const PIXEL = "data:image/gif;base64,R0lGODlhAQABAIAAAP///wAAACH5BAEAAAAALAAAAAABAAEAAAICRAEAOw==";

test("Every property and method is there, of its kind, before the first frame and after it", async ({
  room,
}) => {
  const kinds = (isDrawn: boolean) =>
    room.evaluate(
      (drawn, { names, isDrawn }) => {
        const element = isDrawn ? drawn : document.createElement("candle-flame");
        return names.map((name) => {
          const value: unknown = Reflect.get(element, name);
          const kind = value instanceof Promise ? "promise" : typeof value;
          return `${name} ${value === null ? "null" : kind}`;
        });
      },
      { names: face.members.map(({ name }) => name), isDrawn },
    );
  const expected = (isDrawn: boolean) =>
    face.members.map((member) => {
      if (member.kind === "method") return `${member.name} function`;
      if (member.name === "flame") return `flame ${isDrawn ? "object" : "null"}`;
      if (member.name === "ready") return "ready promise";
      const { text = "" } = member.type ?? {};
      const kind = text.startsWith('"') ? "string" : text;
      return `${member.name} ${["string", "number", "boolean"].includes(kind) ? kind : "object"}`;
    });
  expect(await kinds(false)).toEqual(expected(false));
  expect(await kinds(true)).toEqual(expected(true));
});

test("Every event comes when it should, and none bubbles", async ({ room }) => {
  const { eventTypes, left } = await room.page.evaluate(
    async ({ types }) => {
      const element = document.createElement("candle-flame");
      const eventTypes = new Set<string>();
      const left: string[] = [];
      const stop = new AbortController();
      for (const type of types) {
        element.addEventListener(type, () => eventTypes.add(type));
        document.body.addEventListener(type, () => left.push(type), { signal: stop.signal });
      }
      const next = (type: string) =>
        new Promise((resolve) => element.addEventListener(type, resolve, { once: true }));
      Object.assign(element, { look: "paper", quality: "medium", controls: true });
      element.style.cssText = "width: 32px; height: 18px";
      document.body.append(element);
      await element.ready;
      element.pause();
      element.place();
      element.take();
      element.extinguish();
      element.light();
      element.camera = { ...element.camera, yaw: 1 };
      element.quality = "low";
      element.enter();
      element.blur();
      const canvas = element.shadowRoot?.querySelector("canvas");
      const extension = canvas?.getContext("webgl2")?.getExtension("WEBGL_lose_context");
      const lost = next("contextlost");
      extension?.loseContext();
      await lost;
      await new Promise((resolve) => setTimeout(resolve));
      const restored = next("contextrestored");
      extension?.restoreContext();
      await restored;
      const failed = next("error");
      element.src = "data:model/gltf-binary,nonsense";
      await failed;
      element.remove();
      stop.abort();
      return { eventTypes: [...eventTypes], left };
    },
    { types: namesOf(face.events) },
  );
  expect(eventTypes.sort()).toEqual(namesOf(face.events));
  expect(left).toEqual([]);
});

test("Every slot and part of the shadow tree is in the manifest, and no other", async ({
  room,
}) => {
  const found = await room.evaluate((element) => {
    const all = [...(element.shadowRoot?.querySelectorAll("*") ?? [])];
    return {
      slots: all.flatMap((node) => (node instanceof HTMLSlotElement ? [node.name] : [])).sort(),
      parts: all.flatMap((node) => [...node.part]).sort(),
    };
  });
  expect(found.slots).toEqual(namesOf(face.slots));
  // The button is there when it is needed.
  expect(["reload", ...found.parts].sort()).toEqual(namesOf(face.cssParts));
});

test("What the page puts into slots is shown in place of what the element has", async ({
  room,
}) => {
  const seen = await room.page.evaluate(async (poster) => {
    const make = (settings: object) => {
      const element = document.createElement("candle-flame");
      Object.assign(element, { look: "paper", quality: "low", paused: true, poster }, settings);
      element.style.cssText = "width: 320px; height: 180px";
      element.innerHTML = ["poster", "progress", "hint", "error"]
        .map((name) => `<b slot="${name}">${name}</b>`)
        .join("");
      const shown = () =>
        [...element.children]
          .filter((child) => child.checkVisibility({ checkOpacity: true }))
          .map((child) => child.textContent);
      const own = () =>
        ["poster", "progress"].filter((name) =>
          element.shadowRoot?.querySelector(`[part~=${name}]`)?.checkVisibility(),
        );
      return { element, shown, own };
    };
    const { element, shown, own } = make({ controls: true });
    const begun = new Promise((resolve) => {
      element.addEventListener("progress", resolve, { once: true });
    });
    document.body.append(element);
    await begun;
    const loading = { shown: shown(), own: own() };
    const [cover] = element.children;
    const { width } = cover?.getBoundingClientRect() ?? {};
    await element.ready;
    for (const fade of element.shadowRoot?.getAnimations() ?? []) fade.finish();
    const loaded = { shown: shown(), own: own() };
    element.enter();
    const standing = shown();
    element.step(0);
    const walking = shown();
    element.blur();
    const left = shown();
    element.remove();

    const broken = make({ src: "data:model/gltf-binary,nonsense" });
    document.body.append(broken.element);
    await broken.element.ready.catch(() => {});
    const failed = { shown: broken.shown(), own: broken.own() };
    const sentence = broken.element.shadowRoot?.querySelector("[part~=error] p");
    const isReplaced = sentence?.checkVisibility() === false;
    broken.element.remove();
    return { loading, width, loaded, standing, walking, left, failed, isReplaced };
  }, PIXEL);
  expect(seen).toEqual({
    loading: { shown: ["poster", "progress"], own: [] },
    width: 320,
    loaded: { shown: [], own: [] },
    standing: [],
    walking: ["hint"],
    left: [],
    failed: { shown: ["poster", "error"], own: [] },
    isReplaced: true,
  });
});

test("Every part can be styled from outside", async ({ room }) => {
  const colors = await room.evaluate(
    (element, names) => {
      const style = document.createElement("style");
      style.textContent = names
        .map((name, i) => `candle-flame::part(${name}) { border-top-color: rgb(0, 0, ${i + 1}) }`)
        .join("\n");
      document.head.append(style);
      const colors = names.map((name) => {
        const part = element.shadowRoot?.querySelector(`[part~=${name}]`);
        return part && getComputedStyle(part).borderTopColor;
      });
      style.remove();
      return colors;
    },
    namesOf(face.cssParts).filter((name) => name !== "reload"),
  );
  expect(colors).toEqual(colors.map((_, i) => `rgb(0, 0, ${i + 1})`));
});

test("The bar has the colour and the height that the page gives it", async ({ room }) => {
  const bar = await room.evaluate((element) => {
    const part = element.shadowRoot?.querySelector("[part~=progress]");
    if (!part) throw new Error("no bar");
    const styles = () => {
      const { backgroundColor, height } = getComputedStyle(part);
      return { backgroundColor, height };
    };
    const { parentElement } = part;
    if (parentElement) parentElement.hidden = false; // a box that is not shown has no height
    const before = styles();
    element.style.setProperty("--candle-flame-progress-color", "rgb(1, 2, 3)");
    element.style.setProperty("--candle-flame-progress-height", "9px");
    const after = styles();
    element.style.removeProperty("--candle-flame-progress-color");
    element.style.removeProperty("--candle-flame-progress-height");
    if (parentElement) parentElement.hidden = true;
    return { before, after };
  });
  const defaults = Object.fromEntries(
    face.cssProperties.map(({ name, default: value }) => [name, value]),
  );
  expect(defaults["--candle-flame-progress-color"]).toBe("#f0a54a");
  expect(bar).toEqual({
    before: {
      backgroundColor: "rgb(240, 165, 74)",
      height: defaults["--candle-flame-progress-height"],
    },
    after: { backgroundColor: "rgb(1, 2, 3)", height: "9px" },
  });
});

test("Its states are those of the moment", async ({ room }) => {
  const { waiting, states } = await room.page.evaluate(
    async (names) => {
      const lazy = document.createElement("candle-flame");
      Object.assign(lazy, { loading: "lazy" });
      document.body.append(lazy);
      lazy.scene = "candle";
      const waiting = lazy.matches(":state(alone)");
      lazy.remove();
      const element = document.createElement("candle-flame");
      Object.assign(element, { look: "paper", quality: "low", paused: true, controls: true });
      element.style.cssText = "width: 32px; height: 18px";
      const now = () => names.filter((name) => element.matches(`:state(${name})`)).join(" ");
      const states = [now()];
      document.body.append(element);
      states.push(now());
      await element.ready;
      states.push(now());
      element.extinguish();
      states.push(now());
      element.light();
      element.enter();
      states.push(now());
      element.blur();
      element.play();
      states.push(now());
      element.scene = "candle";
      await element.ready;
      states.push(now());
      element.remove();
      await new Promise((resolve) => setTimeout(resolve));
      states.push(now());
      return { waiting, states };
    },
    ["loading", "lit", "walking", "playing", "alone"],
  );
  expect(waiting, "of an element that waits for the viewport").toBe(true);
  expect(states).toEqual([
    "",
    "loading",
    "lit",
    "",
    "lit walking",
    "lit playing",
    "lit playing alone",
    "",
  ]);
  expect(namesOf(face.cssStates)).toEqual(["alone", "lit", "loading", "playing", "walking"]);
});

test("What is set before the tag is defined holds when it is, in a box that the page may shape", async ({
  page,
}) => {
  const complaints = complaintsOf(page);
  const values: Record<string, unknown> = {};
  for (const [name, setting] of Object.entries(SETTINGS)) {
    const property = name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());
    if (setting.kind === "flag") values[property] = true;
    else if (setting.kind === "number") values[property] = setting.max;
    else if (setting.kind === "choice") values[property] = setting.choices.at(-1);
    else values[property] = "data:,text";
  }
  await page.route(`${LIBRARY}early.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      // Out of sight and lazy, it fetches nothing.
      body: `<!doctype html><title>early</title><div style="height: 5000px"></div>
        <candle-flame></candle-flame>
        <script>Object.assign(document.querySelector("candle-flame"), ${JSON.stringify(values)})</script>
        <script type="module" src="/define.js"></script>`,
    }),
  );
  await page.goto(`${LIBRARY}early.html`);
  await page.waitForFunction(() => customElements.get("candle-flame") !== undefined);
  const found = await page.evaluate((names) => {
    const element = document.querySelector("candle-flame") as unknown as Record<string, unknown>;
    return Object.fromEntries(names.map((name) => [name, element[name]]));
  }, Object.keys(values));
  expect(found).toEqual(values);
  // On a page that says nothing of the tag:
  const sizes = await page.evaluate(() => {
    const element = document.querySelector("candle-flame");
    if (!element) throw new Error("no element");
    const frame = document.createElement("div");
    frame.style.cssText = "width: 320px; position: absolute; top: 5000px";
    frame.append(element);
    document.body.append(frame);
    const sizes = [
      "",
      "width: 160px",
      "height: 90px",
      "aspect-ratio: 1",
      "width: auto; height: 90px",
      "width: auto; height: 90px; aspect-ratio: 1",
      "border: 10px solid; padding: 5px",
      "width: 160px; padding: 5px; box-sizing: content-box",
      "width: auto; margin: 0 20px",
    ].map((css) => {
      element.style.cssText = css;
      return `${element.offsetWidth} x ${element.offsetHeight}`;
    });
    return sizes;
  });
  expect(sizes, "a block of 16 to 9, unless the page wants another").toEqual([
    "320 x 180",
    "160 x 90",
    "320 x 90",
    "320 x 320",
    "160 x 90",
    "90 x 90",
    "320 x 180",
    "170 x 100",
    "280 x 158",
  ]);
  const display = () => getComputedStyle(document.querySelector("candle-flame") as Element).display;
  expect(await page.evaluate(display)).toBe("block");
  const popovers = await page.evaluate(() => {
    const element = document.createElement("candle-flame");
    Object.assign(element, { loading: "lazy", popover: "manual" });
    element.style.cssText = "width: 160px; margin: auto";
    document.body.append(element);
    const closed = element.offsetWidth;
    element.showPopover();
    const { position } = getComputedStyle(element);
    const { left, right, top, bottom } = element.getBoundingClientRect();
    element.style.cssText = "";
    const widest = element.offsetWidth;
    element.remove(); // before it is seen
    return {
      closed,
      position,
      aside: left + right - innerWidth,
      below: top + bottom - innerHeight,
      overflow: widest - innerWidth,
    };
  });
  const within = { aside: 0, below: 0, overflow: 0 };
  expect(popovers).toEqual({ closed: 0, position: "fixed", ...within });
  // Boxes that are as wide as what is in them, and columns that are not.
  const widths = await page.evaluate(() => {
    const element = document.querySelector("candle-flame");
    const frame = element?.parentElement;
    if (!element || !frame) throw new Error("no element");
    element.style.cssText = "";
    const boxes = ["float: left", "display: inline-block", "position: absolute", "display: table"];
    const columns = ["flex: 1", "flex: 1; display: flex", "flex: 1; display: grid"];
    return [...boxes, ...columns].map((css) => {
      const box = document.createElement("div");
      box.style.cssText = css;
      box.append(element);
      frame.style.display = css.startsWith("flex") ? "flex" : "block";
      frame.replaceChildren(
        box,
        ...(css.startsWith("flex") ? [1, 2, 3].map(() => box.cloneNode()) : []),
      );
      return `${element.offsetWidth} x ${element.offsetHeight}`;
    });
  });
  expect(widths, "of 300 pixels, as a canvas is, but of less where there is less").toEqual([
    ...Array(4).fill("300 x 169"),
    ...Array(3).fill("80 x 45"),
  ]);
  expect(complaints).toEqual([]);
});
