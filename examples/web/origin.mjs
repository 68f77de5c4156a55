/* origin.mjs - chooses the origin for a model that is far from 0, by build/render's rule: floats there are coarse, and
   all drawing is done in floats. */

const away = 100;                                       /* in diagonals of the model; nearer models are not moved */
const coarse = 2e-5;                      /* largest spacing of floats in diagonals of the model that is not reported */

/* Returns the middle of bounds, rounded to few digits, if they are far from 0; else 0, 0, 0. */
export function originOf(lower, upper) {
    const middle = lower.map((least, i) => 0.5 * (least + upper[i]));
    const diagonal = Math.hypot(...lower.map((least, i) => upper[i] - least));
    if (!(Math.max(...middle.map(Math.abs)) > away * diagonal)) return [0, 0, 0];
    const step = 2 ** Math.floor(Math.log2(diagonal));
    return middle.map(v => (diagonal > 0 ? step * Math.round(v / step) : v));
}

/* Returns the spacing of floats at a number. */
export const floatsAt = v => 2 ** (Math.floor(Math.log2(Math.max(Math.abs(v), 2 ** -126))) - 23);

/* Returns a sentence if the spacing gap is too coarse for a model of that diagonal; else null. */
export const gapSaid = (gap, diagonal) => (gap > coarse * diagonal
    ? `its coordinates are floats, which so far from 0 are ${+gap.toPrecision(2)} apart, `
        + `${+(gap / diagonal).toPrecision(2)} of its size`
    : null);
