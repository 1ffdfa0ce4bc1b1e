// Tone LUT: the display transform as a 3D table of display colours, over the fourth roots of white-balanced exposed
// light.

const float TONE_LUT_SIZE = 32.0;
// Light at the end of the table, where white is about 1.
const float TONE_LUT_MAX = 12.0;
