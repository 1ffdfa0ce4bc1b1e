// `import type {} from "candle-flame/react"` once, anywhere: then TSX knows the tag. React 18 and 19.
import type {
  CandleFlameAttributes,
  CandleFlameElement,
  CandleFlameListeners,
  CandleFlameProperties,
} from "candle-flame";
import type { ClassAttributes, HTMLAttributes } from "react";

/** React 18 writes attributes only and hears no events; React 19 sets properties and listens. */
type Own = CandleFlameAttributes & CandleFlameProperties & CandleFlameListeners;

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "candle-flame": Omit<HTMLAttributes<CandleFlameElement>, keyof Own> &
        ClassAttributes<CandleFlameElement> &
        Own & { class?: string | undefined };
    }
  }
}
