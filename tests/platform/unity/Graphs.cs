// Tests graphs in the package's part without UnityEngine against a real library.
// usage: Graphs.exe poses BEHAVING.mrw      the hash that poses.c prints, told to play a graph
//        Graphs.exe tests BEHAVING.mrw CORNER_GRAPH.mrw GRAPH_PACK.mrw NEWT_NONE.mrw
// BEHAVING.mrw is the newt with tests/examples/stages/animator.anim.toml, GRAPH_PACK.mrw a pack of its clips with that
// graph, CORNER_GRAPH.mrw corner.py's with corner.anim.toml.
using System;
using System.Collections.Generic;
using MarrowAnimation;

public static unsafe class Graphs {
    static uint hash = 2166136261;
    static void Add(float value) { hash = unchecked((hash ^ *(uint*)&value) * 16777619); }

    static void Expect(bool condition, string what) {
        if (!condition) throw new Exception("does not hold: " + what);
    }

    static void Near(double got, double wanted, double within, string what) {
        Expect(Math.Abs(got - wanted) <= within, what + " is " + got + ", not " + wanted);
    }

    static void Refused(Action what, params string[] words) {
        try {
            what();
        } catch (MarrowException problem) {
            foreach (string word in words) Expect(problem.Message.Contains(word), problem.Message + " names " + word);
            return;
        }
        throw new Exception("is not refused: " + string.Join(" ", words));
    }

    static void Disposed(Action what) {
        try {
            what();
        } catch (ObjectDisposedException) {
            return;
        }
        throw new Exception("what is disposed of can be used");
    }

    static MarrowCharacter CharacterFor(MarrowGraph graph, MarrowFile file) {
        return new MarrowCharacter(file, new MarrowCharacterOptions {Layers = Math.Max(2, graph.Poses)});
    }

    // ---- As C ----

    static void AddFrame(MarrowCharacter character, float[] rows, float[][] positions, float[][] normals) {
        for (int j = 0; j < character.JointCount(0); ++j) {
            MarrowTransform t = character.GetLocal(0, j);
            character.GetScene(0, j, rows);
            Add(t.Px); Add(t.Py); Add(t.Pz);
            Add(t.Rx); Add(t.Ry); Add(t.Rz); Add(t.Rw);
            Add(t.Sx); Add(t.Sy); Add(t.Sz);
            foreach (float value in rows) Add(value);
        }
        for (int m = 0; m < positions.Length; ++m) {
            character.Skin(m, positions[m], normals[m], null);
            foreach (float value in positions[m]) Add(value);
            foreach (float value in normals[m]) Add(value);
        }
    }

    static void AddStep(MarrowAnimator animator, MarrowCharacter character) {
        animator.Update(1.0f / 60);
        MarrowTransform step = animator.Step;
        Add(step.Px); Add(step.Py); Add(step.Pz);
        Add(step.Rx); Add(step.Ry); Add(step.Rz); Add(step.Rw);
        for (int i = 0; i < animator.EventCount; ++i) {
            MarrowMotionEvent met = animator.Event(i);
            uint id = met.Id;
            Expect(MarrowAnimator.EventId(met.Name) == id, met.Name + " has its number");
            Add(*(float*)&id); Add(met.Number); Add(met.Time);
        }
        character.Pose(animator);
        character.Finish();
    }

    static void Poses(string name) {
        using (MarrowFile file = MarrowFile.Load(name))
        using (MarrowAnimator animator = new MarrowAnimator(file.Graph()))
        using (MarrowCharacter character = CharacterFor(file.Graph(), file)) {
            byte[] saved = null;
            float[] rows = new float[12];
            float[][] positions = new float[character.MeshCount][], normals = new float[character.MeshCount][];
            for (int m = 0; m < positions.Length; ++m) {
                positions[m] = new float[3 * character.Mesh(m).SlotCount];
                normals[m] = new float[positions[m].Length];
            }
            animator.SetNumber("speed", 0.3f);
            for (int i = 0; i < 120; ++i) {
                if (i == 60) {
                    saved = animator.Save();
                    animator.SetNumber("speed", 0);
                    animator.Fire("reach");
                }
                AddStep(animator, character);
                AddFrame(character, rows, positions, normals);
            }
            animator.Restore(saved);
            for (int i = 0; i < 60; ++i) {
                AddStep(animator, character);
                AddFrame(character, rows, positions, normals);
            }
        }
        Console.WriteLine(hash.ToString("x8"));
    }

    // ---- By hand ----

    // The graph's space is as fast as it is asked to be, so 0.3 m/s for 4 s are 1.2 m, along z; and a walk's feet come
    // down by turns.
    static void Walk(MarrowFile file) {
        MarrowGraph graph = file.Graph("animator");
        Expect(graph == file.Graph() && graph.Name == "animator", "the first graph");
        Expect(graph.ParameterCount == 2 && graph.MachineCount == 1 && graph.MachineName(0) == "body", "what is in it");
        MarrowParameter speed = graph.ParameterAt(graph.Parameter("speed"));
        Expect(speed.Kind == MarrowParameterKind.Number && speed.Least == 0 && speed.Most == 1, "speed");
        Expect(graph.ParameterAt(graph.Parameter("reach")).Kind == MarrowParameterKind.Trigger, "reach");
        using (MarrowAnimator animator = new MarrowAnimator(graph))
        using (MarrowAnimator server = new MarrowAnimator(graph, new MarrowAnimatorOptions {UpdatesAlone = true}))
        using (MarrowCharacter character = CharacterFor(graph, file)) {
            int number = graph.Parameter("speed"), body = graph.Machine("body");
            double z = 0;
            List<string> feet = new List<string>();
            Expect(animator.StateOf(body) == null, "nothing is shown before the first update");
            animator.SetNumber(number, 0.3f);
            server.SetNumber("speed", 0.3f);
            long allocated = 0;
            for (int i = 0; i < 240; ++i) {
                if (i == 200) allocated = GC.GetAllocatedBytesForCurrentThread();
                animator.Update(1.0f / 60);
                z += animator.Step.Pz;
                for (int e = 0; e < animator.EventCount; ++e) {
                    MarrowMotionEvent met = animator.Event(e);
                    if (met.Name == "left_foot" || met.Name == "right_foot") feet.Add(met.Name);
                    Expect(met.Clip == "walk" || met.Clip == "idle", "whose clip it is: " + met.Clip);
                    Expect(met.Count == 1 && met.Until >= met.Time, "what an event has");
                }
                character.Pose(animator);
                character.Finish();
            }
            allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
            Expect(allocated < 200, "forty frames allocate " + allocated + " bytes");  // the list of feet may grow
            Near(z, 1.2, 5e-4, "the way of 4 s at 0.3 m/s");
            float seconds;
            Expect(animator.StateOf(body, out seconds) == "moves", "the state");
            Near(seconds, 4, 1e-4, "its seconds");
            Expect(feet.Count >= 5, "feet are heard");
            for (int i = 1; i < feet.Count; ++i) Expect(feet[i] != feet[i - 1], "feet come down by turns");
            for (int i = 0; i < 240; ++i) server.Update(1.0f / 60);
            Expect(Same(animator.Save(), server.Save()), "without poses the state is the same");
            Reach(animator, server, body);
            character.Pose(server);
        }
    }

    // The trigger takes the machine to another state, which a snapshot takes back, in another animator, too.
    static void Reach(MarrowAnimator animator, MarrowAnimator other, int body) {
        byte[] saved = animator.Save();
        float speed = animator.Value(animator.Graph.Parameter("speed"));
        animator.SetNumber("speed", 0);
        animator.Fire("reach");
        animator.Update(0.1f);
        Expect(animator.StateOf(body) == "reaches", "it reaches");
        Expect(animator.Value(animator.Graph.Parameter("speed")) == 0, "what was set last");
        animator.SetNumber("speed", 7);
        Expect(animator.Value(animator.Graph.Parameter("speed")) == 1, "what was set last is in the range");
        animator.Restore(saved);
        Expect(animator.Value(animator.Graph.Parameter("speed")) == speed, "so is what was set");
        Expect(animator.StateOf("body") == "moves" && Same(animator.Save(), saved), "it is taken back");
        other.Update(3);
        other.Restore(saved);
        animator.Update(0.5f);
        other.Update(0.5f);
        Expect(Same(animator.Save(), other.Save()), "both go on alike");
        byte[] now = animator.Save(), changed = (byte[])saved.Clone();
        changed[0] ^= 1;
        Refused(() => animator.Restore(changed), "behaving.mrw", "no snapshot");
        Refused(() => animator.Restore(new byte[saved.Length - 1]), "no snapshot");
        Refused(() => animator.Save(new byte[3]), "no room");
        Expect(Same(animator.Save(), now), "and nothing has changed");
    }

    static bool Same(byte[] a, byte[] b) {
        if (a.Length != b.Length) return false;
        for (int i = 0; i < a.Length; ++i)
            if (a[i] != b[i]) return false;
        return true;
    }

    // corner.py's joint ends at (10, 20, 30), turned by 90 degrees about z, and is turned by 90 degrees about y at half
    // of the clip. What the root takes of it and what is left in the pose are the whole, in Unity's axes mirrored.
    static void Corner(MarrowFile file, MarrowSpace space) {
        float mirror = space == MarrowSpace.Unity ? -1 : 1;
        MarrowGraph graph = file.Graph("corner");
        using (MarrowAnimator animator = new MarrowAnimator(graph, new MarrowAnimatorOptions {Space = space}))
        using (MarrowCharacter character = new MarrowCharacter(file, new MarrowCharacterOptions {Space = space})) {
            MarrowTransform at = new MarrowTransform {Rw = 1, Sx = 1, Sy = 1, Sz = 1};
            float[] rows = new float[12];
            double moved = 0;
            for (int half = 1; half <= 2; ++half) {
                animator.Update(0.5f);
                MarrowTransform step = animator.Step;
                moved += Math.Abs(step.Px) + Math.Abs(step.Ry);
                Expect(step.Sx == 1 && step.Sy == 1 && step.Sz == 1, "a step is rigid");
                at = Times(at, step);
                if (half == 1) Expect(animator.EventCount == 1 && animator.Event(0).Name == "mark" &&
                                      animator.Event(0).Number == 7 && animator.Event(0).Time == 0.25f &&
                                      animator.Event(0).Clip == "turn", "an event of its own");
                else Expect(animator.EventCount == 0, "once");
                character.Pose(animator);
                character.GetScene(0, 0, rows);
                double[] p = Turned(at, rows[3], rows[7], rows[11]), x = Turned(at, rows[0], rows[4], rows[8]);
                double end = half == 1 ? 0 : 1;
                Near(p[0] + at.Px, mirror * 10 * end, 1e-3, "x");
                Near(p[1] + at.Py, 20 * end, 1e-3, "y");
                Near(p[2] + at.Pz, 30 * end, 1e-3, "z");
                // The joint's x axis comes to -z, then to y.
                Near(x[0], 0, 1e-3, "the axis' x");
                Near(x[1], mirror * end, 1e-3, "the axis' y");
                Near(x[2], -mirror * (1 - end), 1e-3, "the axis' z");
            }
            Expect(moved > 1, "the root has moved");
            Expect(graph.ParameterAt(0).Initial == 1 && animator.Value(1) == 1, "initial values");
        }
    }

    static double[] Turned(MarrowTransform by, double x, double y, double z) {
        double cx = by.Ry * z - by.Rz * y, cy = by.Rz * x - by.Rx * z, cz = by.Rx * y - by.Ry * x;
        return new[] {x + 2 * (by.Rw * cx + by.Ry * cz - by.Rz * cy), y + 2 * (by.Rw * cy + by.Rz * cx - by.Rx * cz),
                      z + 2 * (by.Rw * cz + by.Rx * cy - by.Ry * cx)};
    }

    static MarrowTransform Times(MarrowTransform a, MarrowTransform b) {
        double[] p = Turned(a, b.Px, b.Py, b.Pz);
        MarrowTransform made = a;
        made.Px += (float)p[0];
        made.Py += (float)p[1];
        made.Pz += (float)p[2];
        made.Rx = a.Rw * b.Rx + a.Rx * b.Rw + a.Ry * b.Rz - a.Rz * b.Ry;
        made.Ry = a.Rw * b.Ry - a.Rx * b.Rz + a.Ry * b.Rw + a.Rz * b.Rx;
        made.Rz = a.Rw * b.Rz + a.Rx * b.Ry - a.Ry * b.Rx + a.Rz * b.Rw;
        made.Rw = a.Rw * b.Rw - a.Rx * b.Rx - a.Ry * b.Ry - a.Rz * b.Rz;
        return made;
    }

    // ---- Bad calls, and what goes before what it needs ----

    static void Misuse(MarrowFile file, MarrowFile corner) {
        MarrowGraph graph = file.Graph();
        Refused(() => file.Graph("animatr"), "behaving.mrw", "\"animatr\"", "it has animator");
        Refused(() => graph.Parameter("sped"), "\"sped\"", "speed, reach");
        Refused(() => graph.Machine("move"), "\"move\"", "it has body");
        Refused(() => corner.Graph().Machine("move"), "it has none");
        using (MarrowAnimator animator = new MarrowAnimator(graph)) {
            Refused(() => animator.SetFlag("speed", true), "\"speed\"", "for a flag");
            Refused(() => animator.Fire("speed"), "for a trigger");
            Refused(() => animator.SetNumber("reach", 1), "\"reach\"", "for a number");
            Refused(() => animator.SetNumber("speed", float.NaN), "speed");
            Refused(() => animator.SetNumber(7, 1), "no parameter 7");
            Refused(() => animator.SetNumber(-1, 1), "no parameter -1");
            Refused(() => animator.Update(-1), "animator", "below 0");
            Refused(() => animator.Update(float.NaN), "below 0");
            using (MarrowCharacter early = CharacterFor(graph, file))
                Refused(() => early.Pose(animator), "never updated");
            animator.Update(0.1f);
            using (MarrowCharacter other = new MarrowCharacter(corner))
                Refused(() => other.Pose(animator), "another file");
            using (MarrowCharacter small = new MarrowCharacter(file, new MarrowCharacterOptions {Layers = 1}))
                Refused(() => small.Pose(animator), "room for 1", "Layers");
            try {
                animator.Event(animator.EventCount);
                throw new Exception("an event that there is not");
            } catch (ArgumentOutOfRangeException) {}
        }
        MarrowAnimatorOptions one = new MarrowAnimatorOptions {Events = 1, LeastLoudness = 0};
        using (MarrowAnimator few = new MarrowAnimator(graph, one)) {
            few.SetNumber("speed", 0.3f);
            few.Update(4);
            Expect(few.EventCount == 1 && few.EventsLeftOut > 0, "events that have no room are counted");
        }
    }

    // A graph of a pack takes clips of the character's file and of packs, and does not fit where there are none.
    static void Packs(string behaving, string pack, string newt) {
        MarrowFile file = MarrowFile.Load(newt), more = MarrowFile.Load(pack);
        Refused(() => file.Graph(), "newt_none.mrw", "cook it with --graph");
        MarrowClips moves = file.ClipsOf(more);
        MarrowGraph graph = file.GraphOf(more, "", moves);
        MarrowAnimator animator = new MarrowAnimator(graph);
        more.Dispose();
        animator.SetNumber("speed", 0.3f);
        animator.Update(1);
        Expect(animator.StateOf("body") == "moves", "it plays");
        graph.Dispose();
        moves.Dispose();
        Disposed(() => animator.Update(1));
        Disposed(() => animator.Save());
        file.Dispose();
        animator.Dispose();
        animator.Dispose();
        Disposed(() => Console.Write(file.MeshCount));
        Disposed(() => Console.Write(more.MeshCount));

        MarrowFile other = MarrowFile.Load(newt), source = MarrowFile.Load(pack);
        MarrowClips clips = other.ClipsOf(source);
        animator = new MarrowAnimator(other.GraphOf(source, "animator", clips));
        clips.Dispose();
        Disposed(() => animator.Update(1));
        animator.Dispose();
        using (MarrowFile corner = MarrowFile.Load(behaving.Replace("behaving", "corner_graph")))
            Refused(() => corner.GraphOf(source, ""), "does not fit", "corner_graph.mrw", "\"idle\"");

        MarrowFile own = MarrowFile.Load(behaving);
        MarrowAnimator last = new MarrowAnimator(own.Graph());
        own.Dispose();
        last.Update(1);  // a file stays open for its animators
        last.Dispose();
        Disposed(() => last.Update(1));
        Disposed(() => new MarrowAnimator(last.Graph));
    }

    public static int Main(string[] args) {
        if (args[0] == "poses") {
            Poses(args[1]);
            return 0;
        }
        using (MarrowFile file = MarrowFile.Load(args[1]), corner = MarrowFile.Load(args[2])) {
            Walk(file);
            Corner(corner, MarrowSpace.Gltf);
            Corner(corner, MarrowSpace.Unity);
            Misuse(file, corner);
        }
        Packs(args[1], args[3], args[4]);
        Console.WriteLine("graphs: 1.2 m in 4 s at 0.3 m/s, taken back to the bit, no allocation a frame");
        return 0;
    }
}
