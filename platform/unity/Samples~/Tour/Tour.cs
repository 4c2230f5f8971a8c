using MarrowAnimation;
using UnityEngine;

/// <summary>Goes through all clips of the player beside it, fading from each to the next.</summary>
[RequireComponent(typeof(MarrowPlayer))]
public sealed class Tour : MonoBehaviour {
    [SerializeField] float seconds = 3;
    MarrowPlayer player;
    int next;
    float left;

    void Start() { player = GetComponent<MarrowPlayer>(); }

    void Update() {
        left -= Time.deltaTime;
        if (left > 0 || player.File == null) return;
        left = seconds;
        MarrowClips clips = player.File.Clips;
        player.Play(clips[next++ % clips.Count], 0.3f);
    }
}
