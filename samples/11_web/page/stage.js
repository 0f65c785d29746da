// The stage: renderer, light, floor, and a camera that circles the object.
import { AmbientLight, Color, DirectionalLight, Mesh, NeutralToneMapping, PCFSoftShadowMap, PerspectiveCamera, PlaneGeometry, PMREMGenerator,
    Raycaster, Scene, ShadowMaterial, SRGBColorSpace, Vector2, Vector3, WebGLRenderer } from './three/three.module.min.js';
import { RoomEnvironment } from './three/addons/environments/RoomEnvironment.js';

const FIELD_OF_VIEW = 32; // degrees: a long lens, which shows things calmly
const EASE = 6; // 1/s, of the camera behind the hand
const POLES = 0.12; // rad that the camera keeps from straight above and below

export class Stage {
    scene = new Scene();
    camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
    #target = new Vector3();
    #now = { turn: 0.6, tilt: 0.28, distance: 4 };
    #goal = { turn: 0.6, tilt: 0.28, distance: 4 };
    #radius = 1;
    #caster = new Raycaster();
    #insets = { right: 0, bottom: 0 };
    #insetsGoal = { right: 0, bottom: 0 };

    constructor(canvas) {
        this.canvas = canvas;
        this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
        this.renderer.outputColorSpace = SRGBColorSpace;
        this.renderer.toneMapping = NeutralToneMapping;
        this.renderer.shadowMap.enabled = true;
        this.renderer.shadowMap.type = PCFSoftShadowMap;
        const generator = new PMREMGenerator(this.renderer);
        this.scene.environment = generator.fromScene(new RoomEnvironment(), 0.03).texture;
        this.scene.environmentIntensity = 0.62;
        generator.dispose();
        this.sun = new DirectionalLight(0xfff4e6, 2.1);
        this.sun.castShadow = true;
        this.sun.shadow.mapSize.set(2048, 2048);
        this.sun.shadow.radius = 7;
        this.sun.shadow.bias = -0.0002;
        this.sun.shadow.normalBias = 0.02;
        this.floor = new Mesh(new PlaneGeometry(1, 1), new ShadowMaterial({ opacity: 0.22, color: 0x1c1410 }));
        this.floor.rotation.x = -Math.PI / 2;
        this.floor.receiveShadow = true;
        this.scene.add(this.sun, this.sun.target, this.floor, new AmbientLight(0xffffff, 0.15));
    }

    setTheme(dark) {
        this.floor.material.opacity = dark ? 0.5 : 0.2;
        this.floor.material.color = new Color(dark ? 0x000000 : 0x2a2018);
        this.scene.environmentIntensity = dark ? 0.5 : 0.66;
    }

    /** Shows an object in this box. view: { turn, tilt } of the camera, rad. */
    frame(box, view = {}) {
        const size = box.getSize(new Vector3());
        this.#radius = size.length() / 2;
        box.getCenter(this.#target);
        Object.assign(this.#goal, { turn: 0.55, tilt: 0.26, ...view, distance: this.#fitDistance() });
        Object.assign(this.#now, this.#goal, { turn: this.#goal.turn + 0.5, distance: this.#goal.distance * 1.25 });
        this.camera.near = this.#radius / 50;
        this.camera.far = this.#radius * 60;
        this.floor.position.set(this.#target.x, box.min.y - this.#radius * 0.002, this.#target.z);
        this.floor.scale.setScalar(this.#radius * 30);
        this.sun.position.copy(this.#target).add(new Vector3(-0.55, 1.25, 0.85).multiplyScalar(this.#radius * 2.4));
        this.sun.target.position.copy(this.#target);
        const reach = this.#radius * 1.9, camera = this.sun.shadow.camera;
        Object.assign(camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: this.#radius * 0.2, far: this.#radius * 7 });
        camera.updateProjectionMatrix();
        this.sun.shadow.normalBias = this.#radius * 0.012;
    }

    #fitDistance() {
        const half = FIELD_OF_VIEW * Math.PI / 360, { width, height } = this.#free();
        const narrow = Math.min(1, width / height);
        return this.#radius * 1.06 / Math.sin(Math.atan(Math.tan(half) * narrow));
    }

    // What the panels leave free.
    #free() {
        return { width: Math.max(this.canvas.clientWidth - this.#insets.right, 1), height: Math.max(this.canvas.clientHeight - this.#insets.bottom, 1) };
    }

    /** The panels' room at the right and at the bottom, px: the object is shown beside them, before long. */
    setInsets(insets, now = false) {
        this.#insetsGoal = insets;
        if (now) this.#insets = { ...insets };
        this.resize();
    }

    /** Stands still where it is: what a hand holds must not move under it. */
    stop() {
        this.#goal = { ...this.#now };
    }

    resize() {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        if (width === 0 || height === 0) return;
        this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.#offset();
    }

    // Puts the middle of the picture into the middle of what the panels leave free.
    #offset() {
        const { clientWidth: width, clientHeight: height } = this.canvas, { right, bottom } = this.#insets;
        this.camera.setViewOffset(width, height, right / 2, bottom / 2, width, height);
        this.camera.updateProjectionMatrix();
    }

    orbit(dx, dy) {
        const speed = 2.6 / Math.min(this.canvas.clientWidth, this.canvas.clientHeight);
        this.#goal.turn -= dx * speed;
        this.#goal.tilt = Math.min(Math.max(this.#goal.tilt + dy * speed, -0.35), Math.PI / 2 - POLES);
    }

    zoom(factor) {
        this.#goal.distance = Math.min(Math.max(this.#goal.distance * factor, this.#radius * 1.2), this.#radius * 14);
    }

    /** Moves the camera on; true while it moves. held: a hand holds a part. */
    advance(dt, { still = false, held = false } = {}) {
        const share = still ? 1 : 1 - Math.exp(-EASE * dt);
        let moving = !held && this.#advanceInsets(share);
        for (const key of Object.keys(this.#now)) {
            const step = (this.#goal[key] - this.#now[key]) * share;
            this.#now[key] += step;
            moving ||= Math.abs(step) > 1e-5 * (key === 'distance' ? this.#radius : 1);
        }
        const { turn, tilt, distance } = this.#now, flat = Math.cos(tilt) * distance;
        this.camera.position.set(Math.sin(turn) * flat, Math.sin(tilt) * distance, Math.cos(turn) * flat).add(this.#target);
        this.camera.lookAt(this.#target);
        this.camera.updateMatrixWorld();
        return moving;
    }

    #advanceInsets(share) {
        let moving = false;
        for (const key of Object.keys(this.#insets)) {
            const step = (this.#insetsGoal[key] - this.#insets[key]) * share;
            if (Math.abs(step) < 0.05) continue;
            this.#insets[key] += step;
            moving = true;
        }
        if (moving) this.#offset();
        return moving;
    }

    render() {
        this.renderer.render(this.scene, this.camera);
    }

    /** The ray through a place of the page, px. */
    rayAt(x, y) {
        const bounds = this.canvas.getBoundingClientRect();
        const place = new Vector2((x - bounds.left) / bounds.width * 2 - 1, 1 - (y - bounds.top) / bounds.height * 2);
        this.#caster.setFromCamera(place, this.camera);
        return this.#caster.ray;
    }

    /** The first thing of a group at a place of the page: { mesh, face, point }, or null. */
    hit(x, y, group) {
        this.rayAt(x, y);
        const [first] = this.#caster.intersectObjects(group.children, false);
        return first ? { mesh: first.object, face: first.object.userData.faces[first.faceIndex], point: first.point } : null;
    }

    /** Where a point of the scene is on the page, px. */
    project(point) {
        const seen = point.clone().project(this.camera), bounds = this.canvas.getBoundingClientRect();
        return { x: bounds.left + (seen.x + 1) / 2 * bounds.width, y: bounds.top + (1 - seen.y) / 2 * bounds.height };
    }
}
