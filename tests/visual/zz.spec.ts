import { writeFileSync, mkdirSync } from "node:fs";
import { RoomDriver } from "../support/room-driver.ts";
import { test } from "../support/test.ts";
const BOX = { width: 1280, height: 720 };
const VIEWS = {
  table: { position: [-0.85, 1.3, 1.1], yaw: -0.805, pitch: -0.244 },
  door: { position: [0, 1.6, 0], yaw: 2.9, pitch: -0.1 },
  close: { position: [-0.1, 1.15, 0.5], yaw: -0.6, pitch: -0.35 },
} as const;
test("pictures in motion", async ({ page }) => {
  await page.setViewportSize(BOX);
  const room = await new RoomDriver(page).open({ look: "physical", quality: "low", ...(process.env.SRC ? {src: process.env.SRC} : {}) }, BOX);
  mkdirSync(process.env.SHOTS!, { recursive: true });
  for (const [name, camera] of Object.entries(VIEWS)) {
    const rest = await room.evaluate((element, camera) => { element.camera = camera; element.step(0); return { png: element.shadowRoot!.querySelector("canvas")!.toDataURL("image/png"), triangles: element.stats.triangles }; }, camera);
    const seen = await room.evaluate((element, camera) => {
      element.play();
      const canvas = element.shadowRoot!.querySelector("canvas")!;
      let out = ""; const tri: number[] = []; const times: number[] = []; const gl = canvas.getContext("webgl2")!;
      for (let left = 61; left >= 0; left--) {
        element.camera = { ...camera, yaw: camera.yaw - 0.01 * left };
        const t = performance.now();
        element.step(0);
        gl.readPixels(0,0,1,1,gl.RGBA,gl.UNSIGNED_BYTE,new Uint8Array(4));
        times.push(performance.now() - t);
        tri.push(element.stats.triangles);
        if (left < 2 && (tri.at(-1)! > tri.at(-2)!)) out = canvas.toDataURL("image/png");
      }
      element.pause();
      return { png: out, tri: tri.slice(-4), first: times.slice(0, 6), times: times.slice(-50) };
    }, camera);
    const med = (a: number[]) => `${Math.min(...a).toFixed(1)}..${a.toSorted((x, y) => x - y)[a.length >> 1]!.toFixed(1)}`;
    const at = (p: string, b: string) => writeFileSync(`${process.env.SHOTS}/${name}${p}.png`, Buffer.from(b.split(",")[1]!, "base64"));
    if (seen.png) at("-moving", seen.png); at("-rest", rest.png);
    console.log(name, rest.triangles, JSON.stringify(seen.tri), "even", med(seen.times.filter((_, i) => i % 2 === 0)), "odd", med(seen.times.filter((_, i) => i % 2)), "first", seen.first.map((x) => x.toFixed(0)).join(" "));
  }
});
