import type { CandleFlameElement } from "../candle-flame-element.js";
import { BreathDetector, soundOf } from "./breath.js";
import { find } from "./find.js";

/** Samples of each frame: some 40 ms. */
const WINDOW = 2048;
/** Frames farther apart than this are not one breath, seconds. */
const LONGEST_FRAME = 0.1;
/** Phones filter wind out of speech, unless asked not to. */
const AUDIO = { echoCancellation: false, noiseSuppression: false, autoGainControl: false };

/**
 * Binds the button that opens the microphone, so that the visitor can blow at the flame, and its status line.
 *
 * Sound is measured and forgotten; nothing leaves the page.
 */
export function bindMicrophone(room: CandleFlameElement, section: HTMLElement): void {
  const button = find(section, "button", HTMLButtonElement);
  const status = find(section, "[role=status]", HTMLElement);
  let stop: (() => void) | null = null;

  async function open(): Promise<void> {
    button.setAttribute("aria-busy", "true"); // a disabled one would lose the focus
    let stream: MediaStream | null = null;
    try {
      stream = await navigator.mediaDevices.getUserMedia({ audio: AUDIO });
      stop = listen(stream, (strength) => room.blow(strength));
      for (const track of stream.getTracks()) {
        // Unplugged, or no longer allowed: the page itself ends tracks without this event.
        track.addEventListener("ended", () => close("The microphone was switched off."));
      }
      tell("Blow at the microphone.");
      if (document.hidden) close("");
    } catch (error) {
      closeTracks(stream);
      tell(sentenceOf(error as Error));
    }
    button.removeAttribute("aria-busy");
    button.setAttribute("aria-pressed", String(stop !== null));
  }

  /** The end of a dialog hides what is added there. */
  function tell(sentence: string): void {
    status.textContent = sentence;
    status.scrollIntoView({ block: "nearest" });
  }

  function close(sentence: string): void {
    stop?.();
    stop = null;
    button.setAttribute("aria-pressed", "false");
    status.textContent = sentence;
  }

  button.addEventListener("click", () => {
    if (button.hasAttribute("aria-busy")) return;
    if (stop) close("");
    else void open();
  });
  document.addEventListener("visibilitychange", () => {
    if (document.hidden && stop) {
      close("The microphone was switched off when you left the page.");
    }
  });
}

/** Detects blowing in a microphone's sound, until what it returns is called. */
function listen(stream: MediaStream, onBreath: (strength: number) => void): () => void {
  const context = new AudioContext();
  const analyser = new AnalyserNode(context, { fftSize: WINDOW });
  try {
    context.createMediaStreamSource(stream).connect(analyser);
  } catch (error) {
    void context.close();
    throw error;
  }
  const samples = new Float32Array(WINDOW);
  const detector = new BreathDetector();
  let lastTime = Number.NaN;
  const hear = (milliseconds: DOMHighResTimeStamp): void => {
    request = requestAnimationFrame(hear);
    const elapsed = (milliseconds - lastTime) / 1000;
    lastTime = milliseconds;
    if (!(elapsed > 0)) return;
    analyser.getFloatTimeDomainData(samples);
    const sound = soundOf(samples, context.sampleRate);
    const strength = detector.hear(sound, Math.min(elapsed, LONGEST_FRAME));
    if (strength > 0) onBreath(strength);
  };
  let request = requestAnimationFrame(hear);
  return () => {
    cancelAnimationFrame(request);
    closeTracks(stream);
    void context.close();
  };
}

function closeTracks(stream: MediaStream | null): void {
  for (const track of stream?.getTracks() ?? []) track.stop();
}

function sentenceOf({ name }: Error): string {
  if (name === "NotAllowedError") return "The browser keeps the microphone from this page.";
  if (name === "NotFoundError") return "No microphone was found.";
  if (!navigator.mediaDevices) return "This browser has no microphone for this page.";
  return "The microphone could not be opened.";
}
