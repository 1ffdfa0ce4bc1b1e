import { expect, test } from "../support/hosted-page.ts";
import { drawNothing } from "../support/no-drawing.ts";
import { LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";

/**
 * Takes away what Safari 16.4 or Firefox ESR 115 lacks, of all that our scripts or their like might use.
 * In Chromium there is more to take than in either of them.
 */
function removeNewerApis(): void {
  const lose = (owner: object, names: readonly string[]) => {
    for (const name of names) {
      Reflect.deleteProperty(owner, name);
      if (name in owner) throw new Error(`${name} is still there`);
    }
  };
  const aria = (prototype: object) => [
    "role",
    ...Object.getOwnPropertyNames(prototype).filter((name) => /^aria[A-Z]/.test(name)),
  ];
  lose(ElementInternals.prototype, ["states", ...aria(ElementInternals.prototype)]);
  lose(Element.prototype, aria(Element.prototype));
  lose(AbortSignal, ["any"]);
  lose(URL, ["canParse", "parse"]);
  lose(Object, ["groupBy"]);
  lose(Map, ["groupBy"]);
  lose(Promise, ["withResolvers", "try"]);
  lose(Array, ["fromAsync"]);
  const setMethods = ["union", "intersection", "difference", "isSubsetOf", "isSupersetOf"];
  lose(Set.prototype, [...setMethods, "symmetricDifference", "isDisjointFrom"]);
  const iterator: object = Object.getPrototypeOf(Object.getPrototypeOf([].values()));
  lose(iterator, ["map", "filter", "take", "drop", "flatMap", "toArray", "forEach", "some"]);
  lose(iterator, ["every", "find", "reduce"]);
  lose(ArrayBuffer.prototype, ["resize", "transfer"]);
  lose(String.prototype, ["isWellFormed", "toWellFormed"]);
  lose(HTMLElement.prototype, ["showPopover", "hidePopover", "togglePopover", "popover"]);
  lose(HTMLDialogElement.prototype, ["closedBy", "requestClose"]);
  lose(Element.prototype, ["checkVisibility", "getHTML", "setHTMLUnsafe"]);
  lose(WebGL2RenderingContext.prototype, ["drawingBufferColorSpace", "unpackColorSpace"]);
  lose(ResizeObserverEntry.prototype, ["devicePixelContentBoxSize"]);
  lose(Navigator.prototype, ["userActivation", "gpu"]);
  lose(globalThis, ["scheduler", "requestIdleCallback", "CloseWatcher", "VideoFrame", "CSSScope"]);
  const observe = ResizeObserver.prototype.observe;
  ResizeObserver.prototype.observe = function (target, options) {
    if (options?.box === "device-pixel-content-box") throw new TypeError("no such box");
    observe.call(this, target, options);
  };
}

test("in an old browser the page opens, one walks in and out, and its dialogs open", async ({
  fresh,
}) => {
  const { page, room } = fresh;
  await page.addInitScript(removeNewerApis);
  await drawNothing(page);
  await fresh.open("#look=paper&quality=low");
  const states = async () => {
    const names = await fresh.evaluate((element) => element.getAttributeNames());
    return names.filter((name) => name.startsWith("state-")).sort();
  };
  expect(await states()).toEqual(["state-lit", "state-playing"]);
  await expect(page.getByRole("application", { name: "A burning candle" })).toHaveCount(1);
  await expect(room).toHaveAttribute("aria-description", /Press Enter to take control/);

  const title = page.getByRole("heading", { level: 1 });
  await expect(title).toBeVisible();
  await fresh.enter.click();
  await expect(room).toHaveAttribute("state-walking", "");
  await expect(title).toBeHidden();
  await expect(room).toHaveCSS("outline-style", "none");
  await page.keyboard.press("e");
  await expect(room).not.toHaveAttribute("state-lit", "");
  await fresh.evaluate((element) => element.blur());
  await expect(room).not.toHaveAttribute("state-walking", "");
  await expect(title).toBeVisible();

  await page.getByRole("button", { name: "Settings" }).click();
  await expect(page.getByRole("dialog", { name: "Settings" })).toBeVisible();
  await expect(title).toBeHidden();
  await page.keyboard.press("Escape");
  await expect(page.getByRole("dialog", { name: "Settings" })).toBeHidden();
  await expect(title).toBeVisible();
  await page.getByRole("button", { name: "Help" }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Close" }).click();
  await expect(page.getByRole("dialog")).toBeHidden();

  const width = () => page.locator(".stage").evaluate((stage) => stage.clientWidth);
  await page.setViewportSize({ width: 900, height: 500 });
  expect(await width()).toBe(900);
  const looks = await fresh.openLab("Before and after");
  expect(await width()).toBeLessThan(600);
  await looks.getByRole("button", { name: "Compare" }).click();
  await expect(page.getByRole("slider", { name: "Divider between the two looks" })).toBeVisible();
});

test("a lone candle and the physical room open, and a failure shows a message", async ({
  page,
}) => {
  await page.addInitScript(removeNewerApis);
  await drawNothing(page);
  await serveSmallTextures(page);
  const size = { width: 64, height: 36 };
  const room = await new RoomDriver(page).open({ scene: "candle", alt: "A wee flame" }, size);
  const seen = () =>
    room.evaluate((element) => {
      const part = (name: string) => element.shadowRoot?.querySelector(`[part=${name}]`);
      const style = (name: string) => getComputedStyle(part(name) ?? element);
      const { display } = style("glow");
      return {
        display,
        visibility: style("canvas").visibility,
        draws: element.stats.drawCalls > 0,
      };
    });
  expect(await seen()).toEqual({ display: "block", visibility: "visible", draws: true });
  await expect(page.getByRole("img", { name: "A wee flame" })).toHaveCount(1);
  await room.evaluate((element) => {
    element.look = "physical";
    element.quality = "low";
    element.src = "/models/paper-room.glb"; // textured, as the cabin is, and opened sooner
    element.scene = "room";
    return element.ready;
  });
  expect(await seen()).toEqual({ display: "none", visibility: "visible", draws: true });

  const sentence = await room.evaluate(async (element) => {
    const failed = new Promise((resolve) =>
      element.addEventListener("error", ({ detail }) => resolve(detail.message), { once: true }),
    );
    element.src = "http://[nowhere";
    return failed;
  });
  expect(sentence).toMatch(/address is none that can be read: http:\/\/\[nowhere/);
  const fresh = await page.evaluate(async (src) => {
    const element = document.createElement("candle-flame");
    Object.assign(element, { src, controls: true, alt: "A room that is not there" });
    document.body.append(element);
    return element.ready.catch((error: Error) => error.message);
  }, `${LIBRARY}nowhere.glb`);
  expect(fresh).toMatch(/nowhere\.glb/);
  await expect(page.getByRole("alert")).toContainText("nowhere.glb");
  await expect(page.getByRole("group", { name: "A room that is not there" })).toHaveCount(1);
});
