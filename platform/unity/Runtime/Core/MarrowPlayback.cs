using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>What happens at the ends of a clip.</summary>
public enum MarrowPlayMode {
    Once = PlayMode.Once,
    Loop = PlayMode.Loop,
    PingPong = PlayMode.PingPong,
}

/// <summary>Where in its clip a character is. Plain numbers; begin with Start().</summary>
public struct MarrowPlayback {
    Playback state;

    /// <summary>At the clip's start, or backwards from its end. speed: seconds of the clip a second.</summary>
    public static MarrowPlayback Start(MarrowClip clip, MarrowPlayMode mode = MarrowPlayMode.Loop, float speed = 1) {
        MarrowPlayback made;
        made.state = Playback.New();
        made.state.mode = (PlayMode)mode;
        made.state.speed = speed;
        if (speed < 0) made.state.time_s = clip.Duration;
        return made;
    }

    /// <summary>Seconds from the clip's start.</summary>
    public float Time { get { return (float)state.time_s; } }
    public float Speed { get { return state.speed; } set { state.speed = value; } }

    /// <summary>How often the last Advance() passed an end; events are due by it.</summary>
    public int Turns { get { return state.turns; } }

    public unsafe void Advance(MarrowClip clip, float seconds) {
        fixed (Playback* at = &state) MarrowException.Must(Marrow.Advance(at, clip.Duration, seconds), clip.Name);
    }

    /// <summary>Whether a clip that plays once has come to its end.</summary>
    public unsafe bool IsFinished(MarrowClip clip) {
        fixed (Playback* at = &state) return Marrow.Finished(at, clip.Duration) != 0;
    }
}

}
