// Samplers are lowp in fragment shaders unless told otherwise.
precision highp float;
precision highp int;
precision highp sampler2D;
