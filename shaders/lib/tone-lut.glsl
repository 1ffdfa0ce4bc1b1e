// The display's law as a table: colours on the screen over the fourth roots of exposed light, its channels
// such that light from a white thing has as much of each.

const float TONE_LUT_SIZE = 32.0;
// Light at the end of the table, where white is about 1.
const float TONE_LUT_MAX = 12.0;
