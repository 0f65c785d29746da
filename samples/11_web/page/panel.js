// The card of the chosen part, and the list of parts.
import { Degraded, JointBasis, JointType } from './dragmesh/dragmesh.js';

const SHOWN = 4; // hypotheses that the card offers
const ALIKE = 0.03; // rad, and share of the size, within which two hypotheses look the same
const SHORTEST = 0.0005; // m: a length below it is shown as 0
const UPRIGHT = 0.8; // how much less the height counts where an edge is named: a lid's is at the back, not at the bottom
const nouns = { [JointType.REVOLUTE]: 'Hinge', [JointType.PRISMATIC]: 'Slide', [JointType.SCREW]: 'Screw', [JointType.CONTINUOUS]: 'Turns freely', [JointType.FIXED]: 'Fixed', [JointType.UNKNOWN]: 'Unknown' };
const origins = { [JointBasis.PREPARED]: 'as prepared', [JointBasis.PULL]: 'by your pull', [JointBasis.HOST]: 'as you say', [JointBasis.CHOSEN]: 'your choice' };
const icons = {
    [JointType.REVOLUTE]: 'M7 4v16M7 6l9-2v16l-9-2M19 8c1.5 2 1.5 6 0 8',
    [JointType.PRISMATIC]: 'M4 12h15M15 8l4 4-4 4M4 7v10',
    [JointType.SCREW]: 'M8 5h8M8 9l8 2M8 13l8 2M8 17l8 2M12 3v18',
    [JointType.CONTINUOUS]: 'M19 12a7 7 0 1 1-2.2-5.1M19 4v4h-4',
    [JointType.FIXED]: 'M6 6h12v12H6z', [JointType.UNKNOWN]: 'M6 6h12v12H6z',
};

const byName = ([x, y, z]) => [['left–right', x], ['up–down', y], ['front–back', z]].reduce((best, each) => (Math.abs(each[1]) > Math.abs(best[1]) ? each : best))[0];

// Whether the joints were found without a network or the ranker, whose confidence says little then.
const isGuess = part => (part.degraded & (Degraded.NO_KINEMATICS | Degraded.NO_RANKER)) !== 0;

/** What a joint is in words: 'Hinge, left side'. */
function describe(joint, info) {
    const noun = nouns[joint.type];
    if (joint.type === JointType.PRISMATIC) return `${noun}, ${byName(joint.axis)}`;
    if (joint.type !== JointType.REVOLUTE) return noun;
    const place = joint.origin.map((value, k) => (value - info.centre[k]) / Math.max(info.boxMax[k] - info.boxMin[k], 1e-9));
    const along = joint.axis.map(Math.abs), axis = along.indexOf(Math.max(...along));
    place[1] *= UPRIGHT;
    const [side] = [[0, place[0] < 0 ? 'left' : 'right'], [1, place[1] < 0 ? 'bottom' : 'top'], [2, place[2] < 0 ? 'back' : 'front']]
        .filter(([k]) => k !== axis && Math.abs(place[k]) > 0.25).sort((a, b) => Math.abs(place[b[0]]) - Math.abs(place[a[0]]));
    return side ? `${noun}, ${side[1]}` : `${noun}, ${byName(joint.axis)}`;
}

const alike = (a, b, size) => a.type === b.type && a.axis.every((v, k) => Math.abs(v - b.axis[k]) < ALIKE) && a.origin.every((v, k) => Math.abs(v - b.origin[k]) < ALIKE * size);

function number(joint, value) {
    if (joint.type !== JointType.PRISMATIC) return `${Math.round(value * 180 / Math.PI)}°`.replace('-', '−');
    const length = Math.abs(value), sign = value < 0 && joint.upper > SHORTEST ? '−' : ''; // where a slide goes both ways
    if (length < SHORTEST) return '0';
    return sign + (length >= 1 ? `${length.toFixed(2)} m` : length >= 0.02 ? `${(length * 100).toFixed(1)} cm` : `${(length * 1000).toFixed(1)} mm`);
}

// How sure the joint in force is, and where it comes from. What the user says needs no number.
function trust(part) {
    const { confidence, basis } = part, told = basis === JointBasis.HOST || basis === JointBasis.CHOSEN;
    if (part.isStated && basis !== JointBasis.CHOSEN) return 'as the file says';
    if (!told && isGuess(part)) return 'a guess: weights are missing';
    return told ? origins[basis] : `${Math.round(confidence * 100)} % sure, ${origins[basis]}`;
}

function icon(type) {
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg'), path = document.createElementNS(svg.namespaceURI, 'path');
    svg.setAttribute('viewBox', '0 0 24 24');
    svg.setAttribute('aria-hidden', 'true');
    path.setAttribute('d', icons[type]);
    svg.append(path);
    return svg;
}

export class Panel {
    #root = document.querySelector('#panel');
    #list = document.querySelector('#parts');
    #part = null;

    // actions: { select(part), toggle(part), value(part, value, done), choose(part, joint), takeBack(part), forget(part) }
    constructor(actions) {
        this.actions = actions;
        this.$ = name => this.#root.querySelector(name);
        this.$('.toggle').onclick = () => actions.toggle(this.#part);
        this.$('.before').onclick = () => actions.takeBack(this.#part);
        this.$('.fixed').onclick = () => actions.forget(this.#part);
        this.$('.slider').oninput = event => actions.value(this.#part, this.#fromSlider(event.target.value));
        this.$('.slider').onchange = () => actions.value(this.#part, null);
    }

    #range() {
        const { lower, upper } = this.#part.joint, open = this.#part.openValue;
        return lower === upper ? [0, open] : open < 0 ? [upper, lower] : [lower, upper];
    }

    #fromSlider(place) {
        const [from, to] = this.#range();
        return from + (to - from) * place / 1000;
    }

    show(part) {
        this.#part = part;
        this.#root.hidden = !part;
        for (const button of this.#list.children) button.setAttribute('aria-pressed', String(Number(button.dataset.id) === part?.id));
        if (!part) return;
        this.$('h2').textContent = part.name;
        this.#choices();
        this.#facts();
        this.update();
    }

    /** Shows the part's value; called every frame that it moves. */
    update() {
        const part = this.#part;
        if (!part) return;
        const { joint, value } = part, [from, to] = this.#range();
        const noun = part.isFree && joint.type === JointType.PRISMATIC ? 'Loose, lifts off' : nouns[joint.type];
        this.$('.kind').textContent = `${noun} · ${trust(part)}`;
        this.$('.before').hidden = !part.before;
        this.$('.value').textContent = number(joint, value);
        const share = Math.min(1, Math.max(0, (value - from) / (to - from || 1)));
        const slider = this.$('.slider');
        if (document.activeElement !== slider || !slider.matches(':active')) slider.value = share * 1000;
        slider.style.setProperty('--fill', `${share * 100}%`);
        slider.setAttribute('aria-valuetext', number(joint, value));
        slider.disabled = joint.type === JointType.FIXED;
        this.$('.toggle').textContent = Math.abs(value) > Math.abs(part.openValue) / 2 ? 'Close' : 'Open';
    }

    #choices() {
        const { hypotheses, info, parts } = this.#part, shown = [];
        for (const joint of hypotheses) if (shown.length < SHOWN && !shown.some(each => alike(each, joint, parts.asset.size))) shown.push(joint);
        this.$('.choices').replaceChildren(...shown.map(joint => {
            const button = document.createElement('button'), text = document.createElement('span'), share = document.createElement('small');
            text.textContent = describe(joint, info);
            share.textContent = isGuess(this.#part) ? '' : `${Math.max(1, Math.round(joint.jointConfidence * 100))} %`;
            button.setAttribute('role', 'radio');
            button.setAttribute('aria-checked', String(alike(joint, this.#part.joint, parts.asset.size)));
            button.append(icon(joint.type), text, share);
            button.onclick = () => this.actions.choose(this.#part, joint);
            return button;
        }));
    }

    #facts() {
        const { joint, times } = this.#part;
        const limits = joint.lower === joint.upper ? 'without limits' : `from ${number(joint, joint.lower)} to ${number(joint, joint.upper)}`;
        this.$('.facts').textContent = `Moves ${limits}. Found in ${Math.round(times.find + times.prepare)} ms, on your machine.`;
    }

    /** Lists the parts found. */
    list(parts) {
        this.#list.replaceChildren(...parts.map(part => {
            const button = document.createElement('button');
            button.textContent = part.name;
            button.dataset.id = part.id;
            button.setAttribute('aria-pressed', String(part === this.#part));
            button.onclick = () => this.actions.select(part);
            return button;
        }));
    }
}
