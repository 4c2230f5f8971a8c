// The newt walks: Marrow skins on the CPU, straight into Metal's buffers, and Metal draws. SwiftUI, iOS 14.
import MarrowKit
import MetalKit
import SwiftUI

@main
struct NewtApp: App {
  var body: some Scene { WindowGroup { NewtView().ignoresSafeArea() } }
}

struct NewtView: UIViewRepresentable {
  func makeCoordinator() -> Renderer { Renderer(file: "newt.mrw", clip: "walk") }

  func makeUIView(context: Context) -> MTKView {
    let view = MTKView(frame: .zero, device: context.coordinator.device)
    view.colorPixelFormat = .bgra8Unorm_srgb
    view.depthStencilPixelFormat = .depth32Float
    view.clearColor = MTLClearColor(red: 0.2, green: 0.25, blue: 0.3, alpha: 1)
    view.delegate = context.coordinator
    return view
  }

  func updateUIView(_ view: MTKView, context: Context) {}
}

/// What Metal has of a mesh. vertices: for each frame in flight the positions of all slots, then their normals.
struct DrawnMesh {
  let slots: Int
  let vertices: MTLBuffer
  let indices: MTLBuffer
  let indexCount: Int
  let indexType: MTLIndexType
  var colour: SIMD4<Float>

  init(_ device: MTLDevice, _ mesh: mrw_mesh) {
    let geometry = mesh.geometry
    slots = Int(geometry.slot_count)
    vertices = device.makeBuffer(length: Renderer.framesInFlight * 24 * slots, options: .storageModeShared)!
    indexCount = Int(geometry.index_count)
    indexType = geometry.index_bytes == 2 ? .uint16 : .uint32
    let bytes = indexCount * Int(geometry.index_bytes)
    indices = device.makeBuffer(bytes: geometry.indices, length: bytes, options: .storageModeShared)!
    let c = mesh.base_colour
    colour = SIMD4(c.0, c.1, c.2, c.3)
  }
}

final class Renderer: NSObject, MTKViewDelegate {
  static let framesInFlight = 3
  let device = MTLCreateSystemDefaultDevice()!
  private lazy var queue = device.makeCommandQueue()!
  private let free = DispatchSemaphore(value: framesInFlight)
  private var puppet: Puppet?
  private var meshes: [DrawnMesh] = []
  private var pipeline: MTLRenderPipelineState?
  private var depth: MTLDepthStencilState?
  private var centre = SIMD4<Float>(), height: Float = 1
  private var frame = 0

  init(file: String, clip: String) {
    super.init()
    do {
      guard let url = Bundle.main.url(forResource: file, withExtension: nil) else {
        throw MarrowError(status: mrw_status(MRW_BAD_ARGUMENT), what: "\(file) is not in the app: add it to its target")
      }
      let puppet = try Data(contentsOf: url).withUnsafeBytes { try Puppet($0, name: file) }
      try puppet.play(clip)
      meshes = (0..<puppet.meshCount).map { DrawnMesh(device, puppet.character.pointee.meshes[$0].mesh) }
      let low = puppet.geometry(0).box_min, high = puppet.geometry(0).box_max
      centre = SIMD4(low.0 + high.0, low.1 + high.1, low.2 + high.2, 0) / 2
      height = 1.3 * (high.1 - low.1)
      try makePipeline()
      self.puppet = puppet
    } catch {
      print("NewtApp: \(error)")
    }
  }

  private func makePipeline() throws {
    let library = try device.makeLibrary(source: shaders, options: nil)
    let wanted = MTLRenderPipelineDescriptor()
    wanted.vertexFunction = library.makeFunction(name: "place")
    wanted.fragmentFunction = library.makeFunction(name: "shade")
    wanted.colorAttachments[0].pixelFormat = .bgra8Unorm_srgb
    wanted.depthAttachmentPixelFormat = .depth32Float
    pipeline = try device.makeRenderPipelineState(descriptor: wanted)
    let test = MTLDepthStencilDescriptor()
    test.depthCompareFunction = .less
    test.isDepthWriteEnabled = true
    depth = device.makeDepthStencilState(descriptor: test)
  }

  func mtkView(_ view: MTKView, drawableSizeWillChange size: CGSize) {}

  func draw(in view: MTKView) {
    guard let puppet = puppet, let pipeline = pipeline, let pass = view.currentRenderPassDescriptor,
      let drawable = view.currentDrawable, let commands = queue.makeCommandBuffer(),
      let encoder = commands.makeRenderCommandEncoder(descriptor: pass)
    else { return }
    free.wait()
    commands.addCompletedHandler { [free] _ in free.signal() }
    frame = (frame + 1) % Renderer.framesInFlight
    encoder.setRenderPipelineState(pipeline)
    encoder.setDepthStencilState(depth)
    encoder.setFrontFacing(.counterClockwise)
    encoder.setCullMode(.back)
    let aspect = Float(view.drawableSize.height / max(view.drawableSize.width, 1))
    var camera = [centre, SIMD4(2 * aspect, 2, 1, 0) / height]
    encoder.setVertexBytes(&camera, length: 32, index: 2)
    do {
      try puppet.advance(1 / Float(view.preferredFramesPerSecond))
      for (index, mesh) in meshes.enumerated() {
        let begin = frame * 24 * mesh.slots
        let floats = (mesh.vertices.contents() + begin).assumingMemoryBound(to: Float.self)
        try puppet.skin(index, positions: floats, normals: floats + 3 * mesh.slots)
        var colour = mesh.colour
        encoder.setVertexBuffer(mesh.vertices, offset: begin, index: 0)
        encoder.setVertexBuffer(mesh.vertices, offset: begin + 12 * mesh.slots, index: 1)
        encoder.setFragmentBytes(&colour, length: 16, index: 0)
        encoder.drawIndexedPrimitives(
          type: .triangle, indexCount: mesh.indexCount, indexType: mesh.indexType, indexBuffer: mesh.indices,
          indexBufferOffset: 0)
      }
    } catch {
      print("NewtApp: \(error)")
      self.puppet = nil
    }
    encoder.endEncoding()
    commands.present(drawable)
    commands.commit()
  }

  /// From the front, without perspective: y is up, the character looks along z.
  private let shaders = """
    #include <metal_stdlib>
    using namespace metal;
    struct Place { float4 position [[position]]; float3 normal; };
    vertex Place place(uint slot [[vertex_id]], device const packed_float3* positions [[buffer(0)]],
                       device const packed_float3* normals [[buffer(1)]], constant float4* camera [[buffer(2)]]) {
      float3 at = (float3(positions[slot]) - camera[0].xyz) * camera[1].xyz;
      return {float4(at.xy, 0.5 - 0.25 * at.z, 1), float3(normals[slot])};
    }
    fragment float4 shade(Place it [[stage_in]], constant float4& colour [[buffer(0)]]) {
      float light = 0.35 + 0.65 * saturate(dot(normalize(it.normal), normalize(float3(0.3, 0.6, 0.7))));
      return float4(colour.rgb * light, 1);
    }
    """
}
