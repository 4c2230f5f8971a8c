// Takes the example's character down the road where there is a Swift compiler, and writes the positions of all slots.
// usage: road FILE.mrw CLIP SECONDS OUT.bin
import Foundation
import MarrowKit

@main
enum Road {
  static func main() {
    do {
      let words = CommandLine.arguments
      let bytes = try Data(contentsOf: URL(fileURLWithPath: words[1]))
      let puppet = try bytes.withUnsafeBytes { try Puppet($0, name: words[1]) }
      try puppet.play(words[2])
      try puppet.advance(Float(words[3])!)
      var all = Data()
      for mesh in 0..<puppet.meshCount {
        var positions = [Float](repeating: 0, count: 3 * Int(puppet.geometry(mesh).slot_count))
        var normals = positions
        try puppet.skin(mesh, positions: &positions, normals: &normals)
        positions.withUnsafeBytes { all.append(contentsOf: $0) }
      }
      try all.write(to: URL(fileURLWithPath: words[4]))
    } catch {
      print("road: \(error)")
      exit(1)
    }
  }
}
