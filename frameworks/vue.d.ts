// `import type {} from "candle-flame/vue"` once, anywhere: then templates know the tag.
import type {
  CandleFlameAttributes,
  CandleFlameEventMap,
  CandleFlameProperties,
} from "candle-flame";
import type { HTMLAttributes, ReservedProps } from "vue";

type Listeners = {
  [Type in keyof CandleFlameEventMap as `on${Capitalize<Type>}`]?:
    | ((event: CandleFlameEventMap[Type]) => void)
    | undefined;
};
type Own = CandleFlameAttributes & CandleFlameProperties & Listeners;

declare module "vue" {
  interface GlobalComponents {
    "candle-flame": new () => { $props: Omit<HTMLAttributes, keyof Own> & ReservedProps & Own };
  }
}
