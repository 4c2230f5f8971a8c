// swift-tools-version:5.5
// Marrow for Swift: the C interface as the module Marrow, and MarrowKit, which is a few lines of Swift over it.
// tools/apple.sh puts Marrow.xcframework beside this file.
import PackageDescription

let package = Package(
  name: "Marrow",
  platforms: [.iOS(.v14), .macOS(.v11)],
  products: [.library(name: "Marrow", targets: ["Marrow", "MarrowKit"])],
  targets: [
    .binaryTarget(name: "Marrow", path: "Marrow.xcframework"),
    // A static library carries no resources into an app, so the privacy manifest is a resource of this target.
    .target(name: "MarrowKit", dependencies: ["Marrow"], resources: [.copy("PrivacyInfo.xcprivacy")]),
  ]
)
