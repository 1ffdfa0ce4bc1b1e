#version 300 es
#include "../tests/unit/tools/shaders/no-such-file.glsl"
