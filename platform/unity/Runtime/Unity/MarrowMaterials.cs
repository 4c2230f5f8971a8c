using UnityEngine;

namespace MarrowAnimation {

/// <summary>Materials of a base colour, for the render pipeline that the project has.</summary>
public static class MarrowMaterials {
    static readonly string[] shaders = {"Universal Render Pipeline/Lit", "HDRP/Lit", "Standard"};

    /// <summary>Null if the build has no shader of these: then assign materials to the player.</summary>
    public static Material Make(MarrowMesh mesh) {
        foreach (string name in shaders) {
            Shader shader = Shader.Find(name);
            if (shader == null) continue;
            float[] rgba = new float[4];
            mesh.GetBaseColour(rgba);
            Material made = new Material(shader);
            made.name = mesh.MaterialName.Length > 0 ? mesh.MaterialName : mesh.Name;
            made.color = new Color(rgba[0], rgba[1], rgba[2], rgba[3]).gamma;  // the file's are linear
            if (mesh.DoubleSided && made.HasProperty("_Cull")) made.SetFloat("_Cull", 0);
            return made;
        }
        return null;
    }
}

}
