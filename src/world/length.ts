/** Length of a level way. `Math.hypot` gathers its arguments in a list, anew for each call. */
export function length2(x: number, z: number): number {
  return Math.sqrt(x * x + z * z);
}

export function length3(x: number, y: number, z: number): number {
  return Math.sqrt(x * x + y * y + z * z);
}
