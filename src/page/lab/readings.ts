/** Adds a row for each name to a description list; gives the places of their values. */
export function addRows(
  list: HTMLElement,
  names: readonly string[],
): ReadonlyMap<string, HTMLElement> {
  const values = names.map((name) => {
    const row = document.createElement("div");
    const term = document.createElement("dt");
    const value = document.createElement("dd");
    term.textContent = name;
    row.append(term, value);
    list.append(row);
    return [name, value] as const;
  });
  return new Map(values);
}

/**
 * Calls `read` at once and at intervals, while a section is open, and the lab around it, too.
 *
 * @param onToggle called when that begins and when it ends
 * @returns to be called when the lab is shown or hidden
 */
export function readWhileOpen(
  section: HTMLDetailsElement,
  milliseconds: number,
  read: () => void,
  onToggle: (isOpen: boolean) => void = () => {},
): () => void {
  let timer = 0;
  const refresh = () => {
    clearInterval(timer);
    const isOpen = section.open && !section.closest("[hidden]");
    onToggle(isOpen);
    if (!isOpen) return;
    read();
    timer = window.setInterval(read, milliseconds);
  };
  section.addEventListener("toggle", refresh);
  return refresh;
}
