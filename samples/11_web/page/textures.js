// Pictures that are computed: wood, and what a screen and a keyboard show.
import { CanvasTexture, MirroredRepeatWrapping, SRGBColorSpace } from './three/three.module.min.js';

// Noise of a lattice, smooth between its points; the same for the same place.
function noise(x, y, seed) {
    const lattice = (i, j) => { const s = Math.sin(i * 127.1 + j * 311.7 + seed * 74.7) * 43758.5453; return s - Math.floor(s); };
    const i = Math.floor(x), j = Math.floor(y), u = x - i, v = y - j;
    const a = u * u * (3 - 2 * u), b = v * v * (3 - 2 * v);
    return (lattice(i, j) * (1 - a) + lattice(i + 1, j) * a) * (1 - b) + (lattice(i, j + 1) * (1 - a) + lattice(i + 1, j + 1) * a) * b;
}

function canvas(width, height, draw) {
    const element = Object.assign(document.createElement('canvas'), { width, height });
    draw(element.getContext('2d'), width, height);
    return element;
}

function texture(element, color = true) {
    const made = new CanvasTexture(element);
    made.wrapS = made.wrapT = MirroredRepeatWrapping; // without seams
    made.anisotropy = 8;
    if (color) made.colorSpace = SRGBColorSpace;
    return made;
}

/** Wood whose grain runs along u. dark, light: [r, g, b], 0 to 255. */
export function wood(dark, light, seed) {
    return texture(canvas(512, 512, (context, width, height) => {
        const image = context.createImageData(width, height);
        for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) {
            const warp = noise(x / 330, y / 110, seed) * 3.4 + noise(x / 130, y / 30, seed + 3) * 0.5;
            const ring = 0.5 + 0.5 * Math.sin((y / 13 + warp) * 1.7);
            const fibre = noise(x / 70, y / 1.3, seed + 7), pore = noise(x / 22, y / 1.1, seed + 11) > 0.88 ? 0.12 : 0;
            const cloud = noise(x / 150, y / 150, seed + 13);
            const share = Math.min(1, Math.max(0, 0.34 * ring ** 1.4 + 0.38 * fibre + 0.3 * cloud - pore)), at = 4 * (y * width + x);
            for (let k = 0; k < 3; k++) image.data[at + k] = dark[k] + (light[k] - dark[k]) * share;
            image.data[at + 3] = 255;
        }
        context.putImageData(image, 0, 0);
    }));
}

/** A quiet landscape at dusk, for the screen of a laptop. */
export function wallpaper() {
    return texture(canvas(1024, 640, (context, width, height) => {
        const sky = context.createLinearGradient(0, 0, 0, height);
        [[0, '#20304f'], [0.45, '#6f6f9a'], [0.68, '#e8a87c'], [1, '#f4d3a4']].forEach(([at, color]) => sky.addColorStop(at, color));
        context.fillStyle = sky;
        context.fillRect(0, 0, width, height);
        context.fillStyle = '#fff3d6';
        context.beginPath();
        context.arc(width * 0.66, height * 0.56, 34, 0, 7);
        context.fill();
        ['#5b5f86', '#434a70', '#2c3357', '#1a2140'].forEach((color, layer) => {
            context.fillStyle = color;
            context.beginPath();
            context.moveTo(0, height);
            for (let x = 0; x <= width; x += 4) {
                const hill = noise(x / (250 - 40 * layer), layer, 5) * 190 + noise(x / 60, layer, 9) * 26;
                context.lineTo(x, height * (0.62 + 0.12 * layer) - hill * (1 - 0.16 * layer) + 60);
            }
            context.lineTo(width, height);
            context.fill();
        });
    }));
}
