/** The element that a selector finds in our own markup; none there is a mistake of ours. */
export function find<Type extends Element>(
  root: ParentNode,
  selector: string,
  type: abstract new () => Type,
): Type {
  const element = root.querySelector(selector);
  if (element instanceof type) return element;
  throw new Error(`The page's markup has no ${selector}.`);
}
