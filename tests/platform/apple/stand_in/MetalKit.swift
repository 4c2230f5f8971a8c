// What platform/apple/Example uses of Apple's Metal and MetalKit, declared by hand: see SwiftUI.swift.
@_exported import Foundation

public struct MTLClearColor {
  public init(red: Double, green: Double, blue: Double, alpha: Double) {}
}
public enum MTLPixelFormat { case bgra8Unorm_srgb, depth32Float }
public enum MTLIndexType { case uint16, uint32 }
public enum MTLPrimitiveType { case triangle }
public enum MTLWinding { case counterClockwise }
public enum MTLCullMode { case back }
public enum MTLCompareFunction { case less }
public struct MTLResourceOptions: OptionSet {
  public let rawValue: UInt
  public init(rawValue: UInt) { self.rawValue = rawValue }
  public static let storageModeShared = MTLResourceOptions([])
}

public protocol MTLDrawable {}
public protocol CAMetalDrawable: MTLDrawable {}
public protocol MTLFunction {}
public protocol MTLComputePipelineState {}
public struct MTLSize {
  public init(width: Int, height: Int, depth: Int) {}
}
public protocol MTLRenderPipelineState {}
public protocol MTLDepthStencilState {}
public final class MTLCompileOptions {}
public final class MTLRenderPassDescriptor {}

public protocol MTLBuffer {
  func contents() -> UnsafeMutableRawPointer
}
public protocol MTLLibrary {
  func makeFunction(name: String) -> MTLFunction?
}
public final class MTLRenderPipelineColorAttachmentDescriptor {
  public var pixelFormat = MTLPixelFormat.bgra8Unorm_srgb
}
public final class MTLRenderPipelineColorAttachmentDescriptorArray {
  public subscript(index: Int) -> MTLRenderPipelineColorAttachmentDescriptor! { nil }
}
public final class MTLRenderPipelineDescriptor {
  public init() {}
  public var vertexFunction: MTLFunction?
  public var fragmentFunction: MTLFunction?
  public let colorAttachments: MTLRenderPipelineColorAttachmentDescriptorArray! = nil
  public var depthAttachmentPixelFormat = MTLPixelFormat.depth32Float
}
public final class MTLDepthStencilDescriptor {
  public init() {}
  public var depthCompareFunction = MTLCompareFunction.less
  public var isDepthWriteEnabled = false
}

public protocol MTLDevice {
  func makeBuffer(length: Int, options: MTLResourceOptions) -> MTLBuffer?
  func makeBuffer(bytes: UnsafeRawPointer, length: Int, options: MTLResourceOptions) -> MTLBuffer?
  func makeCommandQueue() -> MTLCommandQueue?
  func makeLibrary(source: String, options: MTLCompileOptions?) throws -> MTLLibrary
  func makeRenderPipelineState(descriptor: MTLRenderPipelineDescriptor) throws -> MTLRenderPipelineState
  func makeComputePipelineState(function: MTLFunction) throws -> MTLComputePipelineState
  func makeDepthStencilState(descriptor: MTLDepthStencilDescriptor) -> MTLDepthStencilState?
}
public func MTLCreateSystemDefaultDevice() -> MTLDevice? { nil }

public protocol MTLCommandQueue {
  func makeCommandBuffer() -> MTLCommandBuffer?
}
public protocol MTLCommandBuffer {
  func makeRenderCommandEncoder(descriptor: MTLRenderPassDescriptor) -> MTLRenderCommandEncoder?
  func makeComputeCommandEncoder() -> MTLComputeCommandEncoder?
  func addCompletedHandler(_ block: @escaping @Sendable (MTLCommandBuffer) -> Void)
  func present(_ drawable: MTLDrawable)
  func commit()
}
public protocol MTLRenderCommandEncoder {
  func setRenderPipelineState(_ state: MTLRenderPipelineState)
  func setDepthStencilState(_ state: MTLDepthStencilState?)
  func setFrontFacing(_ winding: MTLWinding)
  func setCullMode(_ mode: MTLCullMode)
  func setVertexBytes(_ bytes: UnsafeRawPointer, length: Int, index: Int)
  func setFragmentBytes(_ bytes: UnsafeRawPointer, length: Int, index: Int)
  func setVertexBuffer(_ buffer: MTLBuffer?, offset: Int, index: Int)
  func drawIndexedPrimitives(
    type: MTLPrimitiveType, indexCount: Int, indexType: MTLIndexType, indexBuffer: MTLBuffer, indexBufferOffset: Int)
  func endEncoding()
}

public protocol MTLComputeCommandEncoder {
  func setComputePipelineState(_ state: MTLComputePipelineState)
  func setBuffer(_ buffer: MTLBuffer?, offset: Int, index: Int)
  func dispatchThreadgroups(_ groups: MTLSize, threadsPerThreadgroup: MTLSize)
  func endEncoding()
}

public protocol MTKViewDelegate: NSObjectProtocol {
  func mtkView(_ view: MTKView, drawableSizeWillChange size: CGSize)
  func draw(in view: MTKView)
}
public final class MTKView {
  public init(frame: CGRect, device: MTLDevice?) {}
  public var colorPixelFormat = MTLPixelFormat.bgra8Unorm_srgb
  public var depthStencilPixelFormat = MTLPixelFormat.depth32Float
  public var clearColor = MTLClearColor(red: 0, green: 0, blue: 0, alpha: 1)
  public weak var delegate: MTKViewDelegate?
  public var currentRenderPassDescriptor: MTLRenderPassDescriptor? { nil }
  public var currentDrawable: CAMetalDrawable? { nil }
  public var drawableSize: CGSize { .zero }
  public var preferredFramesPerSecond: Int { 60 }
}
