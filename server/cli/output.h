// What the command prints: texts to standard output or a file, messages to standard error, errors with their places.
#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/text/diagnostic.h"
#include "dialects/text/fold.h"
#include "server/app/base/error.h"

namespace dripfeed::cli {

// "dripfeed: sentence" and the places below it.
void print_error(std::string_view sentence);
void print_error(const app::Error& error);

// Each with its place, its notes and the edit that mends it; below the first of a kind its help.
void print_diagnostics(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source,
                       std::string_view control);
// Of a program that comes from another text: `origin` names the place there of a line, or "" where none is known.
using LineOrigin = std::function<std::string(std::uint32_t line)>;
void print_diagnostics(const std::vector<text::Diagnostic>& diagnostics, const text::Source& source,
                       std::string_view control, const LineOrigin& origin);

// What to do about a diagnostic, once a kind and command.
void print_help(text::DiagnosticId id);

// How many more there were than were shown.
void print_folded(const text::DiagnosticFold& fold, std::string_view name);

// That a large program was run while it was read, and that what check says of its text was not looked at.
void print_not_validated(std::string_view file);

// Writes the whole text to `path` ("" or "-": standard output). False, with a message, when it cannot.
bool write_output(const std::string& path, std::string_view text);
// The same by `write`, which is false, with errno, when it cannot.
bool write_output_by(const std::string& path, const std::function<bool(std::FILE*)>& write);

// Puts the text into the place of the file in one step, with its permissions. "" or why it cannot.
std::string replace_file(const std::string& path, const std::string& text);

}  // namespace dripfeed::cli
