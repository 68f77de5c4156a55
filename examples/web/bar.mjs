/* bar.mjs - the buttons over the picture, keys, help. */
import { methods, sentenceOf } from './settings.mjs';

const $ = id => document.getElementById(id);

/* Connects buttons, keys and help. set: the page's settings. choose(name, value), home(), save(), fit(): actions. */
export function bar(ssgi, set, { choose, home, save, fit }) {
    const turn = name => () => choose(name, !set[name]);
    const view = word => () => choose('view', word);
    const whole = () => (document.fullscreenElement ? document.exitFullscreen()
        : $('picture').requestFullscreen()).catch(() => {});
    const hide = () => { document.body.classList.toggle('alone'); show(); fit(); };
    const list = () => $('keys').showModal();
    const actions = {
        __proto__: null,
        1: ['lit', view('lit')],
        2: ['what the method finds, alone', view('ambient')],
        3: ['difference from the truth', view('difference')],
        c: ['circle about the scene', turn('circle')],
        m: ['an object that moves', turn('moves')],
        t: ['trace the truth', turn('truth')],
        r: ['reset the view', home],
        s: ['save the picture as PNG', save],
        f: ['full screen', whole],
        p: ['hide or show the panel', hide],
        '?': ['this list', list]
    };
    const buttons = { circle: 'c', png: 's', whole: 'f', hide: 'p', help: '?' };

    function show() {
        $('circle').setAttribute('aria-pressed', set.circle);
        $('hide').setAttribute('aria-pressed', document.body.classList.contains('alone'));
    }

    for (const [id, key] of Object.entries(buttons)) $(id).onclick = () => actions[key][1]();
    $('whole').hidden = !$('picture').requestFullscreen;
    $('keys').querySelector('dl').replaceChildren(...Object.entries(actions).flatMap(([key, [what]]) => {
        const term = document.createElement('dt'), sentence = document.createElement('dd');
        term.append(Object.assign(document.createElement('kbd'), { textContent: key }));
        sentence.textContent = what;
        return [term, sentence];
    }));
    $('methods').replaceChildren(...Object.entries(methods).map(([name, { title }]) => {
        const item = document.createElement('li');
        item.append(Object.assign(document.createElement('b'), { textContent: title }), `: ${sentenceOf(ssgi, name)}`);
        return item;
    }));
    $('keys').onclick = e => { if (e.target === $('keys') || e.target.tagName === 'BUTTON') $('keys').close(); };
    addEventListener('keydown', e => {
        const typing = e.target.closest?.('select, dialog[open]');
        if (typing || e.ctrlKey || e.metaKey || e.altKey || !actions[e.key]) return;
        e.preventDefault();
        actions[e.key][1]();
    });
    show();
    return { show };
}
