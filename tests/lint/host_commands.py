"""The compiler's commands for checkers that are Clang: `host_commands.py COMPILE_COMMANDS FOLDER RESULT` writes those of the sources below the folder, once each, without options that Clang does not know,
and prints the sources' names. Examples are left to their own tests."""
import json
import sys

commands, folder, result = sys.argv[1:]
chosen = {}
with open(commands, encoding="utf-8") as file:
    for entry in json.load(file):
        if entry["file"].startswith(folder + "/") and not entry["file"].startswith(folder + "/examples/"):
            entry["command"] = entry["command"].replace(" -Wno-restrict", "")
            chosen.setdefault(entry["file"], entry)
with open(result, "w", encoding="utf-8") as file:
    json.dump(list(chosen.values()), file, indent=1)
print("\n".join(sorted(chosen)))
