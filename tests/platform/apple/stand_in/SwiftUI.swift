// What platform/apple/Example uses of Apple's SwiftUI, declared by hand: to see that the example's types fit together.
@_exported import Foundation

public protocol View {}
public protocol Scene {}

public protocol App {
  associatedtype Body: Scene
  var body: Body { get }
  init()
}

extension App {
  public static func main() {}
}

public struct WindowGroup: Scene {
  public init<Content: View>(content: () -> Content) {}
}

extension View {
  public func ignoresSafeArea() -> some View { self }
}

public struct UIViewRepresentableContext<Of: UIViewRepresentable> {
  public let coordinator: Of.Coordinator
}

public protocol UIViewRepresentable: View {
  associatedtype UIViewType
  associatedtype Coordinator
  typealias Context = UIViewRepresentableContext<Self>
  func makeCoordinator() -> Coordinator
  func makeUIView(context: Context) -> UIViewType
  func updateUIView(_ view: UIViewType, context: Context)
}
