// SPDX-License-Identifier: Apache-2.0
// The 3-D view of a report page (report_page.h): draws the meshes that stand in the page, with buttons and sliders.
// It is put into the page after three.js and the data; it loads nothing.
'use strict';

// Numbers stand in the page as their bytes, little endian as on every machine with a browser.
function Decode(base64, Type) {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    return new Type(bytes.buffer);
}

// One corner after another, with its position and colour; normals vary over a surface but not over its sharp edges.
function TriangleGeometry(positions, triangles, colors) {
    const n = triangles.length;
    const corners = new Float32Array(3 * n), normals = new Float32Array(3 * n);
    for (let i = 0; i < n; i++) {
        for (let k = 0; k < 3; k++) corners[3 * i + k] = positions[3 * triangles[i] + k];
    }
    // Triangles' normals, as long as twice the area, and their lengths.
    const facets = new Float64Array(n), lengths = new Float64Array(n / 3);
    for (let t = 0; t < n; t += 3) {
        for (let k = 0; k < 3; k++) {
            const a = 3 * t + (k + 1) % 3, b = 3 * t + (k + 2) % 3;
            facets[t + k] = (corners[a + 3] - corners[a]) * (corners[b + 6] - corners[b]) -
                            (corners[b + 3] - corners[b]) * (corners[a + 6] - corners[a]);
        }
        lengths[t / 3] = Math.hypot(facets[t], facets[t + 1], facets[t + 2]);
    }
    // The triangles around each vertex, as lists one after another.
    const starts = new Uint32Array(positions.length / 3 + 1), around = new Uint32Array(n);
    for (let i = 0; i < n; i++) starts[triangles[i] + 1]++;
    for (let v = 1; v < starts.length; v++) starts[v] += starts[v - 1];
    const next = starts.slice();
    for (let i = 0; i < n; i++) around[next[triangles[i]]++] = i - i % 3;
    const cos_crease = Math.cos(40 * Math.PI / 180);
    for (let i = 0; i < n; i++) {
        const own = i - i % 3;
        let x = 0, y = 0, z = 0;
        for (let j = starts[triangles[i]]; j < starts[triangles[i] + 1]; j++) {
            const f = around[j];
            const dot = facets[f] * facets[own] + facets[f + 1] * facets[own + 1] + facets[f + 2] * facets[own + 2];
            if (dot < cos_crease * lengths[f / 3] * lengths[own / 3]) continue;
            x += facets[f], y += facets[f + 1], z += facets[f + 2];
        }
        const length = Math.hypot(x, y, z) || 1;
        normals[3 * i] = x / length, normals[3 * i + 1] = y / length, normals[3 * i + 2] = z / length;
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(corners, 3));
    geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
    if (colors) {
        const bytes = new Uint8Array(3 * n);
        for (let i = 0; i < n; i++) {
            for (let k = 0; k < 3; k++) bytes[3 * i + k] = colors[3 * triangles[i] + k];
        }
        geometry.setAttribute('color', new THREE.BufferAttribute(bytes, 3, true));
    }
    return geometry;
}

// A line is a strip of two triangles, widened by the shader: WebGL's own lines are a pixel thin.
function LineGeometry(positions, lines) {
    const ends = new Float32Array(3 * lines.length);
    for (let i = 0; i < lines.length; i++) {
        for (let k = 0; k < 3; k++) ends[3 * i + k] = positions[3 * lines[i] + k];
    }
    const geometry = new THREE.InstancedBufferGeometry();
    const corners = new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]);  // x along, y across
    geometry.setAttribute('position', new THREE.BufferAttribute(corners, 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const starts = ends.filter((_, i) => i % 6 < 3), stops = ends.filter((_, i) => i % 6 >= 3);
    geometry.setAttribute('start', new THREE.InstancedBufferAttribute(starts, 3));
    geometry.setAttribute('stop', new THREE.InstancedBufferAttribute(stops, 3));
    geometry.instanceCount = lines.length / 2;
    return geometry;
}

// What both kinds of shader do: cut by a plane, and thin out by a pattern of pixels. Two surfaces that share the pixels
// between them fade into each other without any order of drawing.
const kDiscard = `
    precision highp float;
    uniform vec4 plane;
    uniform vec2 pixels;
    void Discard(vec3 place) {
        float pattern = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715))));
        if (dot(plane.xyz, place) > plane.w || pattern < pixels.x || pattern >= pixels.y) discard;
    }`;

const kSurfaceVertex = `
    uniform mat4 modelViewMatrix, projectionMatrix;
    uniform bool is_valued;
    uniform vec3 plain;
    in vec3 position, normal, color;
    out vec3 place, eye, turned, tint;
    void main() {
        vec4 seen = modelViewMatrix * vec4(position, 1);
        place = position;
        eye = -seen.xyz;
        turned = mat3(modelViewMatrix) * normal;
        tint = is_valued ? color : plain;
        gl_Position = projectionMatrix * seen;
    }`;
const kSurfaceFragment = kDiscard + `
    in vec3 place, eye, turned, tint;
    out vec4 pixel;
    void main() {
        Discard(place);
        vec3 n = normalize(turned), e = normalize(eye);
        if (dot(n, e) < 0.) n = -n;
        vec3 light = normalize(vec3(-0.35, 0.6, 1)), half_way = normalize(light + e);
        float lit = 0.5 + 0.15 * n.y + 0.5 * max(dot(n, light), 0.);
        vec3 seen = pow(tint, vec3(2.2)) * lit + 0.06 * pow(max(dot(n, half_way), 0.), 30.);
        if (!gl_FrontFacing && plane.w < 2.) seen *= 0.45;  // the inside, where it is cut open
        pixel = vec4(pow(seen, vec3(1. / 2.2)), 1);
    }`;
const kLineVertex = `
    uniform mat4 modelViewMatrix, projectionMatrix;
    uniform vec2 half_size;
    uniform float half_width;
    in vec3 position, start, stop;
    out vec3 place;
    void main() {
        vec4 a = projectionMatrix * modelViewMatrix * vec4(start, 1);
        vec4 b = projectionMatrix * modelViewMatrix * vec4(stop, 1);
        const float near = 0.001;  // what lies behind the eye is cut off: it has no place on the screen
        if (a.w < near) a = mix(a, b, (near - a.w) / (b.w - a.w));
        if (b.w < near) b = mix(b, a, (near - b.w) / (a.w - b.w));
        vec2 along = (b.xy / b.w - a.xy / a.w) * half_size;
        vec2 across = normalize(vec2(-along.y, along.x) + vec2(1e-9, 0));
        gl_Position = mix(a, b, position.x);
        gl_Position.xy += across * position.y * half_width / half_size * gl_Position.w;
        place = mix(start, stop, position.x);
    }`;
const kLineFragment = kDiscard + `
    uniform vec3 plain;
    in vec3 place;
    out vec4 pixel;
    void main() {
        Discard(place);
        pixel = vec4(plain, 1);
    }`;

// Values on a colour map's 256 steps; what is not a number is grey.
function Colors(values, mesh, map) {
    const colors = new Uint8Array(3 * values.length), scale = mesh.high > mesh.low ? 255 / (mesh.high - mesh.low) : 0;
    values.forEach((value, i) => {
        const step = Math.round(Math.min(Math.max((value - mesh.low) * scale, 0), 255));
        colors.set(Number.isFinite(value) ? map.subarray(3 * step, 3 * step + 3) : [128, 128, 128], 3 * i);
    });
    return colors;
}

class View {
    constructor(report, figure) {
        this.report = report;
        this.figure = figure;
        this.canvas = figure.querySelector('canvas');
        this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: true, alpha: true});
        this.renderer.debug.onShaderError = (gl, program, vertex, fragment) => {
            throw new Error('shader: ' + gl.getShaderInfoLog(vertex) + gl.getShaderInfoLog(fragment));
        };
        this.shared = {plane: {value: [0, 0, 0, 2]}, half_size: {value: [1, 1]}, half_width: {value: 1}};
        this.scene = new THREE.Scene();
        this.meshes = report.meshes.map((mesh) => this.Add(mesh));
        this.camera = new THREE.PerspectiveCamera(report.field_of_view, 1, 0.01, 100);
        this.controls = new THREE.OrbitControls(this.camera, this.canvas);
        this.MakeTools();
        this.Reset();
        this.controls.saveState();
        this.controls.addEventListener('change', () => this.Redraw());
        new ResizeObserver(() => this.Draw()).observe(this.canvas);  // before the page is painted: never stretched
        this.UseKeysAndWheel();
        this.Draw();
    }

    Add(mesh) {
        const positions = Decode(mesh.positions, Float32Array);
        const objects = [], pixels = {value: [0, 1]}, is_valued = {value: mesh.values.length > 0};
        const plain = {value: mesh.color};
        const put = (geometry, vertexShader, fragmentShader) => {
            const material = new THREE.RawShaderMaterial({
                vertexShader, fragmentShader, glslVersion: THREE.GLSL3, side: THREE.DoubleSide,
                uniforms: {...this.shared, pixels, is_valued, plain}
            });
            const object = new THREE.Mesh(geometry, material);
            object.frustumCulled = false;
            this.scene.add(object);
            objects.push(object);
        };
        const triangles = Decode(mesh.triangles, Uint32Array), lines = Decode(mesh.lines, Uint32Array);
        if (triangles.length > 0) {
            const map = is_valued.value && Decode(this.report.maps[mesh.map], Uint8Array);
            const colors = map && Colors(Decode(mesh.values, Float32Array), mesh, map);
            put(TriangleGeometry(positions, triangles, colors), kSurfaceVertex, kSurfaceFragment);
        }
        if (lines.length > 0) put(LineGeometry(positions, lines), kLineVertex, kLineFragment);
        return {...mesh, objects, pixels, is_valued, is_surface: triangles.length > 0};
    }

    Show(mesh, is_shown) {
        for (const object of mesh.objects) object.visible = is_shown;
        mesh.button.setAttribute('aria-pressed', is_shown);
        const is_coloured = (m) => m.values.length > 0 && m.is_valued.value && m.objects[0].visible;
        for (const m of this.meshes) if (m.legend) m.legend.hidden = !is_coloured(m);
        this.Redraw();
    }

    MakeTools() {
        const find = (name) => this.figure.querySelector(name);
        const buttons = find('.buttons'), sliders = find('.sliders'), legends = find('.legends');
        const make = (parent, kind, text = '') => {
            const element = document.createElement(kind);
            element.textContent = text;
            return parent.appendChild(element);
        };
        const slider = (parent, text, action) => {
            const label = make(parent, 'label', text), input = make(label, 'input');
            Object.assign(input, {type: 'range', min: 0, max: 1, step: 0.01, value: 1});
            input.addEventListener('input', () => {action(Number(input.value)); this.Redraw();});
            return input;
        };
        for (const mesh of this.meshes) {
            mesh.button = make(buttons, 'button', mesh.name);
            mesh.button.style.setProperty('--mark', 'rgb(' + mesh.color.map((x) => 255 * x) + ')');
            mesh.button.classList.add('mesh');
            mesh.button.addEventListener('click', () => {
                if (mesh.is_surface) for (const other of this.meshes) other.pixels.value = [0, 1];  // no longer faded
                this.Show(mesh, !mesh.objects[0].visible);
            });
            if (mesh.values.length > 0) this.MakeLegend(mesh, legends, make);
        }
        const surfaces = this.meshes.filter((mesh) => mesh.is_surface);
        if (this.meshes.some((mesh) => mesh.values.length > 0)) {
            const colours = make(buttons, 'button', 'Colours');
            colours.setAttribute('aria-pressed', true);
            colours.addEventListener('click', () => {
                const is_on = colours.getAttribute('aria-pressed') !== 'true';
                colours.setAttribute('aria-pressed', is_on);
                for (const mesh of this.meshes) {
                    mesh.is_valued.value = is_on && mesh.values.length > 0;
                    this.Show(mesh, mesh.objects[0].visible);
                }
            });
        }
        // Half-way both are there, each on half of the pixels.
        if (surfaces.length > 1) {
            const [from, to] = surfaces;
            const fade = (share) => {
                from.pixels.value = [share, 1];
                to.pixels.value = [0, share];
                for (const mesh of [from, to]) this.Show(mesh, mesh.pixels.value[0] < mesh.pixels.value[1]);
            };
            this.fade = slider(sliders, from.name + ' to ' + to.name, fade);
            this.fade.value = this.fade_at_start = from.is_shown ? (to.is_shown ? 0.5 : 0) : 1;
        }
        const cutter = make(sliders, 'div'), axis = make(make(cutter, 'label', 'Cut along'), 'select');
        ['x', 'y', 'z'].forEach((name) => make(axis, 'option', name));
        const cut = (share) => {
            const plane = [0, 0, 0, 2];
            plane[axis.selectedIndex] = 1;
            if (share < 1) plane[3] = this.report.half_sizes[axis.selectedIndex] * (2 * share - 1);
            this.shared.plane.value = plane;
        };
        this.cut = slider(cutter, '', cut);
        this.cut.setAttribute('aria-label', 'Place of the cut');
        axis.addEventListener('change', () => {cut(Number(this.cut.value)); this.Redraw();});
        make(buttons, 'button', 'Reset view').addEventListener('click', () => {this.controls.reset(); this.Reset();});
    }

    MakeLegend(mesh, legends, make) {
        mesh.legend = make(legends, 'div');
        const map = Decode(this.report.maps[mesh.map], Uint8Array), stops = [];
        for (let i = 0; i < 256; i += 15) stops.push('rgb(' + map.subarray(3 * i, 3 * i + 3) + ')');
        make(mesh.legend, 'span', mesh.name + ': ' + mesh.value_name);
        make(mesh.legend, 'i').style.background = 'linear-gradient(to right,' + stops + ')';
        const text = (value) => Number(value.toPrecision(3)) + (mesh.unit && ' ' + mesh.unit);
        make(mesh.legend, 'b', text(mesh.low));
        make(mesh.legend, 'b', text(mesh.high));
    }

    // As at the start: everything in the frame, from the report's direction.
    Reset() {
        for (const mesh of this.meshes) {
            mesh.pixels.value = [0, 1];
            this.Show(mesh, mesh.is_shown);
        }
        if (this.fade) this.fade.value = this.fade_at_start;
        this.cut.value = 1;
        this.shared.plane.value = [0, 0, 0, 2];
        this.camera.up.set(...this.report.up);
        this.camera.position.set(...this.report.direction).multiplyScalar(this.Distance());
        this.controls.target.set(0, 0, 0);
        this.controls.update();
        this.Redraw();
    }

    // From the middle, so that the box around everything is in the frame.
    Distance() {
        const back = new THREE.Vector3(...this.report.direction);
        const right = new THREE.Vector3(...this.report.up).cross(back).normalize(), up = back.clone().cross(right);
        const tan_y = Math.tan(this.report.field_of_view * Math.PI / 360) / 1.08;
        const tan_x = tan_y * this.canvas.clientWidth / this.canvas.clientHeight;
        const sizes = this.report.half_sizes;
        let distance = 0;
        for (let corner = 0; corner < 8; corner++) {
            const p = new THREE.Vector3(...sizes.map((size, k) => corner >> k & 1 ? size : -size));
            const aside = Math.max(Math.abs(p.dot(right)) / tan_x, Math.abs(p.dot(up)) / tan_y);
            distance = Math.max(distance, p.dot(back) + aside);
        }
        return distance;
    }

    UseKeysAndWheel() {
        const step = Math.PI / 24, controls = this.controls;
        const keys = {
            ArrowLeft: () => controls.rotateLeft(step), ArrowRight: () => controls.rotateLeft(-step),
            ArrowUp: () => controls.rotateUp(step), ArrowDown: () => controls.rotateUp(-step),
            '+': () => controls.dollyIn(0.9), '-': () => controls.dollyOut(0.9)
        };
        const moves = {
            ArrowLeft: () => controls.pan(20, 0), ArrowRight: () => controls.pan(-20, 0),
            ArrowUp: () => controls.pan(0, 20), ArrowDown: () => controls.pan(0, -20)
        };
        this.canvas.addEventListener('keydown', (event) => {
            const action = (event.shiftKey && moves[event.key]) || keys[event.key];
            if (!action) return;
            event.preventDefault();
            action();
            controls.update();
        });
        // The wheel scrolls the page until the view was clicked.
        controls.enableZoom = false;
        this.canvas.addEventListener('pointerdown', () => this.canvas.focus({preventScroll: true}), true);
        this.canvas.addEventListener('focus', () => {controls.enableZoom = true;});
        this.canvas.addEventListener('blur', () => {controls.enableZoom = false;});
    }

    Redraw() {
        if (!this.frame) this.frame = requestAnimationFrame(() => {this.frame = 0; this.Draw();});
    }

    Draw() {
        const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
        const ratio = Math.min(window.devicePixelRatio, 2);
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height, false);
        this.shared.half_size.value = [width / 2, height / 2];
        this.shared.half_width.value = Math.max(0.8, Math.min(width, height) / 700);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        this.renderer.render(this.scene, this.camera);
        const {triangles} = this.renderer.info.render;  // for tests
        Object.assign(document.documentElement.dataset, {view: 'drawn', triangles});
    }

    // For tests: draws, and says which share of the pixels is covered.
    Covered() {
        this.Draw();
        const gl = this.renderer.getContext(), n = gl.drawingBufferWidth * gl.drawingBufferHeight;
        const bytes = new Uint8Array(4 * n);
        gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        let covered = 0;
        for (let i = 3; i < bytes.length; i += 4) covered += bytes[i] > 0;
        return covered / n;
    }
}

// The page's words for a missing view stay where anything below fails.
window.addEventListener('error', (event) => {
    document.documentElement.dataset.error = event.message;
    document.documentElement.classList.remove('has-view');
});
if (document.createElement('canvas').getContext('webgl2')) {
    document.documentElement.classList.add('has-view');
    const report = JSON.parse(document.getElementById('report-data').textContent);
    window.report_view = new View(report, document.getElementById('view'));
} else {
    document.documentElement.dataset.view = 'none';
}
