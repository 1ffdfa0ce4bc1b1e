import type { Page } from "playwright/test";
import { drawNothing } from "../support/no-drawing.ts";
import { RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

const TALL = `<button>elsewhere</button><div style="height: 3000px"></div>`;
const LOOKS_ALONG = { position: [0, 1.6, 3], yaw: 0, pitch: 0 } as const;

async function openControls(page: Page): Promise<RoomDriver> {
  await drawNothing(page);
  await serveSmallTextures(page);
  const opening = { width: 160, height: 90, after: TALL };
  const attributes = { look: "paper", quality: "low", controls: "" };
  const room = await new RoomDriver(page).open(attributes, opening);
  await room.stand(LOOKS_ALONG);
  return room;
}

/** Goes into a room that is open already, and has the controls shown, which wait for time. */
const enter = (room: RoomDriver) =>
  room.evaluate((element) => {
    element.controls = true;
    element.enter();
    element.step(0);
  });

const hintOf = (room: RoomDriver) =>
  room.evaluate((element) => {
    element.step(0);
    const hint = element.shadowRoot?.querySelector<HTMLElement>("[part=hint]");
    return hint?.textContent?.replaceAll(/\s+/g, " ").trim();
  });

async function fingersOn(page: Page) {
  const client = await page.context().newCDPSession(page);
  return (type: string, ...points: readonly (readonly [x: number, y: number])[]) =>
    client.send("Input.dispatchTouchEvent", {
      type: type as "touchStart",
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
}

test.describe("Fingers", () => {
  test.use({ hasTouch: true, viewport: { width: 320, height: 480 } });

  test("scroll the page before they go in, then walk, look and come back", async ({ page }) => {
    const room = await openControls(page);
    const fingers = await fingersOn(page);
    const touchAction = () =>
      room.evaluate((element) => {
        const canvas = element.shadowRoot?.querySelector("canvas");
        return canvas && getComputedStyle(canvas).touchAction;
      });
    const events = await room.evaluate((element) => {
      const events: string[] = [];
      element.addEventListener("enter", () => events.push("enter"));
      element.addEventListener("leave", () => events.push("leave"));
      Object.assign(globalThis, { events });
      return events;
    });
    expect(events).toEqual([]);

    expect(await touchAction()).toBe("auto");
    await fingers("touchStart", [120, 45]);
    for (const y of [30, 15, 2]) await fingers("touchMove", [120, y]);
    await fingers("touchEnd");
    await room.step(0.1);
    expect(await room.camera()).toMatchObject(LOOKS_ALONG);
    expect(await room.isWalking()).toBe(false);

    // The page went with the finger, and may still be coasting.
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(0);
    await page.evaluate(async () => {
      for (let rests = 0; rests < 10; ) {
        rests = scrollY === 0 ? rests + 1 : 0;
        scrollTo(0, 0);
        await new Promise(requestAnimationFrame);
      }
    });
    await page.touchscreen.tap(80, 45);
    await expect.poll(() => room.isWalking()).toBe(true);
    expect(await page.evaluate(() => document.pointerLockElement)).toBeNull();
    expect(await touchAction()).toBe("none");
    expect(await hintOf(room)).toMatch(/^Walk with the left thumb/);

    await fingers("touchStart", [40, 80], [120, 45]);
    await fingers("touchMove", [40, 20], [140, 35]);
    await room.step(0.5);
    const { position, yaw, pitch } = await room.camera();
    expect(position[2]).toBeLessThan(2.5);
    expect(yaw).toBeCloseTo(-20 * 0.006, 6);
    expect(pitch).toBeCloseTo(10 * 0.006, 6);
    await fingers("touchEnd");
    expect(await page.evaluate(() => scrollY)).toBe(0);

    await page.touchscreen.tap(200, 300); // beside the element
    await expect.poll(() => room.isWalking()).toBe(false);
    expect(await page.evaluate(() => Reflect.get(globalThis, "events"))).toEqual([
      "enter",
      "leave",
    ]);
    expect(await hintOf(room)).toBe("");
    expect(room.complaints).toEqual([]);
  });

  test("scroll the page from a lone candle, which has no view to turn, all the time", async ({
    page,
  }) => {
    const room = await new RoomDriver(page).open(
      { scene: "candle", quality: "low", controls: "" },
      { width: 160, height: 90, after: TALL },
    );
    await room.evaluate((element) => element.enter());
    await expect.poll(() => room.isWalking()).toBe(true);
    const fingers = await fingersOn(page);
    await fingers("touchStart", [120, 85]);
    for (const y of [60, 40, 20, 5]) await fingers("touchMove", [120, y]);
    await fingers("touchEnd");
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(0);
    expect(await room.isWalking()).toBe(true);
  });
});

test("A gamepad goes in where the focus is, walks, looks, puts out, puts down, and leaves", async ({
  page,
}) => {
  await page.addInitScript(() => {
    const pad = {
      mapping: "standard",
      axes: [0, 0, 0, 0],
      buttons: Array.from({ length: 17 }, () => ({ pressed: false })),
    };
    Object.assign(globalThis, { pad });
    navigator.getGamepads = () => [pad] as unknown as Gamepad[];
  });
  const room = await openControls(page);
  const hold = (axes: readonly number[], pressed: readonly number[] = []) =>
    page.evaluate(
      ({ axes, pressed }) => {
        const { pad } = globalThis as unknown as {
          pad: { axes: readonly number[]; buttons: { pressed: boolean }[] };
        };
        pad.axes = axes;
        pad.buttons.forEach((button, i) => {
          button.pressed = pressed.includes(i);
        });
      },
      { axes, pressed },
    );
  const still = [0.1, -0.1, 0.05, 0];

  await hold([0, -1, 1, 0], [0]);
  await room.step(0.5);
  expect(await room.camera()).toMatchObject(LOOKS_ALONG); // it has no focus
  expect(await room.isWalking()).toBe(false);

  await hold(still);
  await room.evaluate((element) => element.focus());
  await room.step(0.1);
  const setWindowFocus = (has: boolean) =>
    page.evaluate((has) => Object.assign(document, { hasFocus: () => has }), has);
  await setWindowFocus(false);
  await hold(still, [0]);
  await room.step(0.1);
  expect(await room.isWalking()).toBe(false);
  await setWindowFocus(true);
  await hold(still);
  await room.step(0.1);
  await hold(still, [0]);
  await room.step(0.1);
  expect(await room.isWalking()).toBe(true);
  expect(await hintOf(room)).toMatch(/^Left stick walks/);
  await hold(still);
  await room.step(0.5);
  expect(await room.camera()).toMatchObject(LOOKS_ALONG); // worn springs
  await hold([0, -1, 0, -1]);
  await room.step(0.5);
  const { position, pitch } = await room.camera();
  expect(position[2]).toBeLessThan(2.5);
  expect(pitch).toBeCloseTo(0.5, 3);
  await hold(still, [0]);
  await room.step(0.1);
  expect(await room.evaluate((element) => element.lit)).toBe(false);
  await hold(still, [2]);
  await room.step(0.1);
  expect(await room.evaluate((element) => element.held)).toBe(false);
  await hold(still, [1]);
  await room.step(0.1);
  expect(await room.isWalking()).toBe(false);
  expect(room.complaints).toEqual([]);
});

test("The keyboard alone looks up and down and says what it can", async ({ page }) => {
  const room = await openControls(page);
  await page.keyboard.press("Tab");
  const ring = await room.evaluate((element) => getComputedStyle(element).outline);
  expect(ring).toBe("rgb(243, 201, 139) solid 2px");
  await page.keyboard.press("Enter");
  expect(await room.isWalking()).toBe(true);
  expect(await hintOf(room)).toBe(
    "WASD walk, QR turn, PgUpPgDn look, E puts the flame out or lights it, F puts the candle down, Esc leaves",
  );
  await page.keyboard.down("PageDown");
  await room.step(0.5);
  await page.keyboard.up("PageDown");
  expect((await room.camera()).pitch).toBeCloseTo(-0.5, 6);
  expect(await page.evaluate(() => scrollY)).toBe(0);
  const client = await page.context().newCDPSession(page);
  const { nodes } = await client.send("Accessibility.getFullAXTree");
  const application = nodes.find(({ role }) => role?.value === "application");
  expect(application?.description?.value).toBe("Press Enter to take control, Escape to leave.");
  const status = nodes.find(({ role }) => role?.value === "status");
  expect(status?.properties?.find(({ name }) => name === "live")?.value.value).toBe("polite");
  expect(room.complaints).toEqual([]);
});

test("By a button of the page that a key presses, too, the controls are those of the keyboard", async ({
  page,
}) => {
  const after = `<button onclick="document.querySelector('candle-flame').enter()">Walk in</button>`;
  const room = await new RoomDriver(page).open(
    { look: "paper", controls: "" },
    { width: 320, height: 180, after },
  );
  const button = page.getByRole("button", { name: "Walk in" });
  await button.focus();
  await page.keyboard.press("Enter");
  expect(await hintOf(room)).toMatch(/PgUp/);
  await page.keyboard.press("Escape");
  await expect.poll(() => room.isWalking()).toBe(false);
  await button.click();
  expect(await hintOf(room)).toMatch(/the mouse looks/);
  expect(room.complaints).toEqual([]);
});

test("Hints name keys as the visitor's own keyboard does, and what is in his hand", async ({
  page,
}) => {
  await page.addInitScript(() => {
    const names = { KeyW: "z", KeyA: "q", KeyQ: "a", KeyE: "." };
    const keyboard = { getLayoutMap: async () => new Map(Object.entries(names)) };
    Object.defineProperty(navigator, "keyboard", { value: keyboard });
  });
  const room = await openControls(page);
  await room.evaluate((element) => element.focus());
  await page.keyboard.press("Enter");
  await expect.poll(() => hintOf(room)).toMatch(/^Z ?Q ?S ?D walk, A ?R turn/);
  const out = () =>
    room.evaluate((element) => {
      element.light();
      element.extinguish();
    });
  await out();
  expect(await hintOf(room)).toBe("The candle is out. Press . to light it.");
  await page.keyboard.press("Escape");
  await page.evaluate(() => {
    const touch = { pointerType: "touch", bubbles: true };
    document.body.dispatchEvent(new PointerEvent("pointerdown", touch));
  });
  await enter(room);
  await out();
  expect(await hintOf(room)).toBe("The candle is out. Tap twice to light it.");
});

test("Where the lock is refused, the hint says to drag, and the sensitivity is how far that turns the view", async ({
  page,
}) => {
  await page.addInitScript(() => {
    Element.prototype.requestPointerLock = () =>
      Promise.reject(new DOMException("refused", "SecurityError"));
  });
  const room = await openControls(page);
  await room.set({ sensitivity: "3" });
  await page.mouse.click(80, 45);
  const walking =
    "WASD walk, drag to look, E puts the flame out or lights it, F puts the candle down, Esc leaves";
  await expect.poll(() => hintOf(room)).toBe(walking);
  expect(await room.isWalking()).toBe(true);
  await page.mouse.down();
  await page.mouse.move(90, 45);
  await page.mouse.up();
  await room.step(0);
  expect((await room.camera()).yaw).toBeCloseTo(-10 * 0.0022 * 3, 6);
});

test("The hint animates only while it fades: browsers composite the whole page meanwhile", async ({
  room,
}) => {
  await enter(room);
  const fading = () =>
    room.evaluate((element) => {
      const line = element.shadowRoot?.querySelector("[part=hint] p") as HTMLElement;
      const timings = line.getAnimations().map((animation) => {
        const { activeDuration, endTime } = animation.effect?.getComputedTiming() ?? {};
        animation.finish();
        return { activeDuration, endTime };
      });
      return { timings, opacity: getComputedStyle(line).opacity };
    });
  const gone = (endTime: number) => ({
    timings: [{ activeDuration: 500, endTime }],
    opacity: "0",
  });
  expect(await fading()).toEqual(gone(8000));
  await room.evaluate((element) => element.extinguish());
  await room.step(0);
  expect(await fading(), "also one that says how to light the candle").toEqual(gone(20_000));
});

test("Contrast and forced colours reach the hint", async ({ room }) => {
  const { page } = room;
  await enter(room);
  const hint = () =>
    room.evaluate((element) => {
      const line = element.shadowRoot?.querySelector("[part=hint] p");
      const { backgroundColor, outlineStyle } = getComputedStyle(line as Element);
      return { backgroundColor, outlineStyle };
    });
  expect((await hint()).outlineStyle).toBe("none");
  await page.emulateMedia({ contrast: "more" });
  expect(await hint()).toEqual({ backgroundColor: "rgb(0, 0, 0)", outlineStyle: "solid" });
  await page.emulateMedia({ contrast: null, forcedColors: "active" });
  const forced = { backgroundColor: expect.stringMatching(/^rgb\(/), outlineStyle: "solid" };
  expect(await hint()).toEqual(forced);
  await page.emulateMedia({ forcedColors: null });
});
