import "../../define.js";
import { bindLiveFigure } from "./live-figure.js";

document.querySelectorAll<HTMLElement>("figure.live").forEach(bindLiveFigure);
