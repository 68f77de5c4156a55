/* boxes.mjs - the scene of the pages for browsers, as in boxes.h: a floor and 24 boxes, their centres and half
   sizes. */
export const boxes = Array.from({ length: 25 }, (_, i) => {
    const high = 0.2 + 0.2 * (i * 7 % 5);
    return i ? { at: [1.5 * (i % 5 - 2), high, 1.5 * (Math.floor(i / 5) - 2)],
                 half: [0.35 + 0.05 * (i * 3 % 8), high, 0.35 + 0.05 * (i * 5 % 7)] }
        : { at: [0, -0.1, 0], half: [4.5, 0.1, 4.5] };
});

/* Returns a scene of three.js, its camera and its sun. is: the words of the page's address, of which white makes white
   boxes without a sun, white and sun a white background, glass a pane in front. */
export function sceneOf(THREE, is = new Set()) {
    const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(45, 1, 0.1, 100), white = is.has('white');
    const sun = new THREE.DirectionalLight(0xffd9a6, white ? 0 : 3);
    const material = new THREE.MeshLambertMaterial({ color: white ? 0xffffff : 0xe5cca6 });
    camera.position.set(0, 6, 8);
    camera.lookAt(0, 0, 0);
    scene.background = new THREE.Color(white || is.has('sun') ? 0xffffff : 0xb2cce5);
    for (const { at, half } of boxes) {
        const box = new THREE.Mesh(new THREE.BoxGeometry(2, 2, 2), material);
        box.scale.set(...half);
        box.position.set(...at);
        scene.add(box);
    }
    if (is.has('glass')) {
        const glass = new THREE.MeshBasicMaterial({ color: 0x00ff00, transparent: true, opacity: 0.5 });
        const pane = new THREE.Mesh(new THREE.PlaneGeometry(3, 3), glass);
        pane.position.set(0, 2, 3);
        scene.add(pane);
    }
    sun.position.set(-0.6, 0.8, 0);
    scene.add(sun);
    return { scene, camera, sun };
}

/* Calls fit(width, height) now, and when the window's size has changed. */
export function fitted(camera, fit) {
    const resize = () => {
        camera.aspect = innerWidth / innerHeight;
        camera.updateProjectionMatrix();
        fit(innerWidth, innerHeight);
    };
    addEventListener('resize', resize);
    resize();
}
