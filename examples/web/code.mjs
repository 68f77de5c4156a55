/* code.mjs - a chain of the page as C: what makes it with ssgi_gl.h, and its frame. Each enumerator's name is made of
   the sentence that the library has of its field. */

/* [field, C] of what is not 0 in a desc. */
function fieldsOf(ssgi, desc) {
    return ssgi.choices.filter(({ name, values }) => name === 'pass' || (desc[name] && desc[name] !== values[0]))
        .map(({ name, sentence }) => {
            const [, prefix] = /must be (\w+_) and one of/.exec(sentence) ?? [], value = desc[name];
            return [name, typeof value === 'string' ? prefix + value : String(Number(value))];
        });
}

function float(value) {
    const text = String(+value.toPrecision(7));
    return `${/[.e]/.test(text) ? text : `${text}.0`}f`;
}

/* Once, and whenever the size changes. */
function stepsLines(ssgi, { desc, width, height, ...members }) {
    const rest = Object.entries(members).filter(([, value]) => value);
    return [
        '/* Once, and whenever the size changes: what is drawn, in its order. 0: why says what is wrong. */',
        'static int make_steps(ssgi_gl_step steps[STEPS], int width, int height, const char **why)',
        '{',
        '    ssgi_gl_chain chain = { 0 };',
        ...fieldsOf(ssgi, desc).map(([name, value]) => `    chain.desc.${name} = ${value};`),
        '    chain.width = width;',
        '    chain.height = height;',
        ...rest.map(([name, value]) => `    chain.${name} = ${Number(value)};`),
        '    return ssgi_gl_steps(steps, STEPS, &chain, why);',
        '}'
    ];
}

function frameLines({ history }, { radius, thickness, bands }) {
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
        `    frame->thickness = ${float(thickness)};`,
        '    for (int i = 0; i < 12; ++i)',
        '        if (i % 4 < 3) frame->rotation[i] = world_to_view[i];',
        ...(bands ? [`    if (ssgi_gl_harmonics_set(frame, coefficients, ${bands}, world_to_view, why) != SSGI_OK)`,
                     '        return SSGI_BAD_ARGUMENT;'] : []),
        ...(history ? ['    frame->phase = ssgi_gl_phase(number);', '    if (!last_view) return SSGI_OK;',
                       '    return ssgi_gl_frame_history(frame, last_view, world_to_view, last_world_to_view, why);']
            : ['    return SSGI_OK;']),
        '}'
    ];
}

/* Functions that compile as they stand. chain: as Ssgi.steps takes it. given: { radius, thickness: in units of the
   view, bands: of the harmonics that the frame has, or 0, title: what it is }. */
export function cLines(ssgi, chain, given) {
    return [`/* ${given.title} */`, '#include "ssgi_gl.h"', '', `enum { STEPS = ${ssgi.steps(chain).length} };`, '',
            ...stepsLines(ssgi, chain), '', ...frameLines(chain, given), ''].join('\n');
}
