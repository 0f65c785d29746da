// Serves the site on this machine alone, with the headers that any host of it should send.
//   node serve.mjs [PORT [FOLDER]]
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { dirname, extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const types = { '.html': 'text/html; charset=utf-8', '.css': 'text/css', '.js': 'text/javascript', '.wasm': 'application/wasm',
    '.safetensors': 'application/octet-stream', '.svg': 'image/svg+xml', '.json': 'application/json', '.glb': 'model/gltf-binary' };
// The module needs 'wasm-unsafe-eval'; files of a GLB become blobs.
const policy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; " +
    "connect-src 'self' blob: data:; img-src 'self' blob: data:; base-uri 'none'; form-action 'none'";

/** Starts the server; port 0 takes any free one. */
export function serve(folder, port = 0) {
    const server = createServer((request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
        const file = join(folder, path.endsWith('/') ? `${path}index.html` : path);
        let size;
        try {
            size = statSync(file).size;
        } catch {
            response.writeHead(404).end();
            return;
        }
        response.writeHead(200, { 'Content-Type': types[extname(file)] ?? 'application/octet-stream', 'Content-Length': size,
            'Content-Security-Policy': policy, 'X-Content-Type-Options': 'nosniff', 'Cache-Control': 'no-cache' });
        createReadStream(file).pipe(response);
    });
    return new Promise(resolve => server.listen(port, '127.0.0.1', () => resolve(server)));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    const folder = process.argv[3] ?? join(dirname(fileURLToPath(import.meta.url)), '../../build/web/site');
    const server = await serve(folder, Number(process.argv[2] ?? 8080));
    console.log(`http://localhost:${server.address().port}/`);
}
