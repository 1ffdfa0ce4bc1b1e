import type { CandleFlame } from "../candle-flame.js";
import { blowAt } from "../world/commands.js";
import type { Candle } from "./element-types.js";
import { strengthOfBreath } from "./legal-values.js";

/** Candles of one scene, the carried one first. They have no effect once another scene is shown. */
export class CandleList {
  readonly entries: readonly Candle[];
  #source: CandleFlame | null;
  readonly #onChange: () => void;

  /** @param onChange called when a page has changed a candle */
  constructor(source: CandleFlame | null, onChange: () => void) {
    this.#source = source;
    this.#onChange = onChange;
    const names = source?.candleNames ?? [];
    this.entries = Object.freeze(
      names.map((name, index) => Object.freeze(this.#entry(name, index))),
    );
  }

  /** Another scene is shown, or none. */
  retire(): void {
    this.#source = null;
  }

  #entry(name: string, index: number): Candle {
    const report = () => this.#source?.reportOf(index) ?? null;
    const setLit = (isLit: boolean) => this.#change((source) => source.setLit(isLit, index));
    const blow = (strength: unknown) =>
      this.#change(({ world }) => blowAt(world, index, strengthOfBreath(strength)));
    return {
      name,
      get lit() {
        return report()?.lit ?? false;
      },
      set lit(isLit) {
        setLit(Boolean(isLit));
      },
      get position() {
        return report()?.position ?? [0, 0, 0];
      },
      get luminousIntensity() {
        return report()?.luminousIntensity ?? 0;
      },
      get colorTemperature() {
        return report()?.colorTemperature ?? 0;
      },
      light: () => setLit(true),
      extinguish: () => setLit(false),
      blow: (strength = 1) => blow(strength),
    };
  }

  #change(action: (source: CandleFlame) => void): void {
    if (!this.#source) return;
    action(this.#source);
    this.#onChange();
  }
}
