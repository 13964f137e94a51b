// Numbers of a list parameter from a column of a table: lines of cells between commas, semicolons or tabs, with or
// without a first line that names the columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

struct TableColumn {
  std::string value;                          // as an override writes it: "1 mm, 2.5 mm"
  std::vector<text::Diagnostic> diagnostics;  // errors; spans in the table
};

// The column of that name, with the unit after its name ("x mm", "x [mm]") for cells that have none. An empty name is
// the parameter's own, or the table's only column. Cells are checked by the parameter of `family`; a family with faults
// and a parameter that is not a list are left to who binds it. A list of points takes one column an axis, which is
// named x, y or z; `column` is empty.
TableColumn list_of_column(const text::Source& table, std::string_view column, const text::Source& family,
                           std::string_view parameter);

}  // namespace dripfeed::compile
