/**
 * Distance of each cell of a grid to the nearest marked one, middle to middle, in cells. Exact.
 *
 * Meijster, Roerdink and Hesselink 2000, "A General Algorithm for Computing Distance Transforms in
 * Linear Time": down and up the columns, then the lower envelope of parabolas along each row.
 */
export function distanceField(marked: Uint8Array, columns: number, rows: number): Float32Array {
  const field = new Float32Array(columns * rows);
  const far = columns + rows;
  for (let i = 0; i < field.length; i++) {
    field[i] = marked[i] ? 0 : i < columns ? far : Math.min(far, field[i - columns]! + 1);
  }
  for (let i = field.length - columns - 1; i >= 0; i--) {
    field[i] = Math.min(field[i]!, field[i + columns]! + 1);
  }
  const square = new Float64Array(columns);
  const apex = new Int32Array(columns);
  const from = new Int32Array(columns);
  for (let start = 0; start < field.length; start += columns) {
    for (let i = 0; i < columns; i++) square[i] = field[start + i]! ** 2;
    let last = 0;
    apex[0] = 0;
    from[0] = 0;
    for (let i = 1; i < columns; i++) {
      while (last >= 0) {
        const t = from[last]!;
        const a = apex[last]!;
        if ((t - a) ** 2 + square[a]! <= (t - i) ** 2 + square[i]!) break;
        last--;
      }
      if (last < 0) {
        last = 0;
        apex[0] = i;
        continue;
      }
      const a = apex[last]!;
      // First cell at which the parabola of i is lower than that of a.
      const begin = 1 + Math.floor((i * i - a * a + square[i]! - square[a]!) / (2 * (i - a)));
      if (begin >= columns) continue;
      last++;
      apex[last] = i;
      from[last] = begin;
    }
    for (let i = columns - 1; i >= 0; i--) {
      field[start + i] = Math.sqrt((i - apex[last]!) ** 2 + square[apex[last]!]!);
      if (i === from[last]) last--;
    }
  }
  return field;
}
