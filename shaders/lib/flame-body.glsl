// The flame's body: a table over radius and height, bent along a spine. Lengths are in metres from its foot.

// Radius of the table, in luminous radii.
const float BODY_REACH = 1.25;
const int NODES = 16;
const int SPHERES = 8;
const int WICK_NODES = 4;

layout(std140) uniform Flame {
  vec3 base;      // its foot in the room, m
  float steps;    // of the march
  vec3 tip;       // end of the spine, m
  float radius;   // m
  float extent;   // luminous length along the spine, m
  float soot;     // factors on the table
  float blue;
  vec4 nodes[NODES];  // evenly spaced on the way to the tip: x, y, z (m), share of the length
  vec4 necks[NODES];  // of each node: factor on the radius
  vec4 spheres[SPHERES];  // bounding spheres: centre, radius, m
  vec4 wick[WICK_NODES];  // its centre line: x, y, z, m
} flame;

// Over a page the outline is drawn half a pixel farther out, m, and fades across a whole one.
#ifdef ALONE
#define MARGIN (0.5 * length(frame.eyePosition - flame.base) / frame.projectionScale)
#else
#define MARGIN 0.0
#endif
