import "../../src/define.js";
import { measureCandles } from "./candles.js";
import { measureLadder } from "./ladder.js";
import { measurePasses } from "./passes.js";
import { measureScaling } from "./scaling.js";
import { measureScript } from "./script.js";

declare global {
  interface Window {
    bench: {
      readonly measureCandles: typeof measureCandles;
      readonly measureLadder: typeof measureLadder;
      readonly measurePasses: typeof measurePasses;
      readonly measureScaling: typeof measureScaling;
      readonly measureScript: typeof measureScript;
    };
  }
}

window.bench = { measureCandles, measureLadder, measurePasses, measureScaling, measureScript };
