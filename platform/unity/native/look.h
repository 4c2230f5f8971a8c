/* How render events draw: a colour, and light from above the camera. For another look change these two texts. */
static const char kVertexText[] =
    "uniform mat4 clip_from_model;\n"
    "out vec3 normal, vertex_colour;\n"
    "void main() {\n"
    "  MarrowVertex v = marrow_skin();\n"
    "  normal = v.normal;\n"
    "  vertex_colour = vec3(1.0);\n"
    "#if MARROW_COLOUR\n"
    "  vertex_colour = in_colour.rgb;\n"
    "#endif\n"
    "  gl_Position = clip_from_model * vec4(v.position, 1.0);\n"
    "}\n";
static const char kFragmentText[] =
    "precision highp float;\n"
    "uniform vec4 base_colour;\n"
    "in vec3 normal, vertex_colour;\n"
    "out vec4 colour;\n"
    "void main() {\n"
    "  vec3 n = normal * inversesqrt(max(dot(normal, normal), 1e-9));\n"
    "  float light = 0.35 + 0.65 * max(dot(n, vec3(0.37, 0.74, 0.56)), 0.0);\n"
    "  colour = vec4(sqrt(base_colour.rgb * vertex_colour * light), base_colour.a);\n"
    "}\n";
