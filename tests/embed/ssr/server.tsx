// The element's modules are loaded where there is no DOM, as a server does that renders its pages.
import "candle-flame/define";
import { CandleFlameElement } from "candle-flame";
import { renderToString } from "react-dom/server";
import { App } from "./app";

if (typeof CandleFlameElement !== "function") throw new Error("no class");
export const html = renderToString(<App />);
