import { RUNGS } from "./ladder.js";

interface Row {
  readonly milliseconds: HTMLElement;
  readonly framesPerSecond: HTMLElement;
  readonly multiple: HTMLElement;
  readonly bar: HTMLElement;
  readonly paperBar: HTMLElement;
}

const BASELINE = RUNGS[0]?.paper.milliseconds ?? Number.NaN;
const PAPER_MULTIPLES = RUNGS.map(({ paper }) => paper.milliseconds / BASELINE);

/** Table 1: each rung's cost here and in the paper, as numbers and as bars in multiples of the first. */
export class LadderChart {
  readonly #rows: readonly Row[];

  /** @param body the table's, empty; its columns are name, then ms, fps and multiple, twice */
  constructor(body: HTMLTableSectionElement) {
    this.#rows = RUNGS.map(({ name, paper }, i) => {
      const numbers = body.insertRow();
      const head = document.createElement("th");
      head.scope = "row";
      head.textContent = name;
      numbers.append(head);
      const cell = (text: string): HTMLElement => {
        const cell = numbers.insertCell();
        cell.textContent = text;
        return cell;
      };
      const milliseconds = cell("–");
      const framesPerSecond = cell("–");
      const multiple = cell("–");
      cell(paper.milliseconds.toFixed(1)).className = "of-paper";
      cell(String(paper.framesPerSecond)).className = "of-paper";
      cell(formatMultiple(PAPER_MULTIPLES[i])).className = "of-paper";

      // The same numbers again, for the eye alone.
      const drawing = body.insertRow();
      drawing.className = "bars";
      drawing.setAttribute("aria-hidden", "true");
      const space = drawing.insertCell();
      space.colSpan = 7;
      const [bar, paperBar] = [document.createElement("div"), document.createElement("div")];
      bar.className = "bar";
      paperBar.className = "bar of-paper";
      space.append(bar, paperBar);
      return { milliseconds, framesPerSecond, multiple, bar, paperBar };
    });
    this.show([]);
  }

  /** @param medians frame time on each rung, milliseconds; `NaN` or missing where there is none yet */
  show(medians: readonly number[]): void {
    const multiples = medians.map((milliseconds) => milliseconds / (medians[0] ?? Number.NaN));
    const longest = Math.max(...PAPER_MULTIPLES, ...multiples.filter(Number.isFinite));
    this.#rows.forEach(({ milliseconds, framesPerSecond, multiple, bar, paperBar }, i) => {
      const time = medians[i];
      milliseconds.textContent = formatMilliseconds(time);
      framesPerSecond.textContent = formatRate(time && 1000 / time);
      multiple.textContent = formatMultiple(multiples[i]);
      bar.style.inlineSize = share(multiples[i], longest);
      paperBar.style.inlineSize = share(PAPER_MULTIPLES[i], longest);
    });
  }
}

function share(value: number | undefined, whole: number): string {
  return `${Number.isFinite(value) ? ((value ?? 0) / whole) * 100 : 0}%`;
}

export function formatMilliseconds(value: number | undefined): string {
  return format(value, (value ?? 0) < 10 ? 2 : (value ?? 0) < 100 ? 1 : 0);
}

function formatRate(value: number | undefined): string {
  return format(value, (value ?? 0) < 10 ? 1 : 0);
}

function formatMultiple(value: number | undefined): string {
  return format(value, 2);
}

function format(value: number | undefined, digits: number): string {
  return value === undefined || !Number.isFinite(value) ? "–" : value.toFixed(digits);
}
