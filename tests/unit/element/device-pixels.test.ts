import { expect, test, vi } from "vitest";
import { observeDevicePixels } from "../../../src/element/device-pixels.ts";

test("an element has the pixels of the window that shows it, and follows that window's monitor", () => {
  const ended = new AbortController();
  const monitor = new EventTarget();
  const view = {
    devicePixelRatio: 2,
    matchMedia: vi.fn(() => monitor),
    ResizeObserver: class {
      observe() {}
      disconnect() {}
    },
  };
  const box = { clientWidth: 30, clientHeight: 20, ownerDocument: { defaultView: view } };
  const onChange = vi.fn();
  observeDevicePixels(box as unknown as Element, ended.signal, onChange);
  view.devicePixelRatio = 1.5;
  monitor.dispatchEvent(new Event("change"));
  expect(onChange.mock.calls).toEqual([[{ width: 45, height: 30 }]]);
  const queries = [["(resolution: 2dppx)"], ["(resolution: 1.5dppx)"]];
  expect(view.matchMedia.mock.calls).toEqual(queries);
});
