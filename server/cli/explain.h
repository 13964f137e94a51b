// What is known of a diagnostic, as text for a terminal and as Markdown for the docs: its sentence, its help, the
// alarms of the controls, a program that triggers it and one that nearly does.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dialects/text/diagnostic.h"

namespace dripfeed::cli {

std::string explanation_of(const text::DiagnosticRow& row);
// All of them, as docs/diagnostics.md has them.
std::string all_in_markdown();
// One line each.
std::string list_of_diagnostics();
// Names that a misspelled one may mean, the nearest first; at most five.
std::vector<std::string_view> near_names(std::string_view name);

}  // namespace dripfeed::cli
