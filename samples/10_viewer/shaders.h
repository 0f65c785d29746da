/* GLSL of the lit picture. */
#ifndef VIEWER_SHADERS_H
#define VIEWER_SHADERS_H

static const char* const solid_vertex =
    "layout(location = 0) in vec3 place; layout(location = 1) in vec3 normal; layout(location = 2) in vec3 colour;\n"
    "layout(location = 3) in vec2 uv;\n"
    "uniform mat4 model, view_projection, light;\n"
    "out vec3 at; out vec3 n; out vec3 base; out vec2 in_picture; out vec4 in_light;\n"
    "void main() {\n"
    "    vec4 world = model * vec4(place, 1.0);\n"
    "    at = world.xyz; n = mat3(model) * normal; base = colour; in_picture = uv;\n"
    "    in_light = light * world;\n"
    "    gl_Position = view_projection * world;\n"
    "}\n";

/* Shared by what receives the shadow: the share of the sun's light that arrives, from 16 samples of the shadow map. */
#define SHADOW_GLSL                                                                                                    \
    "uniform sampler2DShadow shadow;\n"                                                                                \
    "float sun_share(vec4 in_light, float bias) {\n"                                                                   \
    "    vec3 p = in_light.xyz / in_light.w * 0.5 + 0.5;\n"                                                            \
    "    if (any(lessThan(p, vec3(0.0))) || any(greaterThan(p, vec3(1.0)))) return 1.0;\n"                             \
    "    vec2 texel = 1.0 / vec2(textureSize(shadow, 0));\n"                                                           \
    "    float sum = 0.0;\n"                                                                                           \
    "    for (int i = 0; i < 16; i++)\n"                                                                               \
    "        sum += texture(shadow, vec3(p.xy + (vec2(i % 4, i / 4) - 1.5) * 1.3 * texel, p.z - bias));\n"             \
    "    return sum / 16.0;\n"                                                                                         \
    "}\n"

/* The normal is turned towards the camera: meshes made by people are often wound either way. */
static const char* const solid_fragment =
    "in vec3 at; in vec3 n; in vec3 base; in vec2 in_picture; in vec4 in_light;\n"
    "uniform vec3 eye, sun, up; uniform sampler2D picture;\n"
    "uniform vec4 tint; uniform float glow;\n"
    "out vec4 colour;\n" SHADOW_GLSL "void main() {\n"
    "    vec3 towards = normalize(eye - at);\n"
    "    vec3 flat_normal = normalize(cross(dFdx(at), dFdy(at)));\n"
    "    vec3 normal = length(n) > 0.5 ? normalize(n) : flat_normal;\n"
    "    if (dot(flat_normal, towards) < 0.0) flat_normal = -flat_normal;\n"
    "    if (dot(normal, flat_normal) < 0.0) normal = -normal;\n"
    "    vec3 albedo = mix(base * texture(picture, in_picture).rgb, tint.rgb, tint.a);\n"
    "    float facing = max(dot(normal, sun), 0.0);\n"
    "    float lit = facing * (facing > 0.0 ? sun_share(in_light, 0.0008 + 0.0025 * (1.0 - facing)) : 0.0);\n"
    "    float sky = dot(normal, up) * 0.5 + 0.5;\n"
    "    vec3 ambient = mix(vec3(0.20, 0.185, 0.17), vec3(0.44, 0.48, 0.54), sky);\n"
    "    vec3 fill = vec3(0.16) * max(dot(normal, towards), 0.0);\n"
    "    vec3 light = ambient + fill + vec3(1.25, 1.19, 1.08) * lit;\n"
    "    float shine = pow(max(dot(normal, normalize(towards + sun)), 0.0), 48.0) * 0.16 * lit;\n"
    "    float rim = pow(1.0 - max(dot(normal, towards), 0.0), 3.0);\n"
    "    vec3 sum = albedo * light + shine + rim * (0.06 + 0.4 * glow * tint.rgb);\n"
    "    sum = sum * (1.0 + sum * 0.12) / (1.0 + sum * 0.35);\n"
    "    colour = vec4(pow(sum, vec3(1.0 / 2.2)), 1.0);\n"
    "}\n";

static const char* const ghost_fragment = "in vec3 at; in vec3 n; in vec3 base; in vec4 in_light;\n"
                                          "uniform vec3 eye; uniform vec4 tint;\n"
                                          "out vec4 colour;\n"
                                          "void main() {\n"
                                          "    float edge = 1.0 - abs(dot(normalize(n + 1e-6), normalize(eye - at)));\n"
                                          "    colour = vec4(tint.rgb, tint.a * (0.25 + 0.75 * edge * edge));\n"
                                          "}\n";

static const char* const depth_fragment = "void main() {}\n";

/* One triangle over the whole screen. */
static const char* const sky_vertex = "out vec2 p;\n"
                                      "void main() {\n"
                                      "    p = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
                                      "    gl_Position = vec4(p, 1.0, 1.0);\n"
                                      "}\n";

static const char* const sky_fragment =
    "in vec2 p; out vec4 colour;\n"
    "void main() {\n"
    "    float t = clamp(p.y * 0.5 + 0.5, 0.0, 1.0);\n"
    "    colour = vec4(mix(vec3(0.80, 0.80, 0.79), vec3(0.56, 0.63, 0.71), t), 1.0);\n"
    "}\n";

static const char* const floor_vertex = "uniform mat4 view_projection, light; uniform vec3 middle, side, ahead;\n"
                                        "out vec2 p; out vec4 in_light;\n"
                                        "void main() {\n"
                                        "    p = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;\n"
                                        "    vec4 world = vec4(middle + side * p.x + ahead * p.y, 1.0);\n"
                                        "    in_light = light * world;\n"
                                        "    gl_Position = view_projection * world;\n"
                                        "}\n";

/* Fades into the sky's own colour; ruled every tenth of its half. */
static const char* const floor_fragment =
    "in vec2 p; in vec4 in_light; out vec4 colour;\n" SHADOW_GLSL "void main() {\n"
    "    float fade = 1.0 - smoothstep(0.35, 1.0, length(p));\n"
    "    vec2 cell = abs(fract(p * 10.0 + 0.5) - 0.5) / fwidth(p * 10.0);\n"
    "    float rule = 1.0 - clamp(min(cell.x, cell.y), 0.0, 1.0);\n"
    "    float share = sun_share(in_light, 0.0008);\n"
    "    vec3 ground = mix(vec3(0.40, 0.42, 0.46), vec3(0.83, 0.83, 0.82), share) - 0.05 * rule;\n"
    "    colour = vec4(ground, fade);\n"
    "}\n";

#endif
