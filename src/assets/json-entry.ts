import { Flaw } from "./asset-error.js";

/** An object of an untrusted JSON file; each field is read by its type. */
export class JsonEntry {
  readonly #fields: Readonly<Record<string, unknown>>;
  readonly #place: string;

  /** @param place its path in the file, for error messages */
  constructor(value: unknown, place: string) {
    if (!isObject(value)) throw new Flaw(`is broken: ${place} is not an object`);
    this.#fields = value;
    this.#place = place;
  }

  names(): string[] {
    return Object.keys(this.#fields);
  }

  has(name: string): boolean {
    return Object.hasOwn(this.#fields, name);
  }

  wrong(name: string, what: string): Flaw {
    return new Flaw(`is broken: ${this.#placeOf(name)} ${what}`);
  }

  string(name: string): string | undefined {
    const value = this.value(name);
    return typeof value === "string" ? value : undefined;
  }

  boolean(name: string): boolean {
    return this.value(name) === true;
  }

  number(name: string): number | undefined {
    return this.#typed(name, isNumber, "is not a number");
  }

  /** The raw value, of any type. */
  value(name: string): unknown {
    return this.has(name) ? this.#fields[name] : undefined;
  }

  /** A whole number from 0. */
  whole(name: string): number | undefined {
    return this.#typed(name, isWhole, "is not a whole number");
  }

  /** The number of an entry in a list of so many. */
  index(name: string, count: number): number | undefined {
    const value = this.whole(name);
    if (value !== undefined && value >= count) throw this.wrong(name, "names what is not there");
    return value;
  }

  indices(name: string, count: number): number[] {
    return this.#list(name).map((value) => {
      if (!isWhole(value) || value >= count) throw this.wrong(name, "names what is not there");
      return value;
    });
  }

  /** So many numbers; any number of them without a count. */
  numbers(name: string, count?: number): number[] | undefined {
    if (!this.has(name)) return undefined;
    const values = this.#list(name);
    if (!values.every(isNumber)) throw this.wrong(name, "holds what is not a number");
    if (count !== undefined && values.length !== count) {
      throw this.wrong(name, `does not hold ${count} numbers`);
    }
    return values;
  }

  strings(name: string): string[] {
    return this.#list(name).filter((value) => typeof value === "string");
  }

  entry(name: string): JsonEntry | undefined {
    const value = this.value(name);
    return value === undefined ? undefined : new JsonEntry(value, this.#placeOf(name));
  }

  entries(name: string): JsonEntry[] {
    return this.#list(name).map(
      (value, index) => new JsonEntry(value, `${this.#placeOf(name)}[${index}]`),
    );
  }

  extension(name: string): JsonEntry | undefined {
    return this.entry("extensions")?.entry(name);
  }

  /** Application-specific data, of any type. */
  extras(): JsonEntry | undefined {
    const value = this.value("extras");
    return isObject(value) ? new JsonEntry(value, this.#placeOf("extras")) : undefined;
  }

  #typed<T>(name: string, isOne: (value: unknown) => value is T, flaw: string): T | undefined {
    const value = this.value(name);
    if (value === undefined || isOne(value)) return value;
    throw this.wrong(name, flaw);
  }

  #list(name: string): unknown[] {
    const value = this.value(name);
    if (value === undefined) return [];
    if (!Array.isArray(value)) throw this.wrong(name, "is not a list");
    return value;
  }

  #placeOf(name: string): string {
    return this.#place === "" ? name : `${this.#place}.${name}`;
  }
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

const isNumber = (value: unknown): value is number =>
  typeof value === "number" && Number.isFinite(value);

const isWhole = (value: unknown): value is number =>
  Number.isSafeInteger(value) && Number(value) >= 0;
