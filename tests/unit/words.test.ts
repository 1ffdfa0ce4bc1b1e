import { describe, expect, test } from "vitest";
import { filesIn, textOf } from "./sources.ts";

/**
 * Private words that once stood for terms of the field, and what they are called: docs/glossary.md.
 *
 * Whole words, also as parts of camel case.
 */
const PRIVATE: Readonly<Record<string, string>> = {
  paint: "G-buffer",
  painted: "G-buffer albedo",
  caught: "normal-map shading",
  told: "upsample guide",
  guessed: "bilateral upsampling",
  echo: "probe-ray radiance",
  echoing: "indirect scene",
  glimpse: "direct light at probe rays",
  surroundings: "irradiance",
  veil: "volumetric target, or glare",
  halo: "bloom",
  pupil: "exposure adaptation",
  fumes: "plume",
  spits: "sparks",
  slackly: "at a level of detail",
};

/** Words of relative clauses that stood for nouns. */
const CLAUSES = [
  /\bwho (?:walks|rests|moves|stands|stops|looks|sees)\b/i,
  /\bwhat is seen\b/i,
  /\bwhoever\b/i,
];

const FILES = [...filesIn("src", /\.ts$/), ...filesIn("shaders", /\.(glsl|frag|vert)$/)];

/** `uGBufferAlbedo` -> u, g, buffer, albedo. */
function wordsOf(text: string): Set<string> {
  const words = text.matchAll(/[A-Z]?[a-z]+|[A-Z]+(?![a-z])/g);
  return new Set(Array.from(words, ([word]) => word.toLowerCase()));
}

describe("The names of the sources", () => {
  test.each(FILES)("in %s are the field's", (file) => {
    const text = textOf(file).replace("echoCancellation", ""); // an option of the platform
    const words = wordsOf(text);
    for (const [word, term] of Object.entries(PRIVATE)) {
      expect.soft(words.has(word), `${file}: "${word}" is ${term}`).toBe(false);
    }
    for (const clause of CLAUSES) expect.soft(clause.exec(text)?.[0], file).toBeUndefined();
  });
});
