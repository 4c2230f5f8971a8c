// What the cooker says of a file that it has cooked, as docs/report.schema.json has it; docs/reference/report.md explains
// each field. Lengths are in the scene's units, metres in glTF. An array's place is an index where others refer to it.

export type Place = [number, number, number];  // x, y, z; or red, green, blue

export interface Section {
  type: string;
  bytes: number;
}

export interface Warning {
  pointer: string;  // JSON pointer into the source; of motion capture a line or part
  rule: string;     // the same word for the same matter
  text: string;     // one sentence
}

export interface SkeletonReport {
  name: string;
  joints: number;
  roles: { joints: number; pairs: number; soles: number; doubted: number };
}

export interface LevelReport {
  vertices: number;
  triangles: number;
  influences: number;
  bytes: number;
  rms_error_m: number;
  max_error_m: number;
}

interface Learnt {
  truth: string;
  poses: number;
  made_up_poses: number;
  held_out_share: number;  // RMS error in poses that were held out, over that of linear blend skinning
  worse_share: number;     // of those poses
}
export interface AnimationSpaceReport extends Learnt {
  kind: 'lift' | 'smooth' | 'fit';
  helpers: number;
}
export interface MultiWeightsReport extends Learnt {
  shipped: boolean;
  max_error_m: number;
}
export interface PoseSpaceReport extends MultiWeightsReport {
  examples: number;
}

export interface MeshReport {
  name: string;
  vertices: number;
  triangles: number;
  influences: number;
  joints: number;
  codec: 'draco' | 'meshopt' | 'none';
  bytes: number;  // geometry that meshes share counts at the first of them
  max_position_error_m: number;
  max_normal_error_deg: number;
  max_uv_error: number;
  max_weight_error: number;
  max_target_error_m: number;
  source_triangles?: number;
  split?: { part: number; parts: number; doubled_vertices: number };
  lods?: LevelReport[];
  animation_space?: AnimationSpaceReport;
  multi_weights?: MultiWeightsReport;
  pose_space?: PoseSpaceReport;
}

export interface ClipReport {
  name: string;
  skeleton: number;
  duration_s: number;
  codec: 'segments' | 'raw';
  raw_because: string | null;  // null: in segments, or nothing moves
  raw_bytes: number;
  bytes: number;
  memory_bytes: number;
  ratio: number | null;  // null: nothing moves
  additive: string | null;
  channels: string[];
  max_error_m: number;
  max_error_joint: string;
  max_error_time_s: number;
  max_vertex_error_m: number;
  bounds: { mesh: number; box_min: Place; box_max: Place; radius_m: number }[];
}

export interface MaterialReport {
  name: string;
  alpha: 'opaque' | 'mask' | 'blend';
  unlit?: boolean;
  emissive?: Place;
  textures: { role: string; image: number }[];
}

export interface ImageReport {
  name: string;
  uri: string;
  format: string;
  bytes: number;  // 0: by reference
  fallback?: number;
}

export interface Report {
  // Of several inputs alone: by which program, and how long.
  run?: { program: string; files: number; from_cache: boolean; seconds: number; cooking_s: number };
  source: { file: string; bytes: number };  // bytes: of all that was read
  output: { file: string; bytes: number; sections: Section[] };
  clip_pack: boolean;
  skeletons: SkeletonReport[];
  meshes: MeshReport[];
  clips: ClipReport[];
  materials: MaterialReport[];
  images: ImageReport[];
  nodes: { name: string; skeleton: number; joint: number | null; properties: number }[];
  keep: { glob: string; nodes: string[] }[];
  warnings: Warning[];
}
