export { SmokePass } from "../render/volumetric/smoke-pass.js";
export { createPlume } from "../world/air/plume.js";
