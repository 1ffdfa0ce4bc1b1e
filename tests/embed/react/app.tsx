import type { CandleFlameElement } from "candle-flame";
import type {} from "candle-flame/react";
import { type JSX, useRef } from "react";

export function App({ onLoad }: { onLoad?: (height: number) => void }) {
  const candle = useRef<CandleFlameElement>(null);
  return (
    <candle-flame
      ref={candle}
      scene="candle"
      asset-base="/candle-flame/"
      wind-direction={30}
      quality="low"
      style={{ width: 60, aspectRatio: "1" }}
      onload={() => onLoad?.(candle.current?.flame?.height ?? 0)}
      onerror={({ detail }) => console.error(detail.message)}
    />
  );
}

// @ts-expect-error: no such quality
export const wrong = <candle-flame quality="best" />;

// React calls none of these for a custom element, but the same in the capture phase.
type Listeners = Extract<keyof JSX.IntrinsicElements["candle-flame"], `on${string}`>;
type NeverCalled = Extract<Listeners, "onLoad" | "onError" | "onPlay" | "onPause" | "onProgress">;
export const isEveryListenerCalled: [NeverCalled] extends [never] ? true : false = true;

export const called = (
  <candle-flame onpause={() => {}} onLoadCapture={() => {}} onClick={() => {}} />
);
