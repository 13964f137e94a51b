// Called programs by name: asks whoever holds the texts (a folder, a store) once a name and reads what it gets.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/interpreter/interpreter.h"
#include "dialects/ir/control.h"
#include "dialects/ir/stage.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

// Text of a called program with the name that messages use (a path); nothing when there is none. `name` is as called:
// "O9010", "TURNING_CYCLE", "L100".
using FindText = std::function<std::optional<text::Source>(std::string_view name)>;

// Reads each program once, with the dialect and control of the caller. Not for several threads at a time.
class ProgramLibrary : public interpreter::ProgramFinder {
 public:
  ProgramLibrary(ir::Control control, FindText find_text);

  // nullptr when there is no such program. Valid as long as the library.
  const ir::Program* find(std::string_view name) override;
  // A program that is called in ISO mode (SINUMERIK).
  const ir::Program* find_foreign(std::string_view name) override;
  ForeignText foreign_text(const ir::Program& host) override;
  // nullptr when it cannot be read without an error.
  std::unique_ptr<ir::Program> read_text(std::string_view text) override;
  // What reading the programs gave, by name, in the order they were asked for.
  struct Loaded {
    std::string name;
    ir::ReadResult read;
  };
  [[nodiscard]] const std::vector<std::unique_ptr<Loaded>>& loaded() const { return loaded_; }

 private:
  using ByName = std::map<std::string, const Loaded*, std::less<>>;  // nullptr: asked for and not there
  const ir::Program* find(std::string_view name, bool in_iso_mode);

  ir::Control control_;
  ir::Control iso_;  // as it is in ISO mode; of a SINUMERIK
  FindText find_text_;
  std::vector<std::unique_ptr<Loaded>> loaded_;
  ByName by_name_;
  ByName iso_by_name_;
  // By the text that they stand in, which is held so that no other comes to lie there.
  struct IsoParts {
    text::Source host;
    ir::ReadResult read;
  };
  std::map<const char*, IsoParts> iso_parts_;
};

}  // namespace dripfeed::compile
