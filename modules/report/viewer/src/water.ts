// SPDX-License-Identifier: GPL-3.0-or-later
// The water: a tinted surface with lines on it, shadows, colours that fade with depth, and a bed if it is shallow.
import {
  BufferGeometry, type Color, DoubleSide, Group, LineBasicMaterial, LineSegments, type Material, Mesh, MeshBasicMaterial,
  PlaneGeometry, ShadowMaterial, Vector3,
} from "three";

/** Lines across and along the surface on either side of the structure. */
const kLines = 40;

/** Depth of the floor, in sizes of the scene. */
export const kFloor = 5;

/** A length of 1, 2 or 5 times a power of ten near another. */
const roundLength = (length: number): number => {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * ([5, 2, 1].find((digit) => digit * power <= length) ?? 1);
};

export class Water {
  readonly group = new Group();
  /** Distance of the lines on the surface [m]. */
  readonly spacing: number;
  private readonly surface = new MeshBasicMaterial({ transparent: true, opacity: 0.42, side: DoubleSide, depthWrite: false });
  private readonly deep = new MeshBasicMaterial({});
  private readonly shadow = new ShadowMaterial({ opacity: 0.28, depthWrite: false });
  private readonly lines: LineSegments;
  private readonly lineMaterial = new LineBasicMaterial({ transparent: true, opacity: 0.5, depthWrite: false });

  /**
   * @param size  of the scene [m].
   * @param depth  of the bed [m]; NaN of deep water.
   */
  constructor(
    private readonly size: number,
    private readonly depth: number,
  ) {
    this.spacing = roundLength(0.8 * size);
    const extent = 180 * size;
    const floor = new Mesh(new PlaneGeometry(extent, extent), this.deep);
    floor.position.z = -(depth > 0 ? depth : kFloor * size);
    const top = new Mesh(new PlaneGeometry(extent, extent), this.surface);
    const shaded = new Mesh(new PlaneGeometry(20 * size, 20 * size), this.shadow);
    shaded.receiveShadow = true;
    this.lines = new LineSegments(this.grid(), this.lineMaterial);
    for (const part of [top, shaded, this.lines]) part.renderOrder = 2;
    // Lines lie in the surface, and are drawn over it.
    this.lines.renderOrder = 2.5;
    this.group.add(floor, top, shaded, this.lines);
  }

  setTheme(palette: Record<string, Color>): void {
    this.surface.color = palette.water;
    this.deep.color = this.depth > 0 ? palette.land : palette.deep;
    this.lineMaterial.color = palette.ripple;
    this.fade.deep.value = palette.deep;
  }

  /** Keeps lines and shadows about a place; the lines stay where they are on the water. */
  follow(x: number, y: number): void {
    this.lines.position.set(this.spacing * Math.round(x / this.spacing), this.spacing * Math.round(y / this.spacing), 0);
    this.group.children[2].position.set(x, y, 0);
  }

  private readonly fade = { deep: { value: null as Color | null } };

  /** Makes the colours of a lit material change into the colours of the deep below the surface. */
  fades(material: Material): void {
    material.onBeforeCompile = (shader) => {
      shader.uniforms.deepColour = this.fade.deep;
      shader.uniforms.clearDepth = { value: 0.9 * this.size };
      shader.vertexShader = shader.vertexShader
        .replace("void main() {", "varying float vHeight;\nvoid main() {")
        .replace("#include <project_vertex>", "#include <project_vertex>\nvHeight = (modelMatrix * vec4(transformed, 1.0)).z;");
      shader.fragmentShader = shader.fragmentShader
        .replace("void main() {", "varying float vHeight;\nuniform vec3 deepColour;\nuniform float clearDepth;\nvoid main() {")
        .replace("#include <opaque_fragment>", "outgoingLight = mix(outgoingLight, deepColour, 0.7 * (1.0 - exp(min(vHeight, 0.0) / clearDepth)));\n#include <opaque_fragment>");
    };
  }

  private grid(): BufferGeometry {
    const reach = kLines * this.spacing;
    const ends: Vector3[] = [];
    for (let i = -kLines; i <= kLines; ++i) {
      const at = i * this.spacing;
      ends.push(new Vector3(-reach, at, 0), new Vector3(reach, at, 0), new Vector3(at, -reach, 0), new Vector3(at, reach, 0));
    }
    return new BufferGeometry().setFromPoints(ends);
  }
}
