// Tetrahedral interpolation in a cell of a grid: four of its eight corners, by the one of six tetrahedra that the place
// is in. Kasson, Nin, Plouffe and Hafner 1995, "Performing Color Space Conversions with Three-Dimensional Linear
// Interpolation".

struct Tetrahedron {
  vec4 weights;  // of its corners
  vec4 thresholds;  // corner i is at 1 along all axes along which the place is at least so far
};

// `share`: a place in the cell, 0 to 1 along each axis.
Tetrahedron tetrahedronAt(vec3 share) {
  float most = max(max(share.x, share.y), share.z);
  float least = min(min(share.x, share.y), share.z);
  // Exactly one of the three, which their sum less the others would not be: it is compared with them.
  float middle = max(min(share.x, share.y), min(max(share.x, share.y), share.z));
  return Tetrahedron(vec4(1.0 - most, most - middle, middle - least, least), vec4(2.0, most, middle, least));
}

vec3 tetrahedronCorner(Tetrahedron tetrahedron, int i, vec3 share) {
  return step(tetrahedron.thresholds[i], share);
}
