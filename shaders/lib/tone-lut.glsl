// The display transform as a 3D table over the fourth roots of exposed, white-balanced light.

const float TONE_LUT_SIZE = 32.0;
// Light at the end of the table, where white is about 1.
const float TONE_LUT_MAX = 12.0;
