import { FEATURES, type Feature, type Features } from "../settings.js";

/** Features as properties that are on or off, whatever is written to them; no others can be added. */
export function featureSwitches(features: Features, onChange: (name: Feature) => void): Features {
  const switches = {} as Features;
  for (const name of FEATURES) {
    Object.defineProperty(switches, name, {
      enumerable: true,
      get: () => features[name],
      set: (value: unknown) => {
        if (features[name] === Boolean(value)) return;
        features[name] = Boolean(value);
        onChange(name);
      },
    });
  }
  return Object.seal(switches);
}
