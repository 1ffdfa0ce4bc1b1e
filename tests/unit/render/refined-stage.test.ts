import { mat4 } from "gl-matrix";
import { expect, test } from "vitest";
import type { Gpu } from "../../../src/gl/gpu.ts";
import type { FrameInput } from "../../../src/render/frame-input.ts";
import type { FrameSettings } from "../../../src/render/frame-settings.ts";
import type { RefinedCaptures } from "../../../src/render/refinement/refined-captures.ts";
import { RefinedStage } from "../../../src/render/refinement/refined-stage.ts";
import { REFINED } from "../../../src/render/refinement/refined-tier.ts";
import type { World } from "../../../src/world/world.ts";
import { createWorld } from "../../support/world.ts";

/** Questions to a driver that compiles side by side until a program is compiled. */
const QUESTIONS = 3;

/** As much of a GPU as draws nothing, and is asked for programs. */
class CompilingGpu {
  readonly renderer = "SwiftShader";
  readonly drawsToFloats = true;
  readonly #programs = new Map<string, { questions: number; readonly isCompiled: boolean }>();

  /** Whether it has been asked for a program, and has said that it is compiled. */
  hasCompiled(label: string): boolean {
    return (this.#programs.get(label)?.questions ?? 0) > QUESTIONS;
  }

  get isCompiling(): boolean {
    return Array.from(this.#programs.values(), ({ isCompiled }) => isCompiled).includes(false);
  }

  program(label: string) {
    const known = this.#programs.get(label);
    const program = known ?? {
      questions: 0,
      get isCompiled() {
        return this.questions++ >= QUESTIONS;
      },
    };
    this.#programs.set(label, program);
    return program;
  }

  pass = (label: string) => this.program(label);
  uniformBlock = () => ({ update: () => {} });
  share = () => ({});
  renderTarget = () => ({ width: 64, height: 64, color: {}, colors: [], depth: {}, dispose() {} });
  clear() {}
  draw() {}
}

test("tiles by the moon alone wait for their program, after an image by a flame, too", () => {
  const gpu = new CompilingGpu();
  const irradiance = { textures: {} };
  const moon = { kind: "moon", intensity: [0.1, 0.1, 0.1], virtual: {}, irradiance };
  const held = { shadow: { captureOrigin: [0, 0, 0] }, irradiance, cached: [moon] };
  const captures = { hold: () => true, update: () => held } as unknown as RefinedCaptures;
  const settings = { features: {}, canDefer: true } as unknown as FrameSettings;
  const describe = (world: World) => {
    const frame = { world, settings, instances: [], clipFromWorld: mat4.create(), flameUvs: [] };
    return frame as unknown as FrameInput;
  };
  const frames = { describe, *draw() {} };
  const stage = new RefinedStage(gpu as unknown as Gpu, REFINED, captures, frames);
  stage.resize({ width: 64, height: 64 });
  const isCompiledFor = (world: World) => {
    for (let tries = 0; !stage.prepare(world, settings); tries++) expect(tries).toBeLessThan(100);
    return gpu.hasCompiled("opaque/forward-night");
  };
  expect(isCompiledFor(createWorld("physical", 1))).toBe(false);
  expect(isCompiledFor(createWorld("physical", 1, { isLit: false }))).toBe(true);
});
