#!/usr/bin/env python3
"""Collects the licences of all packages that the programs are built from.

usage: .ci/licences.py TARGET FOLDER

Writes FOLDER/LIST.txt, a line a package, and the licence files of each in FOLDER/NAME-VERSION. A package that names no
licence ends the run: nothing is handed out whose licence nobody knows.
"""

import json
import shutil
import subprocess
import sys
from pathlib import Path

PROGRAMS = {"vibank", "vibank-press", "vibank-scan"}
NAMES = ("licen", "copying", "notice", "unlicense", "copyright")


def linked(metadata):
    """The ids of the packages that end up in the programs: not what only tests or build scripts use."""
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    names = {package["id"]: package["name"] for package in metadata["packages"]}
    todo = [identity for identity in metadata["workspace_members"] if names[identity] in PROGRAMS]
    found = set()
    while todo:
        identity = todo.pop()
        if identity in found:
            continue
        found.add(identity)
        for dependency in nodes[identity]["deps"]:
            if any(kind["kind"] is None for kind in dependency["dep_kinds"]):
                todo.append(dependency["pkg"])
    return found


def main():
    target, folder = sys.argv[1], Path(sys.argv[2])
    command = ["cargo", "metadata", "--locked", "--format-version", "1", "--features", "xlsx", "--filter-platform", target]
    metadata = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    wanted = linked(metadata)
    lines, unknown = [], []
    for package in sorted(metadata["packages"], key=lambda package: (package["name"], package["version"])):
        if package["id"] not in wanted:
            continue
        title = f"{package['name']} {package['version']}"
        root = Path(package["manifest_path"]).parent
        files = [file for file in root.iterdir() if file.is_file() and file.name.lower().startswith(NAMES)]
        if package["license_file"]:
            files.append(root / package["license_file"])
        if not package["license"] and not files:
            unknown.append(title)
        own = folder / f"{package['name']}-{package['version']}"
        for file in files:
            own.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, own / file.name)
        lines.append(f"{title}: {package['license'] or 'see its file'}; {', '.join(package['authors']) or 'no authors named'}")
    if unknown:
        sys.exit("no licence is named by " + ", ".join(unknown))
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "LIST.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")


main()
