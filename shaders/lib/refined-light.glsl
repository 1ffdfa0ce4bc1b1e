// The two lights that a refined image is kept in: exposed intensity of the brighter over that of the dimmer.

const float REFERENCE_RATIO = 1.3;
const float DISPLAY_POWER = 0.45;
