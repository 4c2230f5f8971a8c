// A character on the CPU: a cooked file is unpacked, loaded, posed and skinned. One thread at a time.
import MarrowKit

final class Puppet {
  let animations = UnsafeMutablePointer<mrw_animations>.allocate(capacity: 1)
  let character = UnsafeMutablePointer<mrw_character>.allocate(capacity: 1)
  private let file = UnsafeMutablePointer<mrw_file>.allocate(capacity: 1)
  private var blocks: [Block] = []  // what all of that lies in
  private var playback = mrw_playback()
  private var clip: UnsafePointer<mrw_animation>?

  /// name: for messages. decoders: of the codecs that the library was built with; none for `--mesh-codec none`.
  init(_ bytes: UnsafeRawBufferPointer, name: String, decoders: [mrw_mesh_decoder] = []) throws {
    try checkRelease()
    mrw_playback_init(&playback)
    let source = keep(Block(copy: bytes))
    var cooked = mrw_bytes(data: UnsafeRawPointer(source.memory), size: source.count)
    var error = mrw_data_error()
    if mrw_is_packed(cooked.data, cooked.size) {
      var sizes = mrw_unpack_sizes()
      try check(mrw_find_unpack_sizes(cooked.data, cooked.size, &sizes, &error), name, error)
      let memory = keep(Block(Int(sizes.memory_bytes)))
      try check(
        mrw_unpack(source.memory, source.count, decoders, decoders.count, memory.memory, memory.count, &cooked, &error),
        "\(name), packed", error)
    }
    try check(mrw_load(cooked.data, cooked.size, file, &error), name, error)
    var memory = keep(Block(mrw_animations_bytes(file, file)))
    try check(mrw_make_animations(file, file, memory.memory, memory.count, animations), name)
    memory = keep(Block(mrw_character_bytes(file, nil)))  // nil: options as they are by default
    try check(mrw_make_character(file, nil, memory.memory, memory.count, character), name)
  }

  deinit {
    animations.deallocate()
    character.deallocate()
    file.deallocate()
  }

  private func keep(_ block: Block) -> Block {
    blocks.append(block)
    return block
  }

  var meshCount: Int { character.pointee.mesh_count }

  func geometry(_ mesh: Int) -> mrw_geometry { character.pointee.meshes[mesh].mesh.geometry }

  func play(_ name: String) throws {
    clip = mrw_find_animation(animations, name)
    if clip == nil { throw MarrowError(status: mrw_status(MRW_MISMATCH), what: "no clip \"\(name)\"") }
    mrw_playback_init(&playback)
  }

  /// A frame: time goes on, joints move. Allocates nothing.
  func advance(_ seconds: Float) throws {
    guard let clip = clip else { return }
    try check(mrw_advance(&playback, clip.pointee.duration_s, seconds), "advance")
    var layer = mrw_animation_layer()
    mrw_animation_layer_init(&layer)
    layer.animation = clip
    layer.time_s = mrw_clip_time(&playback)
    try check(mrw_pose_character(character, &layer, 1), "pose")
    // Here the game reaches, looks, places feet.
    try check(mrw_finish_character(character), "finish")
  }

  /// Vertices of a mesh: 3 floats a slot of positions in metres, y up, and of normals, if it has any.
  func skin(_ mesh: Int, positions: UnsafeMutablePointer<Float>, normals: UnsafeMutablePointer<Float>?) throws {
    let it = character.pointee.meshes + mesh
    var out = mrw_skin_output()
    mrw_skin_output_init(&out)
    out.position_count = 3 * Int(it.pointee.mesh.geometry.slot_count)
    out.positions = positions
    if it.pointee.mesh.geometry.normals != nil, let normals = normals {
      out.normal_count = out.position_count
      out.normals = normals
    }
    try withUnsafePointer(to: &it.pointee.mesh) {
      try check(mrw_skin_ssd($0, it.pointee.palette, it.pointee.palette_count, &out), "skin")
    }
  }
}
