import { expect, test } from "vitest";
import type { Gpu } from "../../../src/gl/gpu.ts";
import { areForwardProgramsCompiled } from "../../../src/render/opaque/forward-programs.ts";
import { tierNamed } from "../../../src/render/quality.ts";

test("each question whether programs are compiled starts one of them, without a frame being drawn", () => {
  const programs = new Map<string, { start(): boolean; isCompiled: boolean }>();
  let started = 0;
  const compiling = (): { start(): boolean; isCompiled: boolean } => ({
    isCompiled: false,
    start() {
      if (this.isCompiled) return false;
      started++;
      this.isCompiled = true; // in the call
      return true;
    },
  });
  const gpu = {
    program: (_label: string, _vertex: string, _fragment: string, options: unknown) => {
      const key = JSON.stringify(options);
      const program = programs.get(key) ?? compiling();
      programs.set(key, program);
      return program;
    },
  } as unknown as Gpu;
  const kinds = [true, false].flatMap((isGlossy) =>
    [true, false].map((isCutOut) => ({ isGlossy, isCutOut })),
  );
  const ask = () => areForwardProgramsCompiled(gpu, tierNamed("high"), { isMoonlit: true }, kinds);
  const answers = kinds.map(() => [ask(), started]);
  expect(answers).toEqual([1, 2, 3, 4].map((count) => [false, count]));
  expect(ask()).toBe(true);
  expect(started).toBe(4);
});
