export function barChart(chart: {
  title: string;
  unit: string;
  rows: readonly { label: string; values: readonly number[] }[];
  series: readonly string[];
}): string;
