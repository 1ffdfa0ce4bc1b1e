import "./lab.css";
import "./tables.css";
import "./comparison.css";
import type { CandleFlameElement } from "../../candle-flame-element.js";
import { find } from "../find.js";
import { SettingsForm } from "../settings-form.js";
import { Comparison } from "./comparison.js";
import { ComparisonSection } from "./comparison-section.js";
import { FeatureSwitches } from "./feature-switches.js";
import { FlamePlot } from "./flame-plot.js";
import markup from "./lab.html?raw";
import { LadderSection } from "./ladder-section.js";
import { PassViewer } from "./pass-viewer.js";
import { ReadOut } from "./read-out.js";
import { SpotMeter } from "./spot-meter.js";

const SHOWN = ["look", "quality", "seed", "exposure", "particles"] as const;

/** The side panel: the paper's two tables, live, and everything about the room that can be set. */
export class Lab {
  readonly #panel: HTMLElement;
  readonly #button: HTMLButtonElement;
  readonly #ladder: LadderSection;
  readonly #readOut: ReadOut;
  readonly #meter: SpotMeter;
  readonly #passes: PassViewer;
  readonly #plot: FlamePlot;

  /** @param button shows and hides the panel, and says which */
  constructor(room: CandleFlameElement, stage: HTMLElement, button: HTMLButtonElement) {
    const template = document.createElement("template");
    template.innerHTML = markup;
    this.#panel = find(template.content, ".lab", HTMLElement);
    this.#button = button;
    // After the stage, so that the Tab key comes from the button that opens it straight to it.
    stage.after(this.#panel);
    button.setAttribute("aria-controls", this.#panel.id);

    const section = (name: string) => find(this.#panel, `.${name}`, HTMLDetailsElement);
    const comparison = new Comparison(room, stage);
    const techniques = find(section("techniques"), "fieldset", HTMLFieldSetElement);
    const settings = find(section("settings"), "fieldset", HTMLFieldSetElement);
    const switches = new FeatureSwitches(room, techniques);
    const form = new SettingsForm(room, settings, SHOWN);
    const part = (name: string) => find(template.content, `.${name}`, HTMLElement);
    const looks = new ComparisonSection(
      section("comparison"),
      part("divider"),
      room,
      stage,
      comparison,
    );
    this.#readOut = new ReadOut(room, find(section("last-frame"), "dl", HTMLElement), comparison);
    this.#meter = new SpotMeter(section("meter"), part("spot"), room, stage);
    this.#passes = new PassViewer(section("passes"), room);
    this.#plot = new FlamePlot(section("flame-plot"), room);
    this.#ladder = new LadderSection(section("ladder"), room);
    this.#ladder.onChange = (isRunning) => {
      // What is being measured must not change meanwhile.
      if (isRunning) comparison.close();
      for (const controls of [techniques, settings]) controls.disabled = isRunning;
      looks.isDisabled = isRunning;
      switches.refresh();
    };
    new MutationObserver(() => {
      switches.refresh();
      form.refresh();
      looks.refresh();
      this.#passes.refresh();
    }).observe(room, { attributes: true });

    find(this.#panel, ".close", HTMLButtonElement).addEventListener("click", () => this.toggle());
    this.#panel.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.toggle();
    });
  }

  toggle(): void {
    const opens = this.#panel.hidden === true;
    this.#panel.hidden = !opens;
    this.#button.setAttribute("aria-expanded", String(opens));
    document.body.classList.toggle("lab-open", opens);
    this.#meter.refresh();
    this.#plot.refresh();
    if (opens) {
      this.#readOut.start();
    } else {
      this.#ladder.stop();
      this.#readOut.stop();
      this.#passes.close();
      this.#button.focus();
    }
  }
}
