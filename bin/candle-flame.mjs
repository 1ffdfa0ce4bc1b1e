#!/usr/bin/env node
// npx candle-flame poster …: a picture of a scene, made by the renderer itself, for a page to open on.
import { existsSync } from "node:fs";
import { writeFile } from "node:fs/promises";
import { dirname } from "node:path";
import { makePoster, Refusal } from "./poster.mjs";

const USAGE = `npx candle-flame poster [options] [attributes]

  --out file        .avif (needs the package sharp), .webp, .jpg or .png; poster.webp unless said otherwise
  --size 1600x900   pixels, at most 8192 a side and 16.7 million
  --camera "x y z yaw pitch"   metres and radians, as the property camera has them; a sixth number is the
                    field of view
  --candle "x y z yaw pitch"   from where the candle is put down; without it, it is held
  --seconds 0       for how long it has burnt
  --url address     a page of yours, whose element is taken as it stands there
  --selector css    which element of that page; candle-flame unless said otherwise
  --browser path    a Chromium, Chrome or Edge, where none is found
  --compression 0.8 0 to 1; not for .png

Anything else is an attribute of the element: --look paper --seed 7 --unlit --src room.glb. Unless said
otherwise, quality is high.`;

const OPTIONS = new Set(Array.from(USAGE.matchAll(/^ {2}--(\w+)/gm), ([, name]) => name));

/** \`--name value\`, \`--name=value\` or \`--flag\`, as options of ours and attributes of the element. */
function parse(words) {
  const options = {};
  const attributes = {};
  for (let i = 0; i < words.length; i++) {
    const [, name, joined] = /^--([a-z][a-z-]*)(?:=(.*))?$/s.exec(words[i]) ?? [];
    if (!name) throw new Refusal(`What is ${words[i]}? Options begin with two dashes.`);
    const next = words[i + 1];
    const hasNext = joined === undefined && next !== undefined && !next.startsWith("--");
    const value = joined ?? (hasNext ? next : "");
    if (hasNext) i++;
    (OPTIONS.has(name) ? options : attributes)[name] = value;
  }
  return { options, attributes };
}

const [command, ...words] = process.argv.slice(2);
if (command !== "poster" || words.includes("--help")) {
  console.log(USAGE);
  process.exit(command === "poster" || command === undefined || command === "--help" ? 0 : 1);
}
try {
  const { options, attributes } = parse(words);
  const out = options.out || "poster.webp";
  if (!existsSync(dirname(out))) throw new Refusal(`There is no folder ${dirname(out)}.`);
  const picture = await makePoster({ ...options, out, attributes });
  await writeFile(out, picture).catch(({ message }) => {
    throw new Refusal(message);
  });
  console.log(`${out}: ${(picture.length / 1000).toFixed(1)} kB`);
} catch (error) {
  console.error(error instanceof Refusal ? error.message : error);
  process.exitCode = 1;
}
