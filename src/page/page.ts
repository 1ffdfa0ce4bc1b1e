import "../define.js";
import { find } from "./find.js";
import type { Lab } from "./lab/lab.js";

const stage = find(document, ".stage", HTMLElement);
const room = document.querySelector("candle-flame");
if (!room) throw new Error("The page's markup has no room.");

const enterButton = find(stage, ".enter", HTMLButtonElement);
const hint = find(stage, ".hint", HTMLElement);
const status = find(stage, ".status", HTMLElement);
const help = find(document, ".help", HTMLDialogElement);
const labButton = find(stage, ".lab-button", HTMLButtonElement);

enterButton.addEventListener("click", () => room.enter());
// Where there are no keys there is no Esc; the room lets go of whoever looks elsewhere.
find(stage, ".leave", HTMLButtonElement).addEventListener("click", () => room.blur());
find(stage, ".help-button", HTMLButtonElement).addEventListener("click", () => help.showModal());

room.addEventListener("progress", ({ detail }) => {
  // In quarters: a screen reader reads each change of this sentence aloud.
  const quarters = Math.floor(detail.totalProgress * 4);
  status.textContent = `Loading the room: ${quarters * 25} %`;
});
room.addEventListener("load", () => welcome(true));
// The element itself says what is missing.
room.addEventListener("error", () => welcome(false));

function welcome(isOpen: boolean): void {
  status.textContent = "";
  enterButton.disabled = !isOpen;
  enterButton.hidden = !isOpen;
  hint.hidden = !isOpen;
}

let lab: Promise<Lab> | null = null;
labButton.addEventListener("click", async () => {
  lab ??= import("./lab/lab.js").then(({ Lab }) => new Lab(room, stage, labButton));
  (await lab).toggle();
});
