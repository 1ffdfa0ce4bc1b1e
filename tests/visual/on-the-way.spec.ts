import type { Page } from "playwright/test";
import sharp from "sharp";
import { RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

// What blurs with the size of the picture is as fine here as visitors see it.
const BOX = { width: 1280, height: 720 };
const TABLE = { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 } as const;
const CAMERA = { position: [-0.85, 1.3, 1.1], yaw: -0.805, pitch: -0.244 } as const;
/** To which pictures are brought before they are compared, pixels. */
const SMALL = { width: 160, height: 90 };

/** How far the halo is seen there. */
const HALO = 8;

let page: Page;
let room: RoomDriver;

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage({ viewport: BOX });
  await serveSmallTextures(page);
  room = await new RoomDriver(page).open({ look: "physical", quality: "low" }, BOX);
});
test.afterAll(() => page.close());
test.afterEach(() => expect(room.complaints).toEqual([]));

/** The last two pictures of a way to the same place, of so many pictures. */
async function walk(pictures: number) {
  return room.evaluate(
    (element, { pictures, camera, small }) => {
      const canvas = element.shadowRoot?.querySelector("canvas");
      const paper = Object.assign(document.createElement("canvas"), small).getContext("2d");
      if (!canvas || !paper) throw new Error("There is no picture.");
      paper.imageSmoothingQuality = "high";
      const seen: { triangles: number; shown: Uint8ClampedArray }[] = [];
      const [x, y, z] = camera.position;
      element.play();
      for (let left = pictures - 1; left >= 0; left--) {
        const position = [x + 0.03 * left, y, z - 0.03 * left] as const;
        element.camera = { ...camera, position, yaw: camera.yaw - 0.03 * left };
        element.step(0);
        if (left > 1) continue;
        paper.drawImage(canvas, 0, 0, small.width, small.height);
        const { data } = paper.getImageData(0, 0, small.width, small.height);
        seen.push({ triangles: element.stats.triangles, shown: data });
      }
      element.pause();
      return seen;
    },
    { pictures, camera: CAMERA, small: SMALL },
  );
}

for (const where of ["in the hand", "on the table"]) {
  test(`At low every second picture on the way is the one before as it would be seen now: the candle ${where}`, async () => {
    if (where === "on the table") {
      await room.evaluate((element, table) => {
        element.camera = table;
        element.place();
      }, TABLE);
    }
    await walk(44); // by then all that is coarse is made
    const ways = [await walk(8), await walk(9)];
    const [kept, painted] = ways.toSorted(
      (a, b) => (a[1]?.triangles ?? 0) - (b[1]?.triangles ?? 0),
    );
    expect(kept?.[1]?.triangles).toBeLessThan(0.3 * (painted?.[1]?.triangles ?? 0));
    const wanted = painted?.[1]?.shown ?? new Uint8ClampedArray();
    for (const [kind, frame] of Object.entries({ reduced: painted, reprojected: kept })) {
      const data = Uint8Array.from(frame?.[1]?.shown ?? []);
      const image = await sharp(data, { raw: { ...SMALL, channels: 4 } })
        .png()
        .toBuffer();
      const name = `motion-${where === "in the hand" ? "held" : "standing"}-${kind}.png`;
      expect(image).toMatchSnapshot(name, { threshold: 0.1, maxDiffPixelRatio: 0.002 });
    }
    // Steps of 8 bits.
    const difference = (shown: ArrayLike<number> = []) =>
      Array.from(shown).reduce((sum, x, i) => sum + Math.abs(x - (wanted[i] ?? 0)), 0) /
      (0.75 * shown.length);
    const error = difference(kept?.[1]?.shown);
    const stale = difference(kept?.[0]?.shown);
    console.log(
      `${where}: off by ${error.toFixed(2)} steps, ${stale.toFixed(2)} if it just stayed`,
    );
    expect(error).toBeLessThan(5);
    expect(error).toBeLessThan(0.6 * stale);
    // What is around the flame is lit up by its halo, which does not move as that does.
    const blues = wanted.filter((_, i) => i % 4 === 2);
    const flame = blues.indexOf(Math.max(...blues));
    const parts: number[] = [];
    for (let up = -HALO; up <= HALO; up++) {
      for (let aside = -HALO; aside <= HALO; aside++) {
        const at = 4 * (flame + up * SMALL.width + aside);
        const apart = [0, 1, 2].map((i) =>
          Math.abs((kept?.[1]?.shown[at + i] ?? 0) - (wanted[at + i] ?? 0)),
        );
        parts.push(Math.max(...apart));
      }
    }
    const halo = parts.toSorted((a, b) => b - a)[HALO] ?? 255;
    console.log(`${where}: around the flame off by ${halo} steps, but for ${HALO} pixels`);
    expect(halo).toBeLessThan(30);
  });
}
