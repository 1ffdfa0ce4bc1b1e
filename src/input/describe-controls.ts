import type { Device } from "./first-person-input.js";

const FLAME = "puts the flame out or lights it";
const CANDLE = "[F] puts the candle down";

const CONTROLS: Readonly<Record<Device, string>> = {
  mouse: `[W][A][S][D] walk, the mouse looks, a click ${FLAME}, ${CANDLE}, [Esc] leaves`,
  drag: `[W][A][S][D] walk, drag to look, [E] ${FLAME}, ${CANDLE}, [Esc] leaves`,
  keyboard: `[W][A][S][D] walk, [Q][R] turn, [PgUp][PgDn] look, [E] ${FLAME}, ${CANDLE}, [Esc] leaves`,
  touch:
    "Walk with the left thumb, look with the right. Tap twice to put the flame out or light it, hold to put the candle down",
  gamepad: `Left stick walks, right stick looks, [A] ${FLAME}, [X] puts the candle down, [B] leaves`,
};

/** The same where there are only candles. */
const FLAME_CONTROLS: typeof CONTROLS = {
  mouse: `A click ${FLAME}, [B] blows, [Esc] leaves`,
  drag: `[E] ${FLAME}, [B] blows, [Esc] leaves`,
  keyboard: `[E] ${FLAME}, [B] blows, [Esc] leaves`,
  touch: "Tap twice to put the flame out or light it",
  gamepad: `[A] ${FLAME}, [Y] blows, [B] leaves`,
};

/** What a device does, in a room or where there are only candles; keys are in brackets. */
export function describeControls(device: Device, isAlone: boolean): string {
  return (isAlone ? FLAME_CONTROLS : CONTROLS)[device];
}
