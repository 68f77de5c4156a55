/* code.mjs - writes a chain of the page as C for ssgi_gl.h, with its frame. Names of enumerators are made from the
   library's sentence about each field. */

/* Returns the members of a desc that are not 0, as [field, its value in C]. */
function fieldsOf(ssgi, desc) {
    return ssgi.choices.filter(({ name, values }) => name === 'pass' || (desc[name] && desc[name] !== values[0]))
        .map(({ name, field, sentence }) => {
            const [, prefix] = /must be (\w+_) and one of/.exec(sentence) ?? [], value = desc[name];
            return [field, typeof value === 'string' ? prefix + value : String(Number(value))];
        });
}

function float(value) {
    const text = String(+value.toPrecision(7));
    return `${/[.e]/.test(text) ? text : `${text}.0`}f`;
}

/* Returns the C that gets a chain's steps; a program calls it once, and again if the size changes. */
function stepsLines(ssgi, { desc, width, height, ...members }) {
    const { lights, ...plain } = members, rest = Object.entries(plain).filter(([, value]) => value);
    return [
        '/* Once, and whenever the size changes: what is drawn, in its order. 0: why says what is wrong. */',
        'static int make_steps(ssgi_gl_step steps[STEPS], int width, int height, const char **why)',
        '{',
        '    ssgi_gl_chain chain = { 0 };',
        ...fieldsOf(ssgi, desc).map(([field, value]) => `    chain.desc.${field} = ${value};`),
        '    chain.width = width;',
        '    chain.height = height;',
        ...(lights ? fieldsOf(ssgi, lights).map(([field, value]) => `    chain.lights.${field} = ${value};`) : []),
        ...rest.map(([name, value]) => `    chain.${name} = ${Number(value)};`),
        '    const int count = ssgi_gl_steps(steps, STEPS, &chain, why);',
        '    if (count <= STEPS) return count;',
        '    if (why) *why = "STEPS: must be as many as the chain has";',
        '    return 0;',
        '}'
    ];
}

function frameLines({ history, desc, lights }, { radius, thickness_limit, bands, surfels }) {
    const parameters = [
        'ssgi_gl_frame *frame, const ssgi_view *view, const float world_to_view[16],',
        ...(history ? ['const ssgi_view *last_view, const float last_world_to_view[16], uint32_t number,'] : []),
        ...(bands ? [`const float coefficients[${3 * bands * bands}],`] : []),
        'const char **why)'
    ];
    return [
        '/* Each frame: upload it whole as the uniform block ssgi_frame. view is of ssgi_view_from_projection,',
        `   matrices are column-major.${history ? ' last_view: NULL in the first frame, and after a cut.' : ''} */`,
        `static ssgi_result make_frame(${parameters.join(`\n${' '.repeat(30)}`)}`,
        '{',
        `    if (ssgi_gl_frame_init(frame, view, ${float(radius)}, why) != SSGI_OK) return SSGI_BAD_ARGUMENT;`,
        `    frame->thickness_limit = ${float(thickness_limit)};`,
        '    for (int i = 0; i < 12; ++i)',
        '        if (i % 4 < 3) frame->rotation[i] = world_to_view[i];',
        ...(lights ? ['    frame->lights = 1;'] : []),
        ...(surfels ? [`    frame->epsilon = ${float(surfels.epsilon)};`,
                       `    if (ssgi_gl_surfels_set(frame, view, &surfels_made, NULL, why) != SSGI_OK)`,
                       '        return SSGI_BAD_ARGUMENT;'] : []),
        ...(bands ? [`    if (ssgi_gl_harmonics_set(frame, coefficients, ${bands}, world_to_view, why) != SSGI_OK)`,
                     '        return SSGI_BAD_ARGUMENT;'] : []),
        ...(history ? ['    frame->phase = ssgi_gl_phase(number);', '    if (!last_view) return SSGI_OK;',
                       '    return ssgi_gl_frame_history(frame, last_view, world_to_view, last_world_to_view, why);']
            : ['    return SSGI_OK;']),
        '}'
    ];
}

function surfelLines({ size }, radius) {
    return [
        `static const ssgi_surfel_desc surfels_made = { .size = ${float(size)}, .max_distance = ${float(radius)} };`,
        '',
        '/* Whenever the camera moves: surfels of your triangles, three vec4 attributes of as many instances.',
        '   free() it. NULL: why says what is wrong. */',
        'static ssgi_surfel *make_surfels(size_t *count, const ssgi_view *view, const ssgi_surfel_source *source,',
        '                                 const char **why)',
        '{',
        '    ssgi_surfel_source divided = *source;',
        '    ssgi_surfel *out = NULL;',
        '    float *triangles;',
        '    *why = "out of memory";',
        '    if (ssgi_surfels_divide(NULL, 0, &divided.triangles, &surfels_made, view, source, why) != SSGI_OK)',
        '        return NULL;',
        '    triangles = (float *)malloc((27 * divided.triangles + 1) * sizeof *triangles);',
        '    if (!triangles) return NULL;',
        '    ssgi_surfels_divide(triangles, divided.triangles, count, &surfels_made, view, source, why);',
        '    divided.position = triangles, divided.normal = triangles + 3, divided.colour = triangles + 6;',
        '    divided.position_stride = divided.normal_stride = divided.colour_stride = 9 * sizeof *triangles;',
        '    divided.index = NULL;',
        '    if (ssgi_surfels(NULL, 0, count, &surfels_made, view, &divided, why) == SSGI_OK)',
        '        out = (ssgi_surfel *)malloc((*count + 1) * sizeof *out);',
        '    if (out) ssgi_surfels(out, *count, count, &surfels_made, view, &divided, why);',
        '    free(triangles);',
        '    return out;',
        '}',
        ''
    ];
}

function fieldLines({ resolution, rays, reach }) {
    return [
        '/* Once an object, positions of three corners a triangle in its own space; texels:',
        `   ssgi_field_size(${resolution}) bytes, to be uploaded as a slice of t_ssgi_fields. */`,
        'static ssgi_result make_field(ssgi_field *field, uint32_t *texels, const float *position, size_t triangles,',
        '                              const char **why)',
        '{',
        `    const ssgi_field_desc desc = { .resolution = ${resolution}, .rays = ${rays} };`,
        '    const size_t size = ssgi_field_bake_size(&desc, triangles);',
        '    void *work = malloc(size + 1);',
        '    ssgi_result result = SSGI_TOO_SMALL;',
        '    *why = "out of memory";',
        '    if (work) result = ssgi_field_bake(field, texels, work, size, &desc, position, 12, NULL, triangles, why);',
        '    free(work);',
        '    return result;',
        '}',
        '',
        '/* Each frame, of each object: its row of t_ssgi_occluders. slice: of t_ssgi_fields; object: its number in',
        '   t_ssgi_objects. */',
        'static ssgi_result make_row(ssgi_gl_occluder *row, const ssgi_field *field, const float mesh_to_view[16],',
        '                            int slice, int object, const char **why)',
        '{',
        '    ssgi_field_limits limits = ssgi_field_limits_of(field);',
        `    limits.reach = ${float(reach)} * field->reach;`,
        '    limits.ramp = 0.75f * limits.reach;',
        '    return ssgi_gl_occluder_set(row, field, &limits, mesh_to_view, slice, object, why);',
        '}',
        ''
    ];
}

const sunLines = () => [
    '/* Each frame: the sun, a row of t_ssgi_lights, RGBA32F, 8 wide. to_sun: unit, in the world. map: of the',
    '   projection that t_ssgi_shadow was drawn with, depth as seen from the sun. */',
    'static ssgi_result make_sun(ssgi_gl_light *row, const float to_sun[3], const float irradiance[3],',
    '                            const ssgi_view *map, const float world_to_view[16], const float world_to_sun[16],',
    '                            const char **why)',
    '{',
    '    static const ssgi_gl_light none; /* SSGI_GL_LIGHT_SUN is 0 */',
    '    *row = none;',
    '    for (int i = 0; i < 3; ++i) {',
    '        for (int k = 0; k < 3; ++k) row->at[i] += world_to_view[4 * k + i] * to_sun[k];',
    '        row->colour[i] = irradiance[i];',
    '    }',
    '    return ssgi_gl_light_map(row, map, 0, 0, world_to_view, world_to_sun, why);',
    '}',
    ''
];

/* Returns C functions that compile as they stand. chain: as Ssgi.steps takes it. given: { radius, thickness_limit: in
   units of the view, bands: of the frame's harmonics, or 0, title, surfels, fields: their settings }. */
export function cLines(ssgi, chain, given) {
    const { surfels, fields, radius } = given;
    return [`/* ${given.title} */`, '#include "ssgi_gl.h"', ...(surfels || fields ? ['#include <stdlib.h>'] : []), '',
            `enum { STEPS = ${ssgi.steps(chain).length} };`, '', ...(surfels ? surfelLines(surfels, radius) : []),
            ...(fields ? fieldLines(fields) : []), ...(chain.lights ? sunLines() : []), ...stepsLines(ssgi, chain), '',
            ...frameLines(chain, given),
            ''].join('\n');
}
