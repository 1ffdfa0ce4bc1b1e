import { brass } from "./materials/brass.mjs";
import { char } from "./materials/char.mjs";
import { iron } from "./materials/iron.mjs";
import { leather } from "./materials/leather.mjs";
import { linen } from "./materials/linen.mjs";
import { logends } from "./materials/logends.mjs";
import { logs } from "./materials/logs.mjs";
import { mirror } from "./materials/mirror.mjs";
import { paper } from "./materials/paper.mjs";
import { pewter } from "./materials/pewter.mjs";
import { planks } from "./materials/planks.mjs";
import { plaster } from "./materials/plaster.mjs";
import { stone } from "./materials/stone.mjs";
import { trim } from "./materials/trim.mjs";
import { wax } from "./materials/wax.mjs";
import { wool } from "./materials/wool.mjs";

/** Every texture set, in the order of how much of the room it covers. */
export const materials = [
  logs,
  planks,
  plaster,
  trim,
  stone,
  logends,
  wool,
  linen,
  paper,
  leather,
  wax,
  brass,
  pewter,
  iron,
  char,
  mirror,
];

export function materialNamed(name) {
  const found = materials.find((material) => material.name === name);
  if (found) return found;
  throw new Error(
    `No texture set "${name}"; there are ${materials.map((m) => m.name).join(", ")}.`,
  );
}
