import "candle-flame/define";

globalThis.heard = [];
for (const element of document.querySelectorAll("candle-flame")) {
  element.addEventListener("load", () => heard.push("load"));
}
