import type { CandleFlameElement } from "candle-flame";
import type {} from "candle-flame/react";
import { useRef } from "react";

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
