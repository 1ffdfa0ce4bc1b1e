import type { Page } from "playwright/test";
import { drawNothing } from "../support/no-drawing.ts";
import { type Opening, RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

const SMALL: Opening = { width: 160, height: 90 };
/** What makes a page scroll. */
const TALL = `<div style="height: 3000px"></div>`;
const LOOKS_ALONG = { position: [0, 1.6, 3], yaw: 0, pitch: 0 } as const;

async function openControls(page: Page, opening: Opening = SMALL): Promise<RoomDriver> {
  await drawNothing(page);
  await serveSmallTextures(page);
  const attributes = { look: "paper", quality: "low", controls: "" };
  const room = await new RoomDriver(page).open(attributes, opening);
  await room.stand(LOOKS_ALONG);
  return room;
}

/** Gives an open room controls. */
async function addControls(room: RoomDriver): Promise<void> {
  await room.set({ controls: "" });
  await room.stand(LOOKS_ALONG);
}

async function enterByKeyboard(room: RoomDriver): Promise<void> {
  await room.evaluate((element) => element.focus());
  await room.page.keyboard.press("Enter");
  expect(await room.isWalking()).toBe(true);
}

/** Lets the page's own pointer lock fail, as browsers do: with these errors, or only for raw input. */
async function refusePointerLock(page: Page, error: string, onlyRaw = false): Promise<void> {
  await page.evaluate(
    ({ error, onlyRaw }) => {
      const own = globalThis as { requestPointerLock?: Element["requestPointerLock"] };
      own.requestPointerLock ??= Element.prototype.requestPointerLock;
      const { requestPointerLock } = own;
      const requests: unknown[] = [];
      Object.assign(globalThis, { requests });
      Element.prototype.requestPointerLock = function (options?: PointerLockOptions) {
        requests.push(options?.unadjustedMovement ?? false);
        return onlyRaw && !options?.unadjustedMovement
          ? requestPointerLock.call(this, options)
          : Promise.reject(new DOMException("refused", error));
      };
    },
    { error, onlyRaw },
  );
}

/** Leaves, and stands again where he came in. */
async function comeBack(room: RoomDriver): Promise<void> {
  await room.evaluate(async (element) => {
    const change = new Promise((resolve) =>
      document.addEventListener("pointerlockchange", resolve, { once: true }),
    );
    const isLocked = document.pointerLockElement !== null;
    document.exitPointerLock();
    element.blur();
    if (isLocked) await change;
  });
  await expect.poll(() => room.isWalking()).toBe(false);
  await room.stand(LOOKS_ALONG);
}

const lockRequests = (page: Page) =>
  page.evaluate(() => (globalThis as unknown as { requests: boolean[] }).requests);

const hasLock = (room: RoomDriver) =>
  room.evaluate((element) => {
    const canvas = element.shadowRoot?.querySelector("canvas") ?? null;
    return (
      document.pointerLockElement === element &&
      element.shadowRoot?.pointerLockElement === canvas &&
      canvas !== null
    );
  });

/** A headless browser that is busy may hear the first keys, and not scroll. */
async function expectKeyToScroll(page: Page): Promise<void> {
  await expect
    .poll(async () => {
      await page.keyboard.press("ArrowDown");
      return page.evaluate(() => scrollY);
    })
    .toBeGreaterThan(0);
}

async function clickIn(room: RoomDriver): Promise<void> {
  // The lock comes before its event, which the element must have heard of when the mouse moves.
  const changes = await room.page.evaluateHandle(() => {
    const changes: boolean[] = [];
    document.addEventListener("pointerlockchange", () =>
      changes.push(document.pointerLockElement !== null),
    );
    return changes;
  });
  await room.page.mouse.click(80, 45);
  await expect.poll(() => changes.jsonValue()).toEqual([true]);
  expect(await hasLock(room)).toBe(true);
}

test.describe("Walking", () => {
  let page: Page;
  let room: RoomDriver;
  test.beforeAll(async ({ browser }) => {
    page = await browser.newPage();
    room = await openControls(page);
    await enterByKeyboard(room);
  });
  test.beforeEach(() => room.stand(LOOKS_ALONG));
  test.afterEach(() => expect(room.complaints).toEqual([]));
  test.afterAll(() => page.close());

  /** Way made in the second second of a key's being held: by then the pace is full. */
  async function paceOf(...keys: string[]): Promise<[x: number, z: number]> {
    for (const key of keys) await page.keyboard.down(key);
    await room.step(1 / 20, 20);
    const before = (await room.camera()).position;
    await room.step(1 / 60, 30);
    const after = (await room.camera()).position;
    for (const key of keys) await page.keyboard.up(key);
    await room.step(1);
    return [(after[0] - before[0]) * 2, (after[2] - before[2]) * 2];
  }

  for (const { keys, x, z } of [
    { keys: ["KeyW"], x: 0, z: -2 },
    { keys: ["ArrowUp"], x: 0, z: -2 },
    { keys: ["KeyA"], x: -2, z: 0 },
    { keys: ["ArrowLeft"], x: -2, z: 0 },
    { keys: ["KeyD"], x: 2, z: 0 },
    { keys: ["ArrowRight"], x: 2, z: 0 },
    { keys: ["ShiftLeft", "KeyW"], x: 0, z: -4 },
    { keys: ["KeyW", "KeyD"], x: Math.SQRT2, z: -Math.SQRT2 },
    { keys: ["KeyW", "KeyS"], x: 0, z: 0 },
  ]) {
    test(`${keys.join(" and ")} goes at ${Math.hypot(x, z).toFixed(0)} m/s`, async () => {
      const [alongX, alongZ] = await paceOf(...keys);
      expect(alongX).toBeCloseTo(x, 3);
      expect(alongZ).toBeCloseTo(z, 3);
    });
  }

  for (const key of ["KeyS", "ArrowDown"]) {
    test(`${key} goes backwards at 2 m/s`, async () => {
      await room.stand({ position: [0, 1.6, -3] });
      expect(await paceOf(key)).toEqual([expect.closeTo(0, 3), expect.closeTo(2, 3)]);
    });
  }

  for (const [key, direction] of [
    ["KeyQ", 1],
    ["Home", 1],
    ["KeyR", -1],
    ["End", -1],
  ] as const) {
    test(`${key} turns to the ${direction > 0 ? "left" : "right"}, on the spot`, async () => {
      await page.keyboard.down(key);
      await room.step(1 / 60, 30);
      await page.keyboard.up(key);
      const { yaw, position } = await room.camera();
      expect(yaw * direction).toBeCloseTo(0.8, 6);
      expect(position).toEqual(LOOKS_ALONG.position);
    });
  }

  test("goes where the eye looks", async () => {
    await room.stand({ yaw: Math.PI / 2, position: [0, 1.6, 0] });
    const [x, z] = await paceOf("KeyW");
    expect(x).toBeCloseTo(-2, 3);
    expect(z).toBeCloseTo(0, 3);
  });

  test("ends in the same place at 30, 60 and 144 Hz", async () => {
    const ends: number[] = [];
    for (const framesPerSecond of [30, 60, 144]) {
      await room.stand(LOOKS_ALONG);
      await page.keyboard.down("KeyW");
      await room.step(1 / framesPerSecond, framesPerSecond);
      await page.keyboard.up("KeyW");
      ends.push((await room.camera()).position[2]);
      await room.step(1);
    }
    expect(ends[1]).toBeCloseTo(ends[0] ?? 0, 9);
    expect(ends[2]).toBeCloseTo(ends[0] ?? 0, 9);
  });

  test("with Control, Alt or Meta held is left to the browser", async () => {
    for (const modifier of ["Control", "Alt", "Meta"]) {
      await page.keyboard.down(modifier);
      await page.keyboard.down("KeyQ");
      await room.step(0.2);
      await page.keyboard.up("KeyQ");
      await page.keyboard.up(modifier);
    }
    expect((await room.camera()).yaw).toBe(0);
  });

  test("F puts the candle down and takes it up, and says so", async () => {
    const events = await room.evaluate((element) => {
      const events: string[] = [];
      element.addEventListener("place", () => events.push("place"));
      element.addEventListener("take", () => events.push("take"));
      Object.assign(element, { events });
      return events;
    });
    expect(events).toEqual([]);
    for (const held of [false, true]) {
      await page.keyboard.down("KeyF");
      await page.keyboard.down("KeyF"); // repeats by itself
      await room.step(1 / 60);
      await room.step(1 / 60);
      await page.keyboard.up("KeyF");
      expect(await room.evaluate((element) => element.held)).toBe(held);
    }
    const eventTypes = await room.evaluate(
      (element) => (element as unknown as { events: string[] }).events,
    );
    expect(eventTypes).toEqual(["place", "take"]);
  });
});

test.describe("Walls", () => {
  const WALLS = [
    { name: "north", yaw: 0 },
    { name: "west", yaw: Math.PI / 2 },
    { name: "south", yaw: Math.PI },
    { name: "east", yaw: -Math.PI / 2 },
    { name: "corner", yaw: Math.PI / 4 },
  ];

  test("keep a runner half a metre away, however long a step is", async ({ page }) => {
    const room = await openControls(page, { width: 32, height: 18 });
    await enterByKeyboard(room);
    await page.keyboard.down("ShiftLeft");
    await page.keyboard.down("KeyW");
    for (const { name, yaw } of WALLS) {
      for (const { seconds, times } of [
        { seconds: 1 / 20, times: 40 },
        { seconds: 3, times: 1 },
      ]) {
        await room.stand({ position: [0, 1.6, 0], yaw });
        const farthest = await room.evaluate(
          (element, { seconds, times }) => {
            let farthest = 0;
            for (let i = 0; i < times; i++) {
              element.step(seconds);
              const [x, , z] = element.camera.position;
              farthest = Math.max(farthest, Math.abs(x), Math.abs(z));
            }
            return farthest;
          },
          { seconds, times },
        );
        expect(farthest, `${name}, steps of ${seconds} s`).toBe(4.5);
      }
    }
    await page.keyboard.up("ShiftLeft");

    await test.step("let a walker slide along them", async () => {
      await room.stand({ position: [0, 1.6, -4.5], yaw: Math.PI / 4 });
      await room.step(1 / 20, 20);
      const [x, , z] = (await room.camera()).position;
      expect(z).toBe(-4.5);
      expect(x).toBeLessThan(-1);
    });

    await test.step("of the original are walked through", async () => {
      await room.set({ look: "original" });
      await room.stand({ position: [0, 1.6, 0], yaw: 0 });
      await room.step(1 / 20, 100);
      expect((await room.camera()).position[2]).toBeLessThan(-6);
    });
    expect(room.complaints).toEqual([]);
  });
});

test.describe("The mouse", () => {
  test("is locked by a click, looks around, and is freed by leaving", async ({ page }) => {
    const room = await openControls(page);
    await clickIn(room);
    expect(await room.isWalking()).toBe(true);
    await page.mouse.move(100, 50); // the first move after a lock can jump
    await room.step(0);
    expect(await room.camera()).toMatchObject(LOOKS_ALONG);
    await page.mouse.move(130, 40);
    await room.step(0);
    const { yaw, pitch, position } = await room.camera();
    expect(yaw).toBeCloseTo(-30 * 0.0022, 6);
    expect(pitch).toBeCloseTo(10 * 0.0022, 6);
    expect(position).toEqual(LOOKS_ALONG.position);
    await page.evaluate(() => document.exitPointerLock());
    await expect.poll(() => room.isWalking()).toBe(false);
    await page.mouse.move(60, 60);
    await page.keyboard.down("KeyW");
    await room.step(0.5);
    expect(await room.camera()).toMatchObject({ position, yaw, pitch });
    await page.keyboard.up("KeyW");

    await test.step("locked again by a click soon after it was freed", async () => {
      await clickIn(room);
      await page.evaluate(() => document.exitPointerLock());
      await expect.poll(() => room.isWalking()).toBe(false);
      await clickIn(room);
      expect(await room.isWalking()).toBe(true);
    });

    await test.step("where a click within puts the candle out, and lights it", async () => {
      for (const lit of [false, true]) {
        await page.mouse.click(80, 45);
        await room.step(0.1);
        expect(await room.evaluate((element) => element.lit)).toBe(lit);
      }
    });

    await test.step("and freed when the controls are taken away", async () => {
      await room.evaluate((element) => {
        element.controls = false;
      });
      await expect.poll(() => page.evaluate(() => document.pointerLockElement)).toBeNull();
      expect(await room.isWalking()).toBe(false);
    });
    expect(room.complaints).toEqual([]);
  });

  for (const leaving of ["looked elsewhere", "lost the controls"] as const) {
    test(`is free where the lock comes only after one has ${leaving}`, async ({ page }) => {
      const room = await openControls(page);
      const requests = await room.evaluate(async (element, leaving) => {
        const requests: string[] = [];
        const { requestPointerLock } = Element.prototype;
        /** Goes in, and leaves while the browser still thinks about this one of the two requests. */
        const leaveDuring = (asked: "raw" | "adjusted") =>
          new Promise<void>((resolve, reject) => {
            Element.prototype.requestPointerLock = function (options?: PointerLockOptions) {
              const kind = options?.unadjustedMovement ? "raw" : "adjusted";
              requests.push(kind);
              const locking =
                kind === "raw"
                  ? Promise.reject(new DOMException("refused", "NotSupportedError"))
                  : requestPointerLock.call(this);
              if (kind === asked) {
                if (leaving === "looked elsewhere") element.blur();
                else element.controls = false;
                locking.then(resolve, kind === "raw" ? () => setTimeout(resolve) : reject);
              }
              return locking;
            };
            element.controls = true;
            element.enter();
          });
        await leaveDuring("raw");
        await leaveDuring("adjusted");
        return requests;
      }, leaving);
      expect(requests).toEqual(["raw", "raw", "adjusted"]);
      await expect.poll(() => page.evaluate(() => document.pointerLockElement)).toBeNull();
      expect(await room.isWalking()).toBe(false);
      expect(room.complaints).toEqual([]);
    });
  }

  test("is locked with its speed adjusted, or drags to look, where the lock is refused", async ({
    page,
  }) => {
    const room = await openControls(page);
    await refusePointerLock(page, "NotSupportedError", true);
    await clickIn(room);
    expect(await lockRequests(page)).toEqual([true, false]);

    for (const { error, requests } of [
      { error: "NotSupportedError", requests: [true, false] },
      { error: "SecurityError", requests: [true] },
    ]) {
      await test.step(`with a ${error}`, async () => {
        await comeBack(room);
        await refusePointerLock(page, error);
        await page.mouse.click(80, 45);
        await expect.poll(() => lockRequests(page)).toEqual(requests);
        await page.mouse.move(20, 20); // no button, no lock
        await room.step(0);
        expect(await room.camera()).toMatchObject(LOOKS_ALONG);
        await page.mouse.down();
        await page.mouse.move(60, 40, { steps: 4 });
        await page.mouse.up();
        await room.step(0);
        const { yaw, pitch } = await room.camera();
        expect(yaw).toBeCloseTo(-40 * 0.0022, 6);
        expect(pitch).toBeCloseTo(-20 * 0.0022, 6);
        await page.keyboard.down("KeyQ");
        await room.step(0.1);
        expect((await room.camera()).yaw).toBeGreaterThan(yaw);
        await page.keyboard.up("KeyQ");
      });
    }
    expect(room.complaints).toEqual([]);
  });
});

test.describe("The keyboard", () => {
  test("alone enters, walks and leaves", async ({ page }) => {
    const room = await openControls(page);
    await page.keyboard.press("Tab");
    expect(await room.evaluate((element) => document.activeElement === element)).toBe(true);
    await page.keyboard.down("KeyW");
    await room.step(0.5);
    expect(await room.camera()).toMatchObject(LOOKS_ALONG); // not yet in
    await page.keyboard.up("KeyW");
    await page.keyboard.press("Enter");
    expect(await room.isWalking()).toBe(true);
    await page.keyboard.down("KeyW");
    await room.step(0.5);
    expect((await room.camera()).position[2]).toBeLessThan(2.5);
    await page.keyboard.press("Escape");
    await expect.poll(() => room.isWalking()).toBe(false);
    await room.step(1);
    const before = (await room.camera()).position[2];
    await room.step(1);
    expect((await room.camera()).position[2]).toBeCloseTo(before, 4);
  });

  test("scrolls the page until the room is entered, and walks from then on, while it has the focus", async ({
    page,
  }) => {
    const room = await openControls(page, { ...SMALL, after: `${TALL}<button>elsewhere</button>` });
    await room.evaluate((element) => element.focus());
    await expectKeyToScroll(page);
    expect((await room.camera()).position).toEqual(LOOKS_ALONG.position);
    await enterByKeyboard(room);
    const captured = await page.evaluateHandle(() => {
      const captured: boolean[] = [];
      addEventListener("keydown", (event) => captured.push(event.defaultPrevented));
      return captured;
    });
    await page.keyboard.down("ArrowDown");
    await room.step(0.2);
    await page.keyboard.up("ArrowDown");
    expect((await room.camera()).position[2]).toBeGreaterThan(LOOKS_ALONG.position[2]);
    expect(await captured.jsonValue()).toEqual([true]);

    await test.step("and lets go of every key when it leaves", async () => {
      await page.keyboard.down("KeyW");
      await room.step(0.2);
      await page.locator("button").focus();
      expect(await room.isWalking()).toBe(false);
      await room.step(1);
      const before = (await room.camera()).position[2];
      await enterByKeyboard(room); // W is down still, by the fingers' account
      await room.step(1);
      expect((await room.camera()).position[2]).toBeCloseTo(before, 4);
      await page.keyboard.up("KeyW");
    });
  });
});

test("What keys asked for while no frame ran is forgotten once the visitor leaves, or time begins anew", async ({
  room,
}) => {
  const { page } = room;
  await addControls(room);
  const isLit = () => room.evaluate((element) => element.lit);
  await enterByKeyboard(room);
  await page.keyboard.press("KeyE");
  await page.keyboard.press("Escape");
  await expect.poll(() => room.isWalking()).toBe(false);
  await room.step(0.1);
  expect(await isLit()).toBe(true);
  await enterByKeyboard(room);
  await page.keyboard.press("KeyE");
  await room.evaluate((element) => element.reset());
  await room.step(0.1);
  expect(await isLit()).toBe(true);
  await page.keyboard.press("KeyE");
  await room.step(0.1);
  expect(await isLit()).toBe(false);
});

test("A control in a slot has its keys to itself", async ({ room }) => {
  await addControls(room);
  const isPrevented = await room.evaluate((element) => {
    const button = document.createElement("button");
    button.slot = "error";
    element.append(button);
    const key = { code: "Enter", bubbles: true, composed: true, cancelable: true };
    const isPrevented = !button.dispatchEvent(new KeyboardEvent("keydown", key));
    button.remove();
    return isPrevented;
  });
  expect(isPrevented).toBe(false);
  expect(await room.isWalking()).toBe(false);
});

test("Either Enter walks in, and no other key", async ({ room }) => {
  const { page } = room;
  await addControls(room);
  await room.evaluate((element) => element.focus());
  await page.keyboard.press("KeyW");
  expect(await room.isWalking()).toBe(false);
  for (const key of ["Enter", "NumpadEnter"]) {
    await page.keyboard.press(key);
    expect(await room.isWalking(), key).toBe(true);
    await comeBack(room);
    await room.evaluate((element) => element.focus());
  }
});

test("Without controls nothing is captured: no key, no click, no focus", async ({ page }) => {
  await drawNothing(page);
  const room = await new RoomDriver(page).open({ look: "paper" }, { ...SMALL, after: TALL });
  const before = await room.camera();
  await page.mouse.click(80, 45);
  await room.evaluate((element) => {
    element.focus();
    element.enter();
  });
  await page.keyboard.press("Enter");
  for (const key of ["KeyW", "KeyQ", "KeyF", "ArrowDown"]) await page.keyboard.down(key);
  await page.mouse.move(20, 20);
  await room.step(1);
  expect(await room.camera()).toEqual(before);
  const state = await room.evaluate((element) => ({
    held: element.held,
    hasFocus: document.activeElement === element,
    tabindex: element.getAttribute("tabindex"),
    isLocked: document.pointerLockElement !== null,
  }));
  expect(state).toEqual({ held: true, hasFocus: false, tabindex: null, isLocked: false });
  await expectKeyToScroll(page);
});
