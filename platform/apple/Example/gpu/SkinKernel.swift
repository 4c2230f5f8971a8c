// Marrow's compute shader in Metal's language: tools/check/spirv.sh writes it. docs/other_apis.md says what is in the
// buffers, and has the C++ that makes them; call that from an Objective-C++ file.
import Foundation
import MetalKit

struct SkinKernel {
  let pipeline: MTLComputePipelineState

  /// text: of compute-ubo-ssd-4-pn.comp.metal, or of what else fits the mesh.
  init(_ device: MTLDevice, text: String) throws {
    let library = try device.makeLibrary(source: text, options: nil)
    pipeline = try device.makeComputePipelineState(function: library.makeFunction(name: "main0")!)
  }

  /// streams: bindings 0 to 2, bound to anything where the kernel has none. out: positions of all slots, then normals,
  /// then tangents.
  /// palette: 341 matrices of 48 bytes. uniforms: MarrowUniforms.
  func encode(
    _ commands: MTLCommandBuffer, slots: Int, streams: [MTLBuffer], out: MTLBuffer, palette: MTLBuffer,
    uniforms: MTLBuffer
  ) {
    guard let encoder = commands.makeComputeCommandEncoder() else { return }
    encoder.setComputePipelineState(pipeline)
    for (binding, buffer) in (streams + [out, palette, uniforms]).enumerated() {
      encoder.setBuffer(buffer, offset: 0, index: binding)
    }
    let groups = MTLSize(width: (slots + 63) / 64, height: 1, depth: 1)
    encoder.dispatchThreadgroups(groups, threadsPerThreadgroup: MTLSize(width: 64, height: 1, depth: 1))
    encoder.endEncoding()
  }
}
