using MarrowAnimation;
using UnityEngine;

/// <summary>Walks after a target by the graph of the player beside it, which has a number `speed`.</summary>
[RequireComponent(typeof(MarrowPlayer))]
public sealed class Follow : MonoBehaviour {
    [SerializeField] Transform target = null;
    [SerializeField] float fastest = 1.5f, near = 1, degreesASecond = 120;
    MarrowPlayer player;
    int speed;

    void Start() {
        player = GetComponent<MarrowPlayer>();
        player.ApplyRootMotion = true;
        enabled = player.Graph != null && target != null;
        if (enabled) speed = player.Parameter("speed");  // by name once, not a frame
    }

    void Update() {
        Vector3 way = target.position - transform.position;
        way.y = 0;
        if (way.magnitude > 0.01f) {
            transform.rotation = Quaternion.RotateTowards(transform.rotation, Quaternion.LookRotation(way),
                                                          degreesASecond * Time.deltaTime);
        }
        player.SetNumber(speed, Mathf.Clamp(way.magnitude - near, 0, fastest));
    }
}
