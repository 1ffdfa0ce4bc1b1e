import { CandleFlame } from "../../src/candle-flame.ts";
import { Gpu } from "../../src/gl/gpu.ts";
import { nextTask } from "../../src/gl/next-task.ts";
import { Program, type ProgramOptions, type ShaderSource } from "../../src/gl/program.ts";
import { UniformBlock } from "../../src/gl/uniform-block.ts";
import { createCanvasTarget } from "../../src/scenes/canvas-target.ts";
import { loadScene } from "../../src/scenes/scene.ts";
import { allFeatures, type Look, type Quality, type SceneName } from "../../src/settings.ts";

/** What became of one program after some frames. */
export interface ProgramReport {
  readonly label: string;
  /** Shader files of its two stages. */
  readonly stages: readonly string[];
  /** What compiler and linker said, beside success. */
  readonly log: string;
  /** Loose uniforms and block members that the driver finds active, and nobody set. */
  readonly unset: readonly string[];
  /** How many were set. */
  readonly set: number;
}

/** Of all programs that each look has asked for. */
const sources = new Map<Look, (readonly [ShaderSource, ShaderSource, ProgramOptions])[]>();

/** Members of an array of structures are set alike, or not at all. */
function member(name: string): string {
  return name.replace(/\[0\]$/, "").replace(/\[\d+\]\./, "[].");
}

/** What is drawn: a look of the room, at `medium` if nothing else is said, or candles alone. */
export interface Drawn {
  readonly look?: Look;
  readonly quality?: Quality;
  readonly scene?: SceneName;
  readonly src?: string;
}

/**
 * Goes through a few frames of a look, without drawing a pixel, and tells of each program that took part: the physical one in the cabin, from `medium` on
 * first without the moon. Runs in the browser.
 */
export async function reportPrograms({
  look = "physical",
  quality = "medium",
  scene: name = "room",
  src = "",
}: Drawn): Promise<ProgramReport[]> {
  const made: { program: Program; stages: string[]; set: Set<string> }[] = [];
  const members = new Map<string, Set<string>>();
  const original = {
    program: Gpu.prototype.program,
    set: Program.prototype.set,
    update: UniformBlock.prototype.update,
  };
  const { drawArrays, drawElements } = WebGL2RenderingContext.prototype;
  Object.assign(WebGL2RenderingContext.prototype, { drawArrays() {}, drawElements() {} });
  const known = sources.get(look) ?? [];
  sources.set(look, known);
  Gpu.prototype.program = function (label, vertex, fragment, options = {}) {
    known.push([vertex, fragment, options]);
    const program = original.program.call(this, label, vertex, fragment, options);
    const stages = [vertex, fragment].map(({ files }) => files[0] ?? "");
    // A second request gets the same one.
    const isNew = made.every((known) => known.program !== program);
    if (isNew) made.push({ program, stages, set: new Set() });
    return program;
  };
  Program.prototype.set = function (name, value) {
    made.find(({ program }) => program === this)?.set.add(name);
    original.set.call(this, name, value);
  };
  UniformBlock.prototype.update = function (values) {
    const block = this.label.replace("block ", "");
    const known = members.get(block) ?? new Set();
    for (const name of Object.keys(values)) known.add(member(name));
    members.set(block, known);
    original.update.call(this, values);
  };
  try {
    const canvas = document.createElement("canvas");
    const assetRoot = new URL("/", location.href).href;
    const request = {
      scene: name,
      look,
      src,
      assetRoot,
      baseURI: location.href,
      isStepped: true,
    } as const;
    const loading = { signal: new AbortController().signal, onProgress: () => {} };
    const scene = await loadScene(request, loading);
    const screen = createCanvasTarget(name, canvas);
    // By its name a GPU, on which frames in motion have shaders of their own.
    if (quality !== "low") Object.assign(screen.gpu, { renderer: "A GPU" });
    const moonless = {
      look,
      seed: 1,
      quality,
      exposure: 0,
      particles: 0,
      isStill: false,
      unlit: false,
      litWicks: null,
      wick: 0.002,
      moon: { illuminance: 0, direction: null },
      wind: { speed: 0, direction: 0, gustiness: 0 },
    };
    const moonlit = { ...moonless, moon: { illuminance: 0.15, direction: null } };
    const candle = new CandleFlame(
      screen,
      scene,
      allFeatures(),
      quality === "low" ? moonlit : moonless,
    );
    candle.view.resize(48, 27);
    for (let i = 0; i < 3; i++) candle.step(1 / 60);
    await screen.gpu.whenIdle();
    await nextTask(); // the driver has said whether it accepts all targets
    if (quality === "low") {
      for (const { flame } of candle.world.standing) flame.light();
      candle.step(0.2);
      candle.play(); // in motion it has shaders of its own there, a new one in a few frames
      for (let picture = 0; picture < 40; picture++) {
        candle.world.player.yaw += 0.02;
        candle.step(1 / 60);
      }
      candle.view.resize(480, 270); // beyond the bloom
      candle.step(1 / 60);
      candle.pause();
      candle.step(1 / 60);
      candle.view.resize(48, 27);
    }
    move(candle);
    candle.world.flame.extinguish();
    candle.step(0.1);
    // At low the moon has shone from the first.
    if (name === "room" && look === "physical" && quality !== "low") {
      candle.options = moonlit;
      candle.world.flame.light();
      candle.step(0.1);
      move(candle);
      candle.world.flame.extinguish();
      candle.step(8); // the moon alone, when the ember is cold
      move(candle);
    }
    candle.world.flame.light();
    // Made when it is first looked at; at low all that is looked at is of another tier.
    for (const inspect of quality === "low" ? [] : (["radiance", "haze"] as const)) {
      candle.view.inspect = inspect;
      candle.step(0.1);
    }
    const gl = screen.source.getContext("webgl2");
    if (!gl) throw new Error("no WebGL 2");
    const reports = made.map(({ program, stages, set }) => {
      for (const name of program.samplers.keys()) set.add(name); // `Gpu.draw` insists on each
      for (const [block, names] of members) for (const name of names) set.add(`${block}.${name}`);
      const active = [...new Set(activeUniforms(gl, program.handle).map(member))];
      return {
        label: program.label,
        stages,
        log: logOf(gl, program.handle),
        unset: active.filter((name) => !set.has(name)),
        set: active.filter((name) => set.has(name)).length,
      };
    });
    candle.dispose();
    return reports;
  } finally {
    Object.assign(WebGL2RenderingContext.prototype, { drawArrays, drawElements });
    Gpu.prototype.program = original.program;
    Program.prototype.set = original.set;
    UniformBlock.prototype.update = original.update;
  }
}

/** In motion there are programs of its own. */
function move(candle: CandleFlame): void {
  candle.play();
  for (let picture = 0; picture < 3; picture++) {
    candle.world.player.yaw += 0.02;
    candle.step(1 / 60);
  }
  candle.pause();
}

/** What a program says with a word too many at the end of either of its stages. */
export interface Breakage {
  readonly file: string;
  readonly complaint: string;
}

/** Breaks each stage that a look's programs have, one by one, each in one program. */
export async function breakPrograms(look: Look): Promise<Breakage[]> {
  if (!sources.has(look)) await reportPrograms({ look });
  const gpu = new Gpu(document.createElement("canvas"));
  const attempts = new Map<string, () => void>();
  for (const [vertex, fragment, options] of sources.get(look) ?? []) {
    const attempt = (...stages: [ShaderSource, ShaderSource]) => {
      const program = gpu.program("broken", ...stages, options);
      program.finish();
      program.dispose();
    };
    const broken = (stage: ShaderSource) => ({ ...stage, source: `${stage.source}surplus;` });
    attempts.set(vertex.files[0] ?? "", () => attempt(broken(vertex), fragment));
    attempts.set(fragment.files[0] ?? "", () => attempt(vertex, broken(fragment)));
  }
  const breakages = [...attempts].map(([file, attempt]) => {
    try {
      attempt();
      return { file, complaint: "" };
    } catch (error) {
      return { file, complaint: String(error) };
    }
  });
  gpu.dispose();
  return breakages;
}

/** The message of the error that a program of these sources throws; empty if it throws none. */
export function complaintOf(vertex: ShaderSource, fragment: ShaderSource): string {
  const gpu = new Gpu(document.createElement("canvas"));
  try {
    gpu.program("broken", vertex, fragment, { defines: { SAMPLES: 4, CUTOUT: 0 } }).finish();
    return "";
  } catch (error) {
    return String(error);
  } finally {
    gpu.dispose();
  }
}

/** What two waits for all programs throw, one after the other, if two of them are broken. */
export function refusalsOf(vertex: ShaderSource, broken: ShaderSource): string[] {
  const gpu = new Gpu(document.createElement("canvas"));
  for (const SAMPLES of [1, 4]) {
    gpu.program("broken", vertex, broken, { defines: { SAMPLES, CUTOUT: 0 } });
  }
  const refusals = [1, 2].map(() => {
    try {
      gpu.finishPrograms();
      return "";
    } catch (error) {
      return String(error);
    }
  });
  gpu.dispose();
  return refusals;
}

/** Names of loose uniforms, and of members of blocks after the block's, whatever its instance is called. */
function activeUniforms(gl: WebGL2RenderingContext, program: WebGLProgram): string[] {
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) as number;
  const blocks: number[] = gl.getActiveUniforms(
    program,
    [...Array(count).keys()],
    gl.UNIFORM_BLOCK_INDEX,
  );
  return blocks.map((block, i) => {
    const name = gl.getActiveUniform(program, i)?.name.replace(/\[0\]$/, "") ?? "";
    if (block < 0) return name;
    return `${gl.getActiveUniformBlockName(program, block)}.${name.slice(name.indexOf(".") + 1)}`;
  });
}

function logOf(gl: WebGL2RenderingContext, program: WebGLProgram): string {
  const shaders = gl.getAttachedShaders(program) ?? [];
  const logs = [
    gl.getProgramInfoLog(program),
    ...shaders.map((shader) => gl.getShaderInfoLog(shader)),
  ];
  const linked = gl.getProgramParameter(program, gl.LINK_STATUS) as boolean;
  return [linked ? "" : "not linked", ...logs].filter(Boolean).join("\n");
}
