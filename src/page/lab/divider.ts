/** Steps of the keys, in per cent of the stage's width. */
const STEPS: Readonly<Record<string, number>> = {
  ArrowLeft: -2,
  ArrowDown: -2,
  ArrowRight: 2,
  ArrowUp: 2,
  PageDown: -10,
  PageUp: 10,
  Home: Number.NEGATIVE_INFINITY,
  End: Number.POSITIVE_INFINITY,
};

/**
 * Binds the divider of two views: a slider that is dragged, or moved by its keys.
 *
 * @param onEscape called on Esc, while the divider has the focus
 */
export function bindDivider(line: HTMLElement, stage: HTMLElement, onEscape: () => void) {
  let names: readonly [string, string] = ["", ""];
  let percent = 50;

  function move(wanted: number): void {
    percent = Math.min(Math.max(wanted, 0), 100);
    const rounded = Math.round(percent);
    const text = `${names[0]} ${rounded} %, ${names[1]} ${100 - rounded} %`;
    line.setAttribute("aria-valuenow", String(rounded));
    line.setAttribute("aria-valuetext", text);
    stage.style.setProperty("--divider", `${percent}%`);
  }

  line.addEventListener("pointerdown", ({ pointerId }) => line.setPointerCapture(pointerId));
  line.addEventListener("pointermove", ({ pointerId, clientX }) => {
    if (!line.hasPointerCapture(pointerId)) return;
    const { left, width } = stage.getBoundingClientRect();
    move(((clientX - left) / width) * 100);
  });
  line.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return; // shortcuts of the browser
    const step = STEPS[event.key];
    if (event.key === "Escape") onEscape();
    else if (step === undefined) return;
    else move(percent + step);
    event.preventDefault();
  });

  return {
    /** @param looks the names of what is on the left, and on the right */
    show(looks: readonly [string, string]): void {
      names = looks;
      names.forEach((name, i) => {
        line.children[i]?.replaceChildren(name);
      });
      if (!line.isConnected) stage.append(line);
      document.body.classList.add("comparing");
      move(percent);
    },
    clear(): void {
      line.remove();
      document.body.classList.remove("comparing");
    },
  };
}
