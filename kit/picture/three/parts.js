// SPDX-License-Identifier: Apache-2.0
// What the report page's view takes from three.js; make_bundle.sh makes one file of it.
export {
    BufferAttribute,
    BufferGeometry,
    DoubleSide,
    GLSL3,
    InstancedBufferAttribute,
    InstancedBufferGeometry,
    Mesh,
    PerspectiveCamera,
    RawShaderMaterial,
    Scene,
    Vector3,
    WebGLRenderer,
} from 'three/src/Three.js';
export { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
