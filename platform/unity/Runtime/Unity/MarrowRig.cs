using System.Collections.Generic;
using UnityEngine;

namespace MarrowAnimation {

/// <summary>
/// Transforms of the joints of a character: those found below an object by their names, the others made.
/// </summary>
internal sealed class MarrowRig {
    readonly Transform[][] joints;
    readonly List<GameObject> made = new List<GameObject>();

    internal MarrowRig(MarrowCharacter character, Transform parent) {
        Dictionary<string, Transform> there = new Dictionary<string, Transform>();
        foreach (Transform t in parent.GetComponentsInChildren<Transform>(true))
            if (t != parent && !there.ContainsKey(t.name)) there.Add(t.name, t);
        joints = new Transform[character.SkeletonCount][];
        for (int s = 0; s < joints.Length; ++s) {
            joints[s] = new Transform[character.JointCount(s)];
            for (int j = 0; j < joints[s].Length; ++j) {
                string name = character.JointName(s, j);
                if (there.TryGetValue(name, out joints[s][j])) continue;
                int above = character.JointParent(s, j);
                joints[s][j] = Make(name, above >= 0 ? joints[s][above] : AboveRoot(character, s, j, parent));
            }
        }
    }

    // What stands above a root in the file, if it is anything.
    Transform AboveRoot(MarrowCharacter character, int skeleton, int root, Transform parent) {
        float[] rows = new float[12];
        MarrowTransform t;
        character.GetAboveRoot(skeleton, root, rows);
        bool plain = true;
        for (int i = 0; i < 12; ++i) plain = plain && rows[i] == (i % 5 == 0 ? 1 : 0);
        if (plain) return parent;
        if (!MarrowTransform.TryMake(rows, out t))
            Debug.LogWarning(character.JointName(skeleton, root) + ": what stands above it shears, which no " +
                             "Transform can: apply transforms before exporting", parent);
        Transform above = Make("above " + character.JointName(skeleton, root), parent);
        Set(above, t);
        return above;
    }

    Transform Make(string name, Transform parent) {
        GameObject one = new GameObject(name);
        one.hideFlags = HideFlags.DontSave;
        one.transform.SetParent(parent, false);
        made.Add(one);
        return one.transform;
    }

    static void Set(Transform to, MarrowTransform t) {
        to.localPosition = new Vector3(t.Px, t.Py, t.Pz);
        to.localRotation = new Quaternion(t.Rx, t.Ry, t.Rz, t.Rw);
        to.localScale = new Vector3(t.Sx, t.Sy, t.Sz);
    }

    /// <summary>Allocates nothing.</summary>
    internal void Show(MarrowCharacter character) {
        for (int s = 0; s < joints.Length; ++s)
            for (int j = 0; j < joints[s].Length; ++j) Set(joints[s][j], character.GetLocal(s, j));
    }

    internal Transform Find(MarrowCharacter character, string joint) {
        for (int s = 0; s < joints.Length; ++s) {
            int at = character.FindJoint(s, joint);
            if (at >= 0) return joints[s][at];
        }
        return null;
    }

    internal void Destroy() {
        for (int i = made.Count - 1; i >= 0; --i) MarrowPlayer.Remove(made[i]);  // children first
    }
}

}
