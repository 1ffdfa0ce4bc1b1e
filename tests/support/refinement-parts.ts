import type { Renderer } from "../../src/render/renderer.js";
import type { RefinementParts } from "../../src/scenes/refinement.js";

/** As much of a scene and its target as a refinement needs to make its renderer. */
export function partsOf(
  renderer: Renderer,
  whenCompiled: () => Promise<unknown> = () => Promise.resolve(),
  prepareRenderer: () => boolean = () => true,
): () => RefinementParts {
  const scene = { prepareRenderer, createRenderer: () => renderer };
  const target = { gpu: { whenCompiled, finishPrograms: () => {} } };
  const auto = { rise: () => {}, remeasure: () => {} };
  return () => ({ scene, target, settings: {}, auto }) as unknown as RefinementParts;
}
