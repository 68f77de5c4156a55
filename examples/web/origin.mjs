/* origin.mjs - where a model that lies far from 0 is shown about, by build/render's rule: floats are coarse so far
   away, and all that is drawn is floats. */

const away = 100;                                       /* of its diagonals; below that nothing is moved */
const coarse = 2e-5;                                    /* the share of its diagonal that numbers may lie apart */

/* The middle of bounds, as a number of few digits, or 0, 0, 0. */
export function originOf(lower, upper) {
    const middle = lower.map((least, i) => 0.5 * (least + upper[i]));
    const diagonal = Math.hypot(...lower.map((least, i) => upper[i] - least));
    if (!(Math.max(...middle.map(Math.abs)) > away * diagonal)) return [0, 0, 0];
    const step = 2 ** Math.floor(Math.log2(diagonal));
    return middle.map(v => (diagonal > 0 ? step * Math.round(v / step) : v));
}

/* How far apart floats lie at a number. */
export const floatsAt = v => 2 ** (Math.floor(Math.log2(Math.max(Math.abs(v), 2 ** -126))) - 23);

/* What is said where they are so far apart in a model of such a diagonal; or null. */
export const gapSaid = (gap, diagonal) => (gap > coarse * diagonal
    ? `its coordinates are floats, which so far from 0 are ${+gap.toPrecision(2)} apart, `
        + `${+(gap / diagonal).toPrecision(2)} of its size`
    : null);
