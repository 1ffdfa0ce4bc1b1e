import type { CandleFlameElement } from "../candle-flame-element.js";
import { find } from "./find.js";
import { Microphone } from "./microphone.js";

/** Button that opens the microphone, so that the visitor can blow at the flame, and its status line. */
export class MicrophoneSwitch {
  readonly #room: CandleFlameElement;
  readonly #button: HTMLButtonElement;
  readonly #status: HTMLElement;
  #microphone: Microphone | null = null;

  constructor(room: CandleFlameElement, section: HTMLElement) {
    this.#room = room;
    this.#button = find(section, "button", HTMLButtonElement);
    this.#status = find(section, "[role=status]", HTMLElement);
    this.#button.addEventListener("click", () => {
      if (this.#microphone) this.#close("");
      else void this.#open();
    });
    document.addEventListener("visibilitychange", () => {
      if (document.hidden && this.#microphone) {
        this.#close("The microphone was switched off when you left the page.");
      }
    });
  }

  async #open(): Promise<void> {
    this.#button.disabled = true;
    try {
      this.#microphone = await Microphone.open((strength) => this.#room.blow(strength));
      this.#status.textContent = "Blow at the microphone.";
      if (document.hidden) this.#close("");
    } catch (error) {
      this.#status.textContent = (error as Error).message;
    }
    this.#button.disabled = false;
    this.#button.setAttribute("aria-pressed", String(this.#microphone !== null));
  }

  #close(sentence: string): void {
    this.#microphone?.close();
    this.#microphone = null;
    this.#button.setAttribute("aria-pressed", "false");
    this.#status.textContent = sentence;
  }
}
