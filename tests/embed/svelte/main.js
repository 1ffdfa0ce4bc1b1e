import "candle-flame/define";
import { mount } from "svelte";
import App from "./App.svelte";

globalThis.heard = [];
mount(App, {
  target: document.querySelector("#root"),
  props: { onburns: (height) => height > 0 && heard.push("load") },
});
