import { expect, test } from "vitest";
import { tagOf } from "../../../src/page/docs/snippet.ts";

test("a snippet has the attributes that are not at their default, in the order of the table", () => {
  expect(tagOf({})).toBe("<candle-flame></candle-flame>");
  const attributes = { wick: "8", scene: "candle", paused: "", wind: "0.05", seed: "1" } as const;
  expect(tagOf(attributes)).toBe('<candle-flame scene="candle" paused wick="8"></candle-flame>');
});

test("a snippet is valid markup of its values, whatever is typed", () => {
  expect(tagOf({ alt: 'A "light" & <more>' })).toBe(
    '<candle-flame alt="A &quot;light&quot; &amp; <more>"></candle-flame>',
  );
});

test("a snippet with a model has what the model would set by itself", () => {
  expect(tagOf({ src: "room.glb", wick: "2", moonlight: "0.15", wind: "0.05" })).toBe(
    '<candle-flame src="room.glb" wick="2" moonlight="0.15"></candle-flame>',
  );
});
