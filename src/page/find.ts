/** The element of a selector in our own markup; throws if there is none. */
export function find<Type extends Element>(
  root: ParentNode,
  selector: string,
  type: abstract new () => Type,
): Type {
  const element = root.querySelector(selector);
  if (element instanceof type) return element;
  throw new Error(`The page's markup has no ${selector}.`);
}
