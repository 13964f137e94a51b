# A library without a row is found, under the name that the page has for it.
import licences

BUILD = ["find_package(fmt REQUIRED)\nfind_package(CURL REQUIRED)\nfind_package(Threads REQUIRED)\n", "pkg_check_modules(sodium REQUIRED IMPORTED_TARGET libsodium)"]
PAGE = "| library | for |\n|---|---|\n| fmt | texts |\n| libcurl | webhooks |\n"

assert licences.libraries(BUILD) == ["CURL", "fmt", "libsodium"]
assert licences.faults(BUILD, PAGE) == ["docs/licences.md: libsodium has no row"]
assert licences.faults(BUILD, PAGE + "| libsodium | hashes |\n") == []
assert licences.faults(["find_package(fmt REQUIRED)"], "fmt is used") == ["docs/licences.md: fmt has no row"]
print("ok")
