// `import type {} from "candle-flame/react"` once, anywhere: then TSX knows the tag. React 18 and 19.
import type {
  CandleFlameAttributes,
  CandleFlameElement,
  CandleFlameEventMap,
  CandleFlameListeners,
  CandleFlameProperties,
} from "candle-flame";
import type { ClassAttributes, HTMLAttributes } from "react";

/** React 18 writes attributes only and hears no events; React 19 sets properties and listens. */
type Own = CandleFlameAttributes & CandleFlameProperties & CandleFlameListeners;

/** React's own `onLoad`, `onPlay` and others, which it calls for no custom element. It does call `onload`. */
type NeverCalled = `on${Capitalize<keyof CandleFlameEventMap>}`;

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "candle-flame": Omit<HTMLAttributes<CandleFlameElement>, keyof Own | NeverCalled> &
        ClassAttributes<CandleFlameElement> &
        Own & { class?: string | undefined };
    }
  }
}
