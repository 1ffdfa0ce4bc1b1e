/** Plain bar charts as SVG: they inherit nothing, and read on light and on dark backgrounds. */

const WIDTH = 720;
const LABEL = 190;
const ROW = 26;
const HEAD = 56;

const asText = (text) =>
  String(text).replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");

/**
 * @param title what is shown
 * @param unit what the numbers count
 * @param rows label, and one value for each series
 * @param series names, in the order of the values
 */
export function barChart({ title, unit, rows, series }) {
  const colors = ["#c8741a", "#7d8b99", "#3e5a4b"];
  const most = Math.max(...rows.flatMap(({ values }) => values));
  const scale = (WIDTH - LABEL - 90) / most;
  const step = ROW * 0.62 * series.length + 12;
  const height = HEAD + rows.length * step + 8;
  const bar = (row, index) =>
    row.values
      .map((value, k) => {
        const y = HEAD + index * step + k * ROW * 0.62;
        const width = Math.max(1, value * scale).toFixed(1);
        return `<rect x="${LABEL}" y="${y.toFixed(1)}" width="${width}" height="13" fill="${colors[k]}"/>
<text x="${LABEL + Number(width) + 6}" y="${(y + 11).toFixed(1)}">${value.toFixed(2)}</text>`;
      })
      .join("\n");
  const legend = series
    .map(
      (name, k) =>
        `<rect x="${LABEL + k * 190}" y="30" width="12" height="12" fill="${colors[k]}"/>
<text x="${LABEL + k * 190 + 18}" y="41">${asText(name)}</text>`,
    )
    .join("\n");
  const labels = rows
    .map(
      ({ label }, index) =>
        `<text x="${LABEL - 10}" y="${(HEAD + index * step + 12).toFixed(1)}" text-anchor="end">${asText(label)}</text>`,
    )
    .join("\n");
  const spoken = rows.map(
    ({ label, values }) => `${label}: ${values.map((v) => v.toFixed(2)).join(", ")}`,
  );
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${height.toFixed(0)}" role="img" aria-labelledby="t d">
<title id="t">${asText(title)}</title>
<desc id="d">${asText(`${unit}; ${series.join(", ")}. ${spoken.join("; ")}.`)}</desc>
<rect width="100%" height="100%" fill="#fbf7f0"/>
<g font-family="system-ui, sans-serif" font-size="12" fill="#2a2019">
<text x="10" y="20" font-size="14" font-weight="600">${asText(title)}, ${asText(unit)}</text>
${legend}
${labels}
${rows.map(bar).join("\n")}
</g>
</svg>
`;
}
