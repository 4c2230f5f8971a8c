"""What the peers make of a model: nine settings of gltfpack, glTF-Transform and gltf-pipeline, from npm."""
import json
import pathlib
import subprocess
import tempfile

PACKAGES = ["gltfpack@1.3.0", "@gltf-transform/cli@4.5.1", "gltf-pipeline@4.3.1"]
HERE = pathlib.Path(__file__).resolve().parent

# Positions have 14 bits everywhere; `bits` is what is said of the rest: normals, texture coordinates, weights.
SETTINGS = {
    "gltfpack -c": ("gltfpack -i {in} -o {out} -c -af 0 -vp 14", "8, 12, 8"),
    "gltfpack -cc": ("gltfpack -i {in} -o {out} -cc -af 0 -vp 14", "8, 12, 8"),
    "gltfpack -cz": ("gltfpack -i {in} -o {out} -cz -af 0 -vp 14", "8, 12, 8"),
    "gltf-transform meshopt, medium": ("gltf-transform meshopt {in} {out} --level medium", "10, 12, 8"),
    "gltf-transform meshopt, high": ("gltf-transform meshopt {in} {out} --level high", "10, 12, 8"),
    "gltf-transform draco": ("gltf-transform draco {in} {out}", "10, 12, 12"),
    "gltf-transform draco, speeds 0": (
        "gltf-transform draco {in} {out} --encode-speed 0 --decode-speed 0", "10, 12, 12"),
    "gltf-transform draco, sequential": (
        "gltf-transform draco {in} {out} --method sequential --encode-speed 0 --decode-speed 0", "10, 12, 12"),
    "gltf-pipeline draco, level 10": (
        "gltf-pipeline -i {in} -o {out} -d --draco.compressionLevel 10 --draco.quantizePositionBits 14", "8, 10, 8"),
}


def zstd_bytes(data):
    """Length of one zstd frame at level 19."""
    return len(subprocess.run(["zstd", "-19", "-c", "-q"], input=data, stdout=subprocess.PIPE, check=True).stdout)


def install(folder):
    """Fetches the packages unless they are there; raises if npm or the network is missing."""
    if (folder / "node_modules/.bin/gltfpack").exists():
        return
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["npm", "install", "--silent", "--no-audit", "--no-fund", "--prefix", str(folder), *PACKAGES],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def make(model, setting, folder, out):
    """Lets a peer make `out` of a model."""
    names = {"in": str(model), "out": str(out)}
    words = [word.format(**names) if word in ("{in}", "{out}") else word for word in SETTINGS[setting][0].split()]
    words[0] = str(folder / "node_modules/.bin" / words[0])
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)


def posed_error(model, made, folder):
    """How far joints and vertices of a glTF file stray while clips play, as posed_error.cjs has it; None: not comparable."""
    run = subprocess.run(["node", str(HERE / "posed_error.cjs"), str(folder), str(model), str(made)], check=True,
                         capture_output=True, timeout=600)
    return json.loads(run.stdout)


def measure(model, setting, folder):
    """Sizes and errors of one setting, as measure.cjs has them, and each part after zstd; None where the peer fails."""
    with tempfile.TemporaryDirectory() as work:
        work = pathlib.Path(work)
        made = work / "out.glb"
        parts = [work / part for part in ("geometry", "animation", "rest")]
        try:
            make(model, setting, folder, made)
            run = subprocess.run(
                ["node", str(HERE / "measure.cjs"), str(folder), str(model), str(made), *map(str, parts)], check=True,
                capture_output=True, timeout=600)
        except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
            return None
        out = json.loads(run.stdout)
        data = [part.read_bytes() for part in parts]
        out["geometry_zstd"], out["animation_zstd"] = zstd_bytes(data[0]), zstd_bytes(data[1])
        out["whole_zstd"] = zstd_bytes(b"".join(data))
        return out
