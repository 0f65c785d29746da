// The page: opens objects, turns what fingers, mice and keys do into drags, and shows what was found.
import { Color } from './three/three.module.min.js';
import { GLTFLoader } from './three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from './three/addons/libs/meshopt_decoder.module.js';
import { load, Go, Picking } from './dragmesh/dragmesh.js';
import { Figure, readAsset } from './asset.js';
import { JointView } from './joint_view.js';
import { Panel } from './panel.js';
import { Parts } from './parts.js';
import { props } from './props.js';
import { saveAnimated } from './save.js';
import { Solver } from './solver.js';
import { Stage } from './stage.js';

const LONGEST_FRAME = 1 / 20; // s: a page that was hidden does not leap
const FIRST_FRAME = 1 / 60;
const GLOW = 8; // 1/s, of a part under the pointer
const TAP = 6; // px that a press may move and still be a tap
const MESSAGE_TIME = 4200; // ms
const CHOOSER = 96; // px at the bottom, for the objects to try
const BESIDE = 120; // px at the right, for the card that a pull brings

const $ = selector => document.querySelector(selector);
const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
const stage = new Stage($('#stage')), view = new JointView(), solver = new Solver();
const dragmesh = await load();
const context = dragmesh.createContext({ picking: Picking.NONE });
const panel = new Panel({ select, toggle, value: slide, choose, takeBack, forget });
let parts = null, selected = null, over = null, opened = 0;
stage.scene.add(view.group);

// ---- objects -----------------------------------------------------------------------------------------------------------------

function show(asset, camera) {
    parts?.destroy();
    if (parts) stage.scene.remove(parts.figure.root);
    view.clear();
    const figure = new Figure(asset);
    parts = new Parts(dragmesh, context, solver, asset, figure, changed);
    stage.scene.add(figure.root);
    select(null);
    panel.list([]);
    over = null;
    pressed.clear();
    opened++;
    stage.frame(asset.box, camera);
    $('#save').disabled = false;
    askParts(parts);
    wake();
}

// Asks the asset for its parts while nobody has touched it yet. A touch before waits for the answer.
async function askParts(mine) {
    const several = mine.asset.pieceCount > 1;
    showHint(several ? 'Looking for what moves' : 'Pull on the lid: it is found from the shape');
    busy(true);
    try {
        await solver.ready;
        if (mine !== parts) return;
        await mine.rig(share => { if (mine === parts) showHint(`Looking for what moves: ${Math.round(100 * share)} %`); });
    } catch (error) {
        if (mine === parts) report(error);
    } finally {
        busy(false);
    }
    if (mine !== parts) return;
    if (several) showHint(mine.list.length ? 'Pull on something that opens' : 'Nothing here seems to move. Tap a piece to say that it does.');
    wake();
    document.body.dataset.ready = String(opened);
}

function changed(part) {
    if (!parts?.list.includes(part)) return;
    panel.list(parts.list);
    if (part === selected) panel.show(part);
    if (part === selected) view.show(part, accent());
    wake();
}

async function openProp(prop) {
    setPressed(prop.id);
    show(readAsset(prop.make(), prop.title), prop.view);
}

async function openFile(file) {
    busy(true);
    try {
        const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
        const gltf = await loader.parseAsync(await file.arrayBuffer(), '');
        show(readAsset(gltf.scene, file.name.replace(/\.[^.]+$/, ''), gltf));
        setPressed(null);
    } catch (error) {
        const draco = /DRACOLoader/.test(error.message);
        say(draco ? 'This file is compressed with Draco, which this page does not read.' : `This file could not be opened. ${error.message}`);
    } finally {
        busy(false);
    }
}

async function save() {
    busy(true);
    try {
        const data = await saveAnimated(parts), link = document.createElement('a');
        link.href = URL.createObjectURL(new Blob([data], { type: 'model/gltf-binary' }));
        link.download = `${parts.asset.name.toLowerCase().replace(/[^a-z0-9]+/g, '_')}_animated.glb`;
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 1e4);
        say(parts.list.length ? `Saved, with the animation of ${parts.list.length === 1 ? 'one part' : `${parts.list.length} parts`}.` : 'Saved. Nothing has been pulled on yet, so nothing is animated.');
    } catch (error) {
        report(error);
    } finally {
        busy(false);
    }
}

// ---- the chosen part -----------------------------------------------------------------------------------------------------------

function select(part) {
    if (part === selected) return;
    selected = part;
    panel.show(part);
    if (part) view.show(part, accent());
    else view.hide();
    layout();
    wake();
}

function toggle(part) {
    part.release(Go.TOGGLE);
    endHint();
    wake();
}

// value null: the slider was let go.
let sliding = null;
function slide(part, value) {
    if (value === null && part.drag) part.release(Go.STAY);
    sliding = value === null ? null : { part, value };
    wake();
}

function choose(part, joint) {
    part.choose(joint);
    part.release(Go.OPEN); // shows what was chosen
    wake();
}

function takeBack(part) {
    part.takeBack();
    wake();
}

function forget(part) {
    parts.forget(part);
    select(null);
    panel.list(parts.list);
    say(`${part.name} stays where it is now.`);
    wake();
}

// Says that what was tapped stays, and lets the user say that it does not.
function sayFixed({ face }) {
    const mine = parts, name = mine.pieceName(face);
    say(`${name} stays.`, 'It moves', async () => {
        busy(true);
        const part = await mine.tell(face).catch(report);
        busy(false);
        if (mine !== parts) return;
        if (part) select(part);
        else say(`Nothing tells how ${name} would move.`);
        wake();
    });
}

// ---- pointers ------------------------------------------------------------------------------------------------------------------

const pressed = new Map(); // pointer id -> { x, y, startX, startY, mode: 'asking' | 'pulling' | 'turning', part, moved }
const canvas = $('#stage');

function press(event) {
    if (event.button > 0 && event.pointerType === 'mouse') return;
    canvas.setPointerCapture(event.pointerId);
    const pointer = { x: event.clientX, y: event.clientY, startX: event.clientX, startY: event.clientY, mode: 'turning', moved: false };
    const hit = pressed.size === 0 ? stage.hit(pointer.x, pointer.y, parts.figure.root) : null;
    pressed.set(event.pointerId, pointer);
    if (pressed.size > 1) for (const each of pressed.values()) letGo(each); // two fingers turn and zoom
    if (hit && parts.isFixed(hit.face)) pointer.fixed = hit;
    else if (hit) take(pointer, hit);
    cursor();
    wake();
}

async function take(pointer, hit) {
    pointer.mode = 'asking';
    stage.stop();
    const mine = parts, ray = stage.rayAt(pointer.x, pointer.y).clone();
    let part = null;
    try {
        busy(true);
        part = await mine.find(hit.face, hit.point);
    } catch (error) {
        report(error);
    } finally {
        busy(false);
    }
    if (mine !== parts || pointer.mode !== 'asking') return;
    if (!part) {
        pointer.mode = 'turning';
        if (mine.isFixed(hit.face)) pointer.fixed = hit;
        if (pointer.fixed && pointer.lifted && !pointer.moved) sayFixed(hit);
        cursor();
        return;
    }
    select(part);
    if (pointer.lifted) return; // a tap on a part that was not known yet chooses it
    pointer.mode = 'pulling';
    pointer.part = part;
    part.grab(hit.point, ray);
    endHint();
    cursor();
    wake();
}

function move(event) {
    const pointer = pressed.get(event.pointerId);
    if (!pointer) {
        hover(event);
        return;
    }
    const dx = event.clientX - pointer.x, dy = event.clientY - pointer.y;
    if (pressed.size === 2) pinch(event, pointer);
    else if (pointer.mode === 'turning') stage.orbit(dx, dy);
    pointer.x = event.clientX;
    pointer.y = event.clientY;
    pointer.moved ||= Math.hypot(pointer.x - pointer.startX, pointer.y - pointer.startY) > TAP;
    wake();
}

function pinch(event, pointer) {
    const [other] = [...pressed.values()].filter(each => each !== pointer);
    const before = Math.hypot(pointer.x - other.x, pointer.y - other.y), after = Math.hypot(event.clientX - other.x, event.clientY - other.y);
    if (after > 0) stage.zoom(before / after);
    stage.orbit((event.clientX - pointer.x) / 2, (event.clientY - pointer.y) / 2);
}

function lift(event) {
    const pointer = pressed.get(event.pointerId);
    if (!pointer) return;
    pressed.delete(event.pointerId);
    pointer.lifted = true;
    if (pointer.mode === 'pulling' && !pointer.moved) pointer.part.release(Go.STAY);
    else letGo(pointer);
    if (pointer.mode === 'turning' && !pointer.moved) {
        select(null);
        if (pointer.fixed) sayFixed(pointer.fixed);
    }
    cursor();
    wake();
}

function letGo(pointer) {
    if (pointer.mode === 'pulling') pointer.part.release();
    if (pointer.mode === 'pulling' || !pointer.lifted) pointer.mode = 'turning';
}

let hovered = null; // where the pointer is, until the next frame looks there
function hover(event) {
    if (event.pointerType === 'mouse') hovered = { x: event.clientX, y: event.clientY };
    wake();
}

function lookUnder() {
    if (!hovered || !parts) return;
    const hit = stage.hit(hovered.x, hovered.y, parts.figure.root);
    hovered = null;
    const part = hit ? parts.byId(hit.mesh.userData.owner) : null;
    const movable = hit && !parts.isFixed(hit.face);
    canvas.classList.toggle('over', Boolean(movable));
    over = part;
}

function cursor() {
    const modes = [...pressed.values()].map(pointer => pointer.mode);
    canvas.classList.toggle('pulling', modes.includes('pulling') || modes.includes('asking'));
    canvas.classList.toggle('turning', modes.includes('turning'));
}

canvas.addEventListener('pointerdown', press);
canvas.addEventListener('pointermove', move);
canvas.addEventListener('pointerup', lift);
canvas.addEventListener('pointercancel', lift);
canvas.addEventListener('pointerleave', () => { over = null; wake(); });
canvas.addEventListener('wheel', event => {
    event.preventDefault();
    stage.zoom(Math.exp(Math.max(-120, Math.min(120, event.deltaY)) * 0.0016));
    wake();
}, { passive: false });

// ---- keys ----------------------------------------------------------------------------------------------------------------------

const opening = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
let driving = 0;

canvas.addEventListener('keydown', event => {
    if (event.key in opening) {
        event.preventDefault();
        if (!selected && parts.list.length) select(parts.list[0]);
        if (selected) driving = opening[event.key];
        else stage.orbit(event.key === 'ArrowLeft' ? -40 : event.key === 'ArrowRight' ? 40 : 0, event.key === 'ArrowUp' ? 30 : event.key === 'ArrowDown' ? -30 : 0);
    } else if ((event.key === ' ' || event.key === 'Enter') && selected) {
        event.preventDefault();
        toggle(selected);
    } else if (event.key === 'Tab' && parts.list.length) {
        nextPart(event);
    } else if (event.key === 'Escape') {
        select(null);
    } else if (event.key === 'f') {
        findAtMiddle();
    }
    wake();
});

canvas.addEventListener('keyup', event => {
    if (!(event.key in opening) || driving === 0) return;
    driving = 0;
    if (selected?.drag) selected.release(Go.STAY);
    endHint();
    wake();
});

// Tab goes through the parts, and then on to what follows on the page.
function nextPart(event) {
    const at = parts.list.indexOf(selected) + (event.shiftKey ? -1 : 1);
    if (at < 0 || at >= parts.list.length) return;
    event.preventDefault();
    select(parts.list[at]);
}

// What is in the middle of the picture, for those who cannot point.
async function findAtMiddle() {
    const bounds = canvas.getBoundingClientRect(), hit = stage.hit(bounds.left + bounds.width / 2, bounds.top + bounds.height / 2, parts.figure.root);
    const part = hit && await parts.find(hit.face, hit.point).catch(report);
    if (part) select(part);
    else if (hit && parts.isFixed(hit.face)) sayFixed(hit);
    else say('Nothing that moves is in the middle. Turn the object with the arrow keys, then press F.');
}

// ---- frames --------------------------------------------------------------------------------------------------------------------

let last = 0, asleep = true;
function wake() {
    if (!asleep) return;
    asleep = false;
    document.body.dataset.still = 'false';
    last = 0;
    requestAnimationFrame(frame);
}

function frame(time) {
    const dt = last ? Math.min((time - last) / 1000, LONGEST_FRAME) : FIRST_FRAME;
    last = time;
    lookUnder();
    const held = [...pressed.values()].some(pointer => pointer.mode !== 'turning');
    let busyFrame = stage.advance(dt, { still, held });
    if (parts) busyFrame = moveParts(dt) || busyFrame;
    busyFrame = view.update(dt, still) || busyFrame;
    busyFrame = glow(dt) || busyFrame;
    panel.update();
    stage.render();
    asleep = !busyFrame;
    document.body.dataset.still = String(asleep);
    if (busyFrame) requestAnimationFrame(frame);
}

// Moves the parts that a hand holds or that move by themselves; true while there are any.
function moveParts(dt) {
    const held = new Set();
    for (const pointer of pressed.values()) {
        if (pointer.mode !== 'pulling') continue;
        pointer.part.follow(stage.rayAt(pointer.x, pointer.y), dt);
        held.add(pointer.part);
    }
    if (driving && selected && !held.has(selected)) {
        selected.drive(driving, dt);
        held.add(selected);
    }
    if (sliding && !held.has(sliding.part)) {
        sliding.part.setValue(sliding.value, dt);
        held.add(sliding.part);
    }
    let moving = held.size > 0;
    for (const part of parts.list) if (!held.has(part)) moving = part.coast(dt) || moving;
    return moving;
}

// The part under the pointer is lit a little; true while light comes or goes.
const lit = new Color();
function glow(dt) {
    let fading = false;
    lit.set(accent());
    for (const mesh of parts?.figure.root.children ?? []) {
        if (!mesh.userData.owner || !mesh.material.emissive || mesh.userData.material.emissiveMap) continue;
        const goal = mesh.userData.owner === over?.id && pressed.size === 0 ? 1 : 0, now = mesh.userData.glow ?? 0;
        mesh.userData.glow = now + (goal - now) * (still ? 1 : 1 - Math.exp(-GLOW * dt));
        mesh.material.emissive.copy(mesh.userData.material.emissive).add(lit.clone().multiplyScalar(0.09 * mesh.userData.glow));
        fading ||= Math.abs(goal - mesh.userData.glow) > 0.01;
    }
    return fading;
}

// ---- the page ------------------------------------------------------------------------------------------------------------------

const accent = () => getComputedStyle(document.documentElement).getPropertyValue('--accent').trim();

let saying = 0;
// Shows a message for a while; with a button that does something, where there is one.
function say(text, label, act) {
    const message = $('#message'), button = document.createElement('button');
    message.textContent = text;
    if (label) message.append(button);
    button.textContent = label;
    button.onclick = () => { message.classList.remove('shown'); act(); };
    message.classList.add('shown');
    clearTimeout(saying);
    saying = setTimeout(() => message.classList.remove('shown'), label ? 2 * MESSAGE_TIME : MESSAGE_TIME);
}

function report(error) {
    console.error(error);
    say(error.message);
    return null;
}

let working = 0;
function busy(on) {
    working += on ? 1 : -1;
    $('#loading').classList.toggle('on', working > 0);
}

let hinting = true; // until the first drag
function showHint(text) {
    if (!hinting) return;
    $('#hint span').textContent = text;
    $('#hint').hidden = false;
}

function endHint() {
    hinting = false;
    $('#hint').classList.add('gone');
}

function setPressed(id) {
    for (const button of $('#props').children) button.setAttribute('aria-pressed', String(button.dataset.id === id));
}

// The object stands in what the card leaves free.
function layout(now = false) {
    const card = $('#panel'), phone = matchMedia('(max-width: 760px)').matches;
    const bounds = card.hidden ? { width: 0, height: 0 } : card.getBoundingClientRect();
    stage.setInsets(phone ? { right: 0, bottom: (card.hidden ? 0 : bounds.height) + CHOOSER } : { right: card.hidden ? BESIDE : bounds.width * 0.7, bottom: CHOOSER }, now);
    wake();
}

function setTheme(theme) {
    document.documentElement.dataset.theme = theme;
    stage.setTheme(theme === 'dark');
    if (selected) view.show(selected, accent());
    wake();
}

const darkScheme = matchMedia('(prefers-color-scheme: dark)');
darkScheme.addEventListener('change', () => setTheme(darkScheme.matches ? 'dark' : 'light'));
$('#theme').onclick = () => setTheme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark');
$('#open').onclick = () => $('#file').click();
$('#file').onchange = event => { if (event.target.files[0]) openFile(event.target.files[0]); event.target.value = ''; };
$('#save').onclick = save;
$('#props').append(...props.map(prop => {
    const button = document.createElement('button');
    button.textContent = prop.title;
    button.dataset.id = prop.id;
    button.onclick = () => openProp(prop);
    return button;
}));

let dragged = 0; // elements that a file is held over
for (const [name, step] of [['dragenter', 1], ['dragleave', -1], ['drop', 0]]) {
    addEventListener(name, event => {
        event.preventDefault();
        dragged = step ? dragged + step : 0;
        $('#drop').classList.toggle('over', dragged > 0);
        if (name === 'drop' && event.dataTransfer.files[0]) openFile(event.dataTransfer.files[0]);
    });
}
addEventListener('dragover', event => event.preventDefault());
new ResizeObserver(() => layout(true)).observe(canvas);

solver.ready.catch(error => say(`dragmesh could not start: ${error.message}`));
setTheme(darkScheme.matches ? 'dark' : 'light');
layout(true);
const asked = props.find(prop => prop.id === location.hash.slice(1)) ?? props[0];
openProp(asked);
