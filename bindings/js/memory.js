// The module's memory: numbers, structs, strings and arrays between JavaScript and C.
import { structs } from './abi.js';

const vectorKeys = ['x', 'y', 'z'];
const arrayKinds = new Map([[Float32Array, 'FLOAT32'], [Float64Array, 'FLOAT64'], [Uint32Array, 'UINT32'],
    [Uint16Array, 'UINT16'], [Uint8Array, 'UINT8'], [Uint8ClampedArray, 'UINT8'], [Int32Array, 'INT32']]);

/** Name of a typed array's format, such as 'FLOAT32'. */
export function formatOf(array, allowed, what) {
    const kind = arrayKinds.get(array?.constructor);
    if (!allowed.includes(kind)) throw new TypeError(`${what} must be one of ${allowed.map(name => name.toLowerCase()).join(', ')} arrays`);
    return kind;
}

const ranges = { i32: [-(2 ** 31), 2 ** 31 - 1], u32: [0, 2 ** 32 - 1] };

/** The value, where it is an integer of 32 bits: C would cut others in silence. */
export function integer(value, what, kind = 'u32') {
    if (typeof value !== 'number') throw new TypeError(`${what} must be a number`);
    const [low, high] = ranges[kind];
    if (!Number.isInteger(value) || value < low || value > high) throw new RangeError(`${what} must be an integer of ${low} to ${high}, not ${value}`);
    return value;
}

function integer64(value, what) {
    const number = BigInt(value);
    if (BigInt.asUintN(64, number) !== number) throw new RangeError(`${what} must be an integer of 64 bits, not ${value}`);
    return number;
}

/** The bytes of a buffer or a view of one. */
export function bytesOf(data, what) {
    if (ArrayBuffer.isView(data)) return new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
    const shared = typeof SharedArrayBuffer !== 'undefined' && data instanceof SharedArrayBuffer;
    if (!shared && !(data instanceof ArrayBuffer)) throw new TypeError(`${what} must be an ArrayBuffer or a typed array`);
    return new Uint8Array(data);
}

/** Reads and writes the memory of one module. Growth replaces the buffer: every access looks at the current one. */
export class Memory {
    #exports;
    #view;
    #encoder = new TextEncoder();
    #decoder = new TextDecoder();

    constructor(exports) {
        this.#exports = exports;
        this.#view = new DataView(exports.memory.buffer);
    }

    get view() {
        if (this.#view.buffer !== this.#exports.memory.buffer) this.#view = new DataView(this.#exports.memory.buffer);
        return this.#view;
    }

    bytes(address, length) {
        return new Uint8Array(this.#exports.memory.buffer, address, length);
    }

    /** Runs body(scope); what it allocates there is freed afterwards. */
    scope(body) {
        const scope = new Scope(this, this.#exports);
        try {
            return body(scope);
        } finally {
            scope.free();
        }
    }

    text(address) {
        const all = new Uint8Array(this.#exports.memory.buffer);
        return this.#decoder.decode(all.slice(address, all.indexOf(0, address)));
    }

    encode(text) {
        return this.#encoder.encode(text);
    }

    /** Writes a struct: zeros, its size, and the named fields. An unknown name is a TypeError. */
    write(name, address, values = {}) {
        const { size, fields } = structs[name];
        this.bytes(address, size).fill(0);
        if (fields.structSize) this.view.setUint32(address, size, true);
        if (name === 'dm_vec3') {
            this.writeVector(address, values);
            return;
        }
        for (const key of Object.keys(values)) {
            if (values[key] === undefined || values[key] === null) continue;
            if (!fields[key] || key === 'structSize') throw new TypeError(`${name} has no field "${key}"`);
            this.#writeField(fields[key], address, values[key], `${name}.${key}`);
        }
    }

    /** Writes [x, y, z], or an object that has x, y and z. */
    writeVector(address, value) {
        const array = Array.isArray(value) || ArrayBuffer.isView(value);
        for (let i = 0; i < 3; i++) this.view.setFloat32(address + 4 * i, array ? value[i] : value[vectorKeys[i]], true);
    }

    #writeField([offset, kind, count], address, value, what) {
        if (structs[kind]) this.write(kind, address + offset, value);
        else if (count === undefined) this.#writeNumber(kind, address + offset, value, what);
        else for (let i = 0; i < count; i++) this.#writeNumber(kind, address + offset + i * 4, value[i] ?? 0, what);
    }

    #writeNumber(kind, address, value, what) {
        if (kind === 'u64') this.view.setBigUint64(address, integer64(value, what), true);
        else if (kind !== 'f32') this.view.setInt32(address, integer(value, what, kind), true);
        else if (typeof value === 'number') this.view.setFloat32(address, value, true);
        else throw new TypeError(`${what} must be a number`);
    }

    /** Reads a struct into `out`; vectors and arrays of numbers become arrays. Size and reserved fields are left out. */
    read(name, address, out = {}) {
        if (name === 'dm_vec3') return this.#readNumbers('f32', address, 3, out);
        for (const [key, field] of fieldsOf(name)) out[key] = this.#readField(field, address, out[key]);
        return out;
    }

    #readField([offset, kind, count], address, old) {
        if (count !== undefined && structs[kind]) {
            return Array.from({ length: count }, (_, i) => this.read(kind, address + offset + i * structs[kind].size));
        }
        if (structs[kind]) return this.read(kind, address + offset, old);
        if (count !== undefined) return this.#readNumbers(kind, address + offset, count, old);
        return this.#readNumber(kind, address + offset);
    }

    #readNumbers(kind, address, count, old) {
        const out = Array.isArray(old) ? old : new Array(count);
        for (let i = 0; i < count; i++) out[i] = this.#readNumber(kind, address + 4 * i);
        return out;
    }

    #readNumber(kind, address) {
        switch (kind) {
        case 'f32': return this.view.getFloat32(address, true);
        case 'i32': return this.view.getInt32(address, true);
        case 'u64': return Number(this.view.getBigUint64(address, true));
        default: return this.view.getUint32(address, true);
        }
    }
}

const shown = new Map();

// The fields that callers see.
function fieldsOf(name) {
    if (!shown.has(name)) shown.set(name, Object.entries(structs[name].fields).filter(([key]) => key !== 'structSize' && !key.startsWith('reserved')));
    return shown.get(name);
}

/** Memory of one call. */
class Scope {
    #memory;
    #exports;
    #blocks = [];

    constructor(memory, exports) {
        this.#memory = memory;
        this.#exports = exports;
    }

    allocate(size) {
        const address = this.#exports.malloc(Math.max(size, 1)) >>> 0;
        if (address === 0) throw new RangeError(`no memory for ${size} bytes`);
        this.#blocks.push(address);
        return address;
    }

    struct(name, values) {
        const address = this.allocate(structs[name].size);
        this.#memory.write(name, address, values);
        return address;
    }

    structs(name, list) {
        const { size } = structs[name], rows = Array.from(list), address = this.allocate(size * rows.length);
        rows.forEach((values, i) => this.#memory.write(name, address + i * size, values)); // a hole of the list is zeros
        return address;
    }

    /** A copy of a typed array. */
    copy(data) {
        const bytes = bytesOf(data), address = this.allocate(bytes.length);
        this.#memory.bytes(address, bytes.length).set(bytes);
        return address;
    }

    text(text, what) {
        if (typeof text !== 'string') throw new TypeError(`${what} must be a string`);
        if (text.includes('\0')) throw new TypeError(`${what} has a zero character, which would end it`);
        const bytes = this.#memory.encode(text), address = this.allocate(bytes.length + 1);
        const target = this.#memory.bytes(address, bytes.length + 1);
        target.set(bytes);
        target[bytes.length] = 0;
        return address;
    }

    free() {
        for (const block of this.#blocks) this.#exports.free(block);
        this.#blocks = [];
    }
}
