// npm run reference [names…]: the views as Blender Cycles sees them, into tests/fixtures/reference/ or REFERENCES.
// Needs `npm run build`, and Python with tools/models/requirements.txt (PYTHON names it).
import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import sharp from "sharp";
import { chosenNames } from "../chosen-names.mjs";
import { openGlb, packGlb } from "../models/glb-builder.mjs";
import { FIXTURES, height, inEachRoom, readSource, views, width } from "./room.mjs";
import { ROOMS, roomModel } from "./rooms.mjs";
import { stageView } from "./stage.mjs";

const MODELS = new URL("../../public/models/", import.meta.url);
/** The ring handle's turn against the visitor, and the wick above the foot: as the renderer has them. */
const HANDLE_TURN = -1.1;
const WICK = [0.0011, 0.2, 0.0003];
/** Vertical, degrees. */
const FIELD_OF_VIEW = 56;

const names = chosenNames(views.map(({ name }) => name));
const wanted = views.filter(({ name }) => names.includes(name));

const { Flame } = await readSource("/src/world/flame/flame.ts");
const { TAPER_WICK } = await readSource("/src/world/flame/burning.ts");
const { flameLight, TAPER } = await readSource("/src/light/flame-light.ts");
const { position: centre, ...emitter } = flameLight(
  { root: [0, 0, 0], flame: new Flame(TAPER_WICK, true) },
  TAPER,
);
const lamp = { ...emitter, base: -centre[1], height: TAPER.height, reach: TAPER.radius };

const { CABIN_MOON } = await readSource("/src/world/moon.ts");
const { adaptedMoonlight } = await readSource("/src/light/moonlight.ts");
/** The cabin's window, metres; what its panes let through; luminance of the sky, cd/m² under a moon of 1 lx. */
const WINDOW = [
  [2.4, 0.7, -1.2],
  [2.9, 2.15, 0.25],
];
const PANE = 1;
const SKY = 0.002 / 0.15;

const moonOf = ({ illuminance }) => {
  const color = adaptedMoonlight(illuminance * PANE);
  return {
    illuminance,
    direction: CABIN_MOON,
    color,
    sky: color.map((channel) => channel * SKY),
    window: WINDOW,
  };
};

/** Where camera, flame and candle are in each view: the element itself says so. */
const staged = await inEachRoom("low", wanted, async (views, evaluate) => {
  const staged = [];
  for (const view of views) {
    await evaluate(stageView, view);
    const seen = await evaluate((element) => ({
      camera: element.camera,
      held: element.held,
      flames: element.candles.filter(({ lit }) => lit).map(({ position }) => position),
      position: element.flame.position,
    }));
    if (seen.held !== !view.place) {
      throw new Error(`${view.name}: the candle would not stand there.`);
    }
    staged.push({
      ...view,
      camera: seen.camera,
      flame: { position: seen.position },
      flames: seen.flames,
      ...(view.moon && { moon: moonOf(view.moon) }),
      candle: {
        foot: seen.position.map((x, axis) => x - WICK[axis] - centre[axis]),
        turn: (view.place ?? seen.camera).yaw + HANDLE_TURN,
      },
    });
  }
  return staged;
});

const folder = mkdtempSync(join(tmpdir(), "reference-"));
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
for (const name of ["cabin", "chamberstick"]) await exportModel(name);
for (const [name, parts] of Object.entries(ROOMS)) {
  writeFileSync(join(folder, `${name}.glb`), roomModel(parts));
}
mkdirSync(FIXTURES, { recursive: true });
for (const view of staged) {
  const file = join(folder, `${view.name}.json`);
  writeFileSync(file, JSON.stringify({ ...view, width, height, fieldOfView: FIELD_OF_VIEW, lamp }));
  const trace = fileURLToPath(new URL("trace.py", import.meta.url));
  const words = [trace, file, fileURLToPath(FIXTURES)];
  const { status } = spawnSync(process.env.PYTHON ?? "python3", words, { stdio: "inherit" });
  if (status !== 0) throw new Error(`${view.name} could not be traced.`);
}

/** Writes a model of ours, with textures that Blender reads: it has no decoder for AVIF. */
async function exportModel(name) {
  const { json, binary } = openGlb(readFileSync(new URL(`${name}.glb`, MODELS)));
  const avif = "EXT_texture_avif";
  for (const list of ["extensionsUsed", "extensionsRequired"]) {
    json[list] = json[list]?.filter((extension) => extension !== avif);
  }
  json.textures = json.textures.map(({ extensions, ...texture }) => ({
    ...texture,
    source: extensions[avif].source,
  }));
  for (const image of json.images) {
    const file = `${image.name}.png`;
    await sharp(fileURLToPath(new URL(image.uri, MODELS)))
      .png({ compressionLevel: 1 })
      .toFile(join(folder, file));
    Object.assign(image, { uri: file, mimeType: "image/png" });
  }
  writeFileSync(join(folder, `${name}.glb`), packGlb(json, binary));
}
