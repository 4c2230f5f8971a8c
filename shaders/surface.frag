// A character's skin: matte under a warm key, a cool sky and a rim light.
uniform vec4 base_colour;   // linear
uniform vec2 alpha_range;   // only what is at least as opaque as x and less than y is drawn
uniform float shading;      // 1: lit; 0: the colour as it is (heat maps use something between)
uniform vec3 emissive;      // linear: light of its own
in vec3 position_scene;
#if MARROW_NORMAL
in vec3 normal_scene;
#endif
#if MARROW_UV
uniform highp sampler2D base_texture;
uniform highp sampler2D emissive_texture;
in vec2 uv;
#endif
#if MARROW_COLOUR || MARROW_PALETTES == 2
in vec4 vertex_colour;
#endif
out vec4 frag_colour;

const vec3 kRimColour = vec3(0.9, 1.05, 1.3);

// Schlick's Fresnel and a GGX lobe of middling roughness; no visibility term, which at this gloss cannot be seen.
float gloss(vec3 n, vec3 v, vec3 l) {
  const float alpha2 = 0.09;
  vec3 h = normalize(v + l);
  float nh = max(dot(n, h), 0.0);
  float d = nh * nh * (alpha2 - 1.0) + 1.0;
  float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(v, h), 0.0), 5.0);
  return fresnel * alpha2 / (d * d) * 0.25 * max(dot(n, l), 0.0);
}

void main() {
  vec4 base = base_colour;
  vec3 glow = emissive;
#if MARROW_UV
  base *= texture(base_texture, uv);
  glow *= texture(emissive_texture, uv).rgb;
#endif
#if MARROW_COLOUR || MARROW_PALETTES == 2
  base *= vertex_colour;
#endif
  bool drawn = base.a >= alpha_range.x && base.a < alpha_range.y;
  vec3 view = normalize(camera_position - position_scene);
  vec3 facet = normalize(cross(dFdx(position_scene), dFdy(position_scene)));
  if (dot(facet, view) < 0.0) facet = -facet;
#if MARROW_NORMAL
  float size = length(normal_scene);
  vec3 normal = size > 0.01 ? normal_scene / size : facet;
  // The back of an open surface. Not at the slightest disagreement: there are files whose normals are that far off.
  if (dot(normal, facet) < -0.85) normal = -normal;
#else
  vec3 normal = facet;
#endif

  if (!drawn) discard;  // not before: neighbours need the derivatives
  vec3 albedo = base.rgb;

  float turn = noise(gl_FragCoord.xy);
  float cosine = dot(normal, key_direction);
  vec3 lifted = position_scene + normal * (0.012 * scene_radius);
  float visible = cosine > -0.3 ? key_visibility(lifted, 0.10, 0.006 * scene_radius, turn) : 0.0;
  float key = max((cosine + 0.12) / 1.12, 0.0) * visible;

  // The nearer the ground, the less sky; the more warm light thrown back from it.
  float height = (position_scene.y - ground_height) / scene_radius;
  float open = mix(0.45, 1.0, smoothstep(0.0, 0.5, height));
  float up = normal.y * 0.5 + 0.5;
  vec3 ambient = mix(kBounceColour * open, kSkyColour * mix(open, 1.0, up), up);
  vec3 fill_direction = normalize(vec3(-key_direction.x, 0.25, key_direction.z));
  vec3 fill = vec3(0.2, 0.27, 0.36) * max(dot(normal, fill_direction) * 0.6 + 0.4, 0.0);

  // Painters' white is 1, but no paint reflects more than about 0.8 of the light: whites would burn out.
  float brightest = max(albedo.r, max(albedo.g, albedo.b));
  vec3 paint = albedo * (1.0 - 0.22 * smoothstep(0.5, 1.0, brightest));
  vec3 light = paint * (key * kKeyColour / 3.14159 * 1.25 + ambient * 0.62 + fill);
  light += kKeyColour * gloss(normal, view, key_direction) * visible * 0.55;
  // From behind, on the side away from the key.
  vec3 rim_direction = normalize(vec3(-key_direction.x, 0.55, -key_direction.z));
  float edge = pow(1.0 - max(dot(normal, view), 0.0), 3.0);
  light += kRimColour * (paint * 0.7 + 0.06) * edge * smoothstep(-0.1, 0.8, dot(normal, rim_direction)) * open;

  light += glow;

  vec3 plain = albedo * (0.80 + 0.20 * max(dot(normal, view), 0.0));
  frag_colour = vec4(dither(mix(plain, film(light), shading), gl_FragCoord.xy), base.a);
}
