import "candle-flame/define";
import { createRoot } from "react-dom/client";
import { App } from "./app";

const heard: string[] = [];
Object.assign(globalThis, { heard });
const root = document.querySelector("#root");
if (root) createRoot(root).render(<App onLoad={(height) => height > 0 && heard.push("load")} />);
