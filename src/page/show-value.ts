/** Shows a slider's value with its unit in the output beside it; screen readers have it once, as the slider's value. */
export function showValue(slider: HTMLElement, output: HTMLOutputElement, text: string): void {
  output.value = text;
  slider.setAttribute("aria-valuetext", text);
  // An output is a live region; and where one reads on, the number would come again.
  output.setAttribute("aria-live", "off");
  output.setAttribute("aria-hidden", "true");
}
