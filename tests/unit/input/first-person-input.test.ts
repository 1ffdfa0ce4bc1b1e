import { beforeEach, expect, test, vi } from "vitest";
import { FirstPersonInput } from "../../../src/input/first-person-input.ts";

/** As much of a window as the input asks: another than the script's. */
let view = {};

/** As much of a page as the input listens to. */
function place() {
  const root = { pointerLockElement: null as unknown, activeElement: null as unknown };
  const ownerDocument = Object.assign(new EventTarget(), {
    defaultView: view,
    hasFocus: () => true,
    exitPointerLock: () => {},
  });
  const host = Object.assign(new EventTarget(), {
    ownerDocument,
    isInert: false,
    matches: () => root.activeElement === host,
    getRootNode: () => root,
    focus: () => {
      if (!host.isInert) root.activeElement = host;
    },
  });
  const canvas = Object.assign(new EventTarget(), { getRootNode: () => root });
  const entered = vi.fn();
  const input = new FirstPersonInput(
    host as unknown as HTMLElement,
    canvas as unknown as HTMLCanvasElement,
    entered,
  );
  const lock = () => {
    root.pointerLockElement = canvas;
    ownerDocument.dispatchEvent(new Event("pointerlockchange"));
  };
  const move = (movementX: number, movementY: number) => {
    const given = { pointerType: "mouse", buttons: 0, movementX, movementY };
    canvas.dispatchEvent(Object.assign(new Event("pointermove"), given));
  };
  const press = (code: string, held: Partial<KeyboardEvent> = {}) => {
    const given = { code, ctrlKey: false, metaKey: false, altKey: false, repeat: false, ...held };
    return host.dispatchEvent(Object.assign(new Event("keydown", { cancelable: true }), given));
  };
  return { input, host, canvas, root, entered, lock, move, press };
}

const withButtons = (...pressed: number[]) => ({
  mapping: "standard",
  axes: [0, 0, 0, 0],
  buttons: Array.from({ length: 17 }, (_, i) => ({ pressed: pressed.includes(i) })),
});

beforeEach(() => {
  view = {
    innerWidth: 300,
    screen: { width: 1500 },
    navigator: {},
    matchMedia: () => ({ matches: true }),
    setTimeout: () => 0,
    clearTimeout: () => {},
  };
});

test("a quick mouse turns the view in a narrow frame too, and one jump is dropped", () => {
  const { input, host, lock, move } = place();
  host.focus();
  input.enter();
  lock();
  move(10, 0); // the first after a lock can jump
  const turned = (...moves: [number, number][]) => {
    for (const [x, y] of moves) move(x, y);
    const { yaw, pitch } = input.read();
    return [yaw, pitch].map((angle) => Math.round(angle / -0.0022) + 0);
  };
  expect(turned([300, 0], [0, 400])).toEqual([300, 400]);
  expect(turned([0, -2000]), "a jump").toEqual([0, 0]);
  expect(turned([20, 0])).toEqual([20, 0]);
  expect(turned([900, 0], [900, 0], [900, 0]), "a fast hand").toEqual([1800, 0]);
});

test("a pointer that a script has made drags the view, and is not captured", () => {
  const { input, host, canvas } = place();
  host.focus();
  input.enter();
  const captured = vi.fn();
  Object.assign(canvas, { setPointerCapture: captured });
  const dispatch = (type: string, isTrusted: boolean) => {
    const given = { pointerType: "mouse", pointerId: 7, buttons: 1, movementX: 9, movementY: 0 };
    const event = Object.assign(new Event(type), given);
    canvas.dispatchEvent(Object.defineProperty(event, "isTrusted", { value: isTrusted }));
  };
  dispatch("pointerdown", false);
  dispatch("pointermove", false);
  expect(input.read().yaw).toBeLessThan(0);
  expect(captured).not.toHaveBeenCalled();
  dispatch("pointerdown", true);
  expect(captured.mock.calls).toEqual([[7]]);
});

test("Enter walks in alone, and once: with a modifier it is the browser's, as all keys are", () => {
  const { host, entered, press } = place();
  host.focus();
  for (const held of [{ ctrlKey: true }, { metaKey: true }, { altKey: true }, { repeat: true }]) {
    expect(press("Enter", held)).toBe(true);
  }
  expect(entered).not.toHaveBeenCalled();
  expect(press("Enter")).toBe(false);
  expect(entered.mock.calls).toEqual([[true, "keyboard"]]);
});

test("Esc that ends a walk ends nothing else; another one is the browser's", () => {
  const { input, host, press } = place();
  host.focus();
  expect(press("Escape")).toBe(true);
  press("Enter");
  expect(press("Escape")).toBe(false);
  expect(input.isIn).toBe(false);
  expect(press("Escape", { repeat: true })).toBe(false);
  expect(press("Escape")).toBe(true);
});

test("a gamepad's A walks in when it goes down, not when the focus finds it down", () => {
  const { input, host, entered } = place();
  const read = (...pressed: number[]) => {
    Object.assign(view, { navigator: { getGamepads: () => [withButtons(...pressed)] } });
    input.read();
  };
  read(0);
  host.focus();
  read(0);
  expect(entered).not.toHaveBeenCalled();
  read();
  read(0);
  expect(entered.mock.calls).toEqual([[true, "gamepad"]]);
});

test("a page that enters while a gamepad's A is down enters by gamepad, and locks no pointer", () => {
  const { input, entered } = place();
  const timers = vi.fn();
  const navigator = { getGamepads: () => [null, withButtons(0)] };
  Object.assign(view, { setTimeout: timers, navigator });
  input.enter();
  expect(entered.mock.calls).toEqual([[true, "gamepad"]]);
  expect(timers).not.toHaveBeenCalled();
  expect(input.read().togglesFlame, "by the same press").toBe(false);
});

test("a click elsewhere leaves, one in the host's closed shadow tree does not", () => {
  const { input, host, root, entered } = place();
  const outer = { getRootNode: () => host.ownerDocument };
  const click = (...path: unknown[]) =>
    host.ownerDocument.dispatchEvent(
      Object.assign(new Event("click"), { composedPath: () => path }),
    );
  host.focus();
  input.enter();
  entered.mockClear();
  click(host, outer);
  Object.assign(root, { host: outer });
  click(outer); // all that the document sees of it
  expect(entered).not.toHaveBeenCalled();
  click({}, outer);
  expect(entered.mock.calls.map(([isIn]) => isIn)).toEqual([false]);
});

test("a click on the host walks in, as the page's own click() does; one on what it holds does not", () => {
  const { host, entered } = place();
  const click = (target: EventTarget) =>
    host.dispatchEvent(Object.assign(new Event("click"), { composedPath: () => [target, host] }));
  click(new EventTarget());
  expect(entered).not.toHaveBeenCalled();
  click(host);
  expect(entered).toHaveBeenCalledOnce();
});

/** A place whose pointer lock is asked for at once; the browser answers as it is told to. */
function placeWithLock(answer: () => Promise<void> | undefined) {
  Object.assign(view, { setTimeout: (action: () => void) => action() });
  const request = vi.fn(answer);
  const { canvas, host, ...rest } = place();
  Object.assign(canvas, { requestPointerLock: request });
  const click = async () => {
    const path = { composedPath: () => [canvas, host] };
    host.dispatchEvent(Object.assign(new Event("click"), path));
    await Promise.resolve();
    await Promise.resolve();
  };
  const answerBy = (type: "change" | "error") =>
    host.ownerDocument.dispatchEvent(new Event(`pointerlock${type}`));
  return { ...rest, host, request, click, answerBy };
}

const refusal = () => Promise.reject(new DOMException("refused", "SecurityError"));

test("a mouse whose lock is refused drags, which is told once, and asked for by one click more in a visit", async () => {
  const { input, entered, request, click } = placeWithLock(refusal);
  for (let i = 0; i < 4; i++) await click();
  expect(entered.mock.calls).toEqual([
    [true, "mouse"],
    [true, "drag"],
  ]);
  expect(request).toHaveBeenCalledTimes(2);
  expect(input.read().togglesFlame).toBe(false);
  input.leave();
  entered.mockClear();
  for (let i = 0; i < 4; i++) await click();
  expect(entered.mock.calls).toEqual([[true, "drag"]]);
  expect(request).toHaveBeenCalledTimes(4);
});

test("a click gets the lock that was refused to a page that entered, and the mouse looks", async () => {
  const { input, entered, request, click, lock } = placeWithLock(refusal);
  input.enter();
  await Promise.resolve();
  await Promise.resolve();
  request.mockImplementation(() => Promise.resolve(lock()));
  await click();
  await click();
  expect(entered.mock.calls.map(([, device]) => device)).toEqual(["mouse", "drag", "mouse"]);
  expect(input.read().togglesFlame).toBe(true);
});

test("a refusal by an event alone is heard, unless the visitor has left", async () => {
  const { input, entered, click, answerBy } = placeWithLock(() => undefined);
  await click();
  input.leave();
  answerBy("error");
  entered.mockClear();
  await click();
  answerBy("change"); // of another's lock
  answerBy("error");
  expect(entered.mock.calls).toEqual([
    [true, "mouse"],
    [true, "drag"],
  ]);
});

test("a mouse that can be locked with its speed adjusted alone is none that drags", async () => {
  const { entered, request, click, lock, answerBy } = placeWithLock(() => Promise.resolve(lock()));
  request.mockImplementationOnce(() => {
    answerBy("error");
    return Promise.reject(new DOMException("raw", "NotSupportedError"));
  });
  await click();
  expect(request).toHaveBeenCalledTimes(2);
  expect(entered.mock.calls).toEqual([[true, "mouse"]]);
});

test("a refused lock changes nothing for who came in by keyboard", async () => {
  const { host, entered, request, press } = placeWithLock(refusal);
  host.focus();
  press("Enter");
  await Promise.resolve();
  await Promise.resolve();
  expect(request).toHaveBeenCalledOnce();
  expect(entered.mock.calls).toEqual([[true, "keyboard"]]);
});

test("without the focus nobody is in, and no lock is asked for", () => {
  const { input, host, entered } = place();
  const setTimeout = vi.fn();
  Object.assign(view, { setTimeout });
  host.isInert = true;
  input.enter();
  expect([entered.mock.calls, setTimeout.mock.calls]).toEqual([[], []]);
  host.isInert = false;
  input.enter();
  expect(entered.mock.calls).toEqual([[true, "mouse"]]);
  expect(setTimeout).toHaveBeenCalledOnce();
});
