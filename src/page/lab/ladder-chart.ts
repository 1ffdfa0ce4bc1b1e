import { LADDER_STEPS } from "./ladder.js";

const PAPER_MULTIPLES = multiplesOf(LADDER_STEPS.map(({ milliseconds }) => milliseconds));

/**
 * Table 1: each step's cost here and in the paper, as numbers and as bars in multiples of the first.
 *
 * @param body the table's, empty; its columns are name, then ms, fps and multiple, twice
 * @returns what shows the median frame time of each step, milliseconds; `NaN` or missing where there is none yet
 */
export function addLadderChart(
  body: HTMLTableSectionElement,
): (medians: readonly number[]) => void {
  const rows = LADDER_STEPS.map(({ name, milliseconds, perSecond }, i) => {
    const texts = [milliseconds.toFixed(1), perSecond, formatMultiple(PAPER_MULTIPLES[i])];
    const paperCells = texts.map((text) => `<td class="of-paper">${text}</td>`).join("");
    const numbers = body.insertRow();
    numbers.innerHTML = `<th scope="row">${name}</th>${"<td></td>".repeat(3)}${paperCells}`;
    // The same numbers as bars, which screen readers need not announce.
    const drawing = body.insertRow();
    drawing.className = "bars";
    drawing.setAttribute("aria-hidden", "true");
    drawing.innerHTML = `<td colspan="7"><div class="bar"></div><div class="bar of-paper"></div></td>`;
    const [bar, paperBar] = drawing.querySelectorAll("div");
    return { cells: numbers.querySelectorAll("td"), bar, paperBar };
  });
  const show = (medians: readonly number[]) => {
    const multiples = multiplesOf(medians);
    const longest = Math.max(...PAPER_MULTIPLES, ...multiples.filter(Number.isFinite));
    rows.forEach(({ cells, bar, paperBar }, i) => {
      const time = medians[i] ?? Number.NaN;
      const rate = format(1000 / time, time > 100 ? 1 : 0);
      const texts = [formatMilliseconds(time), rate, formatMultiple(multiples[i])];
      texts.forEach((text, column) => {
        cells[column]?.replaceChildren(text);
      });
      if (bar) bar.style.inlineSize = percentOf(multiples[i], longest);
      if (paperBar) paperBar.style.inlineSize = percentOf(PAPER_MULTIPLES[i], longest);
    });
  };
  show([]);
  return show;
}

function multiplesOf(times: readonly number[]): readonly number[] {
  return times.map((time) => time / (times[0] ?? Number.NaN));
}

function percentOf(value = Number.NaN, whole: number): string {
  return `${Number.isFinite(value) ? (value / whole) * 100 : 0}%`;
}

export function formatMilliseconds(value = Number.NaN): string {
  return format(value, value < 10 ? 2 : value < 100 ? 1 : 0);
}

function formatMultiple(value = Number.NaN): string {
  return format(value, 2);
}

function format(value: number, digits: number): string {
  return Number.isFinite(value) ? value.toFixed(digits) : "–";
}
