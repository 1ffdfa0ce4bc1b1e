import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { expect, test } from "playwright/test";
import { packGlb } from "../../tools/models/glb-builder.mjs";
import { AnyRoom, edited, fixture, fixtureUrl, type Json, opened } from "../support/any-room.ts";
import { FLAWS } from "../support/any-room-flaws.ts";

let room: AnyRoom;

test.beforeAll(async ({ browser }) => {
  room = await AnyRoom.open(await browser.newPage());
});
test.afterEach(() => room.expectTidy());
test.afterAll(() => room.page.close());

test.describe("A file that cannot be a room is refused with a sentence", () => {
  for (const [what, { served, says }] of Object.entries(FLAWS)) {
    test(`${what} is reported as such`, async () => {
      await room.serve("gone.bin", { body: "", status: 404 });
      const before = room.console.length;
      const refusal = await room.refusal(await room.serve("my%20room.glb", served));
      expect(refusal).toMatch(/^AssetError: my room\.glb /);
      expect(refusal).toMatch(says);
      // The browser itself says so of a 404.
      const noise = room.console.slice(before).filter(({ text }) => !/404/.test(text));
      expect(noise).toEqual([]);
    });
  }

  const TEXTURES: Readonly<Record<string, { image: object; says: RegExp }>> = {
    "that is missing": {
      image: { uri: "gone.png" },
      says: /^AssetError: The texture gone\.png of room\.glb could not be fetched: .* 404 Not Found\.$/,
    },
    "that is a web page": {
      image: { uri: "page.png" },
      says: /^AssetError: The texture page\.png of room\.glb is a web page, says its server/,
    },
    "that is no picture": {
      image: { bufferView: 2, mimeType: "image/png" },
      says: /^AssetError: The texture number 0 of room\.glb is not a picture that can be read\.$/,
    },
    "without a source": {
      image: {},
      says: /^AssetError: The texture number 0 of room\.glb is missing\.$/,
    },
  };
  for (const [what, { image, says }] of Object.entries(TEXTURES)) {
    test(`a texture ${what} is named`, async () => {
      await room.serve("gone.png", { body: "", status: 404 });
      await room.serve("page.png", { body: "<!doctype html>", contentType: "text/html" });
      const body = edited("plain.glb", (json) => {
        json.images = [image];
      });
      expect(await room.refusal(await room.serve("room.glb", { body }))).toMatch(says);
    });
  }

  test("a file that needs a decoder that is not there says so", async () => {
    const nowhere = await room.serve("nowhere/", { body: "" });
    for (const name of ["draco_wasm_wrapper.js", "draco_decoder.wasm"]) {
      await room.serve(`nowhere/${name}`, { body: "", status: 404 });
    }
    for (const name of ["basis_transcoder.js", "basis_transcoder.wasm"]) {
      await room.serve(`nowhere/${name}`, { body: "", status: 404 });
    }
    expect(await room.refusal(fixtureUrl("draco.glb"), nowhere)).toMatch(
      /^AssetError: draco\.glb needs a decoder that could not be fetched: .*\/draco_.*\.$/,
    );
    expect(await room.refusal(fixtureUrl("ktx2-etc1s.glb"), nowhere)).toMatch(
      /^AssetError: The texture .* of ktx2-etc1s\.glb needs a decoder that could not be fetched: .*\/basis_.*\.$/,
    );
  });

  test("a file whose decoder a policy forbids says so at once", async ({ browser }) => {
    const FORBIDDING = {
      "draco.glb": ["script-src 'self' 'wasm-unsafe-eval'", "script-src 'self'; worker-src blob:"],
      "ktx2-etc1s.glb": ["script-src 'self' 'wasm-unsafe-eval'; worker-src blob:"],
      "meshopt.glb": ["script-src 'self'"],
    };
    for (const [file, policies] of Object.entries(FORBIDDING)) {
      for (const policy of policies) {
        const strict = await AnyRoom.open(await browser.newPage(), policy);
        const begin = performance.now();
        expect(await strict.refusal(fixtureUrl(file)), `${file}, ${policy}`).toMatch(
          / is not decoded: its decoder cannot run; a content security policy may forbid it\.$/,
        );
        expect(performance.now() - begin).toBeLessThan(15_000);
        await strict.page.close();
      }
    }
  });

  test("a decoder that comes after its file was refused is ended", async () => {
    await room.serve("late/", { body: "" });
    let release = () => {};
    const isRefused = new Promise<void>((resolve) => {
      release = resolve;
    });
    await room.page.route("**/late/draco_*", async (route) => {
      await isRefused;
      const [, name = ""] = route.request().url().split("/late/");
      await route.fulfill({ path: `public/decoders/${name}` });
    });
    const body = edited("draco.glb", (json) => {
      json.images[0].bufferView = 1;
    });
    const url = await room.serve("draco.glb", { body });
    const late = new URL("late/", url).href;
    expect(await room.refusal(url, late)).toMatch(/ is not a picture that can be read\.$/);
    release();
    // Its own decoder comes after the late one.
    expect(await room.try(fixtureUrl("draco.glb"), late)).toHaveProperty("parts");
  });

  /** Each with the buffer view that is spoilt, all but its first bytes. */
  const SPOILT = {
    "draco.glb": {
      view: (json: Json) =>
        json.meshes[0].primitives[0].extensions.KHR_draco_mesh_compression.bufferView,
      kept: 0,
      says: /: draco\.glb holds geometry that cannot be decoded\.$/,
    },
    "meshopt.glb": {
      view: (json: Json) => json.accessors[0].bufferView,
      kept: 0,
      says: /: meshopt\.glb holds meshopt data that cannot be decoded\.$/,
    },
    "ktx2-uastc.glb": {
      view: (json: Json) => json.images[0].bufferView,
      kept: 32,
      says: /: The texture .* of ktx2-uastc\.glb is KTX2 that cannot be decoded\.$/,
    },
  };
  for (const [name, { view, kept, says }] of Object.entries(SPOILT)) {
    test(`${name} with its compressed data spoilt is reported as such`, async () => {
      const { json, binary } = opened(name);
      const spoilt = json.bufferViews[view(json)];
      const { byteOffset = 0, byteLength } = spoilt.extensions?.EXT_meshopt_compression ?? spoilt;
      binary.fill(0x55, byteOffset + kept, byteOffset + byteLength);
      const url = await room.serve(name, { body: packGlb(json, binary) });
      expect(await room.refusal(url)).toMatch(says);
    });
  }
});

test.describe("A file that is too large", () => {
  let server: Server;
  let sent = 0;
  let base = "";
  test.beforeAll(async () => {
    server = createServer((request, response) => {
      response.setHeader("access-control-allow-origin", "*");
      response.setHeader("content-type", "model/gltf-binary");
      if (request.url === "/declared.glb") response.setHeader("content-length", 60e6);
      if (request.url === "/stalled.glb") {
        response.write(fixture("plain.glb").subarray(0, 600));
        return;
      }
      sent = 0;
      const chunk = Buffer.alloc(1 << 20, "glTF");
      const more = () => {
        while (!response.destroyed && sent < 200e6) {
          sent += chunk.length;
          if (!response.write(chunk)) return;
        }
        response.end();
      };
      response.on("drain", more);
      more();
    });
    await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
    base = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  });
  test.afterAll(() => {
    server.closeAllConnections();
    server.close();
  });

  test("is refused by its declared length, before it is fetched", async () => {
    expect(await room.refusal(`${base}/declared.glb`)).toBe(
      "AssetError: declared.glb is too large: 60 MB, where 50 MB are the limit.",
    );
    expect(sent).toBeLessThan(40e6);
  });

  test("is refused on the way, if its length was not declared", async () => {
    expect(await room.refusal(`${base}/endless.glb`)).toBe(
      "AssetError: endless.glb is too large: more, where 50 MB are the limit.",
    );
    expect(sent).toBeLessThan(150e6);
  });

  test("or does not come is given up with the reason of the abort", async () => {
    expect(await room.loadAndAbort(`${base}/stalled.glb`, 0)).toEqual({
      name: "Error",
      message: "changed my mind",
    });
  });
});

test("a load that is given up at any moment rejects with the reason, and leaves nothing open", async () => {
  for (const file of ["plain.glb", "avif.glb", "draco.glb", "ktx2-etc1s.glb", "materials.glb"]) {
    for (const share of [0.1, 0.35, 0.6, 0.9]) {
      expect(await room.loadAndAbort(fixtureUrl(file), share), `${file} at ${share}`).toEqual({
        name: "Error",
        message: "changed my mind",
      });
    }
  }
});

test("three hundred damaged files are read or refused, none of them slowly", async () => {
  const whole = ["plain.glb", "posed.glb", "materials.glb", "meshopt.glb", "sparse.glb"];
  let loaded = 0;
  let refused = 0;
  for (const [i, file] of whole.entries()) {
    const report = await room.fuzz(fixtureUrl(file), 1000 * (i + 1), 60);
    expect(report.odd, file).toEqual([]);
    expect(report.slowest, file).toBeLessThan(1000);
    loaded += report.loaded;
    refused += report.refused;
  }
  expect(loaded + refused).toBe(300);
  expect(refused).toBeGreaterThan(200);
  expect(loaded).toBeGreaterThan(5);
});
