import { readFile } from "node:fs/promises";
import type { Locator, Page } from "playwright/test";
import type { CandleFlameElement } from "../../src/candle-flame-element.ts";
import { FEATURE_MEANINGS, INSPECTION_MEANINGS } from "../../src/page/meanings.ts";
import { featuresOf, INSPECTIONS, SETTINGS } from "../../src/settings.ts";
import { expect, PAGE, scaleType, test } from "../support/hosted-page.ts";
import { OPENING } from "../support/opening.ts";

// Dear, and each for itself: whichever worker is free takes the next.
test.describe.configure({ mode: "parallel" });

test("the page opens on a burning room, from any folder of a site", async ({ fresh }) => {
  const { page } = fresh;
  const folder = `${PAGE}some/folder/`;
  const requests: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  await page.addInitScript(() => {
    window.told = [];
    const note = () => {
      const sentence = document.querySelector(".threshold [role=status]")?.textContent ?? "";
      if (sentence !== window.told.at(-1)) window.told.push(sentence);
    };
    new MutationObserver(note).observe(document, { childList: true, subtree: true });
  });
  await fresh.load("", folder);

  await test.step("whose poster stays around the flame while the room is coarse, until one does something", async () => {
    const found = await fresh.evaluate(async (room) => {
      await room.ready;
      const held = document.querySelector(".held-poster");
      const before = [room.stats.quality, held?.className];
      dispatchEvent(new KeyboardEvent("keydown", { key: "Shift" }));
      return [...before, held?.className];
    });
    expect(found).toEqual(["low", "held-poster", "held-poster fading"]);
    await expect(page.locator(".held-poster")).toHaveCount(0);
  });
  await fresh.settle();

  await test.step("which says how much is there, then that it is being prepared", async () => {
    const told = await page.evaluate(() => window.told);
    expect(told.slice(0, 2)).toEqual(["", "Loading the room: 0 %"]);
    expect(told.slice(-2)).toEqual(["Preparing the light…", ""]);
    expect(told).not.toContain("Loading the room: 100 %");
  });

  await test.step("with one title and one way in", async () => {
    await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
    await expect(fresh.enter).toBeEnabled();
    const time = await fresh.evaluate((room) => room.currentTime);
    await expect.poll(() => fresh.evaluate((room) => room.currentTime)).toBeGreaterThan(time);
    expect(await fresh.evaluate((room) => room.stats.drawCalls)).toBeGreaterThan(0);
    expect(await fresh.evaluate((room) => room.look)).toBe("physical");
  });

  const poster = page.locator("candle-flame > picture");
  await test.step("whose poster gives way to the live picture", async () => {
    await expect(poster).toBeHidden();
    await expect(poster).toHaveCount(1);
  });

  await test.step("whose candle stands on the table, also in a link, until one walks in", async () => {
    const view = await fresh.evaluate(({ held, camera }) => ({ held, camera }));
    expect(view.held).toBe(false);
    await page.getByRole("button", { name: "Share" }).click();
    const hash = await page.evaluate(() => location.hash);
    // The view of its posters, and no setting but the test's own.
    const { camera, candle } = OPENING;
    const [from, at] = [camera, candle].map(({ position, yaw, pitch }) =>
      [...position, yaw, pitch].join("_"),
    );
    expect(hash).toBe(`#camera=${from}&candle=${at}&quality=low`);
    await fresh.enter.click();
    await expect.poll(() => fresh.evaluate((room) => room.held)).toBe(true);
    await fresh.evaluate((room) => room.blur());
    await expect(poster).toHaveCount(1);
    await fresh.evaluate((room) => {
      room.camera = { position: [1.5, 1.6, 0.5], yaw: 1 };
      location.hash = "";
    });
    await expect(poster, "the address of a view takes it away").toHaveCount(0);
    expect(await fresh.evaluate(({ held, camera }) => ({ held, camera }))).toEqual(view);
    await fresh.enter.click();
    await expect.poll(() => fresh.evaluate((room) => room.held), "as at first").toBe(true);
    await fresh.evaluate((room) => room.blur());
    await page.evaluate((hash) => {
      location.hash = hash;
    }, hash);
    await expect.poll(() => fresh.evaluate((room) => room.held)).toBe(false);
    expect(await fresh.evaluate((room) => room.camera)).toEqual(view.camera);
  });

  await fresh.evaluate((room) => room.pause());
  await test.step("fetches the lab when it is asked for, and closes it by keyboard", async () => {
    const isLab = (url: string) => /\/lab-[^/]*\.js$/.test(url);
    expect(requests.filter(isLab)).toEqual([]);
    const button = page.getByRole("button", { name: "Lab", exact: true });
    await button.evaluate((button: HTMLButtonElement) => {
      button.focus();
      for (const _ of ["a click", "and another, while the code is on its way"]) button.click();
    });
    await expect(fresh.lab).toBeVisible();
    expect(requests.filter(isLab)).toHaveLength(1);
    await expect(button).toHaveAttribute("aria-expanded", "true");
    await page.keyboard.press("Tab");
    await expect(fresh.lab.getByRole("button", { name: "Close the lab" })).toBeFocused();
    await page.keyboard.press("Escape");
    await expect(fresh.lab).toBeHidden();
    await expect(button).toBeFocused();
  });

  await test.step("and reads the light where pointer or keys point to", async () => {
    const meter = await fresh.openLab("Spot meter");
    const value = (name: string) =>
      meter
        .locator("dl > div")
        .filter({ hasText: new RegExp(`^${name}`) })
        .getByRole("definition");
    await expect(value("luminance")).toHaveText(/^[\d.,]+ cd\/m²$/);
    const spot = page.getByRole("application", { name: "Spot of the meter" });
    const stage = await fresh.room.boundingBox();
    if (!stage) throw new Error("no room");
    await page.mouse.move(stage.x + stage.width * 0.25, stage.y + stage.height * 0.5);
    await expect(spot).toHaveAttribute("style", /left: 25%/);
    await spot.focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Shift+ArrowDown");
    expect(await shortcutsTaken(spot)).toEqual([]);
    await expect(spot).toHaveAttribute("style", /left: 26%; top: 60%/);
    // Paused, the picture is the same: the meter must show what the element says of that spot.
    const luminance = await fresh.evaluate((room) => {
      const { width, height } = room.stats;
      const [x, y] = [Math.round(width * 0.26 - 2.5), Math.round(height * 0.6 - 2.5)];
      const light = room.readRadiance(x, y, 5, 5);
      const weights = [0.2126729, 0.7151522, 0.072175];
      return light.reduce((sum, channel, i) => sum + channel * (weights[i % 3] ?? 0), 0) / 25;
    });
    expect(luminance).toBeGreaterThan(0);
    const shown = Number.parseFloat((await value("luminance").innerText()).replace(",", ""));
    expect(Math.abs(shown / luminance - 1)).toBeLessThan(0.01);
    await meter.getByLabel("albedo").fill("1");
    const lux = Number.parseFloat((await value("illuminance").innerText()).replace(",", ""));
    expect(Math.abs(lux / (Math.PI * luminance) - 1)).toBeLessThan(0.01);
    const setPreparing = (preparing: boolean) =>
      fresh.room.evaluate((room: CandleFlameElement, preparing) => {
        const { stats } = room;
        if (preparing) Object.defineProperty(room, "stats", { get, configurable: true });
        else Reflect.deleteProperty(room, "stats");
        function get() {
          return { ...stats, preparing };
        }
      }, preparing);
    await setPreparing(true);
    await expect(value("luminance"), "nothing that would have to be compiled first").toHaveText(
      "–",
    );
    await setPreparing(false);
    await expect(value("luminance")).toHaveText(/cd/);
    await expect(value("chromaticity")).toHaveText(/^x 0\.\d{3}, y 0\.\d{3}$/);
    await expect(value("temperature")).toHaveText(/^1\d{3} K$/);
    await meter.locator("summary").click();
    await expect(spot).toHaveCount(0);
  });

  await test.step("shows what its passes leave, by keyboard, and the picture again at the end", async () => {
    const passes = await fresh.openSection("Passes");
    const list = passes.getByLabel("Show");
    await expect(list.getByRole("option")).toHaveText(
      INSPECTIONS.map((name) => name.replace("-", " ")),
    );
    await list.focus();
    await page.keyboard.press("End");
    expect(await fresh.evaluate((room) => room.inspect)).toBe("temperature");
    await expect(passes.getByRole("status")).toHaveText(INSPECTION_MEANINGS.temperature);
  });

  await test.step("and plots the flame's light and its spectrum", async () => {
    const plot = await fresh.openSection("The flame's light");
    await expect(plot.getByText(/^[\d.]+ cd now; .* lately\. 1\d{3} K\.$/)).toBeVisible();
    const points = () => plot.locator(".course polyline").getAttribute("points");
    const once = await points();
    await fresh.evaluate((room) => room.step(0.5));
    await expect.poll(points).not.toBe(once);
    await expect(plot.locator(".spectrum polyline")).toHaveAttribute("points", /^0\.0,.* 400\.0,/);
    await page.keyboard.press("Escape");
    await expect(fresh.lab).toBeHidden();
    expect(await fresh.evaluate((room) => room.inspect)).toBe("picture");
  });

  await test.step("and says that the candle is out, whatever else there is to say", async () => {
    await fresh.evaluate((room) => {
      room.extinguish();
      room.take();
      room.camera = { ...room.camera, pitch: 1.4 };
      room.place();
    });
    await expect(page.getByText("The candle is out.")).toHaveText(
      /^The candle cannot stand there: nothing is within reach\. The candle is out/,
    );
  });

  await test.step("and opens a link to another look as a fresh page does", async () => {
    await page.evaluate(() => {
      // In a corner that the cabin does not have.
      location.hash = "#look=paper&camera=4_1.6_4_0.5_-0.1&candle=3.5_1.6_3.5_0.5_-0.5";
    });
    const seen = () => fresh.evaluate(({ held, camera }) => [held, ...camera.position, camera.yaw]);
    await expect.poll(seen).toEqual([false, 4, 1.6, 4, 0.5]);
    await page.getByRole("button", { name: "Lab", exact: true }).click();
    const course = fresh.lab.locator(".course polyline");
    await expect(course, "one sample in its own unit").toHaveAttribute("points", /^\S+$/);
  });

  const foreign = requests.filter((url) => !url.startsWith(folder) && !url.startsWith("blob:"));
  expect(foreign).toEqual([]);
});

test("walking hides everything but the room, until the visitor leaves it", async ({ hosted }) => {
  const { page } = hosted;
  await hosted.enter.click();
  await expect.poll(() => hosted.isWalking()).toBe(true);
  await expect
    .poll(() => hosted.evaluate((room) => room.ownerDocument.pointerLockElement === room))
    .toBe(true);
  await expect(page.getByRole("heading", { level: 1 })).toBeHidden();
  await expect(page.getByRole("button")).toHaveCount(0);
  await page.keyboard.press("Escape");
  await expect.poll(() => hosted.isWalking()).toBe(false);
  await expect(hosted.enter).toBeVisible();
  await hosted.enter.click();
  await expect.poll(() => hosted.isWalking()).toBe(true);
  await page.keyboard.press("Tab");
  await expect.poll(() => hosted.isWalking()).toBe(false);
  await expect(page.getByRole("button", { name: "Help" }), "the next control").toBeFocused();
});

test("a finger on a machine with a mouse taps to come back", async ({ hosted }) => {
  const { page } = hosted;
  expect(await page.evaluate(() => matchMedia("(hover: hover)").matches)).toBe(true);
  const devtools = await page.context().newCDPSession(page);
  const tap = async (button: Locator) => {
    await expect(button).toBeVisible();
    const box = await button.boundingBox();
    if (!box) throw new Error("nothing to tap");
    const touchPoints = [{ x: box.x + box.width / 2, y: box.y + box.height / 2 }];
    await devtools.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints });
    await devtools.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  };
  const leave = page.getByRole("button", { name: "Come back" });
  await tap(hosted.enter);
  await expect.poll(() => hosted.isWalking()).toBe(true);
  await tap(leave);
  await expect.poll(() => hosted.isWalking()).toBe(false);
  await expect(hosted.enter).toBeFocused();
  await hosted.enter.click();
  await expect.poll(() => hosted.isWalking()).toBe(true);
  await expect(leave, "a mouse is locked").toBeHidden();
  await page.keyboard.press("Escape");
  await expect.poll(() => hosted.isWalking()).toBe(false);
  await devtools.detach();
});

test("a gamepad's A walks in, wherever the focus is on the way in", async ({ hosted }) => {
  const { page } = hosted;
  const hold = (button: number | null) =>
    page.evaluate((button) => {
      const buttons = Array.from({ length: 17 }, (_, i) => ({ pressed: i === button }));
      const pad = { mapping: "standard", axes: [0, 0, 0, 0], buttons };
      navigator.getGamepads = () => [pad] as unknown as Gamepad[];
      dispatchEvent(new Event("gamepadconnected"));
    }, button);
  const [a, b] = [0, 1];
  for (const focus of ["on the page", "on the button"]) {
    await hosted.evaluate((room) => room.blur());
    if (focus === "on the button") await hosted.enter.focus();
    await hold(a);
    await expect.poll(() => hosted.isWalking(), focus).toBe(true);
    await expect(hosted.room.getByText("Left stick walks")).toBeVisible();
    await hold(null);
    await page.evaluate(() => new Promise(requestAnimationFrame));
    await hold(b);
    await expect.poll(() => hosted.isWalking()).toBe(false);
  }
  await hosted.evaluate((room) => room.blur());
  await page.getByRole("button", { name: "Share" }).focus();
  await hold(a);
  for (let frame = 0; frame < 3; frame++) {
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  expect(await hosted.isWalking(), "that is another control's").toBe(false);
  await page.evaluate(() => void Reflect.deleteProperty(navigator, "getGamepads"));
});

test("a candle that is taken up on entering leaves the controls in sight", async ({ hosted }) => {
  await hosted.evaluate((room) => {
    room.place();
    room.addEventListener("enter", () => room.take(), { once: true });
  });
  await hosted.enter.click();
  await expect.poll(() => hosted.evaluate(({ held }) => held)).toBe(true);
  await expect(hosted.room.getByText("walk, the mouse looks")).toBeVisible();
});

test("a candle out of reach is said to be, if one would take it up", async ({ hosted }) => {
  await hosted.evaluate((room) => {
    room.place();
    const [x, y, z] = room.flame?.position ?? [0, 0, 0];
    room.camera = { position: [x < 0 ? x + 2.5 : x - 2.5, y, z] };
    room.take();
  });
  await expect(
    hosted.page.getByText("The candle cannot be taken up: it is out of reach."),
  ).toBeVisible();
});

test("the page says that the room is loading as soon as it is", async ({ fresh }) => {
  const { page } = fresh;
  await page.route(/\.glb$/, () => {}); // on its way for ever
  await fresh.load();
  await expect(page.getByText("Loading the room: 0 %")).toBeVisible();
});

test("the page handles no key while the visitor walks, with the lab open", async ({ hosted }) => {
  const { page } = hosted;
  await hosted.openLab("Settings");
  const meter = await hosted.openSection("Spot meter");
  await hosted.enter.click();
  await expect.poll(() => hosted.isWalking()).toBe(true);
  await expect(hosted.lab).toBeHidden();
  await hosted.evaluate((room) => {
    room.readRadiance = () => {
      throw new Error("Nobody sees the meter.");
    };
  });
  const before = await hosted.evaluate((room) => room.camera.position[2]);
  await page.keyboard.press("?");
  await page.keyboard.down("w");
  await expect
    .poll(() => hosted.evaluate((room) => room.camera.position[2]))
    .toBeLessThan(before - 0.8); // longer than from one reading of the meter to the next
  await page.keyboard.up("w");
  await hosted.evaluate((room) => void Reflect.deleteProperty(room, "readRadiance"));
  await expect(page.getByRole("dialog")).toBeHidden();
  await page.keyboard.press("Escape");
  await expect(hosted.lab).toBeVisible();
  await meter.locator("summary").click();
});

test("help lists the controls, and opens and closes by keyboard", async ({ hosted }) => {
  const { page } = hosted;
  const button = page.getByRole("button", { name: "Help" });
  await button.focus();
  await page.keyboard.press("Enter");
  const help = page.getByRole("dialog", { name: "In the room" });
  await expect(help).toBeVisible();
  const title = help.getByRole("heading", { level: 2 });
  await expect(title).toBeFocused();
  await expect(title, "which is no control").toHaveCSS("outline-style", "none");
  await expect(title).toHaveCSS("box-shadow", "none");
  await expect(help.getByRole("heading", { level: 3 })).toHaveText([
    "Keyboard",
    "Mouse",
    "Touch",
    "Gamepad",
  ]);
  const keys = "Enter|Esc|W|A|S|D|Shift|Q|R|Home|End|Page Up|Page Down|E|B|F|A|B|X|Y";
  await expect(help.locator("kbd")).toHaveText(keys.split("|"));
  const links = await help
    .getByRole("link")
    .evaluateAll((all: HTMLAnchorElement[]) => all.map(({ href }) => href));
  expect(links).toEqual([`${PAGE}how.html`, `${PAGE}use.html`]);
  await page.keyboard.press("Escape");
  await expect(help).toBeHidden();
  await expect(button).toBeFocused();
});

test("dialogs open at their top in low windows too, wherever they were left", async ({
  hosted,
}) => {
  const { page } = hosted;
  for (const [width, height] of [
    [480, 270],
    [320, 256],
    [640, 360],
  ] as const) {
    await page.setViewportSize({ width, height });
    for (const name of ["Help", "Settings"]) {
      await page.getByRole("button", { name }).click();
      const dialog = page.getByRole("dialog");
      await expect(dialog.getByRole("heading", { level: 2 })).toBeFocused();
      expect(await dialog.evaluate(({ scrollTop }) => scrollTop), `${name}, ${width}`).toBe(0);
      await dialog.evaluate((dialog) => dialog.scrollBy(0, 200));
      await page.keyboard.press("Escape");
      await expect(dialog).toBeHidden();
    }
  }
});

test("axe finds nothing, wherever the visitor is", async ({ hosted }) => {
  const { page } = hosted;
  const dialogs = [
    ["Help", "In the room"],
    ["Settings", "Settings"],
  ] as const;
  await hosted.evaluate((room) => room.pause());
  expect(await hosted.axe(), "at the start").toEqual([]);
  for (const [button, dialog] of dialogs) {
    await page.getByRole("button", { name: button }).click();
    await expect(page.getByRole("dialog", { name: dialog })).toBeVisible();
    expect(await hosted.axe(), dialog).toEqual([]);
    await page.keyboard.press("Escape");
  }
  await hosted.enter.click();
  await expect.poll(() => hosted.isWalking()).toBe(true);
  await expect(page.getByRole("heading", { level: 1 })).toBeHidden();
  expect(await hosted.axe(), "walking").toEqual([]);
  await page.keyboard.press("Escape");

  await hosted.openLab("What each technique costs");
  for (const title of ["Techniques", "Settings", "The last frame", "Spot meter"]) {
    await hosted.openSection(title);
  }
  const comparison = await hosted.openSection("Before and after");
  await expect(page.getByRole("application", { name: "Spot of the meter" })).toBeVisible();
  expect(await hosted.axe(), "in the lab").toEqual([]);
  await comparison.getByRole("button", { name: "Compare" }).click();
  const divider = page.getByRole("slider", { name: "Divider" });
  await expect(divider).toBeVisible();
  expect(await hosted.axe(), "comparing").toEqual([]);
  await divider.press("Escape");
});

test("blowing at the microphone blows, while the visitor lets it", async ({ hosted }) => {
  const { page } = hosted;
  const heard = () => page.evaluate(() => window.heard);
  await hosted.evaluate((room) => {
    window.heard = [];
    room.blow = (strength) => void window.heard.push(strength ?? 1);
    navigator.mediaDevices.getUserMedia = () =>
      Promise.reject(new DOMException("", "NotAllowedError"));
  });
  await page.getByRole("button", { name: "Settings" }).click();
  const button = page.getByRole("button", { name: "Blow with your breath" });
  const settings = page.getByRole("dialog", { name: "Settings" });
  await button.click();
  await expect(settings.getByText("keeps the microphone from this page")).toBeVisible();
  await expect(button).toHaveAttribute("aria-pressed", "false");

  // A rumble at 60 Hz is as low and as loud as a breath.
  await page.evaluate(() => {
    navigator.mediaDevices.getUserMedia = async ({ audio } = {}) => {
      window.filters = audio;
      await new Promise((resolve) => setTimeout(resolve, 100)); // the browser asks first
      const context = new AudioContext();
      const breath = new OscillatorNode(context, { frequency: 60 });
      const microphone = context.createMediaStreamDestination();
      breath.connect(microphone);
      breath.start();
      window.microphone = microphone.stream;
      return microphone.stream;
    };
  });
  await button.press("Enter");
  await expect(button).toHaveAttribute("aria-pressed", "true");
  await expect(button).toBeFocused();
  const filters = await page.evaluate(() => window.filters);
  expect(filters, "wind is no noise here").toEqual({
    echoCancellation: false,
    noiseSuppression: false,
    autoGainControl: false,
  });
  await expect.poll(async () => Math.max(...(await heard()))).toBe(1);
  const isOn = () =>
    page.evaluate(() => window.microphone.getTracks().some((track) => track.readyState === "live"));
  expect(await isOn()).toBe(true);
  await button.click();
  await expect(button).toHaveAttribute("aria-pressed", "false");
  expect(await isOn()).toBe(false);

  await button.click();
  await expect(button).toHaveAttribute("aria-pressed", "true");
  await page.evaluate(() => {
    Object.defineProperty(document, "hidden", { configurable: true, value: true });
    document.dispatchEvent(new Event("visibilitychange"));
    Reflect.deleteProperty(document, "hidden");
  });
  await expect(settings.getByText("switched off when you left")).toBeVisible();
  expect(await isOn()).toBe(false);

  await button.click();
  await expect(button).toHaveAttribute("aria-pressed", "true");
  await page.evaluate(() => {
    for (const track of window.microphone.getTracks()) track.dispatchEvent(new Event("ended"));
  });
  await expect(settings.getByText("The microphone was switched off.")).toBeVisible();
  await expect(button).toHaveAttribute("aria-pressed", "false");
  await hosted.evaluate((room) => void Reflect.deleteProperty(room, "blow"));
});

test.describe("what one sees", () => {
  test.use({ viewport: { width: 320, height: 180 }, permissions: ["clipboard-write"] });

  test("can be shared, kept, and set", async ({ fresh }) => {
    const { page } = fresh;
    await fresh.load("");
    // A first link, without a camera, that another replaces while the room is on its way.
    await page.evaluate(() => {
      location.hash = "#lit-wicks=1";
    });
    await expect.poll(() => fresh.evaluate((room) => room.lit)).toBe(false);
    await page.evaluate(() => {
      location.hash =
        "#look=paper&seed=7&camera=-1_0_1_0.5_-0.1&candle=-1_0_1_0.5_-0.5&exposure=%&src=elsewhere.glb";
    });
    await fresh.settle();
    const seen = () =>
      fresh.evaluate(({ look, seed, exposure, src, camera, wick, lit, held }) => {
        const { yaw, pitch } = camera;
        return { look, seed, exposure, src, wick, lit, held, yaw, pitch };
      });
    const shared = {
      look: "paper",
      seed: 7,
      exposure: 0,
      src: "",
      wick: 2,
      lit: true,
      held: false,
      yaw: 0.5,
      pitch: -0.1,
    };
    expect(await seen()).toEqual(shared);

    await test.step("with its candle where the link says, also when one walks in", async () => {
      await fresh.enter.click();
      await expect.poll(() => fresh.isWalking()).toBe(true);
      expect(await seen()).toEqual(shared);
      await fresh.evaluate((room) => room.blur());
    });

    await fresh.evaluate((room) => room.pause());

    await test.step("settings act at once", async () => {
      await page.getByRole("button", { name: "Settings" }).click();
      const settings = page.getByRole("dialog", { name: "Settings" });
      await settings.getByLabel("exposure").fill("-1.5");
      await settings.getByLabel("motion").selectOption("reduced");
      await settings.getByLabel("sensitivity").fill("2");
      await settings.getByLabel("wind", { exact: true }).fill("0.35");
      await settings.getByLabel("wind direction").fill("-90");
      await settings.getByLabel("gustiness").fill("0.8");
      await settings.getByLabel("wick").fill("10");
      await expect(settings.getByText("10 mm")).toBeVisible();
      await expect(settings.getByText("10 mm")).toHaveAttribute("aria-live", "off");
      await expect(settings.getByLabel("wick")).toHaveAttribute("aria-valuetext", "10 mm");
      await expect(settings.getByLabel("wind direction")).toHaveAttribute("aria-valuetext", "-90°");
      expect(
        await fresh.evaluate(({ exposure, motion, sensitivity, quality }) => {
          return { exposure, motion, sensitivity, quality };
        }),
      ).toEqual({ exposure: -1.5, motion: "reduced", sensitivity: 2, quality: "low" });
      expect(
        await fresh.evaluate(({ wind, windDirection, gustiness, wick }) => {
          return { wind, windDirection, gustiness, wick };
        }),
      ).toEqual({ wind: 0.35, windDirection: -90, gustiness: 0.8, wick: 10 });
      await expect(settings.getByLabel("quality")).toHaveValue("low");
      await page.keyboard.press("Escape");
      await expect(settings).toBeHidden();
    });

    await test.step("a photo is a PNG file", async () => {
      const downloading = page.waitForEvent("download");
      await page.getByRole("button", { name: "Photo" }).click();
      const download = await downloading;
      expect(download.suggestedFilename()).toBe("candle-flame.png");
      const bytes = await readFile(await download.path());
      expect(bytes.subarray(1, 4).toString()).toBe("PNG");
    });

    await test.step("the link is copied, or shown where that is refused", async () => {
      await fresh.evaluate((room) => room.extinguish());
      const share = page.getByRole("button", { name: "Share" });
      await share.click();
      await expect(page.getByText("The link is copied.")).toBeVisible();
      const { href, hash } = await page.evaluate(() => ({ ...location }));
      expect(hash).toMatch(
        /^#camera=[-\d._]+&candle=[-\d._]+&look=paper&seed=7&quality=low&exposure=-1\.5&/,
      );
      expect(hash).toMatch(/&wind=0\.35&wind-direction=-90&gustiness=0\.8&wick=10&unlit=$/);
      await page.evaluate(() => {
        navigator.clipboard.writeText = () => Promise.reject(new Error("refused"));
      });
      const link = page.getByLabel("Link to what you see");
      const label = page.getByRole("status").getByText("Copy this link.");
      const leave = [
        () => page.keyboard.press("Escape"),
        () => page.getByRole("button", { name: "Lab", exact: true }).focus(),
        () => fresh.evaluate((room) => room.focus()),
      ];
      for (const go of leave) {
        await share.click();
        await expect(link).toHaveValue(href);
        await expect(link).toBeFocused();
        await expect(label).toBeVisible();
        await go();
        await expect(link, "until one turns to something else").toBeHidden();
        await expect(label).toBeHidden();
      }
      await share.click();
      await expect(link).toBeVisible();
    });

    await test.step("another link in the same tab is followed", async () => {
      await page.evaluate(() => {
        location.hash = "#look=paper&camera=0_0_0_1_0";
      });
      const next = { ...shared, seed: 1, held: true, yaw: 1, pitch: 0 };
      await expect.poll(seen).toEqual(next);
      await expect(page.getByLabel("Link to what you see")).toBeHidden();
      await page.evaluate(() => {
        location.hash = "#look=paper&camera=0_0_0_1_0&wick=8&unlit=";
      });
      await expect.poll(seen).toEqual({ ...next, wick: 8, lit: false });
    });

    const status = page.locator(".threshold [role=status]");
    await test.step("a photo that cannot be taken is answered with a sentence", async () => {
      await fresh.evaluate((room) => {
        room.toBlob = () => Promise.reject(new Error("lost"));
      });
      await page.getByRole("button", { name: "Photo" }).click();
      await expect(page.getByText("There is no image at the moment.")).toBeVisible();
    });

    await test.step("a look that is chosen and taken back leaves no word of its loading", async () => {
      await fresh.evaluate((room) => {
        room.look = "physical";
        const region = document.querySelector(".threshold [role=status]");
        const nodes = [0.3, 0.31].map((totalProgress) => {
          room.dispatchEvent(new CustomEvent("progress", { detail: { totalProgress } }));
          return region?.firstChild;
        });
        if (nodes[0] !== nodes[1]) throw new Error("One sentence is read aloud twice.");
      });
      await fresh.evaluate((room) => {
        room.look = "paper";
      });
      await expect(status).toHaveText("");
    });

    await test.step("and one that cannot be fetched leaves the room as it is, and can be chosen again", async () => {
      let requests = 0;
      await page.route("**/*.glb", (route) => {
        if (route.request().url().endsWith("cabin.glb")) requests++;
        return route.fulfill({ body: "no model" });
      });
      const settings = await fresh.openLab("Settings");
      const look = settings.getByLabel("look");
      const notice = page.locator(".notice");
      for (const attempt of [1, 2]) {
        await look.selectOption("physical");
        await expect(notice).toHaveText(/cabin\.glb.*\. The look stays paper\.$/);
        await expect(look, "what is drawn").toHaveValue("paper");
        expect(await fresh.evaluate((room) => room.look)).toBe("paper");
        expect(requests).toBe(attempt);
        await notice.evaluate((notice) => notice.replaceChildren());
      }
      await expect(fresh.enter).toBeVisible();
      await expect(status).toHaveText("");
      await fresh.lab.getByRole("button", { name: "Close the lab" }).click();
    });

    await test.step("a context that comes back late opens the room again", async () => {
      await fresh.evaluate((room) => {
        const detail = { type: "context-lost", message: "", cause: null };
        room.dispatchEvent(new CustomEvent("error", { detail }));
      });
      await expect(fresh.enter).toBeHidden();
      await fresh.evaluate((room) => void room.dispatchEvent(new CustomEvent("contextrestored")));
      await expect(fresh.enter).toBeVisible();
    });

    await test.step("a link to the original says nothing of its candle, which nobody puts down", async () => {
      await page.unroute("**/*.glb");
      await fresh.evaluate((room) => {
        room.look = "original";
        return new Promise<unknown>((resolve) => {
          room.addEventListener("load", resolve, { once: true });
        });
      });
      await page.getByRole("button", { name: "Share" }).click();
      await expect
        .poll(() => page.evaluate(() => location.hash))
        .toMatch(/^#camera=[-\d._]+&look=original&/);
    });

    await test.step("the whole screen shows it", async () => {
      const button = page.getByRole("button", { name: "Full screen" });
      await button.click();
      await expect(button).toHaveAttribute("aria-pressed", "true");
      await button.click();
      await expect(button).toHaveAttribute("aria-pressed", "false");
    });
  });
});

test.describe("the ladder", () => {
  test("has five measured rungs beside the paper's, and leaves no trace", async ({ hosted }) => {
    await hosted.evaluate((room) => {
      room.look = "original";
      room.features.drift = false;
      room.features.candle = false;
    });
    const state = () =>
      hosted.evaluate(({ features, look, paused }) => ({ ...features, look, paused }));
    const before = await state();
    const ladder = await hosted.openLab("What each technique costs");
    await ladder.getByLabel("Rounds").fill("1");
    await ladder.getByRole("button", { name: "Measure" }).click();
    await expect(ladder.getByRole("status")).toContainText("1 round of");

    const rows = ladder.getByRole("row").filter({ has: hosted.page.getByRole("rowheader") });
    const rungs = (await rows.allInnerTexts()).map((text) => text.split(/\t|\n/));
    expect(rungs.map(([name]) => name)).toEqual([
      "no particles",
      "+ basic emission",
      "+ gradient shading",
      "+ attenuation",
      "+ drift",
    ]);
    expect(rungs.map((rung) => rung.slice(4).map(Number))).toEqual([
      [2.1, 475, 1],
      [4.5, 222, 2.14],
      [5.2, 192, 2.48],
      [6.7, 149, 3.19],
      [7.5, 133, 3.57],
    ]);
    const baseline = rangeOf(rungs[0]?.[1]);
    for (const [, ...cells] of rungs) {
      const [milliseconds, framesPerSecond, multiple] = cells.map(rangeOf) as [Range, Range, Range];
      expect(milliseconds.least).toBeGreaterThan(0);
      expect(framesPerSecond.least).toBeLessThanOrEqual(1000 / milliseconds.least);
      expect(framesPerSecond.most).toBeGreaterThanOrEqual(1000 / milliseconds.most);
      expect(multiple.least).toBeLessThanOrEqual(milliseconds.most / baseline.least);
      expect(multiple.most).toBeGreaterThanOrEqual(milliseconds.least / baseline.most);
    }
    expect(await state()).toEqual(before);
  });

  test("leaves a room with other models, its visitor and its candles where they were", async ({
    hosted,
  }) => {
    await hosted.evaluate(async (room) => {
      room.look = "physical";
      await room.ready;
      room.pause();
      room.step(1);
      room.place();
      room.camera = { position: [0.4, 1.5, 0.9], yaw: 0.8, pitch: -0.2, fieldOfView: 1 };
      for (const candle of room.candles) candle.lit = !candle.lit;
      document.body.dataset.loads = "0";
      room.addEventListener("load", () => {
        document.body.dataset.loads = "more";
      });
    });
    const state = () =>
      hosted.evaluate(({ look, camera, held, flame, candles, currentTime, paused }) => {
        const lit = candles.map((candle) => candle.lit);
        const { loads } = document.body.dataset;
        return { look, camera, held, place: flame?.position, lit, currentTime, paused, loads };
      });
    const before = await state();
    expect([before.held, before.lit.includes(false)]).toEqual([false, true]);
    const ladder = await hosted.openLab("What each technique costs");
    const rounds = ladder.getByLabel("Rounds");
    await rounds.fill("1");
    await rounds.press("Enter");
    await expect(ladder.getByRole("status")).toContainText("1 round of");
    expect(await state()).toEqual(before);

    await test.step("also when it is stopped as one walks in", async () => {
      await rounds.fill("99");
      await rounds.press("Enter");
      await expect(hosted.page.locator("candle-flame")).toHaveCount(2);
      await hosted.evaluate((room) => void room.dispatchEvent(new CustomEvent("enter")));
      await expect(ladder.getByRole("status")).toHaveText("Stopped before the end.");
      await expect(hosted.page.locator("candle-flame")).toHaveCount(1);
      expect(await state()).toEqual(before);
    });
  });

  test("can be left half way, and the flame burns on as before", async ({ hosted }) => {
    const ladder = await hosted.openLab("What each technique costs");
    const rounds = ladder.getByLabel("Rounds");
    await rounds.fill("99");
    await rounds.press("Enter");
    await expect.poll(() => ladder.getByRole("progressbar").evaluate(shareOf)).toBeGreaterThan(0);
    await expect(rounds).toBeFocused();
    expect(await hosted.evaluate((room) => room.paused)).toBe(true);
    await ladder.getByRole("button", { name: "Stop" }).click();
    await expect(ladder.getByRole("status")).toHaveText("Stopped before the end.");
    expect(await hosted.evaluate((room) => room.paused)).toBe(false);
    await ladder.getByRole("button", { name: "Measure" }).click();
    await hosted.evaluate((room) => {
      const detail = { type: "asset", message: "The models are gone.", cause: null };
      room.dispatchEvent(new CustomEvent("error", { detail }));
    });
    await expect(ladder.getByRole("status")).toHaveText("The models are gone.");
    await hosted.evaluate((room) => {
      Object.defineProperty(room, "ready", { configurable: true, value: new Promise(() => {}) });
    });
    await ladder.getByRole("button", { name: "Measure" }).click();
    await ladder.getByRole("button", { name: "Stop" }).click();
    await expect(ladder.getByRole("status"), "without a room").toHaveText(
      "Stopped before the end.",
    );
    await hosted.evaluate((room) => void Reflect.deleteProperty(room, "ready"));
    const features = await hosted.evaluate((room) => ({ ...room.features }));
    expect(Object.values(features)).not.toContain(false);
  });
});

test("the comparison shows two looks from one place at one time, while it is open", async ({
  hosted,
}) => {
  const { page } = hosted;
  const section = await hosted.openLab("Before and after");
  await hosted.evaluate((room) => {
    room.step(3);
    room.place();
  });
  await section.getByRole("button", { name: "Compare" }).click();
  const divider = page.getByRole("slider", { name: "Divider between the two looks" });
  await expect(divider).toBeVisible();
  await divider.focus();
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowRight");
  await expect(divider, "nothing over the picture but its line").toHaveCSS("box-shadow", "none");
  // The candle of the original stands amid its room for good.
  const amid = "0.0 0.0";
  const both = () =>
    page.locator("candle-flame").evaluateAll((rooms: CandleFlameElement[]) =>
      rooms.map(({ look, camera, currentTime, paused, seed, held, flame }) => {
        const [x, , z] = flame?.position ?? [];
        const stands = held ? "in the hand" : `${x?.toFixed(1)} ${z?.toFixed(1)}`;
        return { look, camera, currentTime, paused, seed, stands };
      }),
    );
  const [here, there] = await both();
  expect(here?.stands).not.toEqual(amid);
  expect(there).toEqual({ ...here, look: "original", stands: amid });
  expect(here?.currentTime).toBeGreaterThan(3);
  const looks = (await both()).map(({ look }) => look);
  expect(looks).toEqual(["paper", "original"]);
  await expect(divider).toHaveText("originalpaper");

  await test.step("step by step, wherever the visitor goes and whatever is set", async () => {
    await hosted.evaluate((room) => {
      room.camera = { position: [-2, 1.6, 1], yaw: 0.7, pitch: -0.3 };
      room.seed = 7;
      room.camera = { position: [-2, 1.6, 1], yaw: 0.7, pitch: -0.3 };
    });
    await expect.poll(async () => (await both())[0]?.currentTime).toBeGreaterThan(0.1);
    const [first, second] = await both();
    expect(first?.stands).toBe("in the hand");
    expect(second).toEqual({ ...first, look: "original", stands: amid });
    expect(first?.camera.yaw).toBeCloseTo(0.7);
    expect(first?.paused).toBe(true);
  });

  await test.step("with a divider for keys and pointer", async () => {
    await divider.focus();
    await page.keyboard.press("ArrowLeft");
    expect(await shortcutsTaken(divider)).toEqual([]);
    await expect(divider).toHaveAttribute("aria-valuenow", "48");
    await page.keyboard.press("End");
    await expect(divider).toHaveAttribute("aria-valuenow", "100");
    await page.keyboard.press("Home");
    await expect(divider).toHaveAttribute("aria-valuenow", "0");
    await page.keyboard.press("PageUp");
    await expect(divider).toHaveAttribute("aria-valuenow", "10");
    const stage = await hosted.room.boundingBox();
    const line = await divider.boundingBox();
    if (!stage || !line) throw new Error("nothing to drag");
    const y = line.y + line.height - 5; // below all buttons
    await page.mouse.move(line.x + line.width / 2, y);
    await page.mouse.down();
    await page.mouse.move(stage.x + stage.width * 0.75, y, { steps: 3 });
    await page.mouse.up();
    await expect(divider).toHaveAttribute("aria-valuenow", "75");
    const clip = await page
      .locator("candle-flame.second")
      .evaluate((second) => getComputedStyle(second).clipPath);
    expect(clip).toMatch(/^inset\(0px (calc\(25|25)/);
  });

  await test.step("with a spot meter for what is seen under it", async () => {
    await page.locator("candle-flame").evaluateAll((rooms: CandleFlameElement[]) => {
      for (const room of rooms) {
        room.readRadiance = (...box) => {
          document.body.dataset.read = room.look;
          return Object.getPrototypeOf(room).readRadiance.apply(room, box);
        };
      }
    });
    const meter = await hosted.openSection("Spot meter");
    const { x, y, width } = (await hosted.room.boundingBox()) ?? { x: 0, y: 0, width: 0 };
    for (const [share, look] of [
      [0.5, "original"],
      [0.9, "paper"],
    ] as const) {
      await page.mouse.move(x + width * share, y + 20);
      await expect(page.locator("body")).toHaveAttribute("data-read", look);
    }
    await hosted.evaluate((room) => void Reflect.deleteProperty(room, "readRadiance"));
    await meter.locator("summary").click();
  });

  await test.step("and a photo of both, cut where they are", async () => {
    await page.locator("candle-flame").evaluateAll((rooms: CandleFlameElement[]) => {
      for (const room of rooms) {
        const color = room.look === "original" ? "red" : "blue";
        room.toBlob = () => {
          const canvas = new OffscreenCanvas(room.stats.width, room.stats.height);
          const context = canvas.getContext("2d");
          if (context) context.fillStyle = color;
          context?.fillRect(0, 0, canvas.width, canvas.height);
          return canvas.convertToBlob();
        };
      }
    });
    const downloading = page.waitForEvent("download");
    await page.getByRole("button", { name: "Photo" }).evaluate((one: HTMLElement) => one.click());
    const file = await readFile(await (await downloading).path());
    const seen = await page.evaluate(async (source) => {
      const bytes = Uint8Array.from(atob(source), (character) => character.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext("2d");
      context?.drawImage(image, 0, 0);
      const at = (share: number) => {
        const [x, y] = [share * image.width, image.height - 1].map(Math.floor);
        return [...(context?.getImageData(x ?? 0, y ?? 0, 1, 1).data ?? [])].join();
      };
      return [at(0), at(0.73), at(0.77), at(0.99)];
    }, file.toString("base64"));
    const [red, blue] = ["255,0,0,255", "0,0,255,255"];
    expect(seen).toEqual([red, red, blue, blue]);
    await hosted.evaluate((room) => void Reflect.deleteProperty(room, "toBlob"));
  });

  await test.step("to the end, also if the second room loads other models meanwhile", async () => {
    await page.locator("candle-flame.second").dispatchEvent("load");
    await hosted.lab.getByRole("button", { name: "Close the lab" }).click();
    const share = page.getByRole("button", { name: "Share" });
    await share.evaluate((button) => {
      const { left, width } = button.getBoundingClientRect();
      document
        .querySelector<HTMLElement>(".stage")
        ?.style.setProperty("--divider", `${left + width / 2}px`);
    });
    await share.click({ trial: true }); // the divider below it is in nobody's way
    await divider.press("Escape");
    await expect(page.getByRole("button", { name: "Lab", exact: true })).toBeFocused();
    await expect(page.locator("candle-flame")).toHaveCount(1);
    await expect(divider).toBeHidden();
    expect(await hosted.evaluate((room) => room.paused)).toBe(false);
  });
});

test("techniques and settings change the room at once, and the numbers follow", async ({
  hosted,
}) => {
  const techniques = await hosted.openLab("Techniques");
  const shown = await techniques
    .getByRole("checkbox")
    .evaluateAll((boxes: HTMLInputElement[]) =>
      boxes.map(({ name, labels }) => [name, labels?.[0]?.textContent]),
    );
  const expected = featuresOf("paper").map((name) => [name, `${name}${FEATURE_MEANINGS[name]}`]);
  expect(shown).toEqual(expected);
  const numbers = await hosted.openSection("The last frame");
  const particles = numbers.getByRole("definition").nth(6);
  await expect(particles).not.toHaveText("0");
  await techniques.getByLabel(FEATURE_MEANINGS.particles).uncheck();
  expect(await hosted.evaluate((room) => room.features.particles)).toBe(false);
  await expect(particles).toHaveText("0");

  const settings = await hosted.openSection("Settings");
  await settings.getByLabel("exposure").fill("-1.5");
  expect(await hosted.evaluate((room) => room.exposure)).toBe(-1.5);
  await expect(settings.getByText("-1.5 EV")).toBeVisible();
  await settings.getByLabel("particles").fill("2000000");
  await settings.getByLabel("particles").blur();
  await expect(settings.getByLabel("particles")).toHaveValue(String(SETTINGS.particles.max));
  // What is set elsewhere shows too.
  await hosted.evaluate((room) => {
    room.particles = 800;
    room.look = "original";
  });
  await expect(settings.getByLabel("particles")).toHaveValue("800");
  await expect(settings.getByLabel("look")).toHaveValue("original");
});

test("on a wide screen the lab stands beside the room, and media are minded", async ({
  hosted,
}) => {
  const { page } = hosted;
  await page.setViewportSize({ width: 760, height: 200 });
  await hosted.openLab("Techniques");
  const lab = await hosted.lab.boundingBox();
  const room = await hosted.room.boundingBox();
  expect(room?.height).toBe(200);
  expect((room?.x ?? 0) + (room?.width ?? 0)).toBe(lab?.x);
  const atLeft = await page.evaluate(async () => {
    document.documentElement.dir = "rtl";
    const [lab, room] = [".lab", "candle-flame"].map((one) =>
      document.querySelector(one)?.getBoundingClientRect(),
    );
    document.documentElement.dir = "";
    return [lab?.left, room?.left === lab?.right];
  });
  expect(atLeft, "where one reads from right to left").toEqual([0, true]);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await expect(hosted.lab).toHaveCSS("transition-duration", /^0s(, 0s)*$/);
  // Forced colours are the system's, and let nothing through.
  await page.emulateMedia({ forcedColors: "active" });
  const key = page.locator(".threshold kbd").first();
  for (const one of [hosted.enter, key, page.locator(".threshold .hint")]) {
    await expect(one).toHaveCSS("background-color", /^rgb\(/);
  }
  await page.emulateMedia({ forcedColors: null });

  await test.step("where the hint can be read over the brightest picture, however large the type", async () => {
    await hosted.lab.getByRole("button", { name: "Close the lab" }).click();
    const hint = page.locator(".threshold .hint");
    const setBackdrop = (color: string) =>
      page.evaluate((color) => {
        const { style } = document.querySelector<HTMLElement>(".stage") as HTMLElement;
        style.background = color;
        for (const name of ["candle-flame", ".threshold > .hint > *"]) {
          for (const one of document.querySelectorAll<HTMLElement>(name)) {
            one.style.visibility = color && "hidden";
          }
        }
      }, color);
    for (const [width, height, scale] of [
      [800, 600, 1],
      [1280, 720, 2],
    ] as const) {
      await page.setViewportSize({ width, height });
      await scaleType(page, scale);
      await setBackdrop("#fff");
      const color = await hint.evaluate((hint) => getComputedStyle(hint).color);
      const [text = 0] = await luminances(page, color);
      const box = await hint.boundingBox();
      if (!box) throw new Error("no hint");
      // Without its edge, which may go through pixels.
      const [x, y] = [Math.ceil(box.x) + 1, Math.ceil(box.y) + 1];
      const clip = { x, y, width: Math.floor(box.width) - 3, height: Math.floor(box.height) - 3 };
      const shade = await luminances(page, await page.screenshot({ clip }));
      expect((text + 0.05) / (Math.max(...shade) + 0.05)).toBeGreaterThan(4.5);
    }
    await setBackdrop("");
    await scaleType(page, 1);
  });
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 600 }, hasTouch: true, isMobile: true });

  test("the lab is a sheet below the room, and one taps to come back", async ({ fresh }) => {
    const { page } = fresh;
    // Phones have no pointer to lock.
    await page.addInitScript(() => {
      Element.prototype.requestPointerLock = () =>
        Promise.reject(new DOMException("", "NotSupportedError"));
    });
    await fresh.open();
    await fresh.enter.tap();
    await expect.poll(() => fresh.isWalking()).toBe(true);
    await page.getByRole("button", { name: "Come back" }).tap();
    await expect.poll(() => fresh.isWalking()).toBe(false);
    await expect(fresh.enter).toBeFocused();
    await fresh.evaluate((room) => room.pause());
    await fresh.openLab("What each technique costs");
    const lab = await fresh.lab.boundingBox();
    const room = await fresh.room.boundingBox();
    expect(room?.width).toBe(390);
    expect(room?.height).toBe(lab?.y);
    const overflowOf = (locator: Locator) =>
      locator.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);
    expect(await overflowOf(fresh.lab.locator(".sections"))).toBe(0);

    await test.step("above which there is a place for the flame, also with large type", async () => {
      await page.setViewportSize({ width: 390, height: 844 });
      await scaleType(page, 2);
      const buttons = await page.locator(".corner > button:not([hidden])").evaluateAll((all) => {
        return all.map((button) => button.getBoundingClientRect().bottom);
      });
      expect(Math.max(...buttons)).toBeLessThan((await fresh.enter.boundingBox())?.y ?? 0);
      await scaleType(page, 1);
      await page.setViewportSize({ width: 390, height: 600 });
    });

    await test.step("and whatever is to be touched is as large as a fingertip", async () => {
      for (const title of ["Techniques", "Settings"]) await fresh.openSection(title);
      expect(await tooSmall(page)).toEqual([]);
      await page.keyboard.press("Escape");
      await page.getByRole("button", { name: "Settings" }).tap();
      expect(await tooSmall(page)).toEqual([]);
      expect(await overflowOf(page.getByRole("dialog"))).toBe(0);
      const dialog = await page.getByRole("dialog").boundingBox();
      const { height = 0 } = (await fresh.room.boundingBox()) ?? {};
      expect(height, "the flame stays in sight while it is set").toBe(dialog?.y);
      await scaleType(page, 2);
      expect(await overflowOf(page.getByRole("dialog")), "with large type").toBe(0);
      await scaleType(page, 1);
    });
  });
});

test.describe("without its models", () => {
  test.use({ tolerated: /404/ });

  test("the page says so, and stays of use", async ({ fresh }) => {
    const { page } = fresh;
    await page.route("**/*.glb", (route) => route.fulfill({ status: 404 }));
    await fresh.load("");
    await expect(page.getByRole("alert")).toContainText("could not be fetched");
    await expect(fresh.enter).toBeHidden();
    await page.getByRole("button", { name: "Help" }).click();
    await expect(page.getByRole("dialog")).toBeVisible();
    await page.keyboard.press("Escape");
    const lab = /\/lab-[^/]*\.js$/;
    await page.route(lab, (route) => route.fulfill({ status: 404 }));
    await page.getByRole("button", { name: "Lab", exact: true }).click();
    const notice = page.getByText("The lab cannot be fetched.");
    await expect(notice).toBeVisible();
    expect((await notice.boundingBox())?.x, "all of it in sight").toBeGreaterThanOrEqual(0);
    await page.unroute(lab);
    const ladder = await fresh.openLab("What each technique costs");
    await ladder.getByRole("button", { name: "Measure" }).click();
    await expect(ladder.getByRole("status")).toContainText("could not be fetched");
    const comparison = await fresh.openSection("Before and after");
    await comparison.getByRole("button", { name: "Compare" }).click();
    await expect(comparison.getByRole("status")).toContainText("could not be fetched");
    await expect(page.locator("candle-flame")).toHaveCount(1);
  });
});

interface Range {
  readonly least: number;
  readonly most: number;
}

/** What a number may be that is shown with so many digits. */
function rangeOf(text = ""): Range {
  const digits = text.split(".")[1]?.length ?? 0;
  const rounding = 0.5 * 10 ** -digits;
  return { least: Number(text) - rounding, most: Number(text) + rounding };
}

/** What one would miss with a finger: under 44 CSS pixels, with the label that can be touched as well. */
function tooSmall(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const all = document.querySelectorAll<HTMLElement>("button, select, input, summary, a");
    return [...all].flatMap((control) => {
      if (!control.checkVisibility()) return [];
      const boxes = [control, control.closest("label") ?? control];
      const side = (name: "width" | "height") =>
        Math.max(...boxes.map((box) => box.getBoundingClientRect()[name]));
      const [width, height] = [side("width"), side("height")];
      const isLarge = width >= 44 && height >= 44;
      return isLarge ? [] : [`${control.tagName} ${control.textContent} ${width} x ${height}`];
    });
  });
}

/** Relative luminances, as WCAG has them, of a colour or of a picture's pixels. */
function luminances(page: Page, of: string | Buffer): Promise<number[]> {
  const source = typeof of === "string" ? of : of.toString("base64");
  return page.evaluate(
    async ([source, isColor]) => {
      const canvas = document.createElement("canvas");
      const context = canvas.getContext("2d") as CanvasRenderingContext2D;
      if (isColor) {
        canvas.width = canvas.height = 1;
        context.fillStyle = source;
        context.fillRect(0, 0, 1, 1);
      } else {
        const bytes = Uint8Array.from(atob(source), (character) => character.charCodeAt(0));
        const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
        canvas.width = image.width;
        canvas.height = image.height;
        context.drawImage(image, 0, 0);
      }
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      const linear = [...Array(256)].map((_, byte) =>
        byte <= 10 ? byte / 3294 : ((byte / 255 + 0.055) / 1.055) ** 2.4,
      );
      const at = (i: number) => linear[data[i] ?? 0] ?? 0;
      return [...Array(data.length / 4)].map(
        (_, i) => 0.2126 * at(4 * i) + 0.7152 * at(4 * i + 1) + 0.0722 * at(4 * i + 2),
      );
    },
    [source, typeof of === "string"] as const,
  );
}

/** Arrow keys with a modifier, which mean something to the browser, that a control keeps from it. */
function shortcutsTaken(control: Locator): Promise<string[]> {
  return control.evaluate((control) =>
    ["ctrlKey", "metaKey", "altKey"].filter((modifier) => {
      const init = { key: "ArrowLeft", [modifier]: true, bubbles: true, cancelable: true };
      return !control.dispatchEvent(new KeyboardEvent("keydown", init));
    }),
  );
}

function shareOf(progress: HTMLElement | SVGElement): number {
  return (progress as HTMLProgressElement).value;
}

declare global {
  interface Window {
    /** Strengths of breaths. */
    heard: number[];
    /** What is asked of the microphone. */
    filters: MediaStreamConstraints["audio"];
    microphone: MediaStream;
    /** Sentences of the page on its room, from the first. */
    told: string[];
  }
}
