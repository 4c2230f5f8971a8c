"""Runs marrow_gpu_cost on each GPU's compiler, tells what came out, and compares it with table.json beside.

usage: costs.py FOLDER PROGRAM [PATTERN] [--gpu=PATTERN] [--json | --update]     called by tools/gpu_cost.sh, which says more
FOLDER has the packages for AArch64 and the shims; results are kept in it, by what they were made of.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TABLE = HERE / "table.json"
ROOT = HERE.parents[1]
DOCS = ROOT / "docs" / "performance.md"
FIGURES = ("cycles", "instructions", "registers", "threads", "spills")
MOST = 1.05  # of what the table has

# Shim, driver, OpenGL ES, and what chooses the chip and makes its compiler talk.
PANFROST = ("panfrost_noop", "panfrost", "3.1")
ADRENO = ("freedreno_noop", "msm", "3.1")
TALK = {"FD_MESA_DEBUG": "shaderdb", "GALLIUM_THREAD": "0"}
GPUS = {
    "Mali-T860": (*PANFROST, {"PAN_GPU_ID": "860"}),
    "Mali-G52": (*PANFROST, {"PAN_GPU_ID": "7212"}),
    "Mali-G57": (*PANFROST, {"PAN_GPU_ID": "9093"}),
    "Mali-G610": (*PANFROST, {"PAN_GPU_ID": "a867"}),
    "Adreno 530": (*ADRENO, {"FD_GPU_ID": "530", **TALK}),
    "Adreno 630": (*ADRENO, {"FD_GPU_ID": "630", **TALK}),
    "Adreno 660": (*ADRENO, {"FD_GPU_ID": "660", **TALK}),
    "Adreno 740": (*ADRENO, {"FD_GPU_ID": "740", **TALK}),
    "V3D 4.2": ("v3d_noop", "v3d", "3.0", {"V3D_DEBUG": "shaderdb,precompile"}),
}
# What is told of each in short: the figure that its compiler models best.
HEADLINE = {gpu: "cycles" if gpu.startswith("Mali") else "instructions" for gpu in GPUS}

WORDS = {  # of a message, by figure
    "cycles": r"([\d.]+) (?:cycles|bundles|inst-and-stalls)\b",
    "instructions": r"(\d+) inst\b",
    "registers": r"(\d+) (?:registers|full|max-temps)\b",
    "threads": r"(\d+) (?:threads|waves)\b",
    "spills": r"(\d+)(?::\d+ spills:fills| stp)\b",
}


def complain(text):
    print(f"gpu_cost: {text}", file=sys.stderr)


def run(gpu, folder, program, pattern, kept):
    """What the compiler of a GPU says of the programs that fit the pattern."""
    if kept.exists():
        return kept.read_text()
    shim, driver, version, choice = GPUS[gpu]
    root = folder / "root"
    environment = {
        **os.environ,
        **choice,
        "MESA_LOADER_DRIVER_OVERRIDE": driver,
        "MESA_SHADER_CACHE_DISABLE": "1",
        "LIBGL_DRIVERS_PATH": str(root / "usr/lib/aarch64-linux-gnu/dri"),
        "__EGL_VENDOR_LIBRARY_DIRS": str(root / "usr/share/glvnd/egl_vendor.d"),
        "QEMU_SET_ENV": f"LD_PRELOAD={folder / shim}.so",
    }
    for name in ("MESA_GLES_VERSION_OVERRIDE", "GALLIUM_DRIVER", "LIBGL_ALWAYS_SOFTWARE"):
        environment.pop(name, None)
    command = ["qemu-aarch64", "-L", str(root), str(program), version, pattern or "."]
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0 or "\nprogram " not in done.stdout:
        raise SystemExit(f"gpu_cost: {gpu}: {done.returncode}: {done.stdout[-500:]}")
    if not pattern:
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_text(done.stdout)
    return done.stdout


def figures(messages):
    found = {}
    for figure, words in WORDS.items():
        match = re.search(words, messages)
        found[figure] = float(match[1]) if match else None
    return found


def costs_of(name, messages):
    """The figures of a program, of the stages that skin."""
    stages = {}
    for stage, text in re.findall(r"^(\w+) shader: (.*)$", messages, re.M):
        stages[stage.removeprefix("MESA_SHADER_")] = figures(text)  # the last: by feedback the one that writes
    if name.endswith("/blend"):
        wanted = ("FRAGMENT", "FRAG")
    elif name.endswith("/skin"):
        wanted = ("VERTEX", "VERT", "COMPUTE", "CL")  # Mali's variants that draw as well are not run
    else:
        wanted = ("POSITION", "VARYING", "VERTEX", "VERT")
    parts = [stages[stage] for stage in wanted if stage in stages and stages[stage]["instructions"]]
    if not parts:
        raise SystemExit(f"gpu_cost: {name}: the compiler says nothing of it: {messages!r}")
    joined = {}
    for figure in FIGURES:
        values = [part[figure] for part in parts if part[figure] is not None]
        join = {"registers": max, "threads": min}.get(figure, sum)
        joined[figure] = round(join(values), 2) if values else None
        if joined[figure] is not None and joined[figure] == int(joined[figure]):
            joined[figure] = int(joined[figure])
    return joined


def read(text, pattern):
    programs = {}
    for part in text.split("\nprogram ")[1:]:
        name, _, messages = part.partition("\n")
        if re.search(pattern, name):
            programs[name] = costs_of(name, messages)
    return programs


def rows(costs):
    for gpu, programs in costs.items():
        for name, values in programs.items():
            path, deformer, influences, attributes, *_ = name.split("/")
            if attributes == "blend":
                attributes = ""
            yield {
                "gpu": gpu,
                "program": name,
                "path": path,
                "deformer": deformer,
                "influences": int(influences),
                "attributes": attributes.removesuffix("+morphs"),
                **values,
            }


def names_of(costs):
    return list(dict.fromkeys(name for programs in costs.values() for name in programs))


def cell(values, figure):
    if values is None:
        return "–"
    return f"{values[figure]:.0f}" + ("!" if values["spills"] else "")


def tell(costs):
    names = names_of(costs)
    width = max(map(len, names))
    print("cycles of Mali, instructions of the others; ! spills")
    print("".ljust(width), *(gpu.rjust(10) for gpu in costs))
    for name in names:
        cells = (cell(costs[gpu].get(name), HEADLINE[gpu]).rjust(10) for gpu in costs)
        print(name.ljust(width), *cells)


# What makes the programs' texts: shaders, and of sources the functions that put them together.
SHADERS = ("skin.glsl", "preskin.vert", "preskin.comp", "crowd.vert", "crowd.frag", "surface.vert", "depth.vert", "depth.frag")
FUNCTIONS = {
    "runtime/gles3/program.cpp": ("Text preamble(", "Words words_read(", "Status compile_program("),
    "runtime/gles3/preskin.cpp": ("Status create_preskin(",),
    "runtime/gles3/crowd/crowd.cpp": ("Status create_crowd_program(",),
    "runtime/gles3/self_test/self_test_result.cpp": ("GpuFamily family_of(",),
}


def function(begin, path):
    """Its text, without checks of calls: from the line that begins so to the brace that closes it."""
    found = re.search(rf"^{re.escape(begin)}.*?^}}$", (ROOT / path).read_text(), re.M | re.S)
    if found is None:
        raise SystemExit(f"gpu_cost: {path} has no {begin[:-1]}: say in tools/gpu_cost/costs.py what makes the texts now")
    return re.sub(r"\bMARROW_(REQUIRE|REQUIRE_GOOD|MARK)\b[^;]*;", "", found[0])


def texts():
    """What the programs are made of, as a hash. Not comments: the compilers do not see them."""
    made_of = hashlib.sha256()
    parts = [(HERE / "gpu_cost.cpp").read_text(), *((ROOT / "shaders" / name).read_text() for name in SHADERS)]
    parts += [function(begin, path) for path, begins in FUNCTIONS.items() for begin in begins]
    for part in parts:
        for line in part.splitlines():
            code = line.split("//")[0].strip()
            if code and not code.startswith("#include"):
                made_of.update(code.encode() + b"\n")
    return made_of.hexdigest()


def load():
    if not TABLE.exists():
        return None, {}
    table = json.loads(TABLE.read_text())
    stored = {gpu: {} for gpu in table["gpus"]}
    for name, of_gpus in table["programs"].items():
        for gpu, values in zip(table["gpus"], of_gpus):
            if values is not None:
                stored[gpu][name] = dict(zip(table["figures"], values))
    return table["mesa"], stored


def compare(costs, stored, whole):
    """How many rows are worse than the table's; each is told."""
    worse = 0
    for gpu, programs in costs.items():
        for name in [name for name in stored.get(gpu, {}) if whole and name not in programs]:
            complain(f"{gpu}: {name}: is in the table, but no longer among the programs")
            worse += 1
        for name, values in programs.items():
            old = stored.get(gpu, {}).get(name)
            if old is None:
                complain(f"{gpu}: {name}: is new: --update writes it to the table")
                continue
            for figure in FIGURES:
                before, now = old[figure], values[figure]
                if before is None or now is None:
                    bad = before != now
                elif figure == "threads":
                    bad = now < before
                else:
                    bad = now > before * (1 if figure == "spills" else MOST)
                if bad:
                    complain(f"{gpu}: {name}: {figure} {before} → {now}")
                    worse += 1
    return worse


def update(costs, mesa, whole):
    """Writes the table. Of some rows alone the others stay, and so does what the table says it is of."""
    made_of = texts()
    if not whole:
        of, stored = load()
        if of != mesa:
            raise SystemExit(f"gpu_cost: the table is of Mesa {of}, and this is {mesa}: --update all rows")
        made_of = json.loads(TABLE.read_text())["texts"]
        costs = {gpu: {**stored.get(gpu, {}), **costs.get(gpu, {})} for gpu in GPUS}

    def line(name):
        of_gpus = [costs[gpu].get(name) for gpu in costs]
        return [values and [values[figure] for figure in FIGURES] for values in of_gpus]

    lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(line(name), separators=(',', ':'))}" for name in names_of(costs))
    head = f'"mesa": "{mesa}",\n"texts": "{made_of}",\n"gpus": {json.dumps(list(costs))},\n"figures": {json.dumps(FIGURES)},\n"programs": {{\n'
    TABLE.write_text("{\n" + head + lines + "\n}}\n")
    text = DOCS.read_text()
    begin, end = "<!-- gpu_cost -->\n", "<!-- /gpu_cost -->"
    if begin in text:
        before, _, rest = text.partition(begin)
        DOCS.write_text(before + begin + summary(costs) + end + rest.partition(end)[2])


def summary(costs):
    """A Markdown table: SSD → AS."""
    gpus = list(costs)
    lines = ["| path | influences, attributes | " + " | ".join(gpus) + " |", "|---" * (len(gpus) + 2) + "|"]
    for path, last in [("ubo", "colour"), ("texture", "colour"), ("crowd", "colour"), ("feedback", "skin"), ("compute", "skin")]:
        kinds = [(4, "p"), (4, "pn"), (4, "pnt"), (4, "pn-surface")]
        kinds += [(influences, kind) for influences in (5, 6, 8) for kind in ("pn", "pn-surface")]
        for influences, kind in kinds:
            base = f"{path}/ssd/{influences}/{kind.removesuffix('-surface')}/{last}"
            mine = f"{path}/as/{influences}/{kind}/{last}"
            if not any(base in costs[gpu] and mine in costs[gpu] for gpu in gpus):
                continue
            cells = []
            for gpu in gpus:
                a, b = (cell(costs[gpu].get(name), HEADLINE[gpu]) for name in (base, mine))
                cells.append("–" if a == "–" else f"{a} → {b}")
            lines.append(f"| `{path}` | {influences}, {kind} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main(folder, program, *rest):
    pattern = next((word for word in rest if not word.startswith("--")), "")
    chips = next((word.removeprefix("--gpu=") for word in rest if word.startswith("--gpu=")), "")
    gpus = [gpu for gpu in GPUS if re.search(chips, gpu)]
    folder, program = pathlib.Path(folder).resolve(), pathlib.Path(program).resolve()
    made_of = hashlib.sha256(program.read_bytes())
    for shim in sorted(folder.glob("*.so")):
        made_of.update(shim.read_bytes())
    kept = folder / "results" / made_of.hexdigest()[:16]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        # The last first: its compiler is the slowest.
        going = {gpu: pool.submit(run, gpu, folder, program, pattern, kept / f"{gpu}.txt") for gpu in reversed(gpus)}
        texts = {gpu: going[gpu].result() for gpu in gpus}
    costs = {gpu: read(text, pattern) for gpu, text in texts.items()}
    if not names_of(costs):
        raise SystemExit(f"gpu_cost: no program or no GPU fits {pattern} {chips}")
    mesa = re.search(r"Mesa (\S+)", texts[gpus[0]])[1]
    if "--update" in rest:
        update(costs, mesa, gpus == list(GPUS) and not pattern)
    if "--json" in rest:
        print(json.dumps(list(rows(costs)), indent=1))
    else:
        tell(costs)
    of, stored = load()
    if of != mesa:
        complain(f"the table is of Mesa {of}, and this is {mesa}: nothing is compared")
        return 0
    worse = compare(costs, stored, not pattern)
    if worse == 0:
        complain(f"{sum(map(len, costs.values()))} rows, none worse than the table's")
    return 1 if worse else 0


if __name__ == "__main__":
    if sys.argv[1:] == ["--unchanged"]:
        sys.exit(json.loads(TABLE.read_text()).get("texts") != texts())
    sys.exit(main(*sys.argv[1:]))
