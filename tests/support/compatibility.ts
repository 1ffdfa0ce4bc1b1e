import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { CompatData, CompatStatement, Identifier } from "@mdn/browser-compat-data";
import { type CssNode, type PseudoClassSelector, parse, type WalkContext, walk } from "css-tree";
import { OLDEST_BROWSERS } from "../../tools/oldest-browsers.ts";

const FILE = createRequire(import.meta.url).resolve("@mdn/browser-compat-data");
/** MDN's browser compatibility data. */
const DATA: CompatData = JSON.parse(readFileSync(FILE, "utf8"));
const CSS = DATA.css as Record<"at-rules" | "properties" | "selectors" | "types", Identifier>;
const HTML = DATA.html as Record<"elements" | "global_attributes", Identifier>;

/** The oldest supported browsers that lack a feature, each with the version that has it first. */
function lackingIn(statement: CompatStatement): string[] {
  return OLDEST_BROWSERS.flatMap(({ name, version }) => {
    const support = statement.support[name];
    const all = Array.isArray(support) ? support : support ? [support] : [];
    const isThere = all.some(
      (entry) =>
        !entry.flags &&
        !entry.prefix &&
        !entry.alternative_name &&
        !entry.partial_implementation &&
        typeof entry.version_added === "string" &&
        isAtMost(entry.version_added.replace("≤", ""), version) &&
        !(typeof entry.version_removed === "string" && isAtMost(entry.version_removed, version)),
    );
    return isThere ? [] : [`${name} ${version}`];
  });
}

function isAtMost(version: string, limit: string): boolean {
  const [a = [], b = []] = [version, limit].map((text) => text.split(".").map(Number));
  const part = a.findIndex((number, i) => number !== (b[i] ?? 0));
  return part < 0 || (a[part] ?? Number.NaN) < (b[part] ?? 0);
}

/** What lacks it, in words; null where nothing does, or where MDN knows no such feature. */
function lackOf(feature: string, entry: Identifier | undefined): string | null {
  const statement = entry?.__compat;
  const browsers = statement ? lackingIn(statement) : [];
  return browsers.length > 0 ? `${feature}: not in ${browsers.join(", ")}` : null;
}

const said = (lack: string | null): string[] => (lack === null ? [] : [lack]);
const own = (entry: Identifier | undefined, key: string): Identifier | undefined =>
  entry && Object.hasOwn(entry, key) ? entry[key] : undefined;

/** CSS functions, wherever MDN files them: `color-mix` is a color, `linear-gradient` an image. */
const FUNCTIONS = new Map<string, Identifier>();
(function file(entry: Identifier) {
  for (const [name, inner] of Object.entries(entry)) {
    if (name === "__compat") continue;
    FUNCTIONS.set(name, inner as Identifier);
    file(inner as Identifier);
  }
})(CSS.types);

const MEDIA = own(CSS["at-rules"], "media");

const UNITS = [
  [/^d(v[whib]|vmin|vmax)$/, "viewport_percentage_units_dynamic"],
  [/^[sl](v[whib]|vmin|vmax)$/, "viewport_percentage_units_small"],
  [/^cq/, "container_query_length_units"],
] as const;

/** What a style sheet uses that some of the oldest supported browsers lack: `:has(): not in firefox 115`. */
export function lacksOfCss(css: string): string[] {
  const lacks = new Set<string>();
  const look = (feature: string, entry: Identifier | undefined) => {
    const lack = lackOf(feature, entry);
    if (lack) lacks.add(lack);
  };
  const onParseError = ({ message }: Error) => lacks.add(`syntax: ${message}`);
  const tree = parse(css, { parseCustomProperty: false, onParseError });
  walk(tree, function (this: WalkContext, node) {
    const property = this.declaration && own(CSS.properties, this.declaration.property);
    switch (node.type) {
      case "SelectorList":
        for (const lack of lacksOfSelector(node)) lacks.add(lack);
        return walk.skip;
      case "Rule":
        if (this.rule) look("nesting", own(CSS.selectors, "nesting"));
        return;
      case "Atrule":
        look(`@${node.name}`, own(CSS["at-rules"], node.name));
        // What it holds is for those who have what it asks for.
        return node.name === "supports" ? walk.skip : undefined;
      case "Feature":
        look(`@media (${node.name})`, own(MEDIA, node.name.replace(/^(min|max)-/, "")));
        return;
      case "FeatureRange":
        look("@media ranges", own(MEDIA, "range_syntax"));
        return;
      case "Declaration":
        if (/^-/.test(node.property)) return;
        if (!own(CSS.properties, node.property)) lacks.add(`${node.property}: unknown`);
        look(node.property, own(CSS.properties, node.property));
        return;
      case "Identifier":
        look(`${this.declaration?.property}: ${node.name}`, own(property ?? undefined, node.name));
        return;
      case "Function":
        look(`${node.name}()`, own(property ?? undefined, node.name) ?? FUNCTIONS.get(node.name));
        return;
      case "Dimension": {
        const [, unit = node.unit] = UNITS.find(([form]) => form.test(node.unit)) ?? [];
        look(node.unit, own(own(CSS.types, "length"), unit));
      }
    }
  });
  return [...lacks].sort();
}

/** An unknown selector invalidates the whole list, except in `:is()` and `:where()` beside one that is known. */
function lacksOfSelector(selector: CssNode): string[] {
  const lacks: string[] = [];
  walk(selector, (node) => {
    if (node.type === "NestingSelector")
      lacks.push(...said(lackOf("nesting", own(CSS.selectors, "nesting"))));
    if (node.type !== "PseudoClassSelector" && node.type !== "PseudoElementSelector") return;
    if (node.name.startsWith("-")) return;
    const entry = own(CSS.selectors, node.name);
    lacks.push(...said(entry ? lackOf(`:${node.name}`, entry) : `:${node.name}: unknown`));
    if (node.type === "PseudoElementSelector" || !/^(is|where)$/.test(node.name)) return;
    const choices = choicesOf(node).map(lacksOfSelector);
    if (choices.every(({ length }) => length > 0)) lacks.push(...choices.flat());
    return walk.skip;
  });
  return lacks;
}

function choicesOf({ children }: PseudoClassSelector): CssNode[] {
  return [...(children ?? [])].flatMap((list) =>
    list.type === "SelectorList" ? [...list.children] : [list],
  );
}

/** What markup uses that some of the oldest supported browsers lack: elements and attributes. */
export function lacksOfHtml(html: string): string[] {
  const lacks = new Set<string>();
  for (const [, tag = "", attributes = ""] of html.matchAll(
    /<([a-z][\w-]*)((?:\s+[\w-]+(?:="[^"]*")?)*)\s*\/?>/g,
  )) {
    const element = own(HTML.elements, tag);
    const names = [...attributes.matchAll(/([\w-]+)(?:="[^"]*")?/g)].map(([, name = ""]) => name);
    const found = [
      lackOf(`<${tag}>`, element),
      ...names.map((name) =>
        lackOf(`<${tag} ${name}>`, own(element, name) ?? own(HTML.global_attributes, name)),
      ),
    ];
    for (const lack of found) if (lack) lacks.add(lack);
  }
  return [...lacks].sort();
}

/** The oldest supported browsers that do not read a kind of picture. */
export function lacksOfPicture(kind: string): string[] {
  return said(lackOf(kind, own(own(DATA.mediatypes as Identifier, "image"), kind)));
}

/** Each interface's members and each builtin's, by the member's name. */
const MEMBERS = new Map<string, Identifier[]>();
const INTERFACES = new Map<string, Identifier>();
for (const library of [DATA.api, DATA.javascript.builtins] as readonly Identifier[]) {
  for (const [name, entry] of Object.entries(library)) {
    INTERFACES.set(name, entry as Identifier);
    for (const [key, member] of Object.entries(entry as Identifier)) {
      if (key === "__compat" || key === name) continue;
      const own = key.replace(/_static$/, "");
      MEMBERS.set(own, [...(MEMBERS.get(own) ?? []), member as Identifier]);
    }
  }
}

/**
 * What a script uses that some of the oldest supported browsers lack: interfaces and functions by their names,
 * `URL.canParse` by both, and members that no interface has had for longer.
 *
 * @param ours members that our own code declares
 */
export function lacksOfScript(source: string, ours: ReadonlySet<string>): string[] {
  const code = source.replaceAll(/\/\*[\s\S]*?\*\/|^\s*\/\/.*$|(?<=[\s;])\/\/ .*$/gm, "");
  const lacks = new Set<string>();
  for (const [, target, name = ""] of code.matchAll(/(?:\b([A-Z]\w*))?\??\.(\w+)\b/g)) {
    const entry = target === undefined ? undefined : INTERFACES.get(target);
    const member = own(entry, `${name}_static`) ?? own(entry, name);
    const members = member ? [member] : ours.has(name) ? [] : (MEMBERS.get(name) ?? []);
    const found = members.map((one) => lackOf(member ? `${target}.${name}` : `.${name}`, one));
    const [first] = found;
    if (first && found.every((lack) => lack !== null)) lacks.add(first);
  }
  for (const [, made, called] of code.matchAll(/\bnew ([A-Z]\w*)|(?<![.\w#])([a-z]\w*)\(/gi)) {
    const name = made ?? called ?? "";
    const lack = ours.has(name) ? null : lackOf(name, INTERFACES.get(name));
    if (lack) lacks.add(lack);
  }
  return [...lacks].sort();
}

/** Names of members that a script declares. */
export function declaredIn(source: string): string[] {
  const declared =
    /\b(?:readonly|get|set|const|let|function|class) (\w+)|^ {2}(?:async |static )?(\w+)\(/gm;
  return [...source.matchAll(declared)].map(([, name, method]) => name ?? method ?? "");
}
