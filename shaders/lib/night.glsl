// Ambient light of a dark room at night, from a window: mean radiance, cd/m².
// Its hue looks like moonlight to an eye adapted to candlelight.
const vec3 NIGHT = vec3(0.0096, 0.0055, 0.00036);
