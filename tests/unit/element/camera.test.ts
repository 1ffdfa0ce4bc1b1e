import { expect, test } from "vitest";
import { changeOf } from "../../../src/element/camera.ts";

test("a camera before the first frame is as legal as one in a room", () => {
  const before = { position: [1, 2, 3], yaw: 4, pitch: 0.5, fieldOfView: 1 } as const;
  const change = (camera: object) => changeOf(camera, before);
  expect(change({ position: [1e9, Number.NaN, 5], yaw: Infinity, pitch: 9 })).toEqual({
    position: [1e4, 2, 5],
    pitch: 1.5,
  });
  expect(change({ position: [-Infinity, 1, 0], pitch: -Infinity, fieldOfView: 0 })).toEqual({
    position: [1, 1, 0],
    fieldOfView: 0.3,
  });
});
