/* show-texts.mjs - the shaders of the page's last draws, for WebGL 2 and, translated to WGSL by make web, for WebGPU:
   bodies in the GLSL that both dialects take. It does not use the page. */

/* Draws a side. kind: 0 unoccluded light, 1 ambient visibility, 2 light, 3 light and a bounce, 4 ground truth. */
const picture = `
vec3 harmonics(vec3 n, vec3 band) {
    vec3 l = u_sky[0].xyz * 0.282095 * band.x;
    l += (u_sky[1].xyz * n.y + u_sky[2].xyz * n.z + u_sky[3].xyz * n.x) * 0.488603 * band.y;
    l += (u_sky[4].xyz * 1.092548 * n.x * n.y + u_sky[5].xyz * 1.092548 * n.y * n.z
          + u_sky[6].xyz * (0.946175 * n.z * n.z - 0.315392) + u_sky[7].xyz * 1.092548 * n.x * n.z
          + u_sky[8].xyz * 0.546274 * (n.x * n.x - n.y * n.y)) * band.z;
    return max(l, 0.0);
}
vec3 coded(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(max(c, 1e-6), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
vec3 shown(vec3 c) { // the curve of film [Narkowicz 2016], then sRGB
    c = max(c, 0.0) * u_exposure;
    return coded(clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0));
}
float near(ivec2 p) { // 1 / view depth, which is linear on planes of the picture
    return u_decode.x + u_decode.y * texelFetch(t_depth, p, 0).x;
}
vec4 traced(ivec2 p) { // a: -1: nothing is known
    int apart = int(u_step);
    ivec2 last = textureSize(t_truth, 0) - 1, from = ivec2(apart >> 1);
    ivec2 nearest = clamp((p - from + (apart >> 1)) / apart, ivec2(0), last);
    vec4 here = texelFetch(t_truth, nearest, 0), sum = vec4(0.0);
    if (u_rough == 0.0) return here;
    vec3 n = texelFetch(t_normal, p, 0).xyz;
    float at = near(p) / dot(n, vec3((vec2(p) + 0.5) * u_ray.xy + u_ray.zw, -1.0)), all = 0.0;
    for (int i = 0; i < 25; ++i) {
        ivec2 t = clamp(nearest + ivec2(i % 5 - 2, i / 5 - 2), ivec2(0), last), q = from + apart * t;
        float there = near(q), plane = at * dot(n, vec3((vec2(q) + 0.5) * u_ray.xy + u_ray.zw, -1.0));
        vec4 of = texelFetch(t_truth, t, 0);
        vec2 off = max(2.5 - abs(vec2(p - q)) / u_step, 0.0);
        float weight = pow(max(dot(n, texelFetch(t_normal, q, 0).xyz), 0.0), 16.0) * off.x * off.y
            * exp2(-100.0 * abs(there / plane - 1.0)) * step(0.0, of.a);
        sum += weight * of;
        all += weight;
    }
    return all > 0.01 ? sum / all : here;
}
vec3 error(float e) { // from -1, too dark, to 1, too bright: the root, so that small ones are seen
    float a = sqrt(abs(e));
    vec3 white = vec3(0.96), middle = e < 0.0 ? vec3(0.45, 0.68, 0.9) : vec3(0.98, 0.62, 0.42);
    vec3 end = e < 0.0 ? vec3(0.05, 0.18, 0.55) : vec3(0.6, 0.02, 0.12);
    return a < 0.5 ? mix(white, middle, 2.0 * a) : mix(middle, end, 2.0 * a - 1.0);
}
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    o_colour = vec4(0.0, 0.0, 0.0, 1.0);
    vec3 way = u_world * vec3(gl_FragCoord.xy * u_ray.xy + u_ray.zw, -1.0);
    if (texelFetch(t_depth, p, 0).x >= 1.0) {
        o_colour.rgb = u_view == 0.0 ? shown(harmonics(normalize(way), vec3(1.0)) * 0.6) : vec3(0.105, 0.11, 0.118);
        return;
    }
    vec3 n = normalize(u_world * texelFetch(t_normal, p, 0).xyz);
    vec3 open = harmonics(n, vec3(1.0, 0.6666667, 0.25)), light = open;
    vec4 seen = u_traced > 0.0 ? traced(p) : vec4(-1.0);
    bool known = seen.a >= 0.0;
    vec3 truth = u_light > 0.0 ? seen.rgb : open * seen.a;
    float visible = 1.0;
    vec4 of = texelFetch(t_light, p, 0);
    if (u_kind == 1.0) light = open * (visible = of.r);
    if (u_kind == 2.0 || u_kind == 3.0) light = of.rgb;
    if (u_kind == 3.0) light += texelFetch(t_bounce, p, 0).rgb;
    if (u_kind == 4.0 && known) { light = truth; visible = seen.a; }
    if (u_view < 2.0) {
        vec3 share = max(light, 0.0) / max(open, 1e-4); // above 1 is what a lamp adds
        light = open * pow(min(share, 1.0), vec3(u_effect)) * max(share, 1.0);
        visible = pow(visible, u_effect);
    }
    if (u_view == 0.0) {
        vec3 sun = texelFetch(t_direct, p, 0).rgb * u_sun;
        o_colour.rgb = shown(texelFetch(t_albedo, p, 0).rgb * light + sun);
    } else if (u_view == 1.0 || u_kind == 4.0) {
        o_colour.rgb = u_light > 0.0 ? shown(light) : vec3(visible);
    } else {
        float off = u_light > 0.0 ? dot(light - truth, vec3(0.3333333)) : visible - seen.a;
        o_colour.rgb = known ? error(clamp(off / u_range, -1.0, 1.0)) : vec3(0.5);
        o_colour.rgb *= 0.8 + 0.2 * dot(texelFetch(t_normal, p, 0).xyz, -normalize(way * u_world)); // as a relief
    }
}`;

/* Blends pixels along edges of luminance [after Lottes 2009, FXAA]. */
const smooth = `
vec3 at(vec2 p) {
    p /= u_size;
    return gl_FragCoord.x > u_split ? linear(t_right, p).rgb : linear(t_left, p).rgb;
}
float luma(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }
void main() {
    vec2 p = vec2(gl_FragCoord.x, u_upright > 0.0 ? u_size.y - gl_FragCoord.y : gl_FragCoord.y);
    vec3 here = at(p);
    vec4 l = vec4(luma(at(p + vec2(-1.0, 1.0))), luma(at(p + 1.0)), luma(at(p - 1.0)),
                  luma(at(p + vec2(1.0, -1.0)))); // nw ne sw se
    float m = luma(here), least = min(m, min(min(l.x, l.y), min(l.z, l.w)));
    float most = max(m, max(max(l.x, l.y), max(l.z, l.w)));
    o_colour = vec4(here, 1.0);
    if (u_plain > 0.0 || most - least < max(0.04, 0.1 * most)) return;
    vec2 way = vec2(l.z + l.w - l.x - l.y, l.x + l.z - l.y - l.w);
    float weak = max((l.x + l.y + l.z + l.w) * 0.03, 0.008);
    way = clamp(way / (min(abs(way.x), abs(way.y)) + weak), -8.0, 8.0);
    vec3 near = 0.5 * (at(p - way / 6.0) + at(p + way / 6.0));
    vec3 far = 0.5 * near + 0.25 * (at(p - 0.5 * way) + at(p + 0.5 * way));
    float found = luma(far);
    o_colour.rgb = found < least || found > most ? near : far;
}`;

/* Writes view-space normal and depth, for a file. */
const held = `
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    float d = texelFetch(t_depth, p, 0).x;
    o_frame = d < 1.0 ? vec4(texelFetch(t_normal, p, 0).xyz, 1.0 / (u_decode.x + u_decode.y * d)) : vec4(0.0);
}`;

/* Writes how many pixels a point has moved since the last frame. */
const motion = `
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec3 at = vec3(gl_FragCoord.xy / u_size, texelFetch(t_depth, p, 0).x) * 2.0 - 1.0;
    vec4 world = u_back * vec4(at, 1.0);
    vec4 was = (texelFetch(t_albedo, p, 0).a < 0.5 ? u_moved : u_last) * vec4(world.xyz / world.w, 1.0);
    o_motion = gl_FragCoord.xy - (was.xy / was.w * 0.5 + 0.5) * u_size;
}`;

/* Writes the number of the object that a pixel shows; 0: the scene. */
const objects = `
void main() {
    float mark = texelFetch(t_albedo, ivec2(gl_FragCoord.xy), 0).a;
    o_object = mark < 0.25 ? 1u : mark < 0.9 ? 2u : 0u;
}`;

/* For each shader: the textures that it reads, in the order of their units, and its uniforms, in std140. */
export const texts = {
    __proto__: null,
    picture: {
        body: picture, out: 'vec4 o_colour',
        textures: ['t_depth', 't_normal', 't_albedo', 't_direct', 't_truth', 't_light', 't_bounce'],
        numbers: `
    vec4 u_sky[9];              // radiance as spherical harmonics
    mat3 u_world;               // view space to the world
    vec4 u_ray;                 // a pixel's way in view space: xy * [0,1] + [2,3], -1
    float u_view;               // 0 lit, 1 ambient light alone, 2 difference
    float u_light;              // 1: the truth of light, else of visibility
    float u_traced;             // 1: there is a truth
    float u_sun, u_range;
    float u_exposure;           // a factor
    float u_effect;             // exponent of what occlusion leaves: 1 as it is; for the eye alone
    float u_kind;
    vec2 u_decode;              // 1 / view depth = x + y * window depth
    float u_step;               // pixels between those of t_truth
    float u_rough;              // 1: neighbours of t_truth on the same surface are averaged`
    },
    smooth: {
        body: smooth, out: 'vec4 o_colour', textures: ['t_left', 't_right'],
        numbers: `
    vec2 u_size;
    float u_split;              // right of so many pixels is right
    float u_plain;              // 1: edges are smooth
    float u_upright;            // 1: row 0 is the top one`
    },
    held: { body: held, out: 'vec4 o_frame', textures: ['t_depth', 't_normal'], numbers: 'vec2 u_decode;' },
    motion: { body: motion, out: 'vec2 o_motion', textures: ['t_depth', 't_albedo'],
              numbers: 'mat4 u_back, u_last, u_moved; vec2 u_size;' },
    objects: { body: objects, out: 'highp uint o_object', textures: ['t_albedo'], numbers: 'float u_none;' }
};

const heads = {
    '300ES': ({ textures, numbers, out }) => `#version 300 es
precision highp float;
#define linear(t, p) textureLod(t, p, 0.0)
layout(std140) uniform block { ${numbers}
};
${textures.map(name => `uniform sampler2D ${name};\n`).join('')}out ${out};`,

    VULKAN: ({ textures, numbers, out }) => `#version 450
#extension GL_EXT_samplerless_texture_functions : require
#define linear(t, p) textureLod(sampler2D(t, s_all), p, 0.0)
layout(binding = 0, std140) uniform block { ${numbers}
};
${textures.map((name, i) => `layout(binding = ${i + 1}) uniform texture2D ${name};\n`).join('')}
layout(binding = ${textures.length + 1}) uniform sampler s_all;
layout(location = 0) out ${out};`
};
export const textOf = (name, dialect) => `${heads[dialect](texts[name])}\n${texts[name].body}`;

/* Returns shader picture's uniforms, in its block's order. sky: nine of three; world: a matrix of three by three. */
export const pictureNumbers = ({ sky, world, ray, view, light, range, exposure, effect, step, rough, decode },
                               { sun, kind }, traced) => [
    ...Array.from({ length: 9 }, (_, i) => [...sky.slice(3 * i, 3 * i + 3), 0]).flat(),
    ...[0, 3, 6].flatMap(i => [world[i], world[i + 1], world[i + 2], 0]), ...ray, view, light, +traced, sun, range,
    exposure, effect, kind, ...decode, step, rough];
