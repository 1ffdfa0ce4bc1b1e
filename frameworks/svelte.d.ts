// `import type {} from "candle-flame/svelte"` once, anywhere: then templates know the tag.
import type {
  CandleFlameAttributes,
  CandleFlameElement,
  CandleFlameListeners,
  CandleFlameProperties,
} from "candle-flame";
import type { HTMLAttributes } from "svelte/elements";

type Own = CandleFlameAttributes & CandleFlameProperties & CandleFlameListeners;

declare module "svelte/elements" {
  interface SvelteHTMLElements {
    "candle-flame": Omit<HTMLAttributes<CandleFlameElement>, keyof Own> & Own;
  }
}
