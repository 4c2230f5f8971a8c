"""Cooks models with Bazel: a file is an action, hermetic, whose inputs are what is named here.

In WORKSPACE:

    local_repository(name = "rules_marrow", path = "third_party/marrow/tools/farm/bazel")
    load("@rules_marrow//:defs.bzl", "marrow_program")
    marrow_program(name = "marrow", path = "/usr/bin/marrow")

In BUILD:

    load("@rules_marrow//:defs.bzl", "marrow_asset", "marrow_library")
    marrow_asset(name = "hero", src = "hero.gltf", data = ["hero.bin"], options = ["--as", "fit"])
    marrow_library(name = "props", srcs = glob(["props/**/*.glb"]), settings = "marrow.toml")
"""

def _marrow_program_impl(repository):
    repository.symlink(repository.attr.path, "marrow")
    repository.file("BUILD.bazel", 'exports_files(["marrow"])\n')

marrow_program = repository_rule(
    implementation = _marrow_program_impl,
    attrs = {"path": attr.string(mandatory = True, doc = "of the program `marrow`, absolute")},
    local = True,
    doc = "The program, as a file that actions depend on: another one cooks all anew.",
)

def _cook(ctx, src, stem, settings):
    cooked = ctx.actions.declare_file(stem + ".mrw")
    report = ctx.actions.declare_file(stem + ".report.json")
    arguments = ctx.actions.args()
    arguments.add("cook")
    arguments.add(src)
    arguments.add("--output", cooked)
    arguments.add("--report", report)
    arguments.add("--settings", settings)
    arguments.add("--jobs", ctx.attr.jobs)
    arguments.add_all([ctx.expand_location(option, ctx.attr.data) for option in ctx.attr.options])
    ctx.actions.run(
        executable = ctx.executable.marrow,
        arguments = [arguments],
        inputs = depset([src, settings] + ctx.files.data),
        outputs = [cooked, report],
        mnemonic = "MarrowCook",
        progress_message = "Cooking " + src.short_path,
    )
    return cooked, report

def _settings(ctx):
    if ctx.file.settings:
        return ctx.file.settings

    # No marrow.toml that happens to lie above counts.
    none = ctx.actions.declare_file(ctx.label.name + ".none.toml")
    ctx.actions.write(none, "")
    return none

def _marrow_asset_impl(ctx):
    cooked, report = _cook(ctx, ctx.file.src, ctx.label.name, _settings(ctx))
    return [DefaultInfo(files = depset([cooked])), OutputGroupInfo(report = depset([report]))]

def _marrow_library_impl(ctx):
    settings = _settings(ctx)
    package = ctx.label.package + "/" if ctx.label.package else ""
    both = []
    for src in ctx.files.srcs:
        name = src.short_path
        name = name[len(package):] if name.startswith(package) else name
        both.append(_cook(ctx, src, ctx.label.name + "/" + name[:-len(src.extension) - 1], settings))
    return [
        DefaultInfo(files = depset([cooked for cooked, _ in both])),
        OutputGroupInfo(report = depset([report for _, report in both])),
    ]

_ATTRIBUTES = {
    "data": attr.label_list(allow_files = True, doc = "what else is read: buffers, images, skeletons, graphs, masks"),
    "jobs": attr.string(default = "1", doc = "threads of an action"),
    "marrow": attr.label(
        default = "@marrow//:marrow",
        allow_single_file = True,
        executable = True,
        cfg = "exec",
        doc = "the program",
    ),
    "options": attr.string_list(doc = "as on the command line; $(location LABEL) names a file of data"),
    "settings": attr.label(allow_single_file = [".toml"], doc = "a marrow.toml"),
}
_KINDS = [".glb", ".gltf", ".vrm", ".bvh"]

marrow_asset = rule(
    implementation = _marrow_asset_impl,
    attrs = dict(_ATTRIBUTES, src = attr.label(allow_single_file = _KINDS, mandatory = True, doc = "the model")),
    doc = "NAME.mrw of one model; the output group `report` has NAME.report.json.",
)

marrow_library = rule(
    implementation = _marrow_library_impl,
    attrs = dict(_ATTRIBUTES, srcs = attr.label_list(allow_files = _KINDS, mandatory = True, doc = "models")),
    doc = "NAME/PATH.mrw of each model, each by an action of its own.",
)
