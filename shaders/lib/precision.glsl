// Default precisions: samplers would be lowp in fragment shaders.
precision highp float;
precision highp int;
precision highp sampler2D;
