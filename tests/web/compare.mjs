// Compares two outputs of the common scenario, the second from another instruction set and another C library: the same words and
// whole numbers, and floats that differ by a few units of their last place, as sums in another order do.
//   node tests/web/compare.mjs FILE FILE
import { readFileSync } from 'node:fs';

const TOLERANCE = 1e-5; // absolute, on numbers of the order of 1; measured: 8e-7
const lines = path => readFileSync(path, 'utf8').trim().split('\n');
const [a, b] = [lines(process.argv[2]), lines(process.argv[3])];
const float = bits => new DataView(Uint32Array.of(Number.parseInt(bits, 16)).buffer).getFloat32(0, true);
const isFloat = word => /^[0-9a-f]{8}$/.test(word);

let largest = 0;
const same = a.length === b.length && a.every((line, i) => {
    if (line.startsWith('saved')) return line.split(' ')[1] === b[i].split(' ')[1]; // the hash is of floats
    const [words, others] = [line.split(' '), b[i].split(' ')];
    if (line.startsWith('evidence')) return words.length === others.length; // steps, and a hash, of floats
    return words.length === others.length && words.every((word, k) => {
        if (!isFloat(word)) return word === others[k];
        const difference = Math.abs(float(word) - float(others[k]));
        largest = Math.max(largest, difference);
        return difference <= TOLERANCE;
    });
});
console.log(`largest difference from native: ${largest.toExponential(1)}`);
process.exit(same ? 0 : 1);
