import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import type { Page, Request, Response } from "playwright/test";
import type { Camera } from "../../src/candle-flame-element.ts";
import { fixture } from "../support/any-room.ts";
import { graphicsErrors, recordContexts } from "../support/contexts.ts";
import { LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

/** Small, and cheap to draw: every step draws. */
const ATTRIBUTES = { look: "physical", quality: "low", controls: "" } as const;
const SIZE = { width: 320, height: 180 } as const;

/** From here one looks down at the table's top. */
const AT_THE_TABLE = { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 } as const;
const BY_THE_DOOR = { position: [-1.55, 1.6, 1.3], yaw: -0.94, pitch: 0 } as const;
const TABLE = { min: [-0.16, -0.45], max: [1.16, 0.35], top: 0.745 } as const;
/** A lane without furniture, along the south wall, eastwards. */
const LANE = { position: [-1.6, 1.6, 1.4], yaw: -Math.PI / 2, pitch: 0 } as const;

interface Glb {
  readonly nodes: readonly {
    readonly name: string;
    readonly translation?: readonly [number, number, number];
    readonly rotation?: readonly [number, number, number, number];
  }[];
  readonly meshes: readonly { readonly primitives: readonly { readonly indices: number }[] }[];
  readonly accessors: readonly { readonly count: number }[];
}

function glb(name: string): Glb {
  const bytes = readFileSync(new URL(`../../public/models/${name}`, import.meta.url));
  return JSON.parse(bytes.toString("utf8", 20, 20 + bytes.readUInt32LE(12)));
}

const primitivesOf = ({ meshes }: Glb) => meshes.flatMap(({ primitives }) => primitives);

const trianglesOf = (model: Glb) =>
  primitivesOf(model).reduce(
    (sum, { indices }) => sum + (model.accessors[indices]?.count ?? 0),
    0,
  ) / 3;

/** Bytes that a server with compression sends: pictures as they are, all else packed. */
const onTheWire = (url: string, body: Buffer) =>
  /\.(avif|jpg|wasm)$/.test(url) ? body.length : gzipSync(body).length;

test.describe("The cabin", () => {
  let page: Page;
  let room: RoomDriver;
  const received = new Map<string, Promise<Buffer>>();

  test.beforeAll(async ({ browser }) => {
    page = await browser.newPage();
    await recordContexts(page);
    const receive = (response: Response) => received.set(response.url(), response.body());
    page.on("response", receive);
    room = await new RoomDriver(page).open(ATTRIBUTES, SIZE);
    page.off("response", receive);
  });
  test.beforeEach(async () => {
    await room.evaluate((element) => element.reset());
  });
  test.afterEach(async () => {
    expect(room.complaints).toEqual([]);
    expect(await graphicsErrors(page)).toEqual([]);
  });
  test.afterAll(() => page.close());

  /** What the element tells while the candle is put down or taken up, and where the candle is then. */
  function after(verb: "place" | "take"): Promise<{ events: string[]; held: boolean }> {
    return room.evaluate((element, verb) => {
      const events: string[] = [];
      const stop = new AbortController();
      for (const type of ["place", "take", "error"] as const) {
        element.addEventListener(type, () => events.push(type), { signal: stop.signal });
      }
      element[verb]();
      stop.abort();
      return { events, held: element.held };
    }, verb);
  }

  /** The middle of the flame's light, as of the last frame. */
  function light(): Promise<readonly [number, number, number]> {
    return room.evaluate((element) => element.flame?.position ?? ([0, 0, 0] as const));
  }

  async function enter(): Promise<void> {
    await room.evaluate((element) => element.focus());
    await page.keyboard.press("Enter");
    expect(await room.isWalking()).toBe(true);
  }

  /** Leaves the candle on the table, and goes somewhere: a light that stands is far quicker to draw. */
  async function putDown(camera: Partial<Camera> = {}): Promise<void> {
    const held = await room.evaluate(
      (element, { table, camera }) => {
        element.camera = table;
        element.place();
        element.camera = { ...table, ...camera };
        return element.held;
      },
      { table: AT_THE_TABLE, camera },
    );
    expect(held).toBe(false);
  }

  /** Holds keys down for some steps, and tells where the visitor was after each. */
  async function walk(keys: readonly string[], seconds: number, times: number) {
    for (const key of keys) await page.keyboard.down(key);
    const way = await room.evaluate(
      (element, { seconds, times }) => {
        const way: (readonly [number, number, number])[] = [];
        for (let i = 0; i < times; i++) {
          element.step(seconds);
          way.push(element.camera.position);
        }
        return way;
      },
      { seconds, times },
    );
    for (const key of keys) await page.keyboard.up(key);
    return way;
  }

  test("comes over the wire in at most 4 MB, decoders left where they are", async () => {
    let bytes = 0;
    for (const [url, body] of received) bytes += onTheWire(url, await body);
    const files = [...received.keys()].map((url) => url.slice(LIBRARY.length));
    expect(files).toContain("models/cabin.glb");
    expect(files).toContain("models/chamberstick.glb");
    expect(files.filter((file) => /\.avif$/.test(file)).length).toBeGreaterThan(30);
    expect(files.filter((file) => /^decoders|paper-/.test(file))).toEqual([
      // The leaves of books are a material of the cabin.
      ...files.filter((file) => /^textures\/paper-/.test(file)),
    ]);
    expect(bytes).toBeLessThanOrEqual(4e6);
    expect(bytes).toBeGreaterThan(1e6);
  });

  test("has at most 64 000 triangles with its four candles, and 40 draws of its own", async () => {
    const [cabin, candle] = [glb("cabin.glb"), glb("chamberstick.glb")];
    const triangles = trianglesOf(cabin) + trianglesOf(candle);
    expect(triangles).toBeLessThanOrEqual(64_000);
    expect(triangles).toBeGreaterThan(20_000);
    expect(primitivesOf(cabin).length).toBeLessThanOrEqual(40);
  });

  test("takes at most 128 MB of the GPU's memory", async () => {
    const { gpuBytes } = await room.stats();
    expect(gpuBytes).toBeGreaterThan(20e6);
    expect(gpuBytes).toBeLessThanOrEqual(128e6);
  });

  test("is entered by the door, where its model says", async () => {
    const spawn = glb("cabin.glb").nodes.find(({ name }) => name === "spawn");
    const [x = 0, , z = 0] = spawn?.translation ?? [];
    const [, sine = 0, , cosine = 1] = spawn?.rotation ?? [];
    const { position, yaw } = await room.camera();
    expect(position[0]).toBeCloseTo(x, 3);
    expect(position[1]).toBeCloseTo(1.6, 3);
    expect(position[2]).toBeCloseTo(z, 3);
    expect(yaw).toBeCloseTo(2 * Math.atan2(sine, cosine), 3);
  });

  for (const { keys, pace } of [
    { keys: ["KeyW"], pace: 1.4 },
    { keys: ["ShiftLeft", "KeyW"], pace: 2.8 },
  ]) {
    test(`is crossed at ${pace} m/s with ${keys.join(" and ")}`, async () => {
      await putDown(LANE);
      await enter();
      // Full pace within a thousandth after 0.6 s; the lane is long enough.
      const way = await walk(keys, 0.1, 8);
      const [before, after] = [way[5] ?? [], way[7] ?? []];
      expect((after[0] ?? 0) - (before[0] ?? 0)).toBeCloseTo(pace * 0.2, 2);
      expect(after[2]).toBeCloseTo(LANE.position[2], 6);
    });
  }

  for (const { from, position, yaw } of [
    { from: "west", position: [-0.9, 1.6, -0.05], yaw: -Math.PI / 2 },
    { from: "south", position: [0.2, 1.6, 1.2], yaw: 0 },
  ] as const) {
    test(`has a table that a runner from the ${from} does not pass`, async () => {
      await putDown({ position, yaw, pitch: 0 });
      await enter();
      const way = await walk(["ShiftLeft", "KeyW"], 1 / 20, 14);
      const distances = way.map(([x, , z]) =>
        Math.hypot(
          Math.max(TABLE.min[0] - x, 0, x - TABLE.max[0]),
          Math.max(TABLE.min[1] - z, 0, z - TABLE.max[1]),
        ),
      );
      expect(Math.min(...distances)).toBeGreaterThan(0.24);
      expect(Math.min(...distances)).toBeLessThan(0.35);
    });
  }

  test("lets the candle be put on the table that one looks at", async () => {
    await room.stand(AT_THE_TABLE);
    await room.step(0);
    const before = await room.pixels();
    const inHand = await light();
    expect(await after("place")).toEqual({
      events: ["place"],
      held: false,
    });
    await room.step(0);
    const [x, y, z] = await light();
    // The middle of the light is some 2 cm above a wick 20 cm above the candle's foot.
    expect(y - TABLE.top).toBeGreaterThan(0.2);
    expect(y - TABLE.top).toBeLessThan(0.24);
    expect(x).toBeGreaterThan(TABLE.min[0]);
    expect(x).toBeLessThan(TABLE.max[0]);
    expect(z).toBeGreaterThan(TABLE.min[1]);
    expect(z).toBeLessThan(TABLE.max[1]);
    expect(Math.hypot(x - inHand[0], z - inHand[2])).toBeGreaterThan(0.05);
    expect(await room.pixels()).not.toBe(before);
    expect(await after("place")).toEqual({ events: [], held: false });
  });

  test("refuses a candle before a wall that one faces closely, and leaves it in the hand", async () => {
    await room.stand({ position: [1.8, 1.6, 1.6], yaw: Math.PI, pitch: 0 });
    await room.step(0);
    const before = await room.pixels();
    expect(await after("place")).toEqual({ events: [], held: true });
    expect(await room.pixels()).toBe(before);
  });

  test("lets the candle be taken up within reach, and not from across the room", async () => {
    await putDown(BY_THE_DOOR);
    expect(await after("take")).toEqual({ events: [], held: false });
    await room.stand(AT_THE_TABLE);
    expect(await after("take")).toEqual({ events: ["take"], held: true });
    expect(await after("take")).toEqual({ events: [], held: true });
  });

  test("sways in walking, but not with reduced motion", async () => {
    await putDown();
    await enter();
    /** Whether the picture of a moment of walking is that of standing at the same spot. */
    const isStill = async (key: string) => {
      await room.stand({ ...BY_THE_DOOR, position: [-1.2, 1.6, 1.3] });
      await walk([key], 0.1, 3);
      const walking = await room.pixels();
      await room.stand({});
      return (await room.pixels()) === walking;
    };
    expect(await isStill("KeyD")).toBe(false);
    await page.emulateMedia({ reducedMotion: "reduce" });
    expect(await isStill("KeyD")).toBe(true);
    await page.emulateMedia({ reducedMotion: null });
  });

  test("is the same picture each time, for the same seed and the same steps", async () => {
    const pictures: string[] = [];
    for (let i = 0; i < 2; i++) {
      await room.evaluate((element) => element.reset(7));
      await room.step(1 / 60, 3);
      pictures.push(await room.pixels());
    }
    expect(pictures[1]).toBe(pictures[0]);
    await room.stand({ yaw: 0.3 });
    expect(await room.pixels()).not.toBe(pictures[0]);
  });

  test("comes back in the very same pixels after a lost context, its candle on the table", async () => {
    await putDown({ position: [-0.85, 1.3, 1.1] });
    await room.step(1 / 15, 2);
    const picture = await room.pixels();
    const { gpuObjects, gpuBytes } = await room.stats();
    await room.evaluate(async (element) => {
      const extension = contexts.at(-1)?.getExtension("WEBGL_lose_context");
      const happens = (type: "contextlost" | "contextrestored") =>
        new Promise((resolve) => element.addEventListener(type, resolve, { once: true }));
      const [lost, restored] = [happens("contextlost"), happens("contextrestored")];
      extension?.loseContext();
      await lost;
      // The browser learns that it is wanted back only after the event's task.
      await new Promise((resolve) => setTimeout(resolve));
      extension?.restoreContext();
      await restored;
    });
    expect(await room.pixels()).toBe(picture);
    expect(await room.stats()).toMatchObject({ gpuObjects, gpuBytes });
    expect(await room.evaluate((element) => element.held)).toBe(false);
  });

  /** Sets attributes, and waits for `load` or `error`: the file's sentence, or nothing. */
  function changed(attributes: Readonly<Record<string, string>>): Promise<string | null> {
    return room.evaluate(
      (element, attributes) =>
        new Promise<string | null>((resolve) => {
          const stop = new AbortController();
          const end = (sentence: string | null) => {
            stop.abort();
            resolve(sentence);
          };
          const { signal } = stop;
          element.addEventListener("load", () => end(null), { signal });
          element.addEventListener(
            "error",
            ({ detail }) => end(`${detail.type}: ${detail.message}`),
            { signal },
          );
          for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
        }),
      attributes,
    );
  }

  test.describe("gives way to another room:", () => {
    test.beforeAll(async () => {
      const body = fixture("plain.glb");
      const contentType = "model/gltf-binary";
      await page.route(`${LIBRARY}rooms/*.glb`, (route) => route.fulfill({ contentType, body }));
      await page.route(`${LIBRARY}rooms/broken.glb`, (route) =>
        route.fulfill({ contentType, body: body.subarray(0, body.length / 2) }),
      );
    });

    test("one that is broken is named, and the cabin stays as it was", async () => {
      const before = await room.pixels();
      const { gpuObjects, gpuBytes } = await room.stats();
      expect(await changed({ src: "rooms/broken.glb" })).toMatch(/^asset: .*broken\.glb .*\.$/);
      expect(await room.pixels()).toBe(before);
      expect(await room.stats()).toMatchObject({ gpuObjects, gpuBytes });
      await room.evaluate((element) => element.removeAttribute("src"));
      expect(await room.pixels()).toBe(before);
    });

    test("the last of two asked for in quick succession is shown, the first given up; then the paper's, then the cabin, and nothing is left over", async () => {
      const cabin = await room.pixels();
      const { gpuObjects, gpuBytes } = await room.stats();
      const given: Promise<Request> = page.waitForEvent("requestfailed", {
        predicate: (request) => request.url().endsWith("/slow.glb"),
      });
      // It would be answered, but never is before it is given up.
      await page.route(`${LIBRARY}rooms/slow.glb`, async (route) => {
        await given;
        await route.abort().catch(() => {});
      });
      const asked = page.waitForRequest(/slow\.glb$/);
      await room.set({ src: "rooms/slow.glb" });
      await asked;
      expect(await changed({ src: "rooms/plain.glb" })).toBeNull();
      expect((await given).failure()?.errorText).toMatch(/ABORTED/);
      await room.stand({ position: [1, 0.6, 2.2], yaw: 0, pitch: 0 });
      const sign = await room.pixels();
      expect(sign).not.toBe(cabin);
      const own = await room.stats();

      expect(await changed({ src: "rooms/other.glb" })).toBeNull();
      await room.stand({ position: [1, 0.6, 2.2], yaw: 0, pitch: 0 });
      expect(await room.pixels()).toBe(sign);
      expect(await room.stats()).toMatchObject({
        gpuObjects: own.gpuObjects,
        gpuBytes: own.gpuBytes,
      });

      expect(await changed({ src: "", look: "paper" })).toBeNull();
      await room.stand({ position: [1, 0.6, 2.2], yaw: 0, pitch: 0 });
      expect(await room.pixels()).not.toBe(sign);
      expect(await changed({ look: "physical" })).toBeNull();
      await room.evaluate((element) => element.reset());
      expect(await room.pixels()).toBe(cabin);
      expect(await room.stats()).toMatchObject({ gpuObjects, gpuBytes });
    });
  });
});
