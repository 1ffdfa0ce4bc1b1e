import type { CandleFlameElement } from "../candle-flame-element.js";

/**
 * The room as one sees it: beside another look, both at one moment, cut at the divider.
 *
 * @param stage holds the rooms, and the divider's place
 */
export async function photograph(room: CandleFlameElement, stage: HTMLElement): Promise<Blob> {
  const isComparing = document.body.classList.contains("comparing");
  const beside = isComparing ? stage.querySelector<CandleFlameElement>(".beside") : null;
  if (!beside) return room.toBlob();
  const share = Number.parseFloat(stage.style.getPropertyValue("--divider")) / 100;
  const images = [room, beside].map(async (one) => createImageBitmap(await one.toBlob()));
  const [right, left] = await Promise.all(images);
  if (!right || !left) throw new Error("A room has no image.");
  const { width, height } = right;
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const isWide = matchMedia("(color-gamut: p3)").matches;
  const context = canvas.getContext("2d", { colorSpace: isWide ? "display-p3" : "srgb" });
  if (!context) throw new Error("There is no 2D context.");
  context.drawImage(right, 0, 0);
  const cut = Math.round(share * width);
  if (cut > 0)
    context.drawImage(left, 0, 0, (left.width * cut) / width, left.height, 0, 0, cut, height);
  for (const image of [right, left]) image.close();
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("It is too large.")))),
  );
}
