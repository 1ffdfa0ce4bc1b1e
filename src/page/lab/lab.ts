import "./lab.css";
import "./tables.css";
import "./comparison.css";
import type { CandleFlameElement } from "../../candle-flame-element.js";
import { find } from "../find.js";
import { addSettings } from "../settings-form.js";
import { Comparison } from "./comparison.js";
import { bindComparison } from "./comparison-section.js";
import { addFeatureSwitches } from "./feature-switches.js";
import { bindFlamePlot } from "./flame-plot.js";
import markup from "./lab.html?raw";
import { bindLadder } from "./ladder-section.js";
import { bindPassViewer } from "./pass-viewer.js";
import { bindReadOut } from "./read-out.js";
import { bindSpotMeter } from "./spot-meter.js";

const SHOWN = ["look", "quality", "seed", "exposure", "particles"] as const;

/**
 * Adds the side panel: the paper's two tables, live, and everything about the room that can be set.
 *
 * @param button shows and hides the panel, and says which
 * @returns what shows the panel, or hides it
 */
export function addLab(
  room: CandleFlameElement,
  stage: HTMLElement,
  button: HTMLButtonElement,
): () => void {
  const template = document.createElement("template");
  template.innerHTML = markup;
  const part = (name: string) => find(template.content, `.${name}`, HTMLElement);
  const panel = part("lab");
  const [divider, spot] = [part("divider"), part("spot")];
  // After the stage, so that the Tab key comes from the button that opens it straight to it.
  stage.after(panel);
  button.setAttribute("aria-controls", panel.id);

  const section = (name: string) => find(panel, `.${name}`, HTMLDetailsElement);
  const comparison = new Comparison(room, stage);
  const techniques = find(section("techniques"), "fieldset", HTMLFieldSetElement);
  const settings = find(section("settings"), "fieldset", HTMLFieldSetElement);
  addFeatureSwitches(room, techniques);
  addSettings(room, settings, SHOWN);
  const disableLooks = bindComparison(
    section("comparison"),
    divider,
    room,
    stage,
    comparison,
    button,
  );
  const showFrame = bindPassViewer(section("passes"), room);
  const instruments = [
    bindReadOut(section("last-frame"), room, comparison),
    bindSpotMeter(section("meter"), spot, room, stage, comparison),
    bindFlamePlot(section("flame-plot"), room),
  ];
  const stopLadder = bindLadder(section("ladder"), room, stage, (isRunning) => {
    // What is being measured must not change meanwhile.
    if (isRunning) comparison.close();
    for (const controls of [techniques, settings]) controls.disabled = isRunning;
    disableLooks(isRunning);
  });

  function toggle(): void {
    const opens = panel.hidden === true;
    panel.hidden = !opens;
    button.setAttribute("aria-expanded", String(opens));
    document.body.classList.toggle("lab-open", opens);
    for (const refresh of instruments) refresh();
    if (opens) return;
    stopLadder();
    showFrame();
    button.focus();
  }
  find(panel, ".close", HTMLButtonElement).addEventListener("click", toggle);
  for (const part of [panel, button]) {
    part.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && !panel.hidden) toggle();
    });
  }
  return toggle;
}
