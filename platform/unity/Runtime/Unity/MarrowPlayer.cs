using System;
using UnityEngine;

namespace MarrowAnimation {

/// <summary>
/// Plays a graph of behaviour of a .mrw file, or its clips: skins its meshes below this object, and poses Transforms of
/// its joints if asked to. Nothing of a frame allocates.
/// </summary>
[ExecuteAlways, DisallowMultipleComponent, DefaultExecutionOrder(-50), AddComponentMenu("Marrow/Marrow Player")]
public sealed partial class MarrowPlayer : MonoBehaviour {
    [SerializeField, Tooltip("A .mrw file of the project")] MarrowAsset asset;
    [SerializeField, Tooltip("A graph's name in the file; empty: the first, if Clip is empty, too")] string graph = "";
    [SerializeField, Tooltip("Without a graph: its name in the file; empty: the first")] string clip = "";
    [SerializeField] MarrowPlayMode mode = MarrowPlayMode.Loop;
    [SerializeField, Tooltip("Seconds of the clip a second; below 0: backwards")] float speed = 1;
    [SerializeField, Tooltip("Show the file's meshes, skinned by the CPU")] bool skinsMeshes = true;
    [SerializeField, Tooltip("Have a Transform for each joint, to hang things on")] bool posesJoints = false;
    [SerializeField, Tooltip("Pose the Transforms below this one that are called as joints; empty: own ones")]
    Transform rig;
    [SerializeField, Tooltip("One a mesh of the file; the last serves the others")]
    Material[] materials = new Material[0];

    MarrowFile file;
    MarrowCharacter character;
    MarrowSkin[] skins = new MarrowSkin[0];
    MarrowRig joints;
    readonly MarrowLayer[] layers = new MarrowLayer[2];
    MarrowClip now, before;
    MarrowPlayback at, atBefore;
    float fade, fadeLeft;

    /// <summary>Between pose and skinning, once a frame: for look-at, feet and the like.</summary>
    public event Action<MarrowPlayer> Posed;

    /// <summary>Before the character's memory goes.</summary>
    internal event Action Closing;

    /// <summary>Whether time goes on by Unity's.</summary>
    public bool PlaysByItself { get; set; } = true;

    /// <summary>Whether meshes are skinned by the CPU. Setting it begins anew.</summary>
    public bool SkinsMeshes {
        get { return skinsMeshes; }
        set {
            if (value == skinsMeshes) return;
            skinsMeshes = value;
            if (file != null) Open(file);
        }
    }

    /// <summary>Null while nothing is open.</summary>
    public MarrowCharacter Character { get { return character; } }
    public MarrowFile File { get { return file; } }
    public MarrowClip Clip { get { return now; } }
    public float Time { get { return at.Time; } }

    /// <summary>Of the current clip and those to come.</summary>
    public float Speed {
        get { return speed; }
        set {
            speed = value;
            at.Speed = value;
        }
    }

    /// <summary>Of materials, null where none is given.</summary>
    public void SetUp(MarrowAsset asset, Material[] materials) {
        this.asset = asset;
        this.materials = materials ?? new Material[0];
    }

    void OnEnable() {
        if (asset == null || character != null) return;
        try {
            Open(asset.File);
        } catch (MarrowException problem) {
            Debug.LogError(problem.Message, this);
        }
    }

    void OnDisable() { Close(); }

    /// <summary>
    /// Shows a character of a file, as by MarrowFile.Load(), in place of that there was. The caller may dispose of the
    /// file when he likes. Throws a MarrowException.
    /// </summary>
    public void Open(MarrowFile file) {
        bool hasGraph = graph.Length > 0 || (clip.Length == 0 && file.GraphCount > 0);
        Open(file, hasGraph ? file.Graph(graph) : null);
    }

    void Open(MarrowFile file, MarrowGraph played) {
        MarrowCharacterOptions options = new MarrowCharacterOptions();
        options.Space = MarrowSpace.Unity;
        options.PosesAlone = !skinsMeshes;
        if (played != null) options.Layers = Math.Max(2, played.Poses);
        // Before the old one goes, and maybe the file with it.
        MarrowCharacter next = new MarrowCharacter(file, options);
        Close();
        character = next;
        this.file = file;
        try {
            if (skinsMeshes) {
                skins = new MarrowSkin[character.MeshCount];
                for (int i = 0; i < skins.Length; ++i)
                    skins[i] = new MarrowSkin(character, i, file, transform, MaterialOf(i));
            }
            if (posesJoints || rig != null) joints = new MarrowRig(character, rig != null ? rig : transform);
            if (played != null) Begin(played);
            else if (clip.Length > 0) Play(clip, 0);
            else if (file.Clips.Count > 0) Play(file.Clips[0], 0);
            Show();
        } catch {
            Close();
            throw;
        }
    }

    Material MaterialOf(int mesh) {
        return materials.Length == 0 ? null : materials[Math.Min(mesh, materials.Length - 1)];
    }

    void Close() {
        if (Closing != null) Closing();
        foreach (MarrowSkin skin in skins)
            if (skin != null) skin.Destroy();
        skins = new MarrowSkin[0];
        if (joints != null) joints.Destroy();
        LeaveGraph();
        if (character != null) character.Dispose();
        joints = null;
        character = null;
        file = null;
        now = before = null;
    }

    /// <summary>
    /// A clip of the file by its name; the exception of one that there is not lists those that there are.
    /// </summary>
    public void Play(string clip, float fadeSeconds = 0.2f) {
        if (file == null) throw new InvalidOperationException(name + ": nothing is open to play \"" + clip + "\" with");
        Play(file.Clips[clip], fadeSeconds);
    }

    /// <summary>From its start. fadeSeconds: how long the clip before fades out; a graph ends at once.</summary>
    public void Play(MarrowClip clip, float fadeSeconds = 0.2f) {
        LeaveGraph();
        before = fadeSeconds > 0 ? now : null;
        atBefore = at;
        fade = fadeLeft = fadeSeconds;
        now = clip;
        at = MarrowPlayback.Start(clip, mode, speed);
        if (IsOwn(clip)) return;
        foreach (MarrowSkin skin in skins) skin.NeverCull();  // the file's boxes know nothing of a pack's clips
    }

    bool IsOwn(MarrowClip clip) {
        foreach (MarrowClip own in file.Clips)
            if (own == clip) return true;
        return false;
    }

    /// <summary>A joint's Transform; null if there is none, or the player has no Transforms.</summary>
    public Transform Joint(string joint) { return joints == null ? null : joints.Find(character, joint); }

    void LateUpdate() {
        if (PlaysByItself && Application.isPlaying) Advance(UnityEngine.Time.deltaTime);
    }

    /// <summary>Moves on and shows. LateUpdate does it, unless PlaysByItself is false: then a game does.</summary>
    public void Advance(float seconds) {
        if (character == null) return;
        if (animator != null) {
            Behave(seconds);
            return;
        }
        if (now != null) at.Advance(now, seconds);
        if (before != null) {
            atBefore.Advance(before, seconds);
            fadeLeft -= seconds;
            if (fadeLeft <= 0) before = null;
        }
        Show();
    }

    void Show() {
        if (hasBegun) character.Pose(animator);
        else PoseClips();  // of none the rest pose
        if (Posed != null) Posed(this);
        if (joints != null) joints.Show(character);
        if (skins.Length == 0) return;
        character.Finish();
        for (int i = 0; i < skins.Length; ++i) skins[i].Show(character);
    }

    void PoseClips() {
        int count = 0;
        if (now != null) {
            layers[count].Clip = now;
            layers[count].Time = at.Time;
            layers[count++].Weight = before == null ? 1 : 1 - fadeLeft / fade;
        }
        if (before != null) {
            layers[count].Clip = before;
            layers[count].Time = atBefore.Time;
            layers[count++].Weight = fadeLeft / fade;
        }
        character.Pose(layers, count);
    }

    /// <summary>Destroys what the player made, in play mode and outside it.</summary>
    internal static void Remove(UnityEngine.Object made) {
        if (made == null) return;
        if (Application.isPlaying) Destroy(made);
        else DestroyImmediate(made);
    }
}

}
