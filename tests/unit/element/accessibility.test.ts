import { expect, test } from "vitest";
import { Accessibility } from "../../../src/element/accessibility.ts";
import type { Overlay } from "../../../src/element/overlay.ts";
import type { ReflectedAttributes } from "../../../src/element/reflected-attributes.ts";

function create(attributes: Map<string, string>, controls = true) {
  const host = {
    alt: "A candle",
    controls,
    hasAttribute: (name: string) => attributes.has(name),
    getAttribute: (name: string) => attributes.get(name) ?? null,
    removeAttribute: (name: string) => attributes.delete(name),
    set tabIndex(index: number) {
      attributes.set("tabindex", String(index));
    },
  };
  const internals = { role: null, ariaLabel: null, ariaDescription: null };
  const overlay = { isFailing: false, posterAlt: "", hint: { element: { hidden: false } } };
  const accessibility = new Accessibility(
    host as unknown as ReflectedAttributes,
    internals as unknown as ElementInternals,
    overlay as unknown as Overlay,
  );
  accessibility.update(null);
  return { accessibility, host, internals, overlay };
}

test("a failure in the room's place says nothing of walking in", () => {
  const { accessibility, internals, overlay } = create(new Map());
  expect(internals).toMatchObject({
    role: "application",
    ariaDescription: expect.stringMatching(/^Press Enter/),
  });
  overlay.isFailing = true;
  accessibility.update(null);
  expect(internals).toMatchObject({ role: "group", ariaLabel: "A candle", ariaDescription: null });
});

test("an application has a name, even where the image would have none", () => {
  const { accessibility, host, internals } = create(new Map());
  host.alt = "";
  accessibility.update(null);
  expect(internals.ariaLabel).toBe("A burning candle");
});

test("an image without meaning tells nothing", () => {
  const { accessibility, host, overlay } = create(new Map(), false);
  const { element } = overlay.hint;
  expect(element.hidden).toBe(false);
  host.alt = "";
  accessibility.update(null);
  expect(element.hidden).toBe(true);
  host.controls = true;
  accessibility.update(null);
  expect(element.hidden).toBe(false);
});

test("without controls the focus goes, from a copy too, unless the page has its own tabindex", () => {
  const own = new Map<string, string>();
  const copy = new Map([["tabindex", "0"]]);
  const page = new Map([["tabindex", "-1"]]);
  for (const attributes of [own, copy, page]) {
    const { accessibility, host } = create(attributes);
    expect(attributes.get("tabindex")).toMatch(/0|-1/);
    host.controls = false;
    accessibility.update(null);
  }
  const never = new Map([["tabindex", "0"]]);
  create(never, false);
  const later = new Map<string, string>();
  const { accessibility, host } = create(later);
  later.set("tabindex", "3");
  host.controls = false;
  accessibility.update(null);
  expect([own, copy, page, never, later].map((one) => one.get("tabindex"))).toEqual([
    undefined,
    undefined,
    "-1",
    "0",
    "3",
  ]);
});
