import type { CandleFlameElement } from "../candle-flame-element.js";
import { find } from "./find.js";
import { Microphone } from "./microphone.js";

/** Binds the button that opens the microphone, so that the visitor can blow at the flame, and its status line. */
export function bindMicrophone(room: CandleFlameElement, section: HTMLElement): void {
  const button = find(section, "button", HTMLButtonElement);
  const status = find(section, "[role=status]", HTMLElement);
  let microphone: Microphone | null = null;

  async function open(): Promise<void> {
    button.disabled = true;
    try {
      microphone = await Microphone.open((strength) => room.blow(strength));
      status.textContent = "Blow at the microphone.";
      if (document.hidden) close("");
    } catch (error) {
      status.textContent = (error as Error).message;
    }
    button.disabled = false;
    button.setAttribute("aria-pressed", String(microphone !== null));
  }

  function close(sentence: string): void {
    microphone?.close();
    microphone = null;
    button.setAttribute("aria-pressed", "false");
    status.textContent = sentence;
  }

  button.addEventListener("click", () => {
    if (microphone) close("");
    else void open();
  });
  document.addEventListener("visibilitychange", () => {
    if (document.hidden && microphone) {
      close("The microphone was switched off when you left the page.");
    }
  });
}
