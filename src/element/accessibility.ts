import { SETTINGS } from "../settings.js";
import type { Overlay } from "./overlay.js";
import type { ReflectedAttributes } from "./reflected-attributes.js";

const ATTRIBUTES = {
  role: "role",
  ariaLabel: "aria-label",
  ariaDescription: "aria-description",
} as const;
type Semantic = keyof typeof ATTRIBUTES;

/**
 * Accessibility of the element: role, name, description and focus, of itself, its canvas and its poster.
 *
 * With `controls` the element is an application that takes the focus; without, the canvas alone is an image. The
 * element sets default semantics, which the page's attributes override.
 */
export class Accessibility {
  readonly #host: ReflectedAttributes;
  readonly #internals: ElementInternals;
  readonly #overlay: Overlay;
  readonly #own: Partial<Record<Semantic, string | null>> = {};
  #hadControls = false;

  constructor(host: ReflectedAttributes, internals: ElementInternals, overlay: Overlay) {
    this.#host = host;
    this.#internals = internals;
    this.#overlay = overlay;
  }

  /** To be called when `controls`, `alt`, the canvas or the failure has changed. */
  update(canvas: HTMLCanvasElement | null): void {
    const host = this.#host;
    const { alt, controls } = host;
    const { isFailing } = this.#overlay;
    // Not the element itself: screen readers read nothing of an image but its name, and the hint must be read.
    const isImage = !controls && !isFailing;
    const role = isFailing ? "group" : "application";
    this.#setSemantics({
      role: isImage ? null : role,
      // What takes the focus has a name.
      ariaLabel: isImage ? null : alt || SETTINGS.alt.default,
      ariaDescription:
        controls && !isFailing ? "Press Enter to take control, Escape to leave." : null,
    });
    this.#overlay.posterAlt = isImage ? alt : "";
    // An empty text is of an image without meaning.
    const isNamed = isImage && alt !== "";
    this.#overlay.hint.element.hidden = isImage && !isNamed;
    canvas?.setAttribute("role", isNamed ? "img" : "presentation");
    if (isNamed) canvas?.setAttribute("aria-label", alt);
    else canvas?.removeAttribute("aria-label");
    const isOwn = host.getAttribute("tabindex") === "0"; // in copies of the element, too
    if (controls && !host.hasAttribute("tabindex")) host.tabIndex = 0;
    else if (!controls && this.#hadControls && isOwn) host.removeAttribute("tabindex");
    this.#hadControls = controls;
  }

  /** `ElementInternals`, or in Firefox before 119 the attribute itself unless the page has set it. */
  #setSemantics(semantics: Readonly<Record<Semantic, string | null>>): void {
    for (const [name, attribute] of Object.entries(ATTRIBUTES) as [Semantic, string][]) {
      const value = semantics[name];
      const present = this.#host.getAttribute(attribute);
      if (name in this.#internals) {
        this.#internals[name] = value;
      } else if (present === null || present === this.#own[name]) {
        this.#own[name] = value;
        if (value === null) this.#host.removeAttribute(attribute);
        else this.#host.setAttribute(attribute, value);
      }
    }
  }
}
