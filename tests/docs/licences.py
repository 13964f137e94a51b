# Every library that the build asks for stands in docs/licences.md, by its name there.
#   licences.py [ROOT]
import pathlib
import re
import sys

PAGE = "docs/licences.md"
ASKED = re.compile(r"find_package\((\w+)|pkg_check_modules\(\w+ REQUIRED IMPORTED_TARGET ([\w-]+)\)")
# Tools, the compiler's own, and what only tests are linked with.
NOT_LINKED = {"PkgConfig", "Python3", "Threads", "GTest"}
# How the page calls them, where it is not the name that the build has.
CALLED = {"CURL": "libcurl", "SQLite3": "SQLite", "nlohmann_json": "nlohmann/json"}


def libraries(texts):
    names = {name for text in texts for pair in ASKED.findall(text) for name in pair if name}
    return sorted(names - NOT_LINKED)


def faults(texts, page):
    rows = [line for line in page.splitlines() if line.startswith("| ")]
    return [f"{PAGE}: {name} has no row" for name in libraries(texts) if not any(row.startswith(f"| {CALLED.get(name, name)} ") for row in rows)]


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    files = [*root.glob("cmake/*.cmake"), *(file for top in ("dialects", "checks", "protocol", "store", "server") for file in (root / top).rglob("CMakeLists.txt"))]
    texts = [file.read_text() for file in files]
    found = faults(texts, (root / PAGE).read_text())
    print("\n".join(found) or f"{len(libraries(texts))} libraries, each with its licence")
    sys.exit(1 if found or not libraries(texts) else 0)


if __name__ == "__main__":
    main()
