// Graphs in the package's UnityEngine part, over stand-ins of its types.
using System;
using System.Collections.Generic;
using System.Reflection;
using MarrowAnimation;
using MarrowAnimation.Editor;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;
using UnityEngine.Events;

public static partial class Player {
    static void Refused(Type problem, string words, Action what) {
        try {
            what();
        } catch (Exception told) {
            Expect(told.GetType() == problem && told.Message.Contains(words), told.Message + " says \"" + words + "\"");
            return;
        }
        throw new Exception("is not refused: " + words);
    }

    static T Get<T>(object of, string field) {
        return (T)of.GetType().GetField(field, BindingFlags.Instance | BindingFlags.NonPublic).GetValue(of);
    }

    // As fast as it is asked to be, 0.3 m/s, and along the object's z axis: after 4 s at 1.2 m.
    static void Behave(AssetImportContext behaving) {
        MarrowPlayer player = Instance(behaving, p => Set(p, "applyRootMotion", true));
        Expect(player.Graph.Name == "animator" && player.Clip == null, "the file's first graph plays");
        List<string> heard = new List<string>(64), said = new List<string>();
        player.MotionEvent += (p, met) => {
            Expect(p == player, "whose event it is");
            if (heard.Count < heard.Capacity) heard.Add(met.Name);
        };
        UnityEvent<string, float, float> heardToo = Get<UnityEvent<string, float, float>>(player, "onMotionEvent");
        heardToo.AddListener((name, number, time) => said.Add(name));
        int speed = player.Parameter("speed");
        player.SetNumber(speed, 0.3f);
        for (int i = 0; i < 240; ++i) player.Advance(1.0f / 60);
        Vector3 at = player.transform.localPosition;
        Expect(Math.Abs(at.z - 1.2f) < 5e-4 && Math.Abs(at.x) < 1e-3 && at.y == 0, "the way is " + at);
        Expect(Math.Abs(player.DeltaPosition.z - 0.005f) < 5e-5, "a frame's way is " + player.DeltaPosition);
        Expect(heard.Contains("left_foot") && heard.Contains("right_foot"), "feet are heard");
        Expect(string.Join(" ", heard) == string.Join(" ", said), "both ways of hearing them");
        heard.Capacity = heard.Count;
        player.SetNumber(speed, 0);
        player.Advance(1);
        long allocated = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 30; ++i) player.Advance(1.0f / 60);
        allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
        Expect(allocated == 0, "30 frames allocate " + allocated + " bytes");
        Turned(behaving);
        TakenBack(player);
        player.Play("walk", 0);
        Expect(player.Graph == null && player.Animator == null && player.DeltaPosition.z == 0, "a clip ends the graph");
        Refused(typeof(InvalidOperationException), "no graph is played", () => player.SetNumber("speed", 1));
        player.PlayGraph("animator");
        Refused(typeof(MarrowException), "it has speed, reach", () => player.SetNumber("sped", 1));
        Refused(typeof(MarrowException), "it has animator", () => player.PlayGraph("animatr"));
        Expect(player.StateOf("body") == null, "from its beginning");
        GameObject.Destroy(player.gameObject);
    }

    // A character that looks along the scene's x axis and is twice as large goes there, twice as far.
    static void Turned(AssetImportContext behaving) {
        MarrowPlayer player = Instance(behaving);
        player.transform.localRotation = Quaternion.AngleAxis(90, new Vector3(0, 1, 0));
        player.transform.localScale = new Vector3(2, 2, 2);
        player.transform.localPosition = new Vector3(5, 1, 0);
        player.SetNumber("speed", 0.3f);
        player.Advance(1);
        Near(player.transform.localPosition, 5, 1, 0, "who does not move by itself");
        player.ApplyRootMotion = true;
        player.Speed = 0.5f;
        player.Advance(4);
        Vector3 at = player.transform.localPosition;
        Expect(Math.Abs(at.x - 6.2f) < 1e-3 && Math.Abs(at.y - 1) < 1e-6 && Math.Abs(at.z) < 2e-3, "it came to " + at);
        player.Speed = -1;
        player.Advance(1);
        Expect(player.transform.localPosition.x == at.x, "a graph does not go backwards");
        GameObject.Destroy(player.gameObject);
    }

    static void TakenBack(MarrowPlayer player) {
        byte[] saved = player.Animator.Save();
        player.Fire("reach");
        player.Advance(0.1f);
        Expect(player.StateOf("body") == "reaches", "it reaches");
        player.Animator.Restore(saved);
        player.Advance(0.1f);
        Expect(player.StateOf("body") == "moves", "it is taken back");
    }

    // corner.py's joint ends at (10, 20, 30): in Unity the object, moved by the root, and the joint below it together.
    static void CornerGraph(AssetImportContext corner) {
        MarrowPlayer player = Instance(corner, p => {
            Set(p, "posesJoints", true);
            Set(p, "applyRootMotion", true);
        });
        for (int i = 0; i < 10; ++i) player.Advance(0.1f);
        Vector3 red = player.Joint("hinge").TransformPoint(new Vector3(-1, 0, 0));
        float off = Math.Abs(red.x + 10) + Math.Abs(red.y - 21) + Math.Abs(red.z - 30);
        Expect(off < 3e-3, "the red corner is at " + red);
        Expect(player.transform.localPosition.x < -5, "the object is moved");
        Inspect(player);
        GameObject.Destroy(player.gameObject);
    }

    // By the inspector: a slider, a toggle, a button.
    static void Inspect(MarrowPlayer player) {
        MarrowPlayerEditor inspector = new MarrowPlayerEditor {target = player};
        Hand.Shown.Clear();
        inspector.OnInspectorGUI();
        Expect(string.Join(", ", Hand.Shown) ==
                   "label Graph corner, slider -2 3 slow 1, toggle lit True, button shut False",
               "what is shown: " + string.Join(", ", Hand.Shown));
        Expect(inspector.RequiresConstantRepaint(), "it is drawn anew");
        Hand.Sets["slow"] = 2.5f;
        Hand.Sets["lit"] = false;
        Hand.Sets["shut"] = true;
        inspector.OnInspectorGUI();
        Expect(player.Animator.Value(0) == 2.5f && player.Animator.Value(1) == 0, "it is set");
        Hand.Sets.Clear();
        Application.isPlaying = false;
        Hand.Shown.Clear();
        inspector.OnInspectorGUI();
        Expect(Hand.Shown.Count == 0 && !inspector.RequiresConstantRepaint(), "in the Editor it shows no graph");
        Application.isPlaying = true;
        UnityEngine.Object.Destroy(inspector);
    }

    static void InspectMachine(AssetImportContext behaving) {
        MarrowPlayer player = Instance(behaving);
        MarrowPlayerEditor inspector = new MarrowPlayerEditor {target = player};
        Hand.Shown.Clear();
        inspector.OnInspectorGUI();
        Expect(Hand.Shown.Contains("label body not shown"), "before the first frame");
        Hand.Sets["reach"] = true;
        inspector.OnInspectorGUI();
        Hand.Sets.Clear();
        player.Advance(0.25f);
        Hand.Shown.Clear();
        inspector.OnInspectorGUI();
        string reaches = "label body reaches, " + 0.25f.ToString("0.0") + " s";
        Expect(Hand.Shown.Contains(reaches), "what it is in: " + string.Join(", ", Hand.Shown));
        UnityEngine.Object.Destroy(inspector);
        GameObject.Destroy(player.gameObject);
    }

    // Who hears an event may end the graph, or the player.
    static void EndedByEvent(AssetImportContext behaving) {
        foreach (bool closes in new[] {false, true}) {
            MarrowPlayer player = Instance(behaving);
            int heard = 0;
            player.MotionEvent += (p, met) => {
                ++heard;
                if (closes) p.enabled = false;
                else p.Play("idle");
            };
            player.SetNumber("speed", 0.3f);
            for (int i = 0; i < 240; ++i) player.Advance(1.0f / 60);
            Expect(heard == 1 && player.Graph == null && (player.Character == null) == closes, "it ended once");
            GameObject.Destroy(player.gameObject);
        }
        Application.isPlaying = false;  // in the Editor it stands as the graph begins
        MarrowPlayer shown = Instance(behaving);
        Expect(shown.StateOf("body") == "moves", "it is shown in the Editor");
        GameObject.Destroy(shown.gameObject);
        Application.isPlaying = true;
    }

    // A pack's graph, which holds more poses than the clips before; and a file whose graph is not wanted.
    static void GraphOfPack(AssetImportContext newt, AssetImportContext pack, AssetImportContext behaving) {
        MarrowAsset asset = (MarrowAsset)pack.Objects["file"];
        MarrowPlayer player = Instance(newt);
        Refused(typeof(MarrowException), "cook it with --graph", () => player.PlayGraph());
        using (MarrowClips clips = player.File.ClipsOf(asset.File))
        using (MarrowGraph graph = player.File.GraphOf(asset.File, "", clips)) {
            player.PlayGraph(graph);
            player.SetNumber("speed", 0.3f);
            player.Advance(0.1f);
            Expect(player.Character.LayerCount >= graph.Poses && graph.Poses > 2, "it holds " + graph.Poses + " poses");
            Expect(player.Graph == graph && MeshOf(player, "body").bounds.extents.x == 100, "and has no box");
            player.Play("idle");
        }
        GameObject.Destroy(player.gameObject);
        player = Instance(behaving, p => Set(p, "clip", "walk"));
        Expect(player.Graph == null && player.Clip.Name == "walk", "a clip is wanted");
        GameObject.Destroy(player.gameObject);
        Debug.Said.Clear();
        player = Instance(behaving, p => Set(p, "graph", "animatr"));
        Expect(Debug.Said.Count == 1 && Debug.Said[0].Contains("\"animatr\": it has"), "a graph that is not there");
        GameObject.Destroy(player.gameObject);
    }

    static void GraphTests(AssetImportContext newt, string behaving, string corner, string pack) {
        AssetImportContext walker = Import(behaving), once = Import(corner), more = Import(pack);
        Expect(walker.Errors.Count + once.Errors.Count + more.Errors.Count == 0, "they are imported");
        int alive = UnityEngine.Object.Alive;
        Behave(walker);
        CornerGraph(once);
        InspectMachine(walker);
        EndedByEvent(walker);
        GraphOfPack(newt, more, walker);
        Expect(UnityEngine.Object.Alive == alive, "objects left: " + (UnityEngine.Object.Alive - alive));
        Console.WriteLine("player: a graph moves its object 1.2 m in 4 s at 0.3 m/s, and is set by the inspector");
    }
}
