import type { CandleFlameElement } from "candle-flame";
import type {} from "candle-flame/react";
import { useEffect, useRef } from "react";

/** React 19 hears no `on…` of a tag that a server has written, so the effect listens. */
export function App({ onLoad }: { onLoad?: () => void }) {
  const candle = useRef<CandleFlameElement>(null);
  useEffect(() => {
    const stop = new AbortController();
    candle.current?.addEventListener("load", () => onLoad?.(), { signal: stop.signal });
    return () => stop.abort();
  }, [onLoad]);
  return (
    <candle-flame
      ref={candle}
      scene="candle"
      asset-base="/candle-flame/"
      wind-direction={30}
      quality="low"
      style={{ width: 60, aspectRatio: "1" }}
    />
  );
}
