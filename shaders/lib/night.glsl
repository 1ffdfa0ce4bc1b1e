// What light there is in a dark room besides the flame's: the glow of the night in a window.
// It has the hue that looks like moonlight to an eye that has adapted to a candle.
const vec3 NIGHT = vec3(0.0096, 0.0055, 0.00036);  // mean radiance, cd/m²
