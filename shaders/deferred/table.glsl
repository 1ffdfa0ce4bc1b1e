// The display's law as a table: colours on the screen over the roots of exposed light.

const float TABLE_SIZE = 32.0;
// Light at the end of the table, where white is about 1.
const float TABLE_LIGHT = 12.0;
