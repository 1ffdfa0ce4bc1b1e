// @ts-expect-error: the analyzer's command line has no types.
import { cli } from "@custom-elements-manifest/analyzer/cli.js";
import { SETTING_MEANINGS } from "../src/page/meanings.ts";
import { INSPECTIONS, SETTINGS, type SettingName } from "../src/settings.ts";

const SOURCE = "src/candle-flame-element.ts";
const TYPES = { number: "number", flag: "boolean", text: "string" } as const;

interface Described {
  readonly name: string;
  readonly description?: string;
  readonly default?: string;
  readonly type?: { readonly text: string };
}

/** What the analyzer reads of the class, that is used here. */
interface Declaration extends Described {
  readonly members: readonly (Described & { readonly kind: string; readonly privacy?: string })[];
  readonly events: readonly Described[];
  readonly slots: readonly Described[];
  readonly cssParts: readonly Described[];
  readonly cssStates: readonly Described[];
  readonly cssProperties: readonly Described[];
}

const union = (values: readonly string[]) => values.map((value) => `"${value}"`).join(" | ");

/**
 * The custom elements manifest, schema 1.0.0, which describes the tag to editors: what
 * `@custom-elements-manifest/analyzer` reads of the class, and the attributes, which the class has from the
 * table of settings.
 */
export async function manifest() {
  // It writes the folder into package.json, whatever else it is told.
  const argv = ["analyze", "--quiet", "--outdir", "dist", "--globs", SOURCE];
  const analyzed = await cli({ argv, noWrite: true });
  const analyzedClass: Declaration = analyzed.modules[0].declarations[0];
  const attributes = Object.entries(SETTINGS).map(([name, setting]) => ({
    name,
    fieldName: name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase()),
    description: SETTING_MEANINGS[name as SettingName],
    type: { text: setting.kind === "choice" ? union(setting.choices) : TYPES[setting.kind] },
    ...("default" in setting ? { default: JSON.stringify(setting.default) } : {}),
  }));
  const fields = attributes.map(({ fieldName: name, description, type }) => {
    return { kind: "field", name, description, type };
  });
  const members = analyzedClass.members
    .filter(({ privacy }) => privacy === undefined)
    .map((member) =>
      member.name === "inspect" ? { ...member, type: { text: union(INSPECTIONS) } } : member,
    );
  const superclass = { name: "HTMLElement" };
  const path = "dist/candle-flame-element.js";
  const declaration = { name: analyzedClass.name, module: path };
  return {
    schemaVersion: "1.0.0",
    modules: [
      {
        kind: "javascript-module",
        path,
        declarations: [
          { ...analyzedClass, superclass, attributes, members: [...fields, ...members] },
        ],
        exports: [{ kind: "js", name: declaration.name, declaration }],
      },
      {
        kind: "javascript-module",
        path: "dist/define.js",
        exports: [{ kind: "custom-element-definition", name: "candle-flame", declaration }],
      },
    ],
  };
}
