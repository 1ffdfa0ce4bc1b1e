// The samples around the middle of a texel of the light, by number.

const int AROUND = 4;  // along each axis
const int MIDDLE = 10;

ivec2 aside(int number) {
  return ivec2(number % AROUND, number / AROUND) - AROUND / 2;
}
