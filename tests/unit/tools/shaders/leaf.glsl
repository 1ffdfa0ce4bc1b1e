// Needs nothing.
float leaf(float x) { return x; /* MARKER_IN_LEAF */ }
