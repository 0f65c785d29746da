// The page in Chromium, with the pointer events of a mouse and of fingers: opens parts, compares pictures, saves and opens a GLB.
//   node tests/web/page.mjs SITE [--write]     --write: the pictures become those to compare with
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { serve } from '../../samples/11_web/serve.mjs';

const here = name => fileURLToPath(new URL(name, import.meta.url));
const { chromium } = createRequire(here('../../build/web/npm/package.json'))('playwright-core');
const [, , site, option] = process.argv;
const pictures = here('pictures'), out = here('../../build/web/pictures');
const PATIENCE = 120000; // ms: two slow cores draw without a GPU
const ALIKE = 0.02; // largest mean difference of two pictures, of all levels; measured: 0.003 here; another Chromium draws edges anew
const SMALL = 160; // px: pictures are compared at this width, where a letter's edge does not count
const FOLLOWED = 12; // frames after which a part has come to where the pointer asks it to be
const KEPT = 480; // px: width of the pictures that are kept to compare with

const server = await serve(site);
const address = `http://127.0.0.1:${server.address().port}/`;
// No GPU: SwiftShader draws. Nothing is fetched from elsewhere.
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--no-first-run',
    '--disable-background-networking', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
mkdirSync(out, { recursive: true });

const desktop = { viewport: { width: 960, height: 600 } };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

async function open(kind, prop) {
    const context = await browser.newContext({ ...kind, reducedMotion: 'reduce', acceptDownloads: true });
    context.setDefaultTimeout(PATIENCE);
    const page = await context.newPage(), problems = [];
    page.on('pageerror', error => problems.push(error.message));
    page.on('console', message => { if (message.type() === 'error') problems.push(message.text()); });
    page.on('request', request => { if (!request.url().startsWith(address) && !/^(blob|data):/.test(request.url())) problems.push(`asked for ${request.url()}`); });
    await page.goto(`${address}#${prop}`);
    await page.waitForFunction(() => document.body.dataset.ready === '1');
    return { page, problems, close: () => context.close() };
}

// Mouse and fingers, as the browser's own input events.
async function hand(page, touch) {
    if (!touch) return { down: async (x, y) => { await page.mouse.move(x, y); await page.mouse.down(); }, move: (x, y) => page.mouse.move(x, y), up: () => page.mouse.up() };
    const session = await page.context().newCDPSession(page);
    const send = (type, points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points });
    return { down: (x, y) => send('touchStart', [{ x, y }]), move: (x, y) => send('touchMove', [{ x, y }]), up: () => send('touchEnd', []) };
}

const value = page => page.textContent('#panel .value');

// Pulls from a place over a way, in steps that frames see; returns what the card says while the part is held.
async function pull(page, touch, [x, y], [dx, dy]) {
    const fingers = await hand(page, touch);
    await fingers.down(x, y);
    await page.waitForSelector('#panel:not([hidden])');
    for (let i = 1; i <= 10; i++) {
        await fingers.move(x + dx * i / 10, y + dy * i / 10);
        await frames(page, 1);
    }
    await frames(page, FOLLOWED);
    const held = await value(page);
    return { held, kind: await page.textContent('#panel .kind'), up: () => fingers.up() };
}

const frames = (page, count) => page.evaluate(async count => {
    for (let i = 0; i < count; i++) await new Promise(resolve => requestAnimationFrame(resolve));
}, count);

// Until nothing moves any more.
async function settled(page) {
    await frames(page, 2);
    await page.waitForFunction(() => document.body.dataset.still === 'true');
}

// A picture made smaller, by the browser.
async function smaller(page, picture) {
    const base64 = await page.evaluate(async ([source, width]) => {
        const image = await createImageBitmap(await (await fetch(source)).blob()), height = Math.round(width * image.height / image.width);
        const canvas = new OffscreenCanvas(width, height), context = canvas.getContext('2d');
        context.imageSmoothingQuality = 'high';
        context.drawImage(image, 0, 0, width, height);
        const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
        return btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(''));
    }, [`data:image/png;base64,${picture.toString('base64')}`, KEPT]);
    return Buffer.from(base64, 'base64');
}

// Mean difference of two pictures, 0 to 1, computed by the browser.
async function difference(page, a, b) {
    return page.evaluate(async ([a, b, width]) => {
        const pixels = async source => {
            const image = await createImageBitmap(await (await fetch(source)).blob()), height = Math.round(width * image.height / image.width);
            const context = new OffscreenCanvas(width, height).getContext('2d');
            context.imageSmoothingQuality = 'high';
            context.drawImage(image, 0, 0, width, height);
            return context.getImageData(0, 0, width, height).data;
        };
        const [p, q] = await Promise.all([pixels(a), pixels(b)]);
        return p.length === q.length ? p.reduce((sum, level, i) => sum + Math.abs(level - q[i]), 0) / p.length / 255 : 1;
    }, [a, b, SMALL].map(each => (Buffer.isBuffer(each) ? `data:image/png;base64,${each.toString('base64')}` : each)));
}

async function compare(page, name) {
    const picture = await page.screenshot({ animations: 'disabled' }), file = join(pictures, `${name}.png`);
    writeFileSync(join(out, `${name}.png`), picture);
    if (option === '--write') {
        mkdirSync(pictures, { recursive: true });
        writeFileSync(file, await smaller(page, picture));
    }
    assert.ok(existsSync(file), `${file} is missing: node tests/web/page.mjs SITE --write, and look at it`);
    const off = await difference(page, picture, readFileSync(file));
    console.log(`${name}: ${(100 * off).toFixed(2)} % from its picture`);
    assert.ok(off <= ALIKE, `${name} differs by ${(100 * off).toFixed(1)} %: compare ${join(out, name)}.png`);
    return picture;
}

const number = text => Number.parseFloat(text.replace('−', '-'));

async function try_(name, kind, prop, from, way, expected) {
    const { page, problems, close } = await open(kind, prop);
    const before = await compare(page, `${name}_before`);
    const { held, kind: what, up } = await pull(page, kind.hasTouch, from, way);
    const after = await compare(page, `${name}_pulled`);
    console.log(`${name}: ${what}, ${held}`);
    assert.match(what, expected);
    assert.ok(Math.abs(number(held)) > 5, `${name} stands at ${held}`);
    assert.ok(await difference(page, before, after) > 0.01, `${name} looks as before`);
    await up();
    assert.deepEqual(problems, []);
    return { page, problems, close };
}

try {
    const sideboard = await try_('sideboard_desktop', desktop, 'sideboard', [474, 294], [-93, 64], /^Hinge/);
    await keys(sideboard.page);
    await saveAndOpen(sideboard.page);
    assert.deepEqual(sideboard.problems, []);
    await sideboard.close();
    await (await try_('chest_desktop', desktop, 'chest', [363, 193], [0, -93], /^Hinge/)).close();
    await (await try_('washer_phone', phone, 'washer', [203, 428], [-110, 40], /^(Hinge|Turns)/)).close();
    const toolbox = await try_('toolbox_desktop', desktop, 'toolbox', [370, 240], [22, -125], /^Hinge/); // one mesh: the lid is found
    await dropFiles(toolbox.page);
    await wholeAsset(toolbox.page);
    assert.deepEqual(toolbox.problems, []);
    await toolbox.close();
    console.log('page: passed');
} finally {
    await browser.close();
    server.close();
}

// Enter opens the chosen part or closes it, arrow keys move it.
async function keys(page) {
    await page.focus('#stage');
    await settled(page);
    const seen = [await value(page)];
    await page.keyboard.press('Enter');
    await settled(page);
    seen.push(await value(page));
    await page.keyboard.down('ArrowLeft');
    await frames(page, FOLLOWED);
    await page.keyboard.up('ArrowLeft');
    await settled(page);
    seen.push(await value(page));
    await page.keyboard.press('Enter');
    await settled(page);
    seen.push(await value(page));
    console.log(`keys: ${seen.join(', ')}`);
    assert.ok(number(seen[2]) < number(seen[1]), 'the arrow to the left closes');
    assert.ok(new Set(seen).size > 2 && seen.slice(1).includes('0°'), 'Enter opens and closes');
}

// The saved GLB has an animation and a node for each part, and opens here with the same parts.
async function saveAndOpen(page) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save')]);
    const file = join(tmpdir(), `dragmesh_${process.pid}.glb`);
    await download.saveAs(file);
    const data = readFileSync(file), json = JSON.parse(data.subarray(20, 20 + data.readUInt32LE(12)));
    assert.equal(data.readUInt32LE(0), 0x46546c67); // 'glTF'
    assert.equal(json.animations.length, 1);
    const parts = json.nodes.filter(node => node.extras?.dragmesh);
    assert.equal(parts.length, 5);
    assert.ok(parts.every(node => ['revolute', 'prismatic'].includes(node.extras.dragmesh.type)));
    await page.setInputFiles('#file', file);
    await page.waitForFunction(() => document.body.dataset.ready === '2');
    assert.equal(await page.locator('#parts button').count(), 5);
    console.log(`saved: ${data.length} bytes, ${parts.length} parts, opened again`);
}

// A file held over the page, and let go there.
async function drop(page, name, data) {
    const files = await page.evaluateHandle(([name, base64]) => {
        const transfer = new DataTransfer();
        transfer.items.add(new File([Uint8Array.from(atob(base64), letter => letter.charCodeAt(0))], name));
        return transfer;
    }, [name, data.toString('base64')]);
    await page.dispatchEvent('#stage', 'dragenter', { dataTransfer: files });
    assert.match(await page.getAttribute('#drop', 'class') ?? '', /\bover\b/, 'the page does not show that a file may be dropped');
    await page.dispatchEvent('#stage', 'drop', { dataTransfer: files });
    assert.doesNotMatch(await page.getAttribute('#drop', 'class') ?? '', /\bover\b/);
}

// A .glb of boxes, each a node: name, least corner, greatest corner.
function boxes(list) {
    const faces = [0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6];
    const corners = list.flatMap(([, low, high]) => faces.flatMap(i => [0, 1, 2].map(k => ((i >> k) & 1 ? high[k] : low[k]))));
    const bytes = Buffer.from(Float32Array.from(corners).buffer), count = faces.length, length = 12 * count;
    const json = JSON.stringify({
        asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: list.map((_, i) => i) }], nodes: list.map(([name], i) => ({ name, mesh: i })),
        meshes: list.map((_, i) => ({ primitives: [{ attributes: { POSITION: i } }] })), buffers: [{ byteLength: bytes.length }],
        bufferViews: list.map((_, i) => ({ buffer: 0, byteOffset: length * i, byteLength: length })),
        accessors: list.map(([, min, max], i) => ({ bufferView: i, componentType: 5126, count, type: 'VEC3', min, max })) });
    const text = Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4)), head = Buffer.alloc(20), between = Buffer.alloc(8);
    head.write('glTF');
    [2, 28 + text.length + bytes.length, text.length, 0x4e4f534a].forEach((number, i) => head.writeUInt32LE(number, 4 + 4 * i));
    [bytes.length, 0x004e4942].forEach((number, i) => between.writeUInt32LE(number, 4 * i));
    return Buffer.concat([head, text, between, bytes]);
}

// A cupboard that nobody has rigged: the knob goes with the door, and the boards stay.
async function wholeAsset(page) {
    await drop(page, 'cupboard.glb', boxes([['side', [-0.4, 0, -0.25], [-0.38, 0.8, 0.23]], ['side_2', [0.38, 0, -0.25], [0.4, 0.8, 0.23]],
        ['floor', [-0.38, 0, -0.25], [0.38, 0.02, 0.23]], ['roof', [-0.38, 0.78, -0.25], [0.38, 0.8, 0.23]],
        ['back', [-0.38, 0.02, -0.25], [0.38, 0.78, -0.23]], ['door', [-0.4, 0, 0.232], [0.4, 0.8, 0.25]], ['knob', [0.25, 0.34, 0.25], [0.33, 0.46, 0.3]]]));
    await page.waitForFunction(() => document.body.dataset.ready === '3');
    await settled(page);
    assert.deepEqual(await page.locator('#parts button').allTextContents(), ['Door']);
    await page.mouse.click(590, 250);
    await page.getByText('Side 2 stays.').waitFor();
    assert.equal(await page.locator('#panel').isVisible(), false, 'a board can be dragged');
    const { held, kind, up } = await pull(page, false, [475, 300], [-120, 60]);
    await up();
    console.log(`cupboard: ${kind}, ${held}, by its knob`);
    assert.match(kind, /^Hinge/);
    assert.ok(Math.abs(number(held)) > 5, `the door stands at ${held}`);
}

// A dropped GLB opens; a dropped file of another sort is refused with words, and what was there stays.
async function dropFiles(page) {
    await drop(page, 'cabinet.glb', readFileSync(here('../../samples/cabinet.glb')));
    await page.waitForFunction(() => document.body.dataset.ready === '2');
    const names = await page.locator('#parts button').allTextContents();
    assert.equal(names.length, 4, `the dropped cabinet has the parts ${names}`);
    await drop(page, 'notes.txt', Buffer.from('no model'));
    await page.getByText('This file could not be opened').waitFor();
    assert.equal(await page.locator('#parts button').count(), 4);
    console.log(`dropped: ${names.join(', ')}`);
}
