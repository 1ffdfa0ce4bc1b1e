// The moon as a light source, and the night behind the window: 1 lx on a surface outside that faces it. Light and sky are
// white here: their colour is that of the layer's intensity.

layout(std140) uniform Moon {
  vec3 position;       // corner of the moon's map, before the room, m
  float depth;         // of the map, m
  vec3 across;         // edges of the map, perpendicular to the light, m
  float surfelArea;    // of a surfel's column of light, m²
  vec3 up;
  float sky;           // luminance of the sky, cd/m²
  vec3 direction;      // in which the light goes, length 1
  float paneArea;      // of the window, m²; 0 where there is none
  vec3 paneCorner;     // of the window's panes, m
  float surfelColumns;
  vec3 paneAcross;     // edges of the panes, m
  vec3 paneUp;
  vec3 paneNormal;     // into the room
  float paneRows;      // of surfels on the panes
  vec3 luma;           // weights of luma, times its colour
} moon;

// Luminance of radiance that was computed for white moonlight, cd/m².
float moonLuma(vec3 color) {
  return dot(color, moon.luma);
}

// Tangent of the moon's angular radius, 0.26 degrees.
const float MOON_TANGENT = 0.00454;

// A caster less far before the lit plane is the plane, m.
const float MOON_BIAS = 0.003;

// Place of a point on the map, as shares of its edges, and its depth, m.
vec3 onMoonMap(vec3 point) {
  vec3 d = point - moon.position;
  float across = dot(d, moon.across) / dot(moon.across, moon.across);
  return vec3(across, dot(d, moon.up) / dot(moon.up, moon.up), dot(d, moon.direction));
}

bool isOnMap(vec2 place) {
  return all(greaterThanEqual(place, vec2(0.0))) && all(lessThan(place, vec2(1.0)));
}

// The wood's luminance as a share of the sky's, and the mean height of its line over the horizon, as a slope.
const float WOOD = 0.06;
const float TREES = -0.01;

// Luminance of the night at a slope over the horizon as a share of the sky's, above an edge of trees: brighter towards
// the horizon, by scattering in the air.
float nightShare(float slope, float edge) {
  float sky = 1.0 + 0.5 * exp(-4.0 * max(slope, 0.0));
  return mix(WOOD, sky, smoothstep(-0.004, 0.004, slope - edge));
}

// The same through a pane, in a direction of length 1.
float paneShare(vec3 direction) {
  return nightShare(direction.y / max(length(direction.xz), 1e-3), TREES);
}

// Distance before the panes up to which a surface may be one: glass is never flat, m.
const float PANE_DEPTH = 0.02;
// What is rougher there is the frame.
const float PANE_ROUGHNESS = 0.15;

// Place of a point of the panes' plane, as shares of their edges.
vec2 onPanes(vec3 fromCorner) {
  return vec2(dot(fromCorner, moon.paneAcross) / dot(moon.paneAcross, moon.paneAcross),
    dot(fromCorner, moon.paneUp) / dot(moon.paneUp, moon.paneUp));
}

// Whether a point lies on the window's panes.
bool isOnPane(vec3 point) {
  vec3 d = point - moon.paneCorner;
  return moon.paneArea > 0.0 && isOnMap(onPanes(d)) && abs(dot(d, moon.paneNormal)) < PANE_DEPTH;
}

// Whether the light to a point passes through the panes, if there are any, and not through joints of walls.
bool isInBeam(vec3 point) {
  vec3 d = point - moon.paneCorner;
  float way = dot(d, moon.paneNormal) / max(dot(moon.direction, moon.paneNormal), 1e-4);
  // Its penumbra is cast by the frame, which lies over the panes' rims.
  vec2 slack = (way * MOON_TANGENT + PANE_DEPTH) / vec2(length(moon.paneAcross), length(moon.paneUp));
  vec2 place = (onPanes(d - way * moon.direction) + slack) / (1.0 + 2.0 * slack);
  return moon.paneArea <= 0.0 || (way > -PANE_DEPTH && isOnMap(place));
}
