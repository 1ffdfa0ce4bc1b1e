import "candle-flame/define";
import { createApp } from "vue";
import App from "./App.vue";

globalThis.heard = [];
createApp(App, { onBurns: (height) => height > 0 && heard.push("load") }).mount("#root");
