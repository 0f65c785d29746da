// Copies into this folder what the package takes from elsewhere: module, weights, licence. npm runs it before `npm pack`, and
// with --clean afterwards.
import { copyFileSync, mkdirSync, rmSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const here = name => fileURLToPath(new URL(name, import.meta.url));
const models = ['kpp_net', 'dq_vae', 'ranker'].map(name => `${name}.safetensors`);
const copies = [['../../build/web/dragmesh.wasm', 'dragmesh.wasm'], ['../../LICENSE', 'LICENSE'],
    ...models.map(name => [`../../sdk/models/${name}`, `models/${name}`])];

if (process.argv[2] === '--clean') {
    for (const name of ['dragmesh.wasm', 'LICENSE', 'models']) rmSync(here(name), { recursive: true, force: true });
} else {
    mkdirSync(here('models'), { recursive: true });
    for (const [from, to] of copies) copyFileSync(here(from), here(to));
}
