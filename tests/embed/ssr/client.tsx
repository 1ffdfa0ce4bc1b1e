import "candle-flame/define";
import { hydrateRoot } from "react-dom/client";
import { App } from "./app";

const heard: string[] = [];
Object.assign(globalThis, { heard });
const root = document.querySelector("#root");
if (root) {
  hydrateRoot(root, <App onLoad={() => heard.push("load")} />, {
    onRecoverableError: (error) => console.error(error),
  });
}
