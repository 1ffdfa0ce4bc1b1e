import { find } from "../find.js";

export function addCopyButton(snippet: HTMLElement): void {
  const code = find(snippet, "code", HTMLElement);
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = "Copy";
  button.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(code.textContent ?? "");
      button.textContent = "Copied";
    } catch {
      // No clipboard without a secure origin and the visitor's leave: then by hand.
      getSelection()?.selectAllChildren(code);
      button.textContent = "Selected";
    }
  });
  button.addEventListener("blur", () => {
    button.textContent = "Copy";
  });
  // Long lines scroll, by keyboard too.
  code.tabIndex = 0;
  snippet.append(button);
}
