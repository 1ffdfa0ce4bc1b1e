import { openSources } from "../support/sources.ts";
import { expect, test } from "../support/test.ts";

test("Pixels come from SwiftShader, the same on every machine", async ({ room }) => {
  const renderer = await room.evaluate((element) => {
    const gl = element.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
    const names = gl?.getExtension("WEBGL_debug_renderer_info");
    return names ? String(gl?.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  });
  expect(renderer).toContain("SwiftShader");
});

test("WebGL 2 draws as asked", async ({ page }) => {
  const { version, pixel } = await page.evaluate(() => {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) return { version: "none", pixel: [] };
    gl.clearColor(1, 0.5, 0, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return { version: String(gl.getParameter(gl.VERSION)), pixel: [...pixel] };
  });
  expect(version).toContain("WebGL 2.0");
  expect(pixel).toEqual([255, 128, 0, 255]);
});

test("A frame binds only what is not bound", async ({ room }) => {
  const { calls, again } = await room.evaluate((element) => {
    const gl = element.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
    if (!gl) throw new Error("There is no context.");
    const bound = new Map<string, unknown>();
    let unit = 0;
    const log = { calls: 0, again: [] as string[] };
    const note = (place: string, value: unknown) => {
      log.calls++;
      if (bound.get(place) === value) log.again.push(place);
      bound.set(place, value);
    };
    const { activeTexture, bindTexture, bindBufferBase, bindFramebuffer, viewport } = gl;
    const noting = {
      activeTexture: (name: GLenum) => {
        unit = name;
        activeTexture.call(gl, name);
      },
      bindTexture: (target: GLenum, texture: WebGLTexture | null) => {
        // The first unit is for filling textures.
        if (unit !== gl.TEXTURE0) note(`texture ${unit} ${target}`, texture);
        bindTexture.call(gl, target, texture);
      },
      bindBufferBase: (target: GLenum, index: GLuint, buffer: WebGLBuffer | null) => {
        if (target === gl.UNIFORM_BUFFER) note(`block ${index}`, buffer);
        bindBufferBase.call(gl, target, index, buffer);
      },
      bindFramebuffer: (target: GLenum, framebuffer: WebGLFramebuffer | null) => {
        if (target === gl.FRAMEBUFFER) note("framebuffer", framebuffer);
        else bound.delete("framebuffer");
        bindFramebuffer.call(gl, target, framebuffer);
      },
      viewport: (...box: Parameters<typeof viewport>) => {
        note("viewport", box.join());
        viewport.apply(gl, box);
      },
    };
    Object.assign(gl, noting);
    for (let i = 0; i < 3; i++) element.step(1 / 60);
    for (const name in noting) Reflect.deleteProperty(gl, name);
    return log;
  });
  expect(calls).toBeGreaterThan(20);
  expect(again).toEqual([]);
});

test("What is made after the next renderer was given up is not its own", async ({ page }) => {
  await openSources(page);
  const count = await page.evaluate(async () => {
    const { Gpu } = await import(/* @vite-ignore */ `${location.origin}/src/gl/gpu.ts`);
    const gpu = new Gpu(document.createElement("canvas"));
    gpu.isAhead = true;
    gpu.clearUnshared(true);
    gpu.buffer("of the renderer that goes on", 16);
    gpu.clearUnshared(true);
    const { objectCount } = gpu;
    gpu.dispose();
    return objectCount;
  });
  expect(count).toBe(1);
});

test("A context that is cleared for another renderer keeps the programs that it has drawn with, and no other", async ({
  page,
}) => {
  await openSources(page);
  const kept = await page.evaluate(async () => {
    const { Gpu } = await import(/* @vite-ignore */ `${location.origin}/src/gl/gpu.ts`);
    const gpu = new Gpu(document.createElement("canvas"));
    const fragment = {
      source: "#version 300 es\nout mediump vec4 color; void main() { color = vec4(1); }",
      files: ["white.frag"],
    };
    const make = () => ["drawn with", "idle"].map((label) => gpu.pass(label, fragment));
    const before = make();
    gpu.draw({ program: before[0], target: "canvas" });
    gpu.buffer("of the renderer before", 16);
    gpu.clearObjects();
    const count = gpu.objectCount;
    const same = make().map((program, i) => program === before[i]);
    gpu.dispose();
    return { count, same, left: gpu.objectCount };
  });
  expect(kept).toEqual({ count: 0, same: [true, false], left: 0 });
});

test("A draw compiles its own program alone: of the others, one after each frame is started", async ({
  page,
}) => {
  await openSources(page);
  const started = await page.evaluate(async () => {
    const { Gpu } = await import(/* @vite-ignore */ `${location.origin}/src/gl/gpu.ts`);
    const gpu = new Gpu(document.createElement("canvas"));
    const { gl } = gpu;
    let links = 0;
    gl.linkProgram = (program: WebGLProgram) => {
      links++;
      WebGL2RenderingContext.prototype.linkProgram.call(gl, program);
    };
    const fragment = {
      source: "#version 300 es\nout mediump vec4 color; void main() { color = vec4(1); }",
      files: ["white.frag"],
    };
    const programs = ["asked", "waits", "drawn with"].map((label) => gpu.pass(label, fragment));
    const counts = [programs[0].isCompiled, links];
    gpu.draw({ program: programs[2], target: "canvas" });
    counts.push(links);
    gpu.endFrame();
    counts.push(links);
    await gpu.whenCompiled();
    counts.push(links, programs[0].isCompiled);
    gpu.dispose();
    return counts;
  });
  expect(started).toEqual([false, 0, 1, 2, 3, true]);
});

test("What draws to the canvas draws to no target of another format, for which some drivers compile anew", async ({
  cabin,
}) => {
  const formats = await cabin.evaluate(async (element) => {
    const gl = element.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
    if (!gl) throw new Error("There is no context.");
    const { useProgram, texStorage2D, bindFramebuffer, drawArrays } = gl;
    const formatOf = new Map<unknown, number>();
    const drawn = new Map<unknown, Set<number | "canvas">>();
    let current: Set<number | "canvas"> = new Set();
    let format: number | "canvas" = "canvas";
    Object.assign(gl, {
      useProgram: (program: WebGLProgram) => {
        current = drawn.get(program) ?? new Set();
        drawn.set(program, current);
        useProgram.call(gl, program);
      },
      texStorage2D: (...values: Parameters<typeof texStorage2D>) => {
        formatOf.set(gl.getParameter(gl.TEXTURE_BINDING_2D), values[2]);
        texStorage2D.apply(gl, values);
      },
      bindFramebuffer: (target: GLenum, framebuffer: WebGLFramebuffer | null) => {
        bindFramebuffer.call(gl, target, framebuffer);
        const [of, name] = [gl.COLOR_ATTACHMENT0, gl.FRAMEBUFFER_ATTACHMENT_OBJECT_NAME];
        const texture = framebuffer && gl.getFramebufferAttachmentParameter(target, of, name);
        format = framebuffer ? (formatOf.get(texture) ?? 0) : "canvas";
      },
      drawArrays: (...values: Parameters<typeof drawArrays>) => {
        current.add(format);
        drawArrays.apply(gl, values);
      },
    });
    Object.assign(element, { look: "paper", quality: "low" });
    await element.ready;
    Object.assign(element, { look: "physical", paused: false });
    await element.ready;
    element.paused = true;
    for (let i = 0; i < 3; i++) element.step(1 / 60);
    for (const name of ["useProgram", "texStorage2D", "bindFramebuffer", "drawArrays"])
      Reflect.deleteProperty(gl, name);
    const used = [...drawn.values()].filter((formats) => formats.has("canvas"));
    return used.map((formats) => [...formats].filter((f) => f !== "canvas" && f !== gl.RGB8));
  });
  expect(formats.length).toBeGreaterThan(1);
  expect(formats.flat()).toEqual([]);
});
