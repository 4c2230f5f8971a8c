using UnityEngine;

namespace MarrowAnimation {

/// <summary>
/// A cooked file in the project, which the importer makes of each .mrw. All players of it share one copy.
/// </summary>
public sealed class MarrowAsset : ScriptableObject {
    [SerializeField, HideInInspector] byte[] bytes = new byte[0];
    [SerializeField, HideInInspector] string source = "";
    MarrowFile file;

    /// <summary>source: what errors call the file.</summary>
    public static MarrowAsset Make(byte[] bytes, string source) {
        MarrowAsset made = CreateInstance<MarrowAsset>();
        made.bytes = bytes;
        made.source = source;
        return made;
    }

    /// <summary>The file, opened when first asked for. Throws a MarrowException.</summary>
    public MarrowFile File { get { return file ?? (file = MarrowFile.FromBytes(bytes, source)); } }

    void OnDisable() {
        if (file != null) file.Dispose();  // its memory stays as long as characters have it
        file = null;
    }
}

}
