import { describe, expect, test } from "vitest";
import { readShareLink, SHARED, type View, writeShareLink } from "../../../src/page/share-link.ts";
import { FIELDS_OF_VIEW, SETTINGS } from "../../../src/settings.ts";

const NOTHING: View = { camera: null, candle: null, settings: {} };

test("a view survives the round trip", () => {
  const view: View = {
    camera: { position: [-2.25, 0, 1.5], yaw: 3.0417, pitch: -0.0001 },
    candle: { position: [0.5, 1.6, -1], yaw: -0.25, pitch: -0.5 },
    settings: {
      look: "paper",
      seed: "4294967295",
      exposure: "-1.5",
      quality: "ultra",
      wind: "0.4",
      "wind-direction": "-90",
      gustiness: "0",
      wick: "12.5",
      moonlight: "0.3",
      "moon-direction": "-70 32.5",
      particles: "1200",
      unlit: "",
      "lit-wicks": "0 2",
    },
  };
  expect(readShareLink(writeShareLink(view))).toEqual(view);
  expect(Object.keys(view.settings).toSorted()).toEqual([...SHARED].toSorted());
});

test.each([
  ["120, 30", "120 30"],
  [" .5  30 ", "0.5 30"],
  ["-1080,1e1", "-1080 10"],
  ["east", undefined],
  ["1 2 3", undefined],
  ["1 Infinity", undefined],
])("the moon at “%s” is carried as the element reads it", (text, carried) => {
  const hash = writeShareLink({ ...NOTHING, settings: { "moon-direction": text } });
  expect(readShareLink(hash).settings["moon-direction"]).toBe(carried);
});

test("a camera is carried to a tenth of a millimetre", () => {
  const camera = { position: [1 / 3, 1e-9, -1e-9], yaw: -2 / 3, pitch: 0.123456789 } as const;
  const read = readShareLink(writeShareLink({ ...NOTHING, camera })).camera;
  expect(read).toEqual({ position: [0.3333, 0, 0], yaw: -0.6667, pitch: 0.1235 });
});

test("a field of view goes with the camera, unless it is the look's own", () => {
  const camera = {
    position: [1, 1.6, 2],
    yaw: 0,
    pitch: 0,
    fieldOfView: FIELDS_OF_VIEW.paper,
  } as const;
  const view = { ...NOTHING, camera, candle: camera };
  expect(writeShareLink(view)).toBe("#camera=1_1.6_2_0_0_0.7854&candle=1_1.6_2_0_0");
  expect(readShareLink(writeShareLink(view)).camera?.fieldOfView).toBe(0.7854);
  const settings = { look: "paper" };
  expect(writeShareLink({ camera, candle: null, settings })).toBe("#camera=1_1.6_2_0_0&look=paper");
});

test("what is at its default is not in the link", () => {
  const settings: Record<string, string> = {};
  for (const name of SHARED) {
    const setting = SETTINGS[name];
    if ("default" in setting) settings[name] = String(setting.default);
  }
  expect(writeShareLink({ ...NOTHING, settings })).toBe("#");
});

test("a link needs no escapes", () => {
  const camera = { position: [-1.5, 0, 2], yaw: 0.5, pitch: 0 } as const;
  const hash = writeShareLink({ ...NOTHING, camera, settings: { exposure: "-2" } });
  expect(hash).toBe("#camera=-1.5_0_2_0.5_0&exposure=-2");
});

describe("hostile hashes", () => {
  test.each([
    "",
    "#",
    "####",
    "#=&=&&==",
    "#%",
    "#%E0%A4%A",
    "#\0\ud800",
    "#look=constructor&quality=__proto__",
    "#__proto__=1&constructor=2&toString=3",
    "#src=https://elsewhere.example/room.glb&asset-base=//elsewhere.example",
    "#look=<img src=x onerror=alert(1)>",
    "#seed=NaN&exposure=Infinity",
    "#wind=gale&wick=&wind-direction=[]&gustiness=NaN&lit-wicks=all&Unlit=1&windDirection=90",
    `#look=${"x".repeat(1_000_000)}`,
    "&look=paper&".repeat(2).replaceAll("look", "LOOK"),
  ])("say nothing (%#)", (hash) => {
    expect(readShareLink(hash)).toEqual(NOTHING);
  });

  test.each([
    "1_2_3_4",
    "1_2_3_4_5_6_7",
    "____",
    "0_0_0_NaN_0",
    "0_0_Infinity_0_0",
    "1e999_0_0_0_0",
  ])("name no camera by %s", (camera) => {
    expect(readShareLink(`#camera=${camera}`).camera).toBeNull();
    expect(readShareLink(`#candle=${camera}`).candle).toBeNull();
  });

  test("lose illegal values only, and numbers are clamped to their range", () => {
    expect(
      readShareLink(
        "#camera=here&unknown=1&look=PAPER&exposure=1e9&seed=-7&wick=99&wind=-1&unlit=no&lit-wicks=x,3_3;-1+2,2,99999",
      ),
    ).toEqual({
      camera: null,
      candle: null,
      settings: {
        look: "paper",
        exposure: String(SETTINGS.exposure.max),
        seed: "0",
        wick: "50",
        wind: "0",
        unlit: "",
        "lit-wicks": "2",
      },
    });
  });
});
