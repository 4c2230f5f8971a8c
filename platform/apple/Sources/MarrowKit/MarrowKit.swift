// A few lines of Swift over the C interface, and what an app shows in its privacy report. All else is `import Marrow`.
@_exported import Marrow

/// What a call came to, if not to MRW_OK.
public struct MarrowError: Error, CustomStringConvertible {
  public let status: mrw_status
  public let what: String

  public init(status: mrw_status, what: String) {
    self.status = status
    self.what = what
  }

  public var description: String { "\(what): \(String(cString: mrw_status_text(status)))" }
}

/// Throws unless the status is MRW_OK: `try check(mrw_load(…), "newt.mrw")`.
public func check(_ status: mrw_status, _ what: @autoclosure () -> String) throws {
  if status != MRW_OK { throw MarrowError(status: status, what: what()) }
}

/// The same, and says where in the file and which rule.
public func check(_ status: mrw_status, _ what: @autoclosure () -> String, _ error: mrw_data_error) throws {
  let rule = error.rule.map { ": byte \(error.offset): \(String(cString: $0))" } ?? ""
  try check(status, what() + rule)
}

/// Throws unless the library and the headers are of one release. Ask once, first.
public func checkRelease() throws {
  try check(mrw_status(mrw_abi() == MRW_ABI ? MRW_OK : MRW_MISMATCH), "Marrow's library and headers")
}

/// Memory for the runtime: it begins on a boundary of 16 bytes, stays where it is, and goes with its last owner.
public final class Block {
  public let memory: UnsafeMutableRawPointer
  public let count: Int

  public init(_ count: Int) {
    self.count = count
    memory = .allocate(byteCount: max(count, 16), alignment: 16)
  }

  public convenience init(copy bytes: UnsafeRawBufferPointer) {
    self.init(bytes.count)
    memory.copyMemory(from: bytes.baseAddress ?? UnsafeRawPointer(memory), byteCount: bytes.count)
  }

  deinit { memory.deallocate() }
}
