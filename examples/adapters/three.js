import * as THREE from "three";
import { ThreeView } from "thud/three";
import { HEIGHT, makeScene, run, SCALE, WIDTH } from "./scene.js";

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(WIDTH, HEIGHT);
renderer.setClearColor("white");
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(60, WIDTH / HEIGHT);
// From here the plane z = 0 is seen at SCALE pixels a metre.
camera.position.z = HEIGHT / 2 / SCALE / Math.tan(Math.PI / 6);
const { world, ball, things } = await makeScene();
const view = new ThreeView(world, scene);
for (const { body, size, round, colour } of things) {
  const geometry = round ? new THREE.CircleGeometry(size / 2, 32) : new THREE.PlaneGeometry(size, size);
  view.add(body, new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color: colour })));
}
view.drag(renderer.domElement, camera);
const lines = new THREE.LineBasicMaterial({ vertexColors: true, depthTest: false });
const seen = new THREE.LineSegments(new THREE.BufferGeometry(), lines);
[seen.frustumCulled, seen.renderOrder] = [false, 1]; // above the bodies, which are in the same plane
scene.add(seen);

run({
  world,
  ball,
  canvas: renderer.domElement,
  picture(seconds) {
    const { alpha } = world.advance(seconds);
    view.update(alpha);
    if (location.search === "?debug") {
      const { positions, colours } = view.debug({ shapes: true, contacts: true, lower: [-8, -6], upper: [8, 6] });
      seen.geometry.dispose();
      seen.geometry = new THREE.BufferGeometry()
        .setAttribute("position", new THREE.Float32BufferAttribute(positions, 3))
        .setAttribute("color", new THREE.Float32BufferAttribute(colours, 3));
    }
    renderer.render(scene, camera);
    return alpha;
  },
});
