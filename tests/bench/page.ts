import "../../src/define.js";
import { measureLadder } from "./ladder.js";
import { measurePasses } from "./passes.js";
import { measureScaling } from "./scaling.js";

declare global {
  interface Window {
    bench: {
      readonly measureLadder: typeof measureLadder;
      readonly measurePasses: typeof measurePasses;
      readonly measureScaling: typeof measureScaling;
    };
  }
}

window.bench = { measureLadder, measurePasses, measureScaling };
