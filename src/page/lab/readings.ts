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
