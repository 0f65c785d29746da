// Draws a joint: the axis of a hinge with the arc of its range, the rail of a slide, and where the part is on it.
import { BufferAttribute, BufferGeometry, CylinderGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, Quaternion, SphereGeometry, Vector3 } from './three/three.module.min.js';
import { JointType } from './dragmesh/dragmesh.js';

const STEPS = 64; // of an arc
const FADE = 9; // 1/s
const up = new Vector3(0, 1, 0);

export class JointView {
    group = new Group();
    #materials = new Map();
    #shown = 0;
    #goal = 0;

    constructor() {
        this.group.renderOrder = 10;
    }

    // Each shape is drawn twice: faint where it is hidden, full where it is seen.
    #material(name, color, opacity) {
        if (!this.#materials.has(name)) {
            const make = (hidden) => Object.assign(new MeshBasicMaterial({ color, transparent: true, depthWrite: false, depthTest: !hidden, side: DoubleSide, toneMapped: false }),
                { userData: { opacity: hidden ? opacity * 0.28 : opacity } });
            this.#materials.set(name, [make(true), make(false)]);
        }
        return this.#materials.get(name);
    }

    #add(geometry, name, color, opacity) {
        return this.#material(name, color, opacity).map(material => {
            const mesh = new Mesh(geometry, material);
            mesh.renderOrder = 10;
            this.group.add(mesh);
            return mesh;
        });
    }

    clear() {
        for (const mesh of this.group.children) mesh.geometry.dispose();
        this.group.clear();
        this.#goal = 0;
    }

    hide() {
        this.#goal = 0;
    }

    /** Shows a part's joint; accent: a CSS colour. */
    show(part, accent) {
        for (const mesh of this.group.children) mesh.geometry.dispose();
        this.group.clear();
        this.#materials.forEach(pair => pair.forEach(material => material.color.set(accent)));
        this.part = part;
        const { joint, info } = part;
        const low = new Vector3(...info.boxMin), high = new Vector3(...info.boxMax), size = high.distanceTo(low);
        const axis = new Vector3(...joint.axis), origin = new Vector3(...joint.origin), thick = part.parts.asset.size * 0.0045;
        this.rest = new Vector3(...info.centre);
        if (joint.type === JointType.PRISMATIC) this.#slide(joint, axis, thick, accent);
        else if (joint.type !== JointType.FIXED) this.#hinge(joint, axis, origin, size, thick, accent);
        this.#goal = 1;
        this.update();
    }

    #hinge(joint, axis, origin, size, thick, accent) {
        const { info } = this.part, extent = corners(info).map(corner => corner.sub(origin).dot(axis));
        const from = Math.min(...extent) - size * 0.08, to = Math.max(...extent) + size * 0.08;
        this.#rod(origin.clone().addScaledVector(axis, from), origin.clone().addScaledVector(axis, to), thick, accent);
        // The arc lies through the part's centre, or, of a part that turns about it, through its rim.
        const along = this.rest.clone().sub(origin).dot(axis), middle = origin.clone().addScaledVector(axis, along);
        let arm = this.rest.clone().sub(middle);
        const reach = Math.max(...corners(info).map(corner => distanceToLine(corner, origin, axis)));
        if (arm.length() < 0.2 * reach) arm = anyAcross(axis).multiplyScalar(reach * 0.9);
        else arm.setLength(Math.min(arm.length() * 1.25, reach));
        const [lower, upper] = range(joint, 2 * Math.PI);
        this.#sector(middle, axis, arm, lower, upper, thick, accent);
        this.marker = value => middle.clone().add(arm.clone().applyQuaternion(new Quaternion().setFromAxisAngle(axis, value))).addScaledVector(axis, joint.pitch * value);
        this.#add(new SphereGeometry(thick * 2.6, 24, 16), 'solid', accent, 0.95).forEach(mesh => { mesh.userData.marker = true; });
    }

    #slide(joint, axis, thick, accent) {
        const { asset } = this.part.parts;
        const [lower, upper] = range(joint, asset.size);
        const at = value => this.rest.clone().addScaledVector(axis, value);
        this.#rod(at(lower), at(upper), thick, accent);
        for (const end of [lower, upper]) {
            const [mesh, other] = this.#add(new SphereGeometry(thick * 1.7, 20, 12), 'solid', accent, 0.95);
            mesh.position.copy(at(end));
            other.position.copy(at(end));
        }
        this.marker = at;
        this.#add(new SphereGeometry(thick * 2.6, 24, 16), 'solid', accent, 0.95).forEach(mesh => { mesh.userData.marker = true; });
    }

    #rod(from, to, thick, accent) {
        const along = to.clone().sub(from), geometry = new CylinderGeometry(thick, thick, along.length(), 16);
        for (const mesh of this.#add(geometry, 'solid', accent, 0.95)) {
            mesh.position.copy(from).addScaledVector(along, 0.5);
            mesh.quaternion.setFromUnitVectors(up, along.normalize());
        }
    }

    // A fan from the middle, faint, and a band along its rim.
    #sector(middle, axis, arm, lower, upper, thick, accent) {
        const radius = arm.length(), fan = [], band = [], turn = new Quaternion();
        const place = (value, share) => arm.clone().multiplyScalar(share).applyQuaternion(turn.setFromAxisAngle(axis, value)).add(middle);
        const rim = 1 - 2.2 * thick / radius;
        for (let i = 0; i < STEPS; i++) {
            const a = lower + (upper - lower) * i / STEPS, b = lower + (upper - lower) * (i + 1) / STEPS;
            fan.push(middle, place(a, rim), place(b, rim));
            band.push(place(a, rim), place(a, 1), place(b, 1), place(a, rim), place(b, 1), place(b, rim));
        }
        this.#add(surface(fan), 'fan', accent, 0.16);
        this.#add(surface(band), 'solid', accent, 0.95);
    }

    /** Follows the part, and fades; true while it fades. */
    update(dt = 0, still = false) {
        this.#shown += (this.#goal - this.#shown) * (still ? 1 : 1 - Math.exp(-FADE * dt));
        this.group.visible = this.#shown > 0.01;
        this.#materials.forEach(pair => pair.forEach(material => { material.opacity = material.userData.opacity * this.#shown; }));
        if (this.part) {
            const carried = this.part.parent;
            this.group.matrixAutoUpdate = false;
            if (carried) this.group.matrix.copy(carried.world);
            else this.group.matrix.identity();
            this.group.matrixWorldNeedsUpdate = true;
            for (const mesh of this.group.children) if (mesh.userData.marker) mesh.position.copy(this.marker(this.part.value));
        }
        return Math.abs(this.#goal - this.#shown) > 0.004;
    }
}

// The range that is drawn; joints without limits have all of it.
function range({ type, lower, upper }, all) {
    if (type === JointType.CONTINUOUS || lower === upper) return [-all / 2, all / 2];
    return [Math.max(lower, -all), Math.min(upper, all)];
}

function corners({ boxMin, boxMax }) {
    return Array.from({ length: 8 }, (_, i) => new Vector3(...[0, 1, 2].map(k => (i >> k & 1 ? boxMax : boxMin)[k])));
}

function distanceToLine(point, origin, axis) {
    return point.clone().sub(origin).cross(axis).length();
}

function anyAcross(axis) {
    const other = Math.abs(axis.y) < 0.9 ? up : new Vector3(1, 0, 0);
    return other.clone().cross(axis).normalize();
}

function surface(points) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(points.flatMap(point => point.toArray())), 3));
    return geometry;
}
