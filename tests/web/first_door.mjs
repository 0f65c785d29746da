// The page of docs/engines/web.md in Chromium, served as it says: a door of the cabinet follows the mouse, and stays open.
//   node tests/web/first_door.mjs FOLDER [PICTURE.png]
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { createRequire } from 'node:module';
import { createServer } from 'node:net';
import { fileURLToPath } from 'node:url';

const { chromium } = createRequire(fileURLToPath(new URL('../../build/web/npm/package.json', import.meta.url)))('playwright-core');
const [, , folder, picture] = process.argv;
const PATIENCE = 120000; // ms: two slow cores draw without a GPU

const port = await new Promise(resolve => { // a free one
    const probe = createServer().listen(0, '127.0.0.1', () => { const { port } = probe.address(); probe.close(() => resolve(port)); });
});
const server = spawn('/usr/bin/python3', ['-m', 'http.server', port, '--bind', '127.0.0.1'], { cwd: folder, stdio: 'ignore' });
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--no-first-run',
    '--disable-background-networking', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
try {
    const page = await browser.newPage({ viewport: { width: 800, height: 600 } }), problems = [];
    page.setDefaultTimeout(PATIENCE);
    page.on('pageerror', error => problems.push(error.message));
    const address = `http://127.0.0.1:${port}/first_door.html`;
    await page.goto(address).catch(() => page.waitForTimeout(2000).then(() => page.goto(address))); // the server takes a moment
    await page.waitForFunction(() => document.title === 'drag a door');
    await page.mouse.move(345, 330); // the left door, whose hinge is at its left
    await page.mouse.down();
    for (let x = 345; x >= 265; x -= 8) {
        await page.mouse.move(x, 330 + (345 - x) / 4);
        await page.waitForTimeout(50);
    }
    await page.waitForFunction(() => /stands at [1-9]|stands at 0\.[3-9]/.test(document.title));
    const held = await page.title();
    await page.mouse.up();
    if (picture) await page.screenshot({ path: picture });
    assert.deepEqual(problems, []);
    console.log(`first_door.html: ${held}`);
} finally {
    await browser.close();
    server.kill();
}
