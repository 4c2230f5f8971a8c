using System.IO;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace MarrowAnimation.Editor {

/// <summary>
/// Makes of a .mrw file a MarrowAsset, its materials, and an object with a player that can be dragged into a scene.
/// </summary>
[ScriptedImporter(1, "mrw")]
public sealed class MarrowImporter : ScriptedImporter {
    public override void OnImportAsset(AssetImportContext context) {
        byte[] bytes = System.IO.File.ReadAllBytes(context.assetPath);
        MarrowAsset asset = MarrowAsset.Make(bytes, context.assetPath);
        asset.name = Path.GetFileNameWithoutExtension(context.assetPath);
        GameObject shown = new GameObject(asset.name);
        try {
            Material[] materials = MakeMaterials(asset.File);
            context.AddObjectToAsset("file", asset);
            for (int i = 0; i < materials.Length; ++i)
                if (materials[i] != null) context.AddObjectToAsset("material " + i, materials[i]);
            shown.AddComponent<MarrowPlayer>().SetUp(asset, materials);
        } catch (MarrowException problem) {
            context.LogImportError(problem.Message);
            context.AddObjectToAsset("file", asset);
        }
        context.AddObjectToAsset("object", shown);
        context.SetMainObject(shown);
    }

    // One a mesh. A clip pack has none.
    static Material[] MakeMaterials(MarrowFile file) {
        MarrowCharacterOptions options = new MarrowCharacterOptions();
        options.PosesAlone = true;
        if (file.MeshCount == 0) return new Material[0];
        using (MarrowCharacter character = new MarrowCharacter(file, options)) {
            Material[] made = new Material[character.MeshCount];
            for (int i = 0; i < made.Length; ++i) made[i] = MarrowMaterials.Make(character.Mesh(i));
            return made;
        }
    }
}

}
