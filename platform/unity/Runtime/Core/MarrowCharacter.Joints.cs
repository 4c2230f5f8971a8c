using System;
using MarrowRuntime;

namespace MarrowAnimation {

public sealed unsafe partial class MarrowCharacter {
    CharacterSkeleton* SkeletonAt(int skeleton) {
        Character* character = Native;
        if (skeleton < 0 || skeleton >= joints.Length) throw new ArgumentOutOfRangeException("skeleton");
        return &character->skeletons[skeleton];
    }

    CharacterSkeleton* JointOf(int skeleton, int joint) {
        CharacterSkeleton* s = SkeletonAt(skeleton);
        if (joint < 0 || joint >= joints[skeleton].Length) throw new ArgumentOutOfRangeException("joint");
        return s;
    }

    public int JointCount(int skeleton) { return joints[skeleton].Length; }
    public string JointName(int skeleton, int joint) { return joints[skeleton][joint]; }

    /// <summary>-1 for a root. A parent comes before its children.</summary>
    public int JointParent(int skeleton, int joint) {
        ushort parent = JointOf(skeleton, joint)->pose.skeleton.parents[joint];
        return parent == Marrow.NoJoint ? -1 : parent;
    }

    /// <summary>-1 if there is none of this name. Look joints up once, not a frame.</summary>
    public int FindJoint(int skeleton, string joint) { return Array.IndexOf(joints[skeleton], joint); }

    /// <summary>parent_from_joint, or of a root root_from_joint.</summary>
    public MarrowTransform GetLocal(int skeleton, int joint) {
        CharacterSkeleton* s = JointOf(skeleton, joint);
        JointTransform t;
        MarrowException.Must(Marrow.GetJoint(s->pose.local, s->pose.local_count, (uint)joint, &t), name);
        MarrowTransform made;
        made.Px = t.translation[0];
        made.Py = t.translation[1];
        made.Pz = t.translation[2];
        made.Rx = t.rotation[0];
        made.Ry = t.rotation[1];
        made.Rz = t.rotation[2];
        made.Rw = t.rotation[3];
        made.Sx = t.scale[0];
        made.Sy = t.scale[1];
        made.Sz = t.scale[2];
        return options.Space == MarrowSpace.Unity ? MarrowMirror.Mirrored(made) : made;
    }

    /// <summary>Between Pose() and Finish(); then UpdateJoints() once. The rotation must have length 1.</summary>
    public void SetLocal(int skeleton, int joint, MarrowTransform to) {
        CharacterSkeleton* s = JointOf(skeleton, joint);
        if (options.Space == MarrowSpace.Unity) to = MarrowMirror.Mirrored(to);
        JointTransform t = default(JointTransform);
        t.translation[0] = to.Px;
        t.translation[1] = to.Py;
        t.translation[2] = to.Pz;
        t.rotation[0] = to.Rx;
        t.rotation[1] = to.Ry;
        t.rotation[2] = to.Rz;
        t.rotation[3] = to.Rw;
        t.scale[0] = to.Sx;
        t.scale[1] = to.Sy;
        t.scale[2] = to.Sz;
        MarrowException.Must(Marrow.SetJoint(s->pose.local, s->pose.local_count, (uint)joint, &t), name);
    }

    /// <summary>After SetLocal(): where joints are in the scene.</summary>
    public void UpdateJoints() { MarrowException.Must(Marrow.CharacterToModel(Native), name); }

    /// <summary>model_from_joint as 12 floats, three rows of four; scene: the character's own.</summary>
    public void GetScene(int skeleton, int joint, float[] rows) {
        CharacterSkeleton* s = JointOf(skeleton, joint);
        CopyRows(s->pose.model_from_joint[joint], rows);
    }

    /// <summary>What stands above a root and never moves: model_from_root, as GetScene().</summary>
    public void GetAboveRoot(int skeleton, int root, float[] rows) {
        CharacterSkeleton* s = SkeletonAt(skeleton);
        if (root < 0 || root >= s->pose.skeleton.root_count) throw new ArgumentOutOfRangeException("root");
        CopyRows(s->pose.skeleton.model_from_root[root], rows);
    }

    void CopyRows(Affine map, float[] rows) {
        MustHold(rows, 12, "rows");
        if (options.Space == MarrowSpace.Unity) MarrowMirror.MirrorBoth(&map);
        for (int i = 0; i < 12; ++i) rows[i] = map.rows[i];
    }
}

}
