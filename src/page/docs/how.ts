import "../../define.js";
import { LiveFigure } from "./live-figure.js";

for (const figure of document.querySelectorAll<HTMLElement>("figure.live")) new LiveFigure(figure);
