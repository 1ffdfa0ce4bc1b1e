/** The names on the command line, or all; one that is none of them would do nothing, and pass. */
export function chosenNames(names) {
  const chosen = process.argv.slice(2);
  const unknown = chosen.find((name) => !names.includes(name));
  if (unknown !== undefined) throw new Error(`There is no ${unknown}, but ${names.join(", ")}.`);
  return chosen.length > 0 ? chosen : names;
}
