// Makes the site, a folder that any web server can serve as it is. npm brings three.js, as package-lock.json pins it.
//   node build.mjs [OUTPUT_FOLDER]     build/web/site unless it is given
import { execFileSync } from 'node:child_process';
import { cpSync, copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url)), root = join(here, '../..');
const site = process.argv[2] ?? join(root, 'build/web/site');
const packages = join(root, 'build/web/npm'), three = join(packages, 'node_modules/three');

// Packages stay out of the sources' folder. What the lock names is there when its copy is.
const lock = readFileSync(join(here, 'package-lock.json'));
const installed = join(packages, 'installed.json');
if (!existsSync(installed) || !readFileSync(installed).equals(lock)) {
    mkdirSync(packages, { recursive: true });
    for (const file of ['package.json', 'package-lock.json']) copyFileSync(join(here, file), join(packages, file));
    execFileSync('npm', ['ci', '--no-audit', '--no-fund', '--ignore-scripts'], { cwd: packages, stdio: ['ignore', 'ignore', 'inherit'] });
    copyFileSync(join(here, 'package-lock.json'), installed);
}

rmSync(site, { recursive: true, force: true });
cpSync(join(here, 'page'), site, { recursive: true });

// The binding, its module and the weights.
mkdirSync(join(site, 'dragmesh/models'), { recursive: true });
for (const file of ['dragmesh.js', 'abi.js', 'memory.js']) copyFileSync(join(root, 'bindings/js', file), join(site, 'dragmesh', file));
copyFileSync(join(root, 'build/web/dragmesh.wasm'), join(site, 'dragmesh/dragmesh.wasm'));
for (const name of ['kpp_net', 'dq_vae', 'ranker']) {
    copyFileSync(join(root, `sdk/models/${name}.safetensors`), join(site, `dragmesh/models/${name}.safetensors`));
}

// three.js, and those of its add-ons that the page imports. They import 'three' by name, which browsers do not know.
const build = join(site, 'three/three.module.min.js');
function bring(from, to) {
    const text = readFileSync(from, 'utf8');
    const named = text.replace(/(from\s*)(['"])three\2/g, (_, word) => `${word}'./${relative(dirname(to), build)}'`.replace('././', './').replace('./..', '..'));
    mkdirSync(dirname(to), { recursive: true });
    writeFileSync(to, named);
    for (const [, path] of named.matchAll(/from\s*['"](\.[^'"]+)['"]/g)) {
        const next = join(dirname(from), path);
        if (next.startsWith(three) && !path.endsWith('three.module.min.js')) bring(next, join(dirname(to), path));
    }
}
for (const file of ['three.module.min.js', 'three.core.min.js']) {
    mkdirSync(join(site, 'three'), { recursive: true });
    copyFileSync(join(three, 'build', file), join(site, 'three', file));
}
copyFileSync(join(three, 'LICENSE'), join(site, 'three/LICENSE'));
for (const name of ['loaders/GLTFLoader', 'exporters/GLTFExporter', 'environments/RoomEnvironment', 'geometries/RoundedBoxGeometry']) {
    bring(join(three, 'examples/jsm', `${name}.js`), join(site, 'three/addons', `${name}.js`));
}
bring(join(three, 'examples/jsm/libs/meshopt_decoder.module.js'), join(site, 'three/addons/libs/meshopt_decoder.module.js'));
