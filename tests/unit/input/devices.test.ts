import { beforeEach, describe, expect, test, vi } from "vitest";
import { beyondDeadZone, Gamepads, type Pad } from "../../../src/input/gamepads.ts";
import { Keyboard } from "../../../src/input/keyboard.ts";
import { Touch } from "../../../src/input/touch.ts";
import { STILL } from "../../../src/world/player/intent.ts";

describe("the keyboard", () => {
  const press = (keyboard: Keyboard, code: string, repeat = false) =>
    keyboard.press({ code, repeat } as KeyboardEvent);
  const lift = (keyboard: Keyboard, code: string) => keyboard.lift({ code } as KeyboardEvent);

  test.each([
    ["W and the up arrow go ahead, once", ["KeyW", "ArrowUp"], { forward: 1 }],
    ["A and D together go nowhere", ["KeyA", "KeyD"], {}],
    ["Home turns left", ["Home"], { turn: 1 }],
    ["R turns right, Shift runs", ["KeyR", "ShiftRight"], { turn: -1, runs: true }],
    ["Page Up looks up", ["PageUp"], { tilt: 1 }],
    ["Page Down looks down", ["PageDown"], { tilt: -1 }],
  ] as const)("%s", (_, codes, wish) => {
    const keyboard = new Keyboard();
    for (const code of codes) expect(press(keyboard, code)).toBe(true);
    expect(keyboard.read()).toEqual({ ...STILL, ...wish });
    expect(keyboard.read()).toEqual({ ...STILL, ...wish });
    for (const code of codes) lift(keyboard, code);
    expect(keyboard.read()).toEqual(STILL);
  });

  test("has a key that went down and up between two frames act in one, and no other", () => {
    const keyboard = new Keyboard();
    press(keyboard, "KeyQ");
    lift(keyboard, "KeyQ");
    press(keyboard, "KeyQ");
    lift(keyboard, "KeyQ");
    expect(keyboard.read()).toEqual({ ...STILL, turn: 1 });
    expect(keyboard.read()).toEqual(STILL);

    // Held for a frame, in which it repeats.
    press(keyboard, "KeyW");
    expect(keyboard.read()).toEqual({ ...STILL, forward: 1 });
    press(keyboard, "KeyW", true);
    lift(keyboard, "KeyW");
    expect(keyboard.read()).toEqual(STILL);

    press(keyboard, "KeyW");
    lift(keyboard, "KeyW");
    keyboard.release();
    expect(keyboard.read()).toEqual(STILL);
  });

  test("forgets what is down when Command is lifted, since macOS reports no key lifted before that", () => {
    const keyboard = new Keyboard();
    press(keyboard, "KeyW");
    keyboard.lift({ code: "MetaLeft", key: "Meta" } as KeyboardEvent);
    expect(keyboard.read()).toEqual(STILL);
  });

  test.each([
    ["KeyE", { togglesFlame: true }],
    ["KeyB", { blows: true }],
    ["KeyF", { placesOrTakes: true }],
  ])("%s acts once, however long it is held", (code, wish) => {
    const keyboard = new Keyboard();
    expect(press(keyboard, code)).toBe(true);
    expect(keyboard.read()).toEqual({ ...STILL, ...wish });
    expect(press(keyboard, code, true)).toBe(true);
    expect(keyboard.read()).toEqual(STILL);
  });

  test("leaves every other key to the page", () => {
    const keyboard = new Keyboard();
    for (const code of ["Tab", "Space", "F5", "KeyZ"]) {
      expect(press(keyboard, code), code).toBe(false);
    }
    expect(keyboard.read()).toEqual(STILL);
  });
});

describe("the gamepad", () => {
  const pad = (axes: readonly number[], pressed: readonly number[] = [], mapping = "standard") =>
    ({
      mapping,
      axes,
      buttons: Array.from({ length: 17 }, (_, i) => ({ pressed: pressed.includes(i) })),
    }) satisfies Pad;
  let gamepads: Gamepads;
  beforeEach(() => {
    gamepads = new Gamepads();
  });

  test("has a round dead zone, and its rim at length 1", () => {
    expect(beyondDeadZone(0.1, 0.1)).toEqual([0, 0]);
    expect(beyondDeadZone(Number.NaN, 0)).toEqual([0, 0]);
    for (const angle of [0, 0.7, 2, 4]) {
      const [x, y] = beyondDeadZone(Math.cos(angle), Math.sin(angle));
      expect(Math.hypot(x, y)).toBeCloseTo(1, 9);
      expect(Math.atan2(y, x)).toBeCloseTo(Math.atan2(Math.sin(angle), Math.cos(angle)), 9);
    }
    // No leap at its edge.
    expect(Math.hypot(...beyondDeadZone(0.151, 0))).toBeLessThan(0.01);
    expect(beyondDeadZone(2, 0)).toEqual([1, 0]);
  });

  test("walks with the left stick, looks with the right, and runs with its trigger", () => {
    const intent = gamepads.read([null, pad([0.5, -1, 1, 0.05], [7])]);
    expect(intent.forward).toBeCloseTo(1 / Math.hypot(1, 0.5), 6);
    expect(intent.right).toBeCloseTo(0.5 / Math.hypot(1, 0.5), 6);
    expect(intent.turn).toBeCloseTo(-1, 2);
    expect(Math.abs(intent.tilt)).toBeLessThan(0.06);
    expect(intent.runs).toBe(true);
  });

  test("acts once for each press of a button", () => {
    gamepads.read([pad([0, 0, 0, 0])]);
    const pressed = () => gamepads.read([pad([0, 0, 0, 0], [0, 2, 3])]);
    expect(pressed()).toMatchObject({ togglesFlame: true, placesOrTakes: true, blows: true });
    expect(pressed()).toMatchObject({ togglesFlame: false, placesOrTakes: false, blows: false });
  });

  test("does nothing with the button that brought it in, until that comes up", () => {
    gamepads.release();
    const withA = pad([0, 0, 0, 0], [0]);
    expect(gamepads.read([withA]).togglesFlame).toBe(false);
    gamepads.read([pad([0, 0, 0, 0])]);
    expect(gamepads.read([withA]).togglesFlame).toBe(true);
  });

  test("is the one in the hand, whichever place it has, and stays so while it rests", () => {
    const idle = pad([0.1, 0, 0, 0]);
    const walking = pad([0, -1, 0, 0]);
    gamepads.read([idle, null, idle]);
    expect(gamepads.read([idle, null, pad([0, 0, 0, 0], [0])]).togglesFlame).toBe(true);
    expect(gamepads.enters).toBe(true);
    expect(gamepads.read([idle, null, walking]).forward).toBe(1);
    expect(gamepads.read([idle, null, idle])).toMatchObject({ forward: -0, runs: false });
    expect(gamepads.read([walking, null, idle]).forward, "another is taken up").toBe(1);
    expect(gamepads.read([walking, null, pad([0, 0, 1, 0])]).turn, "and drifts").toBeCloseTo(0);
    expect(gamepads.read([walking, null, pad([0, 0, 1, 0], [2])])).toMatchObject({
      turn: -1,
      placesOrTakes: true,
    });
  });

  test("acts once for a press, though another is taken up meanwhile", () => {
    const idle = pad([0, 0, 0, 0]);
    const withX = pad([0, 0, 0, 0], [2]);
    gamepads.read([idle, idle]);
    expect(gamepads.read([withX, idle]).placesOrTakes).toBe(true);
    expect(gamepads.read([withX, withX]).placesOrTakes).toBe(true);
    // Both are held from now on, or lost and found.
    const held = [
      [withX, withX],
      [withX, idle],
      [withX, null],
      [withX, withX],
    ];
    for (const pads of held) expect(gamepads.read(pads).placesOrTakes).toBe(false);
  });

  test("of an unknown layout is nobody's", () => {
    expect(gamepads.read([pad([1, 1, 1, 1], [0], "")])).toEqual(STILL);
    expect(gamepads.read([])).toEqual(STILL);
  });
});

describe("fingers", () => {
  const BOX = { left: 10, width: 400 } as DOMRect;
  let touch: Touch;
  let time: number;
  beforeEach(() => {
    vi.useFakeTimers();
    touch = new Touch(globalThis as unknown as Window);
    time = 0;
    return () => vi.useRealTimers();
  });

  const at = (pointerId: number, clientX: number, clientY: number, type = "pointerup") =>
    ({ pointerId, clientX, clientY, type, timeStamp: time }) as PointerEvent;
  const down = (id: number, x: number, y: number) => touch.down(at(id, x, y), BOX);
  const move = (id: number, x: number, y: number) => touch.move(at(id, x, y), 1);
  const up = (id: number, x: number, y: number, type?: string) => touch.up(at(id, x, y, type));
  const wait = (milliseconds: number) => {
    time += milliseconds;
    vi.advanceTimersByTime(milliseconds);
  };
  const tap = (x: number, y: number) => {
    down(1, x, y);
    wait(60);
    up(1, x, y);
  };

  test("walk on the left and look on the right, both at once", () => {
    down(1, 100, 300);
    down(2, 300, 300);
    move(1, 100, 240);
    move(2, 250, 310);
    const intent = touch.read();
    expect(intent.forward).toBeCloseTo(1, 9);
    expect(intent.right).toBeCloseTo(0, 9);
    expect(intent.runs).toBe(false);
    expect(intent.yaw).toBeCloseTo(50 * 0.006, 9);
    expect(intent.pitch).toBeCloseTo(-10 * 0.006, 9);
    // A thumb that rests there walks on, a finger that rests there looks no further.
    const next = touch.read();
    expect([next.forward, next.yaw, next.pitch]).toEqual([intent.forward, 0, 0]);
    up(1, 100, 240);
    expect(touch.read()).toEqual(STILL);
  });

  test("walk slowly near where they touched, not at all for a tremble, and run far out", () => {
    down(1, 100, 300);
    move(1, 105, 300);
    expect(touch.read()).toEqual(STILL);
    move(1, 134.5, 300);
    expect(touch.read().right).toBeCloseTo(0.5, 2);
    move(1, 100, 180);
    expect(touch.read()).toMatchObject({ forward: 1, runs: true });
  });

  test("light and put out by tapping twice in one place, anywhere", () => {
    for (const x of [60, 390]) {
      tap(x, 100);
      expect(touch.read().togglesFlame).toBe(false);
      wait(100);
      tap(x + 10, 100);
      expect(touch.read().togglesFlame).toBe(true);
      wait(100);
      tap(x, 100); // a third is a first again
      expect(touch.read().togglesFlame).toBe(false);
      wait(1000);
    }
  });

  test.each([
    ["too late", 600, 0],
    ["elsewhere", 100, 100],
  ])("do not by a second tap %s", (_, pause, way) => {
    tap(100, 100);
    wait(pause);
    tap(100 + way, 100);
    expect(touch.read().togglesFlame).toBe(false);
  });

  test("put down and take up by a hold on the right that does not move", () => {
    down(1, 300, 100);
    wait(600);
    expect(touch.read().placesOrTakes).toBe(true);
    expect(touch.read().placesOrTakes).toBe(false);
    up(1, 300, 100);
    const begins = [
      () => move(1, 330, 100),
      () => up(1, 300, 100, "pointercancel"),
      () => touch.release(),
    ];
    for (const ends of begins) {
      down(1, 300, 100);
      ends();
      wait(600);
      expect(touch.read().placesOrTakes).toBe(false);
      up(1, 300, 100);
    }
    down(1, 100, 100); // the left walks
    wait(600);
    expect(touch.read().placesOrTakes).toBe(false);
  });
});
