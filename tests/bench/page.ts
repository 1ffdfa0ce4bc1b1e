import "../../src/define.js";
import { measureLadder } from "./ladder.js";
import { measureScaling } from "./scaling.js";

declare global {
  interface Window {
    bench: {
      readonly measureLadder: typeof measureLadder;
      readonly measureScaling: typeof measureScaling;
    };
  }
}

window.bench = { measureLadder, measureScaling };
