import type { CandleFlameElement } from "candle-flame";
import type {} from "candle-flame/react";
import { useEffect, useRef } from "react";

/** Of a tag that a server has written React 19 hears no `on…`, and sets no property: the effect does. */
export function App({ onLoad }: { onLoad?: () => void }) {
  const candle = useRef<CandleFlameElement>(null);
  useEffect(() => {
    const stop = new AbortController();
    if (candle.current) candle.current.camera = { fieldOfView: 1 };
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
