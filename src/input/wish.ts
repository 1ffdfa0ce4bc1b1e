import type { Intent } from "../world/intent.js";

/** What is wanted once, not for as long as something is held. */
export type Wish = keyof Pick<Intent, "placesOrTakes" | "togglesFlame" | "blows">;
