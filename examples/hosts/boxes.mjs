/* boxes.mjs - the scene of the pages for browsers, as in boxes.h: a floor and 24 boxes, their centres and half
   sizes. */
export const boxes = Array.from({ length: 25 }, (_, i) => {
    const high = 0.2 + 0.2 * (i * 7 % 5);
    return i ? { at: [1.5 * (i % 5 - 2), high, 1.5 * (Math.floor(i / 5) - 2)],
                 half: [0.35 + 0.05 * (i * 3 % 8), high, 0.35 + 0.05 * (i * 5 % 7)] }
        : { at: [0, -0.1, 0], half: [4.5, 0.1, 4.5] };
});

/* Returns a scene of three.js and its camera. plain: with a white background; white: with white boxes, too. */
export function sceneOf(THREE, { plain, white }) {
    const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100);
    const material = new THREE.MeshLambertMaterial({ color: white ? 0xffffff : 0xe5cca6 });
    camera.position.set(0, 6, 8);
    camera.lookAt(0, 0, 0);
    scene.background = new THREE.Color(plain ? 0xffffff : 0xb2cce5);
    for (const { at, half } of boxes) {
        const box = new THREE.Mesh(new THREE.BoxGeometry(2, 2, 2), material);
        box.scale.set(...half);
        box.position.set(...at);
        scene.add(box);
    }
    return { scene, camera };
}
