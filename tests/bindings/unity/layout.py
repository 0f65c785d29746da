"""Checks the folder of the Unity package as the package manager reads it: PACKAGE_FOLDER."""
import json
import re
import sys
from pathlib import Path

package = Path(sys.argv[1])
problems = []


def must(holds, what):
    if not holds:
        problems.append(what)


def imported(path):
    """Unity leaves out folders that end with ~, but a sample is copied with what lies in it."""
    inside = path.relative_to(package).parts
    return inside[0] == "Samples~" and len(inside) > 1 or not any(name.endswith("~") for name in inside)


manifest = json.loads((package / "package.json").read_text())
must(re.fullmatch(r"com\.[a-z0-9.-]+", manifest["name"]), "the name is no reverse domain")
must(re.fullmatch(r"\d+\.\d+\.\d+(-dev)?", manifest["version"]), "the version is none of semantic versioning")
must(re.fullmatch(r"\d{4}\.\d", manifest["unity"]), "the least version of Unity")
for sample in manifest["samples"]:
    must((package / sample["path"]).is_dir(), "no sample at " + sample["path"])

guids = {}
for path in sorted(package.rglob("*")):
    if path.suffix == ".meta":
        must(path.with_suffix("").exists(), f"{path} is the .meta of nothing")
        guid = re.search(r"^guid: ([0-9a-f]{32})$", path.read_text(), re.MULTILINE)
        must(guid and guids.setdefault(guid[1], path) == path, f"{path} has no guid of its own")
    elif imported(path):
        must(path.with_name(path.name + ".meta").exists(), f"{path} has no .meta")

assemblies = {path: json.loads(path.read_text()) for path in package.rglob("*.asmdef")}
names = {assembly["name"] for assembly in assemblies.values()}
for path, assembly in assemblies.items():
    must(set(assembly["references"]) <= names, f"{path} refers to an assembly that the package lacks")
    must(assembly.get("includePlatforms", []) == (["Editor"] if "Editor" in path.parts else []), f"{path} is for other platforms")
for folder in ("Runtime", "Editor"):
    must(any(path.parent == package / folder for path in assemblies), f"{folder} has no assembly definition")
for path in package.rglob("*.cs"):
    must(any(assembly.parent in path.parents for assembly in assemblies) or "Samples~" in path.parts, f"{path} is in no assembly")

# Whatever a scene names by its guid is in the package, or is built into Unity.
BUILT_IN = "0000000000000000f000000000000000"
for scene in package.rglob("*.unity"):
    for guid in re.findall(r"guid: (\w+)", scene.read_text()):
        must(guid == BUILT_IN or guid in guids, f"{scene} names {guid}, which no .meta has")

if problems:
    sys.exit("\n".join(problems))
